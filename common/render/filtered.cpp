// The tree of rays with ray differentials. What chapter 11 says of one ray is put together here.
#include "common/render/filtered.hpp"

#include "chapters/07_recursion/radiance.hpp"
#include "chapters/11_textures/differential.hpp"
#include "common/render/integrators.hpp"
#include "common/render/texture_places.hpp"
#include "common/render/textures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {
namespace {

// The mean curvature of shapes, which other than spheres and flat things have only an estimate.

template <class Shape>
Real curvature_of(const Shape&) {
    return 0;
}
Real curvature_of(const Sphere& sphere) { return 1 / sphere.radius; }
Real curvature_of(const Cone& cone) { return 1 / (2 * std::max(cone.radius_a, cone.radius_b)); }
Real curvature_of(const OpenCone& open) { return curvature_of(open.cone); }
Real curvature_of(const Torus& torus) { return 1 / (2 * torus.tube); }
template <class Shape>
Real curvature_of(const Placed<Shape>& placed) {
    const Mat4& m = placed.transform.to_world;
    return 3 * curvature_of(placed.shape) / (length(Vec3(m[0])) + length(Vec3(m[1])) + length(Vec3(m[2])));
}

/// That of what a ray has met.
Real curvature_at(const World& world, const Hit& hit) {
    const Primitive& primitive = world.primitives[hit.primitive];
    return std::visit([&](const auto& group) { return curvature_of(group.shapes[primitive.index]); },
                      world.groups[primitive.group]);
}

/// How a ray of the camera changes from sample to sample: of n samples a pixel, each stands for an nth of it.
RayDifferential camera_ray_differential(const World& world, const Ray& ray) {
    const View& view = world.view;
    // Where in the picture the ray looks through.
    const Vec3 away = view.projection == Projection::Perspective ? ray.direction : ray.origin - view.eye;
    const Real depth = view.projection == Projection::Perspective ? -dot(away, view.frame.w) : 1;
    const Real pixel = 2 * view.half_height / view.height;
    const Real x = view.width / 2.0 + dot(away, view.frame.u) / depth / pixel,
               y = view.height / 2.0 - dot(away, view.frame.v) / depth / pixel;
    RayDifferential change = camera_differential(view, x, y);
    const Real share = 1 / std::sqrt(static_cast<Real>(world.sampling.count));
    change.origin_dx *= share, change.origin_dy *= share;
    change.direction_dx *= share, change.direction_dy *= share;
    return change;
}

/// What a bundle of rays meets.
struct Arrival {
    Surface surface;
    RayDifferential change;  ///< on the surface
    Real curvature = 0;      ///< as for normal_change, of the normal that points outwards
    Material material;       ///< its texture averaged over what is seen of it
};

Arrival arrival(const World& world, const Ray& ray, const RayDifferential& change, const Hit& hit) {
    Arrival at{surface_without_bumps(world, ray, hit), {}, 0, {}};
    const TexturePoint texture = texture_point_at(world, ray, hit, at.surface);
    at.change = transferred(change, ray, hit.t, at.surface.normal);
    at.curvature = curvature_at(world, hit);
    const Footprint seen = footprint(texture.du, texture.dv, at.change.origin_dx, at.change.origin_dy);
    if (world.needs.bumps) apply_bumps(world, ray, hit, &seen, at.surface);
    at.material = world.materials[material_index(world, hit, at.surface)];
    if (world.needs.textures) apply_texture(world, hit, at.surface, &seen, at.material);
    return at;
}

/// A ray of the tree and its differential.
struct Bundle {
    Branch branch;
    RayDifferential change;
};

/// The differential of a ray that `scatter` has sent on.
RayDifferential sent_on(const World& world, const Branch& incoming, const Branch& next, const Arrival& at) {
    const Vec3& d = incoming.ray.direction;
    const bool turns = dot(at.surface.normal, d) > 0;
    const Vec3 n = turned_to_viewer(at.surface.shading_normal, d);
    const NormalChange change = normal_change(at.change, n, turns ? -at.curvature : at.curvature);
    if (next.kind == RayKind::Reflection) return reflected(at.change, d, n, change);
    return refracted(at.change, d, n, change, ior(world, incoming.media) / ior(world, next.media));
}

}  // namespace

Vec3 filtered_radiance(const World& world, const Ray& ray, Stream&) {
    Branch camera;
    camera.ray = ray;
    camera.media = world.eye_inside;
    Vec3 sum(0);
    std::vector<Bundle> stack{{camera, camera_ray_differential(world, ray)}};
    while (!stack.empty()) {
        Bundle bundle = std::move(stack.back());
        stack.pop_back();
        Branch& branch = bundle.branch;
        const std::optional<Hit> hit = closest_hit(world, branch.ray, {0, infinity});
        if (world.needs.absorption) branch.weight *= left_after(world, branch.media, hit ? hit->t : infinity);
        if (!hit) {
            sum += branch.weight * background(world, branch.ray.direction);
            continue;
        }
        const Arrival at = arrival(world, branch.ray, bundle.change, *hit);
        const Vec3 n = turned_to_viewer(at.surface.shading_normal, branch.ray.direction);
        sum += branch.weight * local_light(world, at.surface, at.material, n, -branch.ray.direction);
        const Branches next = scatter(world, branch, *hit, at.surface, at.material);
        for (int i = next.count - 1; i >= 0; --i) {
            const Branch& one = next.branch[static_cast<std::size_t>(i)];
            ++(one.kind == RayKind::Reflection ? ray_counts().reflection : ray_counts().refraction);
            stack.push_back({one, sent_on(world, branch, one, at)});
        }
    }
    return sum;
}

Vec3 filtered_own_light(const World& world, const Ray& ray, const Hit& hit) {
    const Material material = arrival(world, ray, camera_ray_differential(world, ray), hit).material;
    return material.ambient + material.emission;
}

Vec3 filtered_normal(const World& world, const Ray& ray, const Hit& hit) {
    const Vec3 n = arrival(world, ray, camera_ray_differential(world, ray), hit).surface.shading_normal;
    return 0.5 * (turned_to_viewer(n, ray.direction) + Vec3(1));
}

}  // namespace rt
