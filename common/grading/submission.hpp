// What somebody handed in: the files of the exercises, and nothing else of what lies beside them.
#pragma once

#include "common/grading/time_stamp.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/catalogue.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// No file of a submission is larger: 1 MiB.
inline constexpr std::size_t largest_submitted_file = std::size_t{1} << 20;

struct Submission {
    std::string name;  ///< of its directory, or of its archive without the ending
    /// Text by the exercise's file as from the root, such as "chapters/02_spheres/sphere.cpp".
    std::map<std::string, std::string> files;
    /// What was not taken, a line each: "chapters/02_spheres/sphere.cpp is a symbolic link".
    std::vector<std::string> remarks;
    /// When it was handed in, if somebody has said so: files carry whatever times their owner wants.
    std::optional<Moment> submitted = std::nullopt;
    /// Why nothing of it can be marked, as what follows its name: "is encrypted"; empty where something can.
    std::string refused{};
};

/// What was handed in cannot be marked as it is, and whoever did so must be told why.
struct BadSubmission : InputError {
    BadSubmission(const std::filesystem::path& path, const std::string& what_it_is);
    std::string why;  ///< as `Submission::refused`
};

/// "chapters/02_spheres/sphere.cpp".
std::string exercise_path(const Chapter& chapter, std::string_view file);

/// Names of the chapter's files that students write, each once, in the order of the steps.
std::vector<std::string> files_of_steps(const Chapter& chapter);

/// What a submission in this directory or archive is called: the directory's own name, the archive's without
/// its ending.
std::string name_of_submission(const std::filesystem::path& path);

/// Where an exercise may be in what was handed in, from its top; the first that is there counts.
std::vector<std::string> places_of(const Chapter& chapter, std::string_view file);

/// Reads the exercises of these chapters from a directory: a student's whole tree, or the exercises' files
/// alone, in directories named as the chapters or all in one; or from the only directory in it that has them.
/// Only regular files count; no symbolic link is followed, not even of a directory. What is missing is left
/// out. Throws BadSubmission if the directory is empty of exercises or has them in several directories, and
/// another InputError if it cannot be read.
Submission read_submission(const std::filesystem::path& directory,
                           const std::vector<const Chapter*>& chapters);

/// What has no exercises.
BadSubmission without_exercises(const std::filesystem::path& path,
                                const std::vector<const Chapter*>& chapters);

/// Changes with the text of any file, and with the reason why there is none.
std::string digest_of(const Submission& submission);

}  // namespace rt
