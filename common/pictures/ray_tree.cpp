// The ray tree of a pixel as JSON.
#include "common/pictures/ray_tree.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "common/math/input_error.hpp"
#include "common/pictures/grid_walk.hpp"
#include "common/render/compile.hpp"
#include "common/render/integrators.hpp"
#include "common/render/patterns.hpp"
#include "common/render/trace.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// Only of so many rays of a tree the cells are told: a ray may meet hundreds.
constexpr std::size_t most_walks = 100;

std::string_view kind_name(RayKind kind) {
    if (kind == RayKind::Reflection) return "reflection";
    return kind == RayKind::Refraction ? "refraction" : "camera";
}

ordered_json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }
std::string text(const Vec3& v) { return triple_of_tree(to_json(v)); }

/// A number, or "infinity", which JSON has no number for.
ordered_json to_json(Real x) { return std::isinf(x) ? ordered_json("infinity") : ordered_json(x); }

std::string in_words(const AreaLight& light) {
    return std::visit(
        [](const auto& shape) -> std::string {
            if constexpr (requires { shape.center; })
                return "light around " + text(shape.center);
            else if constexpr (requires { shape.corner; })
                return "light with the corner " + text(shape.corner);
            else
                return "light with the corner " + text(shape.a);
        },
        light.shape);
}

/// The light with this number of the world (LightRecord), by what tells it from the others.
std::string light_in_words(const World& world, std::size_t number) {
    if (number < world.point_lights.size())
        return "point light at " + text(world.point_lights[number].position);
    number -= world.point_lights.size();
    if (number < world.directional_lights.size())
        return "light from the direction " + text(world.directional_lights[number].direction);
    return in_words(world.area_lights.lights[number - world.directional_lights.size()]);
}

ordered_json to_json(const World& world, const LightRecord& light) {
    ordered_json json = {
        {"light", light_in_words(world, light.light)}, {"direction", to_json(light.sample.direction)},
        {"distance", to_json(light.sample.distance)},  {"color", to_json(light.sample.color)},
        {"visible", to_json(light.visible)},           {"contribution", to_json(light.contribution)}};
    if (light.lobe) json["lobe"] = to_json(*light.lobe);
    return json;
}

/// What few hits have: how the surface spreads light.
void add_spreading(const World& world, const TraceRecord& record, ordered_json& json) {
    if (record.finish) {
        const bool is_coat = record.finish->kind == FinishKind::Coated;
        json["finish"] = {{"kind", word_of(record.finish->kind).name},
                          {is_coat ? "ior" : "roughness", record.finish->value}};
    }
    const auto& [gloss, translucency, alpha] = record.spread;
    if (alpha > 0) json["facets"] = alpha;
    if (alpha == 0 && gloss > 0) json["gloss"] = gloss;
    if (alpha == 0 && translucency > 0) json["translucency"] = translucency;
    if (world.needs.skylight) json["skylight"] = to_json(record.skylight);
}

/// Which object of the file the primitive is.
std::uint32_t object_of(const World& world, std::uint32_t primitive) {
    const auto face = std::ranges::lower_bound(world.faces, primitive, {}, &BodyFace::primitive);
    return face != world.faces.end() && face->primitive == primitive ? face->object
                                                                     : world.primitives[primitive].object;
}

ordered_json to_json(const Scene& scene, const World& world, const TraceRecord& record) {
    const Branch& branch = record.branch;
    ordered_json json = {{"kind", kind_name(branch.kind)},
                         {"parent", record.parent},
                         {"depth", branch.depth},
                         {"origin", to_json(branch.ray.origin)},
                         {"direction", to_json(branch.ray.direction)},
                         {"weight", to_json(branch.weight)},
                         {"hit", record.hit.has_value()}};
    if (record.hit) {
        const std::uint32_t number = object_of(world, record.hit->primitive);
        const bool is_light = number >= scene.objects.size();
        json["shape"] = is_light ? "area light" : words_of(scene.objects[number].shape).name;
        json["line"] = is_light ? scene.area_lights[number - scene.objects.size()].place.line
                                : scene.objects[number].place.line;
        json["primitive"] = record.hit->primitive;
        json["t"] = to_json(record.hit->t);
        json["point"] = to_json(record.surface.point);
        json["normal"] = to_json(record.normal);
        json["arriving_weight"] = to_json(record.weight);
        add_spreading(world, record, json);
        json["lights"] = ordered_json::array();
        for (const LightRecord& light : record.lights) json["lights"].push_back(to_json(world, light));
    }
    json["local"] = to_json(record.local);
    return json;
}

/// The ray of a pixel's first sample, and the random numbers that are left for what it meets.
std::pair<Ray, Stream> first_sample(const World& world, int x, int y) {
    const int count = world.sampling.count;
    const Patterns patterns =
        patterns_for(world, count == 1 ? Sampler::Regular : world.sampling.sampler, count);
    Stream stream = stream_of(world, patterns, x, y, 0, count);
    const Vec2 at = pattern_of(world, patterns, x, y, 0, count).front().at;
    const Ray ray = camera_ray(world, Vec2(x, y) + at, stream);
    return {ray, stream};
}

}  // namespace

ordered_json ray_tree(const Scene& scene, int x, int y) { return ray_tree(scene, compile(scene), x, y); }

ordered_json ray_tree(const Scene& scene, const World& world, int x, int y) {
    if (x < 0 || y < 0 || x >= scene.width || y >= scene.height)
        throw InputError(
            fmt::format("pixel ({}, {}) is outside the picture of {} × {}", x, y, scene.width, scene.height));
    const bool sampled = world.needs.distribution;
    auto [ray, stream] =
        sampled ? first_sample(world, x, y) : std::pair{pixel_ray(world.view, x + 0.5, y + 0.5), Stream()};
    ordered_json rays = ordered_json::array();
    Vec3 color(0);
    std::vector<TraceRecord> tree =
        sampled ? trace_sample(world, ray, stream, most_rays + 1) : trace_tree(world, ray, most_rays + 1);
    const bool complete = tree.size() <= most_rays;
    if (!complete) tree.pop_back();
    for (const TraceRecord& record : tree) {
        color += record.weight * record.local;
        rays.push_back(to_json(scene, world, record));
        if (world.needs.accelerators && rays.size() <= most_walks)
            rays.back()["grids"] = walks_of(world, record.branch.ray);
    }
    return {{"scene", scene.file},
            {"x", x},
            {"y", y},
            {"color", to_json(color_function(world)(world, ray, stream))},
            {"tree_color", to_json(color)},
            {"complete", complete},
            {"rays", rays}};
}

}  // namespace rt
