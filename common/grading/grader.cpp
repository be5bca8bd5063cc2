// A submission's mark: compiled and run in boxes, judged by the chapters' own tests.
#include "common/grading/grader.hpp"

#include "common/grading/isolation.hpp"
#include "common/grading/marks.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/stopwatch.hpp"
#include "common/terminal/lock.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rt {

namespace fs = std::filesystem;

namespace {

// The judge itself limits the time of a call, and of all of them, by what they would take on a machine with
// nothing else to do (tests/grading/judge.cpp). This is for one that hangs all the same.
constexpr double hour = 3600;

TestReport judge(const Project& project, const Chapter& chapter, const fs::path& worker,
                 const GraderOptions& options) {
    const fs::path report = own_directory(project) / ("judge_" + chapter.number + ".jsonl");
    fs::remove(report);
    ProcessOptions process;
    process.time_limit = hour;
    process.environment = {{"COURSE_WORKER", worker.string()},
                           {"COURSE_ISOLATION", std::string(name_of(options.isolation))},
                           {"COURSE_CALL_SECONDS", std::to_string(options.call_seconds)},
                           {"COURSE_JUDGE_SECONDS", std::to_string(options.judge_seconds)}};
    run_process({program(project, "judge_" + chapter.number).string(), "--order", "decl", "--quick",
                 "--report", report.string(), "--seed", std::to_string(options.seed)},
                process);
    return fs::exists(report) ? read_report(read_file(report)) : TestReport{};
}

/// Which verdict a test has because of how a call ended (tests/grading/judge.cpp).
Verdict verdict_of(const std::string& stopped) { return verdict_named(stopped).value_or(Verdict::Crashed); }

StepRun run_of(const Step& step, const TestReport& report) {
    StepRun run;
    for (const TestRun& test : report.ended) {
        if (std::find(test.steps.begin(), test.steps.end(), step.id) == test.steps.end()) continue;
        run.ended.push_back(test);
        if (!test.stopped.empty() && !run.stop) run.stop = Stop{verdict_of(test.stopped), test.message, test};
    }
    if (!report.complete) run.stop = Stop{Verdict::TimedOut, "the tests did not end", report.died_in};
    return run;
}

}  // namespace

Grader::Grader(const Project& project, GraderOptions options)
    : project_(project),
      options_(std::move(options)),
      workshop_((prepare_boxes(project, options_.isolation), project), options_.chapters,
                options_.isolation) {}

void Grader::grade_chapter(const Chapter& chapter, const Submission& submission, Grade& grade) {
    const fs::path directory = workshop_.place() / "work" / std::to_string(graded_) / chapter.number;
    fs::create_directories(directory);
    const BuiltWorker worker = workshop_.build(chapter, submission, directory);
    grade.peak_bytes = std::max(grade.peak_bytes, static_cast<std::int64_t>(worker.peak_memory));
    TestReport report;
    if (!worker.program.empty()) report = judge(project_, chapter, worker.program, options_);
    const int late = late_percent(options_.rubric, chapter.number, grade.submitted);
    for (const Step& step : chapter.steps) {
        StepRun run = run_of(step, report);
        const auto error = worker.errors.find(step.file);
        if (error != worker.errors.end())
            run = {{}, run.ended, Stop{Verdict::NotCompiled, error->second, {}}, ""};
        grade.steps.push_back(marked(chapter, step, options_.rubric.steps.at(step.id), late, run));
    }
    std::error_code ignored;
    fs::remove_all(directory.parent_path(), ignored);
}

Grade Grader::grade(const Submission& submission, const std::function<void(double)>& progress) {
    const Stopwatch watch;
    Grade grade;
    grade.submission = submission.name;
    grade.digest = digest_of(submission);
    grade.rubric = digest_of(options_.rubric);
    grade.seed = options_.seed;
    grade.isolation = name_of(options_.isolation);
    grade.submitted = submission.submitted;
    ++graded_;
    for (std::size_t i = 0; i < options_.chapters.size(); ++i) {
        if (progress) progress(static_cast<double>(i) / static_cast<double>(options_.chapters.size()));
        grade_chapter(*options_.chapters[i], submission, grade);
    }
    grade.seconds = watch.seconds();
    grade.graded = now();
    return grade;
}

}  // namespace rt
