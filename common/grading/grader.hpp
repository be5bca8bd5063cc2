// A submission's mark: compiled and run in boxes, judged by the chapters' own tests in a process that never
// runs what a student wrote.
#pragma once

#include "common/grading/marks.hpp"
#include "common/grading/rubric.hpp"
#include "common/grading/workshop.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace rt {

struct GraderOptions {
    std::vector<const Chapter*> chapters;  ///< those that are marked
    Rubric rubric;
    std::uint64_t seed = 0;  ///< of the tests' random cases
    Isolation isolation = Isolation::Bubblewrap;
    double call_seconds = 10;    ///< what one call of a function may take, where nothing else runs
    double judge_seconds = 300;  ///< and all tests of a chapter; those that ended before count
};

class Grader {
public:
    /// Builds what all submissions share. Throws InputError if there can be no box at this level.
    Grader(const Project& project, GraderOptions options);

    /// Never throws for what a submission does or is: one that was refused has no marks, and its reason in
    /// each step. Throws GraderFault (run_judge.hpp) where a judge fails. `progress` is told before each
    /// chapter how much of the submission is marked, from 0 to 1.
    Grade grade(const Submission& submission, const std::function<void(double)>& progress = {});

    /// Where what is marked is built; for tests of what goes into it.
    Workshop& workshop() { return workshop_; }

private:
    std::vector<StepRun> run_chapter(const Chapter& chapter, const Submission& submission, Grade& grade);
    void grade_chapter(const Chapter& chapter, const Submission& submission, Grade& grade);

    const Project& project_;
    GraderOptions options_;
    Workshop workshop_;
    int graded_ = 0;
};

}  // namespace rt
