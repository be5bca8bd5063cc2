// Builds and tests chapters; a compile error, a crash or a hang costs what it must and no more.
#include "common/workbook/check.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/back_trace.hpp"
#include "common/workbook/causes.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/missing_function.hpp"
#include "common/workbook/solutions.hpp"
#include "common/workbook/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace rt {

namespace fs = std::filesystem;

namespace {

// A chapter's quick tests take less than a second; what takes ten hangs.
constexpr double time_limit = 10;
constexpr double time_limit_alone = 5;

/// The fraction in ninja's "[12/80] Building …", or −1.
double ninja_fraction(std::string_view line) {
    int done = 0, total = 0;
    if (line.size() > 32) line = line.substr(0, 32);
    const bool found = std::sscanf(std::string(line).c_str(), "[%d/%d]", &done, &total) == 2 && total > 0;
    return found ? static_cast<double>(done) / total : -1;
}

std::string without_root(const Project& project, std::string line) {
    const std::string root = project.root.string() + "/";
    for (auto at = line.find(root); at != std::string::npos; at = line.find(root))
        line.erase(at, root.size());
    return line;
}

/// Whether a linker has said that something is missing or twice there. Some of them write "error" as a
/// compiler does, which knows of things that are twice there, too, and says in which column.
bool is_linkers(const std::string& line) {
    const auto has = [&](const char* text) { return line.find(text) != std::string::npos; };
    if (has("undefined reference to") || has("undefined symbol") || has("ld: cannot find")) return true;
    const auto error = line.find(": error: ");
    const bool is_compilers =
        error != std::string::npos && error > 0 && line[error - 1] >= '0' && line[error - 1] <= '9';
    return has("multiple definition of") && !is_compilers;
}

StepResult died(const std::string& step, const TestOutcome& outcome) {
    return {step, State::Failed, death_in_words(outcome)};
}

/// Where a student's code was, and what a check of the standard library said of it.
std::string place_of_death(const Project& project, const fs::path& program, const TestOutcome& outcome) {
    const std::string rule = broken_rule(outcome.output);
    const std::string place = stopped_in_words(project, program, outcome.report.stopped_at);
    return rule.empty() || place.empty() ? rule + place : rule + " " + place;
}

/// Every step has failed for the same reason.
ChapterResult not_built(const Chapter& chapter, const std::string& why) {
    ChapterResult result = all_todo(chapter);
    result.build_error = why;
    for (StepResult& step : result.steps) {
        step.state = State::Failed;
        step.message = why;
    }
    return result;
}

bool concerns(const TestRun& test, const std::string& step) {
    return std::find(test.steps.begin(), test.steps.end(), step) != test.steps.end();
}

/// CMake takes the path in PWD for its own if it leads to the same place, and would write the name of a
/// symbolic link into the build. This names the directory itself.
ProcessOptions for_cmake(const Project& project) {
    ProcessOptions options;
    options.environment = {{"PWD", project.root.string()}};
    return options;
}

/// As build_targets, for who has the build's lock.
BuildResult build_locked(const Project& project, const std::vector<std::string>& targets,
                         const std::string& label, bool keep_going = false) {
    std::vector<std::string> command{"cmake", "--build", project.build.string(), "--target"};
    command.insert(command.end(), targets.begin(), targets.end());
    if (keep_going) command.insert(command.end(), {"--", "-k", "0"});

    Progress progress(label);
    ProcessOptions options = for_cmake(project);
    double fraction = 0;
    options.on_line = [&](std::string_view line) { fraction = std::max(ninja_fraction(line), fraction); };
    // Ninja says nothing before a file is compiled, which may take long.
    options.while_waiting = [&] { progress.update(fraction); };
    const ProcessResult result = run_process(command, options);
    remember_warnings(project, result.output);
    for (const std::string& target : targets) keep_program(project, target);
    if (succeeded(result)) return {true, "", result.output};
    return {false, printable(first_error(project, result.output)), result.output};
}

std::string target_of(const Chapter& chapter, bool solutions) {
    return "check_" + chapter.number + (solutions ? "_solution" : "");
}

/// Why the student's code for a chapter cannot be built, or nothing. In a handout it stands on the student's
/// code for earlier chapters.
std::string what_is_missing(const Project& project, const Chapter& chapter) {
    if (has_solutions(project)) return missing_message(project, chapter);
    std::string message;
    for (const Chapter& earlier : read_catalogue(project))
        if (message.empty() && earlier.number <= chapter.number) message = missing_message(project, earlier);
    return message;
}

}  // namespace

