// Grades as JSON, the class's kept results: what is written is read back the same, whatever bytes it holds.
#pragma once

#include "common/grading/class_parts.hpp"
#include "common/grading/grade.hpp"
#include "common/terminal/json_source.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// As common/grading/grades.schema.json says of one of them. A text that is not UTF-8 becomes an object with
/// its bytes in base64.
nlohmann::ordered_json to_json(const Grade& grade);

/// What `to_json` wrote. Throws InputError with file, line, column and key for everything else.
Grade grade_from(const JsonValue& value);

/// Kept results of a class: {"version":1,"grades":[…]}, a line a submission, in the order of their names. Of
/// the same grades in any order the text has the same bytes. A part of a class says which one it is, and
/// results that lack somebody at whom the grader failed say whom.
std::string grades_text(std::vector<Grade> grades, const std::optional<ClassPart>& part = {},
                        const std::vector<std::string>& not_marked = {});

/// What `grades_text` wrote, all or nothing. Throws InputError also for a submission that is in it twice.
GradesFile read_grades_file(const std::string& file, const std::string& text);

/// Its grades alone.
std::vector<Grade> read_grades(const std::string& file, const std::string& text);

}  // namespace rt
