// The integrators `analyticdirect` and `direct` of the successor course.
#include "common/render/direct.hpp"

#include "chapters/12_distribution/glossy.hpp"
#include "chapters/12_distribution/lambert_polygon.hpp"
#include "common/math/axes.hpp"
#include "common/render/area_lights.hpp"
#include "common/render/finish.hpp"
#include "common/render/integrators.hpp"

#include <array>

namespace rt {
namespace {

constexpr Interval everything{0, infinity};

/// What a ray has met, for those who want nothing but light that is reflected once.
struct Shaded {
    Surface surface;
    Material material;
    Vec3 normal;  ///< turned to the viewer
};

/// The colour of a ray by `reflected`, a function of what it has met.
template <class Reflected>
Vec3 color_of(const World& world, const Ray& ray, const Reflected& reflected) {
    const std::optional<Hit> hit = closest_hit(world, ray, everything);
    if (!hit) return background(world, ray.direction);
    if (const std::optional<Vec3> light = light_at(world, ray, *hit)) return *light;
    Shaded at;
    at.surface = surface_at(world, ray, *hit);
    at.material = material_at(world, *hit, at.surface);
    at.normal = turned_to_viewer(at.surface.shading_normal, ray.direction);
    return at.material.emission + reflected(at);
}

/// The corners of a light that is a polygon, in the order that makes light on its bright side positive.
struct Corners {
    std::vector<Vec3> operator()(const QuadLight& q) const {
        return {q.corner, q.corner + q.ab, q.corner + q.ab + q.ac, q.corner + q.ac};
    }
    std::vector<Vec3> operator()(const TriangleLight& t) const { return {t.a, t.c, t.b}; }
    std::vector<Vec3> operator()(const DiscLight&) const { return {}; }
    std::vector<Vec3> operator()(const SphereLight&) const { return {}; }
};

}  // namespace

Vec3 analytic_direct(const World& world, const Ray& ray, Stream&) {
    return color_of(world, ray, [&](const Shaded& at) {
        Vec3 sum(0);
        for (const AreaLight& light : world.area_lights.lights)
            sum += light.radiance *
                   dot(lambert_vector(std::visit(Corners(), light.shape), at.surface.point), at.normal);
        return at.material.diffuse / pi * sum;
    });
}

Vec3 direct(const World& world, const Ray& ray, Stream& stream) {
    return color_of(world, ray, [&](const Shaded& at) {
        const Material& m = at.material;
        const Finish finish = finish_at(world, m);
        const Mat3 frame = axes_around(at.normal);
        const Vec3 viewer = -ray.direction * frame;
        Vec3 sum(0);
        visit_area_lights(
            {world, at.surface, at.normal, ray.time}, stream,
            [&](const LightSample& light, const Vec3& visible, std::uint32_t) {
                const Vec3 l = light.direction * frame;
                const Vec3 f = finish.brdf == Brdf::Ggx
                                   ? evaluate(DiffuseGgx{m.diffuse, m.specular, finish.roughness}, l, viewer)
                                   : evaluate(ModifiedPhong{m.diffuse, m.specular, m.shininess}, l, viewer);
                sum += pi * l.z * f * light.color * visible;
            });
        return sum;
    });
}

}  // namespace rt
