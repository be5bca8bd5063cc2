// Where in a student's code a test program crashed, or was when its time was over.
#pragma once

#include "common/terminal/project.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A call that had begun and not ended.
struct Frame {
    std::string function;  ///< "refine"
    std::string file;      ///< as from the repository's root
    int line = 0;
};

/// The calls of a student's functions in what addr2line(1) has said (with -a -f -i -C), the innermost first.
std::vector<Frame> student_frames(const Project& project, std::string_view output);

/// "in refine, chapters/09_grids/build.cpp:31", or "refine called itself without end, …"; nothing where no
/// frame is.
std::string frames_in_words(const std::vector<Frame>& frames);

/// The same of a program that stopped at these places of its file. Nothing if they are not a student's, or
/// cannot be told.
std::string stopped_in_words(const Project& project, const std::filesystem::path& program,
                             const std::vector<std::string>& addresses);

/// What a check of the standard library has found wrong before it ended the program: "an index is out of
/// range". Empty if it says nothing.
std::string broken_rule(std::string_view printed);

}  // namespace rt
