// Copies are similar whatever was done to them; right code by somebody else is clearly less so.
#include "common/similarity/similarity_formats.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/variants.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <set>

using namespace rt;

namespace {

// ------------------------------------------------------------------------- what is done to copies

/// All names are others, and behind each line stands a comment.
std::string renamed(const std::string& text) {
    const std::set<std::string> kept{"if",          "else",     "for",    "while",    "return", "const",
                                     "namespace",   "auto",     "struct", "switch",   "case",   "template",
                                     "static_cast", "include",  "break",  "continue", "true",   "false",
                                     "double",      "int",      "bool",   "default",  "using",  "operator",
                                     "constexpr",   "requires", "class",  "void",     "static", "inline"};
    std::string other;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
            ++end;
        const std::string word = text.substr(i, end - i);
        if (word.empty())
            other += text[i] == '\n' ? std::string("  // mine\n") : std::string(1, text[i]);
        else
            other +=
                word + (kept.contains(word) || std::isdigit(static_cast<unsigned char>(word[0])) ? "" : "_2");
        i = std::max(end, i + 1);
    }
    return other;
}

/// The last function is the first.
std::string reordered(const std::string& text) {
    const std::string open = "namespace rt {\n", close = "}  // namespace rt";
    const std::size_t begin = text.find(open) + open.size(), end = text.rfind(close);
    std::string functions;
    for (std::size_t at = begin; at < end;) {
        const std::size_t next = std::min(text.find("\n}\n", at), end - 3) + 3;
        functions.insert(0, text.substr(at, next - at));
        at = next;
    }
    return text.substr(0, begin) + functions + text.substr(end);
}

/// A line more after every fifth statement.
std::string with_more_lines(const std::string& text) {
    std::string longer;
    int count = 0;
    for (const std::string& line : split_lines(text)) {
        longer += line + "\n";
        if (line.starts_with("    ") && line.ends_with(";") && ++count % 5 == 0)
            longer += "    int not_needed = 0;\n";
    }
    return longer;
}

// ---------------------------------------------------------------------------------- a small class

using Change = std::string (*)(const std::string& solution);

Submission submission(std::string name, const Chapter& chapter, Change change) {
    Submission made{std::move(name), {}, {}};
    for (const auto& [file, text] : solution_files(this_project(), chapter))
        made.files[exercise_path(chapter, file)] = change(text);
    return made;
}

std::string as_copied(const std::string& text) { return solution_text(text, "copied"); }
std::string as_renamed(const std::string& text) { return renamed(reordered(as_copied(text))); }
std::string as_edited(const std::string& text) {
    return renamed(reordered(with_more_lines(as_copied(text))));
}
std::string as_handed_out(const std::string& text) { return exercise_text(text, "handed out"); }

std::vector<ChapterSimilarity> report_of_copies(const SimilarityOptions& options) {
    std::vector<ChapterSimilarity> report;
    for (const Chapter& chapter : read_catalogue(this_project())) {
        const std::vector<Submission> all{submission("renamed", chapter, as_renamed),
                                          submission("edited", chapter, as_edited),
                                          submission("not begun", chapter, as_handed_out)};
        report.push_back(similarity_report(this_project(), {&chapter}, all, options).front());
    }
    return report;
}

const SimilarPair& pair_of(const ChapterSimilarity& chapter, const std::string& first,
                           const std::string& second) {
    const auto found = std::find_if(chapter.found.pairs.begin(), chapter.found.pairs.end(), [&](auto& pair) {
        return chapter.samples[pair.first].name == first && chapter.samples[pair.second].name == second;
    });
    REQUIRE(found != chapter.found.pairs.end());
    return *found;
}

Similarities compared(const std::vector<std::string>& texts, const std::string& given = "",
                      std::size_t known = 0) {
    std::vector<CodeSample> samples;
    for (const std::string& text : texts) samples.push_back({"", {{"x.cpp", text}}});
    return similarities(samples, {{"x.cpp", given}}, known, {});
}

const std::string loop =
    "int f(int n) {\n    int sum = 0;\n    for (int i = 0; i < n; ++i)\n        if (i % 3 == 1) sum += i * "
    "i;\n"
    "    return sum;\n}\n";
const std::string look_up =
    "bool g(Node* n, int key) {\n    while (n) {\n        if (n->key == key) return true;\n"
    "        n = key < n->key ? n->left : n->right;\n    }\n    return false;\n}\n";

}  // namespace

TEST_CASE("copies are similar whatever was done to them, right code by others is less", "[similarity]") {
    const std::vector<ChapterSimilarity> report = report_of_copies({});
    CHECK(report.size() >= 9);
    for (const ChapterSimilarity& chapter : report) {
        INFO(chapter.chapter);
        // Solutions change, so less is asked than was measured.
        CHECK(pair_of(chapter, "renamed", "our solution").similarity >= 0.96);
        CHECK(pair_of(chapter, "edited", "our solution").similarity >= 0.84);
        CHECK(pair_of(chapter, "renamed", "edited").similarity >= 0.84);
        CHECK(chapter.of_variants > 0);
        CHECK(chapter.of_variants <= 0.79);
        CHECK(chapter.known >= 3);
        // What was only handed out is nobody's own.
        CHECK(chapter.found.tokens[2] == 0);
        CHECK(std::none_of(chapter.found.pairs.begin(), chapter.found.pairs.end(),
                           [](const SimilarPair& pair) { return pair.first == 2 || pair.second == 2; }));
    }
}

