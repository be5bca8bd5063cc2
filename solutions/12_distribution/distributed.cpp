// Distribution ray tracing: the tree of chapter 7, each of whose rays asks a random one of all that blurs.
#include "chapters/12_distribution/distributed.hpp"

#include "chapters/12_distribution/glossy.hpp"

#include <utility>
#include <vector>

namespace rt {
std::optional<Branch> spread(const Branch& branch, const Surface& surface, Real exponent,
                             const Vec2& random) {
    // [exercise 12.19] The branch in a random direction around its own; nothing if that is on the other side
    // of the flat surface.
    Branch blurred = branch;
    blurred.ray.direction = around_axis(branch.ray.direction, exponent, random);
    const Real before = dot(branch.ray.direction, surface.normal);
    const Real after = dot(blurred.ray.direction, surface.normal);
    if (!(before * after > 0)) return std::nullopt;
    return blurred;
    // [/exercise]
}

namespace {

/// The light that a branch brings back from its hit, times its weight; the rays that go on from there are
/// pushed on the stack.
Vec3 light_from(const World& world, const Branch& branch, const Hit& hit, Stream& stream,
                std::vector<Branch>& stack) {
    // [exercise 12.20] What the branch brings back from its hit, times its weight: the light of a lamp, or
    // the local light at the time of the ray. Push the branches that go on, spread where they are glossy, and
    // count them in ray_counts().
    if (const std::optional<Vec3> light = light_at(world, branch.ray, hit)) return branch.weight * *light;
    const Surface surface = surface_at(world, branch.ray, hit);
    const Material material = material_at(world, hit, surface);
    const Vec3& d = branch.ray.direction;
    const Vec3 n = dot(surface.shading_normal, d) > 0 ? -surface.shading_normal : surface.shading_normal;
    const Vec3 local = local_light(world, surface, material, n, -d, branch.ray.time, stream);
    Branches next = scatter(world, branch, hit, surface, material);
    for (int i = next.count - 1; i >= 0; --i) {
        std::optional<Branch> going_on = next.branch[static_cast<std::size_t>(i)];
        const Real exponent = gloss_of(world, material, going_on->kind == RayKind::Refraction);
        if (exponent > 0) going_on = spread(*going_on, surface, exponent, next_point(stream));
        if (!going_on) continue;
        ++(going_on->kind == RayKind::Reflection ? ray_counts().reflection : ray_counts().refraction);
        stack.push_back(std::move(*going_on));
    }
    return branch.weight * local;
    // [/exercise]
}

}  // namespace

Vec3 distributed(const World& world, const Ray& ray, Stream& stream) {
    Branch camera;
    camera.ray = ray;
    camera.media = world.eye_inside;
    // The walk of 07.6.
    Vec3 light(0);
    for (std::vector<Branch> waiting{camera}; !waiting.empty();) {
        Branch next = std::move(waiting.back());
        waiting.pop_back();
        const std::optional<Hit> found = closest_hit(world, next.ray, {0, infinity});
        if (world.needs.absorption) next.weight *= left_after(world, next.media, found ? found->t : infinity);
        light += found ? light_from(world, next, *found, stream, waiting)
                       : next.weight * background(world, next.ray.direction);
    }
    return light;
}

}  // namespace rt
