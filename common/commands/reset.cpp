// `course reset`: a chapter or a step back to its start; what was there is kept.
#include "common/commands/commands.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/backup.hpp"
#include "common/workbook/functions.hpp"
#include "common/workbook/given_files.hpp"
#include "common/workbook/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::string pristine_or_explain(const Project& project, const Chapter& chapter, const std::string& file) {
    const auto text = pristine_text(project, chapter, file);
    if (text) return *text;
    throw InputError(
        fmt::format("chapters/{}/{} cannot be reset: its original is neither in solutions/ nor in "
                    ".course/pristine/",
                    chapter.name, file));
}

std::string todo_line(const std::string& step) { return "return todo(\"" + step + "\");"; }

/// The other steps that the function belongs to.
std::vector<std::string> other_steps(std::string_view function, const Chapter& chapter,
                                     const std::string& step) {
    std::vector<std::string> others;
    for (const Step& other : chapter.steps)
        if (other.id != step && function.find(todo_line(other.id)) != std::string_view::npos)
            others.push_back(other.id);
    return others;
}

/// The student's text with those functions of one step that were deleted, which are added to `added`. Throws
/// InputError if one has no place there.
std::string with_missing_functions(std::string text, const std::string& pristine, const Chapter& chapter,
                                   const Step& step, std::vector<std::string>& added) {
    for (const FunctionText& original : functions_with(pristine, todo_line(step.id))) {
        if (find_function(text, original.signature)) continue;
        const auto whole = with_function(text, pristine, original);
        if (!whole)
            throw InputError(
                fmt::format("step {} cannot be reset alone: chapters/{}/{} has no function '{}' any "
                            "more; ./course reset {} resets the whole chapter",
                            step.id, chapter.name, step.file, original.signature, chapter.number));
        text = *whole;
        added.push_back(original.signature);
    }
    return text;
}

/// The student's text, which has all functions of one step, with them as they were at the start. Tells on
/// standard error what else that takes back.
std::string with_step_reset(std::string text, const std::string& pristine, const Chapter& chapter,
                            const Step& step) {
    for (const FunctionText& original : functions_with(pristine, todo_line(step.id))) {
        const auto found = find_function(text, original.signature);
        const std::string function = pristine.substr(original.begin, original.end - original.begin);
        for (const std::string& other : other_steps(function, chapter, step.id))
            say("the same function holds step {}, which starts again, too", other);
        text.replace(found->begin, found->end - found->begin, function);
    }
    return text;
}

/// A file that was put back, and where the old one went; both as from the repository's root.
struct Reset {
    std::string file;
    std::string backup;                ///< empty if there was none
    std::vector<std::string> added{};  ///< the functions that came back, if nothing else did
};

/// Puts a file back, all of it or one step. Nothing if it is at its start already.
std::optional<Reset> reset_file(const Project& project, const Chapter& chapter, const std::string& file,
                                const Step* step) {
    const fs::path path = project.root / "chapters" / chapter.name / file;
    const std::string pristine = pristine_or_explain(project, chapter, file);
    if (!fs::exists(path)) {
        write_file(path, pristine);
        return Reset{relative(project, path), ""};
    }
    const std::string mine = read_file(path);
    std::vector<std::string> added;
    std::string text = step ? with_missing_functions(mine, pristine, chapter, *step, added) : pristine;
    if (step && added.empty()) text = with_step_reset(mine, pristine, chapter, *step);
    if (text == mine) return std::nullopt;
    const fs::path backup = keep_backup(path, mine);
    write_file(path, text);
    return Reset{relative(project, path), relative(project, backup), added};
}

void print_resets(const std::vector<Reset>& resets) {
    if (resets.empty()) fmt::print("Nothing to reset: it is as it was at the start.\n");
    for (const Reset& reset : resets)
        if (reset.backup.empty())
            fmt::print("{} was missing and is back, as it was at the start\n", reset.file);
        else if (!reset.added.empty())
            fmt::print("{} has {} again, and else is as it was; what you had is in {}\n", reset.file,
                       fmt::join(reset.added, " and "), reset.backup);
        else
            fmt::print("{} is back at its start; what you had is in {}\n", reset.file, reset.backup);
}

void print_json(const std::vector<Reset>& resets) {
    auto list = nlohmann::ordered_json::array();
    for (const Reset& reset : resets)
        list.push_back({{"file", reset.file},
                        {"backup", reset.backup.empty() ? nlohmann::ordered_json()
                                                        : nlohmann::ordered_json(reset.backup)}});
    fmt::print("{}\n", json_text(nlohmann::ordered_json{{"reset", list}}));
}

}  // namespace

int run_reset(const std::string& name, bool json) {
    const Project project = this_project();
    const Lock lock(memory_lock(project), "a reset");
    std::vector<Reset> resets;
    // Without its given files a chapter may not even be known.
    for (const std::string& file : restore_missing(project, name)) resets.push_back({file, ""});
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Target target = find_target(chapters, name);
    const Chapter& chapter = *target.chapter;

    // What was deleted comes back alone: the files that are there may hold finished work.
    std::vector<std::string> files = missing_files(project, chapter);
    const bool only_missing = !target.step && !(resets.empty() && files.empty());
    if (target.step)
        files = {target.step->file};
    else if (!only_missing)
        files = exercise_files(project, chapter);
    for (const std::string& file : files)
        if (const auto reset = reset_file(project, chapter, file, target.step)) resets.push_back(*reset);
    if (json) {
        print_json(resets);
        return 0;
    }
    print_resets(resets);
    if (only_missing)
        fmt::print(
            "The chapter's other files are as they were; ./course reset {} once more resets them, too.\n",
            chapter.number);
    return 0;
}

}  // namespace rt
