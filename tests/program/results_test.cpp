// From the report of a test program to the state of each step, and what is remembered of it.
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/causes.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/drift.hpp"
#include "common/workbook/next_step.hpp"
#include "common/workbook/result_text.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <nlohmann/json.hpp>

using namespace rt;

namespace {

TestRun run(State state, std::vector<std::string> steps, const std::string& missing = "") {
    return {"a test", std::move(steps), state, state == State::Failed ? "a.cpp:1: CHECK( x )" : "", missing};
}

struct Tree {
    Project project = test::sandbox("results");
    std::vector<Chapter> chapters;
    Tree() {
        test::add_chapter(project, "02_spheres", test::good_chapter);
        chapters = read_catalogue(project);
    }
    std::filesystem::path exercise() const { return project.root / "chapters/02_spheres/x.cpp"; }
    const Chapter& chapter() const { return chapters[0]; }
    void start_first_step() const {
        std::string text = read_file(exercise());
        const std::string todo = "return todo(\"02.1\");";
        text.replace(text.find(todo), todo.size(), "return 7;");
        test::write(exercise(), text);
    }
};

}  // namespace

TEST_CASE("a report is read as far as it was written") {
    const std::string started = R"({"started":"first","steps":["02.1"]})";
    const std::string ended =
        R"({"ended":"first","steps":["02.1"],"state":"failed","message":"why","missing":""})";
    const std::string second = R"({"started":"second","steps":["02.2"]})";

    TestReport report = read_report(started + "\n" + ended + "\n" + R"({"finished":true})" + "\n");
    CHECK(report.complete);
    CHECK_FALSE(report.died_in);
    REQUIRE(report.ended.size() == 1);
    CHECK(report.ended[0].state == State::Failed);
    CHECK(report.ended[0].message == "why");

    report = read_report(started + "\n" + ended + "\n" + second + "\n");
    CHECK_FALSE(report.complete);
    REQUIRE(report.died_in);
    CHECK(report.died_in->name == "second");
    CHECK(report.died_in->steps == std::vector<std::string>{"02.2"});

    report = read_report(started + "\n" + ended.substr(0, 20));
    CHECK(report.ended.empty());
    CHECK(report.died_in->name == "first");
    CHECK_FALSE(read_report("").complete);
}

TEST_CASE("a step has failed if any of its tests has") {
    const StepResult result =
        result_of("02.1", {run(State::Passed, {"02.1"}), run(State::Todo, {"02.1"}, "02.1"),
                           run(State::Failed, {"02.1", "02.2"}), run(State::Passed, {"02.2"})});
    CHECK(result.state == State::Failed);
    CHECK(result.message == "a test\na.cpp:1: CHECK( x )");
}

TEST_CASE("a plain test speaks before a family of extreme cases, whichever failed first") {
    TestRun family = run(State::Failed, {"02.1", "stability"}), plain = run(State::Failed, {"02.1"});
    family.name = "a family";
    CHECK(result_of("02.1", {family, plain}).message == "a test\na.cpp:1: CHECK( x )");
    CHECK(result_of("02.1", {plain, family}).message == "a test\na.cpp:1: CHECK( x )");
    CHECK(result_of("02.1", {family, run(State::Passed, {"02.1"})}).message ==
          "a family\na.cpp:1: CHECK( x )");
}

TEST_CASE("a step is todo while a function that its tests need is not started") {
    CHECK(result_of("02.1", {run(State::Todo, {"02.1"}, "02.1")}).state == State::Todo);
    CHECK(result_of("02.1", {run(State::Todo, {"02.1"}, "02.1")}).message.empty());
    CHECK(result_of("02.2", {run(State::Todo, {"02.2"}, "02.1")}).message == "waits for step 02.1");
    CHECK(result_of("02.1", {run(State::Passed, {"02.1"}), run(State::Todo, {"02.1"}, "02.1")}).message ==
          "begun: 1 of 2 tests pass");
}

