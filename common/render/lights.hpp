// The lights of a world at one point: what arrives, and how much of it gets through.
#pragma once

#include "chapters/06_shadows/shadow.hpp"

namespace rt {

/// Which part of a light arrives at the surface.
[[gnu::always_inline]] inline Vec3 visible_part(const World& world, const Surface& surface,
                                                const LightSample& light) {
    if (!world.needs.shadows) return Vec3(1);
    ++ray_counts().shadow;
    const ShadowRay shadow = shadow_ray(surface, light);
    return world.needs.colored_shadows ? colored_visibility(world, shadow) : visibility(world, shadow);
}

/// Calls visit(LightSample, visible part) for each light in front of the surface: point lights first.
/// Lights behind it are hidden by the surface itself and cost no shadow ray.
// This and the sum are asked of most rays. They are always part of their caller: to pass so many arguments
// on costs more than what is done with them where there are few lights.
template <class Visit>
[[gnu::always_inline]] inline void visit_lights(const World& world, const Surface& surface,
                                                const Vec3& normal, Visit visit) {
    const auto ask = [&](const LightSample& light) __attribute__((always_inline)) {
        if (dot(normal, light.direction) > 0) visit(light, visible_part(world, surface, light));
    };
    for (const PointLight& light : world.point_lights) ask(sample_light(light, surface.point));
    for (const DirectionalLight& light : world.directional_lights) ask(sample_light(light, surface.point));
}

/// The same as `local_light`, in a world whose needs say no `other_light`.
[[gnu::always_inline]] inline Vec3 sum_of_lights(const World& world, const Surface& surface,
                                                 const Material& material, const Vec3& normal,
                                                 const Vec3& to_viewer) {
    Vec3 sum = emitted_light(material);
    visit_lights(
        world, surface,
        normal, [&](const LightSample& light, const Vec3& visible) __attribute__((always_inline)) {
            // A light that something hides is not worked out. Where it is seen, the first comparison says so.
            if (visible.x > 0 || visible.y > 0 || visible.z > 0)
                sum += reflected_light(material, normal, to_viewer, light, visible);
        });
    return sum;
}

}  // namespace rt
