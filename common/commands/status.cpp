// `course` and `course list`: the chapters, the steps, and the one next action.
#include "common/commands/commands.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/verdict.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

namespace {

struct Known {
    std::vector<Chapter> chapters;
    std::vector<KnownResult> results;
};

Known everything_known(const Project& project) {
    Known known{read_catalogue(project), {}};
    for (const Chapter& chapter : known.chapters) known.results.push_back(known_result(project, chapter));
    return known;
}

/// "●●●○○": one mark a step.
std::string bar(const ChapterResult& result) {
    std::string marks;
    for (const StepResult& step : result.steps)
        marks += step.state == State::Passed   ? paint("●", Tone::Good)
                 : step.state == State::Failed ? paint("✗", Tone::Bad)
                                               : paint("○", Tone::Dim);
    return marks;
}

nlohmann::ordered_json to_json(const Known& known) {
    std::vector<ChapterResult> results;
    for (const KnownResult& result : known.results) results.push_back(result.result);
    return verdicts_json(known.chapters, results);
}

}  // namespace

int run_status(bool json) {
    const Project project = this_project();
    const Known known = everything_known(project);
    if (known.chapters.empty()) {
        say("there are no chapters yet");
        return 0;
    }
    const std::string next = next_action(project, known.chapters, known.results);
    if (json) {
        auto object = to_json(known);
        object["next"] = next;
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    int passed = 0, total = 0;
    for (const KnownResult& result : known.results) {
        passed += count(result.result, State::Passed);
        total += static_cast<int>(result.result.steps.size());
    }
    fmt::print("{}  {} of {}\n\n", paint("Ray tracing, chapter by chapter", Tone::Bold), passed,
               counted(total, "step"));
    std::size_t width = 0;
    for (const Chapter& chapter : known.chapters) width = std::max(width, chapter.title.size());
    for (std::size_t i = 0; i < known.chapters.size(); ++i)
        fmt::print("  {}  {:<{}}  {}{}\n", known.chapters[i].number, known.chapters[i].title, width,
                   bar(known.results[i].result),
                   known.results[i].current ? "" : paint("  changed since it was checked", Tone::Dim));
    fmt::print("\n{} {}\n", paint("Next:", Tone::Bold), next);
    return 0;
}

int run_list(bool json) {
    const Project project = this_project();
    const Known known = everything_known(project);
    if (json) {
        fmt::print("{}\n", json_text(to_json(known)));
        return 0;
    }
    for (std::size_t i = 0; i < known.chapters.size(); ++i) {
        const Chapter& chapter = known.chapters[i];
        fmt::print("{}{}  {}{}\n", i > 0 ? "\n" : "", paint(chapter.number, Tone::Bold),
                   paint(chapter.title, Tone::Bold),
                   known.results[i].current ? "" : paint("  changed since it was checked", Tone::Dim));
        for (std::size_t s = 0; s < chapter.steps.size(); ++s)
            fmt::print("{}\n", step_line(chapter.steps[s], known.results[i].result.steps[s]));
    }
    return 0;
}

}  // namespace rt
