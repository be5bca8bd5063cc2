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

Scene scene_of(const TraceCommand& command) {
    Scene scene = read_scene(command.scene, command.lenient);
    if (!command.size.empty()) set_size(scene, command.size);
    return scene;
}

ordered_json tree_of(const TraceCommand& command) {
    const Scene scene = scene_of(command);
    ordered_json tree = ray_tree(scene, command.x, command.y);
    tree["scene"] = command.scene.string();
    return tree;
}

/// The trees of more pixels than one, which nobody reads.
void print_trees(const TraceCommand& command) {
    const Scene scene = scene_of(command);
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

void print_comparison(const std::optional<TraceDifference>& difference, const ordered_json& mine,
                      const ordered_json& theirs, const std::string& what_to_do) {
    if (!difference) {
        print_tree(theirs);
        fmt::print("{}\n", paint("The two trees are the same.", Tone::Good));
        return;
    }
    // Equal trees may still be summed up to different colours.
    const bool all = difference->quantity == colour_of_pixel;
    print_both(mine["rays"], theirs["rays"], all ? theirs["rays"].size() : difference->ray);
    fmt::print("{} {}: yours is {}, the solution's {}.\n{}\n", paint("First difference:", Tone::Bad),
               difference->quantity, difference->mine, difference->theirs, what_to_do);
}

int run_against(const TraceCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const OwnCode own = own_code(project, chapters);
    const ordered_json theirs = tree_of(command);
    const ordered_json mine =
        is_empty(own) ? theirs
                      : student_trees(project, own, {command.scene, command.lenient, command.size},
                                      {{command.x, command.y}})
                            .front();
    const std::optional<TraceDifference> difference = first_difference(mine, theirs);
    const std::vector<WrongStep> wrong =
        difference ? wrong_steps(project, chapters) : std::vector<WrongStep>();
    if (command.json) {
        ordered_json object = {{"same", !difference}, {"mine", mine}, {"solution", theirs}};
        if (difference)
            object["difference"] = {{"ray", difference->ray},
                                    {"quantity", difference->quantity},
                                    {"mine", difference->mine},
                                    {"solution", difference->theirs},
                                    {"step", step_to_look_at(*difference, wrong).value_or("")}};
        fmt::print("{}\n", json_text(object));
    } else {
        print_comparison(difference, mine, theirs, difference ? advice(*difference, wrong) : "");
        flush_output();
        say(is_empty(own) ? "nothing of yours is begun: both are the solutions'"
                          : fmt::format("your code for {}, solutions for the rest", in_words(own)));
    }
    return difference ? 1 : 0;
}

/// Goes on with the student's code, as far as it is begun.
void use_mine(const TraceCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const OwnCode own = own_code(project, chapters);
    if (is_empty(own)) say("nothing of yours is begun: this is the solutions' tree");
    become_mine(project, own, command.arguments);
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
    if (command.mine && !linked_chapters()) use_mine(command);
    become_mine_in_handout(command.arguments);
    if (!command.also.empty()) {
        print_trees(command);
        return 0;
    }
    const ordered_json tree = tree_of(command);
    if (command.json) {
        fmt::print("{}\n", json_text(tree));
        return 0;
    }
    print_tree(tree);
    flush_output();
    if (command.mine && linked_chapters()) say(whose_code());
    return 0;
}

}  // namespace rt
