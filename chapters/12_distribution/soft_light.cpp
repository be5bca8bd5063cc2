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
    // 12.18  A direction to the light, chosen as `how` says, its distance, and the colour of a
    // light that stands for the whole lamp.
    return todo("12.18");
}

}  // namespace rt
