// Which transparent objects the eye is inside of.
#pragma once

#include "common/world/world.hpp"

#include <vector>

namespace rt {

/// The transparent objects around the eye, outermost first: those that a line from the eye to
/// infinity crosses an odd number of times, and planes whose normal points away from it. Other objects are
/// closed, or the answer means nothing.
std::vector<Medium> objects_around_eye(const World& world);

}  // namespace rt
