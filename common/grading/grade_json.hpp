// Grades as JSON, the class's kept results: what is written is read back the same, whatever bytes it holds.
#pragma once

#include "common/grading/grade.hpp"
#include "common/grading/json_source.hpp"

#include <string>
#include <vector>

namespace rt {

/// As common/grading/grades.schema.json says of one of them. A text that is not UTF-8 becomes an object with
/// its bytes in base64.
nlohmann::ordered_json to_json(const Grade& grade);

/// What `to_json` wrote. Throws InputError with file, line, column and key for everything else.
Grade grade_from(const JsonValue& value);

/// Kept results of a class: {"version":1,"grades":[…]}, a line a submission, in the order of their names. Of
/// the same grades in any order the text has the same bytes.
std::string grades_text(std::vector<Grade> grades);

/// What `grades_text` wrote, all or nothing. Throws InputError also for a submission that is in it twice.
std::vector<Grade> read_grades(const std::string& file, const std::string& text);

/// Kept results of parts of a class.
struct GradesFile {
    std::string name;  ///< for messages
    std::vector<Grade> grades;
};

/// One class of several parts, ordered by the submissions' names. Throws InputError, a line that names both
/// files, for a submission that is in two, and for parts that were marked by other rubrics, from other seeds
/// or on other steps: those would not be the same class.
std::vector<Grade> merged(const std::vector<GradesFile>& files);

}  // namespace rt
