// Where submissions become programs: the course's own parts are built once, a student's files in a box.
#pragma once

#include "common/grading/submission.hpp"
#include "common/sandbox/sandbox.hpp"
#include "common/terminal/staged_directory.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt {

/// A program that answers calls of one chapter as a student wrote it, of all others as the solutions do.
struct BuiltWorker {
    std::filesystem::path program;              ///< empty where nothing could be built
    std::map<std::string, std::string> errors;  ///< the compiler's first one, by the exercise's file
    std::uint64_t peak_memory = 0;              ///< bytes, of the compiler
};

/// Builds the program that looks after boxes. Throws InputError, with the reason, if it does not build, or if
/// there can be no box at this level.
void prepare_boxes(const Project& project, Isolation isolation);

class Workshop {
public:
    /// Builds what all submissions share, and the judges of these chapters.
    Workshop(const Project& project, const std::vector<const Chapter*>& chapters, Isolation isolation);

    /// A place for all that is worked at, which everybody may read and which is removed with the workshop.
    const std::filesystem::path& place() const { return shared_.path; }

    /// Compiles a chapter of a submission, and links it into `directory`, which everybody may read. A file
    /// that is missing, or that does not compile, is as the student got it. Compiling costs at most
    /// `compiler_limits` a file.
    BuiltWorker build(const Chapter& chapter, const Submission& submission,
                      const std::filesystem::path& directory);

private:
    struct Compiled {
        std::filesystem::path object;
        std::string error;  ///< the compiler's first one; empty if there is an object
        std::uint64_t peak_memory = 0;
    };
    /// Gets ready what all submissions are compiled and linked with; done when the first one is.
    void furnish();
    /// Of one file, which is compiled when it is first asked for: the same text gives the same object.
    const Compiled& compiled(const Chapter& chapter, const std::string& file, const std::string& text);
    /// Of an exercise as students get it.
    std::filesystem::path pristine_object(const Chapter& chapter, const std::string& file);
    /// Of a submission's file, or the pristine one in its place; an error goes into `built`.
    std::filesystem::path object_of(const Chapter& chapter, const Submission& submission,
                                    const std::string& file, BuiltWorker& built);
    /// The linker's first error; empty where `directory`/worker is there now.
    std::string link(const Chapter& chapter, const std::vector<std::filesystem::path>& objects,
                     const std::filesystem::path& directory, std::uint64_t& peak_memory);

    const Project& project_;
    std::vector<std::string> numbers_;  // of all chapters
    Isolation isolation_;
    StagedDirectory shared_;  // include/ and lib/, and what is worked at
    bool is_furnished_ = false;
    std::map<std::string, Compiled> compiled_;
};

}  // namespace rt
