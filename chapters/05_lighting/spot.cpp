// A lamp with a shade: its light falls into a cone, with a soft edge.
// The lesson uses the same letters: c for the cosine between the axis and the way to the point, x across the
// edge.
#include "chapters/05_lighting/spot.hpp"

#include "common/math/todo.hpp"

#include <algorithm>

namespace rt {

LightSample sample_light(const SpotLight& light, const Vec3& point) {
    // 05.6  What the lamp sends to the point (05.1), its colour multiplied by the part that falls
    // there: 1 inside of the inner cone, 0 outside of the outer one, and x²(3 − 2x) between, where x grows
    // evenly with the cosine c from 0 at `outer` to 1 at `inner`.
    return todo("05.6");
}

}  // namespace rt
