// Light from the sky, and light on surfaces that do not spread it evenly.
#include "common/render/other_light.hpp"

#include "chapters/11_textures/harmonics.hpp"
#include "chapters/11_textures/lobes.hpp"
#include "common/math/axes.hpp"
#include "common/render/area_lights.hpp"
#include "common/render/lights.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

Lobe lobe_of(const Finish& finish, const Material& material) {
    const Vec3 color = glm::min(material.diffuse, Vec3(1));
    const Real roughness =
        std::clamp(finish.value * static_cast<Real>(material.finish_factor), Real(0), Real(1));
    switch (finish.kind) {
        case FinishKind::Velvet:
            return Velvet{color, roughness};
        case FinishKind::Metal:
            return RoughMetal{color, roughness};
        case FinishKind::Coated:
            return Coated{color, finish.value};
        case FinishKind::Glass:
            return RoughGlass{color, roughness, material.ior};
        case FinishKind::Matte:
        case FinishKind::Plain:
            break;
    }
    return Matte{color, roughness};
}

/// The finish of a material, if it is not the plain one.
const Finish* finish_of(const World& world, const Material& material) {
    if (!world.needs.finishes || material.finish < 0) return nullptr;
    const Finish& finish = world.finishes[static_cast<std::size_t>(material.finish)];
    return finish.kind == FinishKind::Plain ? nullptr : &finish;
}

/// What the surface sends to the viewer by itself, and of the sky and the lamps. `visit_all(normal, visit)`
/// calls `visit` for each lamp in front of that normal, with the light and its visible part.
template <class VisitAll>
Vec3 sum_of_all(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                const Vec3& to_viewer, const VisitAll& visit_all) {
    const Finish* const finish = finish_of(world, material);
    const bool is_glass = finish && finish->kind == FinishKind::Glass;
    Lobe lobe;
    Mat3 frame(1);
    Material plain = material;
    if (finish) {
        // The z axis of glass points out of it.
        const bool is_inside = is_glass && dot(surface.normal, to_viewer) < 0;
        frame = axes_around(is_inside ? -normal : normal);
        lobe = lobe_of(*finish, material);
        plain.diffuse = Vec3(0);
    }
    const Vec3 viewer = to_viewer * frame;
    Vec3 sum = emitted_light(material);
    if (world.needs.skylight) sum += sky_diffuse(world.skylight, normal, material.diffuse);
    const auto spread = [&](const LightSample& light, const Vec3& visible) {
        const Vec3 l = light.direction * frame;
        sum += pi * std::abs(l.z) * evaluate(lobe, l, viewer) * light.color * visible;
    };
    visit_all(normal, [&](const LightSample& light, const Vec3& visible) {
        if (visible == Vec3(0)) return;
        sum += reflected_light(plain, normal, to_viewer, light, visible);
        if (finish) spread(light, visible);
    });
    // Light from behind goes through, as far as the rest of the body lets it.
    if (is_glass)
        visit_all(-normal, [&](const LightSample& light, const Vec3& visible) {
            if (visible != Vec3(0)) spread(light, visible);
        });
    return sum;
}

}  // namespace

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
