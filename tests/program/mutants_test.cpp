// Mutants: which are made of a few lines, and the lists of those that are right, too.
#include "common/evidence/mutants.hpp"
#include "common/evidence/equivalent_mutants.hpp"
#include "common/workbook/lexemes.hpp"
#include "common/workbook/variants.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fmt/ranges.h>

#include <algorithm>

using namespace rt;
using test::error_of;

namespace {

using Lines = std::vector<std::string>;

std::string exercise_of(const std::string& code) {
    return "const int other = 1 + 1;\n// [exercise 02.1] Do it.\n" + code + "\n// [/exercise]\n";
}

/// What becomes of this line of an exercise, in order.
Lines mutants(const std::string& code) {
    Lines lines;
    for (const Mutant& mutant : mutants_of(exercise_of(code), "x.cpp")) lines.push_back(mutant.to);
    return lines;
}

void check_mutants(const std::string& code, const Lines& expected) {
    INFO(fmt::format("{}\nbecomes\n{}\nexpected\n{}", code, fmt::join(mutants(code), "\n"),
                     fmt::join(expected, "\n")));
    CHECK(test::or_say(mutants(code) == expected, "these are other mutants"));
}

}  // namespace

TEST_CASE("a source is cut into words, numbers, quoted texts and signs") {
    Lines texts;
    for (const Lexeme& lexeme :
         lexemes_of("#include <a>\nx->y <<= 1'000 * .5e-3; // z\n/* q */ s = R\"(a\"b)\" 'c';"))
        texts.emplace_back(lexeme.text);
    CHECK(texts ==
          Lines{"x", "->", "y", "<<=", "1'000", "*", ".5e-3", ";", "s", "=", "R\"(a\"b)\"", "'c'", ";"});
}

TEST_CASE("operators between operands have others in their place") {
    check_mutants("return a < b;", {"return a <= b;", "return a >= b;"});
    check_mutants("return a + b * c;", {"return a - b * c;", "return a + b / c;"});
    check_mutants("return a && !b;", {"return a || !b;", "return a && b;"});
    check_mutants("const Vec3& a = -b;", {"const Vec3& a = b;"});
    check_mutants("sum += x;", {";", "sum -= x;", "sum = x;"});
    check_mutants("return i % n;", {"return i / n;"});
}

TEST_CASE("numbers are one more and one less, and fractions doubled") {
    check_mutants("return v[1];", {"return v[2];", "return v[0];"});
    check_mutants("return 0;", {"return 1;"});
    check_mutants("return 1u;", {"return 2u;", "return 0u;"});
    check_mutants("return 0x1p-3;", {"return (2 * 0x1p-3);"});
    check_mutants("const std::array<Real, 3> a = b;", {});
}

TEST_CASE("conditions are always or never true") {
    check_mutants("if (a) b();", {"if (true) b();", "if (false) b();", "if (a) ;"});
    check_mutants("while (a) b();", {"while (false) b();", "while (a) ;"});
    check_mutants("for (; a; b()) c();", {"for (; false; b()) c();", "for (; a; b()) ;"});
    check_mutants("if (const auto a = b()) c();", {"if (const auto a = b()) ;"});
    check_mutants("return a ? b : c;", {"return a || true ? b : c;", "return a && false ? b : c;"});
}

TEST_CASE("neighbours in a list change places, unless their order does not matter") {
    check_mutants("return cross(a, b, c);", {"return cross(b, a, c);", "return cross(a, c, b);"});
    check_mutants("return {a, f<b, c>(d, e)};", {"return {f<b, c>(d, e), a};"});
    check_mutants("return dot(a, b);", {});
    check_mutants("return cross(a, a);", {});
    check_mutants("return Hit{.t = a, .uv = b};", {});
}

TEST_CASE("calls and names that have an opposite") {
    check_mutants("return std::sqrt(a);", {"return (a);"});
    check_mutants("return std::min(a.x, b);", {"return std::max(a.x, b);", "return std::min(a.y, b);"});
    check_mutants("return a.size(b);", {});
    check_mutants("const Real a(b);", {});
}

TEST_CASE("statements are left out where they declare and return nothing") {
    check_mutants("Real a = b;\nauto c = d;\nstd::vector<int> e;\nconst Vec3& f = g;\nreturn h;", {});
    check_mutants("a = b;", {";"});
    check_mutants("a.b.reserve(n + 1);", {});
    check_mutants("for (const X& a : b) { if (c) continue; }",
                  {"for (const X& a : b) { if (true) continue; }",
                   "for (const X& a : b) { if (false) continue; }", "for (const X& a : b) { if (c) ; }"});
    check_mutants("const auto f = [&](int a) { b = a; };", {"const auto f = [&](int a) { ; };"});
}

TEST_CASE("a mutant knows its step, line and text") {
    const std::string solution = exercise_of("return a\n       < b;");
    const std::vector<Mutant> made = mutants_of(solution, "x.cpp");
    REQUIRE(made.size() == 2);
    CHECK(made[0].step == "02.1");
    CHECK(made[0].line == 4);
    CHECK(made[0].from == "< b;");
    CHECK(mutated(solution, made[0]) == exercise_of("return a\n       <= b;"));
}

TEST_CASE("the list of equivalent mutants is read whole, and says what is wrong with it") {
    const std::string good = "step 02.1\nfrom a < b;\nto   a <= b;\nto   a >= b;\nwhy  It is so.\n";
    const std::vector<EquivalentMutant> entries = parse_equivalent(good, "e");
    REQUIRE(entries.size() == 2);
    CHECK(entries[1].step == "02.1");
    CHECK(entries[1].from == "a < b;");
    CHECK(entries[1].to == "a >= b;");
    CHECK(entries[1].why == "It is so.");
    CHECK(entries[1].line == 4);
    const auto error = [](const std::string& text) { return error_of([&] { parse_equivalent(text, "e"); }); };
    CHECK(error("to a;\n") == "e:1: 'to' without a 'step' and a 'from' before it");
    CHECK(error("step 2\n") == "e:1: expected 'step NN.S', such as 'step 02.1'");
    CHECK(error("step 02.1\nfrom a;\nto b;\n") == "e:3: the last entry has no 'why'");
    CHECK(error("step 02.1\nfrom a;\nto b;\nfrom c;\n") == "e:4: the entry before has no 'why'");
    CHECK(error("why  so\n") == "e:1: 'why' without a 'to' before it");
    CHECK(error("from\n") == "e:1: expected 'step', 'from', 'to' or 'why', and a text");
    CHECK(error("form a;\n") == "e:1: expected 'step', 'from', 'to' or 'why', not 'form'");
}

TEST_CASE("no list of equivalent mutants names a line that is not there any more") {
    const Project project = this_project();
    for (const Chapter& chapter : read_catalogue(project)) {
        std::vector<Mutant> all;
        for (const auto& [file, text] : solution_files(project, chapter)) {
            const std::vector<Mutant> more = mutants_of(text, file);
            all.insert(all.end(), more.begin(), more.end());
        }
        const Lines stale =
            stale_entries(equivalent_mutants(project, chapter), all, equivalent_list(chapter));
        INFO(fmt::format("{}", fmt::join(stale, "\n")));
        CHECK(stale.empty());
    }
}
