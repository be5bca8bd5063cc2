// `course`: the chapters, how far they are, and the one next action.
#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/result_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

namespace {

/// "●●●○◇": one mark a step; a diamond is one that may be left out.
std::string bar(const ChapterResult& result) {
    std::string marks;
    for (const StepResult& step : result.steps)
        marks += step.state == State::Passed   ? paint("●", Tone::Good)
                 : step.state == State::Failed ? paint("✗", Tone::Bad)
                                               : paint(step.optional ? "◇" : "○", Tone::Dim);
    return marks;
}

void print(const std::vector<Chapter>& chapters, const std::vector<KnownResult>& known) {
    int passed = 0, total = 0;
    for (const KnownResult& result : known) {
        const StepsDone done = steps_done(result.result);
        passed += done.passed;
        total += done.all;
    }
    fmt::print("{}  {} of {}\n\n", paint("Ray tracing, chapter by chapter", Tone::Bold), passed,
               counted(total, "step"));
    std::size_t width = 0;
    for (const Chapter& chapter : chapters) width = std::max(width, chapter.title.size());
    for (std::size_t i = 0; i < chapters.size(); ++i)
        fmt::print("  {}  {:<{}}  {}{}\n", chapters[i].number, chapters[i].title, width, bar(known[i].result),
                   known[i].current ? "" : paint("  changed since it was checked", Tone::Dim));
}

}  // namespace

int run_status(bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const std::vector<KnownResult> known = known_results(project, chapters);
    if (chapters.empty()) {
        say("there are no chapters yet");
        return 0;
    }
    const std::string next = next_action(project, chapters, known);
    if (json) {
        auto object = results_json(chapters, results_of(known));
        object["next"] = next;
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    print(chapters, known);
    fmt::print("\n{} {}\n", paint("Next:", Tone::Bold), next);
    return 0;
}

}  // namespace rt
