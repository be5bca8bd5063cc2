// The ray trees of a scene's pixels, as the student's code makes them.
#pragma once

#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <utility>
#include <vector>

namespace rt {

/// The trees that these of the student's chapters, and the solutions of the others, make of pixels (x, y), at
/// least one, from a process of their own. Throws InputError, which says why, where there are none.
std::vector<nlohmann::ordered_json> student_trees(const Project& project,
                                                  const std::vector<const Chapter*>& mine,
                                                  const std::filesystem::path& scene, bool lenient,
                                                  const std::vector<std::pair<int, int>>& pixels);

}  // namespace rt
