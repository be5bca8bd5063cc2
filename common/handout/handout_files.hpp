// What a handout consists of: the course's files without solutions and all that would give them away.
#pragma once

#include "common/handout/class_facts.hpp"
#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// What a handout says of itself in .course/handout.json, which also marks a directory as one.
struct HandoutRecord {
    std::vector<std::string> chapters;  ///< the numbers of those that are not hidden
    ClassFacts about;
    std::map<std::string, std::string> files;  ///< as they were handed out: fingerprints by path
};

inline constexpr const char* record_file = ".course/handout.json";
std::string record_text(const HandoutRecord& record);
/// Reads what `record_text` has made, which since may have been in anybody's hands: throws InputError, with
/// the place in the file of that name, for anything else, also for paths that lead out of the directory.
HandoutRecord read_record(const std::string& text, const std::string& name);

struct HandoutFile {
    std::string path;  ///< from the handout's root
    std::string text;
    bool executable = false;
};

/// All files of a handout with these chapters; the last is its record. They are
///  - of all chapters the contracts, which the renderer is compiled against, and in .course/pristine/ the
///    exercises, made from the solutions: what `course reset` brings and what stands behind a contract where
///    a student's code does not;
///  - of the chapters that are not hidden also lessons, steps, exercises, scenes and pictures, and tests;
///  - common/ and what all tests share; a README.md of its own.
/// Files that the repository's .gitignore names are not looked at. Throws InputError where a line of a
/// solution would be in it, with the places, and where git, which reads .gitignore, is not installed.
std::vector<HandoutFile> handout_files(const Project& project, const std::vector<Chapter>& chapters,
                                       const ClassFacts& about);

/// Whether this is a path of files that students write: chapters/NN_name/*.cpp.
bool is_exercise(std::string_view path);

}  // namespace rt
