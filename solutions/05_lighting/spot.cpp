// A lamp with a shade: its light falls into a cone, with a soft edge.
// The lesson uses the same letters: c for the cosine between the axis and the way to the point, x across the
// edge.
#include "chapters/05_lighting/spot.hpp"

#include <algorithm>

namespace rt {

LightSample sample_light(const SpotLight& light, const Vec3& point) {
    // [exercise 05.6] What the lamp sends to the point (05.1), its colour multiplied by the part that falls
    // there: 1 inside of the inner cone, 0 outside of the outer one, and x²(3 − 2x) between, where x grows
    // evenly with the cosine c from 0 at `outer` to 1 at `inner`.
    LightSample sample = sample_light(light.lamp, point);
    const Real c = -dot(light.axis, sample.direction);
    if (c >= light.inner) return sample;
    const Real x = std::max((c - light.outer) / (light.inner - light.outer), Real(0));
    sample.color *= x * x * (3 - 2 * x);
    return sample;
    // [/exercise]
}

}  // namespace rt
