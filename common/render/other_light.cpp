// Light from the sky, and light on surfaces that do not spread it evenly.
#include "common/render/other_light.hpp"

#include "chapters/11_textures/harmonics.hpp"
#include "chapters/11_textures/lobes.hpp"
#include "common/math/axes.hpp"
#include "common/render/area_lights.hpp"
#include "common/render/lights.hpp"

namespace rt {
namespace {

Lobe lobe_of(const Finish& finish, const Vec3& color) {
    switch (finish.kind) {
        case FinishKind::Velvet:
            return Velvet{color, finish.value};
        case FinishKind::Metal:
            return RoughMetal{color, finish.value};
        case FinishKind::Coated:
            return Coated{color, finish.value};
        case FinishKind::Matte:
        case FinishKind::Plain:
            break;
    }
    return Matte{color, finish.value};
}

/// The finish of a material, if it is not the plain one.
const Finish* finish_of(const World& world, const Material& material) {
    if (!world.needs.finishes || material.finish < 0) return nullptr;
    const Finish& finish = world.finishes[static_cast<std::size_t>(material.finish)];
    return finish.kind == FinishKind::Plain ? nullptr : &finish;
}

/// What the surface sends to the viewer by itself, and of the sky and the lamps. `visit_all` calls its
/// argument for each lamp with the light and its visible part.
template <class VisitAll>
Vec3 sum_of_all(const World& world, const Material& material, const Vec3& normal, const Vec3& to_viewer,
                const VisitAll& visit_all) {
    const Finish* const finish = finish_of(world, material);
    Lobe lobe;
    Mat3 frame(1);
    Material plain = material;
    if (finish) {
        frame = axes_around(normal);
        lobe = lobe_of(*finish, glm::min(material.diffuse, Vec3(1)));
        plain.diffuse = Vec3(0);
    }
    const Vec3 viewer = to_viewer * frame;
    Vec3 sum = emitted_light(material);
    if (world.needs.skylight) sum += sky_diffuse(world.skylight, normal, material.diffuse);
    visit_all([&](const LightSample& light, const Vec3& visible) {
        if (visible == Vec3(0)) return;
        sum += reflected_light(plain, normal, to_viewer, light, visible);
        if (!finish) return;
        const Vec3 l = light.direction * frame;
        sum += pi * l.z * evaluate(lobe, l, viewer) * light.color * visible;
    });
    return sum;
}

}  // namespace

Vec3 other_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer) {
    return sum_of_all(world, material, normal, to_viewer,
                      [&](const auto& visit) { visit_lights(world, surface, normal, visit); });
}

Vec3 local_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer, Real time, Stream& stream) {
    const LightAsked asked{world, surface, normal, time};
    return sum_of_all(world, material, normal, to_viewer, [&](const auto& visit) {
        visit_lamps(asked, visit);
        visit_area_lights(asked, stream, visit);
    });
}

}  // namespace rt
