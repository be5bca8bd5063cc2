// The questions of common/world/query.hpp, answered by dispatch over the shapes that occur.
#include "common/world/query.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/11_textures/sky.hpp"
#include "chapters/12_distribution/lens.hpp"
#include "chapters/12_distribution/motion.hpp"
#include "common/render/groups.hpp"
#include "common/render/lights.hpp"
#include "common/render/other_light.hpp"
#include "common/render/textures.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

// A world without accelerators does not look for one in each group. The loops are kept out of the functions
// that call them, which else would save registers for them always.
template <bool accelerators>
[[gnu::noinline]] std::optional<Hit> closest_of_several(const World& world, const Ray& ray, Interval range) {
    std::optional<Hit> best;
    for (const AnyGroup& any : world.groups) {
        visit_group(any, [&](const auto& group) {
            std::optional<Hit> hit =
                accelerators ? closest_in(group, ray, range) : closest_hit(shapes_of(group), ray, range);
            if (!hit) return;
            hit->primitive = group.primitive[hit->primitive];
            // Hits at exactly range.max are reported too, so here the file's order decides.
            if (!best || hit->t < best->t || hit->primitive < best->primitive) best = hit;
            range.max = best->t;
        });
    }
    return best;
}

template <bool accelerators>
[[gnu::noinline]] bool any_of_several(const World& world, const Ray& ray, Interval range) {
    const auto ask = [&](const auto& group) {
        return accelerators ? any_in(group, ray, range) : any_hit(shapes_of(group), ray, range);
    };
    for (const AnyGroup& any : world.groups)
        if (visit_group(any, ask)) return true;
    return false;
}

/// What is hit at exactly the distance of `last`, and comes after it there; see next_hit.
std::optional<Hit> next_at_once(const World& world, const Ray& ray, const Hit& last) {
    thread_local std::vector<Hit> hits;  // in the order of the file, once it is sorted
    hits.clear();
    const Interval here{std::nextafter(last.t, -infinity), last.t};
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&](const auto& group) {
                const std::size_t first = hits.size();
                append_in(group, ray, here, hits);
                for (std::size_t i = first; i < hits.size(); ++i)
                    hits[i].primitive = group.primitive[hits[i].primitive];
            },
            any);
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.primitive < b.primitive; });
    const auto object = [&](const Hit& hit) { return world.primitives[hit.primitive].object; };
    for (auto hit = hits.begin(); hit != hits.end(); ++hit) {
        if (hit->primitive <= last.primitive) continue;
        const bool is_first = std::none_of(hits.begin(), hit,
                                           [&](const Hit& before) { return object(before) == object(*hit); });
        if (is_first) return *hit;
    }
    return std::nullopt;
}

/// Without bumps. Part of its callers, for each of which a call would be a cost.
[[gnu::always_inline]] inline Surface smooth_surface(const World& world, const Ray& ray, const Hit& hit) {
    const Primitive& primitive = world.primitives[hit.primitive];
    return visit_group(world.groups[primitive.group], [&](const auto& group) {
        return surface_in(world, group, primitive.index, ray, hit);
    });
}

/// The ray through a lens, or at a time.
[[gnu::noinline]] Ray blurred_camera_ray(const World& world, const CameraSample& sample) {
    const Real x = sample.place.x, y = sample.place.y;
    Ray ray;
    if (world.needs.lens) {
        const Lens& lens = world.blur.lens;
        const Vec2 on_lens =
            lens.sides == 0 ? disc_point(sample.lens) : polygon_point(lens.sides, lens.turn, sample.lens);
        ray = lens_ray(world.view, lens, x, y, on_lens);
    } else {
        ray = pixel_ray(world.view, x, y);
    }
    ray.origin += sample.time * world.blur.motion;
    ray.time = sample.time;
    return ray;
}

}  // namespace

std::optional<Hit> closest_hit(const World& world, const Ray& ray, Interval range) {
    if (world.needs.accelerators) return closest_of_several<true>(world, ray, range);
    if (world.groups.size() != 1) return closest_of_several<false>(world, ray, range);
    // One group holds all the primitives in the order of the file: its answer is the world's.
    return visit_group(world.groups.front(),
                       [&](const auto& group) { return closest_hit(shapes_of(group), ray, range); });
}

