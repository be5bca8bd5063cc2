// Where two ray trees of one pixel first differ, and the step to look at.
#include "common/pictures/tree_difference.hpp"

#include "common/math/counted.hpp"
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

using Makers = std::vector<std::string>;

constexpr const char* what_is_hit = "what is hit";

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

std::string text(const ordered_json& value) {
    if (value.is_array() && value.size() == 3) return triple_of_tree(value);
    if (value.is_array() || value.is_object()) return json_text(value);
    return value.is_string() ? value.get<std::string>() : number_of_tree(value);
}

// ------------------------------------------------------------------ what takes part in computing a quantity

Makers operator+(Makers a, const Makers& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// What takes part where a ray meets a triangle.
const Makers triangle_hits{"03.4", "03.5", "03.6", "03.7", "03.9"};

/// Where a ray meets a shape of this name.
Makers makers_of_hit(const std::string& shape) {
    if (shape == "sphere") return {"02.1", "02.2", "02.3", "02.5"};
    if (shape == "plane") return {"01.4", "01.5"};
    if (shape == "polygon") return {"03/polygon.cpp", "03.4"};
    if (shape == "triangle" || shape == "mesh") return triangle_hits;
    return {"10"};
}

/// The point and normal there.
Makers makers_of_surface(const std::string& shape) {
    if (shape == "sphere") return {"02.4", "04"};
    if (shape == "plane") return {"01.4", "04"};
    if (shape == "polygon") return {"03/polygon.cpp", "04"};
    if (shape == "triangle" || shape == "mesh") return {"03.3", "03.8", "04"};
    return {"10", "04"};
}

/// What makes hits of any shape: transforms, grids, motion.
const Makers all_hits{"04", "09", "12/motion.cpp"};

/// The steps of the lobe of a finish: only metal and glass have GGX's facets (11.16), and only glass and a
/// coat Fresnel's law (07.3).
Makers makers_of_lobe(const ordered_json& ray) {
    static const std::map<std::string, Makers> steps{{"matte", {"11.15"}},
                                                     {"metal", {"11.16"}},
                                                     {"glass", {"07.3", "11.16", "11.18"}},
                                                     {"velvet", {"11.20"}},
                                                     {"coated", {"07.3", "11.22"}}};
    return steps.at(ray["finish"]["kind"].get<std::string>());
}

/// Where a ray leads that a hit sends on.
Makers makers_of_direction(const ordered_json& rays, const ordered_json& ray) {
    const std::string kind = ray["kind"];
    if (kind == "camera") return {"01/camera.cpp", "12/lens.cpp"};
    const ordered_json& parent = rays[ray["parent"].get<std::size_t>()];
    const bool is_mirrored = kind == "reflection";
    const Makers sharp{is_mirrored ? "07.1" : "07.2", "07.5"};
    if (parent.contains("facets")) return Makers{"11.17"} + sharp;
    if (parent.contains(is_mirrored ? "gloss" : "translucency")) return sharp + Makers{"12.16", "12.19"};
    return sharp;
}

// ---------------------------------------------------------------------------------------- what is compared

std::string hit_in_words(const ordered_json& ray) {
    if (!ray["hit"].get<bool>()) return "nothing";
    return fmt::format("the {} of line {}", ray["shape"].get<std::string>(), ray["line"].get<int>());
}

std::string shape_of(const ordered_json& ray) { return ray.value("shape", ""); }

std::string cell_in_words(const ordered_json& visits, std::size_t i) {
    return i < visits.size() ? text(visits[i]["cell"]) : "none";
}

std::string content_in_words(const ordered_json& visit) {
    if (visit.contains("inner")) return "a grid of " + text(visit["inner"]) + " cells";
    if (!visit.contains("shapes")) return "nothing that can be read";
    return counted(visit["shapes"].size(), "shape");
}

/// The first difference of two walks through grids over the same shapes.
std::optional<TraceDifference> difference_of_walks(const ordered_json& a, const ordered_json& b,
                                                   std::size_t ray) {
    const std::string over = "the grid over the " + b["of"].get<std::string>();
    for (const auto& [key, what] : {std::pair{"low", "lowest corner"}, std::pair{"high", "highest corner"}})
        if (!same(a[key], b[key]))
            return TraceDifference{ray,
                                   fmt::format("{} of {}", what, over),
                                   text(a[key]),
                                   text(b[key]),
                                   {"09/bounds.cpp", "09/build.cpp"}};
    if (a["cells"] != b["cells"])
        return TraceDifference{ray,
                               "number of cells of " + over,
                               text(a["cells"]),
                               text(b["cells"]),
                               {"09/bounds.cpp", "09/build.cpp"}};
    const ordered_json &mine = a["visits"], &theirs = b["visits"];
    for (std::size_t i = 0; i < std::max(mine.size(), theirs.size()); ++i) {
        const std::string cell = cell_in_words(mine, i), right = cell_in_words(theirs, i);
        if (cell != right)
            return TraceDifference{
                ray,
                fmt::format("cell {} of {} on the way through {}", i + 1, theirs.size(), over),
                cell,
                right,
                {"09.2", "09/walk.cpp"}};
        const ordered_json p = mine[i].value("shapes", ordered_json()),
                           q = theirs[i].value("shapes", ordered_json());
        if (p == q && mine[i].value("inner", ordered_json()) == theirs[i].value("inner", ordered_json()))
            continue;
        const bool alike = content_in_words(mine[i]) == content_in_words(theirs[i]);
        return TraceDifference{ray,
                               fmt::format("content of cell {} of {}", right, over),
                               alike ? "the shapes " + text(p) : content_in_words(mine[i]),
                               alike ? "the shapes " + text(q) : content_in_words(theirs[i]),
                               {"09/bounds.cpp", "09/build.cpp"}};
    }
    return std::nullopt;
}

/// Two rays that are the same hit different things, or at different places. Where they go through grids, the
/// first cell that differs says more.
TraceDifference difference_of_hits(const ordered_json& a, const ordered_json& b, std::size_t ray,
                                   const TraceDifference& plain) {
    const ordered_json mine = a.value("grids", ordered_json::array()),
                       theirs = b.value("grids", ordered_json::array());
    for (std::size_t i = 0; i < std::min(mine.size(), theirs.size()); ++i)
        if (mine[i]["of"] == theirs[i]["of"])
            if (auto difference = difference_of_walks(mine[i], theirs[i], ray)) return *difference;
    return plain;
}

/// The first difference in what two rays are and hit.
std::optional<TraceDifference> difference_of_ways(const ordered_json& rays, const ordered_json& a,
                                                  const ordered_json& b, std::size_t i) {
    const auto differ = [&](const char* key) {
        return !same(a.value(key, ordered_json()), b.value(key, ordered_json()));
    };
    const auto found = [&](const char* key, const char* quantity, const Makers& makers) {
        return TraceDifference{i, quantity, text(a.value(key, ordered_json())),
                               text(b.value(key, ordered_json())), makers};
    };
    const Makers scattered{"07.2", "07.3", "07.4", "07.5"};
    const bool is_camera = b["kind"] == "camera";
    if (differ("kind")) return found("kind", "kind of ray", scattered);
    if (differ("parent")) return found("parent", "ray that it comes from", scattered);
    if (differ("origin"))
        return found("origin", "origin of the ray",
                     is_camera ? Makers{"01/camera.cpp", "12/lens.cpp"} : Makers{"06.1", "07.5"});
    if (differ("direction")) return found("direction", "direction of the ray", makers_of_direction(rays, b));
    const bool from_facet = !is_camera && rays[b["parent"].get<std::size_t>()].contains("facets");
    if (differ("weight"))
        return found("weight", "weight of the ray", (from_facet ? Makers{"11.16"} : Makers{}) + scattered);
    const Makers hits = makers_of_hit(shape_of(b)) + makers_of_hit(shape_of(a)) + all_hits;
    if (differ("hit") || differ("line") || differ("shape"))
        return difference_of_hits(a, b, i, {i, what_is_hit, hit_in_words(a), hit_in_words(b), hits});
    if (differ("primitive") || differ("t")) {
        const bool same_place = !differ("t");
        return difference_of_hits(
            a, b, i,
            same_place ? found("primitive", "number of what is hit", hits) : found("t", "distance t", hits));
    }
    const Makers surface = makers_of_surface(shape_of(b));
    if (differ("point")) return found("point", "point", surface);
    if (differ("normal")) return found("normal", "normal", surface + Makers{"11.11"});
    if (differ("arriving_weight")) return found("arriving_weight", "weight after absorption", {"07.4"});
    if (differ("skylight")) return found("skylight", "light from the sky", {"11.5", "11.6"});
    return std::nullopt;
}

/// The first difference in what one light gave, which stands in both trees.
std::optional<TraceDifference> difference_of_light(const ordered_json& ray, const ordered_json& a,
                                                   const ordered_json& b, std::size_t i) {
    const std::string name = b["light"];
    const bool has_extent = !name.starts_with("point light") && !name.starts_with("light from the direction");
    const Makers sample = has_extent ? Makers{"12"} : Makers{"05.1"};
    const Makers lobe = b.contains("lobe") ? makers_of_lobe(ray) : Makers{};
    const Makers shadow = Makers{"06", "01.4", "02.1", "02.2", "02.3", "02.5", "03/polygon.cpp", "10"} +
                          triangle_hits + all_hits;
    const std::tuple<const char*, const char*, Makers> quantities[] = {
        {"direction", "direction to", sample},
        {"distance", "distance to", sample},
        {"color", "light arriving from", sample},
        {"visible", "visible part of", shadow},
        {"lobe", "lobe towards", lobe},
        {"contribution", "light sent on from", Makers{"05.2", "05.3", "05.4", "05.5"} + lobe},
    };
    for (const auto& [key, words, makers] : quantities) {
        const ordered_json p = a.value(key, ordered_json()), q = b.value(key, ordered_json());
        if (!same(p, q))
            return TraceDifference{i, fmt::format("{} the {}", words, name), text(p), text(q), makers};
    }
    return std::nullopt;
}

/// What the lists of two hits say of the light with this name, the `turn`-th time that it occurs.
const ordered_json* find_light(const ordered_json& lights, const ordered_json& name, int turn) {
    for (const ordered_json& light : lights)
        if (light["light"] == name && turn-- == 0) return &light;
    return nullptr;
}

/// The first difference of two hits' lights, each compared with itself: a light that stands in front of the
/// surface in one tree only is not there in the other.
std::optional<TraceDifference> difference_of_lights(const ordered_json& a, const ordered_json& b,
                                                    std::size_t i) {
    const ordered_json mine = a.value("lights", ordered_json::array());
    const ordered_json theirs = b.value("lights", ordered_json::array());
    const auto missing = [&](const ordered_json& light, bool in_mine) {
        const char *front = "in front of the surface", *behind = "behind it";
        return TraceDifference{i,
                               "side of the " + light["light"].get<std::string>(),
                               in_mine ? front : behind,
                               in_mine ? behind : front,
                               {"05.1", "12"}};
    };
    std::map<std::string, int> turns;
    for (const ordered_json& light : theirs) {
        const ordered_json* same_one =
            find_light(mine, light["light"], turns[light["light"].get<std::string>()]++);
        if (!same_one) return missing(light, false);
        if (auto difference = difference_of_light(b, *same_one, light, i)) return difference;
    }
    for (const ordered_json& light : mine)
        if (turns[light["light"].get<std::string>()]-- <= 0) return missing(light, true);
    if (!same(a["local"], b["local"])) {
        const bool is_hit = b["hit"].get<bool>();
        return TraceDifference{i, is_hit ? "radiance of the hit" : "background", text(a["local"]),
                               text(b["local"]), is_hit ? Makers{"05.5", "11"} : Makers{"11.4"}};
    }
    return std::nullopt;
}

Vec3 vec(const ordered_json& v) {
    const auto at = [&](std::size_t i) { return v[i].is_number() ? v[i].get<Real>() : Real(0); };
    return {at(0), at(1), at(2)};
}

/// How a tree's colour seems to have been summed up, if its rays' lights were not weighted as they should be:
/// ", as if …", or nothing.
std::string how_summed(const ordered_json& tree) {
    const Vec3 extra = vec(tree["color"]) - vec(tree["tree_color"]);
    const auto is_extra = [&](const Vec3& v) {
        return length(v - extra) <= 1e-9 * (length(v) + length(extra));
    };
    Vec3 left_out(0), unweighted(0), all_unweighted(0);
    for (const ordered_json& ray : tree["rays"]) {
        const Vec3 local = vec(ray["local"]), weight = vec(ray.value("arriving_weight", ray["weight"]));
        const std::string what =
            fmt::format("the {} ray that hits {}", ray["kind"].get<std::string>(), hit_in_words(ray));
        if (is_extra(-weight * local)) return fmt::format(", as if {} were left out", what);
        if (is_extra(local - weight * local))
            return fmt::format(", as if {} counted in full, not by its weight", what);
        all_unweighted += local - weight * local;
        if (ray["hit"].get<bool>()) continue;
        left_out -= weight * local;
        unweighted += local - weight * local;
    }
    if (is_extra(all_unweighted)) return ", as if each ray counted in full, not by its weight";
    if (is_extra(left_out)) return ", as if rays that hit nothing were left out";
    if (is_extra(unweighted)) return ", as if rays that hit nothing counted in full, not by their weight";
    return "";
}

}  // namespace

