// What a student's code printed, test by test, and what of it is shown.
#include "common/workbook/printed.hpp"
#include "common/workbook/result_text.hpp"
#include "tests/catch.hpp"

using namespace rt;

TEST_CASE("what is printed is told with its test, and the program's own last line is not") {
    const auto printed = read_printed(
        "before\n"
        "\x1e"
        "a miss\n"
        "\x1e"
        "two roots\n"
        "h = 3\n\nd = \x1b[2J 4"  // no end of line
        "\x1e"
        "one root\n"
        "h = 5\n"
        "/usr/include/c++/12/span:278: operator[]: Assertion '__idx < size()' failed.\n"
        "\x1e\n"
        "2 passed, 1 failed\n");
    REQUIRE(printed.size() == 3);
    CHECK(printed[0].test.empty());
    CHECK(printed[0].lines == std::vector<std::string>{"before"});
    CHECK(printed[1].test == "two roots");
    CHECK(printed[1].lines == std::vector<std::string>{"h = 3", "d = \\x1b[2J 4"});
    CHECK(printed[2].test == "one root");
    CHECK(read_printed("").empty());
    // A crash ends it anywhere.
    CHECK(read_printed("\x1e"
                       "a miss")
              .empty());
}

TEST_CASE("what was printed in the test that failed is shown, and how much there is beside it") {
    std::vector<Printed> printed{{"first", {"a"}}, {"second", {"b", "c"}}};
    CHECK(printed_in_words({}, "second").empty());
    CHECK(printed_in_words(printed, "second") ==
          "  Printed in the test \"second\":\n      b\n      c\n      (1 line in 1 other test)\n");
    CHECK(printed_in_words(printed, "third") ==
          "  Printed in the test \"first\":\n      a\n      (2 lines in 1 other test)\n");
    std::string many;
    for (int i = 0; i < 5000; ++i) many += "a\n";
    const std::string text = printed_in_words(read_printed(many), "");
    CHECK(text.starts_with("  Printed before the first test:\n      a\n"));
    CHECK(text.ends_with("      … and 4990 more lines\n"));
}

TEST_CASE("below the steps stand what the first failed test printed, and the compiler's warnings") {
    ChapterResult result{
        "02_spheres", "", {{"02.1", State::Passed, ""}, {"02.2", State::Failed, "second\nwhy"}}};
    CHECK(notes(result).empty());
    result.printed = {{"first", {"a"}}, {"second", {"b"}}};
    result.warnings = {"chapters/02_spheres/x.cpp:3:1: warning: no return statement"};
    CHECK(notes(result) ==
          "  Printed in the test \"second\":\n      b\n      (1 line in 1 other test)\n"
          "  The compiler warns:\n      chapters/02_spheres/x.cpp:3:1: warning: no return statement\n");
    result.steps[1].message = "crashed (abort) in the test \"second\"\nin f, chapters/02_spheres/x.cpp:3";
    CHECK(notes(result).starts_with("  Printed in the test \"second\""));
}
