// A class whose marks are known beforehand: students who wrote the steps of a chapter in their order, and
// came as far as they came. Their last step may be wrong. Usage: make_class DIR COUNT SEED CHAPTER...
//
// What a student is due does not come from any test that was run, but from how the course is made: a step
// that is not written costs nothing before it, so the steps before the last one are earned, the last one is
// if it is right, and those after it are not. A wrong step is one of tests/NN_*/mistakes, or it crashes, or
// its file does not compile, which costs the other steps of the file, too. Right ones are as in the solution,
// or as in tests/NN_*/variants. No mark depends on whether a later step's tests notice an earlier mistake.
#include "common/grading/points.hpp"
#include "common/grading/submission.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

using namespace rt;
namespace fs = std::filesystem;

namespace {

using Texts = std::map<std::string, std::string>;  // by the exercise's file

/// Of one chapter, what students are made of.
struct Material {
    const Chapter* chapter = nullptr;
    Texts solution;
    std::map<std::string, std::vector<Mistake>> mistakes, variants;  // by step

    /// Whether a part of the step is in the file: some steps have parts in two.
    bool is_in(const Step& step, const std::string& file) const {
        const std::vector<ExerciseRegion> regions = exercise_regions(solution.at(file), file);
        return std::ranges::find(regions, step.id, &ExerciseRegion::step) != regions.end();
    }
};

std::vector<std::string> lines_of(const std::string& text, const std::string& file, const std::string& step,
                                  bool inside) {
    const std::vector<std::string> lines = split_lines(text);
    std::vector<std::string> chosen;
    for (const ExerciseRegion& region : exercise_regions(text, file))
        if (region.step == step)
            for (int i = 0; i < static_cast<int>(lines.size()); ++i)
                if ((i >= region.first_line && i < region.last_line) == inside)
                    chosen.push_back(lines[static_cast<std::size_t>(i)]);
    return chosen;
}

/// Whether a change leaves all other steps alone, and what lies between them.
bool is_of_its_step_alone(const Mistake& change, const std::string& solution) {
    const std::string text = apply_mistake(change, solution, change.file);
    return lines_of(text, change.file, change.step, false) ==
           lines_of(solution, change.file, change.step, false);
}

std::map<std::string, std::vector<Mistake>> changes_in(const fs::path& directory, const std::string& ending) {
    std::map<std::string, std::vector<Mistake>> changes;
    for (const fs::path& file : files_in(directory, {ending})) {
        Mistake change = parse_mistake(read_file(file), file.string());
        changes[change.step].push_back(change);
    }
    return changes;
}

Material material_of(const Project& project, const Chapter& chapter) {
    Material material{&chapter, {}, {}, {}};
    for (const std::string& file : files_of_steps(chapter))
        material.solution[file] = read_file(project.root / "solutions" / chapter.name / file);
    const fs::path tests = project.root / "tests" / chapter.name;
    material.mistakes = changes_in(tests / "mistakes", ".mistake");
    material.variants = changes_in(tests / "variants", ".variant");
    for (auto& [step, mistakes] : material.mistakes)
        std::erase_if(mistakes, [&](const Mistake& mistake) {
            return !is_of_its_step_alone(mistake, material.solution.at(mistake.file));
        });
    return material;
}

// ---------------------------------------------------------------------------------------------- one student

/// Puts one line in the place of a step's code, of the first part if it has several.
std::string replaced_step(const std::string& text, const Step& step, const std::string& code) {
    std::vector<std::string> lines = split_lines(text);
    for (const ExerciseRegion& region : exercise_regions(text, step.file))
        if (region.step == step.id) {
            const auto first = lines.begin() + region.first_line;
            lines.erase(first, lines.begin() + region.last_line - 1);
            lines.insert(lines.begin() + region.first_line, code);
            break;
        }
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

/// What a student hands in who wrote these steps: the others are as they were handed out.
std::string handed_in(const std::string& text, const std::string& file,
                      const std::set<std::string>& written) {
    std::vector<std::string> lines = split_lines(text);
    const std::vector<ExerciseRegion> regions = exercise_regions(text, file);
    for (auto region = regions.rbegin(); region != regions.rend(); ++region) {
        if (!written.contains(region->step)) continue;
        lines.erase(lines.begin() + region->last_line - 1);
        lines.erase(lines.begin() + region->first_line - 1);
    }
    return exercise_text(fmt::format("{}\n", fmt::join(lines, "\n")), file);
}

struct Student {
    Texts files;
    std::set<std::string> earned;
    std::string about;
};

class Maker {
public:
    explicit Maker(std::uint64_t seed) : engine(seed) {}

    Student student(const Material& material) {
        const std::vector<Step>& steps = material.chapter->steps;
        const std::size_t count = drawn(3) == 0 ? steps.size() : drawn(steps.size() + 1);
        Student student{material.solution, {}, "nothing"};
        std::set<std::string> written;
        const std::size_t form = drawn(3);  // of right steps: as in the solution, or which variant
        for (std::size_t i = 0; i < count; ++i) {
            written.insert(steps[i].id);
            student.earned.insert(steps[i].id);
            student.about = "right up to " + steps[i].id;
        }
        std::string spoilt;  // the file with a mistake in it has no variants
        if (count > 0 && drawn(2) == 0) spoilt = spoil(material, count, student);
        for (const std::string& step : written) vary(material, step, form, spoilt, student);
        for (auto& [file, text] : student.files) text = handed_in(text, file, written);
        return student;
    }

private:
    std::size_t drawn(std::size_t below) { return static_cast<std::size_t>(engine() % below); }

    /// Makes the last of the first `count` steps wrong; the file in which it stands.
    std::string spoil(const Material& material, std::size_t count, Student& student) {
        const std::vector<Step>& steps = material.chapter->steps;
        const Step& last = steps[count - 1];
        const auto mistakes = material.mistakes.find(last.id);
        const std::size_t how = drawn(8);
        std::string file = last.file;
        std::string& text = student.files.at(file);
        if (how == 0) {
            text = replaced_step(text, last, "    __builtin_trap();");
            student.about = last.id + " crashes";
        } else if (how == 1 && is_behind_all_others(material, count)) {
            text = replaced_step(text, last, "    return these are no words of C++;");
            for (const Step& step : steps)
                if (material.is_in(step, file)) student.earned.erase(step.id);
            student.about = file + " does not compile";
        } else if (mistakes != material.mistakes.end() && !mistakes->second.empty()) {
            const Mistake& mistake = mistakes->second[drawn(mistakes->second.size())];
            file = mistake.file;
            student.files.at(file) = apply_mistake(mistake, student.files.at(file), file);
            student.about = last.id + ": " + mistake.why;
        } else {
            return "";
        }
        student.earned.erase(last.id);
        return file;
    }

    /// Whether, of the first `count` steps, all from the first one in the last one's file on are in that
    /// file.
    static bool is_behind_all_others(const Material& material, std::size_t count) {
        const std::vector<Step>& steps = material.chapter->steps;
        const auto end = steps.begin() + static_cast<std::ptrdiff_t>(count);
        const auto is_there = [&](const Step& step) { return material.is_in(step, steps[count - 1].file); };
        return std::all_of(std::find_if(steps.begin(), end, is_there), end, is_there);
    }

    void vary(const Material& material, const std::string& step, std::size_t form, const std::string& spoilt,
              Student& student) {
        const auto variants = material.variants.find(step);
        if (form == 0 || variants == material.variants.end() || variants->second.size() < form) return;
        const Mistake& variant = variants->second[form - 1];
        if (variant.file == spoilt || drawn(4) == 0) return;
        std::string& text = student.files.at(variant.file);
        text = apply_mistake(variant, text, variant.file);
    }

    std::mt19937_64 engine;
};

// ---------------------------------------------------------------------------------------------- the class

/// The class, and beside it what each of its marks must be.
void make(const fs::path& directory, int count, std::uint64_t seed, const std::vector<Material>& materials) {
    Maker maker(seed);
    std::string expected = "submission,earned,possible", about;
    for (const Material& material : materials)
        for (const Step& step : material.chapter->steps) expected += "," + step.id;
    expected += "\n";
    for (int i = 1; i <= count; ++i) {
        const std::string name = fmt::format("s{:03}", i);
        Points earned, possible;
        std::string columns;
        for (const Material& material : materials) {
            const Student student = maker.student(material);
            for (const auto& [file, text] : student.files) {
                const fs::path place =
                    directory / "submissions" / name / exercise_path(*material.chapter, file);
                fs::create_directories(place.parent_path());
                write_file(place, text);
            }
            for (const Step& step : material.chapter->steps) {
                const Points points = whole_points(step.points);
                const Points due = student.earned.contains(step.id) ? points : Points{};
                if (!step.optional) possible += points;  // else it is extra credit
                earned += due;
                columns += "," + text_of(due);
            }
            about += fmt::format("{} {}: {}\n", name, material.chapter->number, student.about);
        }
        expected += fmt::format("{},{},{}{}\n", name, text_of(earned), text_of(possible), columns);
    }
    write_file(directory / "expected.csv", expected);
    write_file(directory / "about.txt", about);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 5) throw InputError("usage: make_class DIR COUNT SEED CHAPTER...");
        const Project project = this_project();
        const std::vector<Chapter> chapters = read_catalogue(project);
        std::vector<Material> materials;
        for (int i = 4; i < argc; ++i)
            materials.push_back(material_of(project, find_chapter(chapters, argv[i])));
        make(argv[1], std::atoi(argv[2]), std::strtoull(argv[3], nullptr, 10), materials);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
