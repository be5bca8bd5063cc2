// Functions are found in source text, so that one step can be reset or shown.
#include "common/workbook/functions.hpp"
#include "tests/catch.hpp"

using namespace rt;

namespace {

constexpr std::string_view text = R"(#include <x>

namespace rt {

int first(int a) { return a; }

std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray,
                             Interval range) {
    // a brace in a comment }
    const char* s = "}";
    const char c = '}';
    const int n = 1'000;
    return todo("02.3");
}

/// A comment.
bool any(int a) {
    return todo("02.5");
}

bool more(int a) {
    if (a) {
        return todo("02.5");
    }
    return todo("02.5");
}

}  // namespace rt
)";

std::string cut(std::string_view from, const FunctionText& function) {
    return std::string(from.substr(function.begin, function.end - function.begin));
}

}  // namespace

TEST_CASE("the functions that hold a text are found once each") {
    const auto functions = functions_with(text, "todo(\"02.5\")");
    REQUIRE(functions.size() == 2);
    CHECK(functions[0].signature == "bool any(int a)");
    CHECK(cut(text, functions[0]) == "bool any(int a) {\n    return todo(\"02.5\");\n}\n");
    CHECK(functions[1].signature == "bool more(int a)");
    CHECK(functions[1].line == 21);
}

TEST_CASE("braces in comments, strings and characters do not count") {
    const auto functions = functions_with(text, "todo(\"02.3\")");
    REQUIRE(functions.size() == 1);
    CHECK(functions[0].line == 7);
    const std::string function = cut(text, functions[0]);
    CHECK(function.ends_with("    return todo(\"02.3\");\n}\n"));
}

TEST_CASE("a function is found again however it is formatted") {
    const std::string_view mine =
        "bool other() { return 1; }\nbool  any( int a )\n{ if (a) { return 0; } }\nint x;\n";
    const auto function = find_function(mine, "bool any(int a)");
    REQUIRE(function);
    CHECK(cut(mine, *function) == "bool  any( int a )\n{ if (a) { return 0; } }\n");
    CHECK(function->line == 2);
}

TEST_CASE("a function that is gone, or whose braces do not match, is not found") {
    CHECK_FALSE(find_function(text, "bool any(long a)"));
    CHECK_FALSE(find_function("bool any(int a) { if (a) {\n}\n", "bool any(int a)"));
}

TEST_CASE("a function that was deleted is put back in its place") {
    const std::string original =
        "namespace rt {\n\nint one() {\n    return 1;\n}\n\nint two(int n) {\n    return n;\n}\n\n"
        "int three() {\n    return 3;\n}\n\n}  // namespace rt\n";
    const auto functions = functions_with(original, "return");
    REQUIRE(functions.size() == 3);
    for (const FunctionText& function : functions) {
        INFO("deleted: " << function.signature);
        std::string mine = original;
        mine.erase(function.begin, function.end - function.begin + 1);
        CHECK(with_function(mine, original, function) == original);
    }
    const std::string bare = "namespace rt {\n}  // namespace rt\n";
    CHECK(with_function(bare, original, functions[0]) ==
          "namespace rt {\nint one() {\n    return 1;\n}\n\n}  // namespace rt\n");
    CHECK_FALSE(with_function("int other();\n", original, functions[0]));
    // One of the name with other parameters would stay beside it.
    CHECK_FALSE(with_function("int three() {\n    return 3;\n}\n\nint two(long n) {\n    return 2;\n}\n",
                              original, functions[1]));
}
