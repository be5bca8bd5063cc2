// Submissions for tests of the grader, and what came of them.
#include "tests/submissions/submissions.hpp"

#include "common/image/whole_file.hpp"
#include "common/terminal/lock.hpp"
#include "tests/grading/sandbox/boxes.hpp"
#include "tests/support.hpp"

#include <iostream>
#include <sstream>

namespace rt::test {

namespace fs = std::filesystem;

namespace {

std::optional<Isolation> find_best_level() {
    for (const Level& level : probe())
        if (level.possible && level.isolation != Isolation::None) return level.isolation;
    std::cout << "This machine can have no boxes; no submission was graded.\n";
    return {};
}

}  // namespace

std::optional<Isolation> best_level() {
    static const std::optional<Isolation> best = find_best_level();
    if (best && *best != Isolation::Bubblewrap) {
        static const Lock until_the_end(boxes_lock(), "marking submissions");
    }
    return best;
}

Submission perfect(const std::vector<const Chapter*>& chapters) {
    Submission submission{"perfect", {}, {}};
    for (const Chapter* chapter : chapters)
        for (const std::string& file : files_of_steps(*chapter))
            submission.files[exercise_path(*chapter, file)] =
                read_file(fs::path(repository()) / "solutions" / chapter->name / file);
    return submission;
}

void change(Submission& submission, const Chapter& chapter, const std::string& file,
            const std::vector<Replacement>& replacements) {
    std::string& text = submission.files.at(exercise_path(chapter, file));
    text = apply_mistake({"", file, "", "", replacements}, text, file);
}

void change_as(Submission& submission, const Chapter& chapter, const std::string& file) {
    const fs::path path = fs::path(repository()) / "tests" / chapter.name / file;
    const Mistake mistake = parse_mistake(read_file(path), file);
    change(submission, chapter, mistake.file, mistake.replacements);
}

std::string told(const Grade& grade) {
    std::ostringstream all;
    for (const GradedStep& step : grade.steps) {
        all << step.id << ": " << text_of(step.earned) << " of " << text_of(step.possible) << ", "
            << name_of(step.verdict);
        if (step.failure) all << ": " << step.failure->asked << ": " << step.failure->said;
        all << "\n";
    }
    return all.str();
}

bool somebody_said(const Grade& grade, std::string_view text) {
    for (const GradedStep& step : grade.steps)
        if (step.failure && step.failure->said.find(text) != std::string::npos) return true;
    return false;
}

}  // namespace rt::test
