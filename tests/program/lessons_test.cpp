// The form of lessons (CONTRIBUTING.md), the code that they show, and the numbers in them.
#include "common/evidence/lesson_numbers.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/lesson.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

using Lines = std::vector<std::string>;

/// A page of a lesson, without its blocks of code and formulas; these lines are empty.
struct Page {
    std::string name;  ///< "chapters/02_spheres/README.md"
    std::string text;
    Lines prose;
};

Lines prose_of(const std::string& text) {
    Lines lines = split_lines(text);
    bool in_block = false;
    for (std::string& line : lines) {
        const bool is_fence = line.starts_with("```") || line == "$$";
        if (is_fence) in_block = !in_block;
        if (in_block || is_fence) line.clear();
    }
    return lines;
}

std::vector<Page> pages(const Chapter& chapter) {
    std::vector<Page> all;
    for (const fs::path& file : pages_of(fs::path(test::repository()) / "chapters" / chapter.name)) {
        const std::string text = read_file(file);
        all.push_back({relative(this_project(), file), text, prose_of(text)});
    }
    return all;
}

std::vector<Chapter> chapters() { return read_catalogue(this_project()); }

bool has(const std::string& line, const std::string& text) { return line.find(text) != std::string::npos; }

std::size_t words_in(const Lines& lines, std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        std::istringstream in(std::regex_replace(lines[i], std::regex("<!--.*?-->"), ""));
        for (std::string word; in >> word;) ++count;
    }
    return count;
}

std::string place(const Page& page, std::size_t line) { return fmt::format("{}:{}", page.name, line + 1); }

/// The lines from this one to the next empty one, as one text.
std::string paragraph(const Lines& lines, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < lines.size() && !lines[i].empty(); ++i) text += lines[i] + " ";
    return text;
}

/// The steps that the pages ask for, in the order in which they do, and paragraphs that do not say how a step
/// is checked.
void read_tasks(const Page& page, Lines& steps, Lines& unchecked) {
    static const std::regex task("^\\*\\*Now write (\\d\\d\\.\\d+)\\*\\*.*");
    for (std::size_t i = 0; i < page.prose.size(); ++i) {
        std::smatch found;
        if (!std::regex_match(page.prose[i], found, task)) continue;
        steps.push_back(found[1]);
        if (!has(paragraph(page.prose, i), "`./course check " + found[1].str() + "`"))
            unchecked.push_back(place(page, i));
    }
}

std::size_t line_that_begins(const Page& page, const std::string& text) {
    const auto found = std::ranges::find_if(page.prose, [&](const auto& l) { return l.starts_with(text); });
    return static_cast<std::size_t>(found - page.prose.begin());
}

/// Whether a table's row has at least two cells that are nothing but numbers.
bool has_numbers(const std::string& row) {
    static const std::regex number("[-−]?[\\d.,·⁰¹²³⁴⁵⁶⁷⁸⁹⁻$ %]*\\d[\\d.,·⁰¹²³⁴⁵⁶⁷⁸⁹⁻$ %]*");
    int count = 0;
    std::istringstream in(row);
    for (std::string cell; std::getline(in, cell, '|');) count += std::regex_match(cell, number);
    return count >= 2;
}

}  // namespace

TEST_CASE("a lesson leads to each of its steps, in their order, and says how it is checked", "[lessons]") {
    for (const Chapter& chapter : chapters()) {
        INFO("chapter " << chapter.name);
        Lines asked, unchecked, expected;
        for (const Page& page : pages(chapter)) read_tasks(page, asked, unchecked);
        for (const Step& step : chapter.steps) expected.push_back(step.id);
        CHECK(asked == expected);
        CHECK(unchecked == Lines{});
    }
}