TEST_CASE("a step passes when all its tests do, and there are some") {
    CHECK(result_of("02.1", {run(State::Passed, {"02.1"}), run(State::Failed, {"02.2"})}).state ==
          State::Passed);
    CHECK(result_of("02.3", {run(State::Passed, {"02.1"})}).state == State::Failed);
    CHECK(result_of("02.3", {}).message == "no test has the tag [02.3]");
}

TEST_CASE("an exercise that was not touched is todo without a check") {
    const Tree tree;
    CHECK(is_untouched(tree.project, tree.chapter()));
    const KnownResult known = known_result(tree.project, tree.chapter());
    CHECK(known.current);
    CHECK(steps_done(known.result).passed == 0);
    CHECK(steps_done(known.result).all == 2);
}

TEST_CASE("a verdict is remembered until a file of the chapter changes") {
    const Tree tree;
    tree.start_first_step();
    CHECK_FALSE(known_result(tree.project, tree.chapter()).current);

    ChapterResult result = all_todo(tree.chapter());
    result.steps[0] = {"02.1", State::Passed, ""};
    result.steps[1] = {"02.2", State::Failed, "why\nwhere"};
    remember(tree.project, tree.chapter(), result, sources_fingerprint(tree.project, tree.chapter()));
    KnownResult known = known_result(tree.project, tree.chapter());
    CHECK(known.current);
    CHECK(known.result.steps[0].state == State::Passed);
    CHECK(known.result.steps[1].message == "why\nwhere");

    test::write(tree.exercise(), read_file(tree.exercise()) + "// more\n");
    known = known_result(tree.project, tree.chapter());
    CHECK_FALSE(known.current);
    CHECK(known.result.steps[0].state == State::Passed);
}

TEST_CASE("a damaged memory is as good as none") {
    const Tree tree;
    tree.start_first_step();
    for (const char* damage : {"", "[1]", "{\"02_spheres\":3}", "{\"02_spheres\":{\"build_error\":\"\"}}"}) {
        INFO("memory := " << damage);
        test::write(tree.project.root / ".course" / "state.json", damage);
        CHECK_FALSE(known_result(tree.project, tree.chapter()).current);
        CHECK_NOTHROW(remember(tree.project, tree.chapter(), all_todo(tree.chapter()), "1234"));
    }
}

TEST_CASE("without solutions the original comes from the handout") {
    const Tree tree;
    const std::string original = read_file(tree.exercise());
    std::filesystem::remove_all(tree.project.root / "solutions");
    CHECK_FALSE(pristine_text(tree.project, tree.chapter(), "x.cpp"));
    test::write(tree.project.root / ".course/pristine/02_spheres/x.cpp", original);
    CHECK(pristine_text(tree.project, tree.chapter(), "x.cpp") == original);
    CHECK(is_untouched(tree.project, tree.chapter()));
}

TEST_CASE("an exercise that its solution does not generate has drifted") {
    const Tree tree;
    CHECK(drifted_exercises(tree.project, tree.chapters).empty());
    test::write(tree.exercise(), read_file(tree.exercise()) + "\n");
    const auto drifted = drifted_exercises(tree.project, tree.chapters);
    REQUIRE(drifted.size() == 1);
    CHECK(drifted[0].file == tree.exercise());
    CHECK_FALSE(is_students_tree(tree.project, tree.chapters));
}

TEST_CASE("marks must name steps of the chapter, and every step must be marked") {
    const Tree tree;
    const auto solution = tree.project.root / "solutions/02_spheres/x.cpp";
    const std::string text = read_file(solution);
    std::string wrong = text;
    wrong.replace(wrong.find("02.2"), 4, "02.7");
    test::write(solution, wrong);
    CHECK_THROWS_WITH(drifted_exercises(tree.project, tree.chapters),
                      "solutions/02_spheres/x.cpp:10: chapters/02_spheres/chapter.json has no step 02.7");
    wrong.replace(wrong.find("02.7"), 4, "02.1");
    test::write(solution, wrong);
    CHECK_THROWS_WITH(drifted_exercises(tree.project, tree.chapters),
                      "solutions/02_spheres/x.cpp marks nothing as [exercise 02.2]");
}

