// A judge that fails costs nobody a mark: that is the grader's fault, and told so.
#include "common/grading/run_judge.hpp"
#include "common/grading/class_marks.hpp"
#include "common/image/whole_file.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"
#include "tests/support.hpp"

#include <filesystem>

namespace fs = std::filesystem;
using namespace rt;

namespace {

fs::path bench() {
    const fs::path place = fs::path(test::scratch_directory()) / "judges";
    fs::create_directories(place);
    return place;
}

/// A judge that does what a shell's commands say; $4 is the name of its report.
fs::path fake_judge(const std::string& commands) {
    const fs::path judge = bench() / "judge_01";
    write_file(judge, "#!/bin/sh\n" + commands + "\n");
    fs::permissions(judge, fs::perms(0755));
    return judge;
}

const std::string begun = R"(echo '{"started":"two roots","steps":["02.1"]}' >"$4")";
const std::string ended =
    R"(echo '{"ended":"two roots","steps":["02.1"],"state":"failed"}' >>"$4"; echo '{"finished":true}' >>"$4")";

TestReport judged_by(const std::string& commands) {
    return run_judge(fake_judge(commands), bench() / "report.jsonl", {});
}

std::string fault_of(const std::string& commands) {
    try {
        judged_by(commands);
    } catch (const GraderFault& fault) {
        return fault.what();
    }
    return "none";
}

}  // namespace

TEST_CASE("a judge that dies, or ends without its whole report, is the grader's fault") {
    CHECK(fault_of("kill -ABRT $$") == "judge_01 crashed (abort) outside of any test");
    CHECK(fault_of(begun + "; kill -SEGV $$") ==
          "judge_01 crashed (segmentation fault) in the test \"two roots\"");
    CHECK(fault_of(begun + "; exit 2") == "judge_01 ended the program (status 2) in the test \"two roots\"");
    CHECK(fault_of("exit 0") == "judge_01 ended the program (status 0) outside of any test");
    // A report of an earlier run does not count.
    CHECK(fault_of(begun + "; " + ended + "; exit 1") == "none");
    CHECK(fault_of("exit 1") == "judge_01 ended the program (status 1) outside of any test");
}

TEST_CASE("a judge is told what it is to judge, and its report is read") {
    const fs::path told = bench() / "told";
    const std::string tell = "printf '%s\\n' \"$@\" >'" + told.string() + "'; ";
    const TestReport report =
        run_judge(fake_judge(tell + begun + "; " + ended + "; exit 1"), bench() / "report.jsonl",
                  {.worker = "/a worker",
                   .isolation = Isolation::User,
                   .call_seconds = 2,
                   .judge_seconds = 30,
                   .seed = 7,
                   .pictures = "/pictures",
                   .scenes = {"one.scene", "two.scene"}},
                  {"[02.1]"});
    REQUIRE(report.ended.size() == 1);
    CHECK(report.ended[0].state == State::Failed);
    CHECK_THAT(read_file(told),
               Catch::EndsWith(
                   "--quick\n--seed\n7\n--worker\n/a worker\n--isolation\nuser\n--call-seconds\n2.000000\n"
                   "--judge-seconds\n30.000000\n--pictures\n/pictures\n--scene\none.scene\n--scene\n"
                   "two.scene\n[02.1]\n"));
}

TEST_CASE("who is not marked by the grader's fault has no mark, and everybody else has one") {
    fs::remove_all(bench());
    const KeptGrades kept({bench(), bench() / "build"}, {});
    const std::vector<Submission> submissions{{"ada", {}, {}}, {"ben", {}, {}}, {"cleo", {}, {}}};
    std::vector<std::string> marked;
    bool fails = true;
    const Marking mark = [&](const Submission& submission, const auto&) {
        if (fails && submission.name == "ben") judged_by("kill -ABRT $$");
        marked.push_back(submission.name);
        return test::perfect(submission.name);
    };
    const ClassMarks marks = marks_of(submissions, kept, mark);
    CHECK(marks.grades == std::vector<Grade>{test::perfect("ada"), test::perfect("cleo")});
    CHECK(marks.not_marked == std::vector<std::string>{"ben"});
    CHECK(marked == std::vector<std::string>{"ada", "cleo"});
    CHECK_FALSE(kept.find(submissions[1]));

    // Mended, it marks those only whom it has not marked.
    fails = false;
    const ClassMarks all = marks_of(submissions, kept, mark);
    CHECK(all.grades.size() == 3);
    CHECK(all.not_marked.empty());
    CHECK(marked == std::vector<std::string>{"ada", "cleo", "ben"});
    fs::remove_all(bench());
}
