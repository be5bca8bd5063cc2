// What compiling a scene kept, what it left out, and why.
#pragma once

#include "common/world/world.hpp"

#include <string>
#include <vector>

namespace rt {

/// One thing that the picture does or does not need, and the reason: both parts of a sentence in English.
struct Reason {
    std::string what;
    std::string why;
};

struct Explanation {
    std::vector<Reason> kept;
    std::vector<Reason> left_out;
    std::vector<std::string> chapters;  ///< numbers of the chapters whose code this picture runs: "01", ...
    std::size_t bytes = 0;              ///< memory of the world's arrays
};

/// `world` must be compile(scene).
Explanation explain(const Scene& scene, const World& world);

}  // namespace rt
