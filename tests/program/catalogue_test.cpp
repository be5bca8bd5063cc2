// chapter.json is read strictly, and every complaint names file and key.
#include "common/workbook/catalogue.hpp"
#include "common/math/input_error.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <nlohmann/json.hpp>

using namespace rt;
using nlohmann::json;

namespace {

std::string error_of(const json& chapter) {
    const Project project = test::sandbox("catalogue");
    test::add_chapter(project, "02_spheres", chapter.dump());
    return test::error_of([&] { read_catalogue(project); });
}

json good() { return json::parse(test::good_chapter); }

}  // namespace

TEST_CASE("the catalogue of the course itself is right") {
    const auto chapters = read_catalogue({test::repository(), ""});
    REQUIRE(chapters.size() >= 3);
    CHECK(chapters[0].number == "01");
    for (const Chapter& chapter : chapters) {
        CHECK(chapter.steps.size() >= 3);
        CHECK(chapter.scenes.size() >= 3);
    }
}

TEST_CASE("a chapter is read with all that it says") {
    const Project project = test::sandbox("catalogue");
    test::add_chapter(project, "02_spheres", test::good_chapter);
    const auto chapters = read_catalogue(project);
    REQUIRE(chapters.size() == 1);
    CHECK(chapters[0].name == "02_spheres");
    CHECK(chapters[0].number == "02");
    CHECK(chapters[0].title == "Spheres");
    REQUIRE(chapters[0].steps.size() == 2);
    CHECK(chapters[0].steps[1].id == "02.2");
    CHECK(chapters[0].steps[1].points == 5);
    CHECK(chapters[0].steps[1].hints.size() == 3);
    CHECK(chapters[0].scenes == std::vector<std::string>{"one.scene"});
}

TEST_CASE("a directory with a contract only is no chapter yet; one with exercises must be described") {
    const Project project = test::sandbox("catalogue");
    test::write(project.root / "chapters/04_transforms/transform.hpp", "");
    CHECK(read_catalogue(project).empty());
    test::write(project.root / "chapters/04_transforms/transform.cpp", "");
    CHECK_THROWS_WITH(read_catalogue(project), "chapters/04_transforms/chapter.json: the file: is missing");
}

TEST_CASE("what is missing or of the wrong type is named") {
    json chapter = good();
    chapter.erase("title");
    CHECK(error_of(chapter) == "chapters/02_spheres/chapter.json: title: is missing");
    chapter = good();
    chapter["steps"][1].erase("points");
    CHECK(error_of(chapter) == "chapters/02_spheres/chapter.json: steps[1].points: is missing");
    chapter = good();
    chapter["steps"][0]["points"] = 0;
    CHECK(error_of(chapter).find("steps[0].points: expected a whole number") != std::string::npos);
    chapter["steps"][0]["points"] = 2.5;
    CHECK(error_of(chapter).find("steps[0].points: expected a whole number") != std::string::npos);
    chapter = good();
    chapter["steps"] = json::array();
    CHECK(error_of(chapter).find("steps: expected a list") != std::string::npos);
    CHECK(error_of(json::array()).find("expected an object") != std::string::npos);
}

TEST_CASE("two hints are too few") {
    json chapter = good();
    chapter["steps"][0]["hints"] = {"a", "b"};
    CHECK(error_of(chapter) ==
          "chapters/02_spheres/chapter.json: steps[0].hints: expected at least 3, not 2");
}

TEST_CASE("step numbers are of their chapter, and each once") {
    json chapter = good();
    chapter["steps"][1]["id"] = "03.2";
    CHECK(error_of(chapter).find("'03.2' is not a step of chapter 02") != std::string::npos);
    chapter["steps"][1]["id"] = "02.1";
    CHECK(error_of(chapter).find("steps[1].id: '02.1' is there twice") != std::string::npos);
}

TEST_CASE("files that are named must exist") {
    json chapter = good();
    chapter["steps"][0]["file"] = "sphere.cpp";
    CHECK(error_of(chapter).find("steps[0].file: there is no 'sphere.cpp'") != std::string::npos);
    chapter = good();
    chapter["scenes"].push_back("two.scene");
    CHECK(error_of(chapter) ==
          "chapters/02_spheres/chapter.json: scenes: there is no references/02_spheres/two.scene");
}

TEST_CASE("a key that nobody reads is refused") {
    json chapter = good();
    chapter["steps"][0]["hint"] = "x";
    CHECK(error_of(chapter) == "chapters/02_spheres/chapter.json: steps[0].hint: is not known");
}

TEST_CASE("chapters and steps are found as people write them") {
    const Project project = test::sandbox("catalogue");
    test::add_chapter(project, "02_spheres", test::good_chapter);
    const auto chapters = read_catalogue(project);
    for (const char* text : {"02", "2", "02_spheres"}) {
        CHECK(find_target(chapters, text).chapter == &chapters[0]);
        CHECK(find_target(chapters, text).step == nullptr);
    }
    for (const char* text : {"02.2", "2.2"}) CHECK(find_step(chapters, text).step == &chapters[0].steps[1]);
    CHECK_THROWS_WITH(find_target(chapters, "7"), "there is no chapter '7'; there are 02");
    CHECK_THROWS_WITH(find_target(chapters, "02.9"), "there is no step '02.9'; chapter 02 has 02.1, 02.2");
    CHECK_THROWS_AS(find_step(chapters, "02"), InputError);
    CHECK_THROWS_AS(find_target(chapters, ""), InputError);
}
