// `course check`: verdicts a step, the first failing message, the chapter's picture, the one next action.
#include "common/workbook/check.hpp"
#include "common/commands/chapter_pictures.hpp"
#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/given_files.hpp"
#include "common/workbook/result_text.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>

namespace rt {

namespace {

/// The chapters to check, each once, and the steps that were named; none if all are meant.
struct Request {
    std::vector<const Chapter*> chapters;
    std::set<std::string> steps;
    std::set<std::string> whole;  ///< numbers of the chapters that were named without a step
};

const Chapter& in_progress(const Project& project, const std::vector<Chapter>& chapters) {
    for (const Chapter& chapter : chapters) {
        const KnownResult known = known_result(project, chapter);
        if (!known.current || !all_passed(known.result)) return chapter;
    }
    return chapters.back();
}

Request requested(const Project& project, const std::vector<Chapter>& chapters, const CheckCommand& command) {
    Request request;
    const auto add = [&](const Chapter& chapter) {
        if (std::find(request.chapters.begin(), request.chapters.end(), &chapter) == request.chapters.end())
            request.chapters.push_back(&chapter);
    };
    for (const std::string& text : command.targets) {
        const Target target = find_target(chapters, text);
        add(*target.chapter);
        if (target.step)
            request.steps.insert(target.step->id);
        else
            request.whole.insert(target.chapter->number);
    }
    if (command.targets.empty() && command.solutions)
        for (const Chapter& chapter : chapters) add(chapter);
    if (command.targets.empty() && !command.solutions) add(in_progress(project, chapters));
    return request;
}

bool wanted(const Request& request, const Chapter& chapter, const std::string& step) {
    const bool all = request.whole.contains(chapter.number) ||
                     std::none_of(request.steps.begin(), request.steps.end(), [&](const std::string& id) {
                         return id.starts_with(chapter.number + ".");
                     });
    return all || request.steps.contains(step);
}

/// The steps of a result that were asked for.
ChapterResult narrowed(const Request& request, const Chapter& chapter, ChapterResult result) {
    std::erase_if(result.steps, [&](const StepResult& step) { return !wanted(request, chapter, step.id); });
    return result;
}

/// Of its message the first line alone.
StepResult in_short(const StepResult& step) {
    return {step.id, step.state, step.message.substr(0, step.message.find('\n'))};
}

void print_chapter(const Chapter& chapter, const ChapterResult& result) {
    const StepsDone done = steps_done(result);
    fmt::print("{}  {} of {}\n",
               paint(fmt::format("Chapter {}: {}", chapter.number, chapter.title), Tone::Bold), done.passed,
               counted(done.all, "step"));
    if (!result.build_error.empty()) {
        fmt::print("  {} It does not build:\n      {}\n{}", paint("✗", Tone::Bad), result.build_error,
                   notes(result));
        return;
    }
    const bool alone = result.steps.size() == 1;
    bool shown = false;
    std::string not_shown;
    for (const StepResult& step : result.steps) {
        fmt::print("{}\n", step_line(step_of(chapter, step.id), step));
        if (step.state != State::Failed) continue;
        const bool follows = !step.because.empty() && !alone;
        // One message is enough to work on; the others' first lines say that there are more. What follows
        // from another step is no trouble of its own.
        if (!follows) fmt::print("{}", shown ? details(in_short(step)) : details(step));
        if ((shown || follows) && not_shown.empty()) not_shown = step.id;
        shown = shown || !follows;
    }
    if (!not_shown.empty())
        fmt::print("{}\n",
                   paint(fmt::format("  ./course check {} shows all about that step", not_shown), Tone::Dim));
    fmt::print("{}", notes(result));
}

/// What there is to show: the first step of those asked for that has failed, a step that was named and has
/// passed, or the chapter's picture where all has passed.
std::optional<VerdictPicture> picture_of(const Project& project, const Chapter& chapter,
                                         const Request& request, const ChapterResult& asked,
                                         const ChapterResult& all) {
    if (!all.build_error.empty()) return std::nullopt;
    const auto failed = std::ranges::find(asked.steps, State::Failed, &StepResult::state);
    if (failed != asked.steps.end()) return picture_of_failed(project, chapter, all, failed->id);
    for (const StepResult& step : asked.steps)
        if (request.steps.contains(step.id) && step.state == State::Passed)
            if (auto picture = picture_of_passed(project, chapter, step_of(chapter, step.id))) return picture;
    return all_passed(all) ? chapter_picture(project, chapter) : std::nullopt;
}

/// The results as JSON, with what is shown beside them.
nlohmann::ordered_json verdict_json(const std::vector<Chapter>& chapters,
                                    const std::vector<ChapterResult>& asked,
                                    const std::optional<VerdictPicture>& picture) {
    nlohmann::ordered_json json = results_json(chapters, asked);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        nlohmann::ordered_json& chapter = json["chapters"][i];
        chapter["prints"] = nlohmann::ordered_json::array();
        for (const Printed& printed : asked[i].printed)
            chapter["prints"].push_back(
                {{"test", printed.test}, {"lines", printed.lines}, {"more", printed.more}});
        chapter["warnings"] = asked[i].warnings;
        if (picture) chapter["picture"] = picture->file;
    }
    return json;
}

/// What to do first where a chapter does not build because of a given file that was changed; else nothing.
std::string given_to_restore(const Project& project, const ChapterResult& result) {
    const std::string& error = result.build_error;
    const bool is_theirs = error.starts_with("chapters/") && error.find(".cpp") < error.find(' ');
    if (error.empty() || is_theirs) return "";
    const GivenChanges changes = given_changes(project);
    return changes.files.empty() ? "" : restore_command(changes);
}

/// First what was asked for; if that has all passed, whatever comes next in the course.
std::string next_after(const Project& project, const std::vector<Chapter>& chapters, const Request& request,
                       const std::vector<ChapterResult>& results) {
    for (const ChapterResult& result : results)
        if (const std::string restore = given_to_restore(project, result); !restore.empty()) return restore;
    for (std::size_t i = 0; i < results.size(); ++i)
        if (!all_passed(results[i])) return next_action(*request.chapters[i], results[i]);
    return next_action(project, chapters, known_results(project, chapters));
}

}  // namespace

