// The forms in which results leave the house: for systems that students read, and for the instructor.
#pragma once

#include "common/grading/class_parts.hpp"
#include "common/grading/grade.hpp"
#include "common/grading/shown.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

// ------------------------------------------------------------------------------- what students may read
// Each takes grades as students may see them. Those of systems that cannot keep a mark back until a date
// throw InputError where the rubric wants that.

/// Gradescope's results.json, a test a step; before the rubric's date visible only after publishing.
std::string gradescope(const ShownGrade& shown);

/// Lines NAME=VALUE for a step's outputs in a workflow of GitHub's: `runners`, and for each of them, one a
/// chapter, what the reporter of GitHub Classroom reads, in base64. Their scores add up to the points earned.
std::string github_classroom(const ShownGrade& shown);

/// What Classroom 50 knows of a submission and a grade does not; all may be empty.
struct Classroom50Names {
    std::string classroom, assignment, commit, release, review;
};

/// Classroom 50's result.json. Points there are whole numbers: halves are rounded up, step by step.
std::string classroom50(const ShownGrade& shown, const Classroom50Names& names);

/// PrairieLearn's results.json, at most `most_prairielearn` bytes: where it would be more, the largest
/// difference pictures are left out first, then the longest texts. What was not taken, or does not compile
/// and has earned nothing, is not gradable, which there costs no attempt; where other files have earned
/// something, that is kept.
std::string prairielearn(const ShownGrade& shown);
inline constexpr std::size_t most_prairielearn = 1'000'000;

/// The two last lines of an Autolab autograder's output: the feedback, and the scores, a problem a step.
std::string autolab(const ShownGrade& shown);

/// JUnit's XML: a suite a submission, a case a step. Characters that XML 1.0 forbids are escaped.
std::string junit_xml(const std::vector<ShownGrade>& shown);

// --------------------------------------------------------------------------------- what instructors read

/// A row a submission, a column a step (RFC 4180). No field begins a formula: where it would, it has an
/// apostrophe in front. The grades are of one class (`merged`).
std::string csv(const std::vector<Grade>& grades);

/// One page, nothing loaded from elsewhere: the class at a glance, common mistakes, the slowest, the crashed,
/// and behind each row its student's page; and who lacks a mark because the grader failed. The grades are of
/// one class.
std::string class_page(const std::vector<Grade>& grades, const std::vector<std::string>& not_marked = {});

// ------------------------------------------------------------------------------------------ all by name

/// What a format may need to know.
struct FormatRequest {
    std::vector<Grade> grades;  ///< of one class
    Rubric rubric;
    Moment at{};                             ///< when students read it
    std::vector<std::string> private_words;  ///< see `shown_to_student`
    Classroom50Names classroom50;
    std::optional<ClassPart> part{};        ///< of a class that the grades are, if they are not all of it
    std::vector<std::string> not_marked{};  ///< submissions at which the grader failed
};

struct Format {
    std::string_view name;   ///< on the command line
    std::string_view about;  ///< a line of help
    std::string (*text)(const FormatRequest& request);
};

/// All of them, in the order of their help.
const std::vector<Format>& formats();

/// The one with this name; throws InputError, which lists the names, if there is none.
const Format& find_format(std::string_view name);

}  // namespace rt
