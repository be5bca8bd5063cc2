// `course solution`: a student's code for a step, and the solution's.
#include "common/commands/commands.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/functions.hpp"
#include "common/workbook/results.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

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

/// The functions of a step.
struct BothCodes {
    std::vector<Shown> yours, theirs;
};

BothCodes code_of(const Project& project, const Chapter& chapter, const Step& step,
                  const fs::path& solution) {
    const std::string annotated = read_file(solution);
    const fs::path exercise = project.root / "chapters" / chapter.name / step.file;
    const std::string own = fs::exists(exercise) ? read_file(exercise) : "";
    BothCodes code;
    for (const FunctionText& function : functions_with(annotated, "// [exercise " + step.id + "]")) {
        const std::string text = annotated.substr(function.begin, function.end - function.begin);
        code.theirs.push_back(
            {relative(project, solution), function.line, solution_text(text, solution.string())});
        if (const auto mine = find_function(own, function.signature))
            code.yours.push_back(
                {relative(project, exercise), mine->line, own.substr(mine->begin, mine->end - mine->begin)});
    }
    return code;
}

bool has_passed(const Project& project, const Chapter& chapter, const Step& step) {
    const std::vector<StepResult> results = known_result(project, chapter).result.steps;
    return std::any_of(results.begin(), results.end(), [&](const StepResult& result) {
        return result.id == step.id && result.state == State::Passed;
    });
}

}  // namespace

int run_solution(const std::string& name, bool spoil, bool json) {
    const Project project = this_project();
    require_solutions(project, "./course solution");
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Target target = find_step(chapters, name);
    const Chapter& chapter = *target.chapter;
    const Step& step = *target.step;

    const fs::path solution = project.root / "solutions" / chapter.name / step.file;
    if (!spoil && !has_passed(project, chapter, step)) {
        say("step {} has not passed yet, and finding it yourself is the fun of it. ./course hint {} helps "
            "on; ./course solution {} --spoil shows it all the same.",
            step.id, step.id, step.id);
        return 1;
    }
    const BothCodes code = code_of(project, chapter, step, solution);
    if (json) {
        const nlohmann::ordered_json object = {
            {"step", step.id}, {"yours", to_json(code.yours)}, {"solution", to_json(code.theirs)}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    print_code("Yours", code.yours);
    print_code("The solution", code.theirs);
    return 0;
}

}  // namespace rt
