// What a test program reports of itself, whatever its tests say.
#include "common/image/whole_file.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/results.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>

using namespace rt;

// Not run with the others: it is what the next test runs.
TEST_CASE("a failure that is hard to show", "[.][unreadable]") {
    INFO("caf\xe9 \x1b[2J\x01");
    throw std::runtime_error("\xff is no letter\nbut \"this\" is");
}

TEST_CASE("a failure is reported as JSON whatever it says") {
    const std::string test_program = program(this_project(), "test_program").string();
    const std::string file = test::scratch_directory() + "/unreadable.jsonl";
    const ProcessResult result = run_process({test_program, "[unreadable]", "--report", file});
    CHECK(result.signal == 0);
    CHECK(result.exit_code == 1);
    const std::string text = read_file(file);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        CHECK(nlohmann::json::accept(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    const TestReport report = read_report(text);
    CHECK(report.complete);
    REQUIRE(report.ended.size() == 1);
    CHECK(report.ended[0].message.find("\\xff is no letter\nbut \"this\" is") != std::string::npos);
    CHECK(report.ended[0].message.find("caf\\xe9 \\x1b[2J\\x01") != std::string::npos);
}

// Likewise.
TEST_CASE("a loop of which some cases fail", "[.][some-fail]") {
    for (int i = 0; i < 10; ++i) {
        INFO("number " << i);
        CHECK(i % 3 == 0);
        CHECK(i < 9);
    }
}

TEST_CASE("of cases that fail alike the first is shown, and how many there are") {
    const std::string file = test::scratch_directory() + "/some_fail.jsonl";
    run_process({program(this_project(), "test_program").string(), "[some-fail]", "--report", file});
    const TestReport report = read_report(read_file(file));
    REQUIRE(report.ended.size() == 1);
    CHECK_THAT(report.ended[0].message,
               Catch::StartsWith("number 1\ncame out: 1, expected 0\nit fails in 5 more "
                                 "cases of this test\ntests/program/"));
}

TEST_CASE("a test program says by its status that its report is not whole") {
    const std::string test_program = program(this_project(), "test_program").string();
    const std::string test = "a report is read as far as it was written";
    CHECK(run_process({test_program, test}).exit_code == 0);
    CHECK(run_process({test_program, test, "--report", "/dev/full"}).exit_code == 2);
    CHECK(run_process({test_program, test, "--report", "/dev/null/x"}).exit_code == 2);
    CHECK(run_process({"sh", "-c", "'" + test_program + "' '" + test + "' >/dev/full"}).exit_code == 2);
}
