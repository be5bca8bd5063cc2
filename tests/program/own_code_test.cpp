// What of the course's code is the student's, and what the solutions fill in.
#include "common/workbook/own_code.hpp"
#include "common/image/whole_file.hpp"
#include "common/workbook/results.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

using namespace rt;

namespace {

/// The student's x.cpp of chapter 2, where one function is written in place of its `return todo`.
void write_step(const Project& project, const std::string& step, const std::string& code) {
    const auto file = project.root / "chapters/02_spheres/x.cpp";
    std::string text = read_file(file);
    const std::string todo = "return todo(\"" + step + "\");";
    REQUIRE(text.find(todo) != std::string::npos);
    test::write(file, text.replace(text.find(todo), todo.size(), code));
}

Project half_way(const std::string& name) {
    const Project project = test::sandbox(name);
    test::add_chapter(project, "02_spheres", test::good_chapter);
    return project;
}

}  // namespace

TEST_CASE("nothing is the student's before it is begun") {
    const Project project = half_way("own nothing");
    CHECK(is_empty(own_code(project, read_catalogue(project))));
    CHECK(begun_steps(project, read_catalogue(project).front()).empty());
}

TEST_CASE("a chapter that is half written is the student's by steps, all of it as a whole") {
    const Project project = half_way("own half");
    write_step(project, "02.1", "return 5;");
    const std::vector<Chapter> chapters = read_catalogue(project);
    OwnCode own = own_code(project, chapters);
    CHECK(own.whole.empty());
    CHECK(own.filled == std::vector<std::string>{"02_spheres/x.cpp"});
    CHECK(in_words(own) == "02.1");

    write_step(project, "02.2", "// return todo(\"02.2\");\n    return 6;");
    own = own_code(project, chapters);
    CHECK(own.filled.empty());
    CHECK(in_words(own) == "02");
}

TEST_CASE("without solutions all chapters are the student's") {
    const Project project = half_way("own handout");
    const std::vector<Chapter> chapters = read_catalogue(project);
    std::filesystem::remove_all(project.root / "solutions");
    CHECK(in_words(own_code(project, chapters)) == "02");
}

TEST_CASE("the solution fills in what is not begun, and compilers name the right lines") {
    const std::string pristine =
        "int f() {\n    return todo(\"02.1\");\n}\n\nint g() {\n    return todo(\"02.2\");\n}\n";
    const std::string solution = "// Two.\nint f() {\n    return 1;\n}\n\nint g() {\n    return 2;\n}\n";
    const std::string mine =
        "int f()\n{ return 5; }\n\nint g()\n{\n    return todo(\"02.2\");\n}\nint h();\n";
    CHECK(filled_text(mine, pristine, solution, "02_spheres/x.cpp") ==
          "#line 1 \"chapters/02_spheres/x.cpp\"\nint f()\n{ return 5; }\n\n"
          "#line 6 \"solutions/02_spheres/x.cpp\"\nint g() {\n    return 2;\n}\n"
          "#line 8 \"chapters/02_spheres/x.cpp\"\nint h();\n");
}

TEST_CASE("a file that is filled in is written once") {
    const Project project = half_way("own file");
    write_step(project, "02.2", "return 6;");
    const std::vector<Chapter> chapters = read_catalogue(project);
    write_filled(project, own_code(project, chapters));
    const auto made = project.build / "mine/02_spheres/x.cpp";
    CHECK_THAT(read_file(made), Catch::Contains("return 1;") && Catch::Contains("return 6;"));
    const auto before = std::filesystem::last_write_time(made);
    write_filled(project, own_code(project, chapters));
    CHECK(std::filesystem::last_write_time(made) == before);
}
