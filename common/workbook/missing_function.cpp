// A function that a chapter's contract declares and the student's files do not have: what a linker says of
// it, in words.
#include "common/workbook/missing_function.hpp"
#include "common/workbook/functions.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace rt {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The words of a text: "rt::Sphere const&" has rt, Sphere and const.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    bool inside = false;
    for (const char c : text) {
        if (is_word(c) && !inside) words.emplace_back();
        inside = is_word(c);
        if (inside) words.back() += c;
    }
    return words;
}

/// "intersect" of "rt::intersect(rt::Sphere const&)".
std::string name_of(std::string_view linker_name) {
    const std::vector<std::string> words = words_of(linker_name.substr(0, linker_name.find('(')));
    return words.empty() ? "" : words.back();
}

/// The course's own types among a function's parameters, in order; the linker writes rt:: before each.
std::vector<std::string> own_types(std::string_view linker_name) {
    const std::vector<std::string> words =
        words_of(linker_name.substr(std::min(linker_name.find('('), linker_name.size())));
    std::vector<std::string> types;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i - 1] == "rt") types.push_back(words[i]);
    return types;
}

/// Whether these words stand in the text, in this order.
bool has_in_order(std::string_view text, const std::vector<std::string>& wanted) {
    std::size_t found = 0;
    for (const std::string& word : words_of(text))
        if (found < wanted.size() && word == wanted[found]) ++found;
    return found == wanted.size();
}

/// "02.3" of the last "[02.3]" in a comment.
std::string step_in(std::string_view comment) {
    const auto end = comment.rfind(']');
    const auto begin = end == std::string_view::npos ? end : comment.rfind('[', end);
    if (begin == std::string_view::npos) return "";
    const std::string_view id = comment.substr(begin + 1, end - begin - 1);
    const bool is_step =
        id.size() >= 4 && id[2] == '.' && std::isdigit(static_cast<unsigned char>(id[0])) != 0;
    return is_step ? std::string(id) : "";
}

/// Where a line begins that declares a function of this name, from `from` on; npos if none does.
std::size_t find_declaration(std::string_view text, const std::string& name, std::size_t from) {
    for (auto at = text.find(name + "(", from); at != std::string_view::npos;
         at = text.find(name + "(", at + 1)) {
        const std::size_t begin = text.rfind('\n', at) + 1;
        const bool whole_word = at > 0 && !is_word(text[at - 1]);
        if (whole_word && begin < at && is_word(text[begin]) && text.substr(begin, 7) != "return ")
            return begin;
    }
    return std::string_view::npos;
}

/// The comment of lines with /// that ends before `begin`.
std::string_view comment_before(std::string_view text, std::size_t begin) {
    std::size_t top = begin;
    while (top > 1) {
        const std::size_t above = text.rfind('\n', top - 2) + 1;
        if (!text.substr(above).starts_with("///")) break;
        top = above;
    }
    return text.substr(top, begin - top);
}

std::optional<Declared> declared_in(std::string_view header, std::string_view linker_name) {
    const std::string name = name_of(linker_name);
    if (name.empty()) return std::nullopt;
    const std::vector<std::string> types = own_types(linker_name);
    for (std::size_t at = find_declaration(header, name, 0); at != std::string_view::npos;
         at = find_declaration(header, name, header.find('\n', at))) {
        const std::string_view text = header.substr(at, header.find(';', at) - at);
        const std::size_t open = std::min(text.find('('), text.size());
        if (has_in_order(text.substr(open), types))
            return Declared{nullptr, step_in(comment_before(header, at)), in_one_line(text)};
    }
    return std::nullopt;
}

/// The name in "undefined reference to `rt::next(int)'", or in "undefined symbol: rt::next(int)".
std::string_view linker_name_in(std::string_view line) {
    constexpr std::string_view gnu = "undefined reference to ", lld = "undefined symbol: ";
    if (const auto at = line.find(gnu); at != std::string_view::npos) {
        std::string_view name = line.substr(at + gnu.size());
        name.remove_prefix(std::min<std::size_t>(name.find_first_not_of("`'\""), name.size()));
        return name.substr(0, name.find_last_not_of("`'\"") + 1);
    }
    const auto at = line.find(lld);
    return at == std::string_view::npos ? std::string_view() : line.substr(at + lld.size());
}

}  // namespace

std::optional<Declared> declared_function(const Project& project, const std::vector<Chapter>& chapters,
                                          std::string_view linker_name) {
    for (const Chapter& chapter : chapters)
        for (const auto& header : files_in(project.root / "chapters" / chapter.name, {".hpp"}))
            if (auto declared = declared_in(read_file(header), linker_name)) {
                declared->chapter = &chapter;
                return declared;
            }
    return std::nullopt;
}

std::string missing_in_words(const Project& project, const std::vector<Chapter>& chapters,
                             std::string_view line) {
    const std::string_view name = linker_name_in(line);
    if (name.empty()) return "";
    const auto declared = declared_function(project, chapters, name);
    if (!declared) return fmt::format("the function {} is called, and nowhere written", printable(name));
    const auto step = std::ranges::find(declared->chapter->steps, declared->step, &Step::id);
    if (step == declared->chapter->steps.end())
        return fmt::format(
            "chapters/{0} has no function {1} any more; ./course reset {2} brings the chapter back",
            declared->chapter->name, declared->text, declared->chapter->number);
    return fmt::format(
        "chapters/{}/{} has no function {} of step {}; if it was deleted, ./course reset {} puts it back, "
        "and changes "
        "nothing else",
        declared->chapter->name, step->file, declared->text, step->id, step->id);
}

}  // namespace rt