std::optional<Hit> next_hit(const World& world, const Ray& ray, const Hit& last, Interval range) {
    if (const std::optional<Hit> beside = next_at_once(world, ray, last)) return beside;
    return closest_hit(world, ray, {last.t, range.max});
}

bool occluded(const World& world, const Ray& ray, Interval range) {
    if (world.needs.accelerators) return any_of_several<true>(world, ray, range);
    if (world.groups.size() != 1) return any_of_several<false>(world, ray, range);
    return visit_group(world.groups.front(),
                       [&](const auto& group) { return any_hit(shapes_of(group), ray, range); });
}

std::optional<Hit> closest_hit(const SharedMesh& mesh, const Ray& local, Interval range) {
    if (has_accelerator(mesh.triangles)) return closest_by_accelerator(mesh.triangles, local, range);
    return closest_hit(std::span<const Triangle>(mesh.triangles.shapes), local, range);
}

bool occluded(const SharedMesh& mesh, const Ray& local, Interval range) {
    if (has_accelerator(mesh.triangles)) return any_by_accelerator(mesh.triangles, local, range);
    return any_hit(std::span<const Triangle>(mesh.triangles.shapes), local, range);
}

std::vector<Hit> all_hits(const SharedMesh& mesh, const Ray& local) {
    std::vector<Hit> hits;
    const Group<Triangle>& triangles = mesh.triangles;
    append_hits(triangles.accelerator, std::span<const Triangle>(triangles.shapes), local,
                {-infinity, infinity}, mailbox_of(triangles.mailbox), hits);
    return hits;
}

Surface surface_without_bumps(const World& world, const Ray& ray, const Hit& hit) {
    return smooth_surface(world, ray, hit);
}

Surface surface_at(const World& world, const Ray& ray, const Hit& hit) {
    Surface surface = smooth_surface(world, ray, hit);
    if (world.needs.bumps) apply_bumps(world, ray, hit, nullptr, surface);
    return surface;
}

std::uint32_t material_index(const World& world, const Hit& hit, const Surface& surface) {
    const std::uint32_t material = world.primitives[hit.primitive].material;
    if (!world.needs.patterns) return material;
    const Pattern& pattern = world.patterns[material];
    if (pattern.size == 0) return material;
    // A surface that lies exactly between two cubes belongs to the upper one, whatever its rounding.
    const Vec3 cell = glm::floor((surface.point + surface.error) / pattern.size);
    const Real parity = std::fmod(cell.x + cell.y + cell.z, Real(2));
    return parity == 0 ? material : pattern.odd;
}

Material material_at(const World& world, const Hit& hit, const Surface& surface) {
    Material material = world.materials[material_index(world, hit, surface)];
    if (world.needs.textures) apply_texture(world, hit, surface, nullptr, material);
    return material;
}

Vec3 sky_color(const World& world, const Vec3& direction) { return sky_radiance(world.sky, direction); }

const Material* material_around(const World& world, std::span<const Medium> inside) {
    for (auto medium = inside.rbegin(); medium != inside.rend(); ++medium)
        if (!std::binary_search(world.sheets.begin(), world.sheets.end(), medium->object))
            return &world.materials[medium->material];
    return nullptr;
}

Vec3 local_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer) {
    if (world.needs.other_light) return other_light(world, surface, material, normal, to_viewer);
    return sum_of_lights(world, surface, material, normal, to_viewer);
}

Ray camera_ray(const World& world, const CameraSample& sample) {
    if (!world.needs.blur) return pixel_ray(world.view, sample.place.x, sample.place.y);
    return blurred_camera_ray(world, sample);
}

CameraSample camera_sample(const World& world, const Vec2& place, Stream& stream) {
    CameraSample sample{.place = place};
    if (world.needs.lens) sample.lens = next_point(stream);
    if (world.needs.motion) sample.time = shutter_time(world.blur.shutter, next_real(stream));
    return sample;
}

Ray camera_ray(const World& world, const Vec2& place, Stream& stream) {
    if (!world.needs.blur) return pixel_ray(world.view, place.x, place.y);
    return blurred_camera_ray(world, camera_sample(world, place, stream));
}

}  // namespace rt
