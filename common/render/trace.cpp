// The ray tree of one camera ray, written down: what was hit, what each light gave, what went on.
#include "common/render/trace.hpp"

#include "common/render/area_lights.hpp"
#include "common/render/integrators.hpp"
#include "common/render/lights.hpp"
#include "common/render/other_light.hpp"
#include "common/render/rough.hpp"

#include <utility>

namespace rt {
namespace {

/// Writes down which part of the local light each light gives. Area lights are asked by the numbers of
/// `stream`, if there is one.
void write_lights(const World& world, const Material& material, TraceRecord& record, Stream* stream) {
    const Ray& ray = record.branch.ray;
    const LampShading lamps = lamp_shading(world, record.surface, material, record.normal, -ray.direction);
    record.finish = lamps.finish;
    const auto write = [&](const LightSample& sample, const Vec3& visible, std::uint32_t number) {
        record.lights.push_back({number, sample, visible, sent_on(lamps, sample, visible), std::nullopt});
        if (lamps.finish) record.lights.back().lobe = lobe_towards(lamps, sample);
    };
    const auto ask_all = [&](const Vec3& side) {
        const LightAsked asked{world, record.surface, side, ray.time};
        visit_lamps(asked, write);
        if (stream) visit_area_lights(asked, *stream, write);
    };
    ask_all(record.normal);
    if (shines_through(lamps)) ask_all(-record.normal);
}

/// Writes down what is seen at the hit by the numbers of a stream, or what the area light shows that is hit.
void shade_by_sample(const World& world, const Material& material, TraceRecord& record, Stream& stream) {
    const Ray& ray = record.branch.ray;
    if (const std::optional<Vec3> light = light_at(world, ray, *record.hit)) {
        record.local = *light;
        return;
    }
    Stream again = stream;
    record.local =
        local_light(world, record.surface, material, record.normal, -ray.direction, ray.time, stream);
    record.skylight = light_of_sky(world, material, record.normal);
    record.spread = {world.needs.reflection ? gloss_of(world, material, false) : 0,
                     world.needs.refraction ? gloss_of(world, material, true) : 0,
                     facet_alpha(world, material)};
    if (world.needs.lights) write_lights(world, material, record, &again);
}

/// Writes down what is seen at the hit; the surface's material. Without a stream nothing is random.
Material shade(const World& world, TraceRecord& record, Stream* stream) {
    const Ray& ray = record.branch.ray;
    record.surface = surface_at(world, ray, *record.hit);
    record.normal = turned_to_viewer(record.surface.shading_normal, ray.direction);
    record.material = material_index(world, *record.hit, record.surface);
    const Material material = material_at(world, *record.hit, record.surface);
    if (!row_of(world.integrator).tree) return material;
    if (stream) {
        shade_by_sample(world, material, record, *stream);
        return material;
    }
    record.skylight = light_of_sky(world, material, record.normal);
    record.local = material.ambient + material.emission + record.skylight;
    if (!world.needs.lights) return material;
    write_lights(world, material, record, nullptr);
    for (const LightRecord& light : record.lights) record.local += light.contribution;
    return material;
}

/// What a ray sees where it hits nothing, or all that it sees where there is no tree.
Vec3 seen_at_once(const World& world, const Ray& ray, Stream* stream) {
    if (row_of(world.integrator).tree) return background(world, ray.direction);
    return stream ? color_function(world)(world, ray, *stream) : color_along(world, ray);
}

/// What goes on from a hit, the last to be traced first.
std::vector<Branch> going_on(const World& world, const TraceRecord& record, const Material& material,
                             Stream* stream) {
    Branch arrived = record.branch;
    arrived.weight = record.weight;
    if (!stream) {
        const Branches next = scatter(world, arrived, *record.hit, record.surface, material);
        std::vector<Branch> all;
        for (int i = next.count - 1; i >= 0; --i) all.push_back(next.branch[static_cast<std::size_t>(i)]);
        return all;
    }
    if (light_at(world, arrived.ray, *record.hit)) return {};
    return spread_branches(world, arrived, *record.hit, record.surface, material, *stream);
}

std::vector<TraceRecord> walked(const World& world, const Ray& ray, Stream* stream, std::size_t most) {
    const bool bounces = world.needs.reflection || world.needs.refraction;
    TraceRecord first;
    first.branch.ray = ray;
    if (bounces) first.branch.media = world.eye_inside;
    std::vector<TraceRecord> tree;
    std::vector<TraceRecord> stack{first};
    while (!stack.empty() && tree.size() < most) {
        TraceRecord record = std::move(stack.back());
        stack.pop_back();
        record.weight = record.branch.weight;
        const Ray& here = record.branch.ray;
        record.local = seen_at_once(world, here, stream);
        record.hit = closest_hit(world, here, {0, infinity});
        const int index = static_cast<int>(tree.size());
        if (world.needs.absorption)
            record.weight *= left_after(world, record.branch.media, record.hit ? record.hit->t : infinity);
        if (record.hit) {
            const Material material = shade(world, record, stream);
            if (bounces)
                for (Branch& branch : going_on(world, record, material, stream)) {
                    TraceRecord child;
                    child.branch = std::move(branch);
                    child.parent = index;
                    stack.push_back(std::move(child));
                }
        }
        tree.push_back(std::move(record));
    }
    return tree;
}

}  // namespace

std::vector<TraceRecord> trace_tree(const World& world, const Ray& ray, std::size_t most) {
    return walked(world, ray, nullptr, most);
}

std::vector<TraceRecord> trace_sample(const World& world, const Ray& ray, Stream stream, std::size_t most) {
    return walked(world, ray, &stream, most);
}

}  // namespace rt
