// What the report of a judge says of each step, whole or cut off.
#include "common/grading/judged.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"

using namespace rt;

namespace {

const Stop too_long{Verdict::TimedOut, "the tests did not end in 300 s", {}};
const StepRubric part_of_15{whole_points(15), Credit::Part, false, {}};

std::string line(const std::string& event, const std::string& name, const std::string& more = "") {
    const std::string step = name == "z" ? "02.2" : "02.1";
    return "{\"" + event + "\":\"" + name + "\",\"steps\":[\"" + step + "\"]" + more + "}\n";
}

std::string passed(const std::string& name) {
    return line("started", name) + line("ended", name, ",\"state\":\"passed\"");
}

const std::string chosen = line("chosen", "a") + line("chosen", "z") + line("chosen", "b") +
                           line("chosen", "c") + line("chosen", "d");

/// Four checks of 02.1 and one of 02.2; the judge was ended in the third.
const std::string cut_off = chosen + passed("a") + passed("z") + line("started", "b");

GradedStep mark(const std::string& report, std::size_t step = 0) {
    const std::vector<Chapter> chapters = test::two_chapters();
    const Step& asked = chapters[1].steps.at(step);
    return marked(chapters[1], asked, part_of_15, 100, run_of(asked, read_judged(report, too_long)));
}

}  // namespace

TEST_CASE("checks that a judge never came to count") {
    const GradedStep step = mark(cut_off);
    CHECK(text_of(step.earned) == "3.75");  // one of four
    CHECK(step.verdict == Verdict::TimedOut);
    CHECK(step.checks == CheckCount{1, 4});
    CHECK(step.failure == FailedCheck{"b", too_long.why});
}

TEST_CASE("a judge that comes to no end costs those steps only that it left without a check") {
    const GradedStep whole = mark(cut_off, 1);
    CHECK(whole.verdict == Verdict::Passed);
    CHECK(text_of(whole.earned) == "15");
    // The check that ran is another step's, which may have hidden it.
    const GradedStep step = mark(chosen + passed("a") + line("started", "z"));
    CHECK(step.failure == FailedCheck{"", too_long.why});
    CHECK(mark("").verdict == Verdict::TimedOut);
    CHECK(mark("").failure == FailedCheck{"", too_long.why});
}

TEST_CASE("a check whose call gave no answer stops its step, and its reason is told once") {
    const std::string report =
        line("chosen", "a") + line("chosen", "z") + line("chosen", "b") + passed("a") + passed("z") +
        line("started", "b") +
        line("ended", "b",
             ",\"state\":\"failed\",\"message\":\"f crashed\",\"stopped\":\"too much memory\"") +
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
