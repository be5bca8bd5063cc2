// The lights of a world at one point: what arrives, and how much of it gets through.
#pragma once

#include "chapters/06_shadows/shadow.hpp"

namespace rt {

/// Which part of a light arrives at the surface.
inline Vec3 visible_part(const World& world, const Surface& surface, const LightSample& light) {
    if (!world.needs.shadows) return Vec3(1);
    ++ray_counts().shadow;
    const ShadowRay shadow = shadow_ray(surface, light);
    return world.needs.colored_shadows ? colored_visibility(world, shadow) : visibility(world, shadow);
}

/// Calls visit(LightSample, visible part) for each light in front of the surface: point lights first.
/// Lights behind it are hidden by the surface itself and cost no shadow ray.
template <class Visit>
void visit_lights(const World& world, const Surface& surface, const Vec3& normal, Visit visit) {
    const auto ask = [&](const LightSample& light) {
        if (dot(normal, light.direction) > 0) visit(light, visible_part(world, surface, light));
    };
    for (const PointLight& light : world.point_lights) ask(sample_light(light, surface.point));
    for (const DirectionalLight& light : world.directional_lights) ask(sample_light(light, surface.point));
}

}  // namespace rt
