// Known mistakes are applied to solutions, and refused where they no longer fit.
#include "common/workbook/mistake.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;

namespace {

const std::string good = R"(step 02.2
file quadratic.cpp
why  The roots are not sorted.

--- replace
    a;
    b;
--- with
    b;
--- end
--- replace
    c;
--- with
--- end
)";

std::string error_of(const std::string& text, const std::string& solution = "") {
    return test::error_of([&] { apply_mistake(parse_mistake(text, "m.mistake"), solution, "m.mistake"); });
}

std::string without(std::string text, const std::string& part) {
    text.erase(text.find(part), part.size());
    return text;
}

}  // namespace

TEST_CASE("a mistake file is read whole") {
    const Mistake mistake = parse_mistake(good, "m.mistake");
    CHECK(mistake.step == "02.2");
    CHECK(mistake.file == "quadratic.cpp");
    CHECK(mistake.why == "The roots are not sorted.");
    REQUIRE(mistake.replacements.size() == 2);
    CHECK(mistake.replacements[0].from == "    a;\n    b;\n");
    CHECK(mistake.replacements[0].to == "    b;\n");
    CHECK(mistake.replacements[1].to.empty());
}

TEST_CASE("a mistake may say what its message shows") {
    CHECK(parse_mistake(good, "m").shows.empty());
    CHECK(parse_mistake("shows the roots ascend\n" + good, "m").shows == "the roots ascend");
}

TEST_CASE("all the groups of a mistake are applied") {
    const std::string solution = "x\n    a;\n    b;\ny\n    c;\nz\n";
    CHECK(apply_mistake(parse_mistake(good, "m"), solution, "m") == "x\n    b;\ny\nz\n");
}

TEST_CASE("a text to replace must stand in the solution exactly once") {
    CHECK(error_of(good, "    a;\n    b;\n    c;\n    c;\n") ==
          "m.mistake:11: the text to replace stands 2 times in quadratic.cpp; expected once");
    CHECK(error_of(good, "    c;\n") ==
          "m.mistake:5: the text to replace does not stand in quadratic.cpp; expected once");
}

TEST_CASE("an incomplete mistake file is refused") {
    CHECK(error_of(without(good, "step 02.2\n")).find("expected a line 'step NN.S'") != std::string::npos);
    CHECK(error_of(without(good, "file quadratic.cpp\n")).find("expected a line 'file") != std::string::npos);
    CHECK(error_of(without(good, "why  The roots are not sorted.\n")).find("'why") != std::string::npos);
    CHECK(error_of("step 02.2\nfile x.cpp\nwhy y\n").find("expected a group") != std::string::npos);
    CHECK(error_of(good.substr(0, good.rfind("--- end"))).find("not closed") != std::string::npos);
    CHECK(error_of(without(good, "--- with\n")).substr(0, 12) == "m.mistake:9:");
    CHECK(error_of("stop 02.2\n") ==
          "m.mistake:1: expected 'step', 'file', 'why', 'shows' or '--- replace', not 'stop 02.2'");
}
