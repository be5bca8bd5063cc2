// Failures that may only follow from others: of steps that use a step that is wrong.
#pragma once

#include "common/workbook/results.hpp"

#include <set>
#include <string>
#include <vector>

namespace rt {

/// Fills in `because` of the failed steps of a result: the course's first step, of those that have failed and
/// that the step uses, directly or through others. `failed_before` are steps of earlier chapters.
void find_causes(const std::vector<Chapter>& chapters, const std::set<std::string>& failed_before,
                 ChapterResult& result);

/// The failed steps of earlier chapters with which the student's code for this one is linked: none where the
/// solutions take their place. What was not checked since it changed is not known to be wrong.
std::set<std::string> failed_before(const Project& project, const std::vector<Chapter>& chapters,
                                    const Chapter& chapter);

}  // namespace rt
