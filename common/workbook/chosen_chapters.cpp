// Which chapters a class gets, and which are marked.
#include "common/workbook/chosen_chapters.hpp"

#include "common/math/input_error.hpp"
#include "common/terminal/pattern.hpp"

#include <fmt/format.h>

namespace rt {

std::vector<Chapter> chosen_chapters(const std::vector<Chapter>& chapters, const std::string& text) {
    if (chapters.empty()) throw InputError("there are no chapters to hand out");
    if (text.empty()) return chapters;
    const auto parts = parts_of(text, "(\\d\\d?)(-(\\d\\d?))?");
    if (!parts)
        throw InputError(
            fmt::format("--chapters: '{}' is not from one chapter to another, such as 1-5", text));
    const Chapter& first = find_chapter(chapters, parts->at(1));
    const Chapter& last = find_chapter(chapters, parts->at(3).empty() ? parts->at(1) : parts->at(3));
    if (first.number != chapters.front().number || last.number < first.number)
        throw InputError(
            fmt::format("--chapters: '{}' must begin with {}, because each chapter stands on those "
                        "before it; such as 1-5",
                        text, chapters.front().number));
    std::vector<Chapter> chosen;
    for (const Chapter& chapter : chapters)
        if (chapter.number <= last.number) chosen.push_back(chapter);
    return chosen;
}

std::vector<const Chapter*> named_chapters(const std::vector<Chapter>& chapters,
                                           const std::vector<std::string>& numbers) {
    std::vector<const Chapter*> named;
    if (numbers.empty())
        for (const Chapter& chapter : chapters) named.push_back(&chapter);
    for (const std::string& number : numbers) named.push_back(&find_chapter(chapters, number));
    return named;
}

}  // namespace rt
