// Right ways of writing a chapter that are not the solution's.
#pragma once

#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/mistake.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt {

/// The right variants of each program variants_NN_k of the chapter, in the order of k: those that are the
/// k-th of their step. Throws InputError as `parse_mistake`.
std::vector<std::vector<Mistake>> right_variants(const Project& project, const Chapter& chapter);

/// The files of a chapter's solution by their names, as they are written, with all marks.
std::map<std::string, std::string> solution_files(const Project& project, const Chapter& chapter);

}  // namespace rt
