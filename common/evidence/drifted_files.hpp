// All generated files against what they are generated from: exercises, and the reference of scenes.
#pragma once

#include "common/workbook/drift.hpp"

#include <vector>

namespace rt {

/// The exercises that have drifted, and the reference of scenes if its table of commands is not the parser's.
/// Throws InputError as `drifted_exercises`, and if the reference has lost the marks around its table.
std::vector<Drift> drifted_files(const Project& project, const std::vector<Chapter>& chapters);

}  // namespace rt
