// `course trace`: the ray tree of one pixel, and where a student's tree first differs from the solution's.
#include "common/render/trace.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "common/commands/commands.hpp"
#include "common/math/input_error.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/pictures/tree_difference.hpp"
#include "common/render/compile.hpp"
#include "common/render/shade.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// A tree may have any number of rays: 2^depth between two panes of glass. So many are written down.
constexpr std::size_t most_rays = 10'000;
/// Deeper rays are indented no farther, else a tree's text would grow with the square of its depth.
constexpr std::size_t most_levels = 16;

constexpr const char* colour_of_pixel = "colour of the pixel";

// What a shape of a file is called: as in a world, if it stands there as it is.
template <class Shape>
std::string_view shape_name(const Shape&) {
    return words<Shape>.one;
}
std::string_view shape_name(const TriangleObject&) { return words<Triangle>.one; }
std::string_view shape_name(const PolygonObject&) { return words<Polygon>.one; }
std::string_view shape_name(const MeshObject&) { return "mesh"; }

std::string_view kind_name(RayKind kind) {
    if (kind == RayKind::Reflection) return "reflection";
    return kind == RayKind::Refraction ? "refraction" : "camera";
}

// ------------------------------------------------------------------------------------- tree to JSON

ordered_json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

/// A number, or "infinity", which JSON has no number for.
ordered_json to_json(Real x) { return std::isinf(x) ? ordered_json("infinity") : ordered_json(x); }

ordered_json to_json(const LightRecord& light) {
    return {{"direction", to_json(light.sample.direction)},
            {"distance", to_json(light.sample.distance)},
            {"color", to_json(light.sample.color)},
            {"visible", to_json(light.visible)},
            {"contribution", to_json(light.contribution)}};
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
        const Object& object = scene.objects[object_of(world, record.hit->primitive)];
        json["shape"] = std::visit([](const auto& shape) { return shape_name(shape); }, object.shape);
        json["line"] = object.place.line;
        json["primitive"] = record.hit->primitive;
        json["t"] = to_json(record.hit->t);
        json["point"] = to_json(record.surface.point);
        json["normal"] = to_json(record.normal);
        json["arriving_weight"] = to_json(record.weight);
        json["lights"] = ordered_json::array();
        for (const LightRecord& light : record.lights) json["lights"].push_back(to_json(light));
    }
    json["local"] = to_json(record.local);
    return json;
}

ordered_json trace_json(const TraceCommand& command) {
    Scene scene = read_scene(command.scene, command.lenient);
    if (command.x < 0 || command.y < 0 || command.x >= scene.width || command.y >= scene.height)
        throw InputError(fmt::format("pixel ({}, {}) is outside the picture of {} × {}", command.x, command.y,
                                     scene.width, scene.height));
    const World world = compile(scene);
    const Ray ray = pixel_ray(world.view, command.x + 0.5, command.y + 0.5);
    ordered_json rays = ordered_json::array();
    Vec3 color(0);
    std::vector<TraceRecord> tree = trace_tree(world, ray, most_rays + 1);
    const bool complete = tree.size() <= most_rays;
    if (!complete) tree.pop_back();
    for (const TraceRecord& record : tree) {
        color += record.weight * record.local;
        rays.push_back(to_json(scene, world, record));
    }
    return {{"scene", command.scene.string()},
            {"x", command.x},
            {"y", command.y},
            {"color", to_json(color_function(world)(world, ray))},
            {"tree_color", to_json(color)},
            {"complete", complete},
            {"rays", rays}};
}

// ------------------------------------------------------------------------------------- JSON to text

std::string number(const ordered_json& x) {
    return x.is_string() ? x.get<std::string>() : fmt::format("{:.6g}", x.get<Real>());
}
std::string triple(const ordered_json& v) {
    return fmt::format("({}, {}, {})", number(v[0]), number(v[1]), number(v[2]));
}

