// What a run of a judge said of a chapter's steps.
#include "common/grading/judged.hpp"

#include "common/workbook/exercise.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace rt {

using nlohmann::json;

namespace {

bool concerns(const TestRun& check, const std::string& step) {
    return std::find(check.steps.begin(), check.steps.end(), step) != check.steps.end();
}

/// A line each before all others: {"chosen":"name","steps":["02.1"]}.
std::vector<TestRun> chosen_tests(std::string_view report) {
    std::vector<TestRun> chosen;
    for (const std::string& line : split_lines(report)) {
        const json event = json::parse(line, nullptr, false);
        if (!event.is_object() || !event.contains("chosen")) break;
        TestRun test;
        test.name = event.value("chosen", "");
        test.steps = event.value("steps", std::vector<std::string>());
        chosen.push_back(test);
    }
    return chosen;
}

}  // namespace

Judged read_judged(std::string_view report, const Stop& end) {
    return {read_report(report), chosen_tests(report), end};
}

StepRun run_of(const Step& step, const Judged& judged) {
    const TestReport& report = judged.report;
    StepRun run;
    std::set<std::string> ended;
    for (const TestRun& test : report.ended) {
        ended.insert(test.name);
        if (!concerns(test, step.id)) continue;
        run.ended.push_back(test);
        if (!test.stopped.empty() && !run.stop)
            run.stop = Stop{verdict_named(test.stopped).value_or(Verdict::Crashed), test.message, test};
    }
    for (const TestRun& test : judged.chosen)
        if (concerns(test, step.id) && !ended.contains(test.name)) run.not_ended.push_back(test);
    const bool cut_off = !report.complete && (!run.not_ended.empty() || judged.chosen.empty());
    if (cut_off && !run.stop) {
        run.stop = judged.end;
        if (report.died_in && concerns(*report.died_in, step.id)) run.stop->during = report.died_in;
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
