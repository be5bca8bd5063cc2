// The program that is linked with the student's chapters in place of solutions, and when commands go on as
// it.
#pragma once

#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"

#include <string>
#include <vector>

namespace rt {

/// The numbers of the student's chapters that this program is linked with, as "02, 03"; null if it is linked
/// with none.
const char* linked_chapters();

/// Goes on as the program that is linked with these of the student's chapters, given the same arguments;
/// returns if there are none. Throws std::runtime_error if they do not build.
void become_mine(const Project& project, const std::vector<const Chapter*>& mine,
                 const std::vector<std::string>& arguments);

/// In a handout, where nothing else can draw, goes on as the program that is linked with all of the student's
/// chapters; returns elsewhere, and in that program.
void become_mine_in_handout(const std::vector<std::string>& arguments);

/// Pointers to all of them.
std::vector<const Chapter*> pointers_to(const std::vector<Chapter>& chapters);

}  // namespace rt
