// `course list`: chapters and steps with titles, hours, points and state.
#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/result_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

int run_list(bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const std::vector<KnownResult> known = known_results(project, chapters);
    if (json) {
        fmt::print("{}\n", json_text(results_json(chapters, results_of(known))));
        return 0;
    }
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        const Chapter& chapter = chapters[i];
        fmt::print("{}{}  {}{}{}\n", i > 0 ? "\n" : "", paint(chapter.number, Tone::Bold),
                   paint(chapter.title, Tone::Bold),
                   paint(fmt::format("  about {}", counted(chapter.hours, "hour")), Tone::Dim),
                   known[i].current ? "" : paint("  changed since it was checked", Tone::Dim));
        for (std::size_t s = 0; s < chapter.steps.size(); ++s)
            fmt::print("{}\n", step_line(chapter.steps[s], known[i].result.steps[s]));
    }
    return 0;
}

}  // namespace rt
