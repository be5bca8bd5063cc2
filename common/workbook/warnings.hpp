// The compiler's warnings of a student's files, which it says only when it compiles them.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The exercises that a build by ninja has compiled, as from the repository's root, each with its warnings:
/// one line each, "chapters/02_spheres/sphere.cpp:31:1: warning: …".
std::map<std::string, std::vector<std::string>> compiled_exercises(const Project& project,
                                                                   std::string_view output);

/// Keeps the warnings that a build has said of exercises, beside what it has built. The build's lock must be
/// held.
void remember_warnings(const Project& project, std::string_view output);

/// What the compiler said of the chapter's files when it last compiled them; nothing of one that has changed
/// since.
std::vector<std::string> known_warnings(const Project& project, const Chapter& chapter);

/// The first of them, indented to stand below a verdict, and how many more there are. Empty if there are
/// none.
std::string warnings_in_words(const std::vector<std::string>& warnings);

}  // namespace rt