BuildResult build_targets(const Project& project, const std::vector<std::string>& targets,
                          const std::string& label, bool keep_going) {
    const Lock lock(build_lock(project), label);
    return build_locked(project, targets, label, keep_going);
}

std::string first_error(const Project& project, const std::string& output) {
    std::string linker, last;
    for (const std::string& line : split_lines(output)) {
        const bool from_driver = line.starts_with("collect2:") || line.starts_with("clang");
        const bool from_linker = is_linkers(line);
        if (!from_driver && !from_linker &&
            (line.find(": error: ") != std::string::npos ||
             line.find(": fatal error: ") != std::string::npos))
            return without_root(project, line);
        if (from_linker && linker.empty()) linker = line;
        if (!line.empty() && !line.starts_with("ninja: build stopped")) last = line;
    }
    if (linker.empty()) return without_root(project, last);
    const std::string missing = missing_in_words(project, read_catalogue(project), linker);
    return missing.empty() ? without_root(project, linker) : missing;
}

std::string death_in_words(const TestOutcome& outcome) {
    const std::string place = outcome.report.died_in
                                  ? fmt::format(" in the test \"{}\"", outcome.report.died_in->name)
                                  : " outside of any test";
    return outcome.death + place + (outcome.place.empty() ? "" : "\n" + outcome.place);
}

TestOutcome run_tests(const fs::path& program, const fs::path& report,
                      const std::vector<std::string>& arguments, const ProcessOptions& options) {
    fs::remove(report);
    std::vector<std::string> command{program.string(), "--order", "decl", "--report", report.string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run_process(command, options);

    TestOutcome outcome;
    outcome.seconds = result.seconds;
    outcome.output = result.output;
    if (fs::exists(report)) outcome.report = read_report(read_file(report));
    if (result.timed_out)
        outcome.death = fmt::format("did not finish in {:g} s", options.time_limit);
    else if (result.signal != 0)
        outcome.death = fmt::format("crashed ({})", signal_name(result.signal));
    else if (!outcome.report.complete)
        outcome.death = fmt::format("ended the program (status {})", result.exit_code);
    return outcome;
}

TestOutcome run_test_program(const Project& project, const std::string& name, const std::string& tags,
                             bool quick, double limit) {
    // What Catch2 says is in the report, too, and in better words.
    std::vector<std::string> arguments{"--watched", "--out", "/dev/null"};
    if (quick) arguments.push_back("--quick");
    if (!tags.empty()) arguments.push_back(tags);
    ProcessOptions options;
    options.time_limit = limit;
    options.last_words = SIGQUIT;
    options.output_limit = std::size_t{64} << 20;  // what is printed in the last test counts, too
    const fs::path file = program(project, name);
    TestOutcome outcome = run_tests(file, own_directory(project) / (name + ".jsonl"), arguments, options);
    if (!outcome.death.empty()) outcome.place = place_of_death(project, file, outcome);
    return outcome;
}

ChapterResult judge_program(const Project& project, const Chapter& chapter, const std::string& name) {
    const TestOutcome all = run_test_program(project, name, "", true, time_limit);
    ChapterResult result{chapter.name, "", {}};
    result.printed = read_printed(all.output);
    // Without a test that started, it is the program itself that dies: trying again would not help.
    const bool hopeless = !all.death.empty() && all.report.ended.empty() && !all.report.died_in;
    for (const Step& step : chapter.steps) {
        // What failed before the end says more than the end does: plain tests run first.
        const StepResult ended = result_of(step.id, all.report.ended);
        const bool has_failed = std::any_of(
            all.report.ended.begin(), all.report.ended.end(),
            [&](const TestRun& test) { return test.state == State::Failed && concerns(test, step.id); });
        if (all.death.empty() || has_failed) {
            result.steps.push_back(ended);
        } else if (hopeless || (all.report.died_in && concerns(*all.report.died_in, step.id))) {
            result.steps.push_back(died(step.id, all));
        } else {
            const TestOutcome alone =
                run_test_program(project, name, "[" + step.id + "]", true, time_limit_alone);
            result.steps.push_back(alone.death.empty() ? result_of(step.id, alone.report.ended)
                                                       : died(step.id, alone));
        }
        result.steps.back().optional = step.optional;
    }
    return result;
}

std::vector<ChapterResult> check_chapters(const Project& project, const std::vector<const Chapter*>& chapters,
                                          bool solutions) {
    std::vector<std::string> targets, missing, sources;
    for (const Chapter* chapter : chapters) {
        missing.push_back(solutions ? "" : what_is_missing(project, *chapter));
        sources.push_back(sources_fingerprint(project, *chapter));
        if (missing.back().empty()) targets.push_back(target_of(*chapter, solutions));
    }
    const std::string label =
        chapters.size() == 1 ? "Building chapter " + chapters.front()->number : "Building the chapters";
    // One chapter's first error is enough; where a header that all include is broken there are hundreds.
    const BuildResult together =
        targets.empty() ? BuildResult{} : build_targets(project, targets, label, targets.size() > 1);

    const std::vector<Chapter> catalogue = read_catalogue(project);
    std::vector<ChapterResult> results;
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        const Chapter& chapter = *chapters[i];
        const std::string target = target_of(chapter, solutions);
        // What could be built is built by now, so asking for one at a time only tells whose error is whose.
        const BuildResult build = !missing[i].empty() ? BuildResult{false, missing[i], ""}
                                  : together.ok || targets.size() == 1
                                      ? together
                                      : build_targets(project, {target}, label);
        results.push_back(build.ok ? judge_program(project, chapter, target)
                                   : not_built(chapter, build.message));
        if (!solutions) results.back().warnings = known_warnings(project, chapter);
        find_causes(catalogue,
                    solutions ? std::set<std::string>() : failed_before(project, catalogue, chapter),
                    results.back());
        if (!solutions) remember(project, chapter, results.back(), sources[i]);
    }
    return results;
}

