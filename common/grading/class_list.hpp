// A class as it was handed in: its directories and archives, listed and read.
#pragma once

#include "common/grading/class_parts.hpp"
#include "common/grading/submission.hpp"
#include "common/sandbox/sandbox.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// Directories and archives in the order of the submissions' names, and those names.
struct ClassList {
    std::vector<std::string> names;
    std::vector<std::filesystem::path> paths;
};

/// Throws InputError if there are none, or two of the same name.
ClassList class_list(const std::vector<std::filesystem::path>& paths);

/// Reads the submissions of a part, or all, in the list's order. What is not taken of them, and those that
/// are bad as a whole, are told on standard error, a line each. Archives are opened in boxes of this level,
/// which are built if there are any. Throws InputError for what is not there, and where there can be no box.
std::vector<Submission> read_class(const ClassList& list, const std::optional<ClassPart>& part,
                                   const Project& project, const std::vector<const Chapter*>& chapters,
                                   Isolation isolation);

}  // namespace rt
