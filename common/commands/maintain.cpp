// What keeps generated files true to their sources: exercises and figures.
#include "common/commands/commands.hpp"
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/drift.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_in(const fs::path& directory) {
    std::vector<std::string> names;
    if (fs::is_directory(directory))
        for (const auto& entry : fs::directory_iterator(directory))
            if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Timings differ each time.
bool is_measured(const std::string& name) { return name.starts_with("measured_"); }

int report(const std::vector<std::string>& changed, bool make, bool json, const char* repair) {
    if (json) {
        const nlohmann::ordered_json object = {{"changed", changed}, {"written", make}};
        fmt::print("{}\n", json_text(object));
    } else {
        for (const std::string& file : changed) fmt::print("{} {}\n", make ? "wrote" : "differs:", file);
        if (changed.empty()) fmt::print("nothing has changed\n");
        if (!changed.empty() && !make) say("{} writes what differs", repair);
    }
    return changed.empty() || make ? 0 : 1;
}

}  // namespace

std::vector<Drift> drifted_exercises(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<Drift> drifted;
    for (const Chapter& chapter : chapters) {
        const fs::path solutions = project.root / "solutions" / chapter.name;
        std::vector<std::string> marked;
        for (const std::string& name : names_in(solutions)) {
            if (fs::path(name).extension() != ".cpp") continue;
            const std::string solution = read_file(solutions / name);
            const std::string file = relative(project, solutions / name);
            for (const ExerciseRegion& region : exercise_regions(solution, file)) {
                const auto step = std::find_if(chapter.steps.begin(), chapter.steps.end(),
                                               [&](const Step& known) { return known.id == region.step; });
                if (step == chapter.steps.end())
                    throw InputError(fmt::format("{}:{}: chapters/{}/chapter.json has no step {}", file,
                                                 region.first_line, chapter.name, region.step));
                if (step->file == name) marked.push_back(region.step);
            }
            const fs::path exercise = project.root / "chapters" / chapter.name / name;
            const std::string expected = exercise_text(solution, file);
            if (!fs::exists(exercise) || read_file(exercise) != expected)
                drifted.push_back({exercise, expected});
        }
        for (const Step& step : chapter.steps)
            if (fs::is_directory(solutions) &&
                std::find(marked.begin(), marked.end(), step.id) == marked.end())
                throw InputError(fmt::format("solutions/{}/{} marks nothing as [exercise {}]", chapter.name,
                                             step.file, step.id));
    }
    return drifted;
}

std::vector<Drift> drifted_files(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<Drift> drifted = drifted_exercises(project, chapters);
    const fs::path reference = project.root / "common/scene/README.md";
    const std::string text = read_file(reference), begin = "<!-- commands -->\n";
    const std::size_t from = text.find(begin), to = text.find("<!-- /commands -->");
    if (from == std::string::npos || to == std::string::npos)
        throw InputError(relative(project, reference) + ": the marks around the table of commands are gone");
    const std::string expected =
        text.substr(0, from + begin.size()) + scene_command_table() + text.substr(to);
    if (text != expected) drifted.push_back({reference, expected});
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

int run_exercises(bool make, bool json) {
    const Project project = this_project();
    std::vector<std::string> changed;
    for (const Drift& drift : drifted_files(project, read_catalogue(project))) {
        if (make) write_file(drift.file, drift.expected);
        changed.push_back(relative(project, drift.file));
    }
    return report(changed, make, json, "./course exercises --make");
}

int run_figures(const std::string& number, bool make, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Chapter* only = number.empty() ? nullptr : &find_chapter(chapters, number);
    std::vector<std::string> changed;
    for (const Chapter& chapter : chapters) {
        const fs::path references = project.root / "references" / chapter.name;
        if ((only && only != &chapter) || !fs::exists(references / "figures.cpp")) continue;
        const std::string target = "figures_" + chapter.number;
        const BuildResult build = build_targets(project, {target}, "Building " + target);
        if (!build.ok) throw std::runtime_error(build.message);

        const fs::path drawn = project.build / "figures" / chapter.name;
        fs::remove_all(drawn);
        make_directories(drawn);
        const ProcessResult result = run_process({program(project, target).string(), drawn.string()});
        if (!succeeded(result)) throw std::runtime_error(target + " failed: " + result.output);

        const fs::path kept = references / "figures";
        for (const std::string& name : names_in(drawn)) {
            const std::string figure = read_file(drawn / name);
            const bool equal =
                fs::exists(kept / name) && (is_measured(name) || read_file(kept / name) == figure);
            if (equal && !(make && is_measured(name))) continue;
            if (make) {
                make_directories(kept);
                write_file(kept / name, figure);
            }
            changed.push_back(relative(project, kept / name));
        }
        for (const std::string& name : names_in(kept)) {
            if (fs::exists(drawn / name)) continue;
            if (make) fs::remove(kept / name);
            changed.push_back(relative(project, kept / name) + " (no longer drawn)");
        }
    }
    return report(changed, make, json, "./course figures --make");
}

}  // namespace rt
