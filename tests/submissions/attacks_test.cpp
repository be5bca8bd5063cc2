// Submissions that attack the grader (attacks/), each with the mark that it must get.
#include "common/grading/private_words.hpp"
#include "common/grading/shown.hpp"
#include "common/image/whole_file.hpp"
#include "tests/catch.hpp"
#include "tests/grading/sandbox/boxes.hpp"
#include "tests/submissions/submissions.hpp"
#include "tests/support.hpp"

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

namespace fs = std::filesystem;
using namespace rt;

namespace {

/// What was earned without the optional step, whose points are extra credit.
Points required_points(const Grade& grade) {
    Points sum;
    for (const GradedStep& step : grade.steps)
        if (!step.extra) sum.hundredths += step.earned.hundredths;
    return sum;
}

/// One file of attacks/: lines `why`, `earns`, and where they matter `file` (else it is plane.cpp)
/// and `says`; then the text between `--- add` (to the solution of that file) or `--- instead` (of it) and
/// `--- end`.
struct Attack {
    std::string name, says, text;
    std::string file = "plane.cpp";
    bool adds = true;
    bool at_most = false;  ///< whatever it earns, it is no more than this
    int earns = 0;
};

Attack read_attack(const fs::path& file) {
    Attack attack;
    attack.name = file.stem().string();
    std::istringstream in(read_file(file));
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        const std::string word = line.substr(0, line.find(' '));
        const auto rest = [&] { return line.substr(line.find_first_not_of(' ', word.size())); };
        if (line == "--- end") return attack;
        if (inside) {
            attack.text += line + "\n";
        } else if (line == "--- add" || line == "--- instead") {
            attack.adds = line == "--- add";
            inside = true;
        } else if (word == "earns") {
            const std::string most = "at most ";
            attack.at_most = rest().starts_with(most);
            attack.earns = std::stoi(attack.at_most ? rest().substr(most.size()) : rest());
        } else if (word == "says") {
            attack.says = rest();
        } else if (word == "file") {
            attack.file = rest();
        } else {
            REQUIRE(word == "why");
        }
    }
    FAIL(file << " has no end");
    return attack;
}

Submission of(const Chapter& chapter, const Attack& attack) {
    Submission submission = test::perfect({&chapter});
    submission.name = attack.name;
    std::string& text = submission.files.at(exercise_path(chapter, attack.file));
    text = attack.adds ? text + "\n" + attack.text : attack.text;
    return submission;
}

/// Files and processes that attacks would leave, all of which are called so.
std::string traces() {
    const std::string name = "course_attack";
    std::string all;
    for (const char* place : {"/tmp", "/var/tmp", "/dev/shm", "/", "/root", "/etc"})
        for (const auto& entry : fs::directory_iterator(place, fs::directory_options::skip_permission_denied))
            if (entry.path().filename().string().find(name) != std::string::npos)
                all += entry.path().string() + "\n";
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::string comm;
        std::getline(std::ifstream(entry.path() / "comm"), comm);
        if (comm.starts_with(name)) all += "process " + entry.path().filename().string() + "\n";
    }
    return all;
}

/// Waits for what a box that has ended still tidies up.
bool settles(const std::function<bool()>& is_so) {
    for (int i = 0; i < 100 && !is_so(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return is_so();
}

/// Whether students would read anything of the machine.
void check_keeps_silent(const Grade& grade, const std::vector<std::string>& words) {
    const ShownGrade shown = shown_to_student(grade, {}, now(), words);
    for (const GradedStep& step : shown.grade.steps)
        for (const std::string& word : words) {
            if (word.size() < 5) continue;  // it may be part of another
            const std::string text = explained(step);
            INFO("'" << word << "' stands in: " << text);
            CHECK(text.find(word) == std::string::npos);
        }
}

void check_attack(Grader& grader, const Chapter& chapter, const Attack& attack) {
    const Grade grade = grader.grade(of(chapter, attack));
    INFO(attack.name << "\n" << test::told(grade));
    if (attack.at_most)
        CHECK(required_points(grade) <= whole_points(attack.earns));
    else
        CHECK(text_of(required_points(grade)) == text_of(whole_points(attack.earns)));
    if (!attack.says.empty()) CHECK(test::somebody_said(grade, attack.says));
    CHECK(settles([] { return traces().empty(); }));
    check_keeps_silent(grade, private_words(this_project()));
}

/// All or nothing.
GraderOptions options_for(const test::Course& course, Isolation level) {
    return {.chapters = course.marked, .rubric = default_rubric(course.all), .seed = 7, .isolation = level};
}

}  // namespace

TEST_CASE("attacks on the grader get their marks, and leave the machine as it was", "[attacks]") {
    const std::optional<Isolation> level = test::best_level();
    if (!level) return;
    const test::Course course;
    GraderOptions options = options_for(course, *level);
    options.call_seconds = 2;
    Grader grader(course.project, options);
    const Submission perfect = test::perfect(course.marked);
    CHECK(text_of(required_points(grader.grade(perfect))) == "70");

    test::fresh_directory("");
    const std::vector<std::string> before = test::surroundings();
    int count = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(test::repository()) / "tests/submissions/attacks")) {
        check_attack(grader, course.planes, read_attack(entry.path()));
        ++count;
    }
    CHECK(count >= 45);
    CHECK(settles([&] { return test::surroundings() == before; }));

    // Nobody's work after that was harmed by it.
    CHECK(text_of(required_points(grader.grade(perfect))) == "70");
}

TEST_CASE("what submissions are compiled with does not say where the course lies", "[attacks]") {
    if (!test::best_level()) return;
    const Project project = this_project();
    const Workshop builds_it(project, {}, *test::best_level());
    const std::string compiled = read_file(project.build / "grading/common.hpp.gch");
    CHECK(compiled.find("common/world/query.hpp") != std::string::npos);
    CHECK(compiled.find(test::repository()) == std::string::npos);
}

TEST_CASE("whoever takes too long loses what was not yet tested, and nothing that was", "[attacks]") {
    const std::optional<Isolation> level = test::best_level();
    if (!level) return;
    const test::Course course;
    GraderOptions options = options_for(course, *level);
    options.judge_seconds = 5;
    Grader grader(course.project, options);
    Submission slow = test::perfect(course.marked);
    std::string& text = slow.files.at("chapters/01_ray_casting/plane.cpp");
    const std::string task = "    // [exercise 01.4]";
    REQUIRE(text.find(task) != std::string::npos);
    text.insert(text.find(task), "    ::usleep(200'000);\n");
    text.insert(0, "#include <unistd.h>\n");
    const Grade grade = grader.grade(slow);
    INFO(test::told(grade));
    CHECK(text_of(required_points(grade)) == "30");  // the camera's
    CHECK(test::somebody_said(grade, "took longer than 5 s"));
}