TEST_CASE("the places of what is shared are named", "[similarity]") {
    const Similarities found = compared({loop + look_up, "\n\n" + look_up + loop});
    REQUIRE(found.pairs.size() == 1);
    const SimilarPair& pair = found.pairs.front();
    CHECK(pair.similarity == 1);
    CHECK(pair.shared == found.tokens[0]);
    REQUIRE(pair.parts.size() == 2);
    CHECK(pair.parts[0].first.first_line == 7);  // to the last token: braces are none
    CHECK(pair.parts[0].first.last_line == 12);
    CHECK(pair.parts[0].second.first_line == 3);
    CHECK(pair.parts[0].second.last_line == 8);
    CHECK(pair.parts[1].first.file == "x.cpp");
    CHECK(pair.parts[1].first.first_line == 1);
}

TEST_CASE("who took a part is told from who has it among more", "[similarity]") {
    const Similarities found = compared({loop, look_up + loop + look_up});
    REQUIRE(found.pairs.size() == 1);
    CHECK(found.pairs[0].part_of_first == 1);
    CHECK(found.pairs[0].part_of_second < 0.5);
    CHECK(found.pairs[0].shared == found.tokens[0]);  // nothing twice
}

TEST_CASE("what was handed out is not compared, nor is the little between it", "[similarity]") {
    const std::string given = look_up + "int h(int a, int b, const Vec3& c) {\n    return todo(1);\n}\n";
    const std::string mine = look_up + "int h(int a, int b, const Vec3& c) {\n    return a + b;\n}\n";
    const Similarities found = compared({mine, mine, given, mine + loop}, given);
    CHECK(found.tokens[0] == 0);
    CHECK(found.tokens[2] == 0);
    CHECK(found.tokens[3] >= 20);
    CHECK(found.compared == 0);
}

TEST_CASE("known answers are not compared with one another", "[similarity]") {
    const Similarities found = compared({loop, look_up, loop, look_up}, "", 2);
    CHECK(found.compared == 5);
    CHECK(found.pairs.front().similarity == 1);
    CHECK(found.pairs.back().similarity == 0);
    CHECK(compared({}).compared == 0);
    CHECK(compared({loop}, "", 1).compared == 0);
}

TEST_CASE("a megabyte of the same ends soon", "[similarity]") {
    std::string long_text;
    while (long_text.size() < largest_submitted_file) long_text += "x = x + x * (x - 1);\n";
    CHECK(compared({long_text, long_text}).pairs.front().similarity == 1);
}

TEST_CASE("the report says all in each of its forms", "[similarity]") {
    const Chapter chapter = read_catalogue(this_project())[1];
    Submission evil = submission("=<b>&\xff", chapter, as_renamed);
    SimilarityOptions options;
    options.least_similarity = 0.7;
    const auto report = similarity_report(this_project(), {&chapter},
                                          {evil, submission("edited", chapter, as_edited)}, options);

    const nlohmann::json json = nlohmann::json::parse(similarity_json(report));
    const nlohmann::json& pairs = json["chapters"][0]["pairs"];
    REQUIRE(pairs.size() == 3);
    CHECK(pairs[0]["second"] == "our solution");
    CHECK(pairs[0]["known_answer"] == true);
    CHECK(pairs[0]["first"] == "=<b>&\\xff");
    CHECK(pairs[0]["similarity"].get<double>() >= pairs[1]["similarity"].get<double>());

    const std::string csv = similarity_csv(report);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
    CHECK(csv.find("\r\n02_spheres,'=<b>&\\xff,our solution,yes,0.9") != std::string::npos);
    CHECK(csv.find("sphere.cpp:") != std::string::npos);

    const std::string text = similarity_text(report);
    CHECK(text.find(" % of =<b>&\\xff, ") != std::string::npos);
    CHECK(text.find("two right programs of ours: ") != std::string::npos);

    const std::string page = similarity_page(report);
    CHECK(page.find("<b>&\xff") == std::string::npos);
    CHECK(page.find("=&lt;b&gt;&amp;") != std::string::npos);
    CHECK(page.find("known answer") != std::string::npos);
    for (int i = 1; i <= 3; ++i) {
        CHECK(page.find(fmt::format("href=\"#pair-02-{}\"", i)) != std::string::npos);
        CHECK(page.find(fmt::format("id=\"pair-02-{}\"", i)) != std::string::npos);
    }
}

// By hand, `test_grading "[measure]"`: what the constants of SimilarityOptions were chosen by.
TEST_CASE("how similar copies and right variants are, by the length of what counts", "[.][measure]") {
    for (const std::size_t least : {12U, 16U, 20U, 24U, 32U})
        for (const ChapterSimilarity& chapter : report_of_copies({.gram = 8, .least_tokens = least}))
            std::cout << fmt::format(
                "{:2} tokens  {:16}  renamed {:.3f}  edited {:.3f}  variants {:.3f}\n", least,
                chapter.chapter, pair_of(chapter, "renamed", "our solution").similarity,
                pair_of(chapter, "edited", "our solution").similarity, chapter.of_variants);
}
