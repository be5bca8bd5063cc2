// Distribution ray tracing: the tree of chapter 7, each of whose rays asks a random one of all that blurs.
#include "chapters/12_distribution/distributed.hpp"

#include "chapters/12_distribution/glossy.hpp"

#include <utility>
#include <vector>

namespace rt {
std::optional<Branch> spread(const Branch& branch, const Surface& surface, Real exponent,
                             const Vec2& random) {
    // [exercise 12.19] Turn the branch's ray to around_axis of its own direction. The two must lie on one
    // side of surface.normal.
    Branch blurred = branch;
    blurred.ray.direction = around_axis(branch.ray.direction, exponent, random);
    const Real before = dot(branch.ray.direction, surface.normal);
    const Real after = dot(blurred.ray.direction, surface.normal);
    if (!(before * after > 0)) return std::nullopt;
    return blurred;
    // [/exercise]
}

Vec3 distributed(const World& world, const Ray& ray, Stream& stream) {
    Branch camera;
    camera.ray = ray;
    camera.media = world.eye_inside;
    // [exercise 12.20] Walk the tree as `radiance` does (07.6). New are: a hit with a light_at adds that
    // times the branch's weight, and nothing else; local_light is asked with the ray's time and the stream;
    // and of the branches, one whose gloss_of is greater than 0 takes a next_point(stream) and is spread, or
    // dropped.
    Vec3 sum(0);
    std::vector<Branch> stack{camera};
    while (!stack.empty()) {
        Branch branch = std::move(stack.back());
        stack.pop_back();
        const std::optional<Hit> hit = closest_hit(world, branch.ray, {0, infinity});
        if (world.needs.absorption) branch.weight *= left_after(world, branch.media, hit ? hit->t : infinity);
        if (!hit) {
            sum += branch.weight * background(world, branch.ray.direction);
            continue;
        }
        if (const std::optional<Vec3> light = light_at(world, branch.ray, *hit)) {
            sum += branch.weight * *light;
            continue;
        }
        const Surface surface = surface_at(world, branch.ray, *hit);
        const Material material = material_at(world, *hit, surface);
        const Vec3& d = branch.ray.direction;
        const Vec3 n = dot(surface.shading_normal, d) > 0 ? -surface.shading_normal : surface.shading_normal;
        sum += branch.weight * local_light(world, surface, material, n, -d, branch.ray.time, stream);
        Branches next = scatter(world, branch, *hit, surface, material);
        for (int i = next.count - 1; i >= 0; --i) {
            std::optional<Branch> going_on = next.branch[static_cast<std::size_t>(i)];
            const Real exponent = gloss_of(world, material, going_on->kind == RayKind::Refraction);
            if (exponent > 0) going_on = spread(*going_on, surface, exponent, next_point(stream));
            if (!going_on) continue;
            ++(going_on->kind == RayKind::Reflection ? ray_counts().reflection : ray_counts().refraction);
            stack.push_back(std::move(*going_on));
        }
    }
    return sum;
    // [/exercise]
}

}  // namespace rt