TEST_CASE("a lesson's first picture and first step come within its first third", "[lessons]") {
    for (const Chapter& chapter : chapters()) {
        const Page page = pages(chapter).front();
        INFO(page.name);
        const std::size_t all = words_in(page.prose, 0, page.prose.size());
        CHECK(words_in(page.prose, 0, line_that_begins(page, "**Now write ")) * 3 <= all);
        CHECK(words_in(page.prose, 0, line_that_begins(page, "*Figure ")) * 3 <= all);
    }
}

TEST_CASE("each page of a lesson is read in a sitting", "[lessons]") {
    for (const Chapter& chapter : chapters())
        for (const Page& page : pages(chapter)) {
            INFO(page.name);
            CHECK(words_in(page.prose, 0, line_that_begins(page, "## Where to read on")) <= 2500);
        }
}

TEST_CASE("a lesson's figures say what they show, and are numbered", "[lessons]") {
    static const std::regex picture("!\\[([^\\]]*)\\]\\("), caption("^\\*Figure (\\d+)\\.(\\d+)\\. .*");
    for (const Chapter& chapter : chapters()) {
        int number = 0;
        for (const Page& page : pages(chapter))
            for (std::size_t i = 0; i < page.prose.size(); ++i) {
                const std::string& line = page.prose[i];
                INFO(place(page, i));
                for (std::sregex_iterator k(line.begin(), line.end(), picture), end; k != end; ++k)
                    CHECK((*k)[1].length() >= 15);
                std::smatch found;
                if (std::regex_match(line, found, caption)) {
                    CHECK(std::stoi(found[1]) == std::stoi(chapter.number));
                    CHECK(std::stoi(found[2]) == ++number);
                }
                if (!line.starts_with("![")) continue;
                std::size_t next = i + 1;
                while (next + 1 < page.prose.size() && page.prose[next].empty()) ++next;
                CHECK(page.prose[next].substr(0, 8) == "*Figure ");
            }
    }
}

TEST_CASE("a lesson works one example by hand, and shows code and a mistake", "[lessons]") {
    for (const Chapter& chapter : chapters()) {
        INFO("chapter " << chapter.name);
        std::string text;
        for (const Page& page : pages(chapter)) text += page.text;
        CHECK(has(text, "\n### By hand: "));
        CHECK(has(text, "\n<!-- code "));
        CHECK(has(text, "\n<!-- mistake "));
    }
}

TEST_CASE("a lesson ends with three to five challenges, one an optional step, the others with answers",
          "[lessons]") {
    for (const Chapter& chapter : chapters()) {
        const Page page = pages(chapter).back();
        INFO(page.name);
        const std::size_t first = line_that_begins(page, "## Challenges");
        const std::size_t last = line_that_begins(page, "## Where to read on");
        REQUIRE(first < last);
        REQUIRE(last < page.prose.size());
        const auto challenges =
            std::count_if(page.prose.begin() + static_cast<std::ptrdiff_t>(first),
                          page.prose.begin() + static_cast<std::ptrdiff_t>(last),
                          [](const auto& line) { return std::regex_search(line, std::regex("^\\d\\. ")); });
        CHECK(challenges >= 3);
        CHECK(challenges <= 5);
        // Its tests answer the optional step; what the others ask is answered behind a fold.
        const auto answers =
            std::count_if(page.prose.begin() + static_cast<std::ptrdiff_t>(first),
                          page.prose.begin() + static_cast<std::ptrdiff_t>(last),
                          [](const auto& line) { return has(line, "<summary>Answer</summary>"); });
        CHECK(answers + 1 >= challenges);
        CHECK(std::ranges::any_of(chapter.steps, &Step::optional));
        CHECK(!chapter.steps.front().optional);
    }
}

TEST_CASE("what can be skipped in a lesson says so", "[lessons]") {
    for (const Chapter& chapter : chapters())
        for (const Page& page : pages(chapter))
            for (std::size_t i = 0; i < page.prose.size(); ++i)
                if (has(page.prose[i], "For the curious")) {
                    INFO(place(page, i));
                    CHECK(page.prose[i].substr(0, 47) == "> **For the curious.** Nothing below needs it. ");
                }
}

