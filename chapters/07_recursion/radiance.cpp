// The tree of rays: Whitted's ray tracer (1980).
#include "chapters/07_recursion/radiance.hpp"

#include "chapters/06_shadows/shadow.hpp"
#include "chapters/07_recursion/optics.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <vector>

namespace rt {
namespace {

[[maybe_unused]] Real ior(const World& world, const Media& media) {
    return media.count == 0 ? 1 : world.materials[media.inside[media.count - 1].material].ior;
}

/// What is left of light after `distance` in the medium around the ray.
[[maybe_unused]] Vec3 left_after(const World& world, const Media& media, Real distance) {
    if (media.count == 0) return Vec3(1);
    return transmitted(world.materials[media.inside[media.count - 1].material].absorption, distance);
}

[[maybe_unused]] Vec3 turned_against(const Vec3& n, const Vec3& d) { return dot(n, d) > 0 ? -n : n; }

/// Appends a ray that leaves the surface, unless nothing worth following would arrive along it.
[[maybe_unused]] void add(const World& world, Branches& branches, const Branch& incoming,
                          const Surface& surface, RayKind kind, const Vec3& direction, const Vec3& factor,
                          const Media& media) {
    const Vec3 weight = incoming.weight * factor;
    if (!(std::max({weight.x, weight.y, weight.z}) > world.min_contribution)) return;
    const Ray ray{offset_origin(surface, direction), direction, incoming.ray.time};
    branches.branch[static_cast<std::size_t>(branches.count++)] = {ray, weight, incoming.depth + 1, kind,
                                                                   media};
}

}  // namespace

Media cross(const Media& media, Medium medium) {
    // 07.4  If the object is among the first `count` of media.inside, remove it and close the gap;
    // else append it, if there is room.
    return todo("07.4");
}

Branches scatter(const World& world, const Branch& incoming, const Hit& hit, const Surface& surface,
                 const Material& material) {
    // 07.5  Nothing goes on once incoming.depth is world.max_depth. Let n be the shading normal,
    // turned against the ray. An opaque material sends one mirror ray with the factor `specular`. A
    // transparent one: eta = ior(before)/ior(after) with `cross`; R = fresnel or schlick as the material
    // says; mirror factor R (specular where it says none), refracted factor (1 − R)·transmission. Where
    // refract returns nothing, all light is mirrored: factor 1. `add` above keeps the books.
    return todo("07.5");
}

Vec3 radiance(const World& world, const Ray& ray) {
    Branch camera;
    camera.ray = ray;
    for (const Medium& medium : world.eye_inside) camera.media = cross(camera.media, medium);
    // 07.6  Keep the rays still to be traced on a stack (a std::vector), at first the camera ray.
    // While there are any: take the last one off. If world.needs.absorption, multiply its weight by what the
    // medium leaves of the light on the way to the hit (`left_after` above; the way is infinite where nothing
    // is hit). Where it hits nothing, add weight · background. Else add weight · local_light, and push
    // what `scatter` returns, the last branch first, so that the reflected ray is traced next. Count each
    // pushed ray in ray_counts().reflection or .refraction.
    return todo("07.6");
}

}  // namespace rt
