// Lights with an extent.
#pragma once

#include "common/math/vec.hpp"

#include <variant>

namespace rt {

/// A parallelogram: corner + s·ab + t·ac for s, t in [0, 1]. It shines on the side of −(ab × ac), as the
/// scenes of the successor course have it; its other side is dark.
struct QuadLight {
    Vec3 corner{0};
    Vec3 ab{1, 0, 0};
    Vec3 ac{0, 0, 1};
};

/// A disc that shines on the side to which its normal points. `normal`: of any length but 0.
struct DiscLight {
    Vec3 center{0};
    Vec3 normal{0, -1, 0};
    Real radius = 1;
};

/// A sphere that shines outwards.
struct SphereLight {
    Vec3 center{0};
    Real radius = 1;
};

/// A triangle that shines on the side from which a, b, c run counterclockwise.
struct TriangleLight {
    Vec3 a{0};
    Vec3 b{1, 0, 0};
    Vec3 c{0, 1, 0};
};

using LightShape = std::variant<QuadLight, DiscLight, SphereLight, TriangleLight>;

/// A light that sends the same radiance from each of its points in each direction, on its bright side.
struct AreaLight {
    LightShape shape;
    Vec3 radiance{1};  ///< W/(m² sr) in a picture of physical units; any unit will do
};

/// How the point of an area light is chosen that a shadow ray is sent to.
enum class LightSampling {
    Area,   ///< all parts of its surface alike
    Angle,  ///< all parts alike of what is seen of it
};

/// How area lights are asked.
struct LightSamples {
    int count = 1;            ///< shadow rays to each light
    bool stratified = false;  ///< those of one light in cells of their own
    LightSampling how = LightSampling::Angle;
    bool all = true;  ///< else one light a point, chosen by its power
};

}  // namespace rt