TEST_CASE("lessons are in British spelling, save words of code, formulas and titles", "[lessons]") {
    static const std::regex not_prose("`[^`]*`|\\$[^$]*\\$|<!--.*?-->|\\]\\([^)]*\\)");
    static const std::regex american(
        "\\b([Cc]ent(er|ers|ered)|[Cc]olor\\w*|[Nn]eighbor\\w*|[Bb]ehavior|gray|[Ff]avor\\w*|[Mm]eters?|"
        "[Tt]oward|([Nn]ormal|[Rr]ecogn|[Oo]rgan|[Rr]eal|[Mm]inim|[Mm]axim)iz\\w*|[Mm]odel(ed|ing))\\b");
    for (const Chapter& chapter : chapters())
        for (const Page& page : pages(chapter))
            for (std::size_t i = 0; i < line_that_begins(page, "## Where to read on"); ++i) {
                const std::string& line = page.prose[i];
                if (line.starts_with("|")) continue;
                std::smatch found;
                const std::string prose = std::regex_replace(line, not_prose, "");
                INFO(place(page, i) << " has a word that is American");
                CHECK((std::regex_search(prose, found, american) ? found.str() : "") == "");
            }
}

TEST_CASE("numbers in lessons are those of the tables that programs wrote", "[lessons]") {
    const fs::path root = test::repository();
    for (const Chapter& chapter : chapters())
        for (const Page& page : pages(chapter))
            CHECK(wrong_numbers(page.text, page.name, root / "references" / chapter.name / "figures", root) ==
                  Lines{});
}

TEST_CASE("a table of numbers in a lesson says where they are from", "[lessons]") {
    for (const Chapter& chapter : chapters())
        for (const Page& page : pages(chapter))
            for (std::size_t i = 1; i + 2 < page.prose.size(); ++i)
                if (page.prose[i].starts_with("|-") && has_numbers(page.prose[i + 1])) {
                    INFO(place(page, i - 1));
                    CHECK((i >= 2 && page.prose[i - 2].starts_with("<!-- table ")));
                }
}

TEST_CASE("a number is read as a person writes it", "[lessons]") {
    const auto value = [](const char* text) { return last_number(text).value().value; };
    const auto unit = [](const char* text) { return last_number(text).value().unit; };
    CHECK(value("of 3,221 rays") == 3221);
    CHECK(value("**2.60** minutes") == 2.6);
    CHECK(unit("2.60") == Approx(0.01));
    CHECK(unit("3,000") == 100);
    CHECK(value("7·10⁻¹⁶") == Approx(7e-16));
    CHECK(value("$-2.5 \\cdot 10^{-8}$") == Approx(-2.5e-8));
    CHECK(unit("$-2.5 \\cdot 10^{-8}$") == Approx(1e-9));
    CHECK(value("10⁸ radii") == 1e8);
    CHECK(value("−10⁴") == -1e4);
    CHECK(value("1e-7") == Approx(1e-7));
    CHECK(!last_number("none"));
}

