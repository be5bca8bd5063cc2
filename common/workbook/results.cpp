// What is known about a student's steps: not started, wrong or right.
#include "common/workbook/results.hpp"

#include "common/image/file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

State state_named(const std::string& name) {
    return name == "passed" ? State::Passed : name == "failed" ? State::Failed : State::Todo;
}

fs::path memory_file(const Project& project) { return memory(project, "state.json"); }

json read_memory(const Project& project) {
    if (!fs::exists(memory_file(project))) return json::object();
    json memory = read_json(read_file(memory_file(project)));
    return memory.is_object() ? memory : json::object();
}

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) names.push_back(file.filename().string());
    return names;
}

}  // namespace

std::string sources_fingerprint(const Project& project, const Chapter& chapter) {
    std::string all;
    for (const char* room : {"chapters", "tests"})
        for (const fs::path& file : files_in(project.root / room / chapter.name, {".cpp", ".hpp"}))
            all += file.filename().string() + '\0' + read_file(file) + '\0';
    return fingerprint(all);
}

std::string_view name_of(State state) {
    return state == State::Passed ? "passed" : state == State::Failed ? "failed" : "todo";
}

ChapterResult all_todo(const Chapter& chapter) {
    ChapterResult result{chapter.name, "", {}};
    for (const Step& step : chapter.steps)
        result.steps.push_back({step.id, State::Todo, "", "", step.optional});
    return result;
}

StepsDone steps_done(const ChapterResult& result) {
    const bool only_optional =
        std::all_of(result.steps.begin(), result.steps.end(), std::mem_fn(&StepResult::optional));
    StepsDone done;
    for (const StepResult& step : result.steps) {
        if (step.optional && !only_optional) continue;
        ++done.all;
        if (step.state == State::Passed) ++done.passed;
    }
    return done;
}

bool all_passed(const ChapterResult& result) {
    const StepsDone done = steps_done(result);
    return done.passed == done.all &&
           std::none_of(result.steps.begin(), result.steps.end(),
                        [](const StepResult& step) { return step.state == State::Failed; });
}

TestReport read_report(std::string_view text) {
    TestReport report;
    for (const std::string& line : split_lines(text)) {
        const json event = read_json(line);
        if (!event.is_object()) break;
        if (event.contains("finished")) report.complete = true;
        if (event.contains("stopped_at"))
            report.stopped_at = event.value("stopped_at", std::vector<std::string>());
        TestRun run;
        run.steps = event.value("steps", std::vector<std::string>());
        if (event.contains("started")) {
            run.name = event.value("started", "");
            report.died_in = run;
        } else if (event.contains("ended")) {
            run.name = event.value("ended", "");
            run.state = state_named(event.value("state", ""));
            run.message = printable(event.value("message", ""), Keep::Lines);
            run.missing = event.value("missing", "");
            run.stopped = event.value("stopped", "");
            report.ended.push_back(run);
            report.died_in.reset();
        }
    }
    return report;
}

bool is_family(const TestRun& test) {
    return std::find(test.steps.begin(), test.steps.end(), family_tag) != test.steps.end();
}

StepResult result_of(const std::string& step, const std::vector<TestRun>& tests) {
    int total = 0, passed = 0;
    const TestRun *failure = nullptr, *own_todo = nullptr, *other_todo = nullptr;
    for (const TestRun& test : tests) {
        if (std::find(test.steps.begin(), test.steps.end(), step) == test.steps.end()) continue;
        ++total;
        if (test.state == State::Passed) ++passed;
        // Of a family's thousands of extreme cases one is hard to read: what a plain test says comes first.
        if (test.state == State::Failed && (!failure || (is_family(*failure) && !is_family(test))))
            failure = &test;
        if (test.state == State::Todo) (test.missing == step ? own_todo : other_todo) = &test;
    }
    if (total == 0) return {step, State::Failed, fmt::format("no test has the tag [{}]", step)};
    if (failure) return {step, State::Failed, failure->name + "\n" + failure->message};
    if (own_todo)
        return {step, State::Todo,
                passed > 0 ? fmt::format("begun: {} of {} tests pass", passed, total) : ""};
    if (other_todo) return {step, State::Todo, fmt::format("waits for step {}", other_todo->missing)};
    return {step, State::Passed, ""};
}

