// What compiling a scene kept, what it left out, and why.
#include "common/render/explain.hpp"

#include "common/math/counted.hpp"
#include "common/render/accelerate.hpp"
#include "common/render/compile.hpp"
#include "common/render/groups.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace rt {
namespace {

// The memory that a world takes.

template <class... Element>
std::size_t bytes_of(const std::vector<Element>&... lists) {
    return (std::size_t(0) + ... + (lists.size() * sizeof(Element)));
}
template <class Shape>
std::size_t bytes_of(const Group<Shape>& group) {
    std::size_t sum = bytes_of(group.shapes, group.primitive) +
                      std::visit([](const auto& of) { return bytes_of(of); }, group.accelerator) +
                      std::apply([](const auto&... lists) { return bytes_of(lists...); }, group.lists());
    for (const Shape& shape : group.shapes) sum += owned_bytes(shape);
    return sum;
}
/// Each picture once.
std::set<const Image*> pictures_of(const World& world) {
    std::set<const Image*> pictures;
    for (const MaterialTexture& texture : world.textures) pictures.insert(texture.picture.image.get());
    for (const PictureLookup& map : world.normal_maps) pictures.insert(map.image.get());
    if (const auto* sky = std::get_if<ImageSky>(&world.sky)) pictures.insert(sky->image.get());
    pictures.erase(nullptr);
    return pictures;
}
std::size_t bytes_of(const World& world) {
    std::size_t sum =
        bytes_of(world.primitives, world.materials, world.patterns, world.textures, world.bumps,
                 world.normal_maps, world.finishes, world.point_lights, world.directional_lights, world.faces,
                 world.sheets, world.area_lights.lights, world.area_lights.chances, world.area_lights.of);
    for (const AnyGroup& any : world.groups)
        sum += std::visit([](const auto& group) { return bytes_of(group); }, any);
    for (const auto& mesh : world.meshes) sum += bytes_of(mesh->triangles);
    for (const Image* picture : pictures_of(world)) sum += bytes_of(picture->pixels);
    return sum;
}

/// How many shapes of which kind a group has.
template <class Shape>
std::string shapes_in_words(const Group<Shape>& group) {
    const ShapeWords& w = words<Shape>;
    if constexpr (std::is_same_v<Shape, Triangle>) {
        const char* kind = group.normals.empty() ? "flat" : "smooth";
        return counted(group.shapes.size(), fmt::format("{} {}", kind, w.one),
                       fmt::format("{} {}", kind, w.many));
    }
    return counted(group.shapes.size(), w.one, w.many);
}

/// Sorts features into kept and left out.
struct Sorter {
    Explanation& explanation;
    void feature(bool needed, const char* what, const char* why_kept, const char* why_left_out) {
        (needed ? explanation.kept : explanation.left_out)
            .push_back({what, needed ? why_kept : why_left_out});
    }
};

template <class Shape>
void explain_accelerator(const Scene& scene, const World& world, const Group<Shape>& group,
                         Explanation& explanation) {
    if (!has_accelerator(group)) return;
    const std::size_t shapes = group.shapes.size();
    const std::string what = std::visit(
        [&](const auto& of) {
            return fmt::format("{} for them, {} bytes a shape", in_words(of), bytes_of(of) / shapes);
        },
        group.accelerator);
    explanation.kept.push_back({what, scene.accelerator == AcceleratorChoice::Auto
                                          ? fmt::format("about {:.2g} rays would ask {} shapes each",
                                                        expected_rays(scene, world), shapes)
                                          : "the scene says 'accelerator'"});
}

std::string why_no_accelerator(const Scene& scene, const World& world) {
    if (scene.accelerator == AcceleratorChoice::None) return "the scene says 'accelerator none'";
    if (scene.visibility == Visibility::Rasterize) return "scan conversion traces no rays";
    std::size_t most = 0;
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&]<class Shape>(const Group<Shape>& group) {
                if constexpr (has_bounds<Shape>()) most = std::max(most, group.shapes.size());
            },
            any);
    for (const auto& mesh : world.meshes) most = std::max(most, mesh->triangles.shapes.size());
    if (most == 0) return "nothing has an end";
    return fmt::format("at most {} of a kind: to ask them all costs less than to build and walk", most);
}

void explain_groups(const Scene& scene, const World& world, Explanation& explanation) {
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&](const auto& group) {
                explanation.kept.push_back({shapes_in_words(group), "in one array"});
                explain_accelerator(scene, world, group, explanation);
            },
            any);
    for (const auto& mesh : world.meshes) {
        const std::size_t shapes = mesh->triangles.shapes.size();
        explanation.kept.push_back(
            {counted(shapes, "shared triangle"), "one mesh that several objects show"});
        explain_accelerator(scene, world, mesh->triangles, explanation);
    }
}

void explain_lights(const Scene& scene, const World& world, Explanation& explanation) {
    const std::size_t area = world.area_lights.lights.size();
    if (area > 0) explanation.kept.push_back({counted(area, "area light"), "also to be seen"});
    const std::size_t kept = world.point_lights.size() + world.directional_lights.size();
    if (kept > 0) explanation.kept.push_back({counted(kept, "light"), "they reach some material"});
    if (kept == scene.lights.size()) return;
    explanation.left_out.push_back({counted(scene.lights.size() - kept, "light"),
                                    !row_of(scene.integrator).lights ? "the integrator asks no lights"
                                    : kept == 0 ? "no material reflects light, or all lights are black"
                                                : "black"});
}

