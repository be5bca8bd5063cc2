// Every test of the project, part by part: test programs, exercises and scripts.
#include "common/evidence/self_test.hpp"

#include "common/evidence/drifted_files.hpp"
#include "common/evidence/side_by_side.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

// A test program that takes longer hangs. The longest takes minutes on two cores.
constexpr double program_seconds = 1800;

}  // namespace

void SelfTest::expect(bool good, const std::string& problem) {
    ++(good ? passed : failed);
    if (!good) problems.push_back(problem);
}

void SelfTest::add(const SelfTest& other) {
    passed += other.passed;
    failed += other.failed;
    problems.insert(problems.end(), other.problems.begin(), other.problems.end());
}

std::vector<std::string> built(const Project& project, const std::vector<std::string>& programs,
                               SelfTest& part) {
    if (programs.empty() || build_targets(project, programs, part.name, true).ok) return programs;
    std::vector<std::string> good;
    for (const std::string& name : programs) {
        const BuildResult build = build_targets(project, {name}, name);
        if (build.ok)
            good.push_back(name);
        else
            part.expect(false, name + " does not build: " + build.message);
    }
    return good;
}

void judge_built(const Project& project, const std::vector<std::string>& programs, SelfTest& part,
                 const std::function<void(std::size_t, SelfTest&)>& expect) {
    const std::vector<std::string> good = built(project, programs, part);
    std::vector<SelfTest> results(programs.size());
    side_by_side(programs.size(), [&](std::size_t i) {
        if (std::find(good.begin(), good.end(), programs[i]) != good.end()) expect(i, results[i]);
    });
    for (const SelfTest& result : results) part.add(result);
}

void test_program(const Project& project, const std::string& name, bool quick, SelfTest& part) {
    const TestOutcome outcome = run_test_program(project, name, "", quick, program_seconds);
    for (const TestRun& test : outcome.report.ended) {
        const std::string why = test.state == State::Todo ? "waits for step " + test.missing : test.message;
        part.expect(test.state == State::Passed, test.name + "\n" + why);
    }
    const std::vector<TestRun>& ended = outcome.report.ended;
    const auto first_family = std::find_if(ended.begin(), ended.end(), is_family);
    const auto late = std::find_if_not(first_family, ended.end(), is_family);
    part.expect(late == ended.end(),
                fmt::format("{}: the plain test \"{}\" comes after a family of extreme cases", name,
                            late == ended.end() ? "" : late->name));
    if (!outcome.death.empty()) part.expect(false, fmt::format("{} {}", name, death_in_words(outcome)));
    if (outcome.death.empty() && outcome.report.ended.empty()) part.expect(false, name + " has no tests");
}

void test_exercises(const Project& project, const std::vector<Chapter>& chapters, SelfTest& part) {
    std::vector<std::string> programs;
    for (const Chapter& chapter : chapters) programs.push_back("check_" + chapter.number);
    judge_built(project, programs, part, [&](std::size_t i, SelfTest& result) {
        for (const StepResult& step : judge_program(project, chapters[i], programs[i]).steps)
            result.expect(step.state == State::Todo, fmt::format("step {} is {} before it is started: {}",
                                                                 step.id, name_of(step.state), step.message));
    });
    const std::vector<Drift> drifted = drifted_files(project, chapters);
    for (const Drift& drift : drifted)
        part.problems.push_back(relative(project, drift.file) +
                                " is not what it is generated from; ./course exercises --make writes it");
    ++(drifted.empty() ? part.passed : part.failed);
}

void test_scripts(const Project& project, SelfTest& part) {
    const std::vector<fs::path> scripts = files_in(project.root / "tests" / "program", {".sh"});
    std::vector<ProcessResult> results(scripts.size());
    side_by_side(scripts.size(), [&](std::size_t i) {
        ProcessOptions options;
        options.environment = {{"COURSE_ROOT", project.root.string()},
                               {"COURSE_BUILD", project.build.string()}};
        results[i] = run_process({"bash", scripts[i].string()}, options);
    });
    for (std::size_t i = 0; i < scripts.size(); ++i)
        part.expect(succeeded(results[i]), relative(project, scripts[i]) + "\n" + results[i].output);
}

}  // namespace rt
