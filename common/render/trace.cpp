// The ray tree of one camera ray, written down: what was hit, what each light gave, what went on.
#include "common/render/trace.hpp"

#include "common/render/integrators.hpp"
#include "common/render/lights.hpp"

namespace rt {
namespace {

/// Writes down what is seen at the hit; the surface's material.
Material shade(const World& world, TraceRecord& record) {
    const Ray& ray = record.branch.ray;
    record.surface = surface_at(world, ray, *record.hit);
    record.normal = turned_to_viewer(record.surface.shading_normal, ray.direction);
    record.material = material_index(world, *record.hit, record.surface);
    const Material material = material_at(world, *record.hit, record.surface);
    if (!row_of(world.integrator).tree) return material;
    record.local = material.ambient + material.emission;
    if (!world.needs.lights) return material;
    visit_lights(world, record.surface, record.normal, [&](const LightSample& sample, const Vec3& visible) {
        const Vec3 part = reflected_light(material, record.normal, -ray.direction, sample, visible);
        record.lights.push_back({sample, visible, part});
        record.local += part;
    });
    return material;
}

}  // namespace

std::vector<TraceRecord> trace_tree(const World& world, const Ray& ray, std::size_t most) {
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
        record.local =
            row_of(world.integrator).tree ? background(world, here.direction) : color_along(world, here);
        record.hit = closest_hit(world, here, {0, infinity});
        const int index = static_cast<int>(tree.size());
        if (world.needs.absorption)
            record.weight *= left_after(world, record.branch.media, record.hit ? record.hit->t : infinity);
        if (record.hit) {
            const Material material = shade(world, record);
            if (bounces) {
                Branch arrived = record.branch;
                arrived.weight = record.weight;
                const Branches next = scatter(world, arrived, *record.hit, record.surface, material);
                for (int i = next.count - 1; i >= 0; --i) {
                    TraceRecord child;
                    child.branch = next.branch[static_cast<std::size_t>(i)];
                    child.parent = index;
                    stack.push_back(std::move(child));
                }
            }
        }
        tree.push_back(std::move(record));
    }
    return tree;
}

}  // namespace rt