TEST_CASE("a tree is a student's once a step is started") {
    const Tree tree;
    CHECK_FALSE(is_students_tree(tree.project, tree.chapters));
    tree.start_first_step();
    CHECK(is_students_tree(tree.project, tree.chapters));
}

TEST_CASE("there is one next action") {
    const Tree tree;
    std::vector<KnownResult> known{{all_todo(tree.chapter()), true}};
    const auto next = [&] { return next_action(tree.project, tree.chapters, known); };
    CHECK(next().find("write step 02.1 in chapters/02_spheres/x.cpp") != std::string::npos);

    known[0].result.steps[0].message = "waits for step 02.2";
    CHECK(next().find("write step 02.2 in chapters/02_spheres/x.cpp") != std::string::npos);
    known[0].result.steps[0] = {"02.1", State::Passed, ""};
    known[0].result.steps[1] = {"02.2", State::Failed, "why"};
    CHECK(next().find("mend step 02.2") == 0);
    known[0].result.build_error = "x.cpp:1:1: error: y";
    CHECK(next() == "mend the compile error, then ./course check 02");
    known[0].current = false;
    CHECK(next() == "./course check 02");
    known[0] = {{"02_spheres", "", {{"02.1", State::Passed, ""}, {"02.2", State::Passed, ""}}}, true};
    CHECK(next().find("every step has passed. Draw a scene of your own") == 0);
    CHECK(next().find("./course tour") != std::string::npos);
    CHECK(next().find("The lessons end with challenges.") != std::string::npos);
    known[0].result.steps[1] = {"02.2", State::Todo, "", "", true};
    CHECK(next().find("The lessons end with challenges; 02.2 can be checked.") != std::string::npos);
    known[0].result.steps[1].state = State::Failed;
    CHECK(next().find("mend step 02.2") == 0);
}

TEST_CASE("between two chapters, what is optional in the first is named") {
    const Tree tree;
    std::vector<Chapter> chapters(2);
    std::vector<KnownResult> known(2);
    for (std::size_t i = 0; i < 2; ++i) {
        chapters[i] = tree.chapter();
        chapters[i].number = i == 0 ? "02" : "03";
        known[i] = {all_todo(chapters[i]), true};
    }
    const auto next = [&] { return next_action(tree.project, chapters, known); };
    std::vector<StepResult>& first = known[0].result.steps;
    std::vector<StepResult>& second = known[1].result.steps;
    first = {{"02.1", State::Passed, ""}, {"02.2", State::Todo, "", "", true}};
    CHECK_THAT(next(), Catch::StartsWith("read chapters/02_spheres/README.md and write step 02.1") &&
                           Catch::EndsWith("; or first step 02.2, which is optional"));
    // Neither after it has passed, nor once the second chapter is begun.
    first[1].state = State::Passed;
    CHECK_THAT(next(), !Catch::Contains("optional"));
    first[1].state = State::Todo;
    second[0].message = "begun: 1 of 2 tests pass";
    CHECK_THAT(next(), !Catch::Contains("optional"));
    second[0] = {"02.1", State::Passed, ""};
    CHECK_THAT(next(), !Catch::Contains("optional"));
    second = all_todo(chapters[1]).steps;
    first = {{"02.1", State::Passed, ""},
             {"02.2", State::Todo, "", "", true},
             {"02.3", State::Todo, "", "", true}};
    CHECK_THAT(next(), Catch::EndsWith("; or first steps 02.2 and 02.3, which are optional"));
}

TEST_CASE("a chapter is complete without its optional steps, but not while one of them is wrong") {
    ChapterResult result{
        "02_spheres", "", {{"02.1", State::Passed, ""}, {"02.2", State::Todo, "", "", true}}};
    CHECK(all_passed(result));
    CHECK(steps_done(result).passed == 1);
    CHECK(steps_done(result).all == 1);
    result.steps[1].state = State::Failed;
    CHECK_FALSE(all_passed(result));
    // Whoever asks for it alone wants to know.
    result = {"02_spheres", "", {{"02.2", State::Todo, "", "", true}}};
    CHECK_FALSE(all_passed(result));
    CHECK(steps_done(result).all == 1);
    result.steps[0].state = State::Passed;
    CHECK(all_passed(result));
}

