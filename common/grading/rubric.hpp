// What an instructor wants of marks: points, parts of them, late work, extra credit, and what students see
// when.
#pragma once

#include "common/grading/points.hpp"
#include "common/grading/time_stamp.hpp"
#include "common/workbook/catalogue.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// What a step gives where some of its checks pass: nothing, or the same part of its points.
enum class Credit { All, Part };

struct StepRubric {
    Points points;
    Credit credit = Credit::All;
    bool extra = false;               ///< its points come on top of what is possible
    std::vector<std::string> hidden;  ///< checks that no student sees: by name, or "[tag]"
};

/// What is left of the points at most `hours` after the date that they were due.
struct LateRule {
    std::int64_t hours = 0;
    int percent = 100;
};

struct Rubric {
    std::map<std::string, StepRubric> steps;  ///< of every step, by its number
    std::map<std::string, Moment> due;        ///< by the chapter's number; a chapter without is never late
    std::vector<LateRule> late;               ///< by hours; after the last rule's nothing is left
    std::optional<Moment> marks_from;   ///< students see their marks from then; at once if there is none
    std::optional<Moment> hidden_from;  ///< and what hidden checks say; never if there is none
};

/// The rubric of an instructor who has written none: points as the chapters say, all or nothing, never late,
/// nothing hidden.
Rubric default_rubric(const std::vector<Chapter>& chapters);

/// The rubric in a `grading.json`, whose form is common/grading/rubric.schema.json; what it leaves out is as
/// in the default. Throws InputError, one line with file, line, column and key, for what is not of that form
/// and for chapters and steps that there are not.
Rubric read_rubric(const std::string& file, const std::string& text, const std::vector<Chapter>& chapters);

/// Changes with everything in a rubric that a mark depends on.
std::string digest_of(const Rubric& rubric);

/// What is left of a chapter's points, in per cent, to what was submitted then.
int late_percent(const Rubric& rubric, const std::string& chapter, const std::optional<Moment>& submitted);

}  // namespace rt
