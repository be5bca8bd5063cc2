// Known mistakes, which the tests must catch.
#include "common/evidence/self_test.hpp"
#include "common/evidence/unclear_message.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr double mistake_seconds = 60;

struct KnownMistake {
    std::string program;
    Mistake mistake;
    std::string chapter() const { return mistake.step.substr(0, mistake.step.find('.')); }
};

std::vector<KnownMistake> known_mistakes(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<KnownMistake> mistakes;
    for (const Chapter& chapter : chapters) {
        for (const fs::path& file :
             files_in(project.root / "tests" / chapter.name / "mistakes", {".mistake"}))
            mistakes.push_back(
                {"mistake_" + file.stem().string(), parse_mistake(read_file(file), relative(project, file))});
    }
    std::sort(mistakes.begin(), mistakes.end(),
              [](const KnownMistake& a, const KnownMistake& b) { return a.program < b.program; });
    return mistakes;
}

/// The plain tests of the mistake's step must fail: not crash, not hang, and not pass; and what a student
/// then sees must say in words what is wrong. Families of extreme cases are not asked: they take most of the
/// time, and a student sees what a plain test says.
void expect_caught(const Project& project, const KnownMistake& known, SelfTest& part) {
    const TestOutcome outcome = run_test_program(
        project, known.program, fmt::format("[{}]~[stability]", known.mistake.step), true, mistake_seconds);
    const StepResult result = result_of(known.mistake.step, outcome.report.ended);
    const std::string state = outcome.death.empty() ? std::string(name_of(result.state)) : outcome.death;
    part.expect(outcome.death.empty() && result.state == State::Failed,
                fmt::format("{} is not caught by the plain tests of step {} ({}): {}", known.program,
                            known.mistake.step, state, known.mistake.why));
    if (result.state != State::Failed) return;
    if (!known.mistake.shows.empty())
        part.expect(result.message.find(known.mistake.shows) != std::string::npos,
                    fmt::format("{} is caught, but its message does not say '{}':\n{}", known.program,
                                known.mistake.shows, result.message));
    const std::string why = unclear(result.message);
    part.expect(why.empty(),
                fmt::format("{} is caught, but its message {}:\n{}", known.program, why, result.message));
}

}  // namespace

void test_mistakes(const Project& project, const std::vector<Chapter>& chapters, bool quick, SelfTest& part) {
    const std::vector<KnownMistake> mistakes = known_mistakes(project, chapters);
    std::vector<KnownMistake> tried = mistakes;
    if (quick) {
        const auto same_step = [](const KnownMistake& a, const KnownMistake& b) {
            return a.mistake.step == b.mistake.step;
        };
        tried.erase(std::unique(tried.begin(), tried.end(), same_step), tried.end());
    }
    std::vector<std::string> programs;
    for (const KnownMistake& known : tried) programs.push_back(known.program);
    judge_built(project, programs, part,
                [&](std::size_t i, SelfTest& result) { expect_caught(project, tried[i], result); });
    for (const Chapter& chapter : chapters) {
        const auto count = std::count_if(mistakes.begin(), mistakes.end(), [&](const KnownMistake& known) {
            return known.chapter() == chapter.number;
        });
        part.expect(count >= 2, fmt::format("chapter {} has {}; at least 2 are expected", chapter.number,
                                            counted(count, "known mistake")));
    }
}

}  // namespace rt
