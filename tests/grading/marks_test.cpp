// Marks worked out by hand, and what of a step's checks its student is told.
#include "common/grading/marks.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"

using namespace rt;

namespace {

TestRun check(const std::string& name, State state, const std::string& said = "") {
    TestRun run{name, {"02.1"}, state, said, ""};
    if (state == State::Todo) run.missing = "02.1";
    return run;
}

TestRun family(const std::string& name, State state, const std::string& said = "") {
    TestRun run = check(name, state, said);
    run.steps.push_back("stability");
    return run;
}

std::vector<TestRun> checks(int passed, int failed) {
    std::vector<TestRun> all;
    for (int i = 0; i < passed; ++i) all.push_back(check("right", State::Passed));
    for (int i = 0; i < failed; ++i) all.push_back(check("wrong", State::Failed, "1 == 2"));
    return all;
}

GradedStep mark(const StepRubric& rubric, const StepRun& run, int late = 100) {
    const std::vector<Chapter> chapters = test::two_chapters();
    return marked(chapters[1], chapters[1].steps[0], rubric, late, run);
}

std::string points(const StepRubric& rubric, const StepRun& run, int late = 100) {
    return text_of(mark(rubric, run, late).earned);
}

const StepRubric all_of_15{whole_points(15), Credit::All, false, {}};
const StepRubric part_of_15{whole_points(15), Credit::Part, false, {}};

}  // namespace

TEST_CASE("all or nothing") {
    CHECK(points(all_of_15, {checks(7, 0), {}, {}, ""}) == "15");
    CHECK(points(all_of_15, {checks(6, 1), {}, {}, ""}) == "0");
    CHECK(points(all_of_15, {checks(6, 0), {check("not reached", State::Todo)}, {}, ""}) == "0");
    CHECK(points(all_of_15, {{}, {}, {}, ""}) == "0");
    CHECK(points({whole_points(0), Credit::All, false, {}}, {checks(7, 0), {}, {}, ""}) == "0");
}

TEST_CASE("by parts: 15 points, of 7 checks") {
    CHECK(points(part_of_15, {checks(7, 0), {}, {}, ""}) == "15");
    CHECK(points(part_of_15, {checks(6, 1), {}, {}, ""}) == "12.86");  // 12.857…
    CHECK(points(part_of_15, {checks(1, 6), {}, {}, ""}) == "2.14");   // 2.142…
    CHECK(points(part_of_15, {checks(0, 7), {}, {}, ""}) == "0");
    // One passed before the crash, and six were never asked.
    const std::vector<TestRun> rest(6, check("not reached", State::Todo));
    CHECK(points(part_of_15, {checks(1, 0), rest, Stop{Verdict::Crashed, "segmentation fault", {}}, ""}) ==
          "2.14");
}

TEST_CASE("late work, rounded once and halves up") {
    CHECK(points(all_of_15, {checks(7, 0), {}, {}, ""}, 90) == "13.5");
    CHECK(points(all_of_15, {checks(7, 0), {}, {}, ""}, 0) == "0");
    CHECK(points(part_of_15, {checks(6, 1), {}, {}, ""}, 90) ==
          "11.57");  // 11.571…, not 0.9 · 12.86 = 11.574
    CHECK(points({whole_points(1), Credit::Part, false, {}}, {checks(1, 7), {}, {}, ""}, 100) ==
          "0.13");  // 0.125
    CHECK(points({whole_points(3), Credit::Part, false, {}}, {checks(1, 1), {}, {}, ""}, 97) ==
          "1.46");  // 1.455
}

TEST_CASE("what a step's mark is made of is told") {
    StepRubric rubric = part_of_15;
    rubric.extra = true;
    const GradedStep step = mark(rubric, {checks(2, 1), {}, {}, "png"}, 80);
    CHECK(step.id == "02.1");
    CHECK(step.title == "The roots");
    CHECK(step.file == "chapters/02_spheres/sphere.cpp");
    CHECK(step.possible == whole_points(15));
    CHECK(step.extra);
    CHECK(step.late_percent == 80);
    CHECK(step.checks == CheckCount{2, 3});
    CHECK(step.hidden == CheckCount{0, 0});
    CHECK(step.failure == FailedCheck{"wrong", "1 == 2"});
    CHECK(step.hint == 1);
    CHECK(step.difference == "png");
}

