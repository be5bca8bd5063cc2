// Submissions that attack the grader (attacks/submissions), each with the mark that it must get, and honest
// ones. They stand after the boxes' own tests: some of those give up root, and could not read what is built
// here.
#include "common/grading/grader.hpp"
#include "common/grading/isolation.hpp"
#include "common/image/whole_file.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <iostream>
#include <sstream>

namespace fs = std::filesystem;
using namespace rt;

namespace {

constexpr const char* attacked = "chapters/01_ray_casting/plane.cpp";

/// One file of attacks/submissions: lines `why`, `earns` and `says`, then the text between `--- add` (to the
/// solution of plane.cpp) or `--- instead` (of it) and `--- end`.
struct Attack {
    std::string name, says, text;
    bool adds = true;
    bool at_most = false;  ///< whatever it earns, it is no more than this
    int earns = 0;
};

Attack read_attack(const fs::path& file) {
    Attack attack{file.stem().string(), "", "", true, false, 0};
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
        } else {
            REQUIRE(word == "why");
        }
    }
    FAIL(file << " has no end");
    return attack;
}

/// What everybody who solved chapter 1 would hand in.
Submission perfect(const Chapter& chapter) {
    Submission submission{"perfect", {}, {}};
    for (const std::string& file : files_of_steps(chapter))
        submission.files[exercise_path(chapter, file)] =
            read_file(fs::path(test::repository()) / "solutions" / chapter.name / file);
    return submission;
}

Submission of(const Chapter& chapter, const Attack& attack) {
    Submission submission = perfect(chapter);
    submission.name = attack.name;
    std::string& text = submission.files.at(attacked);
    text = attack.adds ? text + "\n" + attack.text : attack.text;
    return submission;
}

/// The best level that this machine can do.
std::optional<Isolation> best_level() {
    for (const Level& level : probe())
        if (level.possible && level.isolation != Isolation::None) return level.isolation;
    return {};
}

std::string told(const Grade& grade) {
    std::ostringstream all;
    for (const GradedStep& step : grade.steps) {
        all << step.id << ": " << text_of(step.earned) << " of " << text_of(step.possible) << ", "
            << name_of(step.verdict);
        if (step.failure) all << ": " << step.failure->said;
        all << "\n";
    }
    return all.str();
}

bool somebody_said(const Grade& grade, const std::string& text) {
    for (const GradedStep& step : grade.steps)
        if (step.failure && step.failure->said.find(text) != std::string::npos) return true;
    return false;
}

/// Files where attacks try to leave something, and what lies in directories that everybody may write to.
std::string traces() {
    std::string all;
    for (const char* place : {"/tmp", "/var/tmp", "/dev/shm", "/", "/root", "/etc"})
        for (const auto& entry : fs::directory_iterator(place, fs::directory_options::skip_permission_denied))
            if (entry.path().filename().string().find("course_attack") != std::string::npos)
                all += entry.path().string() + "\n";
    return all;
}

}  // namespace

TEST_CASE("attacks on the grader get their marks, honest work gets its own", "[attacks]") {
    const std::optional<Isolation> level = best_level();
    if (!level) {
        std::cout << "This machine can have no boxes; the attacks were not tried.\n";
        return;
    }
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Chapter& chapter = chapters.front();
    Grader grader(project, {.chapters = {&chapter},
                            .rubric = default_rubric(chapters),
                            .seed = 7,
                            .isolation = *level,
                            .call_seconds = 2});

    const Grade right = grader.grade(perfect(chapter));
    INFO(told(right));
    REQUIRE(earned(right) == possible(right));

    int count = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(test::repository()) / "tests/grading/attacks/submissions")) {
        const Attack attack = read_attack(entry.path());
        const Grade grade = grader.grade(of(chapter, attack));
        INFO(attack.name << "\n" << told(grade));
        if (attack.at_most)
            CHECK(earned(grade) <= whole_points(attack.earns));
        else
            CHECK(text_of(earned(grade)) == text_of(whole_points(attack.earns)));
        if (!attack.says.empty()) CHECK(somebody_said(grade, attack.says));
        CHECK(!somebody_said(grade, project.root.string()));
        CHECK(traces() == "");
        ++count;
    }
    CHECK(count >= 27);

    // Nobody's work after that was harmed by it.
    const Grade again = grader.grade(perfect(chapter));
    CHECK(earned(again) == possible(again));
}

TEST_CASE("whoever takes too long loses what was not yet tested, and nothing that was", "[attacks]") {
    const std::optional<Isolation> level = best_level();
    if (!level) return;
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Chapter& chapter = chapters.front();
    Grader grader(project, {.chapters = {&chapter},
                            .rubric = default_rubric(chapters),
                            .seed = 7,
                            .isolation = *level,
                            .judge_seconds = 5});
    Submission slow = perfect(chapter);
    std::string& text = slow.files.at(attacked);
    const std::string task = "    // [exercise 01.4]";
    REQUIRE(text.find(task) != std::string::npos);
    text.insert(text.find(task), "    ::usleep(200'000);\n");
    text.insert(0, "#include <unistd.h>\n");
    const Grade grade = grader.grade(slow);
    INFO(told(grade));
    CHECK(text_of(earned(grade)) == "30");  // the camera's
    CHECK(somebody_said(grade, "took longer than 5 s"));
}