TEST_CASE("the next step is one that has not passed, from where one is on and round") {
    std::vector<Chapter> chapters(2);
    std::vector<KnownResult> known(2);
    for (std::size_t i = 0; i < 2; ++i) {
        chapters[i].number = std::to_string(i + 1);
        for (const char* step : {".1", ".2", ".3"})
            chapters[i].steps.push_back({chapters[i].number + step, "", "", 1, {}});
        known[i] = {all_todo(chapters[i]), true};
    }
    const auto pass = [&](std::size_t chapter, std::size_t step) {
        known[chapter].result.steps[step].state = State::Passed;
    };
    const auto after = [&](std::size_t chapter, std::size_t step) {
        const auto next = next_step(chapters, known, {&chapters[chapter], &chapters[chapter].steps[step]});
        return next ? next->step->id : "none";
    };
    CHECK(after(0, 1) == "1.2");  // it has not passed itself
    pass(0, 1);
    CHECK(after(0, 1) == "1.3");
    pass(0, 2);
    CHECK(after(0, 1) == "1.1");  // what was skipped
    pass(0, 0);
    CHECK(after(0, 1) == "2.1");
    for (std::size_t i = 0; i < 3; ++i) pass(1, i);
    CHECK(after(0, 1) == "none");
    known[0].current = false;
    CHECK(after(1, 2) == "1.1");  // it changed since
    known[0].current = true;
    known[1].result.steps[2].state = State::Todo;
    chapters[1].steps[2].optional = true;
    CHECK(after(0, 1) == "none");
    CHECK(after(1, 2) == "2.3");  // where one is
}

TEST_CASE("the compiler's first error is found among what a build says") {
    const Project project{"/home/course", "/home/course/build"};
    CHECK(first_error(project,
                      "[1/3] Building CXX object x.o\nFAILED: x.o\nc++ -Werror -c x.cpp\n"
                      "In file included from a.hpp:1:\n"
                      "/home/course/chapters/02_spheres/x.cpp:5:9: error: 'y' was not declared\n"
                      "/home/course/chapters/02_spheres/x.cpp:7:9: error: second\n"
                      "ninja: build stopped: subcommand failed.\n") ==
          "chapters/02_spheres/x.cpp:5:9: error: 'y' was not declared");
    CHECK(first_error(project,
                      "a\n/usr/bin/ld: x.o: undefined reference to `f()'\ncollect2: error: ld returned 1 "
                      "exit status\n") == "the function f() is called, and nowhere written");
    CHECK(first_error(project, "/usr/bin/ld: x.o: multiple definition of `f()'\n") ==
          "/usr/bin/ld: x.o: multiple definition of `f()'");
    // Gold says "error", as a compiler does, which comes first where there is one.
    const std::string gold =
        "/usr/bin/ld.gold: error: x.o: multiple definition of 'f()'\n"
        "/usr/bin/ld.gold: y.o: previous definition here\n";
    CHECK(first_error(project, gold) == "/usr/bin/ld.gold: error: x.o: multiple definition of 'f()'");
    CHECK(first_error(project, "y.o:/home/course/y.cpp:12: error: undefined reference to 'f()'\n") ==
          "the function f() is called, and nowhere written");
    const std::string twice = "x.cpp:3:7: error: multiple definition of 'struct S'";
    CHECK(first_error(project, gold + twice + "\n") == twice);
    CHECK(first_error(project, "first\nlast\n") == "last");
}

