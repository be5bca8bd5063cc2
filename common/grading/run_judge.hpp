// Runs a judge: the process in which a chapter's tests stand, and nothing that a student wrote.
#pragma once

#include "common/sandbox/sandbox.hpp"
#include "common/workbook/results.hpp"

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

/// What a judge is told (tests/grading/judge.cpp, tests/grading/picture.cpp).
struct JudgeOptions {
    std::filesystem::path worker;  ///< the program that answers the tests' calls
    Isolation isolation = Isolation::Bubblewrap;
    double call_seconds = 10;                   ///< what one call may take, where nothing else runs
    double judge_seconds = 300;                 ///< and all of them
    std::uint64_t seed = 0;                     ///< of the tests' random cases
    std::filesystem::path pictures;             ///< where difference pictures go; a directory
    std::vector<std::filesystem::path> scenes;  ///< of the chapter's pictures
};

/// What is no submission's fault. The text is a line for the instructor; nobody loses a mark by it.
struct GraderFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Runs a judge on all its tests, or on those that Catch2 finds by these words, and returns its report, in
/// which all of them have ended. A worker that crashes, hangs or answers nonsense ends a test, never the
/// judge: a judge that comes to no end is a GraderFault. What it says itself of that goes to standard error.
TestReport run_judge(const std::filesystem::path& judge, const std::filesystem::path& report,
                     const JudgeOptions& options, const std::vector<std::string>& tests = {});

}  // namespace rt
