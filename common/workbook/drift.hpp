// Generated files against what they are generated from.
#pragma once

#include "common/workbook/exercise.hpp"
#include "common/workbook/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// A generated file that is not what it should be.
struct Drift {
    std::filesystem::path file;
    std::string expected;
};

/// All exercises that are missing or differ. Throws InputError, with file and line, for a mark of a step that
/// the chapter does not have, and for a step that no mark of its file names.
std::vector<Drift> drifted_exercises(const Project& project, const std::vector<Chapter>& chapters);

/// Whether a student works here: in some exercise a step has been started.
bool is_students_tree(const Project& project, const std::vector<Chapter>& chapters);

}  // namespace rt