TEST_CASE("a number in a lesson that is not its table's is found", "[lessons]") {
    const Project project = test::sandbox("lesson_numbers");
    test::write(project.root / "f/a.csv", "h,\"time, in s\",off\n1e2,0.0694,7e-16\n1e4,1.5,3\n");
    const auto wrong = [&](const std::string& page) {
        return wrong_numbers(page, "p.md", project.root / "f", project.root);
    };
    CHECK(
        wrong(
            "takes 69 ms<!-- = a.csv \"1e2\" \"time, in s\" * 1000 --> or 1.5 s<!-- = a.csv \"1e4\" \"time, "
            "in s\" -->") == Lines{});
    CHECK(wrong("takes 39 ms<!-- = a.csv \"1e2\" \"time, in s\" * 1000 -->") ==
          Lines{"p.md:1: 39 should be 69.4 (a.csv, 1e2)"});
    CHECK(wrong("7<!-- = a.csv \"1e3\" -->") == Lines{"p.md:1: a.csv has 0 rows '1e3'; expected one"});
    CHECK(wrong("7<!-- = a.csv \"1e2\" \"no\" -->") == Lines{"p.md:1: a.csv has no column 'no'"});
    CHECK(wrong("7<!-- = b.csv \"1e2\" -->") == Lines{"p.md:1: there is no table b.csv"});
    const std::string table =
        "<!-- table a.csv \"h\" \"time, in s\" * 1000 - \"off\" -->\n| h | ms | | off |\n|-|-|-|-|\n";
    CHECK(wrong(table + "| 10² | 69 | x | 7·10⁻¹⁶ |\n| 10⁴ | 1500 | y | **3** |\n") == Lines{});
    CHECK(wrong("<!-- table a.csv \"h\" \"off\" --> x") ==
          Lines{"p.md:1: expected a line <!-- table FILE \"column\" … --> or <!-- table by hand -->"});
    CHECK(wrong("3<!-- = a.csv \"1e4\"\n\"off\" -->") ==
          Lines{"p.md:1: expected <!-- = FILE \"row\" \"column\" --> on one line"});
    CHECK(wrong(table + "| 10² | 69 | x | 8·10⁻¹⁶ |\n") ==
          Lines{"p.md:1: 8e-16 should be 7e-16 (a.csv, 10²)"});
}

TEST_CASE("code in a lesson is written from its source, without what it is indented by", "[lessons]") {
    const Project project = test::sandbox("woven");
    test::write(project.root / "a.hpp", "struct A {\n    int b;\n\n    int c;\n};\n");
    test::write(
        project.root / "tests/02_x/mistakes/02.1_half.mistake",
        "step 02.1\nfile x.cpp\nwhy half\n--- replace\n    return 2;\n--- with\n    return 1;\n--- end\n");
    const auto woven = [&](const std::string& mark) {
        return woven_lesson("# A\n" + mark + "\n```\nold\n```\nend\n", "p.md", project.root).text;
    };
    const auto shown = [](const std::string& mark, const std::string& code) {
        return "# A\n" + mark + "\n```cpp\n" + code + "```\nend\n";
    };
    const std::string range = "<!-- code a.hpp \"int b\" to \"int c\" -->",
                      one = "<!-- code a.hpp \"int c\" -->", mistake = "<!-- mistake 02.1_half -->";
    CHECK(woven(range) == shown(range, "int b;\n\nint c;\n"));
    CHECK(woven(one) == shown(one, "int c;\n"));
    CHECK(woven(mistake) == shown(mistake, "return 1;\n"));
    test::write(project.root / "b.hpp", "struct B {\n    int c{};\n};\n");
    const std::string whole = "<!-- code b.hpp \"struct B\" to \"};\" -->";
    CHECK(woven(whole) == shown(whole, "struct B {\n    int c{};\n};\n"));
    CHECK_THROWS_WITH(woven("<!-- code a.hpp \"int d\" -->"),
                      "p.md:2: 'int d' stands on 0 lines of a.hpp; expected one");
    CHECK_THROWS_WITH(woven("<!-- code a.hpp \"int\" -->"),
                      "p.md:2: 'int' stands on 2 lines of a.hpp; expected one");
    CHECK_THROWS_WITH(woven("<!-- code c.hpp \"int\" -->"), "p.md:2: there is no c.hpp");
    CHECK_THROWS_WITH(woven("<!-- mistake 02.9_x -->"), "p.md:2: there is no mistake 02.9_x");
    CHECK_THROWS_WITH(woven_lesson("<!-- code a.hpp \"int c\" -->\ntext\n", "p.md", project.root),
                      "p.md:1: expected a block of code below the mark");
}
