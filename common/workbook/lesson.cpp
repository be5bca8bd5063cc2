// Lessons show code of the course; the program writes it there from its one source.
#include "common/workbook/lesson.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/mistake.hpp"

#include <algorithm>
#include <optional>
#include <regex>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// What a mark asks for, and where the mark stands.
struct Quotation {
    std::string place;       ///< of the lesson
    int line = 0;            ///< of the mark in it
    std::string kind, from;  ///< "code" and a file, or "mistake" and its name
    std::string first, last;
};

[[noreturn]] void fail(const Quotation& mark, const std::string& what) {
    fail_at(mark.place, mark.line, what);
}

/// The mark on this line, if it is one.
std::optional<Quotation> mark_on(const std::string& line, const std::string& place, int number) {
    static const std::regex begin("<!-- (code|mistake)\\b.*");
    static const std::regex form("<!-- (code|mistake) (\\S+)(?: \"([^\"]+)\"(?: to \"([^\"]+)\")?)? -->\\s*");
    if (!std::regex_match(line, begin)) return std::nullopt;
    std::smatch part;
    Quotation mark{place, number, "", "", "", ""};
    if (!std::regex_match(line, part, form))
        fail(mark, "expected <!-- code FILE \"text\" to \"text\" --> or <!-- mistake NN.S_name -->");
    mark.kind = part[1];
    mark.from = part[2];
    mark.first = part[3];
    mark.last = part[4];
    if (mark.kind == "code" && mark.first.empty()) fail(mark, "expected a text in quotes after the file");
    return mark;
}

fs::path file_of(const Quotation& mark, const fs::path& root) {
    if (mark.kind == "code") {
        if (!fs::exists(root / mark.from)) fail(mark, "there is no " + mark.from);
        return root / mark.from;
    }
    if (fs::is_directory(root / "tests"))
        for (const auto& room : fs::directory_iterator(root / "tests")) {
            const fs::path file = room.path() / "mistakes" / (mark.from + ".mistake");
            if (fs::exists(file)) return file;
        }
    fail(mark, "there is no mistake " + mark.from);
}

/// The lines of the file among which the piece is looked for.
std::vector<std::string> lines_of(const Quotation& mark, const fs::path& file) {
    const std::string text = read_file(file);
    if (mark.kind == "code") return split_lines(text);
    std::vector<std::string> wrong;
    for (const Replacement& replacement : parse_mistake(text, file.filename().string()).replacements)
        for (const std::string& line : split_lines(replacement.to)) wrong.push_back(line);
    return wrong;
}

/// From the line with the first text to the next one with the last.
std::vector<std::string> piece(const Quotation& mark, const std::vector<std::string>& lines) {
    if (mark.first.empty()) return lines;
    const auto has = [](const std::string& text) {
        return [text](const std::string& line) { return line.find(text) != std::string::npos; };
    };
    const auto count = std::count_if(lines.begin(), lines.end(), has(mark.first));
    if (count != 1)
        fail(mark, "'" + mark.first + "' stands on " + std::to_string(count) + " lines of " + mark.from +
                       "; expected one");
    const auto from = std::find_if(lines.begin(), lines.end(), has(mark.first));
    if (mark.last.empty()) return {*from};
    const auto to = std::find_if(from + 1, lines.end(), has(mark.last));
    if (to == lines.end())
        fail(mark, "no line after '" + mark.first + "' has '" + mark.last + "' in " + mark.from);
    return {from, to + 1};
}

std::string without_indentation(const std::vector<std::string>& lines) {
    std::size_t indentation = std::string::npos;
    for (const std::string& line : lines) indentation = std::min(indentation, line.find_first_not_of(' '));
    std::string text;
    for (const std::string& line : lines)
        text += (line.size() > indentation ? line.substr(indentation) : "") + "\n";
    return text;
}

/// What the block's opening line says of its language.
std::string fence_of(const fs::path& file) {
    const std::string kind = file.extension().string();
    return kind == ".hpp" || kind == ".cpp" || kind == ".mistake" ? "```cpp" : "```";
}

}  // namespace

std::vector<fs::path> pages_of(const fs::path& chapter) {
    std::vector<fs::path> pages;
    if (fs::is_directory(chapter))
        for (const auto& entry : fs::directory_iterator(chapter))
            if (entry.path().extension() == ".md") pages.push_back(entry.path());
    const auto is_later = [](const fs::path& page) { return page.filename() != "README.md"; };
    std::ranges::sort(pages, {}, [&](const fs::path& page) { return std::pair(is_later(page), page); });
    return pages;
}

WovenLesson woven_lesson(const std::string& text, const std::string& name, const fs::path& root) {
    WovenLesson lesson;
    const std::vector<std::string> lines = split_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lesson.text += lines[i] + "\n";
        const auto mark = mark_on(lines[i], name, static_cast<int>(i) + 1);
        if (!mark) continue;
        const fs::path file = file_of(*mark, root);
        if (std::ranges::find(lesson.sources, file) == lesson.sources.end()) lesson.sources.push_back(file);
        const std::string code = without_indentation(piece(*mark, lines_of(*mark, file)));
        if (i + 1 == lines.size() || !lines[i + 1].starts_with("```"))
            fail(*mark, "expected a block of code below the mark");
        const auto end = std::find(lines.begin() + static_cast<std::ptrdiff_t>(i) + 2, lines.end(), "```");
        if (end == lines.end()) fail(*mark, "the block of code below the mark has no end");
        lesson.text += fence_of(file) + "\n" + code + "```\n";
        i = static_cast<std::size_t>(end - lines.begin());
    }
    return lesson;
}

}  // namespace rt
