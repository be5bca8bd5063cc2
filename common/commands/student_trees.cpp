// The ray trees of a scene's pixels, as the student's code makes them.
#include "common/commands/student_trees.hpp"

#include "common/math/input_error.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// The last line of what a program said: before it may stand what the student's code prints.
std::string last_line(const std::string& output) {
    const std::vector<std::string> lines = split_lines(output);
    return lines.empty() ? "" : lines.back();
}

}  // namespace

std::vector<ordered_json> student_trees(const Project& project, const OwnCode& own, const TracedScene& traced,
                                        const std::vector<std::pair<int, int>>& pixels) {
    const BuildResult build = build_mine(project, own);
    if (!build.ok) throw InputError("your chapters do not build: " + build.message);
    ProcessOptions options;
    options.time_limit = 60;
    options.merge_errors = false;
    options.environment = {{mine_variable, in_words(own)}};
    options.output_limit = std::size_t{256} << 20;
    std::string also;
    for (std::size_t i = 1; i < pixels.size(); ++i)
        also += fmt::format("{}{},{}", i > 1 ? " " : "", pixels[i].first, pixels[i].second);
    std::vector<std::string> line{program(project, "course_mine").string(),
                                  "trace",
                                  traced.scene.string(),
                                  std::to_string(pixels.front().first),
                                  std::to_string(pixels.front().second),
                                  "--json"};
    if (traced.lenient) line.push_back("--lenient");
    if (!traced.size.empty()) line.insert(line.end(), {"--size", traced.size});
    if (!also.empty()) line.insert(line.end(), {"--also", also});
    const ProcessResult result = run_process(line, options);
    const std::string what = pixels.size() == 1 ? "this pixel" : "these pixels";
    if (!succeeded(result))
        throw InputError(result.timed_out     ? "your code takes more than a minute for " + what
                         : result.signal != 0 ? "your code crashed: " + signal_name(result.signal)
                                              : "your code made no tree of " + what);
    const ordered_json told = read_ordered_json(last_line(result.output));
    if (told.is_discarded())
        throw InputError(fmt::format("the tree that your code makes of {} is too large to compare", what));
    if (also.empty()) return {told};
    return told["trees"].get<std::vector<ordered_json>>();
}

std::vector<WrongStep> wrong_steps(const Chapter& chapter, const ChapterResult& result) {
    std::vector<WrongStep> wrong;
    for (const StepResult& step : result.steps)
        if (step.state == State::Failed) wrong.push_back({step.id, step_of(chapter, step.id).file});
    return wrong;
}

std::vector<WrongStep> wrong_steps(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<WrongStep> wrong;
    const std::vector<ChapterResult> results = checked_results(project, chapters);
    for (std::size_t i = 0; i < chapters.size(); ++i)
        for (const WrongStep& step : wrong_steps(chapters[i], results[i])) wrong.push_back(step);
    return wrong;
}

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

}  // namespace rt
