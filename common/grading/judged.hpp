// What a run of a judge said of a chapter's steps.
#pragma once

#include "common/grading/marks.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Stands in what a check says that would have called a function which had not returned from another check:
/// nobody waits for it twice.
inline constexpr std::string_view not_called_again = "was not called again";

/// A judge's run: its report, all checks that were to run (names and tags), and how it ended where it came to
/// no end.
struct Judged {
    TestReport report;
    std::vector<TestRun> chosen;
    Stop end;
};

/// Reads the report that tests/main.cpp writes, as far as it was written.
Judged read_judged(std::string_view report, const Stop& end);

/// What it says of a step: of its checks, those that ended and those that never did. A check whose call gave
/// no answer is a stop. The judge's own end stops those steps only that it left without a check.
StepRun run_of(const Step& step, const Judged& judged);

/// Whether all that stopped the step's checks is that a function did not return in a check of another step.
bool pays_for_another(const StepRun& run);

}  // namespace rt
