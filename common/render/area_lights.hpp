// Lights with an extent, asked by random points, and every light at the time of a ray.
#pragma once

#include "chapters/12_distribution/choice.hpp"
#include "chapters/12_distribution/samples.hpp"
#include "chapters/12_distribution/soft_light.hpp"
#include "common/render/lights.hpp"

namespace rt {

/// The sums of the chances by which one of the lights is chosen: as much as each sends out.
std::vector<Real> chances_of(std::span<const AreaLight> lights);

/// Where and when lights are asked.
struct LightAsked {
    const World& world;
    const Surface& surface;
    const Vec3& normal;  ///< unit, turned to the viewer
    Real time = 0;
};

/// A shadow ray to an area light ends this part of its way before the light, which is a thing itself: nothing
/// that is so near to it gives a shadow.
inline constexpr Real before_light = 0x1p-20;

/// Which part of a light arrives, at the time that is asked for, if the last `spared` part of the way does
/// not matter.
inline Vec3 visible_part(const LightAsked& at, const LightSample& light, Real spared) {
    if (!at.world.needs.shadows) return Vec3(1);
    ++ray_counts().shadow;
    ShadowRay shadow = shadow_ray(at.surface, light);
    shadow.ray.time = at.time;
    shadow.range.max *= 1 - spared;
    return at.world.needs.colored_shadows ? colored_visibility(at.world, shadow)
                                          : visibility(at.world, shadow);
}

/// Calls visit(LightSample, visible part, number of the light) for each light without an extent in front of
/// the surface. Lights are numbered in the world's order: point lights, directional ones, area lights.
template <class Visit>
void visit_lamps(const LightAsked& at, const Visit& visit) {
    std::uint32_t number = 0;
    const auto ask = [&](const LightSample& light) {
        if (dot(at.normal, light.direction) > 0) visit(light, visible_part(at, light, 0), number);
        ++number;
    };
    for (const PointLight& light : at.world.point_lights) ask(sample_light(light, at.surface.point));
    for (const DirectionalLight& light : at.world.directional_lights)
        ask(sample_light(light, at.surface.point));
}

/// Likewise for the random points of one of the area lights. A point that is not in front of the surface, or
/// does not shine on it, is drawn, too: so each light has its own random numbers.
template <class Visit>
void visit_area_light(const LightAsked& at, std::size_t which, Real probability, Stream& stream,
                      const Visit& visit) {
    const World& world = at.world;
    const AreaLight& light = world.area_lights.lights[which];
    const auto number =
        static_cast<std::uint32_t>(world.point_lights.size() + world.directional_lights.size() + which);
    const LightSamples& samples = world.area_lights.samples;
    const auto count = static_cast<std::uint32_t>(samples.count);
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec2 random = next_point(stream);
        if (samples.stratified) {
            const Stratum cell = stratum(i, count);
            random = cell.low + random * (cell.high - cell.low);
        }
        std::optional<LightSample> sample = sample_light(light, at.surface.point, samples.how, random);
        if (!sample || !(dot(at.normal, sample->direction) > 0)) continue;
        sample->color /= probability * count;
        visit(*sample, visible_part(at, *sample, before_light), number);
    }
}

/// Likewise for the area lights: all of them, or one.
template <class Visit>
void visit_area_lights(const LightAsked& at, Stream& stream, const Visit& visit) {
    const AreaLights& all = at.world.area_lights;
    if (all.chances.empty()) {
        for (std::size_t i = 0; i < all.lights.size(); ++i) visit_area_light(at, i, 1, stream, visit);
        return;
    }
    const Choice choice = choose(all.chances, next_real(stream));
    visit_area_light(at, choice.index, choice.probability, stream, visit);
}

}  // namespace rt
