// What a scene does not need: for each feature a scene without it, and a renderer for just that scene.
#pragma once

#include "chapters/01_ray_casting/raycast.hpp"

#include <string>
#include <vector>

namespace rt::test {

/// A feature, a scene that does without it, and what somebody would write who had to draw only that scene.
struct Case {
    std::string feature;
    std::string scene;         ///< without the feature
    std::string with_feature;  ///< the same scene with it
    RayColor minimal;          ///< draws `scene`: calls the chapters, and asks nothing whose answer it knows;
                               ///< is given a World of no more than the view
    std::size_t bytes;         ///< what `scene` has to keep in memory, counted by hand
    bool given_world = false;  ///< whether `minimal` is given the whole World all the same
    bool judged = true;        ///< whether the rule is demanded, or the numbers are only shown
};

/// All of them, in the order of the table.
std::vector<Case> cases();

/// The camera that all the scenes have, for a renderer that has no World.
View view();

}  // namespace rt::test
