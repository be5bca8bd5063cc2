// The ray tree of a pixel as text.
#include "common/pictures/ray_tree.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// Deeper rays are indented no farther, else a tree's text would grow with the square of its depth.
constexpr std::size_t most_levels = 16;

}  // namespace

std::string number_of_tree(const ordered_json& x) {
    if (x.is_null()) return "NaN";  // JSON has no number for it
    return x.is_string() ? x.get<std::string>() : fmt::format("{:.6g}", x.get<Real>());
}
std::string triple_of_tree(const ordered_json& v) {
    return fmt::format("({}, {}, {})", number_of_tree(v[0]), number_of_tree(v[1]), number_of_tree(v[2]));
}

namespace {

/// How the surface that a ray hits spreads light, where it does not do so evenly and as a mirror.
std::string spreading_text(const ordered_json& ray, const std::string& indent) {
    std::string text;
    if (ray.contains("finish"))
        text += fmt::format("{}  finish {}, {} {}\n", indent, ray["finish"]["kind"].get<std::string>(),
                            ray["finish"].contains("ior") ? "index of refraction" : "roughness",
                            number_of_tree(ray["finish"].back()));
    if (ray.contains("facets"))
        text += fmt::format("{}  sends rays on by facets, alpha {}\n", indent, number_of_tree(ray["facets"]));
    if (ray.contains("gloss"))
        text += fmt::format("{}  spreads mirrored rays as cos^{}\n", indent, number_of_tree(ray["gloss"]));
    if (ray.contains("translucency"))
        text += fmt::format("{}  spreads refracted rays as cos^{}\n", indent,
                            number_of_tree(ray["translucency"]));
    if (ray.contains("skylight"))
        text += fmt::format("{}  light from the sky adds {}\n", indent, triple_of_tree(ray["skylight"]));
    return text;
}

std::string light_text(const ordered_json& light, const std::string& indent) {
    return fmt::format("{}  {}: at distance {}, {} arriving, {} of it visible{}: adds {}\n", indent,
                       light["light"].get<std::string>(), number_of_tree(light["distance"]),
                       triple_of_tree(light["color"]), triple_of_tree(light["visible"]),
                       light.contains("lobe") ? fmt::format(", lobe {}", triple_of_tree(light["lobe"])) : "",
                       triple_of_tree(light["contribution"]));
}

/// How many cells of which grids the ray goes through.
std::string walks_text(const ordered_json& ray, const std::string& indent) {
    std::string text;
    if (!ray.contains("grids")) return text;
    for (const ordered_json& grid : ray["grids"])
        text += fmt::format("{}  goes through {} of the grid over the {}\n", indent,
                            counted(grid["visits"].size(), "cell"), grid["of"].get<std::string>());
    return text;
}

}  // namespace

std::string ray_text(const ordered_json& rays, std::size_t index, Tone heading) {
    const ordered_json& ray = rays[index];
    const std::size_t depth = ray["depth"].get<std::size_t>();
    const std::string indent(4 * std::min(depth, most_levels), ' ');
    std::string text = fmt::format("{}{}{}  weight {}\n{}  from {} towards {}\n", indent,
                                   paint(fmt::format("{} ray", ray["kind"].get<std::string>()), heading),
                                   depth > most_levels ? fmt::format(" of depth {}", depth) : "",
                                   triple_of_tree(ray["weight"]), indent, triple_of_tree(ray["origin"]),
                                   triple_of_tree(ray["direction"]));
    text += walks_text(ray, indent);
    if (!ray["hit"].get<bool>())
        return text + fmt::format("{}  hits nothing: background {}\n", indent, triple_of_tree(ray["local"]));
    text += fmt::format("{}  hits the {} of line {} at t = {}, point {}, normal {}\n", indent,
                        ray["shape"].get<std::string>(), ray["line"].get<int>(), number_of_tree(ray["t"]),
                        triple_of_tree(ray["point"]), triple_of_tree(ray["normal"]));
    if (ray["arriving_weight"] != ray["weight"])
        text +=
            fmt::format("{}  weight after absorption {}\n", indent, triple_of_tree(ray["arriving_weight"]));
    text += spreading_text(ray, indent);
    for (const ordered_json& light : ray["lights"]) text += light_text(light, indent);
    return text + fmt::format("{}  radiance here {}\n", indent, triple_of_tree(ray["local"]));
}

std::string tree_text(const ordered_json& tree, Tone heading) {
    std::string text =
        fmt::format("pixel ({}, {}) of {}: colour {}\n", tree["x"].get<int>(), tree["y"].get<int>(),
                    tree["scene"].get<std::string>(), triple_of_tree(tree["color"]));
    for (std::size_t i = 0; i < tree["rays"].size(); ++i) text += ray_text(tree["rays"], i, heading);
    if (!tree["complete"].get<bool>())
        text += fmt::format("The tree goes on: these are its first {} rays.\n", tree["rays"].size());
    return text;
}

void print_ray(const ordered_json& rays, std::size_t index) {
    fmt::print("{}", ray_text(rays, index, Tone::Bold));
}

void print_tree(const ordered_json& tree) { fmt::print("{}", tree_text(tree, Tone::Bold)); }

}  // namespace rt
