// The tree of rays: Whitted's ray tracer (1980).
#include "chapters/07_recursion/radiance.hpp"

#include "chapters/06_shadows/shadow.hpp"
#include "chapters/07_recursion/optics.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rt {
namespace {

[[maybe_unused]] Vec3 turned_against(const Vec3& n, const Vec3& d) { return dot(n, d) > 0 ? -n : n; }

/// Which way is out of the flat surface on the side where the ray arrives.
[[maybe_unused]] Vec3 front_of(const Surface& surface, const Branch& incoming) {
    return turned_against(surface.normal, incoming.ray.direction);
}

/// `refract` for a smooth surface, which is made of flat triangles. Near its rim a direction that is right
/// for the shading normal n may point to the near side of the flat triangle. Light that would enter a body
/// there does not: as where reflection is total, there is no refracted direction.
[[maybe_unused]] std::optional<Vec3> refract_at(const Surface& surface, const Branch& incoming, const Vec3& n,
                                                Real eta, const Media& after) {
    const std::optional<Vec3> refracted = refract(incoming.ray.direction, n, eta);
    const bool enters = after.size() > incoming.media.size();
    if (enters && refracted && dot(*refracted, front_of(surface, incoming)) > 0) return std::nullopt;
    return refracted;
}

/// The mirror direction where reflection is total. Inside a body the mirror is the flat triangle: smooth
/// ones, which lean, draw rays together, and some into a ring of reflections that no ray ever leaves.
[[maybe_unused]] Vec3 reflect_totally(const Surface& surface, const Branch& incoming, const Vec3& n,
                                      const Media& after) {
    const bool inside = after.size() < incoming.media.size();
    return reflect(incoming.ray.direction, inside ? front_of(surface, incoming) : n);
}

/// Appends a ray that leaves the surface, unless nothing worth following would arrive along it. A direction
/// that leaves the flat surface on the wrong side is mirrored at it.
[[maybe_unused]] void add(const World& world, Branches& branches, const Branch& incoming,
                          const Surface& surface, RayKind kind, const Vec3& direction, const Vec3& factor,
                          const Media& media) {
    const Vec3 weight = incoming.weight * factor;
    if (!(max_component(weight) > world.min_contribution)) return;
    const Vec3 front = front_of(surface, incoming);
    const Vec3 side = kind == RayKind::Refraction ? -front : front;
    const Vec3 leaving = dot(direction, side) < 0 ? reflect(direction, side) : direction;
    branches.branch[static_cast<std::size_t>(branches.count++)] = {
        {offset_origin(surface, side), leaving, incoming.ray.time}, weight, incoming.depth + 1, kind, media};
}

/// The media behind the surface that was hit.
[[maybe_unused]] Media media_behind(const World& world, const Branch& incoming, const Hit& hit) {
    const Primitive& primitive = world.primitives[hit.primitive];
    return cross(incoming.media, {primitive.object, primitive.material});
}

/// How much of the light that meets a transparent surface is mirrored, and how much goes through.
struct Shares {
    Vec3 mirrored{0}, through{0};
};

/// The shares at this cosine of the angle of incidence, in [0, 1], where reflection is not total.
[[maybe_unused]] Shares shares(const Material& material, Real cos_i, Real eta) {
    // [exercise 07.5] With a Fresnel law, exact or Schlick's, a part R is mirrored, and of the rest the part
    // `transmission` goes through. Where material.fresnel is Fresnel::None, `specular` is mirrored and
    // `transmission` goes through, whatever the angle.
    if (material.fresnel == Fresnel::None) return {material.specular, material.transmission};
    const Real r = material.fresnel == Fresnel::Exact ? fresnel(cos_i, eta) : schlick(cos_i, eta);
    return {Vec3(r), (1 - r) * material.transmission};
    // [/exercise]
}

}  // namespace

Media cross(const Media& media, Medium medium) {
    // [exercise 07.4] Return the media behind the surface: without the object if the ray was inside of it,
    // else with the medium as the last. The order of the others stays.
    Media after = media;
    const auto same =
        std::find_if(after.begin(), after.end(), [&](const Medium& m) { return m.object == medium.object; });
    if (same != after.end())
        after.erase(same);
    else
        after.push_back(medium);
    return after;
    // [/exercise]
}

Branches scatter(const World& world, const Branch& incoming, const Hit& hit, const Surface& surface,
                 const Material& material) {
    // [exercise 07.5] Return the rays that go on, the mirrored one first: none once incoming.depth is
    // world.max_depth. An opaque material mirrors `specular` of the light. A transparent one shares it out as
    // `shares` says; where reflection is total, all of it is mirrored. Use the shading normal, turned against
    // the ray, and the functions above: `media_behind`, `refract_at`, `reflect_totally`, and `add`, which
    // appends a ray.
    Branches branches;
    if (incoming.depth >= world.max_depth) return branches;
    const Vec3& d = incoming.ray.direction;
    const Vec3 n = turned_against(surface.shading_normal, d);
    if (material.transmission == Vec3(0)) {
        add(world, branches, incoming, surface, RayKind::Reflection, reflect(d, n), material.specular,
            incoming.media);
        return branches;
    }
    const Media after = media_behind(world, incoming, hit);
    const Real eta = ior(world, incoming.media) / ior(world, after);
    const std::optional<Vec3> refracted = refract_at(surface, incoming, n, eta, after);
    auto [mirror, through] = shares(material, std::min(-dot(d, n), Real(1)), eta);
    if (!refracted) mirror = Vec3(1);
    const Vec3 mirrored = refracted ? reflect(d, n) : reflect_totally(surface, incoming, n, after);
    add(world, branches, incoming, surface, RayKind::Reflection, mirrored, mirror, incoming.media);
    if (refracted) add(world, branches, incoming, surface, RayKind::Refraction, *refracted, through, after);
    return branches;
    // [/exercise]
}

Vec3 radiance(const World& world, const Ray& ray) {
    Branch camera;
    camera.ray = ray;
    camera.media = world.eye_inside;
    // [exercise 07.6] Return the sum over the tree of the camera ray, with the rays that wait on a stack (a
    // std::vector). Each ray adds its weight times the local_light of its hit, or times the background; what
    // the medium takes on the way to the hit is taken off its weight first (the way is infinite where nothing
    // is hit). Of what `scatter` returns, the mirrored ray is traced before the refracted one. Count each ray
    // that goes on in ray_counts().reflection or .refraction.
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
        const Surface surface = surface_at(world, branch.ray, *hit);
        const Material material = material_at(world, *hit, surface);
        const Vec3 n = turned_against(surface.shading_normal, branch.ray.direction);
        sum += branch.weight * local_light(world, surface, material, n, -branch.ray.direction);
        Branches next = scatter(world, branch, *hit, surface, material);
        for (int i = next.count - 1; i >= 0; --i) {
            Branch& one = next.branch[static_cast<std::size_t>(i)];
            ++(one.kind == RayKind::Reflection ? ray_counts().reflection : ray_counts().refraction);
            stack.push_back(std::move(one));
        }
    }
    return sum;
    // [/exercise]
}

}  // namespace rt
