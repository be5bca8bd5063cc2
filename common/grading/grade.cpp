// The mark of one submission with all that explains it, as plain data.
#include "common/grading/grade.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rt {
namespace {

constexpr std::array<std::pair<Verdict, std::string_view>, 9> names{{
    {Verdict::Passed, "passed"},
    {Verdict::Failed, "failed"},
    {Verdict::Todo, "todo"},
    {Verdict::Crashed, "crashed"},
    {Verdict::TimedOut, "timed out"},
    {Verdict::TooMuchMemory, "too much memory"},
    {Verdict::NotCompiled, "not compiled"},
    {Verdict::NeedsStep, "needs another step"},
    {Verdict::NotTaken, "not taken"},
}};

}  // namespace

std::string_view name_of(Verdict verdict) {
    return std::find_if(names.begin(), names.end(), [&](const auto& row) { return row.first == verdict; })
        ->second;
}

std::optional<Verdict> verdict_named(std::string_view name) {
    for (const auto& [verdict, word] : names)
        if (word == name) return verdict;
    return std::nullopt;
}

Points earned(const Grade& grade) {
    Points sum;
    for (const GradedStep& step : grade.steps) sum += step.earned;
    return sum;
}

Points possible(const Grade& grade) {
    Points sum;
    for (const GradedStep& step : grade.steps)
        if (!step.extra) sum += step.possible;
    return sum;
}

std::string chapter_of(const GradedStep& step) { return step.id.substr(0, step.id.find('.')); }

}  // namespace rt
