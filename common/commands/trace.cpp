// `course trace`: the ray tree of one pixel, and where a student's tree first differs from the solution's.
#include "common/commands/commands.hpp"
#include "common/commands/mine.hpp"
#include "common/commands/student_trees.hpp"
#include "common/math/input_error.hpp"
#include "common/pictures/ray_tree.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/pictures/tree_difference.hpp"
#include "common/render/compile.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

#include <sstream>

namespace rt {

using nlohmann::ordered_json;

namespace {

ordered_json tree_of(const TraceCommand& command) {
    ordered_json tree = ray_tree(read_scene(command.scene, command.lenient), command.x, command.y);
    tree["scene"] = command.scene.string();
    return tree;
}

/// The trees of more pixels than one, which nobody reads.
void print_trees(const TraceCommand& command) {
    const Scene scene = read_scene(command.scene, command.lenient);
    const World world = compile(scene);
    auto trees = ordered_json::array();
    trees.push_back(ray_tree(scene, world, command.x, command.y));
    std::istringstream in(command.also);
    char comma = 0;
    for (int x = 0, y = 0; in >> x >> comma >> y;) trees.push_back(ray_tree(scene, world, x, y));
    fmt::print("{}\n", json_text(ordered_json{{"trees", trees}}));
}

/// The rays in which both agree are told once, the first in which they do not, by both.
void print_both(const ordered_json& mine, const ordered_json& theirs, std::size_t equal) {
    if (equal > 0) fmt::print("{}\n", paint("both", Tone::Accent));
    for (std::size_t i = 0; i < equal; ++i) print_ray(theirs, i);
    if (equal < mine.size()) fmt::print("{}\n", paint("yours", Tone::Accent)), print_ray(mine, equal);
    if (equal < theirs.size()) fmt::print("{}\n", paint("solution", Tone::Accent)), print_ray(theirs, equal);
}

int run_against(const TraceCommand& command) {
    const ordered_json theirs = tree_of(command);
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const ordered_json mine = student_trees(project, pointers_to(chapters), command.scene, command.lenient,
                                            {{command.x, command.y}})
                                  .front();
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
        require_solutions(this_project(), "./course trace --against solutions");
        return run_against(command);
    }
    become_mine_in_handout(command.arguments);
    if (!command.also.empty()) {
        print_trees(command);
        return 0;
    }
    const ordered_json tree = tree_of(command);
    if (command.json)
        fmt::print("{}\n", json_text(tree));
    else
        print_tree(tree);
    return 0;
}

}  // namespace rt
