// A submission's mark: compiled and run in boxes, judged by the chapters' own tests.
#include "common/grading/grader.hpp"

#include "common/grading/judged.hpp"
#include "common/grading/run_judge.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/stopwatch.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/lock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// A chapter, and what its judge is told.
struct Job {
    const Project& project;
    const Chapter& chapter;
    JudgeOptions options;
};

/// The job of judging a worker. Pictures go into a new directory beside it.
Job job_for(const Project& project, const Chapter& chapter, const GraderOptions& options,
            const fs::path& worker) {
    Job job{project,
            chapter,
            {.worker = worker,
             .isolation = options.isolation,
             .call_seconds = options.call_seconds,
             .judge_seconds = options.judge_seconds,
             .seed = options.seed,
             .pictures = worker.parent_path() / "pictures",
             .scenes = {}}};
    for (const std::string& scene : chapter.scenes)
        job.options.scenes.push_back(project.root / "references" / chapter.name / scene);
    fs::create_directory(job.options.pictures);
    return job;
}

TestReport judge(const Job& job, const std::vector<std::string>& tests = {}) {
    const std::string name = "judge_" + job.chapter.number;
    return run_judge(program(job.project, name), own_directory(job.project) / (name + ".jsonl"), job.options,
                     tests);
}

std::vector<StepRun> judge_steps(const Job& job) {
    const TestReport all = judge(job);
    std::vector<StepRun> runs;
    for (const Step& step : job.chapter.steps) {
        runs.push_back(run_of(step, all));
        if (pays_for_another(runs.back())) runs.back() = run_of(step, judge(job, {"[" + step.id + "]"}));
    }
    return runs;
}

/// What the pristine exercise in the file's place passes is no work of the student's.
StepRun not_compiled(const StepRun& run, const std::string& error) {
    return {{}, run.ended, Stop{Verdict::NotCompiled, error, {}}, ""};
}

/// No step of a submission that was not taken, so that nothing of it could be run, has a mark.
std::vector<StepRun> not_taken(const Chapter& chapter, const std::string& refused) {
    const Stop stop{Verdict::NotTaken, "what was handed in " + refused, {}};
    return std::vector<StepRun>(chapter.steps.size(), StepRun{{}, {}, stop, ""});
}

/// The picture that the test of this name has left; empty if none.
std::string picture_of(const Job& job, const std::string& test) {
    const fs::path file = job.options.pictures / (fingerprint(test) + ".png");
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
    judge(job, {"[picture]"});
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
        const Job job = job_for(project_, chapter, options_, worker.program);
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
