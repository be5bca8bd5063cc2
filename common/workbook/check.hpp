// Builds and tests chapters; a compile error, a crash or a hang costs what it must and no more.
#pragma once

#include "common/terminal/process.hpp"
#include "common/workbook/own_code.hpp"
#include "common/workbook/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

struct BuildResult {
    bool ok = false;
    std::string message;  ///< the compiler's first error in one line, else what the build said last
    std::string output;
};

/// Builds targets, with progress on a terminal. Without `keep_going` it stops at the first error.
BuildResult build_targets(const Project& project, const std::vector<std::string>& targets,
                          const std::string& label, bool keep_going = false);

/// The one line of a failed build's output that says what is wrong, paths as from the repository's root; of a
/// function that a chapter's contract declares and nobody has written, which step's it is.
std::string first_error(const Project& project, const std::string& output);

/// How a test program ended.
struct TestOutcome {
    TestReport report;
    std::string death;  ///< "crashed (segmentation fault)"; empty if it came to its end
    double seconds = 0;
    std::string output{};  ///< what it printed, its beginning
    std::string
        place{};  ///< where a student's code was when it died, and why, in words; empty if nobody knows
};

/// "crashed (segmentation fault) in the test "two roots"", and in a second line where in the student's code.
std::string death_in_words(const TestOutcome& outcome);

/// Runs a program of tests/main.cpp with these arguments, and has it write its report into a file.
TestOutcome run_tests(const std::filesystem::path& program, const std::filesystem::path& report,
                      const std::vector<std::string>& arguments, const ProcessOptions& options);

/// Runs a test program on all its tests, or on those with and without some tags, such as
/// "[02.1]~[stability]", and finds out where it died. `time_limit` in seconds, 0 for none.
TestOutcome run_test_program(const Project& project, const std::string& name, const std::string& tags,
                             bool quick, double time_limit);

/// Tests a program of a chapter that is built: all its steps, one at a time after a crash or a hang.
ChapterResult judge_program(const Project& project, const Chapter& chapter, const std::string& name);

/// Builds and tests these chapters, the student's code or the solutions, each in its turn. The student's
/// results are remembered.
std::vector<ChapterResult> check_chapters(const Project& project, const std::vector<const Chapter*>& chapters,
                                          bool solutions);

/// What is known of all these chapters, after those that changed since they were checked are checked again.
std::vector<ChapterResult> checked_results(const Project& project, const std::vector<Chapter>& chapters);

/// Chapters whose steps have all passed, of those results.
std::vector<const Chapter*> passing_chapters(const Project& project, const std::vector<Chapter>& chapters);

/// Builds the program course_mine with this code in place of the solutions.
BuildResult build_mine(const Project& project, const OwnCode& own);

/// The program that builds with the student's code tells itself so in this variable, in_words(OwnCode).
inline constexpr const char* mine_variable = "COURSE_MINE_LINKED";

}  // namespace rt
