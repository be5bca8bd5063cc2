// `course test`: every test of the project, part by part, with times and one closing line.
#include "common/commands/commands.hpp"
#include "common/evidence/self_test.hpp"
#include "common/evidence/side_by_side.hpp"
#include "common/math/printable.hpp"
#include "common/math/stopwatch.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/drift.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <mutex>

namespace rt {

namespace {

void print(const SelfTest& part) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    for (const std::string& problem : part.problems) {
        const std::vector<std::string> lines = split_lines(printable(problem, Keep::Lines));
        for (std::size_t i = 0; i < lines.size(); ++i)
            fmt::print("  {} {}\n", i == 0 ? paint("✗", Tone::Bad) : "   ", lines[i]);
    }
    fmt::print("{:<28} {:>6} passed {:>4} failed  {:>10}\n", part.name, part.passed, part.failed,
               duration(part.seconds));
    flush_output();
}

/// A part that a function fills in; what it throws is a failure of the part.
template <class Fill>
SelfTest timed(const std::string& name, bool quiet, Fill fill) {
    const Stopwatch stopwatch;
    SelfTest part;
    part.name = name;
    try {
        fill(part);
    } catch (const std::exception& error) {
        part.expect(false, error.what());
    }
    part.seconds = stopwatch.seconds();
    if (!quiet) print(part);
    return part;
}

nlohmann::ordered_json to_json(const std::vector<SelfTest>& parts, int passed, int failed) {
    auto list = nlohmann::ordered_json::array();
    for (const SelfTest& part : parts)
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
    std::vector<SelfTest> parts;

    // The longest ones first: they run side by side.
    std::vector<std::string> programs{"test_submissions", "test_grading", "test_program",
                                      "test_common",      "test_report",  "test_leave_out"};
    for (const Chapter& chapter : chapters) programs.push_back("check_" + chapter.number + "_solution");
    std::vector<std::string> good;
    parts.push_back(timed("build", json, [&](SelfTest& part) { good = built(project, programs, part); }));
    std::vector<SelfTest> of_programs(good.size());
    side_by_side(good.size(), [&](std::size_t i) {
        of_programs[i] =
            timed(good[i], json, [&](SelfTest& part) { test_program(project, good[i], quick, part); });
    });
    parts.insert(parts.end(), of_programs.begin(), of_programs.end());

    parts.push_back(timed("known mistakes", json,
                          [&](SelfTest& part) { test_mistakes(project, chapters, quick, part); }));
    parts.push_back(timed("right variants", json,
                          [&](SelfTest& part) { test_variants(project, chapters, quick, part); }));
    if (!is_students_tree(project, chapters))
        parts.push_back(
            timed("exercises", json, [&](SelfTest& part) { test_exercises(project, chapters, part); }));
    if (!quick) parts.push_back(timed("scripts", json, [&](SelfTest& part) { test_scripts(project, part); }));

    int passed = 0, failed = 0;
    for (const SelfTest& part : parts) {
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
