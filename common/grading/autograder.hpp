// Gradescope's autograder: the archive that an instructor uploads there, and what its scripts ask of the
// program.
#pragma once

#include "common/grading/grader.hpp"

#include <cstddef>
#include <filesystem>

namespace rt {

/// Writes the archive, a zip, whole or not at all: all of the course that is built, with solutions and tests,
/// without what .gitignore names; the rubric; and the scripts setup.sh and run_autograder, which mark these
/// chapters from this seed at this level. `rubric` is the file that `options.rubric` was read from; empty for
/// none. Returns how many files are in it. Throws InputError where it cannot be written, or git or bsdtar is
/// not installed.
std::size_t make_autograder(const Project& project, const std::filesystem::path& archive,
                            const GraderOptions& options, const std::filesystem::path& rubric);

/// Marks `submission` in Gradescope's directory `place`, which is /autograder there, and writes
/// `results/results.json` there, whole. When it was handed in, submission_metadata.json says. What has no
/// exercises gets results, too, which tell its student so. Throws for all that is the grader's fault.
void mark_for_gradescope(const Project& project, const std::filesystem::path& place,
                         const GraderOptions& options);

}  // namespace rt
