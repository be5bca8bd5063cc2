// Honest work of all kinds: each gets exactly the marks of its working steps.
#include "common/image/file.hpp"
#include "tests/catch.hpp"
#include "tests/grading/submissions.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;
using namespace rt;

namespace {

/// A chapter that is cheap to mark.
struct Course {
    Project project = this_project();
    std::vector<Chapter> all = read_catalogue(project);
    const Chapter& planes = find_chapter(all, "01");
    std::vector<const Chapter*> marked{&planes};
};

/// What somebody handed in, and the verdicts of those steps that do not pass.
struct Honest {
    std::string who;
    Submission submission;
    std::map<std::string, Verdict> lost;
    std::string says;                        ///< some step
    std::vector<std::string> pictured = {};  ///< steps that come with a difference picture
};

Honest one_wrong_step(const Course& course) {
    Honest honest{"one wrong step",
                  test::perfect(course.marked),
                  {{"01.1", Verdict::Failed}},
                  "camera_test.cpp",
                  {"01.1"}};
    test::change_as(honest.submission, course.planes, "mistakes/01.1_u_not_unit.mistake");
    return honest;
}

/// One file is done, one is begun, and one is not handed in.
Honest half_done(const Course& course) {
    Honest honest{
        "half done", test::perfect(course.marked), {{"01.5", Verdict::Todo}, {"01.6", Verdict::Todo}}, ""};
    test::change(honest.submission, course.planes,
                 "step 01.5\nfile plane.cpp\nwhy  It is not begun.\n--- replace\n"
                 "    std::optional<Hit> nearest;\n--- with\n    return todo(\"01.5\");\n"
                 "    std::optional<Hit> nearest;\n--- end\n");
    test::change(honest.submission, course.planes,
                 "step 01.5\nfile plane.cpp\nwhy  It is not begun.\n--- replace\n"
                 "#include \"common/math/error.hpp\"\n--- with\n#include \"common/math/error.hpp\"\n"
                 "#include \"common/math/todo.hpp\"\n--- end\n");
    honest.submission.files.erase("chapters/01_ray_casting/raycast.cpp");
    return honest;
}

/// What stands on the file that does not compile waits for it.
Honest error_in_one_file(const Course& course) {
    Honest honest{"a compile error in one file",
                  test::perfect(course.marked),
                  {{"01.6", Verdict::NotCompiled}},
                  "raycast.cpp"};
    honest.submission.files.at("chapters/01_ray_casting/raycast.cpp") += "\nint missing = semicolon\n";
    return honest;
}

Honest error_in_one_chapter(const Course& course) {
    Honest honest{"a chapter that does not compile", test::perfect(course.marked), {}, "camera.cpp"};
    for (const Step& step : course.planes.steps) honest.lost[step.id] = Verdict::NotCompiled;
    for (auto& [file, text] : honest.submission.files)
        if (file.starts_with("chapters/01")) text = "no C++\n" + text;
    return honest;
}

Honest crash_in_one_step(const Course& course) {
    Honest honest{
        "a crash in one step", test::perfect(course.marked), {{"01.6", Verdict::Crashed}}, "crashed"};
    test::change(honest.submission, course.planes,
                 "step 01.6\nfile raycast.cpp\nwhy  Reads where nothing is.\n--- replace\n"
                 "    return material.ambient + material.emission;\n--- with\n"
                 "    return material.ambient + *static_cast<const Vec3* volatile>(nullptr);\n--- end\n");
    return honest;
}

/// pixel_ray does not return for perspective views, step 01.2. Orthographic ones, step 01.3, are done by the
/// same function and are right; the loop, step 01.6, needs both.
Honest endless_loop_in_one_step(const Course& course) {
    Honest honest{"an endless loop in one step",
                  test::perfect(course.marked),
                  {{"01.2", Verdict::TimedOut}, {"01.6", Verdict::TimedOut}},
                  "did not return in 1 s"};
    test::change(honest.submission, course.planes,
                 "step 01.2\nfile camera.cpp\nwhy  Waits for what does not change.\n--- replace\n"
                 "    if (view.projection == Projection::Perspective) {\n--- with\n"
                 "    if (view.projection == Projection::Perspective) {\n"
                 "        for (volatile bool waits = true; waits;) {}\n--- end\n");
    return honest;
}

Honest ten_times_slower(const Course& course) {
    Honest honest{"ten times slower but right", test::perfect(course.marked), {}, ""};
    test::change(honest.submission, course.planes,
                 "step 01.5\nfile plane.cpp\nwhy  Asks every plane ten times.\n--- replace\n"
                 "        const std::optional<Hit> hit = intersect(planes[i], ray, range);\n--- with\n"
                 "        std::optional<Hit> hit;\n        for (volatile int n = 0; n < 10; n = n + 1)\n"
                 "            hit = intersect(planes[i], ray, range);\n--- end\n");
    return honest;
}

/// Every step in another right form: the first of its variants.
Honest right_in_another_form(const Course& course) {
    Honest honest{"right in another form", test::perfect(course.marked), {}, ""};
    for (const Chapter* chapter : course.marked) {
        std::vector<std::string> names;
        for (const fs::path& file : files_in(course.project.root / "tests" / chapter->name / "variants"))
            names.push_back(file.filename().string());
        for (const Step& step : chapter->steps) {
            const auto first = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
                return name.starts_with(step.id + "_");
            });
            REQUIRE(first != names.end());
            test::change_as(honest.submission, *chapter, "variants/" + *first);
        }
    }
    return honest;
}

/// A picture that is small enough for the formats.
void check_picture(const std::string& bytes) {
    CHECK(bytes.size() <= 48 * 1024);
    const Image image = decode_picture("difference.png", bytes).image;
    CHECK(image.width == 320);
    CHECK(std::any_of(image.pixels.begin(), image.pixels.end(),
                      [](const Vec3& color) { return max_component(color) > 0.25; }));
}

void check_marks(const Grade& grade, const Honest& honest) {
    INFO(honest.who << "\n" << test::told(grade));
    for (const GradedStep& step : grade.steps) {
        INFO(step.id);
        const auto lost = honest.lost.find(step.id);
        const Verdict expected = lost == honest.lost.end() ? Verdict::Passed : lost->second;
        CHECK(name_of(step.verdict) == name_of(expected));
        const bool pictured = std::count(honest.pictured.begin(), honest.pictured.end(), step.id) > 0;
        CHECK(step.difference.empty() == !pictured);
        if (pictured && !step.difference.empty()) check_picture(step.difference);
        CHECK(step.earned == (expected == Verdict::Passed ? step.possible : Points{}));
    }
    if (!honest.says.empty()) CHECK(test::somebody_said(grade, honest.says));
}

}  // namespace

TEST_CASE("honest work gets exactly the marks of its working steps", "[honest]") {
    const std::optional<Isolation> level = test::best_level();
    if (!level) return;
    const Course course;
    Grader grader(course.project, {.chapters = course.marked,
                                   .rubric = default_rubric(course.all),
                                   .seed = 11,
                                   .isolation = *level,
                                   .call_seconds = 1});
    check_marks(grader.grade(test::perfect(course.marked)), {"perfect", {}, {}, ""});
    for (const auto& handed_in :
         {half_done, one_wrong_step, error_in_one_file, error_in_one_chapter, crash_in_one_step,
          endless_loop_in_one_step, ten_times_slower, right_in_another_form}) {
        const Honest honest = handed_in(course);
        check_marks(grader.grade(honest.submission), honest);
    }
}
