// What helps a student on: hints, a fresh start, and the solution.
#include "common/commands/commands.hpp"
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/functions.hpp"
#include "common/workbook/results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace rt {

namespace fs = std::filesystem;

namespace {

// ------------------------------------------------------------------------------------------- hints

fs::path hints_file(const Project& project) { return memory(project, "hints.json"); }

/// How many hints of each step were shown; empty if that was never written, or is damaged.
nlohmann::json read_hints(const Project& project) {
    if (!fs::exists(hints_file(project))) return nlohmann::json::object();
    nlohmann::json shown = nlohmann::json::parse(read_file(hints_file(project)), nullptr, false);
    return shown.is_object() ? shown : nlohmann::json::object();
}

/// The number stored for a step, between 0 and `most`.
std::size_t hints_shown(const nlohmann::json& shown, const std::string& step, std::size_t most) {
    const auto found = shown.find(step);
    if (found == shown.end() || !found->is_number_unsigned()) return 0;
    return std::min(found->get<std::size_t>(), most);
}

// ------------------------------------------------------------------------------------------- reset

/// Keeps a text as x.cpp.001.backup, or with the first number that is free, and returns that name. The backup
/// is whole or not there. The memory's lock must be held, so that no other process takes the same number.
fs::path keep_backup(const fs::path& file, const std::string& text) {
    for (int number = 1;; ++number) {
        const fs::path backup = fmt::format("{}.{:03}.backup", file.string(), number);
        if (fs::exists(fs::symlink_status(backup))) continue;
        write_file(backup, text);
        return backup;
    }
}

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

/// The student's text with the functions of one step as they were at the start. Tells on standard error what
/// else that takes back. Throws InputError if a function cannot be found.
std::string with_step_reset(const std::string& mine, const std::string& pristine, const Chapter& chapter,
                            const Step& step) {
    std::string text = mine;
    for (const FunctionText& original : functions_with(pristine, todo_line(step.id))) {
        const auto found = find_function(text, original.signature);
        if (!found)
            throw InputError(
                fmt::format("step {} cannot be reset alone: chapters/{}/{} has no function '{}' any "
                            "more; ./course reset {} resets the whole chapter",
                            step.id, chapter.name, step.file, original.signature, chapter.number));
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
    std::string backup;  ///< empty if there was none
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
    const std::string text = step ? with_step_reset(mine, pristine, chapter, *step) : pristine;
    if (text == mine) return std::nullopt;
    const fs::path backup = keep_backup(path, mine);
    write_file(path, text);
    return Reset{relative(project, path), relative(project, backup)};
}

void print_resets(const std::vector<Reset>& resets) {
    if (resets.empty()) fmt::print("Nothing to reset: it is as it was at the start.\n");
    for (const Reset& reset : resets)
        if (reset.backup.empty())
            fmt::print("{} was missing and is back, as it was at the start\n", reset.file);
        else
            fmt::print("{} is back at its start; what you had is in {}\n", reset.file, reset.backup);
}

// ---------------------------------------------------------------------------------------- solution

/// A function as a part of a file, with the line where it stands.
struct Shown {
    std::string file;
    int line = 0;
    std::string text;
};

void print_code(std::string_view whose, const std::vector<Shown>& functions) {
    for (const Shown& function : functions)
        fmt::print("{}  {}\n{}\n", paint(whose, Tone::Bold),
                   paint(fmt::format("{}:{}", function.file, function.line), Tone::Dim), function.text);
}

nlohmann::json to_json(const std::vector<Shown>& functions) {
    auto list = nlohmann::json::array();
    for (const Shown& function : functions)
        list.push_back({{"file", function.file}, {"line", function.line}, {"text", function.text}});
    return list;
}

}  // namespace

int run_hint(const std::string& name, bool all, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Step& step = *find_step(chapters, name).step;

    const Lock lock(memory_lock(project), "counting hints");
    nlohmann::json shown = read_hints(project);
    const std::size_t before = hints_shown(shown, step.id, step.hints.size());
    const std::size_t after = all ? step.hints.size() : std::min(before + 1, step.hints.size());
    const std::size_t first = all ? 0 : before;
    shown[step.id] = std::max(before, after);
    write_file(hints_file(project), json_text(shown) + "\n");

    if (json) {
        const std::vector<std::string> hints(step.hints.begin() + static_cast<std::ptrdiff_t>(first),
                                             step.hints.begin() + static_cast<std::ptrdiff_t>(after));
        const nlohmann::ordered_json object = {
            {"step", step.id}, {"hints", hints}, {"shown", after}, {"of", step.hints.size()}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    for (std::size_t i = first; i < after; ++i)
        fmt::print("{} {}\n", paint(fmt::format("Hint {} of {}:", i + 1, step.hints.size()), Tone::Bold),
                   step.hints[i]);
    if (first == after)
        fmt::print(
            "No hints are left for step {}: you have seen all {}. ./course hint {} --all shows them again.\n",
            step.id, step.hints.size(), step.id);
    return 0;
}

int run_reset(const std::string& name, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Target target = find_target(chapters, name);
    const Chapter& chapter = *target.chapter;

    const Lock lock(memory_lock(project), "reset " + name);
    // What was deleted comes back alone: the files that are there may hold finished work.
    const std::vector<std::string> missing = missing_files(project, chapter);
    const std::vector<std::string> files = target.step        ? std::vector{target.step->file}
                                           : !missing.empty() ? missing
                                                              : exercise_files(project, chapter);
    std::vector<Reset> resets;
    for (const std::string& file : files)
        if (const auto reset = reset_file(project, chapter, file, target.step)) resets.push_back(*reset);
    if (json) {
        auto list = nlohmann::ordered_json::array();
        for (const Reset& reset : resets)
            list.push_back({{"file", reset.file},
                            {"backup", reset.backup.empty() ? nlohmann::ordered_json()
                                                            : nlohmann::ordered_json(reset.backup)}});
        fmt::print("{}\n", json_text(nlohmann::ordered_json{{"reset", list}}));
        return 0;
    }
    print_resets(resets);
    if (!target.step && !missing.empty())
        fmt::print(
            "The chapter's other files are as they were; ./course reset {} once more resets them, too.\n",
            chapter.number);
    return 0;
}

int run_solution(const std::string& name, bool spoil, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Target target = find_step(chapters, name);
    const Chapter& chapter = *target.chapter;
    const Step& step = *target.step;

    const fs::path solution = project.root / "solutions" / chapter.name / step.file;
    if (!fs::exists(solution)) throw InputError("this tree has no solutions");
    const std::vector<StepResult> results = known_result(project, chapter).result.steps;
    const bool passed = std::any_of(results.begin(), results.end(), [&](const StepResult& result) {
        return result.id == step.id && result.state == State::Passed;
    });
    if (!passed && !spoil) {
        say("step {} has not passed yet, and finding it yourself is the fun of it. ./course hint {} helps "
            "on; ./course solution {} --spoil shows it all the same.",
            step.id, step.id, step.id);
        return 1;
    }

    const std::string annotated = read_file(solution);
    const fs::path exercise = project.root / "chapters" / chapter.name / step.file;
    const std::string own = fs::exists(exercise) ? read_file(exercise) : "";
    std::vector<Shown> theirs, yours;
    for (const FunctionText& function : functions_with(annotated, "// [exercise " + step.id + "]")) {
        const std::string text = annotated.substr(function.begin, function.end - function.begin);
        theirs.push_back(
            {relative(project, solution), function.line, solution_text(text, solution.string())});
        if (const auto mine = find_function(own, function.signature))
            yours.push_back(
                {relative(project, exercise), mine->line, own.substr(mine->begin, mine->end - mine->begin)});
    }
    if (json) {
        const nlohmann::ordered_json object = {
            {"step", step.id}, {"yours", to_json(yours)}, {"solution", to_json(theirs)}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    print_code("Yours", yours);
    print_code("The solution", theirs);
    return 0;
}

}  // namespace rt
