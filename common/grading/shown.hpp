// What a student may see of a grade, and how it is said.
#pragma once

#include "common/grading/grade.hpp"
#include "common/grading/rubric.hpp"

#include <string>
#include <vector>

namespace rt {

/// A grade with nothing in it that its student may not read. `shown_to_student` is where they come from;
/// whatever writes for students takes one, so that no grade gets there by oversight.
struct ShownGrade {
    Grade grade;
    std::optional<Moment> marks_from;  ///< students may see no mark before; nothing where they may already
};

/// Takes away what hidden checks said (until the rubric shows it) and how many there were and passed: of them
/// only remains whether one did not pass; and the seed, from which the random cases come. In every text,
/// names of files lose the directories that lead there from the machine's root, and `private_words`, such as
/// the machine's name or the instructor's, become "…" where they stand as words.
ShownGrade shown_to_student(const Grade& grade, const Rubric& rubric, Moment at,
                            const std::vector<std::string>& private_words);

/// What a step's mark rests on, in some lines of UTF-8 without control characters: the verdict, what was
/// asked, the failing case (its beginning, where it has no end), what hidden checks say if it is there, the
/// hint.
std::string explained(const GradedStep& step);

/// "failed: 5 of 7 checks pass", the first line of that.
std::string verdict_line(const GradedStep& step);

}  // namespace rt
