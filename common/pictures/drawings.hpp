// Drawings of what single functions answer, for steps that no scene shows yet.
#pragma once

#include "common/image/image.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// What one pixel of a drawing stands for, what it was asked, and the answer as a colour and in words: "the
/// point (0.2, 0.4)", "inside".
struct DrawnPixel {
    Vec3 color{0};
    std::string place;
    std::string answer;
};

/// A drawing that chapter.json can name as the picture of a step.
struct Drawing {
    std::string_view name;
    int width, height;
    /// The answer at each pixel, row by row from the top left. Functions that are not started throw
    /// NotImplemented through here.
    std::vector<DrawnPixel> (*draw)(const Drawing& drawing);
};

/// Null if there is none of this name. To add one: a function and a row in drawings.cpp.
const Drawing* drawing_named(std::string_view name);

}  // namespace rt