void print_ray(const ordered_json& rays, std::size_t index) {
    const ordered_json& ray = rays[index];
    const std::size_t depth = ray["depth"].get<std::size_t>();
    const std::string indent(4 * std::min(depth, most_levels), ' ');
    fmt::print("{}{}{}  weight {}\n", indent,
               paint(fmt::format("{} ray", ray["kind"].get<std::string>()), Tone::Bold),
               depth > most_levels ? fmt::format(" of depth {}", depth) : "", triple(ray["weight"]));
    fmt::print("{}  from {} towards {}\n", indent, triple(ray["origin"]), triple(ray["direction"]));
    if (!ray["hit"].get<bool>()) {
        fmt::print("{}  hits nothing: background {}\n", indent, triple(ray["local"]));
        return;
    }
    fmt::print("{}  hits the {} of line {} at t = {}, point {}, normal {}\n", indent,
               ray["shape"].get<std::string>(), ray["line"].get<int>(), number(ray["t"]),
               triple(ray["point"]), triple(ray["normal"]));
    if (ray["arriving_weight"] != ray["weight"])
        fmt::print("{}  weight after absorption {}\n", indent, triple(ray["arriving_weight"]));
    for (const ordered_json& light : ray["lights"])
        fmt::print("{}  light at distance {}, {} arriving, {} of it visible: adds {}\n", indent,
                   number(light["distance"]), triple(light["color"]), triple(light["visible"]),
                   triple(light["contribution"]));
    fmt::print("{}  radiance here {}\n", indent, triple(ray["local"]));
}

void print_tree(const ordered_json& tree) {
    fmt::print("pixel ({}, {}) of {}: colour {}\n", tree["x"].get<int>(), tree["y"].get<int>(),
               tree["scene"].get<std::string>(), triple(tree["color"]));
    for (std::size_t i = 0; i < tree["rays"].size(); ++i) print_ray(tree["rays"], i);
    if (!tree["complete"].get<bool>())
        fmt::print("The tree goes on: these are its first {} rays.\n", tree["rays"].size());
}

// ------------------------------------------------------------------------------------- two trees

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
    if (quantity == "hit" || quantity == "primitive" || quantity == "t" || quantity == "line" ||
        quantity == "shape")
        return shape == "sphere" ? "02.3" : triangle ? "03.4" : shape == "polygon" ? "03.2" : "01.4";
    if (quantity == "point" || quantity == "normal")
        return shape == "sphere" ? "02.4" : triangle ? "03.5" : "01.4";
    return "05.5";
}
std::string step_of_light(const std::string& quantity) {
    if (quantity == "visible") return "06.3";
    return quantity == "contribution" ? "05.5" : "05.1";
}

std::string text(const ordered_json& value) {
    return value.is_array() && value.size() == 3 ? triple(value)
           : value.is_number_float()             ? number(value)
                                                 : value.dump();
}

}  // namespace

std::optional<TraceDifference> first_difference(const ordered_json& mine, const ordered_json& theirs) {
    const ordered_json &a = mine["rays"], &b = theirs["rays"];
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        for (const char* quantity : {"kind", "parent", "origin", "direction", "weight", "hit", "primitive",
                                     "t", "point", "normal", "arriving_weight"}) {
            const ordered_json p = a[i].value(quantity, ordered_json()),
                               q = b[i].value(quantity, ordered_json());
            if (same(p, q)) continue;
            const ordered_json& known = b[i]["hit"].get<bool>() ? b[i] : a[i];
            return TraceDifference{i, quantity, text(p), text(q), step_of(quantity, known)};
        }
        const ordered_json lights = a[i].value("lights", ordered_json::array());
        const ordered_json other = b[i].value("lights", ordered_json::array());
        for (std::size_t k = 0; k < std::min(lights.size(), other.size()); ++k)
            for (const char* quantity : {"direction", "distance", "color", "visible", "contribution"})
                if (!same(lights[k][quantity], other[k][quantity]))
                    return TraceDifference{i, fmt::format("light {}: {}", k + 1, quantity),
                                           text(lights[k][quantity]), text(other[k][quantity]),
                                           step_of_light(quantity)};
        if (lights.size() != other.size())
            return TraceDifference{i, "number of lights in front of the surface",
                                   std::to_string(lights.size()), std::to_string(other.size()), "05.1"};
        if (!same(a[i]["local"], b[i]["local"]))
            return TraceDifference{i, "radiance", text(a[i]["local"]), text(b[i]["local"]), "05.5"};
    }
    if (a.size() != b.size())
        return TraceDifference{std::min(a.size(), b.size()), "number of rays", std::to_string(a.size()),
                               std::to_string(b.size()), "07.5"};
    if (!same(mine["color"], theirs["color"]))
        return TraceDifference{0, colour_of_pixel, text(mine["color"]), text(theirs["color"]),
                               a.size() > 1 ? "07.6" : "01.6"};
    return std::nullopt;
}

