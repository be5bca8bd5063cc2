// How results are shown: a line a step, one next action, and the same as JSON.
#include "common/workbook/result_text.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/solutions.hpp"
#include "common/workbook/warnings.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// A test's failure may come with pages of values; the first lines are what a person reads.
constexpr std::size_t most_detail_lines = 14;

std::string file_of(const Chapter& chapter, const std::string& step) {
    return fmt::format("chapters/{}/{}", chapter.name, step_of(chapter, step).file);
}

/// The test whose name a failure begins with, or, after a crash, ends its first line with in quotes.
std::string test_named_in(const std::string& message) {
    const std::string first = message.substr(0, message.find('\n')), in_test = " in the test \"";
    const auto quoted = first.find(in_test);
    if (quoted == std::string::npos || !first.ends_with('"')) return first;
    const std::size_t begin = quoted + in_test.size();
    return first.substr(begin, first.size() - 1 - begin);
}

/// What of a chapter that is complete can be done beyond that: "; or first step 05.6, which is optional".
std::string optional_left(const ChapterResult& result) {
    std::vector<std::string> left;
    for (const StepResult& step : result.steps)
        if (step.optional && step.state != State::Passed) left.push_back(step.id);
    if (left.empty()) return "";
    const bool one = left.size() == 1;
    return fmt::format("; or first step{} {}, which {} optional", one ? "" : "s", fmt::join(left, " and "),
                       one ? "is" : "are");
}

bool is_begun(const ChapterResult& result) {
    return std::ranges::any_of(result.steps, [](const StepResult& step) {
        return step.state != State::Todo || step.message.starts_with("begun");
    });
}

/// What is left to do when nothing is.
std::string after_the_last(const Project& project, const std::vector<KnownResult>& results) {
    std::vector<std::string> challenges;
    for (const KnownResult& known : results)
        for (const StepResult& step : known.result.steps)
            if (step.optional && step.state != State::Passed) challenges.push_back(step.id);
    std::string text =
        "every step has passed. Draw a scene of your own: common/scene/README.md says how, ./course "
        "render mine.scene --preview shows it. The lessons end with challenges";
    text += challenges.empty() ? "." : fmt::format("; {} can be checked.", fmt::join(challenges, ", "));
    if (has_solutions(project))
        text +=
            " The gallery of all that you can draw is ./course tour, and ./course solution shows how others "
            "write a step.";
    return text;
}

}  // namespace

std::string step_line(const Step& step, const StepResult& result) {
    const std::string mark = result.state == State::Passed   ? paint("✓", Tone::Good)
                             : result.state == State::Failed ? paint("✗", Tone::Bad)
                                                             : paint("○", Tone::Dim);
    std::string line = fmt::format("  {} {}  {:<44} {:>3} points{}", mark, step.id, step.title, step.points,
                                   step.optional ? ", optional" : "");
    if (result.state == State::Todo && !result.message.empty())
        line += paint("   " + result.message, Tone::Dim);
    if (!result.because.empty()) line += paint("   perhaps because of " + result.because, Tone::Dim);
    return line;
}

std::string details(const StepResult& result) {
    if (result.state != State::Failed) return "";
    std::string text;
    const std::vector<std::string> lines = split_lines(result.message);
    for (std::size_t i = 0; i < std::min(lines.size(), most_detail_lines); ++i)
        text += "      " + (i == 0 ? paint(lines[i], Tone::Bad) : "  " + lines[i]) + "\n";
    if (lines.size() > most_detail_lines)
        text += fmt::format("        … and {}\n", counted(lines.size() - most_detail_lines, "more line"));
    return text;
}

std::string notes(const ChapterResult& result) {
    std::string failed;
    for (const StepResult& step : result.steps)
        if (failed.empty() && step.state == State::Failed) failed = test_named_in(step.message);
    return printed_in_words(result.printed, failed) + warnings_in_words(result.warnings);
}

std::string next_action(const Chapter& chapter, const ChapterResult& result) {
    const std::string check = "./course check " + chapter.number;
    // The file may be an earlier chapter's: in a handout nothing else takes its place.
    constexpr std::string_view command = "./course reset ";
    if (const auto reset = result.build_error.find(command); reset != std::string::npos)
        return result.build_error.substr(reset, result.build_error.find(' ', reset + command.size()) - reset);
    if (!result.build_error.empty()) return "mend the compile error, then " + check;
    for (const StepResult& step : result.steps)
        if (step.state == State::Failed && step.because.empty())
            return fmt::format("mend step {} in {}, then {}   (stuck? ./course hint {})", step.id,
                               file_of(chapter, step.id), check, step.id);
    // What is left of failures may follow from an earlier chapter's.
    for (const StepResult& step : result.steps)
        if (step.state == State::Failed)
            return fmt::format("./course check {} shows what is wrong with step {}, which step {} uses",
                               step.because, step.because, step.id);
    for (std::size_t i = 0; i < result.steps.size(); ++i) {
        const StepResult& step = result.steps[i];
        // What only waits for another step may be finished already.
        if (step.state != State::Todo || step.message.starts_with("waits for")) continue;
        if (step.optional && result.steps.size() > 1) continue;
        const std::string lesson = i == 0 ? fmt::format("read chapters/{}/README.md and ", chapter.name) : "";
        return fmt::format("{}write step {} in {}, then {}   (stuck? ./course hint {})", lesson, step.id,
                           file_of(chapter, step.id), check, step.id);
    }
    return check;
}

std::string next_action(const Project& project, const std::vector<Chapter>& chapters,
                        const std::vector<KnownResult>& results) {
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        if (all_passed(results[i].result) && results[i].current) continue;
        if (!results[i].current) return fmt::format("./course check {}", chapters[i].number);
        const bool at_beginning = i > 0 && !is_begun(results[i].result);
        return next_action(chapters[i], results[i].result) +
               (at_beginning ? optional_left(results[i - 1].result) : "");
    }
    return after_the_last(project, results);
}

nlohmann::ordered_json results_json(const std::vector<Chapter>& chapters,
                                    const std::vector<ChapterResult>& results) {
    auto list = nlohmann::ordered_json::array();
    for (const ChapterResult& result : results) {
        const Chapter& chapter = find_chapter(chapters, result.chapter);
        auto steps = nlohmann::ordered_json::array();
        for (const StepResult& step : result.steps) {
            const Step& described = step_of(chapter, step.id);
            steps.push_back({{"id", step.id},
                             {"title", described.title},
                             {"points", described.points},
                             {"state", name_of(step.state)},
                             {"message", step.message}});
            if (described.optional) steps.back()["optional"] = true;
        }
        list.push_back(
            {{"id", chapter.name}, {"title", chapter.title}, {"hours", chapter.hours}, {"steps", steps}});
    }
    return {{"chapters", list}};
}

}  // namespace rt
