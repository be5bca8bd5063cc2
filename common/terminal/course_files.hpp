// Which files are the course's.
#pragma once

#include "common/terminal/project.hpp"

#include <string>
#include <vector>

namespace rt {

/// The files of the course as from its root, without those that .gitignore names. Throws InputError where
/// git, which reads .gitignore, is not installed.
std::vector<std::string> course_files(const Project& project);

}  // namespace rt
