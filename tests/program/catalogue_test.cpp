// chapter.json is read strictly, and every complaint names its place and key.
#include "common/workbook/catalogue.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/results.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

using namespace rt;

namespace {

std::string error_of(const std::string& chapter) {
    const Project project = test::sandbox("catalogue");
    test::add_chapter(project, "02_spheres", chapter);
    return test::error_of([&] { read_catalogue(project); });
}

/// The good chapter with the first `old` in another way.
std::string with(const std::string& old, const std::string& other) {
    std::string chapter = test::good_chapter;
    return chapter.replace(chapter.find(old), old.size(), other);
}

std::string without(const std::string& old) { return with(old, ""); }

}  // namespace

TEST_CASE("the catalogue of the course itself is right") {
    const auto chapters = read_catalogue({test::repository(), ""});
    REQUIRE(chapters.size() >= 3);
    CHECK(chapters[0].number == "01");
    for (const Chapter& chapter : chapters) {
        CHECK(chapter.steps.size() >= 3);
        CHECK(chapter.scenes.size() >= 3);
        for (const Step& step : chapter.steps)
            for (const std::string& used : step.uses) {
                INFO(step.id << " uses " << used);
                CHECK(find_step(chapters, used).step);
            }
    }
}

TEST_CASE("no hint has more than three sentences") {
    const auto sentences = [](const std::string& text) {
        int count = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const bool ends = i + 1 == text.size() || text[i + 1] == ' ';
            const bool is_one_of_three = i > 0 && text[i] == '.' && text[i - 1] == '.';
            if (ends && !is_one_of_three && std::string(".!?").find(text[i]) != std::string::npos) ++count;
        }
        return count;
    };
    for (const Chapter& chapter : read_catalogue({test::repository(), ""}))
        for (const Step& step : chapter.steps)
            for (const std::string& hint : step.hints) {
                INFO(step.id << ": " << hint);
                CHECK(sentences(hint) <= 3);
            }
}

TEST_CASE("the README's table has the chapters' hours") {
    const std::string readme = read_file(test::repository() + "/README.md");
    for (const Chapter& chapter : read_catalogue({test::repository(), ""})) {
        INFO(chapter.name);
        const std::size_t row = readme.find("](chapters/" + chapter.name + "/README.md) |");
        REQUIRE(row != std::string::npos);
        CHECK_THAT(readme.substr(row, readme.find('\n', row) - row),
                   Catch::EndsWith("| " + std::to_string(chapter.hours) + " |"));
    }
}

TEST_CASE("a step uses earlier ones, of its own chapter or of another") {
    const std::string second = "\"id\": \"02.2\",";
    const auto using_step = [&](const std::string& used) {
        return with(second, second + " \"uses\": [\"" + used + "\"],");
    };
    CHECK(error_of(using_step("02.1")) == "");
    CHECK(error_of(using_step("01.9")) == "");
    for (const std::string used : {"02.2", "02.3", "03.1", "x", ""})
        CHECK_THAT(error_of(using_step(used)),
                   Catch::EndsWith("steps/1/uses/0: '" + used + "' is not an earlier step"));
}

TEST_CASE("a chapter is read with all that it says") {
    const Project project = test::sandbox("catalogue");
    test::add_chapter(project, "02_spheres", test::good_chapter);
    const auto chapters = read_catalogue(project);
    REQUIRE(chapters.size() == 1);
    CHECK(chapters[0].name == "02_spheres");
    CHECK(chapters[0].number == "02");
    CHECK(chapters[0].title == "Spheres");
    CHECK(chapters[0].hours == 3);
    REQUIRE(chapters[0].steps.size() == 2);
    CHECK(chapters[0].steps[1].id == "02.2");
    CHECK(chapters[0].steps[1].points == 5);
    CHECK(chapters[0].steps[1].hints.size() == 3);
    CHECK(chapters[0].scenes == std::vector<std::string>{"one.scene"});
}

