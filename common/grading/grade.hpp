// The mark of one submission with all that explains it, as plain data.
#pragma once

#include "common/grading/points.hpp"
#include "common/grading/time_stamp.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

enum class Verdict {
    Passed,
    Failed,
    Todo,
    Crashed,
    TimedOut,
    TooMuchMemory,
    NotCompiled,
    NeedsStep,
    NotTaken
};

/// "passed", "failed", "todo", "crashed", "timed out", "too much memory", "not compiled", "needs another
/// step", or "not taken": the whole submission could not be read.
std::string_view name_of(Verdict verdict);
std::optional<Verdict> verdict_named(std::string_view name);

/// How many checks there were, and how many of them passed.
struct CheckCount {
    int passed = 0;
    int all = 0;
    friend bool operator==(const CheckCount&, const CheckCount&) = default;
};

/// A check that did not pass. Both texts are bytes: what a student's program printed may stand in them.
struct FailedCheck {
    std::string asked;  ///< the check's sentence; empty where none was reached
    std::string
        said;  ///< the failing case in words and numbers, the compiler's error, or how the program ended
    friend bool operator==(const FailedCheck&, const FailedCheck&) = default;
};

struct GradedStep {
    std::string id;  ///< "02.1"
    std::string title;
    std::string file;  ///< of the exercise, "chapters/02_spheres/quadratic.cpp"
    Points possible;
    Points earned;           ///< with everything that the rubric takes from them
    bool extra = false;      ///< extra credit: `possible` is not part of the submission's
    int late_percent = 100;  ///< of the points that were left to a submission at this time
    Verdict verdict = Verdict::Todo;
    std::string needs;                   ///< the step that must be done first, where `verdict` is NeedsStep
    CheckCount checks;                   ///< those that students may see
    CheckCount hidden;                   ///< those that they may not
    std::optional<FailedCheck> failure;  ///< that students may see
    std::optional<FailedCheck> hidden_failure;  ///< for the instructor
    int hint = 0;                               ///< number of the hint to read next; 0 for none
    std::string difference;                     ///< the difference picture as bytes of a PNG; empty for none
    friend bool operator==(const GradedStep&, const GradedStep&) = default;
};

struct Grade {
    std::string submission;           ///< its name; bytes, such as a directory's
    std::string digest;               ///< of its files: `fingerprint` in common/terminal/project.hpp
    std::string rubric;               ///< digest of the rubric that it was marked by
    std::uint64_t seed = 0;           ///< of the random cases: with it the mark can be made again
    std::string isolation;            ///< the level, in words
    double seconds = 0;               ///< from the beginning of its compilation to its last check
    std::int64_t peak_bytes = 0;      ///< of memory, of compiler and checks
    std::optional<Moment> submitted;  ///< nothing where it is not known; then it is not late
    Moment graded{};
    std::vector<GradedStep> steps;  ///< of all chapters that were marked, in their order
    friend bool operator==(const Grade&, const Grade&) = default;
};

/// Sums over the steps; extra credit counts as earned, and not as possible.
Points earned(const Grade& grade);
Points possible(const Grade& grade);

/// "02" of "02.1".
std::string chapter_of(const GradedStep& step);

}  // namespace rt