std::optional<TraceDifference> first_difference(const ordered_json& mine, const ordered_json& theirs) {
    const ordered_json &a = mine["rays"], &b = theirs["rays"];
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (auto difference = difference_of_ways(b, a[i], b[i], i)) return difference;
        if (auto difference = difference_of_lights(a[i], b[i], i)) return difference;
    }
    if (a.size() != b.size())
        return TraceDifference{std::min(a.size(), b.size()),
                               "number of rays",
                               std::to_string(a.size()),
                               std::to_string(b.size()),
                               {"07.2", "07.3", "07.4", "07.5"}};
    if (!same(mine["color"], theirs["color"]))
        return TraceDifference{0,
                               colour_of_pixel,
                               text(mine["color"]) + how_summed(mine),
                               text(theirs["color"]),
                               {"01.6", "07.6", "05.5", "06", "12/distributed.cpp"}};
    return std::nullopt;
}

std::optional<std::string> step_to_look_at(const TraceDifference& difference,
                                           std::span<const WrongStep> wrong) {
    for (const std::string& maker : difference.makers)
        for (const WrongStep& step : wrong) {
            const std::string chapter = step.id.substr(0, 2);
            if (maker == step.id || maker == chapter || maker == chapter + "/" + step.file) return step.id;
        }
    return std::nullopt;
}

std::string in_words(const TraceDifference& difference) {
    if (difference.quantity == what_is_hit)
        return fmt::format("your ray hits {}, expected {}", difference.mine, difference.theirs);
    return fmt::format("your {} is {}, expected {}", difference.quantity, difference.mine, difference.theirs);
}

}  // namespace rt
