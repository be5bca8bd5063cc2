// A class's marks: those that are kept, and those that are given now.
#pragma once

#include "common/grading/kept_grades.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rt {

/// `Grader::grade`.
using Marking = std::function<Grade(const Submission&, const std::function<void(double)>& progress)>;

struct ClassMarks {
    std::vector<Grade> grades;            ///< in the order of the submissions
    std::vector<std::string> not_marked;  ///< names of those at which the grader failed
};

/// The marks of these submissions. Those that are not kept yet are given by `mark`, with progress in a
/// terminal, and kept. Where the grader fails (GraderFault), that submission has no mark, and standard error
/// says why; whoever makes results of the others says that they lack it.
ClassMarks marks_of(const std::vector<Submission>& submissions, const KeptGrades& kept, const Marking& mark);

}  // namespace rt
