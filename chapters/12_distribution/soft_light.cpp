// Lights with an extent under the sum of chapter 5: one random point at a time.
#include "chapters/12_distribution/soft_light.hpp"

#include "chapters/12_distribution/area_light.hpp"
#include "chapters/12_distribution/rectangle_light.hpp"
#include "chapters/12_distribution/sphere_light.hpp"
#include "chapters/12_distribution/triangle_light.hpp"

#include "common/math/todo.hpp"

#include <variant>

namespace rt {

std::optional<LightSample> sample_light(const AreaLight& light, const Vec3& point, LightSampling how,
                                        const Vec2& random) {
    // 12.18  Ask the light's shape, whichever it is, for a direction and its density: by Angle
    // `toward`; by Area a `point_on` it, and how that is `seen_from` the point. Nothing, if there is none.
    // The colour is what arrives on average if directions come with that density, in chapter 5's units.
    return todo("12.18");
}

}  // namespace rt
