// Files of the course that nobody has to touch - headers, tests, lessons, scenes -, and which of them were
// changed.
#pragma once

#include "common/terminal/project.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A given file that is not as the course has it.
struct ChangedGiven {
    std::string path;      ///< as from the repository's root
    bool missing = false;  ///< it was deleted
};

/// The changed files, and where in git's history they are as the course has them.
struct GivenChanges {
    std::vector<ChangedGiven> files;
    std::string commit;      ///< "HEAD", or the commit in which a handout or the branch upstream has them
    bool committed = false;  ///< some were committed as they are now
    bool staged = false;     ///< something is to be committed, perhaps one of them
};

/// Compares with a handout as it was handed out or brought up to date, else with the branch upstream, else
/// with the last commit. Exercises are the student's, and lessons may have notes in them. Nothing where git
/// does not know this directory, or where its setting course.maintainer says that given files are changed on
/// purpose.
GivenChanges given_changes(const Project& project);

/// The same of what git says: `status` is the output of `git diff --name-status -z --no-renames`.
std::vector<ChangedGiven> changed_given(std::string_view status);

/// "common/math/ray.hpp is not as the course has it; git restore common/math/ray.hpp brings it back", and how
/// many more; empty if there are none.
std::string given_in_words(const GivenChanges& changes);

/// The command of git that brings these files back.
std::string restore_command(const GivenChanges& changes);

/// Brings back the given files of a chapter that were deleted, and tells which. `number` as a command line
/// has it.
std::vector<std::string> restore_missing(const Project& project, std::string_view number);

}  // namespace rt
