// What is known about a student's steps: not started, wrong or right.
#pragma once

#include "common/workbook/catalogue.hpp"
#include "common/workbook/printed.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

enum class State { Todo, Failed, Passed };

/// "todo", "failed" or "passed".
std::string_view name_of(State state);

struct StepResult {
    std::string id;
    State state = State::Todo;
    std::string message;  ///< the first line says it all; more may follow
    std::string
        because{};  ///< a failed step that it uses, and from which its own failure may follow; or empty
    bool optional = false;  ///< as the catalogue says of the step
};

struct ChapterResult {
    std::string chapter;            ///< its name, "02_spheres"
    std::string build_error;        ///< the compiler's first message; empty if it compiled
    std::vector<StepResult> steps;  ///< all of the chapter's, in order

    // What is shown beside them; it is not remembered.
    std::vector<Printed> printed{};       ///< while the tests ran
    std::vector<std::string> warnings{};  ///< of the compiler, of the chapter's files
};

/// Nothing started.
ChapterResult all_todo(const Chapter& chapter);

/// Whether nothing is left to do: optional steps need not be begun, unless nothing else was asked for.
bool all_passed(const ChapterResult& result);
/// How many steps there are, and how many have passed; optional ones are not counted, unless there are no
/// others.
struct StepsDone {
    int passed = 0, all = 0;
};
StepsDone steps_done(const ChapterResult& result);

/// One test case as the report of a test program (tests/main.cpp) tells it.
struct TestRun {
    std::string name;
    std::vector<std::string> steps;  ///< all its tags
    State state = State::Todo;
    std::string message;
    std::string missing;    ///< the step that is not started, where `state` is Todo
    std::string stopped{};  ///< how a call ended that gave no answer, in the autograder's judges; else empty
};

/// What a test program had written when it ended, in whichever way.
struct TestReport {
    std::vector<TestRun> ended;
    std::optional<TestRun> died_in;         ///< started and not ended
    bool complete = false;                  ///< the program came to its end
    std::vector<std::string> stopped_at{};  ///< where it was at its end (tests/back_trace.hpp)
};

/// Reads a report. Lines that are not whole, or not a report's, end it.
TestReport read_report(std::string_view text);

/// The tag of tests that put whole families of extreme cases, beside the step's own.
inline constexpr const char* family_tag = "stability";
bool is_family(const TestRun& test);

/// What these test cases say about a step; of those that failed, the first plain one speaks, else the first
/// family. A step that no test names has failed.
StepResult result_of(const std::string& step, const std::vector<TestRun>& tests);

/// What is known about a chapter without building anything.
struct KnownResult {
    ChapterResult result;
    bool current = false;  ///< no file of the exercise or its tests has changed since it was checked
};

/// An exercise that was not touched is all todo, and current. Never throws for a damaged memory.
KnownResult known_result(const Project& project, const Chapter& chapter);

/// The same of all chapters, in their order.
std::vector<KnownResult> known_results(const Project& project, const std::vector<Chapter>& chapters);

/// Only the results, without what is known of the files.
std::vector<ChapterResult> results_of(const std::vector<KnownResult>& known);

/// Changes with everything that a verdict depends on and a student or teacher may edit.
std::string sources_fingerprint(const Project& project, const Chapter& chapter);

/// Remembers the verdict on a chapter in .course/state.json. `sources` is the fingerprint of what was judged,
/// taken before it was built: who goes on writing meanwhile has not been judged.
void remember(const Project& project, const Chapter& chapter, const ChapterResult& result,
              const std::string& sources);

/// The exercise's file as the student got it: from the solution, else from .course/pristine/ of a handout.
std::optional<std::string> pristine_text(const Project& project, const Chapter& chapter,
                                         const std::string& file);

/// Names of the exercise's files, `*.cpp` of the chapter's directory, sorted.
std::vector<std::string> exercise_files(const Project& project, const Chapter& chapter);

/// Names of those files of the exercise that the student got and that are not there any more.
std::vector<std::string> missing_files(const Project& project, const Chapter& chapter);

/// What to do about a chapter whose files are missing: "chapters/02_spheres/sphere.cpp is missing; …", or
/// nothing.
std::string missing_message(const Project& project, const Chapter& chapter);

/// Whether every file of the exercise is as the student got it.
bool is_untouched(const Project& project, const Chapter& chapter);

}  // namespace rt
