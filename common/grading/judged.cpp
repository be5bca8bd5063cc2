// What a judge's report says of a chapter's steps.
#include "common/grading/judged.hpp"

#include <algorithm>

namespace rt {

StepRun run_of(const Step& step, const TestReport& report) {
    StepRun run;
    for (const TestRun& test : report.ended) {
        if (std::find(test.steps.begin(), test.steps.end(), step.id) == test.steps.end()) continue;
        run.ended.push_back(test);
        if (!test.stopped.empty() && !run.stop)
            run.stop = Stop{verdict_named(test.stopped).value_or(Verdict::Crashed), test.message, test};
    }
    return run;
}

bool pays_for_another(const StepRun& run) {
    bool pays = false;
    for (const TestRun& test : run.ended) {
        const bool skipped = test.message.find(not_called_again) != std::string::npos;
        if (!test.stopped.empty() && !skipped) return false;
        pays = pays || skipped;
    }
    return pays;
}

}  // namespace rt
