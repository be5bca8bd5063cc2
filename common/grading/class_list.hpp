// A class as a command names it: directories and archives, one a student, and what they have handed in.
#pragma once

#include "common/grading/sandbox.hpp"
#include "common/grading/submission.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// A class's directories and archives in the order of the submissions' names, and those names.
struct ClassList {
    std::vector<std::string> names;
    std::vector<std::filesystem::path> paths;
};

/// Throws InputError if there are none, or two of the same name.
ClassList class_list(const std::vector<std::filesystem::path>& paths);

/// What students have handed in in these directories and archives; archives are opened in boxes of this
/// level. A line is said for each file that is not taken. Throws the InputError of what cannot be read, is no
/// archive, or has no exercises; where there are several, each is said, and how many they are is thrown.
std::vector<Submission> read_submissions(const Project& project,
                                         const std::vector<std::filesystem::path>& paths,
                                         const std::vector<const Chapter*>& chapters, Isolation isolation);

}  // namespace rt
