// What a class keeps in its tree: the seed of its random cases, and the marks that were given.
#include "common/grading/kept_grades.hpp"

#include "common/grading/grade_json.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/lock.hpp"

#include <fmt/format.h>

#include <random>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// What a mark depends on beside the submission: the tests, the solutions of other chapters, and all that is
/// asked of the grader.
std::string what_counts(const Project& project, const GraderOptions& options) {
    std::string all =
        fmt::format("{} {} {}", digest_of(options.rubric), options.seed, name_of(options.isolation));
    for (const Chapter* chapter : options.chapters)
        all += " " + fingerprint(read_file(program(project, "judge_" + chapter->number)));
    for (const fs::path& library : files_in(project.build / "grading", {".a"}))
        all += " " + fingerprint(read_file(library));
    return all;
}

}  // namespace

std::uint64_t seed_of_class(const Project& project) {
    const Lock lock(memory_lock(project), "drawing the seed of a class");
    const fs::path file = memory(project, "grading_seed");
    if (!fs::exists(file)) {
        std::random_device device;
        write_file(file, fmt::format("{}\n", (std::uint64_t{device()} << 21) ^ device()));
    }
    return std::stoull(read_file(file));
}

KeptGrades::KeptGrades(const Project& project, const GraderOptions& options)
    : directory_(memory(project, "grades")), about_(what_counts(project, options)) {
    fs::create_directories(directory_);
}

std::optional<Grade> KeptGrades::find(const Submission& submission) const {
    const fs::path file = file_of(submission);
    if (!fs::exists(file)) return {};
    try {
        std::vector<Grade> grades = read_grades(file.string(), read_file(file));
        if (grades.size() == 1) return std::move(grades.front());
    } catch (const InputError&) {
    }
    return {};
}

void KeptGrades::keep(const Submission& submission, const Grade& grade) const {
    write_file(file_of(submission), grades_text({grade}));
}

fs::path KeptGrades::file_of(const Submission& submission) const {
    const std::string submitted = submission.submitted ? text_of(*submission.submitted) : "";
    return directory_ / (fingerprint(fmt::format("{}\n{}\n{}\n{}", about_, submission.name,
                                                 digest_of(submission), submitted)) +
                         ".json");
}

}  // namespace rt
