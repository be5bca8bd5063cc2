// What of this machine's files a process may touch where it cannot have a file system of its own.
#pragma once

#include "common/sandbox/sandbox.hpp"

#include <string>
#include <vector>

namespace rt {

/// Lets this process and all that it becomes read and execute what is below the mounts, write what is below
/// `scratch`, and use /dev/null and its like; nothing else. By Landlock; a kernel without it restricts
/// nothing, which `open_at` says. Needs no_new_privs. False, with errno, if it failed.
bool restrict_files(const std::vector<Mount>& mounts, const std::string& scratch);

}  // namespace rt