bool is_transformed(const Scene& scene) {
    const auto has_one = [](const Object& object) { return object.transform >= 0; };
    return std::ranges::any_of(scene.objects, has_one) || std::ranges::any_of(scene.parts, has_one);
}

/// Whether a texture says how far mirrored or refracted rays are spread.
bool spread_varies(const World& world) {
    return world.needs.textures && std::ranges::any_of(world.finishes, [](const Finish& finish) {
               const TexturedFinish& textured = finish.textured;
               return (textured.gloss && finish.gloss > 0) ||
                      (textured.translucency && finish.translucency > 0) ||
                      (textured.roughness && finish.brdf == Brdf::Ggx);
           });
}

void explain_features(const Scene& scene, const World& world, Explanation& explanation) {
    const Needs& needs = world.needs;
    Sorter sort{explanation};
    const bool transformed = is_transformed(scene);
    sort.feature(needs.transforms, "matrices",
                 "some shapes cannot take their transform into their own numbers",
                 transformed ? "every transform is baked into its shape" : "no object is transformed");
    sort.feature(needs.normals, "interpolated normals", "some triangles are smooth",
                 "no smooth triangle whose normal the picture shows");
    sort.feature(needs.uvs, "texture coordinates",
                 row_of(scene.integrator).uvs ? "the integrator shows them"
                                              : "some material has a picture or a normal map",
                 "nothing in the picture uses them");
    sort.feature(needs.patterns, "checkers", "some material has one", "no material has one");
    sort.feature(needs.textures, "textures", "some material has a picture or a pattern of two colours",
                 "no material varies from place to place");
    sort.feature(needs.footprints, "ray differentials", "some texture is averaged over what a pixel sees",
                 "no texture asks how much of it a pixel sees");
    sort.feature(!world.bumps.empty(), "bumps", "some material has them", "no material has them");
    sort.feature(needs.normal_maps, "normal maps", "some material has one", "no material has one");
    sort.feature(needs.sky, "the sky's colours", "they depend on the direction",
                 "the background is one colour");
    sort.feature(needs.skylight, "light from the sky", "the scene says 'skylight'",
                 needs.sky ? "nothing asks for it" : "there is no sky");
    sort.feature(needs.finishes, "finishes", "some material spreads light in another way than evenly",
                 needs.lights ? "all diffuse light is spread evenly" : "no lights");
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
    sort.feature(needs.lens, "a lens", "the scene says 'lens'", "the camera is a pinhole");
    sort.feature(needs.motion, "a time for each ray", "something moves while the shutter is open",
                 "nothing moves");
    sort.feature(needs.area_lights, "points of area lights", "some light has an extent",
                 "no light has an extent, or nothing asks for it");
    sort.feature(needs.gloss || needs.rough, "spread rays",
                 spread_varies(world)
                     ? "some material is glossy, translucent or rough, and a texture says how much"
                     : "some material is glossy, translucent or rough",
                 "every mirrored and refracted ray has one direction");
    if (needs.samples)
        explanation.kept.push_back(
            {counted(static_cast<std::size_t>(world.sampling.count), "sample a pixel", "samples a pixel"),
             world.sampling.count > 1           ? "the scene says 'spp'"
             : needs.blur || needs.distribution ? "something is random about it"
                                                : "its filter is wider than a pixel"});
    else
        explanation.left_out.push_back({"random numbers", world.visibility == Visibility::Rasterize
                                                              ? "scan conversion looks at the pixels' centres"
                                                              : "one sample a pixel, at its centre"});
    if (!needs.accelerators) explanation.left_out.push_back({"grids", why_no_accelerator(scene, world)});
}

template <class Shape>
void add_chapters(std::vector<std::string>& chapters) {
    for (const std::string_view step : words<Shape>.steps)
        if (!step.empty()) chapters.emplace_back(step.substr(0, 2));
}

std::vector<std::string> chapters_of(const Scene& scene, const World& world) {
    std::vector<std::string> chapters{"01", std::string(row_of(scene.integrator).chapter)};
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&]<class Shape>(const Group<Shape>& group) {
                add_chapters<Shape>(chapters);
                if constexpr (std::is_same_v<Shape, Combination>)
                    for (const Combination& tree : group.shapes)
                        for (const Combination::Part& part : tree.parts)
                            std::visit([&]<class Part>(const Part&) { add_chapters<Part>(chapters); },
                                       part.solid);
                if constexpr (std::is_same_v<Shape, Moving> || std::is_same_v<Shape, Turning>)
                    for (const Shape& moving : group.shapes)
                        std::visit([&]<class One>(const One&) { add_chapters<One>(chapters); }, moving.shape);
            },
            any);
    if (is_transformed(scene) && !world.groups.empty()) chapters.emplace_back("04");
    const Needs& needs = world.needs;
    const bool recursion = needs.reflection || needs.refraction;
    if (needs.lights || recursion) chapters.emplace_back("05");
    if (needs.shadows || recursion) chapters.emplace_back("06");
    if (recursion) chapters.emplace_back("07");
    if (needs.samples) chapters.emplace_back("08");
    if (needs.textures || needs.bumps || needs.sky || needs.finishes) chapters.emplace_back("11");
    if (needs.blur || needs.distribution || world.sampling.sampler == Sampler::Sobol)
        chapters.emplace_back("12");
    // An accelerator that the scene does not ask for is a matter of time only.
    for (const AcceleratorWord& word : accelerator_words)
        if (needs.accelerators && word.value == scene.accelerator && !word.chapter.empty())
            chapters.emplace_back(word.chapter);
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
    explanation.bytes = bytes_of(world);
    return explanation;
}

}  // namespace rt
