// A class beyond one machine: the script that marks it in parts on an engine that is there already, GNU
// parallel over ssh or Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The names that `class_script` knows.
const std::vector<std::string>& engines();

/// Throws InputError that lists the names unless there is such an engine.
void require_engine(std::string_view name);

/// One part for ten submissions, so that machines can share the work and little is lost with one of them.
int usual_parts(std::size_t submissions);

struct ClassScript {
    std::string engine;
    std::filesystem::path course;                    ///< the script `course`, absolute
    std::filesystem::path directory;                 ///< absolute; other paths are as from there
    std::vector<std::filesystem::path> submissions;  ///< all of the class
    std::vector<std::string> options;                ///< of `course grade` for each part, with the seed
    std::string rubric;                              ///< once more for the merging; empty for none
    int parts = 1;
    std::string format;  ///< of the class's marks
};

/// The text of the script, for sh. It has a template in common/grading/engines.
std::string class_script(const ClassScript& script);

}  // namespace rt
