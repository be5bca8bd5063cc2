// The tree of rays: Whitted's ray tracer (1980).
#pragma once

#include "chapters/07_recursion/optics.hpp"
#include "common/world/query.hpp"

#include <array>
#include <vector>

namespace rt {

enum class RayKind { Camera, Reflection, Refraction };

/// Which transparent objects a ray is inside of, in the order of entering; the last one's medium is the
/// one around the ray.
using Media = std::vector<Medium>;

/// The index of refraction of what is around a ray that is inside of these.
inline Real ior(const World& world, const Media& media) {
    const Material* around = material_around(world, media);
    return around ? around->ior : 1;
}

/// What is left of light after `distance` in the medium around a ray that is inside of these.
inline Vec3 left_after(const World& world, const Media& media, Real distance) {
    const Material* around = material_around(world, media);
    return around ? transmitted(around->absorption, distance) : Vec3(1);
}

/// One ray of the tree.
struct Branch {
    Ray ray;         ///< direction of unit length
    Vec3 weight{1};  ///< how much of its radiance arrives at the pixel
    int depth = 0;   ///< bounces so far
    RayKind kind = RayKind::Camera;
    Media media;
};

/// The rays that a surface sends on: reflection first, then refraction.
struct Branches {
    std::array<Branch, 2> branch;
    int count = 0;
};

/// [07.4] The media after crossing the surface of `medium.object`: left if the ray was inside of it, else
/// entered. The order of the others stays.
Media cross(const Media& media, Medium medium);

/// [07.5] The rays that go on from a hit, with their weights: mirrored and refracted.
///
/// `incoming.weight` already contains the absorption on the way to the hit. An opaque material (transmission
/// 0) sends one mirror ray with the factor `specular`. A transparent one sends a mirror ray with the factor
/// R, its Fresnel reflectance (`specular` where it has none), and a refracted ray with (1 − R) ·
/// transmission; where reflection is total the mirror ray's factor is 1 and there is no other.
///
/// The mirror ray leaves on the side of the *geometric* surface where `incoming` arrived, the refracted one
/// on the other, whatever the shading normal says. Where a refracted ray that enters an object would not,
/// there is none, as where reflection is total. Mirrored at the geometric surface is any other direction on
/// the wrong side, and whatever is totally reflected inside an object: so no light is lost or caught inside.
///
/// A ray none of whose weights is greater than world.min_contribution is left out, and all are once
/// incoming.depth has reached world.max_depth.
Branches scatter(const World& world, const Branch& incoming, const Hit& hit, const Surface& surface,
                 const Material& material);

/// [07.6] Radiance along a camera ray: the sum over its tree, walked with a stack on the heap whose height is
/// at most world.max_depth + 1. Adds the rays it spawns to ray_counts().
Vec3 radiance(const World& world, const Ray& ray);

}  // namespace rt
