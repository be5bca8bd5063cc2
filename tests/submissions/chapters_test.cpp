// A wrong chapter costs nothing in another, for every pair of chapters.
#include "common/commands/mine.hpp"
#include "common/grading/workshop.hpp"
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

}  // namespace

// The chapters all others of which are spoiled at once: if a chapter's worker held so much as one file of
// another chapter, it would not link, or would end before it is asked anything. It is the same program to the
// byte, so its marks are the same for each of the 72 pairs.
TEST_CASE("the program that is marked for a chapter holds nothing of a submission's other chapters",
          "[chapters]") {
    const std::optional<Isolation> level = test::best_level();
    if (!level) return;
    const Project project = this_project();
    const std::vector<Chapter> all = read_catalogue(project);
    const Submission perfect = test::perfect(pointers_to(all));
    Workshop workshop(project, {}, *level);
    for (const Chapter& chapter : all) {
        INFO(chapter.number);
        Submission no_code = perfect, crashing = perfect;
        spoil_others(no_code, chapter, "this is no C++\n", false);
        spoil_others(crashing, chapter, "\nstatic const bool ended = (__builtin_trap(), true);\n", true);
        const std::string undisturbed = worker_of(workshop, chapter, perfect, "perfect");
        CHECK(worker_of(workshop, chapter, no_code, "no_code") == undisturbed);
        CHECK(worker_of(workshop, chapter, crashing, "crashing") == undisturbed);
    }
}

// And the marks themselves. In a quick run of two chapters only.
TEST_CASE("a chapter has all its marks where every other chapter of the submission is wrong", "[chapters]") {
    const std::optional<Isolation> level = test::best_level();
    if (!level) return;
    const Project project = this_project();
    const std::vector<Chapter> all = read_catalogue(project);
    const bool quick = test::cases(10) < 10;
    for (const Chapter& chapter : all) {
        if (quick && chapter.number != "02" && chapter.number != "07") continue;
        Submission submission = test::perfect(pointers_to(all));
        spoil_others(submission, chapter, "this is no C++\n", false);
        Grader grader(
            project, {.chapters = {&chapter}, .rubric = default_rubric(all), .seed = 3, .isolation = *level});
        const Grade grade = grader.grade(submission);
        INFO(test::told(grade));
        CHECK(grade.steps.size() == chapter.steps.size());
        for (const GradedStep& step : grade.steps) CHECK(text_of(step.earned) == text_of(step.possible));
    }
}
