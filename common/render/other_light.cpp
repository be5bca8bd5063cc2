// Light from the sky, and light on surfaces that do not spread it evenly.
#include "common/render/other_light.hpp"

#include "chapters/11_textures/harmonics.hpp"
#include "chapters/11_textures/lobes.hpp"
#include "common/math/axes.hpp"
#include "common/render/area_lights.hpp"
#include "common/render/finish.hpp"
#include "common/render/lights.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rt {
namespace {

Lobe lobe_of(const Finish& finish, const Material& material) {
    const Vec3 color = glm::min(material.diffuse, Vec3(1));
    switch (finish.kind) {
        case FinishKind::Velvet:
            return Velvet{color, finish.value};
        case FinishKind::Metal:
            return RoughMetal{color, finish.value};
        case FinishKind::Coated:
            return Coated{color, finish.value};
        case FinishKind::Glass:
            return RoughGlass{color, finish.value, material.ior};
        case FinishKind::Matte:
        case FinishKind::Plain:
            break;
    }
    return Matte{color, finish.value};
}

/// The finish of a material, if it is not the plain one.
std::optional<Finish> finish_of(const World& world, const Material& material) {
    if (!world.needs.finishes || material.finish < 0) return std::nullopt;
    const Finish finish = finish_at(world, material);
    return finish.kind == FinishKind::Plain ? std::nullopt : std::optional(finish);
}

/// What the surface sends to the viewer by itself, and of the sky and the lamps. `visit_all(normal, visit)`
/// calls `visit` for each lamp in front of that normal, with the light and its visible part, and perhaps
/// with the lamp's number.
template <class VisitAll>
Vec3 sum_of_all(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                const Vec3& to_viewer, const VisitAll& visit_all) {
    const LampShading lamps = lamp_shading(world, surface, material, normal, to_viewer);
    Vec3 sum = emitted_light(material) + light_of_sky(world, material, normal);
    const auto add = [&](const LightSample& light, const Vec3& visible, std::uint32_t = 0) {
        if (visible != Vec3(0)) sum += sent_on(lamps, light, visible);
    };
    visit_all(normal, add);
    // Light from behind goes through, as far as the rest of the body lets it.
    if (shines_through(lamps)) visit_all(-normal, add);
    return sum;
}

}  // namespace

LampShading lamp_shading(const World& world, const Surface& surface, const Material& material,
                         const Vec3& normal, const Vec3& to_viewer) {
    LampShading lamps{material, normal, to_viewer, finish_of(world, material), {}, Mat3(1), to_viewer};
    if (!lamps.finish) return lamps;
    // The z axis of glass points out of it.
    const bool is_inside = shines_through(lamps) && dot(surface.normal, to_viewer) < 0;
    lamps.frame = axes_around(is_inside ? -normal : normal);
    lamps.viewer = to_viewer * lamps.frame;
    lamps.lobe = lobe_of(*lamps.finish, material);
    lamps.plain.diffuse = Vec3(0);
    return lamps;
}

bool shines_through(const LampShading& lamps) {
    return lamps.finish && lamps.finish->kind == FinishKind::Glass;
}

Vec3 lobe_towards(const LampShading& lamps, const LightSample& light) {
    return evaluate(lamps.lobe, light.direction * lamps.frame, lamps.viewer);
}

Vec3 sent_on(const LampShading& lamps, const LightSample& light, const Vec3& visible) {
    // Of a lamp behind the surface that is black.
    const Vec3 plain = reflected_light(lamps.plain, lamps.normal, lamps.to_viewer, light, visible);
    if (!lamps.finish) return plain;
    const Vec3 l = light.direction * lamps.frame;
    return plain + pi * std::abs(l.z) * evaluate(lamps.lobe, l, lamps.viewer) * light.color * visible;
}

Vec3 light_of_sky(const World& world, const Material& material, const Vec3& normal) {
    return world.needs.skylight ? sky_diffuse(world.skylight, normal, material.diffuse) : Vec3(0);
}

Vec3 other_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer) {
    return sum_of_all(world, surface, material, normal, to_viewer, [&](const Vec3& side, const auto& visit) {
        visit_lights(world, surface, side, visit);
    });
}

Vec3 local_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer, Real time, Stream& stream) {
    return sum_of_all(world, surface, material, normal, to_viewer, [&](const Vec3& side, const auto& visit) {
        const LightAsked asked{world, surface, side, time};
        visit_lamps(asked, visit);
        visit_area_lights(asked, stream, visit);
    });
}

}  // namespace rt
