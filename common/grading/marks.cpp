// From what a step's checks said to its points: the rubric applied, in whole numbers.
#include "common/grading/marks.hpp"

#include <algorithm>

namespace rt {
namespace {

bool names(const std::string& hidden, const TestRun& check) {
    return hidden == check.name ||
           std::any_of(check.steps.begin(), check.steps.end(),
                       [&](const std::string& tag) { return hidden == "[" + tag + "]"; });
}

bool concerns(const TestRun& check, const std::string& step) {
    return std::find(check.steps.begin(), check.steps.end(), step) != check.steps.end();
}

/// The checks that ended and are hidden, or those that are not.
std::vector<TestRun> ended(const StepRubric& rubric, const StepRun& run, bool hidden) {
    std::vector<TestRun> some;
    for (const TestRun& check : run.ended)
        if (is_hidden(rubric, check) == hidden) some.push_back(check);
    return some;
}

CheckCount counted(const StepRubric& rubric, const StepRun& run, bool hidden) {
    CheckCount count;
    for (const TestRun& check : ended(rubric, run, hidden)) {
        ++count.all;
        if (check.state == State::Passed) ++count.passed;
    }
    for (const TestRun& check : run.not_ended)
        if (is_hidden(rubric, check) == hidden) ++count.all;
    return count;
}

Points earned(const GradedStep& step, const StepRubric& rubric, const StepRun& run) {
    const std::int64_t passed = step.checks.passed + step.hidden.passed,
                       all = step.checks.all + step.hidden.all;
    const bool everything = all > 0 && passed == all && !run.stop;
    if (all == 0 || (rubric.credit == Credit::All && !everything)) return {};
    // Rounded once, halves up: a/b + 1/2 is (2a + b)/(2b).
    const std::int64_t a = step.possible.hundredths * passed * step.late_percent, b = all * 100;
    return {(2 * a + b) / (2 * b)};
}

/// What of these checks failed, the one that says most (see `result_of`), then what stopped them.
std::optional<FailedCheck> failure_of(const std::string& step, const std::vector<TestRun>& checks,
                                      const std::optional<Stop>& stop) {
    std::optional<FailedCheck> failure;
    if (const StepResult result = result_of(step, checks); !checks.empty() && result.state == State::Failed) {
        const auto newline = std::min(result.message.find('\n'), result.message.size());
        failure = {result.message.substr(0, newline),
                   result.message.substr(std::min(newline + 1, result.message.size()))};
    }
    if (!stop || (failure && failure->said == stop->why)) return failure;
    if (!failure) return FailedCheck{stop->during ? stop->during->name : "", stop->why};
    failure->said += "\nAfter that: " + stop->why;
    return failure;
}

/// The first step that was missing where a check needed it, its own before any other; or none.
std::string missing_step(const std::string& step, const std::vector<TestRun>& checks) {
    std::string missing;
    for (const TestRun& check : checks)
        if (check.state == State::Todo && (missing.empty() || check.missing == step)) missing = check.missing;
    return missing;
}

void judge(GradedStep& step, const StepRun& run) {
    const State state = result_of(step.id, run.ended).state;
    step.verdict = run.stop                 ? run.stop->verdict
                   : state == State::Failed ? Verdict::Failed
                   : state == State::Todo   ? Verdict::Todo
                   : run.not_ended.empty()  ? Verdict::Passed
                                            : Verdict::Failed;
    if (step.verdict != Verdict::Todo) return;
    const std::string missing = missing_step(step.id, run.ended);
    if (missing.empty() || missing == step.id) return;
    step.verdict = Verdict::NeedsStep;
    step.needs = missing;
}

}  // namespace

bool is_hidden(const StepRubric& rubric, const TestRun& check) {
    return std::any_of(rubric.hidden.begin(), rubric.hidden.end(),
                       [&](const std::string& hidden) { return names(hidden, check); });
}

std::vector<std::string> hides_nothing(const Rubric& rubric, const std::vector<TestRun>& checks) {
    std::vector<std::string> lines;
    for (const auto& [id, step] : rubric.steps)
        for (const std::string& hidden : step.hidden) {
            const bool found =
                std::any_of(checks.begin(), checks.end(), [&, &number = id](const TestRun& check) {
                    return concerns(check, number) && names(hidden, check);
                });
            if (!found) lines.push_back(id + ": " + hidden);
        }
    return lines;
}

GradedStep marked(const Chapter& chapter, const Step& step, const StepRubric& rubric, int late_percent,
                  const StepRun& run) {
    GradedStep graded;
    graded.id = step.id;
    graded.title = step.title;
    graded.file = "chapters/" + chapter.name + "/" + step.file;
    graded.possible = rubric.points;
    graded.extra = rubric.extra;
    graded.late_percent = late_percent;
    graded.checks = counted(rubric, run, false);
    graded.hidden = counted(rubric, run, true);
    graded.earned = earned(graded, rubric, run);
    judge(graded, run);
    const bool stopped_hidden = run.stop && run.stop->during && is_hidden(rubric, *run.stop->during);
    graded.failure = failure_of(step.id, ended(rubric, run, false), stopped_hidden ? std::nullopt : run.stop);
    graded.hidden_failure =
        failure_of(step.id, ended(rubric, run, true), stopped_hidden ? run.stop : std::nullopt);
    if (graded.checks.all + graded.hidden.all == 0 && !graded.failure)
        graded.failure = FailedCheck{"", "there is no check of this step"};
    const bool no_hint_helps = graded.verdict == Verdict::Passed || graded.verdict == Verdict::NeedsStep ||
                               graded.verdict == Verdict::NotTaken;
    if (!no_hint_helps && !step.hints.empty()) graded.hint = 1;
    graded.difference = run.difference;
    return graded;
}

}  // namespace rt
