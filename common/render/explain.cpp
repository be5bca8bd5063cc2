// What compiling a scene kept, what it left out, and why.
#include "common/render/explain.hpp"

#include "chapters/09_grids/build.hpp"
#include "common/render/compile.hpp"
#include "common/render/grids.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace rt {
namespace {

struct Kind {
    std::string_view one, many;
    std::string_view chapter;
};

Kind kind(const Planes&) { return {"plane", "planes", "01"}; }
Kind kind(const Spheres&) { return {"sphere", "spheres", "02"}; }
Kind kind(const Triangles& group) {
    if (group.normals.empty()) return {"flat triangle", "flat triangles", "03"};
    return {"smooth triangle", "smooth triangles", "03"};
}
Kind kind(const Polygons&) { return {"polygon", "polygons", "03"}; }
Kind kind(const Ellipsoids&) {
    return {"ellipsoid with its matrices", "ellipsoids with their matrices", "04"};
}
Kind kind(const Instances&) { return {"instance with its matrices", "instances with their matrices", "04"}; }

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}
template <class Shape>
std::size_t bytes(const Group<Shape>& group) {
    return bytes(group.shapes) + bytes(group.primitive);
}
std::size_t bytes(const Triangles& group) {
    return bytes(group.shapes) + bytes(group.primitive) + bytes(group.normals) + bytes(group.uvs);
}
std::size_t bytes(const Polygons& group) {
    std::size_t sum = bytes(group.shapes) + bytes(group.primitive);
    for (const Polygon& polygon : group.shapes) sum += bytes(polygon.vertices);
    return sum;
}
std::size_t bytes(const World& world) {
    std::size_t sum = bytes(world.primitives) + bytes(world.materials) + bytes(world.patterns) +
                      bytes(world.point_lights) + bytes(world.directional_lights) + bytes(world.faces) +
                      bytes(world.sheets);
    for (const AnyGroup& any : world.groups)
        sum += std::visit(
            []<class Kind>(const Kind& group) {
                if constexpr (has_grid<Kind>)
                    return bytes(group) + bytes_of(group.grid);
                else
                    return bytes(group);
            },
            any);
    for (const SharedMesh& mesh : world.meshes)
        sum += bytes(mesh.triangles) + (mesh.grid.empty() ? 0 : bytes_of(mesh.grid));
    return sum;
}

std::string counted(std::size_t n, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Sorts features into kept and left out.
struct Sorter {
    Explanation& explanation;
    void feature(bool needed, const char* what, const char* why_kept, const char* why_left_out) {
        (needed ? explanation.kept : explanation.left_out)
            .push_back({what, needed ? why_kept : why_left_out});
    }
};

/// The number of grids: this one and all that are in it.
std::size_t grids_in(const Grid& grid) {
    std::size_t sum = 1;
    for (const Grid& inner : grid.grids) sum += grids_in(inner);
    return sum;
}

void explain_grid(const Scene& scene, const World& world, const Grid& grid, std::size_t shapes,
                  Explanation& explanation) {
    const Cells& cells = grid.shape.cells;
    const std::string what =
        fmt::format("grid of {} × {} × {} cells{} for them, {} bytes a shape", cells.x, cells.y, cells.z,
                    grid.grids.empty() ? "" : fmt::format(" and {} grids in it", grids_in(grid) - 1),
                    bytes_of(grid) / shapes);
    explanation.kept.push_back({what, scene.accelerator == AcceleratorChoice::Auto
                                          ? fmt::format("about {:.2g} rays would ask {} shapes each",
                                                        expected_rays(scene, world), shapes)
                                          : "the scene says 'accelerator'"});
}

std::string why_no_grids(const Scene& scene, const World& world) {
    if (scene.accelerator == AcceleratorChoice::None) return "the scene says 'accelerator none'";
    if (scene.integrator == Integrator::Rasterize) return "scan conversion traces no rays";
    std::size_t most = 0;
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&]<class Kind>(const Kind& group) {
                if (!std::is_same_v<Kind, Planes>) most = std::max(most, group.shapes.size());
            },
            any);
    for (const SharedMesh& mesh : world.meshes) most = std::max(most, mesh.triangles.shapes.size());
    if (most == 0) return "nothing has an end";
    return fmt::format("at most {} of a kind: to ask them all costs less than to build and walk", most);
}

void explain_groups(const Scene& scene, const World& world, Explanation& explanation) {
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&]<class Kind>(const Kind& group) {
                const auto k = kind(group);
                explanation.kept.push_back({counted(group.shapes.size(), k.one, k.many), "in one array"});
                if constexpr (has_grid<Kind>)
                    explain_grid(scene, world, group.grid, group.shapes.size(), explanation);
            },
            any);
    for (const SharedMesh& mesh : world.meshes) {
        const std::size_t shapes = mesh.triangles.shapes.size();
        explanation.kept.push_back(
            {counted(shapes, "shared triangle", "shared triangles"), "one mesh that several objects show"});
        if (!mesh.grid.empty()) explain_grid(scene, world, mesh.grid, shapes, explanation);
    }
}

