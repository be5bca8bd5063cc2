// A class's marks: those that are kept, and those that are given now.
#pragma once

#include "common/grading/kept_grades.hpp"

#include <functional>
#include <vector>

namespace rt {

/// `Grader::grade`.
using Marking = std::function<Grade(const Submission&, const std::function<void(double)>& progress)>;

/// The marks of these submissions, in their order. Those that are not kept yet are given by `mark`, with
/// progress in a terminal, and kept. Where the grader fails (GraderFault), that submission is told on
/// standard error and has no mark, and all others are marked and kept; then throws InputError, a line for the
/// instructor: no result is made that lacks somebody.
std::vector<Grade> marks_of(const std::vector<Submission>& submissions, const KeptGrades& kept,
                            const Marking& mark);

}  // namespace rt
