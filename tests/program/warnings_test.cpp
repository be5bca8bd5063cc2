// The compiler's warnings of a student's files, and how long they are remembered.
#include "common/workbook/warnings.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

using namespace rt;

namespace {

struct Tree {
    Project project = test::sandbox("warnings");
    std::vector<Chapter> chapters;
    Tree() {
        test::add_chapter(project, "02_spheres", test::good_chapter);
        chapters = read_catalogue(project);
    }
    std::vector<std::string> known() const { return known_warnings(project, chapters[0]); }
    /// What ninja says as it compiles the exercise.
    std::string compiled(const std::string& said) const {
        return "[1/3] Building CXX object CMakeFiles/exercise_02.dir/chapters/02_spheres/x.cpp.o\n" + said +
               "[2/3] Building CXX object CMakeFiles/tests_02.dir/02_spheres/x_test.cpp.o\n"
               "tests/02_spheres/x_test.cpp:3:1: warning: not theirs\n";
    }
    std::string warning() const {
        return project.root.string() +
               "/chapters/02_spheres/x.cpp:3:1: warning: no return statement in function returning "
               "non-void\n";
    }
};

const std::vector<std::string> expected{
    "chapters/02_spheres/x.cpp:3:1: warning: no return statement in function returning non-void"};

}  // namespace

TEST_CASE("a warning is known as long as the file is as it was compiled") {
    const Tree tree;
    CHECK(tree.known().empty());
    remember_warnings(tree.project, tree.compiled(tree.warning() + "   3 | }\n" + tree.warning()));
    CHECK(tree.known() == expected);
    // Later builds compile other files.
    remember_warnings(tree.project, "[1/1] Linking CXX executable bin/check_02\n");
    CHECK(tree.known() == expected);

    const auto exercise = tree.project.root / "chapters/02_spheres/x.cpp";
    test::write(exercise, "int f() { return 1; }\n");
    CHECK(tree.known().empty());
    remember_warnings(tree.project, tree.compiled(""));
    CHECK(tree.known().empty());
}

TEST_CASE("a file that does not compile may have warnings, too") {
    const Tree tree;
    remember_warnings(
        tree.project,
        "FAILED: CMakeFiles/exercise_02.dir/chapters/02_spheres/x.cpp.o \n/usr/bin/c++ -c x.cpp\n" +
            tree.warning() + "ninja: build stopped: subcommand failed.\n");
    CHECK(tree.known() == expected);
}

TEST_CASE("a damaged memory of warnings knows nothing") {
    const Tree tree;
    for (const char* text : {"{", "[]", "{\"chapters/02_spheres/x.cpp\": 1}"}) {
        INFO("the memory is " << text);
        test::write(tree.project.build / "warnings.json", text);
        CHECK(tree.known().empty());
    }
    remember_warnings(tree.project, tree.compiled(tree.warning()));
    CHECK(tree.known() == expected);
}

TEST_CASE("of many warnings the first are shown") {
    CHECK(warnings_in_words({}).empty());
    CHECK(warnings_in_words({"a", "b"}) == "  The compiler warns:\n      a\n      b\n");
    CHECK(warnings_in_words(std::vector<std::string>(7, "a"))
              .ends_with("      a\n      … and 2 more warnings\n"));
}
