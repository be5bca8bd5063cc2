// A wrong chapter costs nothing in another, for every pair of chapters.
#include "common/commands/mine.hpp"
#include "common/grading/grader.hpp"
#include "common/image/whole_file.hpp"
#include "tests/catch.hpp"
#include "tests/submissions/submissions.hpp"
#include "tests/support.hpp"

#include <filesystem>

namespace fs = std::filesystem;
using namespace rt;

namespace {

/// All files of all chapters but this one, with a text instead of theirs, or after it.
void spoil_others(Submission& submission, const Chapter& chapter, const std::string& text, bool after) {
    for (auto& [file, theirs] : submission.files)
        if (!file.starts_with("chapters/" + chapter.name + "/")) theirs = after ? theirs + text : text;
}

std::string worker_of(Workshop& workshop, const Chapter& chapter, const Submission& submission,
                      const std::string& name) {
    const fs::path directory = workshop.place() / "work" / chapter.number / name;
    fs::create_directories(directory);
    const BuiltWorker worker = workshop.build(chapter, submission, directory);
    CHECK(worker.errors.empty());
    REQUIRE_FALSE(worker.program.empty());
    return fingerprint(read_file(worker.program));
}

/// The chapters all others of which are spoiled at once: if a chapter's worker held so much as one file of
/// another chapter, it would not link, or would end before it is asked anything.
void check_holds_no_other(Workshop& workshop, const Chapter& chapter, const Submission& perfect) {
    INFO(chapter.number);
    Submission no_code = perfect, crashing = perfect;
    spoil_others(no_code, chapter, "this is no C++\n", false);
    spoil_others(crashing, chapter, "\nstatic const bool ended = (__builtin_trap(), true);\n", true);
    const std::string undisturbed = worker_of(workshop, chapter, perfect, "perfect");
    CHECK(worker_of(workshop, chapter, no_code, "no_code") == undisturbed);
    CHECK(worker_of(workshop, chapter, crashing, "crashing") == undisturbed);
}

}  // namespace

// The program that is marked is the same to the byte, whatever the submission's other chapters are, so its
// marks are the same for each pair of chapters; and by it each chapter has all of them. Marks of two chapters
// only in a quick run.
TEST_CASE(
    "the program that is marked for a chapter holds nothing of a submission's others, and has all marks",
    "[chapters]") {
    const std::optional<Isolation> level = test::best_level();
    if (!level) return;
    const Project project = this_project();
    const std::vector<Chapter> all = read_catalogue(project);
    const bool quick = test::cases(10) < 10;
    std::vector<const Chapter*> marked;
    std::size_t steps = 0;
    for (const Chapter& chapter : all) {
        if (quick && chapter.number != "02" && chapter.number != "07") continue;
        marked.push_back(&chapter);
        steps += chapter.steps.size();
    }
    const Submission perfect = test::perfect(pointers_to(all));

    Grader grader(project,
                  {.chapters = marked, .rubric = default_rubric(all), .seed = 3, .isolation = *level});
    for (const Chapter& chapter : all) check_holds_no_other(grader.workshop(), chapter, perfect);
    const Grade grade = grader.grade(perfect);
    INFO(test::told(grade));
    CHECK(grade.steps.size() == steps);
    for (const GradedStep& step : grade.steps) CHECK(text_of(step.earned) == text_of(step.possible));
}
