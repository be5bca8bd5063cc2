// A toy accelerator: a box around each shape.
#pragma once

#include "common/world/bounds.hpp"

#include <vector>

namespace rt {

struct Boxes {
    std::vector<Bounds> boxes;
};

}  // namespace rt
