// The picture that shows a step, as the code draws it that this program is linked with, and what is behind a
// pixel.
#pragma once

#include "common/image/image.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rt {

/// What a step is shown by: a drawing's name (drawings.hpp), or a scene's file with the size of the picture.
struct Shown {
    std::string what;
    int width = 0, height = 0;  ///< of a scene's picture; 0 × 0 as the scene says. A drawing has its own
};

Image step_picture(const Shown& shown);

/// What is behind a pixel: the ray tree of a scene, or {"place", "answer"} of a drawing.
nlohmann::ordered_json step_pixel(const Shown& shown, int x, int y);

/// How a program ends whose picture needs a step that is not started.
inline constexpr int picture_not_started = 3;

/// The same as command lines of a program: `WHAT WIDTH HEIGHT FILE.pfm`, and `WHAT WIDTH HEIGHT X Y
/// FILE.json`. The exit status.
int write_step_picture(const std::vector<std::string>& arguments);
int write_step_pixel(const std::vector<std::string>& arguments);

}  // namespace rt