namespace {

/// The tree that the student's chapters make of the same pixel, from a process of their own.
ordered_json student_trace(const Project& project, const TraceCommand& command) {
    std::vector<const Chapter*> mine;
    const std::vector<Chapter> chapters = read_catalogue(project);
    for (const Chapter& chapter : chapters) mine.push_back(&chapter);
    const BuildResult build = build_mine(project, mine);
    if (!build.ok) throw InputError("your chapters do not build: " + build.message);
    ProcessOptions options;
    options.time_limit = 60;
    options.merge_errors = false;
    options.environment = {{mine_variable, numbers_of(mine)}};
    options.output_limit = std::size_t{256} << 20;
    std::vector<std::string> line{program(project, "course_mine").string(),
                                  "trace",
                                  command.scene.string(),
                                  std::to_string(command.x),
                                  std::to_string(command.y),
                                  "--json"};
    if (command.lenient) line.push_back("--lenient");
    const ProcessResult result = run_process(line, options);
    if (!succeeded(result))
        throw InputError(result.timed_out     ? "your code takes more than a minute for this pixel"
                         : result.signal != 0 ? "your code crashed: " + signal_name(result.signal)
                                              : std::string("your code made no tree of this pixel"));
    ordered_json tree = ordered_json::parse(result.output, nullptr, false);
    if (tree.is_discarded())
        throw InputError("the tree that your code makes of this pixel is too large to compare");
    return tree;
}

/// The rays in which both agree are told once, the first in which they do not, by both.
void print_both(const ordered_json& mine, const ordered_json& theirs, std::size_t equal) {
    if (equal > 0) fmt::print("{}\n", paint("both", Tone::Accent));
    for (std::size_t i = 0; i < equal; ++i) print_ray(theirs, i);
    if (equal < mine.size()) fmt::print("{}\n", paint("yours", Tone::Accent)), print_ray(mine, equal);
    if (equal < theirs.size()) fmt::print("{}\n", paint("solution", Tone::Accent)), print_ray(theirs, equal);
}

int run_against(const TraceCommand& command) {
    const ordered_json theirs = trace_json(command);
    const ordered_json mine = student_trace(this_project(), command);
    const std::optional<TraceDifference> difference = first_difference(mine, theirs);
    if (command.json) {
        ordered_json object = {{"same", !difference}, {"mine", mine}, {"solution", theirs}};
        if (difference)
            object["difference"] = {{"ray", difference->ray},
                                    {"quantity", difference->quantity},
                                    {"mine", difference->mine},
                                    {"solution", difference->theirs},
                                    {"step", difference->step}};
        fmt::print("{}\n", json_text(object));
        return difference ? 1 : 0;
    }
    if (!difference) {
        print_tree(theirs);
        fmt::print("{}\n", paint("The two trees are the same.", Tone::Good));
        return 0;
    }
    // Equal trees may still be summed up to different colours.
    const bool all = difference->quantity == colour_of_pixel;
    print_both(mine["rays"], theirs["rays"], all ? theirs["rays"].size() : difference->ray);
    fmt::print("{} {}: yours is {}, the solution's {}.\nLook at step {}: ./course hint {}\n",
               paint("First difference:", Tone::Bad), difference->quantity, difference->mine,
               difference->theirs, difference->step, difference->step);
    return 1;
}

}  // namespace

int run_trace(const TraceCommand& command) {
    if (!command.against.empty()) {
        if (command.against != "solutions")
            throw InputError(
                fmt::format("--against: there is no '{}'; expected 'solutions'", command.against));
        return run_against(command);
    }
    const ordered_json tree = trace_json(command);
    if (command.json)
        fmt::print("{}\n", json_text(tree));
    else
        print_tree(tree);
    return 0;
}

}  // namespace rt