TEST_CASE("a step may be optional") {
    const Project project = test::sandbox("catalogue");
    std::string description = test::good_chapter;
    description.replace(description.find("\"points\": 5"), 11, "\"points\": 5, \"optional\": true");
    test::add_chapter(project, "02_spheres", description);
    const auto chapters = read_catalogue(project);
    CHECK_FALSE(chapters[0].steps[0].optional);
    CHECK(chapters[0].steps[1].optional);
    CHECK(all_todo(chapters[0]).steps[1].optional);
}

TEST_CASE("a directory with a contract only is no chapter yet; one with exercises must be described") {
    const Project project = test::sandbox("catalogue");
    test::write(project.root / "chapters/04_transforms/transform.hpp", "");
    CHECK(read_catalogue(project).empty());
    test::write(project.root / "chapters/04_transforms/transform.cpp", "");
    CHECK_THROWS_WITH(read_catalogue(project), "chapters/04_transforms/chapter.json is missing");
}

TEST_CASE("what is missing or of the wrong type is named, with its place") {
    const std::string file = "chapters/02_spheres/chapter.json:";
    CHECK(error_of(without("\"title\": \"Spheres\",")) == file + "1:1: the file: 'title' is missing");
    CHECK(error_of(without("\"hours\": 3,")) == file + "1:1: the file: 'hours' is missing");
    CHECK(error_of(with("\"hours\": 3", "\"hours\": 0")) ==
          file + "4:12: hours: expected a whole number from 1 to 100");
    CHECK(error_of(with("\"hours\": 3", "\"hours\": 2.5")) ==
          file + "4:12: hours: expected a whole number from 1 to 100");
    CHECK(error_of(with("\"hours\": 3", "\"hours\": \"3\"")) ==
          file + "4:12: hours: expected a whole number from 1 to 100");
    CHECK(error_of(with("\"points\": 10", "\"points\": 0")) ==
          file + "6:65: steps/0/points: expected a whole number from 1 to 1000");
    CHECK(error_of(with("\"points\": 10,", "")) == file + "6:5: steps/0: 'points' is missing");
    CHECK(error_of(with("\"Round things.\"", "\"\"")) == file + "3:14: summary: expected a text");
    CHECK(error_of(with("\"scenes\"", "\"steps\": [], \"scenes\"")) == file + "9:3: steps: is there twice");
    CHECK(error_of(R"({"title": "T", "summary": "S", "hours": 1, "steps": [], "scenes": []})") ==
          file + "1:53: steps: expected at least one step");
    CHECK(error_of("[]") == file + "1:1: the file: expected an object");
    CHECK(error_of("{").starts_with(file + "1:2: is not JSON"));
}

TEST_CASE("two hints are too few") {
    CHECK(error_of(with(R"(["a", "b", "c"])", R"(["a", "b"])")) ==
          "chapters/02_spheres/chapter.json:6:78: steps/0/hints: expected at least 3, not 2");
}

TEST_CASE("step numbers are of their chapter, and each once") {
    CHECK_THAT(error_of(with("02.2", "03.2")), Catch::EndsWith("7:12: steps/1/id: '03.2' is not a step of "
                                                               "chapter 02; expected '02.N'"));
    CHECK_THAT(error_of(with("02.2", "02.1")), Catch::EndsWith("7:12: steps/1/id: '02.1' is there twice"));
}

TEST_CASE("files that are named must exist") {
    CHECK_THAT(error_of(with("x.cpp", "sphere.cpp")),
               Catch::EndsWith("6:46: steps/0/file: there is no 'sphere.cpp' beside this file"));
    CHECK_THAT(error_of(with("\"points\": 10", "\"points\": 10, \"picture\": \"two.scene\"")),
               Catch::EndsWith("steps/0/picture: there is no references/02_spheres/two.scene"));
    CHECK_THAT(error_of(with("\"one.scene\"", "\"one.scene\", \"two.scene\"")),
               Catch::EndsWith("9:27: scenes/1: there is no references/02_spheres/two.scene"));
}

TEST_CASE("a key that nobody reads is refused") {
    CHECK_THAT(error_of(with("\"points\": 10", "\"point\": 10")),
               Catch::Contains("6:64: steps/0/point: is not known; there are id, title, file, points, "
                               "optional, picture, hints"));
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
