// A submission's mark: compiled and run in boxes, judged by the chapters' own tests.
#include "common/grading/grader.hpp"

#include "common/grading/isolation.hpp"
#include "common/grading/judged.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/stopwatch.hpp"
#include "common/terminal/lock.hpp"
#include "common/terminal/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rt {

namespace fs = std::filesystem;

namespace {

// The judge itself limits the time of a call, and of all of them, by what they would take on a machine with
// nothing else to do (tests/grading/judge.cpp). This is for one that hangs all the same.
constexpr double hour = 3600;

/// A judge and the worker that it is to judge.
struct Job {
    const Project& project;
    const Chapter& chapter;
    const GraderOptions& options;
    fs::path worker;
    fs::path pictures;  ///< where difference pictures go (tests/grading/picture.cpp)
};

std::string scenes_of(const Job& job) {
    std::string lines;
    for (const std::string& scene : job.chapter.scenes)
        lines += (job.project.root / "references" / job.chapter.name / scene).string() + "\n";
    return lines;
}

ProcessResult run_judge(const Job& job, const std::vector<std::string>& arguments) {
    ProcessOptions process;
    process.time_limit = hour;
    process.environment = {{"COURSE_WORKER", job.worker.string()},
                           {"COURSE_ISOLATION", std::string(name_of(job.options.isolation))},
                           {"COURSE_CALL_SECONDS", std::to_string(job.options.call_seconds)},
                           {"COURSE_JUDGE_SECONDS", std::to_string(job.options.judge_seconds)},
                           {"COURSE_PICTURES", job.pictures.string()},
                           {"COURSE_SCENES", scenes_of(job)}};
    std::vector<std::string> command{program(job.project, "judge_" + job.chapter.number).string(),
                                     "--order",
                                     "decl",
                                     "--quick",
                                     "--seed",
                                     std::to_string(job.options.seed)};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_process(command, process);
}

Judged judge(const Job& job, const std::vector<std::string>& tests = {}) {
    const fs::path file = own_directory(job.project) / ("judge_" + job.chapter.number + ".jsonl");
    fs::remove(file);
    std::vector<std::string> arguments{"--report", file.string()};
    arguments.insert(arguments.end(), tests.begin(), tests.end());
    const ProcessResult result = run_judge(job, arguments);
    Stop end{Verdict::Crashed, "the tests came to no end", {}};
    if (result.timed_out) end = {Verdict::TimedOut, "the tests did not end", {}};
    return read_judged(fs::exists(file) ? read_file(file) : "", end);
}

std::vector<StepRun> judge_steps(const Job& job) {
    const Judged all = judge(job);
    std::vector<StepRun> runs;
    for (const Step& step : job.chapter.steps) {
        runs.push_back(run_of(step, all));
        if (pays_for_another(runs.back())) runs.back() = run_of(step, judge(job, {"[" + step.id + "]"}));
    }
    return runs;
}

/// What the pristine exercise in the file's place passes is no work of the student's.
StepRun not_compiled(const StepRun& run, const std::string& error) {
    StepRun none{{}, run.ended, Stop{Verdict::NotCompiled, error, {}}, ""};
    none.not_ended.insert(none.not_ended.end(), run.not_ended.begin(), run.not_ended.end());
    return none;
}

/// No step of a submission that was not taken, so that nothing of it could be run, has a mark.
std::vector<StepRun> not_taken(const Chapter& chapter, const std::string& refused) {
    const Stop stop{Verdict::NotTaken, "what was handed in " + refused, {}};
    return std::vector<StepRun>(chapter.steps.size(), StepRun{{}, {}, stop, ""});
}

/// The picture that the test of this name has left; empty if none.
std::string picture_of(const Job& job, const std::string& test) {
    const fs::path file = job.pictures / (fingerprint(test) + ".png");
    return fs::exists(file) ? read_file(file) : "";
}

/// Gives steps that failed the difference pictures of their checks. Where a chapter is written, runs to its
/// end and has only wrong steps without any, the first of them gets the first of the chapter's
/// pictures that is not POV-Ray's.
void add_pictures(const Job& job, std::vector<StepRun>& runs) {
    StepRun* first_wrong = nullptr;
    bool draws = true, has_one = false;
    for (StepRun& run : runs) {
        draws = draws && !run.stop;
        for (const TestRun& test : run.ended) {
            draws = draws && test.state != State::Todo;
            if (test.state != State::Failed) continue;
            if (!first_wrong) first_wrong = &run;
            if (run.difference.empty()) run.difference = picture_of(job, test.name);
        }
        has_one = has_one || !run.difference.empty();
    }
    if (!draws || !first_wrong || has_one) return;
    run_judge(job, {"[picture]"});
    first_wrong->difference = picture_of(job, "the chapter's pictures are POV-Ray's");
}

}  // namespace

Grader::Grader(const Project& project, GraderOptions options)
    : project_(project),
      options_(std::move(options)),
      workshop_((prepare_boxes(project, options_.isolation), project), options_.chapters,
                options_.isolation) {}

std::vector<StepRun> Grader::run_chapter(const Chapter& chapter, const Submission& submission, Grade& grade) {
    const fs::path directory = workshop_.place() / "work" / std::to_string(graded_) / chapter.number;
    fs::create_directories(directory);
    const BuiltWorker worker = workshop_.build(chapter, submission, directory);
    grade.peak_bytes = std::max(grade.peak_bytes, static_cast<std::int64_t>(worker.peak_memory));
    std::vector<StepRun> runs(chapter.steps.size());
    if (!worker.program.empty()) {
        const Job job{project_, chapter, options_, worker.program, directory / "pictures"};
        fs::create_directory(job.pictures);
        runs = judge_steps(job);
        if (worker.errors.empty()) add_pictures(job, runs);
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto error = worker.errors.find(chapter.steps[i].file);
        if (error != worker.errors.end()) runs[i] = not_compiled(runs[i], error->second);
    }
    std::error_code ignored;
    fs::remove_all(directory.parent_path(), ignored);
    return runs;
}

void Grader::grade_chapter(const Chapter& chapter, const Submission& submission, Grade& grade) {
    const std::vector<StepRun> runs = submission.refused.empty() ? run_chapter(chapter, submission, grade)
                                                                 : not_taken(chapter, submission.refused);
    const int late = late_percent(options_.rubric, chapter.number, grade.submitted);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Step& step = chapter.steps[i];
        grade.steps.push_back(marked(chapter, step, options_.rubric.steps.at(step.id), late, runs[i]));
    }
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