void explain_lights(const Scene& scene, const World& world, Explanation& explanation) {
    const std::size_t kept = world.point_lights.size() + world.directional_lights.size();
    if (kept > 0) explanation.kept.push_back({counted(kept, "light", "lights"), "they reach some material"});
    if (kept == scene.lights.size()) return;
    const bool raytrace = scene.integrator == Integrator::Raytrace;
    explanation.left_out.push_back({counted(scene.lights.size() - kept, "light", "lights"),
                                    !raytrace   ? "the integrator asks no lights"
                                    : kept == 0 ? "no material reflects light, or all lights are black"
                                                : "black"});
}

void explain_features(const Scene& scene, const World& world, Explanation& explanation) {
    const Needs& needs = world.needs;
    Sorter sort{explanation};
    const bool transformed = std::any_of(scene.objects.begin(), scene.objects.end(),
                                         [](const Object& object) { return object.transform >= 0; });
    sort.feature(needs.transforms, "matrices",
                 "some shapes cannot take their transform into their own numbers",
                 transformed ? "every transform is baked into its shape" : "no object is transformed");
    sort.feature(needs.normals, "interpolated normals", "some triangles are smooth",
                 "no smooth triangle whose normal the picture shows");
    sort.feature(needs.uvs, "texture coordinates", "the integrator shows them",
                 "nothing in the picture uses them");
    sort.feature(needs.patterns, "patterns", "some material has a checker", "no material has a checker");
    sort.feature(needs.highlights, "highlights", "some material is specular",
                 needs.lights ? "no material is specular" : "no lights");
    sort.feature(needs.shadows, "shadow rays", "there are lights",
                 needs.lights ? "the scene says 'shadows off'" : "no lights");
    sort.feature(needs.colored_shadows, "coloured shadows", "some material is transparent",
                 needs.shadows ? "every material is opaque, so yes or no is enough" : "no shadow rays");
    sort.feature(needs.reflection, "reflected rays", "some material mirrors",
                 "no material mirrors, or no bounce is allowed");
    sort.feature(needs.refraction, "refracted rays", "some material transmits",
                 "no material transmits, or no bounce is allowed");
    sort.feature(needs.absorption, "absorption", "some material absorbs inside", "no medium absorbs");
    if (needs.samples)
        explanation.kept.push_back(
            {fmt::format("{} samples a pixel", world.sampling.count),
             world.sampling.count > 1 ? "the scene says 'spp'" : "its filter is wider than a pixel"});
    else
        explanation.left_out.push_back({"random numbers", world.integrator == Integrator::Rasterize
                                                              ? "scan conversion looks at the pixels' centres"
                                                              : "one sample a pixel, at its centre"});
    if (!needs.grids) explanation.left_out.push_back({"grids", why_no_grids(scene, world)});
}

std::vector<std::string> chapters_of(const Scene& scene, const World& world) {
    std::vector<std::string> chapters{"01"};
    for (const AnyGroup& any : world.groups) {
        chapters.emplace_back(std::visit([](const auto& group) { return kind(group).chapter; }, any));
        // An ellipsoid is a sphere in its own space; an instance has triangles in a bounding sphere.
        const std::string_view of = std::visit([](const auto& group) { return kind(group).many; }, any);
        if (of.starts_with("ellipsoid")) chapters.emplace_back("02");
        if (of.starts_with("instance")) chapters.insert(chapters.end(), {"02", "03"});
    }
    for (const Object& object : scene.objects)
        if (object.transform >= 0 && !world.groups.empty()) {
            chapters.emplace_back("04");
            break;
        }
    const Needs& needs = world.needs;
    const bool recursion = needs.reflection || needs.refraction;
    if (needs.lights || recursion) chapters.emplace_back("05");
    if (needs.shadows || recursion) chapters.emplace_back("06");
    if (recursion) chapters.emplace_back("07");
    if (needs.samples) chapters.emplace_back("08");
    // A grid that the scene does not ask for is a matter of time only.
    if (needs.grids && scene.accelerator != AcceleratorChoice::Auto) chapters.emplace_back("09");
    std::sort(chapters.begin(), chapters.end());
    chapters.erase(std::unique(chapters.begin(), chapters.end()), chapters.end());
    return chapters;
}

}  // namespace

Explanation explain(const Scene& scene, const World& world) {
    Explanation explanation;
    explain_groups(scene, world, explanation);
    explain_lights(scene, world, explanation);
    explain_features(scene, world, explanation);
    explanation.chapters = chapters_of(scene, world);
    explanation.bytes = bytes(world);
    return explanation;
}

}  // namespace rt
