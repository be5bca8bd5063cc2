// What somebody handed in: the files of the exercises, and nothing else of what lies beside them.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// No file of a submission is larger: 1 MiB.
inline constexpr std::size_t largest_submitted_file = std::size_t{1} << 20;

struct Submission {
    std::string name;  ///< of its directory
    /// Text by the exercise's file as from the root, such as "chapters/02_spheres/sphere.cpp".
    std::map<std::string, std::string> files;
    /// What was not taken, a line each: "chapters/02_spheres/sphere.cpp is a symbolic link".
    std::vector<std::string> remarks;
};

/// "chapters/02_spheres/sphere.cpp".
std::string exercise_path(const Chapter& chapter, std::string_view file);

/// Names of the chapter's files that students write, each once, in the order of the steps.
std::vector<std::string> files_of_steps(const Chapter& chapter);

/// What a submission in this directory is called: the directory's own name.
std::string name_of_submission(const std::filesystem::path& directory);

/// Reads the exercises of these chapters from a directory: a student's whole tree, or the exercises' files
/// alone, in directories named as the chapters or all in one. Only regular files count; no symbolic link is
/// followed, not even of a directory. What is missing is left out. Throws InputError if the directory cannot
/// be read, or is empty of exercises.
Submission read_submission(const std::filesystem::path& directory,
                           const std::vector<const Chapter*>& chapters);

/// Changes with the text of any file.
std::string digest_of(const Submission& submission);

}  // namespace rt
