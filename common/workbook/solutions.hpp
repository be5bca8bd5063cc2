// Whether the solutions are here: the course's own tree has them, a handout has not.
#pragma once

#include "common/terminal/project.hpp"

#include <string_view>

namespace rt {

/// Whether this tree has solutions.
bool has_solutions(const Project& project);

/// Throws InputError in a tree without solutions. `what` needs them, such as "./course tour".
void require_solutions(const Project& project, std::string_view what);

}  // namespace rt
