// Lines of solutions, and texts that have one where there must be none.
#pragma once

#include "common/terminal/project.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rt {

/// Where a line of a solution stands.
struct SolutionLine {
    std::string file;  ///< as from the repository's root
    int line = 0;      ///< counted from 1
};

/// The lines that students are to find, by their text with white space folded.
using SolutionLines = std::unordered_map<std::string, SolutionLine>;

/// The lines of at least 12 characters in the marked parts of all solutions, white space folded, but those
/// that also stand in code that is given: common/, the contracts, and what the exercises have of the
/// solutions.
SolutionLines solution_lines(const Project& project);

/// A line of a text that is a line of a solution.
struct Leak {
    int line = 0;  ///< of the text, counted from 1
    SolutionLine solution;
};

/// The text's first line that is one of these, if there is any.
std::optional<Leak> find_leak(const SolutionLines& lines, std::string_view text);

/// The line without blanks at its ends, and one blank for each white space inside.
std::string folded(std::string_view line);

}  // namespace rt
