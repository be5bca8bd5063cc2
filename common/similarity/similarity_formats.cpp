// The report of similar submissions, for a terminal, for spreadsheets and for programs.
#include "common/similarity/similarity_formats.hpp"

#include "common/grading/formats/parts.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_lines = 20;

std::string heading(const ChapterSimilarity& chapter) {
    std::string text = paint(chapter.chapter.substr(0, 2) + "  " + chapter.title, Tone::Bold);
    if (chapter.found.compared == 0) return text + "  nothing to compare\n";
    text += fmt::format("  {}, half of them below {:.0f} %", counted(chapter.found.compared, "pair"),
                        100 * chapter.found.median);
    if (chapter.of_variants > 0)
        text += fmt::format("; two right programs of ours: {:.0f} %", 100 * chapter.of_variants);
    return text + "\n";
}

std::string line_of(const ChapterSimilarity& chapter, const SimilarPair& pair) {
    return fmt::format("  {:3.0f} %   {:3.0f} % of {}, {:.0f} % of {}\n", 100 * pair.similarity,
                       100 * pair.part_of_first, printable(chapter.samples[pair.first].name),
                       100 * pair.part_of_second, printable(chapter.samples[pair.second].name));
}

std::string text_of(const CodePlace& place) {
    return fmt::format("{}:{}-{}", place.file, place.first_line, place.last_line);
}

ordered_json to_json(const CodePlace& place) {
    return {{"file", place.file}, {"first_line", place.first_line}, {"last_line", place.last_line}};
}

ordered_json to_json(const ChapterSimilarity& chapter, const SimilarPair& pair) {
    auto parts = ordered_json::array();
    for (const SharedPart& part : pair.parts)
        parts.push_back(
            {{"first", to_json(part.first)}, {"second", to_json(part.second)}, {"tokens", part.tokens}});
    return {{"first", chapter.samples[pair.first].name},
            {"second", chapter.samples[pair.second].name},
            {"known_answer", is_known_answer(chapter, pair)},
            {"similarity", pair.similarity},
            {"part_of_first", pair.part_of_first},
            {"part_of_second", pair.part_of_second},
            {"shared_tokens", pair.shared},
            {"parts", parts}};
}

}  // namespace

std::string similarity_text(const std::vector<ChapterSimilarity>& report) {
    std::string text;
    for (const ChapterSimilarity& chapter : report) {
        text += (text.empty() ? "" : "\n") + heading(chapter);
        const std::vector<SimilarPair>& pairs = chapter.found.pairs;
        for (std::size_t i = 0; i < std::min(pairs.size(), most_lines); ++i)
            text += line_of(chapter, pairs[i]);
        if (chapter.found.similar > most_lines)
            text += fmt::format("  … and {}\n", counted(chapter.found.similar - most_lines, "more pair"));
    }
    return text;
}

std::string similarity_csv(const std::vector<ChapterSimilarity>& report) {
    std::string text = csv_row({"chapter", "first", "second", "known answer", "similarity", "of first",
                                "of second", "shared tokens", "places"});
    for (const ChapterSimilarity& chapter : report)
        for (const SimilarPair& pair : chapter.found.pairs) {
            std::string places;
            for (const SharedPart& part : pair.parts)
                places += fmt::format("{}{} = {}", places.empty() ? "" : ", ", text_of(part.first),
                                      text_of(part.second));
            text +=
                csv_row({chapter.chapter, chapter.samples[pair.first].name, chapter.samples[pair.second].name,
                         is_known_answer(chapter, pair) ? "yes" : "no",
                         fmt::format("{:.3f}", pair.similarity), fmt::format("{:.3f}", pair.part_of_first),
                         fmt::format("{:.3f}", pair.part_of_second), std::to_string(pair.shared), places});
        }
    return text;
}

std::string similarity_json(const std::vector<ChapterSimilarity>& report) {
    auto chapters = ordered_json::array();
    for (const ChapterSimilarity& chapter : report) {
        auto pairs = ordered_json::array();
        for (const SimilarPair& pair : chapter.found.pairs) pairs.push_back(to_json(chapter, pair));
        chapters.push_back({{"id", chapter.chapter},
                            {"title", chapter.title},
                            {"compared", chapter.found.compared},
                            {"similar", chapter.found.similar},
                            {"median", chapter.found.median},
                            {"of_variants", chapter.of_variants},
                            {"pairs", pairs}});
    }
    return json_text(ordered_json{{"chapters", chapters}}, 1) + "\n";
}

}  // namespace rt
