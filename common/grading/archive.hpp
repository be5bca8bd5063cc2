// Archives that students hand in, opened in a box: who reads them must trust them no more than the programs
// in them.
#pragma once

#include "common/grading/submission.hpp"
#include "common/sandbox/sandbox.hpp"

#include <filesystem>
#include <vector>

namespace rt {

/// As `read_submission`, from an archive of any form that libarchive knows (zip, tar.gz, 7z, ...). bsdtar
/// opens it in a box of this level, at most `unpacking_limits`; what comes out of the box are the exercises'
/// files and nothing else. No time in an archive is believed. Throws BadSubmission for what is no archive,
/// broken or encrypted, or unpacks to more than the limits, and another InputError if the file cannot be read
/// or bsdtar is not installed.
Submission read_archive(const std::filesystem::path& archive, const std::vector<const Chapter*>& chapters,
                        Isolation isolation);

/// What unpacking may use up. The list of an archive's files is its output.
Limits unpacking_limits();

/// A directory or an archive. A bad submission has no files, and its reason in `refused`.
Submission read_handed_in(const std::filesystem::path& path, const std::vector<const Chapter*>& chapters,
                          Isolation isolation);

}  // namespace rt
