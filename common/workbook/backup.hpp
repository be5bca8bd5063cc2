// Copies of what a person has written, kept when something else takes its place.
#pragma once

#include <filesystem>
#include <string>

namespace rt {

/// Keeps a text as x.cpp.001.backup, or with the first number that is free, and returns that name. The backup
/// is whole or not there. The memory's lock (common/terminal/lock.hpp) must be held, so that no other process
/// takes the same number.
std::filesystem::path keep_backup(const std::filesystem::path& file, const std::string& text);

}  // namespace rt