std::vector<ChapterResult> checked_results(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<const Chapter*> changed;
    for (const Chapter& chapter : chapters)
        if (!known_result(project, chapter).current) changed.push_back(&chapter);
    if (!changed.empty()) {
        say("Checking what has changed: chapter{} {}", changed.size() > 1 ? "s" : "",
            in_words({changed, {}, {}}));
        check_chapters(project, changed, false);
    }
    return results_of(known_results(project, chapters));
}

std::vector<const Chapter*> passing_chapters(const Project& project, const std::vector<Chapter>& chapters) {
    const std::vector<ChapterResult> results = checked_results(project, chapters);
    std::vector<const Chapter*> passing;
    for (std::size_t i = 0; i < chapters.size(); ++i)
        if (all_passed(results[i])) passing.push_back(&chapters[i]);
    return passing;
}

BuildResult build_mine(const Project& project, const OwnCode& own) {
    std::string numbers;
    for (const Chapter* chapter : own.whole) {
        if (const std::string missing = missing_message(project, *chapter); !missing.empty())
            return {false, missing, ""};
        numbers += (numbers.empty() ? "" : ";") + chapter->number;
    }
    const std::string label = "Building with your code for " + in_words(own);
    const Lock lock(build_lock(project), label);
    write_filled(project, own);
    const std::string filled = fmt::format("{}", fmt::join(own.filled, ";"));
    std::string linked, linked_files;
    for (const std::string& line : split_lines(read_file(project.build / "CMakeCache.txt"))) {
        if (line.starts_with("COURSE_MINE:")) linked = line.substr(line.find('=') + 1);
        if (line.starts_with("COURSE_FILLED:")) linked_files = line.substr(line.find('=') + 1);
    }
    if (linked != numbers || linked_files != filled) {
        Progress progress(label);
        ProcessOptions options = for_cmake(project);
        options.while_waiting = [&] { progress.update(0); };
        const ProcessResult result = run_process(
            {"cmake", "-DCOURSE_MINE=" + numbers, "-DCOURSE_FILLED=" + filled, project.build.string()},
            options);
        if (!succeeded(result)) return {false, printable(first_error(project, result.output)), result.output};
    }
    return build_locked(project, {"course_mine"}, label);
}

}  // namespace rt
