// From what a step's checks said to its points: the rubric applied, in whole numbers.
#pragma once

#include "common/grading/grade.hpp"
#include "common/grading/rubric.hpp"
#include "common/workbook/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// What kept a step's checks from coming to their end.
struct Stop {
    Verdict verdict = Verdict::Crashed;  ///< Crashed, TimedOut, TooMuchMemory, NotCompiled or NotTaken
    std::string why;                ///< "segmentation fault", "did not finish in 10 s", the compiler's error
    std::optional<TestRun> during;  ///< the check that was running, if one was
};

/// What came of running a step's checks.
struct StepRun {
    std::vector<TestRun> ended;      ///< with what each of them said
    std::vector<TestRun> not_ended;  ///< all others that the step has; only name and tags are read
    std::optional<Stop> stop;
    std::string difference;  ///< bytes of a PNG, or none
};

/// The step's mark. With `Credit::All` it has all of its points if every check ended and passed and nothing
/// stopped them, with `Credit::Part` as many of them as of its checks passed, hidden ones counted like
/// others; of that `late_percent`; rounded to a hundredth of a point once, halves up. A step without any
/// check has failed.
GradedStep marked(const Chapter& chapter, const Step& step, const StepRubric& rubric, int late_percent,
                  const StepRun& run);

/// Whether students may not see this check.
bool is_hidden(const StepRubric& rubric, const TestRun& check);

/// What the rubric hides in a step that has no such check: somebody believes it to be hidden. As "02.1: a
/// name".
std::vector<std::string> hides_nothing(const Rubric& rubric, const std::vector<TestRun>& checks);

}  // namespace rt
