// `course test`: every test of the project, part by part, with times and one closing line.
#include "common/commands/commands.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/drift.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/mistake.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace rt {

namespace fs = std::filesystem;

namespace {

// A test program that takes longer hangs. The longest takes minutes on two cores.
constexpr double program_seconds = 1800;
constexpr double mistake_seconds = 60;

struct Part {
    std::string name;
    int passed = 0;
    int failed = 0;
    double seconds = 0;
    std::vector<std::string> problems;

    void expect(bool good, const std::string& problem) {
        ++(good ? passed : failed);
        if (!good) problems.push_back(problem);
    }
};

/// A part that a function fills in; what it throws is a failure of the part.
template <class Fill>
Part timed(const std::string& name, bool quiet, Fill fill) {
    const auto start = std::chrono::steady_clock::now();
    Part part;
    part.name = name;
    try {
        fill(part);
    } catch (const std::exception& error) {
        part.expect(false, error.what());
    }
    part.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!quiet) {
        for (const std::string& problem : part.problems) {
            const std::vector<std::string> lines = split_lines(printable(problem, Keep::Lines));
            for (std::size_t i = 0; i < lines.size(); ++i)
                fmt::print("  {} {}\n", i == 0 ? paint("✗", Tone::Bad) : "   ", lines[i]);
        }
        fmt::print("{:<28} {:>6} passed {:>4} failed  {:>10}\n", part.name, part.passed, part.failed,
                   duration(part.seconds));
        std::fflush(stdout);
    }
    return part;
}

/// Builds programs; those that cannot be built are failures, the others are returned.
std::vector<std::string> built(const Project& project, const std::vector<std::string>& programs, Part& part) {
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

void run_program(const Project& project, const std::string& name, bool quick, Part& part) {
    const TestOutcome outcome = run_tests(project, name, "", quick, program_seconds);
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
    if (!outcome.death.empty())
        part.expect(false, fmt::format("{} {} in \"{}\"", name, outcome.death,
                                       outcome.report.died_in ? outcome.report.died_in->name : "no test"));
    if (outcome.death.empty() && outcome.report.ended.empty()) part.expect(false, name + " has no tests");
}

// ---------------------------------------------------------------------------------------- mistakes

struct KnownMistake {
    std::string program;
    Mistake mistake;
};

std::vector<KnownMistake> known_mistakes(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<KnownMistake> mistakes;
    for (const Chapter& chapter : chapters) {
        const fs::path directory = project.root / "tests" / chapter.name / "mistakes";
        if (!fs::is_directory(directory)) continue;
        for (const auto& entry : fs::directory_iterator(directory))
            if (entry.path().extension() == ".mistake")
                mistakes.push_back({"mistake_" + entry.path().stem().string(),
                                    parse_mistake(read_file(entry.path()), relative(project, entry.path()))});
    }
    std::sort(mistakes.begin(), mistakes.end(),
              [](const KnownMistake& a, const KnownMistake& b) { return a.program < b.program; });
    return mistakes;
}

/// The tests of the mistake's step must fail: not crash, not hang, and not pass.
void expect_caught(const Project& project, const KnownMistake& known, Part& part) {
    const TestOutcome outcome = run_tests(project, known.program, known.mistake.step, true, mistake_seconds);
    const StepResult result = judge(known.mistake.step, outcome.report.ended);
    const std::string state = outcome.death.empty() ? std::string(name_of(result.state)) : outcome.death;
    part.expect(outcome.death.empty() && result.state == State::Failed,
                fmt::format("{} is not caught by the tests of step {} ({}): {}", known.program,
                            known.mistake.step, state, known.mistake.why));
    if (known.mistake.shows.empty() || result.state != State::Failed) return;
    part.expect(result.message.find(known.mistake.shows) != std::string::npos,
                fmt::format("{} is caught, but its message does not say '{}':\n{}", known.program,
                            known.mistake.shows, result.message));
}

/// All of them, or if `quick` one a step: most of the time goes into building them.
void test_mistakes(const Project& project, const std::vector<Chapter>& chapters, bool quick, Part& part) {
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
    const std::vector<std::string> good = built(project, programs, part);
    for (const KnownMistake& known : tried)
        if (std::find(good.begin(), good.end(), known.program) != good.end())
            expect_caught(project, known, part);
    for (const Chapter& chapter : chapters) {
        const auto count = std::count_if(mistakes.begin(), mistakes.end(), [&](const KnownMistake& known) {
            return known.mistake.step.starts_with(chapter.number);
        });
        part.expect(count >= 2, fmt::format("chapter {} has {}; at least 2 are expected", chapter.number,
                                            counted(count, "known mistake")));
    }
}

// ---------------------------------------------------------------------------------------- variants

/// The right variants of each program variants_NN_k of the chapter, in the order of k: those that are the
/// k-th of their step.
std::vector<std::vector<Mistake>> right_variants(const Project& project, const Chapter& chapter) {
    const fs::path directory = project.root / "tests" / chapter.name / "variants";
    std::vector<fs::path> files;
    if (fs::is_directory(directory))
        for (const auto& entry : fs::directory_iterator(directory))
            if (entry.path().extension() == ".variant") files.push_back(entry.path());
    std::sort(files.begin(), files.end());

    std::vector<std::vector<Mistake>> programs;
    std::string last;
    std::size_t k = 0;
    for (const fs::path& file : files) {
        const Mistake variant = parse_mistake(read_file(file), relative(project, file));
        k = variant.step == last ? k + 1 : 0;
        last = variant.step;
        if (k == programs.size()) programs.emplace_back();
        programs[k].push_back(variant);
    }
    return programs;
}

/// Every step must pass however it is written: all the variants, or if `quick` the first of each step.
void test_variants(const Project& project, const std::vector<Chapter>& chapters, bool quick, Part& part) {
    std::vector<std::string> programs;
    for (const Chapter& chapter : chapters) {
        const std::size_t count = right_variants(project, chapter).size();
        for (std::size_t k = 0; k < (quick ? std::min<std::size_t>(count, 1) : count); ++k)
            programs.push_back(fmt::format("variants_{}_{}", chapter.number, k + 1));
    }
    const std::vector<std::string> good = built(project, programs, part);
    for (const Chapter& chapter : chapters) {
        const std::vector<std::vector<Mistake>> variants = right_variants(project, chapter);
        for (const Step& step : chapter.steps) {
            const auto count = std::count_if(variants.begin(), variants.end(), [&](const auto& together) {
                return std::any_of(together.begin(), together.end(),
                                   [&](const Mistake& variant) { return variant.step == step.id; });
            });
            part.expect(count >= 2, fmt::format("step {} has {}; at least 2 are expected", step.id,
                                                counted(count, "right variant")));
        }
        for (std::size_t k = 0; k < variants.size(); ++k) {
            const std::string name = fmt::format("variants_{}_{}", chapter.number, k + 1);
            if (std::find(good.begin(), good.end(), name) == good.end()) continue;
            for (const StepResult& step : judge_program(project, chapter, name).steps) {
                std::string which = "the solution";
                for (const Mistake& variant : variants[k])
                    if (variant.step == step.id) which = variant.why;
                part.expect(step.state == State::Passed, fmt::format("{}: step {} is refused ({}): {}", name,
                                                                     step.id, which, step.message));
            }
        }
    }
}

// --------------------------------------------------------------------------------------- exercises

/// Nothing is started in an exercise as a student gets it: every step is todo, and none is right or wrong.
void test_exercises(const Project& project, const std::vector<Chapter>& chapters, Part& part) {
    std::vector<std::string> programs;
    for (const Chapter& chapter : chapters) programs.push_back("check_" + chapter.number);
    const std::vector<std::string> good = built(project, programs, part);
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        if (std::find(good.begin(), good.end(), programs[i]) == good.end()) continue;
        for (const StepResult& step : judge_program(project, chapters[i], programs[i]).steps)
            part.expect(step.state == State::Todo, fmt::format("step {} is {} before it is started: {}",
                                                               step.id, name_of(step.state), step.message));
    }
    const std::vector<Drift> drifted = drifted_files(project, chapters);
    for (const Drift& drift : drifted)
        part.problems.push_back(relative(project, drift.file) +
                                " is not what it is generated from; ./course exercises --make writes it");
    ++(drifted.empty() ? part.passed : part.failed);
}

