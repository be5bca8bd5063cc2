// grading.json is read strictly: what it leaves out has a default, and every complaint is one line with its
// place.
#include "common/grading/rubric.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"
#include "tests/grading/schema.hpp"
#include "tests/support.hpp"

using namespace rt;

namespace {

Rubric read(const std::string& text) { return read_rubric("grading.json", text, test::two_chapters()); }

std::string error_of(const std::string& text) {
    return test::error_of([&] { read(text); });
}

}  // namespace

TEST_CASE("without a grading.json points are the chapters', all or nothing") {
    const Rubric rubric = default_rubric(test::two_chapters());
    CHECK(digest_of(rubric) == digest_of(read(R"({"version": 1})")));
    REQUIRE(rubric.steps.size() == 3);
    CHECK(rubric.steps.at("02.1").points == whole_points(15));
    CHECK(rubric.steps.at("02.1").credit == Credit::All);
    CHECK_FALSE(rubric.steps.at("02.1").extra);
    CHECK(rubric.steps.at("02.1").hidden.empty());
    CHECK(late_percent(rubric, "02", test::moment("9999-01-01T00:00:00Z")) == 100);
}

TEST_CASE("an optional step's points are extra credit, unless the instructor says otherwise") {
    std::vector<Chapter> chapters = test::two_chapters();
    chapters[1].steps[1].optional = true;
    CHECK(default_rubric(chapters).steps.at("02.2").extra);
    CHECK_FALSE(default_rubric(chapters).steps.at("02.1").extra);
    const std::string own = R"({"version": 1, "steps": {"02.2": {"extra": false}}})";
    CHECK_FALSE(read_rubric("grading.json", own, chapters).steps.at("02.2").extra);
}

TEST_CASE("a grading.json is read with all that it says") {
    const Rubric rubric = read(R"({
      "version": 1, "credit": "part", "hidden": ["[stability]"],
      "steps": {"02.1": {"points": 30, "credit": "all", "extra": true, "hidden": ["a far sphere"]}},
      "due": {"02": "2027-03-01T23:59:00+01:00"},
      "late": [{"hours": 24, "percent": 90}, {"hours": 72, "percent": 50}],
      "shown_from": {"marks": "2027-03-08T00:00Z", "hidden": "2027-04-01T00:00:00Z"}
    })");
    CHECK(rubric.steps.at("01.1").credit == Credit::Part);
    CHECK(rubric.steps.at("01.1").hidden == std::vector<std::string>{"[stability]"});
    CHECK(rubric.steps.at("02.1").points == whole_points(30));
    CHECK(rubric.steps.at("02.1").credit == Credit::All);
    CHECK(rubric.steps.at("02.1").extra);
    CHECK(rubric.steps.at("02.1").hidden == std::vector<std::string>{"[stability]", "a far sphere"});
    CHECK(text_of(rubric.due.at("02")) == "2027-03-01T22:59:00Z");
    CHECK(text_of(*rubric.marks_from) == "2027-03-08T00:00:00Z");
    CHECK(text_of(*rubric.hidden_from) == "2027-04-01T00:00:00Z");
}

TEST_CASE("what is left of late work") {
    const Rubric rubric = read(R"({"version": 1, "due": {"02": "2027-03-01T12:00Z"},
        "late": [{"hours": 24, "percent": 90}, {"hours": 72, "percent": 50}]})");
    const auto left = [&](const std::string& time) { return late_percent(rubric, "02", test::moment(time)); };
    CHECK(left("2027-03-01T12:00:00Z") == 100);
    CHECK(left("2027-03-01T12:00:01Z") == 90);
    CHECK(left("2027-03-02T12:00:00Z") == 90);
    CHECK(left("2027-03-02T12:00:01Z") == 50);
    CHECK(left("2027-03-04T12:00:00Z") == 50);
    CHECK(left("2027-03-04T12:00:01Z") == 0);
    // Nobody is late for a chapter without a date, nor at an unknown time.
    CHECK(late_percent(rubric, "01", test::moment("2027-12-01T12:00:00Z")) == 100);
    CHECK(late_percent(rubric, "02", std::nullopt) == 100);
}

