// Lights with an extent under the sum of chapter 5: one random point at a time.
#include "chapters/12_distribution/soft_light.hpp"

#include "chapters/12_distribution/area_light.hpp"
#include "chapters/12_distribution/rectangle_light.hpp"
#include "chapters/12_distribution/sphere_light.hpp"
#include "chapters/12_distribution/triangle_light.hpp"

#include <variant>

namespace rt {

std::optional<LightSample> sample_light(const AreaLight& light, const Vec3& point, LightSampling how,
                                        const Vec2& random) {
    // [exercise 12.18] A direction to the light, chosen as `how` says, its distance, and the colour of a
    // light that stands for the whole lamp.
    const auto choose_direction = [&](const auto& shape) -> std::optional<LightDirection> {
        if (how == LightSampling::Angle) return toward(shape, point, random);
        return seen_from(point_on(shape, random), point);
    };
    const std::optional<LightDirection> chosen = std::visit(choose_direction, light.shape);
    if (!chosen) return std::nullopt;
    return LightSample{chosen->direction, chosen->distance, light.radiance / (pi * chosen->pdf)};
    // [/exercise]
}

}  // namespace rt
