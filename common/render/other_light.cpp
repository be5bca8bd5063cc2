// Light from the sky, and light on surfaces that do not spread it evenly.
#include "common/render/other_light.hpp"

#include "chapters/11_textures/harmonics.hpp"
#include "chapters/11_textures/lobes.hpp"
#include "chapters/11_textures/texture_coordinates.hpp"
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

/// Columns that are perpendicular unit vectors, the last of which is n. The lobes look the same when they are
/// turned about it, so any will do.
Mat3 frame_around(const Vec3& n) {
    const auto [u, v] = plane_axes(n);
    return {u, v, n};
}

}  // namespace

Vec3 other_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer) {
    const bool has_finish = world.needs.finishes && material.finish >= 0;
    Lobe lobe;
    Mat3 frame(1);
    Material plain = material;
    if (has_finish) {
        frame = frame_around(normal);
        lobe = lobe_of(world.finishes[static_cast<std::size_t>(material.finish)],
                       glm::min(material.diffuse, Vec3(1)));
        plain.diffuse = Vec3(0);
    }
    const Vec3 viewer = to_viewer * frame;
    Vec3 sum = emitted_light(material);
    if (world.needs.skylight) sum += sky_diffuse(world.skylight, normal, material.diffuse);
    visit_lights(world, surface, normal, [&](const LightSample& light, const Vec3& visible) {
        if (visible == Vec3(0)) return;
        sum += reflected_light(plain, normal, to_viewer, light, visible);
        if (!has_finish) return;
        const Vec3 l = light.direction * frame;
        sum += pi * l.z * evaluate(lobe, l, viewer) * light.color * visible;
    });
    return sum;
}

}  // namespace rt
