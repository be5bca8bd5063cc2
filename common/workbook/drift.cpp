// Generated files against what they are generated from.
#include "common/workbook/drift.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// The steps of the chapter that a solution's marks name. Throws InputError for one that the chapter does not
/// have.
std::vector<std::string> marked_steps(const Chapter& chapter, const std::string& solution,
                                      const std::string& file) {
    std::vector<std::string> steps;
    for (const ExerciseRegion& region : exercise_regions(solution, file)) {
        const auto step = std::ranges::find(chapter.steps, region.step, &Step::id);
        if (step == chapter.steps.end())
            throw InputError(fmt::format("{}:{}: chapters/{}/chapter.json has no step {}", file,
                                         region.first_line, chapter.name, region.step));
        if (step->file == fs::path(file).filename().string()) steps.push_back(region.step);
    }
    return steps;
}

void add_drift(std::vector<Drift>& drifted, const Project& project, const Chapter& chapter) {
    const fs::path solutions = project.root / "solutions" / chapter.name;
    std::vector<std::string> marked;
    for (const fs::path& path : files_in(solutions, {".cpp"})) {
        const std::string solution = read_file(path), file = relative(project, path);
        for (const std::string& step : marked_steps(chapter, solution, file)) marked.push_back(step);
        const fs::path exercise = project.root / "chapters" / chapter.name / path.filename();
        const std::string expected = exercise_text(solution, file);
        if (!fs::exists(exercise) || read_file(exercise) != expected) drifted.push_back({exercise, expected});
    }
    if (!fs::is_directory(solutions)) return;
    for (const Step& step : chapter.steps)
        if (std::ranges::find(marked, step.id) == marked.end())
            throw InputError(fmt::format("solutions/{}/{} marks nothing as [exercise {}]", chapter.name,
                                         step.file, step.id));
}

}  // namespace

std::vector<Drift> drifted_exercises(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<Drift> drifted;
    for (const Chapter& chapter : chapters) add_drift(drifted, project, chapter);
    return drifted;
}

bool is_students_tree(const Project& project, const std::vector<Chapter>& chapters) {
    for (const Chapter& chapter : chapters) {
        for (const std::string& file : exercise_files(project, chapter)) {
            const std::string mine = read_file(project.root / "chapters" / chapter.name / file);
            const auto pristine = pristine_text(project, chapter, file);
            for (const Step& step : chapter.steps) {
                const std::string todo = "todo(\"" + step.id + "\")";
                if (pristine && pristine->find(todo) != std::string::npos &&
                    mine.find(todo) == std::string::npos)
                    return true;
            }
        }
    }
    return false;
}

}  // namespace rt