TEST_CASE("what is wrong in a grading.json is said in one line with its place") {
    CHECK(error_of("") ==
          "grading.json:1:1: is not JSON: while parsing value - unexpected end of input; expected "
          "'[', '{', or a literal");
    CHECK(error_of("{\n  \"version\": 1,,\n}").find("grading.json:2:16: is not JSON: ") == 0);
    CHECK(error_of("[1]") == "grading.json:1:1: the file: expected an object");
    CHECK(error_of("{}") == "grading.json:1:1: the file: 'version' is missing");
    CHECK(error_of(R"({"version": 2})") == "grading.json:1:13: version: expected a whole number from 1 to 1");
    CHECK(error_of("{\"version\": 1,\n  \"credits\": \"part\"}") ==
          "grading.json:2:14: credits: is not known; there are version, credit, hidden, steps, due, late, "
          "shown_from");
    CHECK(error_of("{\"version\": 1,\n \"steps\": {\n  \"02.1\": {\"points\": -1}}}") ==
          "grading.json:3:22: steps/02.1/points: expected a whole number from 0 to 1000");
    CHECK(error_of("{\"version\": 1,\n \"steps\": {\n  \"02.1\": {\"points\": 1.5}}}") ==
          "grading.json:3:22: steps/02.1/points: expected a whole number from 0 to 1000");
    CHECK(error_of(R"({"version": 1, "steps": {"02.9": {}}})") ==
          "grading.json:1:34: steps/02.9: there is no such step");
    CHECK(error_of(R"({"version": 1, "credit": "half"})") ==
          "grading.json:1:26: credit: expected \"all\" or \"part\"");
    CHECK(error_of(R"({"version": 1, "hidden": ["a", 1]})") ==
          "grading.json:1:32: hidden/1: expected a text");
    CHECK(error_of(R"({"version": 1, "due": {"02": "2027-03-01"}, "late": []})") ==
          "grading.json:1:30: due/02: expected a time with its distance from UTC, such as "
          "\"2027-03-01T23:59:00+01:00\"");
    CHECK(error_of(R"({"version": 1, "due": {"03": "2027-03-01T00:00Z"}, "late": []})") ==
          "grading.json:1:30: due/03: there is no such chapter");
    CHECK(error_of(R"({"version": 1, "late": []})") ==
          "grading.json:1:24: late: needs 'due' and 'late' both");
    CHECK(
        error_of(
            R"({"version": 1, "due": {}, "late": [{"hours": 9, "percent": 5}, {"hours": 9, "percent": 4}]})") ==
        "grading.json:1:74: late/1/hours: expected more hours than in the rule before");
}

TEST_CASE("a key that is twice there is refused: nobody knows which was meant") {
    CHECK(error_of("{\"version\": 1,\n \"steps\": {\"02.1\": {\"points\": 1}, \"02.1\": {}}}") ==
          "grading.json:2:35: steps/02.1: is there twice");
}

TEST_CASE("places are those of the file, whatever stands before them") {
    // Escapes, brackets in texts, a byte order mark and characters of several bytes; columns count
    // characters.
    CHECK(error_of(
              "\xEF\xBB\xBF{\"version\": 1, \"hidden\": [\"\\\\\\\"]}{,\\u00e4\", \"\xC3\xA4\"], \"x\": 0}")
              .find("grading.json:1:56: x: is not known") == 0);
    const std::string deep = std::string(100000, '[');
    CHECK(error_of(deep) == "grading.json: values are nested too deep");
}

TEST_CASE("the rubric's digest changes with what a mark depends on, and with nothing else") {
    const std::string standard = digest_of(read(R"({"version": 1})"));
    CHECK(digest_of(read(R"({"version": 1, "shown_from": {"marks": "2027-03-08T00:00Z"}})")) == standard);
    CHECK(digest_of(read(R"({"version": 1, "steps": {"02.1": {"points": 15}}})")) == standard);
    for (const char* step :
         {R"("points": 16)", R"("credit": "part")", R"("extra": true)", R"("hidden": ["a"])"})
        CHECK(digest_of(read(std::string(R"({"version": 1, "steps": {"02.1": {)") + step + "}}}")) !=
              standard);
    CHECK(digest_of(read(R"({"version": 1, "due": {"02": "2027-03-01T12:00Z"}, "late": []})")) != standard);
}

TEST_CASE("times") {
    CHECK(text_of(test::moment("2028-02-29T00:30:00+01:00")) == "2028-02-28T23:30:00Z");
    CHECK(text_of(test::moment("2027-12-31T23:30:00-02:15")) == "2028-01-01T01:45:00Z");
    for (const char* text :
         {"2027-02-29T00:00Z", "2027-13-01T00:00Z", "2027-01-01T24:00Z", "2027-01-01T00:00",
          "2027-01-01 00:00Z", "1969-01-01T00:00Z", "2027-01-01T00:00Zx", ""}) {
        INFO(text);
        CHECK_FALSE(moment_of(text));
    }
}

TEST_CASE("the written schema of grading.json and its reader agree") {
    const std::string schema = "common/grading/rubric.schema.json";
    const std::vector<std::string> good{
        R"({"version": 1})",
        R"({"version": 1, "credit": "part", "hidden": ["[stability]", "a name"], "steps": {}})",
        R"({"version": 1, "steps": {"02.1": {"points": 0, "credit": "all", "extra": false, "hidden": []}}})",
        R"({"version": 1, "due": {"02": "2027-03-01T12:00Z"}, "late": [{"hours": 1, "percent": 0}]})",
        R"({"version": 1, "shown_from": {"marks": "2027-03-01T12:00:00-05:00", "hidden": "2027-03-01T12:00Z"}})"};
    for (const std::string& text : good) CHECK(error_of(text) == "");
    CHECK(test::against_schema(good, schema) == "");
    for (const std::string& text : std::vector<std::string>{
             "[]", "{}", R"({"version": 2})", R"({"version": 1, "credit": "half"})",
             R"({"version": 1, "hidden": [""]})", R"({"version": 1, "points": 3})",
             R"({"version": 1, "steps": {"02.1": {"points": 1001}}})",
             R"({"version": 1, "steps": {"02.1": {"title": "x"}}})",
             R"({"version": 1, "due": {"02": "2027-03-01T12:00Z"}})",
             R"({"version": 1, "due": {"02": "tomorrow"}, "late": []})",
             R"({"version": 1, "due": {"02": "2027-03-01T12:00Z"}, "late": [{"hours": 0, "percent": 5}]})",
             R"({"version": 1, "shown_from": "now"})"}) {
        INFO(text);
        CHECK(error_of(text) != "");
        CHECK(test::against_schema({text}, schema) != "");
    }
}
