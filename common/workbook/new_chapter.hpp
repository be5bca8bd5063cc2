// A new chapter's column: its rooms with one step that is complete, to be written over.
#pragma once

#include "common/terminal/project.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// Makes chapters/NN_name, solutions/NN_name, tests/NN_name and references/NN_name with one step: lesson,
/// contract, solution, exercise, tests, two mistakes, two variants and a scene, from the templates in
/// common/workbook/new_chapter. Returns the files. Throws InputError, and makes nothing, for a name that is
/// not two digits and words of small letters and digits, "11_area_lights", for a number or words that a
/// chapter has, and in a tree without solutions.
std::vector<std::filesystem::path> make_chapter(const Project& project, const std::string& name);

}  // namespace rt
