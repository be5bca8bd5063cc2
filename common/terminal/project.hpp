// Where things are: the repository and its build directory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

struct Project {
    std::filesystem::path root;   ///< the repository
    std::filesystem::path build;  ///< where CMake builds it
};

/// The repository that this program was built from.
Project this_project();

/// A program of the build, such as "check_02": the one that this process has built, if it has (lock.hpp).
std::filesystem::path program(const Project& project, std::string_view name);

/// A file of what nobody could work out again if it were lost, such as "state.json": in .course/, which no
/// build deletes. One that an earlier version of the course left in the build directory is moved there.
std::filesystem::path memory(const Project& project, std::string_view name);

/// The path as a person at the repository's root would write it; unchanged if it is outside.
std::string relative(const Project& project, const std::filesystem::path& path);

/// Files of a directory with one of these endings, such as ".cpp", or all for none; sorted, and none if there
/// is no such directory. Directories are no files.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& directory,
                                            const std::vector<std::string>& endings = {});

/// FNV-1a (Fowler, Noll & Vo), 64 bits, as 16 hexadecimal digits: tells whether a text has changed.
std::string fingerprint(std::string_view text);

}  // namespace rt