int run_check(const CheckCommand& command) {
    const Project project = this_project();
    if (command.solutions) require_solutions(project, "./course check --solutions");
    const std::vector<Chapter> chapters = read_catalogue(project);
    if (chapters.empty()) throw InputError("there are no chapters to check");
    const Request request = requested(project, chapters, command);

    std::vector<ChapterResult> results = check_chapters(project, request.chapters, command.solutions);
    std::vector<ChapterResult> asked;
    for (std::size_t i = 0; i < results.size(); ++i)
        asked.push_back(narrowed(request, *request.chapters[i], results[i]));
    const bool good = std::all_of(asked.begin(), asked.end(), all_passed);

    const auto picture = [&]() -> std::optional<VerdictPicture> {
        if (command.solutions || request.chapters.size() != 1) return std::nullopt;
        return picture_of(project, *request.chapters.front(), request, asked.front(), results.front());
    };
    if (command.json) {
        fmt::print("{}\n", json_text(verdict_json(chapters, asked, picture())));
        return good ? 0 : 1;
    }

    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (i > 0) fmt::print("\n");
        print_chapter(*request.chapters[i], asked[i]);
    }
    flush_output();
    if (command.solutions) return good ? 0 : 1;

    if (const auto shown = picture()) fmt::print("{}", shown->text);
    fmt::print("\n{} {}\n", paint("Next:", Tone::Bold), next_after(project, chapters, request, results));
    return good ? 0 : 1;
}

}  // namespace rt