// ----------------------------------------------------------------------------------------- scripts

/// Shell scripts: tests of the whole program from outside. Each is one test.
void test_scripts(const Project& project, Part& part) {
    std::vector<fs::path> scripts;
    for (const auto& entry : fs::directory_iterator(project.root / "tests" / "program"))
        if (entry.path().extension() == ".sh") scripts.push_back(entry.path());
    std::sort(scripts.begin(), scripts.end());
    for (const fs::path& script : scripts) {
        ProcessOptions options;
        options.environment = {{"COURSE_ROOT", project.root.string()},
                               {"COURSE_BUILD", project.build.string()}};
        const ProcessResult result = run_process({"bash", script.string()}, options);
        part.expect(succeeded(result), relative(project, script) + "\n" + result.output);
    }
}

nlohmann::ordered_json to_json(const std::vector<Part>& parts, int passed, int failed) {
    auto list = nlohmann::ordered_json::array();
    for (const Part& part : parts)
        list.push_back({{"name", part.name},
                        {"passed", part.passed},
                        {"failed", part.failed},
                        {"seconds", part.seconds},
                        {"problems", part.problems}});
    return {{"parts", list}, {"passed", passed}, {"failed", failed}};
}

}  // namespace

int run_test(bool quick, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    std::vector<Part> parts;

    std::vector<std::string> programs{"test_common", "test_program", "test_leave_out", "test_report"};
    for (const Chapter& chapter : chapters) programs.push_back("check_" + chapter.number + "_solution");
    std::vector<std::string> good;
    parts.push_back(timed("build", json, [&](Part& part) { good = built(project, programs, part); }));
    for (const std::string& name : good)
        parts.push_back(timed(name, json, [&](Part& part) { run_program(project, name, quick, part); }));

    parts.push_back(
        timed("known mistakes", json, [&](Part& part) { test_mistakes(project, chapters, quick, part); }));
    parts.push_back(
        timed("right variants", json, [&](Part& part) { test_variants(project, chapters, quick, part); }));
    if (!is_students_tree(project, chapters))
        parts.push_back(
            timed("exercises", json, [&](Part& part) { test_exercises(project, chapters, part); }));
    if (!quick) parts.push_back(timed("scripts", json, [&](Part& part) { test_scripts(project, part); }));

    int passed = 0, failed = 0;
    for (const Part& part : parts) {
        passed += part.passed;
        failed += part.failed;
    }
    if (json)
        fmt::print("{}\n", json_text(to_json(parts, passed, failed)));
    else
        fmt::print("\n{} passed, {} failed\n", passed, failed);
    return failed > 0 ? 1 : 0;
}

}  // namespace rt
