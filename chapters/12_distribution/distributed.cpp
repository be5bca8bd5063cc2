// Distribution ray tracing: the tree of chapter 7, each of whose rays asks a random one of all that blurs.
#include "chapters/12_distribution/distributed.hpp"

#include "chapters/12_distribution/glossy.hpp"

#include "common/math/todo.hpp"

#include <utility>
#include <vector>

namespace rt {
std::optional<Branch> spread(const Branch& branch, const Surface& surface, Real exponent,
                             const Vec2& random) {
    // 12.19  Turn the branch's ray to around_axis of its own direction. The two must lie on one
    // side of surface.normal.
    return todo("12.19");
}

Vec3 distributed(const World& world, const Ray& ray, Stream& stream) {
    Branch camera;
    camera.ray = ray;
    camera.media = world.eye_inside;
    // 12.20  Walk the tree as `radiance` does (07.6). New are: a hit with a light_at adds that
    // times the branch's weight, and nothing else; local_light is asked with the ray's time and the stream;
    // and of the branches, one whose gloss_of is greater than 0 takes a next_point(stream) and is spread, or
    // dropped.
    return todo("12.20");
}

}  // namespace rt
