// Rough mirrors and rough glass: facets of GGX in the tree of rays.
#include "common/render/rough.hpp"

#include "chapters/06_shadows/shadow.hpp"
#include "chapters/11_textures/microfacet.hpp"
#include "chapters/12_distribution/distributed.hpp"
#include "chapters/12_distribution/glossy.hpp"
#include "common/math/axes.hpp"
#include "common/render/finish.hpp"
#include "common/render/integrators.hpp"

#include <utility>
#include <vector>

namespace rt {
namespace {

/// A ray that meets a surface: what `scatter` and `spread` ask for.
struct Meeting {
    const World& world;
    const Branch& incoming;
    const Hit& hit;
    const Surface& surface;
    const Material& material;
};

/// What goes on from a random facet.
std::vector<Branch> sent_on_by_facets(const Meeting& at, Real alpha, const Vec2& random) {
    const Vec3& d = at.incoming.ray.direction;
    const Vec3 n = turned_to_viewer(at.surface.shading_normal, d),
               front = turned_to_viewer(at.surface.normal, d);
    const Mat3 frame = axes_around(n);
    const Vec3 viewer = -d * frame;
    if (!(viewer.z > 0)) return {};
    Surface facet = at.surface;
    facet.normal = facet.shading_normal = frame * visible_normal(alpha, viewer, random.x, random.y);
    Branches next = scatter(at.world, at.incoming, at.hit, facet, at.material);
    std::vector<Branch> all;
    for (int i = 0; i < next.count; ++i) {
        Branch& branch = next.branch[static_cast<std::size_t>(i)];
        const Real side = branch.kind == RayKind::Refraction ? -1 : 1;
        const Vec3 leaving = side * branch.ray.direction * frame;
        if (!(leaving.z > 0) || !(side * dot(branch.ray.direction, front) > 0)) continue;
        branch.ray.origin = offset_origin(at.surface, side * front);
        branch.weight *= smith_g1(alpha, leaving);
        all.push_back(std::move(branch));
    }
    return all;
}

/// What goes on from a surface without facets, spread where it is glossy (12.19).
std::vector<Branch> sent_on(const Meeting& at, Stream& stream) {
    Branches next = scatter(at.world, at.incoming, at.hit, at.surface, at.material);
    std::vector<Branch> all;
    for (int i = next.count - 1; i >= 0; --i) {
        Branch& branch = next.branch[static_cast<std::size_t>(i)];
        const Real exponent = gloss_of(at.world, at.material, branch.kind == RayKind::Refraction);
        if (exponent > 0) {
            std::optional<Branch> blurred = spread(branch, at.surface, exponent, next_point(stream));
            if (blurred) all.push_back(std::move(*blurred));
        } else {
            all.push_back(std::move(branch));
        }
    }
    return all;
}

}  // namespace

Real facet_alpha(const World& world, const Material& material) {
    if (!world.needs.rough || material.finish < 0) return 0;
    const Finish finish = finish_at(world, material);
    if (finish.brdf != Brdf::Ggx || !(finish.roughness > 0)) return 0;
    const bool sends_on = material.specular != Vec3(0) || material.transmission != Vec3(0);
    return sends_on ? alpha_of(DiffuseGgx{Vec3(0), Vec3(1), finish.roughness}) : 0;
}

std::vector<Branch> spread_branches(const World& world, const Branch& incoming, const Hit& hit,
                                    const Surface& surface, const Material& material, Stream& stream) {
    if (incoming.depth >= world.max_depth) return {};
    const Meeting at{world, incoming, hit, surface, material};
    const Real alpha = facet_alpha(world, material);
    return alpha > 0 ? sent_on_by_facets(at, alpha, next_point(stream)) : sent_on(at, stream);
}

Vec3 rough_distributed(const World& world, const Ray& ray, Stream& stream) {
    Branch camera;
    camera.ray = ray;
    camera.media = world.eye_inside;
    Vec3 sum(0);
    std::vector<Branch> stack{camera};
    while (!stack.empty()) {
        Branch branch = std::move(stack.back());
        stack.pop_back();
        const std::optional<Hit> hit = closest_hit(world, branch.ray, {0, infinity});
        if (world.needs.absorption) branch.weight *= left_after(world, branch.media, hit ? hit->t : infinity);
        const std::optional<Vec3> seen =
            hit ? light_at(world, branch.ray, *hit) : background(world, branch.ray.direction);
        if (seen) {
            sum += branch.weight * *seen;
            continue;
        }
        const Surface surface = surface_at(world, branch.ray, *hit);
        const Material material = material_at(world, *hit, surface);
        const Vec3 n = turned_to_viewer(surface.shading_normal, branch.ray.direction);
        sum += branch.weight *
               local_light(world, surface, material, n, -branch.ray.direction, branch.ray.time, stream);
        for (Branch& next : spread_branches(world, branch, *hit, surface, material, stream)) {
            ++(next.kind == RayKind::Reflection ? ray_counts().reflection : ray_counts().refraction);
            stack.push_back(std::move(next));
        }
    }
    return sum;
}

}  // namespace rt
