// A lamp with a shade: its light falls into a cone, with a soft edge. An optional step: scenes have no such
// lamp.
#pragma once

#include "chapters/05_lighting/lighting.hpp"

namespace rt {

/// A lamp whose light falls into a cone. Angles are measured from the axis, and kept as their cosines.
struct SpotLight {
    PointLight lamp;
    Vec3 axis{0, -1, 0};  ///< unit, from the lamp along the middle of the cone
    Real inner = 1;       ///< cosine of the angle up to which all of the light arrives
    Real outer = 0;       ///< cosine of the angle from which on none arrives; at most `inner`
};

/// [05.6] What a spot light sends to `point`: what its lamp would, and the colour multiplied by a part that
/// depends on the cosine c of the angle between the axis and the way from the lamp to the point. It is 1
/// where c ≥ inner, 0 where c < inner and c ≤ outer, and x²(3 − 2x) between, where x grows evenly with c from
/// 0 at `outer` to 1 at `inner`. Where both are equal, the edge is hard.
LightSample sample_light(const SpotLight& light, const Vec3& point);

}  // namespace rt
