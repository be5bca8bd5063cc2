// Program `leave_out`: what a scene does not need costs nothing, counted in instructions, rays and bytes.
//   leave_out [--json]                    the table; needs valgrind
//   leave_out draw [WHICH FEATURE]        draws everything once, or one picture: what valgrind is shown;
//                                         WHICH is general, minimal or with
#include "common/render/compile.hpp"
#include "common/render/explain.hpp"
#include "common/render/integrators.hpp"
#include "common/render/sampled.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"
#include "tests/leave_out/cases.hpp"

#include <fmt/core.h>
#include <tbb/task_arena.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

/// The part of the program that is counted. Its name is the one that valgrind is told.
extern "C" [[gnu::noinline]] void leave_out_draw(const rt::World& world, rt::RayColor color,
                                                 std::vector<rt::Vec3>& colors) {
    if (!world.needs.samples) {
        colors = rt::render_tile(world, {0, 0, world.view.width, world.view.height}, color);
        return;
    }
    rt::RenderResult result;
    tbb::task_arena(1).execute([&] { rt::render_sampled(world, {}, result); });
    colors = std::move(result.image.pixels);
    rt::ray_counts() = result.rays;
}

namespace rt::test {
namespace {

namespace fs = std::filesystem;

/// A picture, drawn on this thread alone.
struct Drawing {
    std::vector<Vec3> colors;
    RayCounts rays;
    std::size_t bytes = 0;  ///< of the World; 0 for a minimal renderer
};

Drawing draw(const World& world, RayColor color) {
    Drawing drawing;
    ray_counts() = {.camera = static_cast<std::uint64_t>(world.view.width * world.view.height)};
    leave_out_draw(world, color, drawing.colors);
    drawing.rays = ray_counts();
    return drawing;
}

Scene read(const std::string& text, const std::string& name) {
    return parse_scene_text(text, name, this_project().root / "tests" / "leave_out");
}

Drawing draw_general(const std::string& text, const std::string& name) {
    const Scene scene = read(text, name);
    const World world = compile(scene);
    Drawing drawing = draw(world, color_function(world));
    drawing.bytes = explain(scene, world).bytes;
    return drawing;
}

Drawing draw_minimal(const Case& one) {
    if (one.given_world) return draw(compile(read(one.scene, one.feature)), one.minimal);
    World world;
    world.view = view();
    return draw(world, one.minimal);
}

/// What is measured of one case. Counts of instructions are of whole pictures.
struct Row {
    std::string feature;
    Drawing general, minimal, with_feature;
    std::uint64_t general_instructions = 0, minimal_instructions = 0, with_instructions = 0;
    std::size_t minimal_bytes = 0;
    bool judged = true;
};

std::uint64_t total(const RayCounts& rays) {
    return rays.camera + rays.shadow + rays.reflection + rays.refraction;
}

/// The rule: at most 1.01 times the instructions, or 8 more a ray, whichever is more.
std::uint64_t limit(const Row& row) {
    return row.minimal_instructions + std::max(row.minimal_instructions / 100, 8 * total(row.minimal.rays));
}

/// The instructions that each picture took, in the order in which `draw_all` draws them.
std::vector<std::uint64_t> count_instructions() {
    const fs::path directory = this_project().build / "leave_out";
    fs::remove_all(directory);
    fs::create_directories(directory);
    const std::string out = (directory / "counts").string();
    // Each return from the function writes a file of its own, numbered from 1, and starts again from 0.
    const ProcessResult result =
        run_process({"valgrind", "--tool=callgrind", "--collect-atstart=no",
                     "--toggle-collect=leave_out_draw", "--dump-after=leave_out_draw",
                     "--callgrind-out-file=" + out, fs::read_symlink("/proc/self/exe").string(), "draw"});
    if (!succeeded(result)) throw std::runtime_error("valgrind failed:\n" + result.output);
    std::vector<std::uint64_t> counts;
    for (int i = 1; fs::exists(out + "." + std::to_string(i)); ++i) {
        std::ifstream file(out + "." + std::to_string(i));
        const std::string key = "totals: ";
        for (std::string line; std::getline(file, line);)
            if (line.starts_with(key)) counts.push_back(std::stoull(line.substr(key.size())));
    }
    fs::remove_all(directory);
    return counts;
}

void draw_all(const std::string& which, const std::string& feature) {
    for (const Case& one : cases()) {
        if (!feature.empty() && one.feature != feature) continue;
        if (which.empty() || which == "general") draw_general(one.scene, one.feature);
        if (which.empty() || which == "minimal") draw_minimal(one);
        if (which.empty() || which == "with") draw_general(one.with_feature, one.feature);
    }
}

std::vector<Row> measure() {
    const std::vector<std::uint64_t> counts = count_instructions();
    const std::vector<Case> all = cases();
    if (counts.size() != 3 * all.size()) throw std::runtime_error("valgrind did not count every picture");
    std::vector<Row> rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Case& one = all[i];
        rows.push_back({one.feature, draw_general(one.scene, one.feature), draw_minimal(one),
                        draw_general(one.with_feature, one.feature), counts[3 * i], counts[3 * i + 1],
                        counts[3 * i + 2], one.bytes, one.judged});
    }
    return rows;
}

nlohmann::ordered_json to_json(const RayCounts& rays) {
    return {{"camera", rays.camera},
            {"shadow", rays.shadow},
            {"reflection", rays.reflection},
            {"refraction", rays.refraction}};
}

nlohmann::ordered_json to_json(const Row& row) {
    return {{"feature", row.feature},
            {"instructions",
             {{"general", row.general_instructions},
              {"minimal", row.minimal_instructions},
              {"limit", limit(row)},
              {"with_feature", row.with_instructions}}},
            {"rays",
             {{"general", to_json(row.general.rays)},
              {"minimal", to_json(row.minimal.rays)},
              {"with_feature", to_json(row.with_feature.rays)}}},
            {"bytes",
             {{"general", row.general.bytes},
              {"minimal", row.minimal_bytes},
              {"with_feature", row.with_feature.bytes}}},
            {"same_picture", row.general.colors == row.minimal.colors},
            {"judged", row.judged}};
}

std::string in_words(const RayCounts& rays) {
    return fmt::format("{}+{}+{}+{}", rays.camera, rays.shadow, rays.reflection, rays.refraction);
}

void print(const std::vector<Row>& rows) {
    fmt::print(
        "Instructions a ray: of the general renderer, of one written for just the scene, the quotient, the\n"
        "difference, and how great that may be (1 % or 8, whichever is more). 'With it': how many times the\n"
        "instructions are where the scene has the feature. Rays: camera+shadow+reflection+refraction.\n\n");
    fmt::print("{:<28} {:>7} {:>7} {:>6} {:>5} {:>7} {:>7}  {:<19} {:>5} {:>7}\n", "a scene without",
               "general", "minimal", "ratio", "more", "allowed", "with it", "rays", "bytes", "with it");
    for (const Row& row : rows) {
        const auto rays = static_cast<double>(total(row.minimal.rays));
        const auto general = static_cast<double>(row.general_instructions);
        const auto minimal = static_cast<double>(row.minimal_instructions);
        fmt::print("{:<28} {:>7.1f} {:>7.1f} {:>6.4f} {:>5.1f} {:>7.1f} {:>6.2f}x  {:<19} {:>5} {:>7}\n",
                   row.feature + (row.judged ? "" : " *"), general / rays, minimal / rays, general / minimal,
                   (general - minimal) / rays,
                   static_cast<double>(limit(row) - row.minimal_instructions) / rays,
                   static_cast<double>(row.with_instructions) / general, in_words(row.general.rays),
                   row.general.bytes, row.with_feature.bytes);
    }
    fmt::print(
        "\n* shown, not demanded: Whitted's tree of rays is chapter 7's, and keeps lists of media on a "
        "stack;\n"
        "  the minimal renderer recurses and knows that no glass is inside another.\n");
}

int run(const std::vector<std::string>& arguments) {
    if (!arguments.empty() && arguments[0] == "draw") {
        draw_all(arguments.size() > 1 ? arguments[1] : "", arguments.size() > 2 ? arguments[2] : "");
        return 0;
    }
    const bool json = arguments == std::vector<std::string>{"--json"};
    if (!json && !arguments.empty()) {
        fmt::print(stderr, "leave_out: expected nothing, --json, or draw [general|minimal|with FEATURE]\n");
        return 1;
    }
    if (run_process({"valgrind", "--version"}).exit_code != 0) {
        fmt::print(stderr,
                   "leave_out: skipped: it counts instructions with valgrind, which is not installed\n");
        return 2;
    }
    const std::vector<Row> rows = measure();
    if (json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const Row& row : rows) list.push_back(to_json(row));
        fmt::print("{}\n", nlohmann::ordered_json{{"cases", list}}.dump());
    } else {
        print(rows);
    }
    return 0;
}

}  // namespace
}  // namespace rt::test

int main(int argc, char** argv) {
    try {
        return rt::test::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        fmt::print(stderr, "leave_out: {}\n", error.what());
        return 1;
    }
}
