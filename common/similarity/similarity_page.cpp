// The report of similar submissions as a page: what the template pages/similarity.mustache shows.
#include "common/math/counted.hpp"
#include "common/similarity/similarity_formats.hpp"
#include "common/terminal/page.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {
namespace {

/// Of a chapter, those whose code is on the page; the other formats have all.
constexpr std::size_t most_pairs_shown = 50;

std::string percent(double share) { return fmt::format("{:.0f}", 100 * share); }

/// The lines of a place, with their numbers.
PageView code(const CodeSample& sample, const CodePlace& place) {
    const std::vector<std::string> lines = split_lines(sample.files.at(place.file));
    std::string text;
    for (int number = place.first_line; number <= place.last_line; ++number)
        text += fmt::format("{:4}  {}\n", number, lines[static_cast<std::size_t>(number - 1)]);
    return {{"place", fmt::format("{}:{}", place.file, place.first_line)}, {"text", text}};
}

PageView pair_view(const ChapterSimilarity& chapter, const SimilarPair& pair, const std::string& id) {
    const CodeSample& first = chapter.samples[pair.first];
    const CodeSample& second = chapter.samples[pair.second];
    PageView parts = PageView::array();
    for (const SharedPart& part : pair.parts)
        parts.push_back({{"tokens", std::to_string(part.tokens)},
                         {"sides", {code(first, part.first), code(second, part.second)}}});
    return {{"id", id},
            {"first", first.name},
            {"second", second.name},
            {"known", is_known_answer(chapter, pair)},
            {"of_both", percent(pair.similarity)},
            {"of_first", percent(pair.part_of_first)},
            {"of_second", percent(pair.part_of_second)},
            {"shared", std::to_string(pair.shared)},
            {"parts", parts}};
}

PageView chapter_view(const ChapterSimilarity& chapter) {
    const std::string number = chapter.chapter.substr(0, 2);
    const std::vector<SimilarPair>& found = chapter.found.pairs;
    PageView pairs = PageView::array();
    for (std::size_t i = 0; i < std::min(found.size(), most_pairs_shown); ++i)
        pairs.push_back(pair_view(chapter, found[i], fmt::format("pair-{}-{}", number, i + 1)));
    const std::size_t more = chapter.found.similar - pairs.size();
    return {{"number", number},
            {"title", chapter.title},
            {"compared", counted(chapter.found.compared, "pair")},
            {"median", percent(chapter.found.median)},
            {"of_variants", chapter.of_variants > 0 ? percent(chapter.of_variants) : ""},
            {"more", more > 0 ? counted(more, "more pair") : ""},
            {"any", !pairs.empty()},
            {"pairs", pairs}};
}

}  // namespace

std::string similarity_page(const std::vector<ChapterSimilarity>& report) {
    PageView chapters = PageView::array();
    for (const ChapterSimilarity& chapter : report) chapters.push_back(chapter_view(chapter));
    return page_from("common/similarity/pages/similarity.mustache",
                     {{"title", "Similar submissions"},
                      {"policy", "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"},
                      {"chapters", chapters}});
}

}  // namespace rt
