// `course new`: the column that it makes, and the names that it refuses.
#include "common/workbook/new_chapter.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/drift.hpp"
#include "common/workbook/mistake.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

using namespace rt;

namespace {

namespace fs = std::filesystem;

/// A repository with solutions and chapter 02_spheres.
Project with_spheres(const std::string& name) {
    const Project project = test::sandbox(name);
    test::add_chapter(project, "02_spheres", test::good_chapter);
    return project;
}

}  // namespace

TEST_CASE("a new chapter is one of the catalogue, with an exercise as its solution generates it", "[new]") {
    const Project project = with_spheres("new");
    for (const fs::path& file : make_chapter(project, "10_area_lights")) CHECK(fs::exists(file));
    const std::vector<Chapter> chapters = read_catalogue(project);
    REQUIRE(chapters.size() == 2);
    CHECK(chapters[1].name == "10_area_lights");
    CHECK(chapters[1].title == "Area lights");
    REQUIRE(chapters[1].steps.size() == 1);
    CHECK(chapters[1].steps[0].id == "10.1");
    CHECK(drifted_exercises(project, chapters).empty());
    CHECK_FALSE(is_students_tree(project, chapters));
}

TEST_CASE("nothing is left of a template's marks", "[new]") {
    const Project project = with_spheres("new_marks");
    for (const fs::path& file : make_chapter(project, "10_area_lights")) {
        CAPTURE(file);
        CHECK(read_file(file).find("{{") == std::string::npos);
    }
}

TEST_CASE("the changes of a new chapter's tests are changes of its solution", "[new]") {
    const Project project = with_spheres("new_changes");
    make_chapter(project, "10_area_lights");
    const std::string solution = read_file(project.root / "solutions/10_area_lights/area_lights.cpp");
    const fs::path tests = project.root / "tests/10_area_lights";
    std::vector<fs::path> changes = files_in(tests / "mistakes", {".mistake"});
    CHECK(changes.size() == 2);
    for (const fs::path& variant : files_in(tests / "variants", {".variant"})) changes.push_back(variant);
    CHECK(changes.size() == 4);
    for (const fs::path& file : changes) {
        const Mistake change = parse_mistake(read_file(file), file.string());
        CHECK(change.step == "10.1");
        CHECK(file.filename().string().starts_with("10.1_"));
        CHECK(apply_mistake(change, solution, file.string()) != solution);
    }
}

TEST_CASE("names that are none, or another chapter's, are refused and make nothing", "[new]") {
    const Project project = with_spheres("new_names");
    for (const char* name : {"", "10", "10_", "1_lights", "010_lights", "10-lights", "10_Lights",
                             "10_area lights", "10_area__lights", "10_lights_", "10_1st", "00_lights",
                             "x0_lights", "../10_lights", "10_lights/..", "10_l\xc3\xa4mps"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(make_chapter(project, name), InputError);
    }
    CHECK_THROWS_WITH(make_chapter(project, "02_lights"),
                      "the number 02 is taken: there is chapters/02_spheres");
    CHECK_THROWS_WITH(make_chapter(project, "10_spheres"),
                      "the name 'spheres' is taken: there is chapters/02_spheres");
    CHECK(read_catalogue(project).size() == 1);

    fs::remove_all(project.root / "solutions");
    CHECK_THROWS_WITH(make_chapter(project, "10_lights"),
                      "this is a handout, which has no solutions; ./course new needs them");
}
