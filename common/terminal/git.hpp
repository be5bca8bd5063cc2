// Git, without what the person who runs it has set.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Runs git with these arguments and returns what it says. No configuration but a repository's own is read,
/// no hooks run, and the variables that lead git elsewhere are not set. Throws InputError with git's last
/// line where it fails, or is not installed.
std::string git(const std::vector<std::string>& arguments);

}  // namespace rt
