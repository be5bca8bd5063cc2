// Runs a judge: the process in which a chapter's tests stand, and nothing that a student wrote.
#include "common/grading/run_judge.hpp"

#include "common/sandbox/isolation.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

namespace rt {

namespace fs = std::filesystem;

namespace {

// The judge itself limits the time of a call, and of all of them, by what they would take on a machine with
// nothing else to do (tests/grading/judge.cpp). This is for one that hangs all the same.
constexpr double hour = 3600;

}  // namespace

TestReport run_judge(const fs::path& judge, const fs::path& report, const JudgeOptions& options,
                     const std::vector<std::string>& tests) {
    std::vector<std::string> arguments{"--quick",
                                       "--seed",
                                       std::to_string(options.seed),
                                       "--worker",
                                       options.worker.string(),
                                       "--isolation",
                                       std::string(name_of(options.isolation)),
                                       "--call-seconds",
                                       std::to_string(options.call_seconds),
                                       "--judge-seconds",
                                       std::to_string(options.judge_seconds),
                                       "--pictures",
                                       options.pictures.string()};
    for (const fs::path& scene : options.scenes) {
        arguments.emplace_back("--scene");
        arguments.push_back(scene.string());
    }
    arguments.insert(arguments.end(), tests.begin(), tests.end());
    ProcessOptions process;
    process.time_limit = hour;
    process.merge_errors = false;
    const TestOutcome outcome = run_tests(judge, report, arguments, process);
    if (!outcome.death.empty())
        throw GraderFault(fmt::format("{} {}", judge.filename().string(), death_in_words(outcome)));
    return outcome.report;
}

}  // namespace rt
