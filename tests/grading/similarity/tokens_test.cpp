// Tokens: what a copy can change without another thought is forgotten, and nothing else.
#include "common/similarity/tokens.hpp"
#include "tests/catch.hpp"

#include <string>

using namespace rt;

namespace {

/// The kinds as text, to be compared.
std::vector<int> kinds(std::string_view source) {
    std::vector<int> all;
    for (const Token& token : tokens_of(source)) all.push_back(token.kind);
    return all;
}

}  // namespace

TEST_CASE("names, values and layout are forgotten", "[similarity]") {
    const auto original = kinds("const double area = width * height + 2;");
    CHECK(original.size() == 9);
    CHECK(kinds("auto a=w*h+0x1p-3;") == original);
    CHECK(kinds("/* x */ float a = // y\n w * /*\n*/ h\n+ 'c' ;") == original);
    CHECK(kinds("static constexpr Real größe = w * h + \"text \\\" + 1\";") == original);
    CHECK(kinds("std::size_t a = std::w * ::h + R\"x( ) + \" )x\";") == original);
    CHECK(kinds("double a = w * h + nullptr;") == original);
    CHECK(kinds("double a = w * h - 2;") != original);
    CHECK(kinds("double a = w * h + x;") != original);
}

TEST_CASE("braces, qualifiers and included files are dropped", "[similarity]") {
    CHECK(kinds("if (a) { return b; }") == kinds("if (a) return b;"));
    CHECK(kinds("#include \"x.hpp\"\n# include <y>\n#pragma once\nint a;") == kinds("int a;"));
    CHECK(kinds("#define SQUARE(x) x * x\n").size() == 8);
    CHECK(kinds("// one \\\n still one\nint a;") == kinds("int a;"));
    CHECK(kinds("not a and b or c") == kinds("!a && b || c"));
}

TEST_CASE("operators are as long as they can be, and keywords differ", "[similarity]") {
    CHECK(kinds("a <<= b").size() == 3);
    CHECK(kinds("a <=> b").size() == 3);
    CHECK(kinds("a<b>>c").size() == 5);
    CHECK(kinds("x = 1.5e+3f - 1'000.0;").size() == 6);
    CHECK(kinds("while (a)") != kinds("if (a)"));
    CHECK(kinds("a->b") != kinds("a.b"));
}

TEST_CASE("lines are counted through everything", "[similarity]") {
    const std::vector<Token> tokens = tokens_of("a /*\n*/ b R\"(\n\n)\"\n// \\\nx\nc");
    REQUIRE(tokens.size() == 4);
    CHECK(tokens[0].line == 1);
    CHECK(tokens[1].line == 2);
    CHECK(tokens[2].line == 2);
    CHECK(tokens[3].line == 7);
}

TEST_CASE("a source that is none has tokens all the same", "[similarity]") {
    for (const char* broken : {"\"never closed", "'", "/* never closed", "R\"x(never", "R\"never", "#", "\\",
                               "// \\", "1e+", "\x01\x80@`{", "\"\\"})
        CHECK(kinds(broken).size() <= 2);
    CHECK(kinds(std::string_view("a\0b", 3)).size() == 2);
}
