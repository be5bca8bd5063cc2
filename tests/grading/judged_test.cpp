// What the report of a judge says of each step.
#include "common/grading/judged.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"

using namespace rt;

namespace {

const StepRubric part_of_15{whole_points(15), Credit::Part, false, {}};

std::string ended(const std::string& name, const std::string& step, const std::string& more) {
    return "{\"ended\":\"" + name + "\",\"steps\":[\"" + step + "\"]," + more + "}\n";
}

std::string passed(const std::string& name, const std::string& step) {
    return ended(name, step, "\"state\":\"passed\"");
}

GradedStep mark(const std::string& report, std::size_t step = 0) {
    const std::vector<Chapter> chapters = test::two_chapters();
    const Step& asked = chapters[1].steps.at(step);
    return marked(chapters[1], asked, part_of_15, 100, run_of(asked, read_report(report)));
}

}  // namespace

TEST_CASE("a check whose call gave no answer stops its step, and its reason is told once") {
    const std::string report =
        passed("a", "02.1") + passed("z", "02.2") +
        ended("b", "02.1", "\"state\":\"failed\",\"message\":\"f crashed\",\"stopped\":\"too much memory\"") +
        "{\"finished\":true}\n";
    const GradedStep step = mark(report);
    CHECK(step.verdict == Verdict::TooMuchMemory);
    CHECK(step.checks == CheckCount{1, 2});
    CHECK(step.failure == FailedCheck{"b", "f crashed"});
    CHECK(mark(report, 1).verdict == Verdict::Passed);
}

TEST_CASE("a step pays for another where all that stopped it is a call that was not made") {
    TestRun skipped{"a", {"02.1"}, State::Failed, "f did not return before, and was not called again", ""};
    skipped.stopped = "timed out";
    TestRun own = skipped;
    own.message = "f did not return in 10 s";
    const TestRun right{"b", {"02.1"}, State::Passed, "", ""};
    CHECK(pays_for_another({{right, skipped}, {}, {}, ""}));
    CHECK_FALSE(pays_for_another({{own, skipped}, {}, {}, ""}));
    CHECK_FALSE(pays_for_another({{right}, {}, {}, ""}));
}
