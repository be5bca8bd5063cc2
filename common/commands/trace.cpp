// `course trace`: the ray tree of one pixel, and where a student's tree first differs from the solution's.
#include "common/commands/commands.hpp"
#include "common/commands/mine.hpp"
#include "common/math/input_error.hpp"
#include "common/pictures/ray_tree.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/pictures/tree_difference.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

namespace rt {

using nlohmann::ordered_json;

namespace {

ordered_json tree_of(const TraceCommand& command) {
    Scene scene = read_scene(command.scene, command.lenient);
    if (!command.size.empty()) set_size(scene, command.size);
    ordered_json tree = ray_tree(scene, command.x, command.y);
    tree["scene"] = command.scene.string();
    return tree;
}

/// The last line of what a program said: before it may stand what the student's code prints.
std::string last_line(const std::string& output) {
    const std::vector<std::string> lines = split_lines(output);
    return lines.empty() ? "" : lines.back();
}

/// The tree that the student's code makes of the same pixel, from a process of its own.
ordered_json student_trace(const Project& project, const OwnCode& own, const TraceCommand& command) {
    const BuildResult build = build_mine(project, own);
    if (!build.ok) throw InputError("your chapters do not build: " + build.message);
    ProcessOptions options;
    options.time_limit = 60;
    options.merge_errors = false;
    options.environment = {{mine_variable, in_words(own)}};
    options.output_limit = std::size_t{256} << 20;
    std::vector<std::string> line{program(project, "course_mine").string(),
                                  "trace",
                                  command.scene.string(),
                                  std::to_string(command.x),
                                  std::to_string(command.y),
                                  "--json"};
    if (command.lenient) line.push_back("--lenient");
    if (!command.size.empty()) line.insert(line.end(), {"--size", command.size});
    const ProcessResult result = run_process(line, options);
    if (!succeeded(result))
        throw InputError(result.timed_out     ? "your code takes more than a minute for this pixel"
                         : result.signal != 0 ? "your code crashed: " + signal_name(result.signal)
                                              : std::string("your code made no tree of this pixel"));
    ordered_json tree = read_ordered_json(last_line(result.output));
    if (tree.is_discarded())
        throw InputError("the tree that your code makes of this pixel is too large to compare");
    return tree;
}

/// The student's steps that fail their tests, those that changed checked again.
std::vector<WrongStep> wrong_steps(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<WrongStep> wrong;
    const std::vector<ChapterResult> results = checked_results(project, chapters);
    for (std::size_t i = 0; i < chapters.size(); ++i)
        for (const StepResult& step : results[i].steps)
            if (step.state == State::Failed) wrong.push_back({step.id, step_of(chapters[i], step.id).file});
    return wrong;
}

/// What to do about a difference.
std::string advice(const TraceDifference& difference, const std::vector<WrongStep>& wrong) {
    if (const auto step = step_to_look_at(difference, wrong))
        return fmt::format("Look at step {}: ./course hint {}", *step, *step);
    if (wrong.empty())
        return "All that you have written passes its tests, which should have noticed this: please report "
               "it.";
    std::string ids;
    for (const WrongStep& step : wrong) ids += (ids.empty() ? "" : ", ") + step.id;
    return "The steps that work this out pass their tests. Those that do not: " + ids;
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
    const ordered_json mine = is_empty(own) ? theirs : student_trace(project, own, command);
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
