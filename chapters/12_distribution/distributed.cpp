// Distribution ray tracing: the tree of chapter 7, each of whose rays asks a random one of all that blurs.
#include "chapters/12_distribution/distributed.hpp"

#include "chapters/12_distribution/glossy.hpp"

#include "common/math/todo.hpp"

#include <utility>
#include <vector>

namespace rt {
std::optional<Branch> spread(const Branch& branch, const Surface& surface, Real exponent,
                             const Vec2& random) {
    // 12.19  The branch in a random direction around its own; nothing if that is on the other side
    // of the flat surface.
    return todo("12.19");
}

namespace {

/// The light that a branch brings back from its hit, times its weight; the rays that go on from there are
/// pushed on the stack.
Vec3 light_from(const World& world, const Branch& branch, const Hit& hit, Stream& stream,
                std::vector<Branch>& stack) {
    // 12.20  What the branch brings back from its hit, times its weight: the light of a lamp, or
    // the local light at the time of the ray. Push the branches that go on, spread where they are glossy, and
    // count them in ray_counts().
    return todo("12.20");
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
