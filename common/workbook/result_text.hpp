// How results are shown: a line a step, one next action, and the same as JSON.
#pragma once

#include "common/workbook/results.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rt {

/// "  ✓ 02.1  The roots of a quadratic   15 points".
std::string step_line(const Step& step, const StepResult& result);

/// What went wrong with a step, indented to stand below its line; several lines, or none.
std::string details(const StepResult& result);

/// What else a student wants to see below the steps: what their code printed, first in the first test that
/// failed, and the compiler's warnings. Empty if there is nothing.
std::string notes(const ChapterResult& result);

/// The one next thing to do for a student with these results, as an imperative sentence. Between two chapters
/// it names optional steps that are left in the first of them. `results` are all chapters', in the
/// catalogue's order.
std::string next_action(const Project& project, const std::vector<Chapter>& chapters,
                        const std::vector<KnownResult>& results);

/// What to do next in a chapter that is not finished.
std::string next_action(const Chapter& chapter, const ChapterResult& result);

/// {"chapters":[{"id","title","steps":[{"id","title","points","state","message"}]}]}: the results
/// may be of some chapters, and of some of their steps. Optional steps have "optional": true, too.
nlohmann::ordered_json results_json(const std::vector<Chapter>& chapters,
                                    const std::vector<ChapterResult>& results);

}  // namespace rt