namespace {

/// Chapters with steps that use others: 01.2 uses 01.1, 01.3 uses 01.2, 02.1 uses 01.3, 02.2 nothing.
std::vector<Chapter> steps_on_steps() {
    Chapter one{"01_first", "01", "One", "", {}, {}}, two{"02_second", "02", "Two", "", {}, {}};
    one.steps = {{"01.1", "A", "x.cpp", 1, {}, {}},
                 {"01.2", "B", "x.cpp", 1, {}, {"01.1"}},
                 {"01.3", "C", "x.cpp", 1, {}, {"01.2"}}};
    two.steps = {{"02.1", "D", "y.cpp", 1, {}, {"01.3"}}, {"02.2", "E", "y.cpp", 1, {}, {}}};
    return {one, two};
}

}  // namespace

TEST_CASE("a failure names the first failed step that it may follow from") {
    const std::vector<Chapter> chapters = steps_on_steps();
    ChapterResult result{
        "01_first",
        "",
        {{"01.1", State::Failed, "why"}, {"01.2", State::Passed, ""}, {"01.3", State::Failed, "why"}}};
    find_causes(chapters, {}, result);
    CHECK(result.steps[0].because == "");
    CHECK(result.steps[1].because == "");
    CHECK(result.steps[2].because == "01.1");
    CHECK(next_action(chapters[0], result).starts_with("mend step 01.1 in chapters/01_first/x.cpp"));
    CHECK_THAT(step_line(chapters[0].steps[2], result.steps[2]), Catch::Contains("perhaps because of 01.1"));

    result.steps[0].state = State::Passed;
    result.steps[2].because = "";
    find_causes(chapters, {}, result);
    CHECK(result.steps[2].because == "");

    ChapterResult unbuilt{"01_first", "x.cpp:1: error: y", result.steps};
    unbuilt.steps[1].state = State::Failed;
    find_causes(chapters, {}, unbuilt);
    CHECK(unbuilt.steps[2].because == "");
}

TEST_CASE("a failure may follow from an earlier chapter's step") {
    const std::vector<Chapter> chapters = steps_on_steps();
    ChapterResult result{"02_second", "", {{"02.1", State::Failed, "why"}, {"02.2", State::Passed, ""}}};
    find_causes(chapters, {"01.2"}, result);
    CHECK(result.steps[0].because == "01.2");
    CHECK(next_action(chapters[1], result) ==
          "./course check 01.2 shows what is wrong with step 01.2, which step 02.1 uses");
    result.steps[1].state = State::Failed;
    find_causes(chapters, {"01.2"}, result);
    CHECK(next_action(chapters[1], result).starts_with("mend step 02.2 in chapters/02_second/y.cpp"));
}

TEST_CASE("which failed step another follows from is remembered") {
    const Tree tree;
    tree.start_first_step();
    ChapterResult result = all_todo(tree.chapter());
    result.steps[1] = {"02.2", State::Failed, "why", "02.1"};
    remember(tree.project, tree.chapter(), result, sources_fingerprint(tree.project, tree.chapter()));
    CHECK(known_result(tree.project, tree.chapter()).result.steps[1].because == "02.1");
}

TEST_CASE("verdicts as JSON have the documented form") {
    const Tree tree;
    ChapterResult result = all_todo(tree.chapter());
    result.steps[1] = {"02.2", State::Failed, "why"};
    CHECK(results_json(tree.chapters, {result}).dump() ==
          R"({"chapters":[{"id":"02_spheres","title":"Spheres","hours":3,"steps":[)"
          R"({"id":"02.1","title":"First","points":10,"state":"todo","message":""},)"
          R"({"id":"02.2","title":"Second","points":5,"state":"failed","message":"why"}]}]})");
}

TEST_CASE("words that are not UTF-8 are remembered escaped") {
    const Tree tree;
    tree.start_first_step();
    ChapterResult result = all_todo(tree.chapter());
    result.build_error = "x.cpp:1: error: caf\xe9";
    result.steps[0] = {"02.1", State::Failed, "\xff\x1b"};
    remember(tree.project, tree.chapter(), result, sources_fingerprint(tree.project, tree.chapter()));
    const KnownResult known = known_result(tree.project, tree.chapter());
    CHECK(known.current);
    CHECK(known.result.build_error == "x.cpp:1: error: caf\\xe9");
    CHECK(known.result.steps[0].message == "\\xff\x1b");
}