TEST_CASE("verdicts") {
    const auto verdict = [](const StepRun& run) { return mark(all_of_15, run).verdict; };
    CHECK(verdict({checks(7, 0), {}, {}, ""}) == Verdict::Passed);
    CHECK(verdict({checks(6, 1), {}, {}, ""}) == Verdict::Failed);
    CHECK(verdict({{}, {}, {}, ""}) == Verdict::Failed);
    CHECK(verdict({{check("a", State::Todo)}, {}, {}, ""}) == Verdict::Todo);
    CHECK(verdict({checks(1, 0), checks(1, 0), {}, ""}) == Verdict::Failed);
    for (const Verdict stopped :
         {Verdict::Crashed, Verdict::TimedOut, Verdict::TooMuchMemory, Verdict::NotCompiled})
        CHECK(verdict({checks(3, 0), {}, Stop{stopped, "why", {}}, ""}) == stopped);
    for (const auto& [hint, run] :
         {std::pair{0, StepRun{checks(7, 0), {}, {}, ""}}, std::pair{1, StepRun{checks(0, 1), {}, {}, ""}}})
        CHECK(mark(all_of_15, run).hint == hint);
}

TEST_CASE("a step that waits for another needs it; one that is not written is to do") {
    TestRun waiting = check("b", State::Todo);
    waiting.missing = "01.1";
    const GradedStep waits = mark(all_of_15, {{check("a", State::Passed), waiting}, {}, {}, ""});
    CHECK(waits.verdict == Verdict::NeedsStep);
    CHECK(waits.needs == "01.1");
    CHECK(waits.hint == 0);
    const GradedStep own = mark(all_of_15, {{waiting, check("c", State::Todo)}, {}, {}, ""});
    CHECK(own.verdict == Verdict::Todo);
    CHECK(own.needs == "");
}

TEST_CASE("of those that fail a plain check speaks, and what stopped the rest comes after it") {
    const StepRun run{
        {family("many", State::Failed, "far"), check("one", State::Failed, "a.cpp:1: 1 == 2\nso")},
        {check("last", State::Todo)},
        Stop{Verdict::TimedOut, "did not finish in 10 s", check("last", State::Todo)},
        ""};
    const GradedStep step = mark(all_of_15, run);
    CHECK(step.verdict == Verdict::TimedOut);
    CHECK(step.failure == FailedCheck{"one", "a.cpp:1: 1 == 2\nso\nAfter that: did not finish in 10 s"});
    CHECK(step.checks == CheckCount{0, 3});
    const GradedStep only = mark(all_of_15, {checks(1, 0), {check("last", State::Todo)}, run.stop, ""});
    CHECK(only.failure == FailedCheck{"last", "did not finish in 10 s"});
}

TEST_CASE("hidden checks count, and what they say is kept apart") {
    StepRubric rubric = part_of_15;
    rubric.hidden = {"[stability]", "secret"};
    const StepRun run{
        {check("plain", State::Passed), family("many", State::Failed, "far"), check("secret", State::Passed)},
        {},
        {},
        ""};
    const GradedStep step = mark(rubric, run);
    CHECK(text_of(step.earned) == "10");  // two of three
    CHECK(step.verdict == Verdict::Failed);
    CHECK(step.checks == CheckCount{1, 1});
    CHECK(step.hidden == CheckCount{1, 2});
    CHECK_FALSE(step.failure);
    CHECK(step.hidden_failure == FailedCheck{"many", "far"});
    rubric.credit = Credit::All;
    CHECK(mark(rubric, run).earned == Points{});
}

TEST_CASE("a crash in a hidden check does not tell its name") {
    StepRubric rubric = all_of_15;
    rubric.hidden = {"secret"};
    const TestRun secret = check("secret", State::Todo);
    const GradedStep step =
        mark(rubric, {checks(2, 0), {secret}, Stop{Verdict::Crashed, "segmentation fault", secret}, ""});
    CHECK(step.verdict == Verdict::Crashed);
    CHECK_FALSE(step.failure);
    CHECK(step.hidden_failure == FailedCheck{"secret", "segmentation fault"});
    CHECK(step.checks == CheckCount{2, 2});
    CHECK(step.hidden == CheckCount{0, 1});
}

TEST_CASE("what hides nothing is named") {
    Rubric rubric = default_rubric(test::two_chapters());
    rubric.steps.at("02.1").hidden = {"[stability]", "secrte"};
    CHECK(hides_nothing(rubric, {family("a", State::Todo), check("secret", State::Todo)}) ==
          std::vector<std::string>{"02.1: secrte"});
}

TEST_CASE("points are exact") {
    Grade grade = test::troubled("a");
    CHECK(text_of(earned(grade)) == "17.5");
    CHECK(text_of(possible(grade)) == "25");  // 20 more are extra credit
    Points sum;
    for (int i = 0; i < 10; ++i) sum += {10};
    CHECK(sum == whole_points(1));
    CHECK(text_of({5}) == "0.05");
    CHECK(text_of({123456}) == "1234.56");
    CHECK(text_of(whole_points(100)) == "100");
    CHECK(text_of({0}) == "0");
}
