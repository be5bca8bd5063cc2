// Exercises are generated from annotated solutions.
#include "common/workbook/exercise.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/project.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <filesystem>

using namespace rt;

namespace {

constexpr auto solution = R"(// A file.
#include "chapters/02_spheres/x.hpp"

#include "common/math/error.hpp"
#include "common/math/vec.hpp"

#include <cmath>

int given(int a) { return a; }

int f(int a) {
    const int kept = given(a);
    // [exercise 02.1] Add one to `kept`
    // and return it.
    const int sum = kept + 1;
    // A comment in the solution.
    return sum;
    // [/exercise]
}

int g(int a) {
    if (a > 0) {
        // [exercise 02.2] The positive case.
        return a;
        // [/exercise]
    }
    // [exercise 02.3] The other.
    return -a;
    // [/exercise]
}
)";

constexpr auto exercise = R"(// A file.
#include "chapters/02_spheres/x.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"
#include "common/math/vec.hpp"

#include <cmath>

int given(int a) { return a; }

int f(int a) {
    const int kept = given(a);
    // 02.1  Add one to `kept`
    // and return it.
    return todo("02.1");
}

int g(int a) {
    if (a > 0) {
        // 02.2  The positive case.
        return todo("02.2");
    }
    // 02.3  The other.
    return todo("02.3");
}
)";

/// The message that the generator has for a file of these lines.
std::string error_of(const std::string& text) {
    return test::error_of([&] { exercise_text(text, "x.cpp"); });
}

std::string with_includes(const std::string& includes) {
    return includes + "\nint f() {\n    // [exercise 01.1] Task.\n    return 1;\n    // [/exercise]\n}\n";
}

}  // namespace

TEST_CASE("every marked part becomes its task and a todo") {
    CHECK(exercise_text(solution, "x.cpp") == exercise);
}

TEST_CASE("an exercise is its own exercise") { CHECK(exercise_text(exercise, "x.cpp") == exercise); }

TEST_CASE("regions carry their step and lines") {
    const auto regions = exercise_regions(solution, "x.cpp");
    REQUIRE(regions.size() == 3);
    CHECK(regions[0].step == "02.1");
    CHECK(regions[0].first_line == 13);
    CHECK(regions[0].last_line == 18);
    CHECK(regions[2].step == "02.3");
}

TEST_CASE("a reader of the solution sees neither marks nor tasks") {
    const std::string text = solution_text(solution, "x.cpp");
    CHECK(text.find("[exercise") == std::string::npos);
    CHECK(text.find("[/exercise]") == std::string::npos);
    CHECK(text.find("Add one") == std::string::npos);
    CHECK(text.find("    const int kept = given(a);\n    const int sum = kept + 1;\n    // A comment in the "
                    "solution.\n    return sum;\n}") != std::string::npos);
}

TEST_CASE("the header of todo goes where the formatter wants it") {
    const std::string todo = "#include \"common/math/todo.hpp\"\n";
    const std::string own = "#include \"chapters/01_ray_casting/x.hpp\"\n";
    const auto head = [](const std::string& text) {
        const std::string made = exercise_text(with_includes(text), "x.cpp");
        return made.substr(0, made.find("\nint f"));
    };
    CHECK(head(own) == own + "\n" + todo);
    CHECK(head(own + "\n#include <cmath>\n") == own + "\n" + todo + "\n#include <cmath>\n");
    CHECK(head(own + "\n#include \"common/math/error.hpp\"\n") ==
          own + "\n#include \"common/math/error.hpp\"\n" + todo);
    CHECK(head(own + "\n#include \"common/math/vec.hpp\"\n") ==
          own + "\n" + todo + "#include \"common/math/vec.hpp\"\n");
    CHECK(head(own + "\n" + todo) == own + "\n" + todo);
}

TEST_CASE("marks that do not match are refused with their line") {
    CHECK(error_of("int f() {\n// [exercise 02.1] T.\nreturn 1;\n}\n") ==
          "x.cpp:2: the exercise is not closed; expected '// [/exercise]' below");
    CHECK(error_of("int f() {\n// [/exercise]\n}\n") ==
          "x.cpp:2: '[/exercise]' closes an exercise that was not opened");
    CHECK(error_of("// [exercise 02.1] T.\na;\n// [exercise 02.2] T.\nb;\n// [/exercise]\n").substr(0, 8) ==
          "x.cpp:3:");
}

TEST_CASE("malformed marks are refused with their line") {
    CHECK(error_of("\n// [exercise 2.1] T.\na;\n// [/exercise]\n") ==
          "x.cpp:2: '2.1' is not a step; expected '[exercise NN.S]', such as 02.1");
    CHECK(error_of("// [exercise 02.1]\na;\n// [/exercise]\n").substr(0, 8) == "x.cpp:1:");
    CHECK(error_of("// [exercise 02.1 T\na;\n// [/exercise]\n").substr(0, 8) == "x.cpp:1:");
    CHECK(error_of("// [exercise 02.1] T.\na;\n// [/exercice]\n").substr(0, 8) == "x.cpp:3:");
    CHECK(error_of("// [exercise 02.1] T.\n// [/exercise]\n") == "x.cpp:2: the exercise has no code");
}

TEST_CASE("steps have a form") {
    CHECK(is_step_id("02.1"));
    CHECK(is_step_id("12.10"));
    for (const char* wrong : {"", "2.1", "02", "02.", "02.x", "a2.1", "02.100", "02-1", "02.1 "}) {
        INFO("step := " << wrong);
        CHECK_FALSE(is_step_id(wrong));
    }
}

TEST_CASE("every solution of the course generates an exercise without marks, and twice the same") {
    namespace fs = std::filesystem;
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(test::repository() + "/solutions")) {
        if (entry.path().extension() != ".cpp") continue;
        INFO("file := " << entry.path().string());
        const std::string text = read_file(entry.path());
        const std::string once = exercise_text(text, entry.path().string());
        CHECK(once.find("[exercise") == std::string::npos);
        CHECK(once.find("[/exercise]") == std::string::npos);
        CHECK(exercise_text(once, "once") == once);
        CHECK(exercise_regions(text, "x").empty() == (once == text));
        ++files;
    }
    CHECK(files > 0);
}
