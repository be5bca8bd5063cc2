// All generated files against what they are generated from: exercises, code in lessons, the reference of
// scenes.
#pragma once

#include "common/workbook/drift.hpp"

#include <vector>

namespace rt {

/// The exercises that have drifted, pages of chapters that show code as it is no more, and the reference of
/// scenes if its table of commands is not the parser's. Throws InputError as `drifted_exercises` and
/// `woven_lesson`, and if the reference has lost the marks around its table.
std::vector<Drift> drifted_files(const Project& project, const std::vector<Chapter>& chapters);

}  // namespace rt
