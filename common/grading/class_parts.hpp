// A class marked in parts, at once or on several machines, and put together again.
#pragma once

#include "common/grading/grade.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

struct ClassPart {
    int number = 1;    ///< 1 to `count`
    int count = 1;     ///< of parts
    std::string list;  ///< fingerprint of the names of all the class's submissions
    friend bool operator==(const ClassPart&, const ClassPart&) = default;
};

/// The part that "2/7" asks for of the submissions with these names, in any order. Throws InputError unless
/// it is one of 1/n to n/n, with n at most 100 000.
ClassPart part_named(std::string_view text, const std::vector<std::string>& names);

/// Whether the submission at this position belongs to the part, counted from 0 in the order of names. Every
/// n-th does, so that parts differ by one submission at most; there may be more parts than submissions.
bool is_in(const ClassPart& part, std::size_t position);

/// Kept results of a class, or of a part.
struct GradesFile {
    std::string name;  ///< for messages
    std::vector<Grade> grades;
    std::optional<ClassPart> part{};        ///< nothing: it is no part of anything
    std::vector<std::string> not_marked{};  ///< submissions at which the grader failed
};

/// One class of several files, ordered by the submissions' names. Throws InputError, a line that names both
/// files, for a submission that is in two; for files that were marked by other rubrics, from other seeds, at
/// other levels of isolation or on other steps, which would not be the same class; and unless the files are
/// all the parts of one list, each once, or no parts at all.
std::vector<Grade> merged(const std::vector<GradesFile>& files);

/// The submissions at which the grader failed and whose mark is in none of the files, each once, sorted.
std::vector<std::string> not_marked_in(const std::vector<GradesFile>& files);

}  // namespace rt
