// Handouts: a class's copy of the course without solutions, made once and kept up to date.
#pragma once

#include "common/terminal/project.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// What is asked of a handout.
struct HandoutOptions {
    std::string chapters;         ///< "1-5": from the first to another, or "1"; empty: all, or as it was
    std::filesystem::path about;  ///< file of the class's names and dates; empty: none, or as it was
};

struct MadeHandout {
    std::vector<std::string> chapters;  ///< numbers of those that are not hidden
    std::size_t files = 0;
};

/// Makes `directory`: the files of a handout (handout_files.hpp) in a git repository with one commit, so that
/// students can take changes back. It is filled beside its place and appears whole or not at all. Throws
/// InputError, and leaves nothing, if there is something at that place, for chapters that there are not or
/// that leave out one on which they stand, for a file of the class that is wrong, where a line of a solution
/// would be in it, and without git.
MadeHandout make_handout(const Project& project, const std::filesystem::path& directory,
                         const HandoutOptions& options);

/// A file that an update has left as the student had it, or kept a copy of, and why, in one line.
struct KeptFile {
    std::string path;
    std::string why;
};

struct UpdatedHandout {
    std::vector<std::string> chapters;
    std::vector<std::string> written, removed;
    std::vector<KeptFile> kept;
};

/// Brings a handout, or a student's copy of one, up to date with the course. What was given is replaced, what
/// students write is left alone:
///  - an exercise that the student has changed stays; if it has changed in the course, too, `course reset`
///    brings the new one from now on, and it is one of `kept`;
///  - one that nobody has touched becomes the new one; one that was deleted stays deleted;
///  - a given file that was changed there stays if the course's is what it was; else the course's is written,
///    what was there is kept in a backup beside it, and it is one of `kept`;
///  - files that the course does not have any more are removed, if they are as they were handed out.
/// Chapters that are seen cannot be hidden. Nothing is committed. Each file is whole at any time, and an
/// update that was interrupted is finished by the next. Throws InputError, and changes nothing, for a
/// directory that is no handout, where a symbolic link is in the way (it could lead anywhere), and as
/// make_handout does.
UpdatedHandout update_handout(const Project& project, const std::filesystem::path& directory,
                              const HandoutOptions& options);

}  // namespace rt
