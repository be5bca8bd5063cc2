// What a student may see of a grade: nothing of hidden checks, of directories or of the machine.
#include "common/grading/shown.hpp"
#include "common/grading/grade_json.hpp"
#include "common/grading/private_words.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"

#include <unistd.h>

#include <algorithm>

namespace fs = std::filesystem;
using namespace rt;

namespace {

const Moment today = test::moment("2027-03-05T00:00:00Z");

std::string shown_text(const std::string& said, const std::vector<std::string>& words = {}) {
    Grade grade = test::troubled("ada");
    grade.steps[1].failure->said = said;
    return shown_to_student(grade, {}, today, words).grade.steps[1].failure->said;
}

}  // namespace

TEST_CASE("of hidden checks a student sees whether one did not pass, and nothing else") {
    const Grade grade = test::troubled("ada");
    const ShownGrade shown = shown_to_student(grade, {}, today, {});
    CHECK(shown.grade.steps[2].hidden == CheckCount{0, 1});
    CHECK(to_json(shown.grade).dump().find("secret") == std::string::npos);
    CHECK(explained(shown.grade.steps[2]).find("Some hidden check does not pass.") != std::string::npos);
    CHECK(shown.grade.steps[1].failure == grade.steps[1].failure);

    Rubric rubric;
    rubric.hidden_from = today;
    const ShownGrade later = shown_to_student(grade, rubric, today, {});
    CHECK(later.grade.steps[2].hidden_failure == grade.steps[2].hidden_failure);
    CHECK(shown_to_student(grade, rubric, today - std::chrono::seconds(1), {}).grade == shown.grade);
}

TEST_CASE("marks are shown from their date") {
    Rubric rubric;
    CHECK_FALSE(shown_to_student(test::perfect("ada"), rubric, today, {}).marks_from);
    rubric.marks_from = today;
    CHECK_FALSE(shown_to_student(test::perfect("ada"), rubric, today, {}).marks_from);
    CHECK(shown_to_student(test::perfect("ada"), rubric, today - std::chrono::seconds(1), {}).marks_from ==
          today);
}

TEST_CASE("directories of the machine are left out, and nothing that only looks like them") {
    CHECK(shown_text("/home/prof/course/chapters/02_spheres/x.cpp:5:9: error: y") == "x.cpp:5:9: error: y");
    CHECK(shown_text("in \"/var/tmp/a b/c.cpp\" and (/etc/passwd)") == "in \"a b/c.cpp\" and (passwd)");
    CHECK(shown_text("file:///etc/passwd, -I/usr/include/") == "file:passwd, -I/usr/include/");
    for (const char* kept :
         {"1/2", "a / b", "(a)/b/c", "v[0]/2/3", "chapters/02_spheres/x.cpp:5", "/2", "//", ""})
        CHECK(shown_text(kept) == kept);
}

TEST_CASE("private words are left out where they stand as words") {
    CHECK(shown_text("on host17, by /srv/my course/x.cpp of al: also", {"host17", "/srv/my course", "al"}) ==
          "on …, by …/x.cpp of …: also");
    CHECK(shown_text("in /srv/my course/build/runs/12/x.cpp, …/a", {"/srv/my course"}) == "in …/x.cpp, …/a");
}

TEST_CASE("what is private is known: directories, the machine and who uses it") {
    const Project project = this_project();
    const std::vector<std::string> words = private_words(project);
    for (const std::string& word :
         {project.root.string(), project.build.string(), fs::temp_directory_path().string()})
        CHECK(std::count(words.begin(), words.end(), word) == 1);
    char host[256] = "";
    REQUIRE(gethostname(host, sizeof host - 1) == 0);
    CHECK(shown_text("by the host " + std::string(host) + ", in " + project.build.string() + "/a/b.txt",
                     words) == (host == std::string("localhost") ? "by the host localhost, in …/b.txt"
                                                                 : "by the host …, in …/b.txt"));
    // Of two quadratic roots the smaller must stay readable to who is marked by root.
    CHECK(shown_text("the smaller root", words) == "the smaller root");
}

TEST_CASE("a step is explained in some lines") {
    GradedStep step = test::troubled("ada").steps[1];
    step.failure = FailedCheck{"two roots", "1 == 2\nof a far sphere \x1B[31m\xFF"};
    CHECK(explained(step) ==
          "failed: 3 of 7 checks pass\nasked: two roots\n  1 == 2\n  of a far sphere \\x1b[31m\\xff\n"
          "hint 1: ./course hint 02.1");
    step.hidden = {1, 2};
    step.late_percent = 50;
    CHECK(explained(step).find(
              "\nSome hidden check does not pass, either.\nlate: 50 % of the points count\n") !=
          std::string::npos);
    step.failure->said.assign(5000, 'x');
    CHECK(explained(step).size() < 4300);
    step.verdict = Verdict::NeedsStep;
    step.needs = "01.1";
    CHECK(verdict_line(step) == "needs step 01.1: 3 of 7 checks pass");
    CHECK(explained(test::perfect("ada").steps[0]) == "passed: 7 of 7 checks pass");
}
