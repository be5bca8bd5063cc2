// What of the course's code is the student's.
#include "common/workbook/own_code.hpp"

#include "common/image/whole_file.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/functions.hpp"
#include "common/workbook/lexemes.hpp"
#include "common/workbook/results.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::string todo_call(std::string_view step) { return "todo(\"" + std::string(step) + "\")"; }

/// Whether code calls todo, for this step if one is given; in comments it may stand.
bool waits(std::string_view code, std::string_view step = "") {
    const std::vector<Lexeme> all = lexemes_of(code);
    for (std::size_t i = 0; i + 2 < all.size(); ++i)
        if (all[i].is("todo") && all[i + 1].is("(") && all[i + 2].kind == Lexeme::Kind::Quoted &&
            (step.empty() || all[i + 2].text == fmt::format("\"{}\"", step)))
            return true;
    return false;
}

std::string_view text_of(const std::string& file, const FunctionText& function) {
    return std::string_view(file).substr(function.begin, function.end - function.begin);
}

/// What a file of the exercise says; empty if it is missing.
std::string text_of(const Project& project, const Chapter& chapter, const std::string& file) {
    const fs::path path = project.root / "chapters" / chapter.name / file;
    return fs::exists(path) ? read_file(path) : "";
}

/// Whether some function of the step is written. One that is not found any more is: its text was changed.
bool is_begun(const std::string& mine, const std::string& pristine, const std::string& step) {
    const std::vector<FunctionText> functions = functions_with(pristine, todo_call(step));
    return std::any_of(functions.begin(), functions.end(), [&](const FunctionText& function) {
        const auto found = find_function(mine, function.signature);
        return !found || !waits(text_of(mine, *found), step);
    });
}

void add_half_written(const Project& project, const Chapter& chapter, const std::vector<std::string>& steps,
                      OwnCode& own) {
    own.steps.insert(own.steps.end(), steps.begin(), steps.end());
    for (const std::string& file : exercise_files(project, chapter))
        if (text_of(project, chapter, file) != pristine_text(project, chapter, file))
            own.filled.push_back(chapter.name + "/" + file);
}

std::string line_directive(int line, const std::string& file) {
    return fmt::format("#line {} \"{}\"\n", line, file);
}

}  // namespace

std::vector<std::string> begun_steps(const Project& project, const Chapter& chapter) {
    std::vector<std::string> begun;
    for (const Step& step : chapter.steps) {
        const std::string mine = text_of(project, chapter, step.file);
        const auto pristine = pristine_text(project, chapter, step.file);
        if (!mine.empty() && pristine && mine != *pristine && is_begun(mine, *pristine, step.id))
            begun.push_back(step.id);
    }
    return begun;
}

OwnCode own_code(const Project& project, const std::vector<Chapter>& chapters) {
    OwnCode own;
    for (const Chapter& chapter : chapters) {
        // Of a chapter that has lost files the build says so.
        if (!has_solutions(project) || !missing_files(project, chapter).empty()) {
            own.whole.push_back(&chapter);
            continue;
        }
        const std::vector<std::string> steps = begun_steps(project, chapter);
        if (steps.empty()) continue;
        const bool is_whole = std::none_of(chapter.steps.begin(), chapter.steps.end(), [&](const Step& step) {
            return !step.optional && waits(text_of(project, chapter, step.file), step.id);
        });
        if (is_whole)
            own.whole.push_back(&chapter);
        else
            add_half_written(project, chapter, steps, own);
    }
    return own;
}

std::string in_words(const OwnCode& own) {
    std::vector<std::string> parts = own.steps;
    for (const Chapter* chapter : own.whole) parts.push_back(chapter->number);
    std::sort(parts.begin(), parts.end());
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string filled_text(const std::string& mine, const std::string& pristine, const std::string& solution,
                        const std::string& name) {
    std::string text = mine;
    std::vector<FunctionText> missing;  // in the student's file
    for (const FunctionText& function : functions_with(pristine, "todo(\"")) {
        const auto found = find_function(mine, function.signature);
        if (found && waits(text_of(mine, *found))) missing.push_back(*found);
    }
    std::ranges::sort(missing, std::greater(), &FunctionText::begin);  // the last first
    for (const FunctionText& function : missing) {
        const auto solved = find_function(solution, function.signature);
        if (!solved) continue;
        text.replace(function.begin, function.end - function.begin,
                     line_directive(solved->line, "solutions/" + name) +
                         solution.substr(solved->begin, solved->end - solved->begin) +
                         line_directive(line_at(mine, function.end), "chapters/" + name));
    }
    return line_directive(1, "chapters/" + name) + text;
}

void write_filled(const Project& project, const OwnCode& own) {
    for (const std::string& name : own.filled) {
        const fs::path solution = project.root / "solutions" / name, made = project.build / "mine" / name;
        const std::string solved = read_file(solution);
        const std::string text = filled_text(read_file(project.root / "chapters" / name),
                                             exercise_text(solved, name), solved, name);
        make_directories(made.parent_path());
        if (!fs::exists(made) || read_file(made) != text) write_file(made, text);
    }
}

}  // namespace rt
