// The program that is linked with the student's chapters in place of solutions, and when commands go on as
// it.
#pragma once

#include "common/terminal/project.hpp"
#include "common/workbook/own_code.hpp"

#include <string>
#include <vector>

namespace rt {

/// What of the student's this program is linked with, as "02, 03.1"; null if it is linked with none.
const char* linked_chapters();

/// Goes on as the program that is linked with this code of the student's, given the same arguments; returns
/// if there is none. Throws InputError if it does not build.
void become_mine(const Project& project, const OwnCode& own, const std::vector<std::string>& arguments);

/// Whose code the program runs that is linked now: "your code for 02, 03.1, solutions for the rest".
std::string whose_code();

/// In a handout, where nothing else can draw, goes on as the program that is linked with all of the student's
/// chapters; returns elsewhere, and in that program.
void become_mine_in_handout(const std::vector<std::string>& arguments);

/// Pointers to all of them.
std::vector<const Chapter*> pointers_to(const std::vector<Chapter>& chapters);

}  // namespace rt
