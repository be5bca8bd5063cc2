// From an annotated solution to the exercise that a student starts with.
// Light on purpose: the build runs it before anything else is compiled.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A marked part of a solution: `// [exercise NN.S] task` up to `// [/exercise]`.
struct ExerciseRegion {
    std::string step;    ///< such as "02.1"
    int first_line = 0;  ///< of the opening marker, counted from 1
    int last_line = 0;   ///< of the closing marker
};

/// Whether `text` has the form of a step's number: two digits, a point, one or two digits.
bool is_step_id(std::string_view text);

/// The marked parts of a solution, in order. `file` is its name for messages. Throws InputError, with file
/// and line, for a marker that is malformed, nested, not opened or not closed, and for a part without task or
/// code.
std::vector<ExerciseRegion> exercise_regions(std::string_view solution, const std::string& file);

/// The exercise that stands for a solution: every marked part becomes its task as a comment and
/// `return todo("NN.S");`, and the header that declares `todo` is included if it was not. A solution without
/// marks is its own exercise. Throws as `exercise_regions` does.
std::string exercise_text(std::string_view solution, const std::string& file);

/// The solution as a reader wants it: the marker lines gone, the tasks' comments too.
std::string solution_text(std::string_view solution, const std::string& file);

/// Every `from` becomes `to`.
void replace_all(std::string& text, const std::string& from, const std::string& to);

/// Text cut at line ends, which are dropped; a last line without an end counts.
std::vector<std::string> split_lines(std::string_view text);

}  // namespace rt
