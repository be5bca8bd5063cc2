// Axis-aligned boxes, as plain data.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// An axis-aligned box, its faces included. The default is empty: it changes nothing it is merged with.
struct Bounds {
    Vec3 low{infinity};
    Vec3 high{-infinity};
};

}  // namespace rt
