// What of the instructor's machine no student may read.
#pragma once

#include "common/terminal/project.hpp"

#include <string>
#include <vector>

namespace rt {

/// Directories (the project's, this user's, the one for temporary files) and names (the machine's, this
/// user's) as `shown_to_student` wants them, each before those that it contains. Names that everybody has,
/// such as "root" and "localhost", tell nothing and stand in honest messages; they are left out.
std::vector<std::string> private_words(const Project& project);

}  // namespace rt
