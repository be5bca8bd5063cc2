// Honest work of all kinds: each gets exactly the marks of its working steps.
#include "common/image/file.hpp"
#include "tests/catch.hpp"
#include "tests/submissions/submissions.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;
using namespace rt;

namespace {

using test::Course;

/// What somebody handed in, and the verdicts of those steps that do not pass.
struct Honest {
    std::string who;
    std::map<std::string, Verdict> lost = {};
    std::string says = "";                   ///< some step
    std::vector<std::string> pictured = {};  ///< steps that come with a difference picture
    Submission submission = {};              ///< perfect, until it is changed

    /// In a file of chapter 1.
    Honest& change(const Course& course, const std::string& file, const std::vector<Replacement>& changes) {
        test::change(submission, course.planes, file, changes);
        return *this;
    }
};

Honest honest(const Course& course, Honest described) {
    described.submission = test::perfect(course.marked);
    return described;
}

Honest perfect(const Course& course) { return honest(course, {"perfect"}); }

Honest one_wrong_step(const Course& course) {
    Honest wrong =
        honest(course, {"one wrong step", {{"01.1", Verdict::Failed}}, "camera_test.cpp", {"01.1"}});
    test::change_as(wrong.submission, course.planes, "mistakes/01.1_u_not_unit.mistake");
    return wrong;
}

/// One file is done, one is begun, and one is not handed in.
Honest half_done(const Course& course) {
    Honest half = honest(course, {"half done", {{"01.5", Verdict::Todo}, {"01.6", Verdict::Todo}}});
    half.submission.files.erase("chapters/01_ray_casting/raycast.cpp");
    const std::string first = "    std::optional<Hit> nearest;\n",
                      header = "#include \"common/math/error.hpp\"\n";
    return half.change(course, "plane.cpp",
                       {{first, "    return todo(\"01.5\");\n" + first},
                        {header, header + "#include \"common/math/todo.hpp\"\n"}});
}

/// What stands on the file that does not compile waits for it.
Honest error_in_one_file(const Course& course) {
    Honest error =
        honest(course, {"a compile error in one file", {{"01.6", Verdict::NotCompiled}}, "raycast.cpp"});
    error.submission.files.at("chapters/01_ray_casting/raycast.cpp") += "\nint missing = semicolon\n";
    return error;
}

Honest error_in_one_chapter(const Course& course) {
    Honest error = honest(course, {"a chapter that does not compile", {}, "camera.cpp"});
    for (const Step& step : course.planes.steps) error.lost[step.id] = Verdict::NotCompiled;
    for (auto& [file, text] : error.submission.files)
        if (file.starts_with("chapters/01")) text = "no C++\n" + text;
    return error;
}

/// Reads where nothing is.
Honest crash_in_one_step(const Course& course) {
    return honest(course, {"a crash in one step", {{"01.6", Verdict::Crashed}}, "crashed"})
        .change(course, "raycast.cpp",
                {{"    return material.ambient + material.emission;\n",
                  "    return material.ambient + *static_cast<const Vec3* volatile>(nullptr);\n"}});
}

/// pixel_ray does not return for perspective views, step 01.2. Orthographic ones, step 01.3, are done by the
/// same function and are right; the loop, step 01.6, needs both.
Honest endless_loop_in_one_step(const Course& course) {
    const std::string branch = "    if (view.projection == Projection::Perspective) {\n";
    return honest(course, {"an endless loop in one step",
                           {{"01.2", Verdict::TimedOut}, {"01.6", Verdict::TimedOut}},
                           "did not return in 1 s"})
        .change(course, "camera.cpp",
                {{branch, branch + "        for (volatile bool waits = true; waits;) {}\n"}});
}

/// Asks every plane ten times.
Honest ten_times_slower(const Course& course) {
    return honest(course, {"ten times slower but right"})
        .change(course, "plane.cpp",
                {{"        const std::optional<Hit> hit = intersect(planes[i], ray, range);\n",
                  "        std::optional<Hit> hit;\n        for (volatile int n = 0; n < 10; n = n + 1)\n"
                  "            hit = intersect(planes[i], ray, range);\n"}});
}

/// Every step in another right form: the first of its variants.
Honest right_in_another_form(const Course& course) {
    Honest right = honest(course, {"right in another form"});
    for (const Chapter* chapter : course.marked) {
        std::vector<std::string> names;
        for (const fs::path& file : files_in(course.project.root / "tests" / chapter->name / "variants"))
            names.push_back(file.filename().string());
        for (const Step& step : chapter->steps) {
            const auto first = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
                return name.starts_with(step.id + "_");
            });
            REQUIRE(first != names.end());
            test::change_as(right.submission, *chapter, "variants/" + *first);
        }
    }
    return right;
}

/// What the student's build includes before each file (CMakeLists.txt), so that nobody notices if it is
/// forgotten.
Honest includes_forgotten(const Course& course) {
    const std::string begins = "namespace rt {\n";
    return honest(course, {"without includes"}).change(course, "camera.cpp", {{begins, begins + R"(
std::vector<std::string> unused(std::span<const std::optional<std::variant<std::uint32_t, Vec3>>> all) {
    const auto roots = std::make_unique<std::array<double, 2>>(std::array{std::sqrt(2.0), std::sqrt(3.0)});
    return std::vector<std::string>(std::min(all.size(), roots->size()));
}
)"}});
}

/// A picture that is small enough for the formats.
void check_picture(const std::string& bytes) {
    CHECK(bytes.size() <= 48 * 1024);
    const Image image = decode_picture("difference.png", bytes).image;
    CHECK(image.width == 320);
    CHECK(std::any_of(image.pixels.begin(), image.pixels.end(),
                      [](const Vec3& color) { return max_component(color) > 0.25; }));
}

void check_marks(const Grade& grade, const Honest& work) {
    INFO(work.who << "\n" << test::told(grade));
    for (const GradedStep& step : grade.steps) {
        INFO(step.id);
        const auto lost = work.lost.find(step.id);
        const Verdict expected = lost == work.lost.end() ? Verdict::Passed : lost->second;
        CHECK(name_of(step.verdict) == name_of(expected));
        const bool pictured = std::count(work.pictured.begin(), work.pictured.end(), step.id) > 0;
        CHECK(step.difference.empty() == !pictured);
        if (pictured && !step.difference.empty()) check_picture(step.difference);
        CHECK(step.earned == (expected == Verdict::Passed ? step.possible : Points{}));
    }
    if (!work.says.empty()) CHECK(test::somebody_said(grade, work.says));
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
    for (const auto& handed_in :
         {perfect, half_done, one_wrong_step, error_in_one_file, error_in_one_chapter, crash_in_one_step,
          endless_loop_in_one_step, ten_times_slower, right_in_another_form, includes_forgotten}) {
        const Honest work = handed_in(course);
        check_marks(grader.grade(work.submission), work);
    }
}