KnownResult known_result(const Project& project, const Chapter& chapter) {
    KnownResult known{all_todo(chapter), true};
    if (is_untouched(project, chapter)) return known;
    known.current = false;
    try {
        const json memory = read_memory(project);
        if (!memory.contains(chapter.name)) return known;
        const json& entry = memory.at(chapter.name);
        ChapterResult result = all_todo(chapter);
        result.build_error = entry.at("build_error").get<std::string>();
        for (StepResult& step : result.steps) {
            const json& stored = entry.at("steps").at(step.id);
            step.state = state_named(stored.at("state").get<std::string>());
            step.message = stored.at("message").get<std::string>();
            step.because = stored.value("because", "");
        }
        known.result = result;
        known.current = entry.at("sources") == sources_fingerprint(project, chapter);
    } catch (const json::exception&) {
        // Written by another version of the course: as good as nothing.
        known.current = false;
    }
    return known;
}

std::vector<KnownResult> known_results(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<KnownResult> known;
    for (const Chapter& chapter : chapters) known.push_back(known_result(project, chapter));
    return known;
}

std::vector<ChapterResult> results_of(const std::vector<KnownResult>& known) {
    std::vector<ChapterResult> results;
    for (const KnownResult& chapter : known) results.push_back(chapter.result);
    return results;
}

void remember(const Project& project, const Chapter& chapter, const ChapterResult& result,
              const std::string& sources) {
    json steps = json::object();
    for (const StepResult& step : result.steps)
        steps[step.id] = {
            {"state", name_of(step.state)}, {"message", step.message}, {"because", step.because}};
    const Lock lock(memory_lock(project), "remembering results");
    json memory = read_memory(project);
    memory[chapter.name] = {{"sources", sources}, {"build_error", result.build_error}, {"steps", steps}};
    write_file(memory_file(project), json_text(memory, 1) + "\n");
}

std::optional<std::string> pristine_text(const Project& project, const Chapter& chapter,
                                         const std::string& file) {
    const fs::path solution = project.root / "solutions" / chapter.name / file;
    if (fs::exists(solution)) return exercise_text(read_file(solution), relative(project, solution));
    const fs::path kept = project.root / ".course" / "pristine" / chapter.name / file;
    if (fs::exists(kept)) return read_file(kept);
    return std::nullopt;
}

std::vector<std::string> exercise_files(const Project& project, const Chapter& chapter) {
    return names_of(files_in(project.root / "chapters" / chapter.name, {".cpp"}));
}

std::vector<std::string> missing_files(const Project& project, const Chapter& chapter) {
    const fs::path solutions = project.root / "solutions" / chapter.name;
    std::vector<std::string> names = names_of(files_in(
        fs::is_directory(solutions) ? solutions : project.root / ".course" / "pristine" / chapter.name,
        {".cpp"}));
    std::erase_if(names, [&](const std::string& name) {
        return fs::exists(project.root / "chapters" / chapter.name / name);
    });
    return names;
}

std::string missing_message(const Project& project, const Chapter& chapter) {
    const std::vector<std::string> missing = missing_files(project, chapter);
    if (missing.empty()) return "";
    return fmt::format(
        "chapters/{}/{} is missing; ./course reset {} puts back what was deleted, and nothing else",
        chapter.name, missing.front(), chapter.number);
}

bool is_untouched(const Project& project, const Chapter& chapter) {
    if (!missing_files(project, chapter).empty()) return false;
    for (const std::string& file : exercise_files(project, chapter))
        if (pristine_text(project, chapter, file) !=
            read_file(project.root / "chapters" / chapter.name / file))
            return false;
    return true;
}

}  // namespace rt
