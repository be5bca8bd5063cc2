// Where two ray trees of one pixel first differ, and the step that computes it.
#include "common/pictures/tree_difference.hpp"

#include "common/math/vec.hpp"
#include "common/pictures/ray_tree.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// Equal up to what another order of the same operations may change.
bool same(const ordered_json& a, const ordered_json& b) {
    if (a.is_array() && b.is_array()) {
        if (a.size() != b.size()) return false;
        Real size = 0, apart = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (!a[i].is_number() || !b[i].is_number()) return a == b;
            size = std::max({size, std::abs(a[i].get<Real>()), std::abs(b[i].get<Real>())});
            apart = std::max(apart, std::abs(a[i].get<Real>() - b[i].get<Real>()));
        }
        return apart <= 1e-9 * size;
    }
    if (a.is_number_float() && b.is_number()) return same(ordered_json{a}, ordered_json{b});
    return a == b;
}

/// The step that computes a quantity of a ray; `shape` is what it hit.
std::string step_of(const std::string& quantity, const ordered_json& ray) {
    const std::string kind = ray["kind"], shape = ray.value("shape", "");
    const bool triangle = shape == "triangle" || shape == "mesh";
    if (quantity == "origin" || quantity == "direction") {
        if (kind == "camera") return quantity == "origin" ? "01.3" : "01.2";
        if (quantity == "origin") return "06.1";
        return kind == "reflection" ? "07.1" : "07.2";
    }
    if (quantity == "kind" || quantity == "parent" || quantity == "weight") return "07.5";
    if (quantity == "arriving_weight") return "07.4";
    if (quantity == "skylight") return "11.9";
    if (quantity == "hit" || quantity == "primitive" || quantity == "t" || quantity == "line" ||
        quantity == "shape")
        return shape == "sphere" ? "02.3" : triangle ? "03.7" : shape == "polygon" ? "03.2" : "01.4";
    if (quantity == "point" || quantity == "normal")
        return shape == "sphere" ? "02.4" : triangle ? "03.8" : "01.4";
    return "05.5";
}
/// The step of the lobe of a finish.
std::string step_of_lobe(const ordered_json& ray) {
    static const std::map<std::string, std::string> steps{
        {"matte", "11.13"}, {"metal", "11.14"}, {"glass", "11.15"}, {"velvet", "11.16"}, {"coated", "11.17"}};
    return steps.at(ray["finish"]["kind"].get<std::string>());
}
std::string step_of_light(const std::string& quantity, const ordered_json& ray) {
    if (quantity == "visible") return "06.3";
    if (quantity == "lobe") return step_of_lobe(ray);
    return quantity == "contribution" ? "05.5" : "05.1";
}

std::string text(const ordered_json& value) {
    return value.is_array() && value.size() == 3 ? triple_of_tree(value)
           : value.is_number_float()             ? number_of_tree(value)
                                                 : json_text(value);
}

/// The step that sends on a ray from a surface which spreads what it sends on; empty where it does not.
std::string step_of_spread(const ordered_json& rays, const ordered_json& ray) {
    if (ray["parent"].get<int>() < 0) return "";
    const ordered_json& parent = rays[ray["parent"].get<std::size_t>()];
    if (parent.contains("facets")) return "11.14";
    return parent.contains(ray["kind"] == "reflection" ? "gloss" : "translucency") ? "12.19" : "";
}

/// The first difference of two rays, which are number `i` of their trees.
std::optional<TraceDifference> difference_of_rays(const ordered_json& a, const ordered_json& b,
                                                  std::size_t i) {
    for (const char* quantity : {"kind", "parent", "origin", "direction", "weight", "hit", "primitive", "t",
                                 "point", "normal", "arriving_weight", "skylight"}) {
        const ordered_json p = a.value(quantity, ordered_json()), q = b.value(quantity, ordered_json());
        if (same(p, q)) continue;
        const ordered_json& known = b["hit"].get<bool>() ? b : a;
        return TraceDifference{i, quantity, text(p), text(q), step_of(quantity, known)};
    }
    const ordered_json lights = a.value("lights", ordered_json::array());
    const ordered_json other = b.value("lights", ordered_json::array());
    for (std::size_t k = 0; k < std::min(lights.size(), other.size()); ++k)
        for (const char* quantity : {"direction", "distance", "color", "visible", "lobe", "contribution"}) {
            const ordered_json p = lights[k].value(quantity, ordered_json()),
                               q = other[k].value(quantity, ordered_json());
            if (!same(p, q))
                return TraceDifference{i, fmt::format("light {}: {}", k + 1, quantity), text(p), text(q),
                                       step_of_light(quantity, b)};
        }
    if (lights.size() != other.size())
        return TraceDifference{i, "number of lights in front of the surface", std::to_string(lights.size()),
                               std::to_string(other.size()), "05.1"};
    if (!same(a["local"], b["local"]))
        return TraceDifference{i, "radiance", text(a["local"]), text(b["local"]), "05.5"};
    return std::nullopt;
}

}  // namespace

std::optional<TraceDifference> first_difference(const ordered_json& mine, const ordered_json& theirs) {
    const ordered_json &a = mine["rays"], &b = theirs["rays"];
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (auto difference = difference_of_rays(a[i], b[i], i)) {
            const std::string spread = step_of_spread(b, b[i]);
            if (difference->quantity == "direction" && !spread.empty()) difference->step = spread;
            return difference;
        }
    if (a.size() != b.size())
        return TraceDifference{std::min(a.size(), b.size()), "number of rays", std::to_string(a.size()),
                               std::to_string(b.size()), "07.5"};
    if (!same(mine["color"], theirs["color"]))
        return TraceDifference{0, colour_of_pixel, text(mine["color"]), text(theirs["color"]),
                               a.size() > 1 ? "07.6" : "01.6"};
    return std::nullopt;
}

}  // namespace rt
