// What a judge's report says of a chapter's steps.
#pragma once

#include "common/grading/marks.hpp"

#include <string_view>

namespace rt {

/// Stands in what a check says that would have called a function which had not returned from another check:
/// nobody waits for it twice.
inline constexpr std::string_view not_called_again = "was not called again";

/// What it says of a step: its checks. One whose call gave no answer is a stop.
StepRun run_of(const Step& step, const TestReport& report);

/// Whether all that stopped the step's checks is that a function did not return in a check of another step.
bool pays_for_another(const StepRun& run);

}  // namespace rt
