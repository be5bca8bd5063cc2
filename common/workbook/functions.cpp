// Functions in a source file, found without compiling it: enough for files of free functions.
#include "common/workbook/functions.hpp"

#include <algorithm>
#include <cctype>

namespace rt {

namespace {

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::size_t line_start(std::string_view text, std::size_t at) {
    const auto end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    return end == std::string_view::npos ? 0 : end + 1;
}

/// After the end of the line that `at` is on.
std::size_t line_end(std::string_view text, std::size_t at) {
    const auto end = text.find('\n', at);
    return end == std::string_view::npos ? text.size() : end + 1;
}

/// After the comment, string or character literal that begins at `at`; `at` itself if none does.
std::size_t skip_literal(std::string_view text, std::size_t at) {
    const auto after = [&](std::string_view end) {
        const auto found = text.find(end, at + 2);
        return found == std::string_view::npos ? text.size() : found + end.size();
    };
    if (text.substr(at, 2) == "//") return after("\n");
    if (text.substr(at, 2) == "/*") return after("*/");
    const char quote = text[at];
    // A quote after a letter or digit separates digits, as in 1'000.
    const bool separator = quote == '\'' && at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1]));
    if ((quote != '"' && quote != '\'') || separator) return at;
    for (std::size_t i = at + 1; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;
        } else if (text[i] == quote) {
            return i + 1;
        }
    }
    return text.size();
}

/// After the brace that closes the one at `open`; npos if none does.
std::size_t matching_brace(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size();) {
        const std::size_t after = skip_literal(text, i);
        if (after > i) {
            i = after;
            continue;
        }
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i + 1;
        ++i;
    }
    return std::string_view::npos;
}

/// Whether a signature may begin with this line: it is not indented, no comment, and no brace or directive.
bool begins_definition(std::string_view line) {
    return !line.empty() && !is_blank(line[0]) && line[0] != '}' && line[0] != '#' &&
           !line.starts_with("//") && !line.starts_with("namespace");
}

/// Where `part` begins and ends in `text`, blanks aside.
std::optional<std::pair<std::size_t, std::size_t>> find_loosely(std::string_view text,
                                                                std::string_view part) {
    std::string squeezed, wanted;
    std::vector<std::size_t> place;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_blank(text[i])) continue;
        squeezed += text[i];
        place.push_back(i);
    }
    std::copy_if(part.begin(), part.end(), std::back_inserter(wanted), [](char c) { return !is_blank(c); });
    const auto found = squeezed.find(wanted);
    if (wanted.empty() || found == std::string::npos) return std::nullopt;
    return std::pair{place[found], place[found + wanted.size() - 1] + 1};
}

/// All that end with a brace at the beginning of a line.
std::vector<FunctionText> all_functions(std::string_view text) { return functions_with(text, "\n}\n"); }

/// "intersect" of "std::optional<Hit> intersect(const Sphere& sphere)".
std::string_view name_in(std::string_view signature) {
    const std::string_view head = signature.substr(0, signature.find('('));
    const auto last = head.find_last_of(" *&:");
    return last == std::string_view::npos ? head : head.substr(last + 1);
}

}  // namespace

int line_at(std::string_view text, std::size_t at) {
    return 1 +
           static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string in_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\n' || c == '\t';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (line.ends_with(' ')) line.pop_back();
    return line;
}

std::vector<FunctionText> functions_with(std::string_view text, std::string_view part) {
    std::vector<FunctionText> functions;
    for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) {
        if (!functions.empty() && at < functions.back().end) continue;
        std::size_t begin = line_start(text, at);
        while (begin > 0 && !begins_definition(text.substr(begin, line_end(text, begin) - begin)))
            begin = line_start(text, begin - 1);
        const auto open = text.find("{\n", begin);
        const auto close = open < at ? matching_brace(text, open) : std::string_view::npos;
        if (close == std::string_view::npos) continue;
        std::string signature(text.substr(begin, open - begin));
        while (!signature.empty() && is_blank(signature.back())) signature.pop_back();
        functions.push_back({begin, line_end(text, close), line_at(text, begin), signature});
    }
    return functions;
}

std::optional<FunctionText> find_function(std::string_view text, std::string_view signature) {
    const auto place = find_loosely(text, std::string(signature) + "{");
    if (!place) return std::nullopt;
    const auto close = matching_brace(text, place->second - 1);
    if (close == std::string_view::npos) return std::nullopt;
    return FunctionText{place->first, line_end(text, close), line_at(text, place->first),
                        std::string(signature)};
}

std::optional<std::string> with_function(std::string_view text, std::string_view original,
                                         const FunctionText& function) {
    const std::vector<FunctionText> theirs = all_functions(original);
    for (const FunctionText& mine : all_functions(text))
        if (name_in(mine.signature) == name_in(function.signature) &&
            !find_function(original, mine.signature))
            return std::nullopt;

    const std::string lines(original.substr(function.begin, function.end - function.begin));
    const auto inserted = [&](std::size_t at, const std::string& what) {
        return std::string(text.substr(0, at)) + what + std::string(text.substr(at));
    };
    std::optional<FunctionText> before;
    for (const FunctionText& other : theirs) {
        const auto found = find_function(text, other.signature);
        if (found && other.begin < function.begin) before = found;
        if (found && other.begin > function.begin && !before) return inserted(found->begin, lines + "\n");
    }
    if (before) return inserted(before->end, "\n" + lines);
    const auto end = text.rfind("\n}  // namespace rt");
    return end == std::string_view::npos ? std::nullopt : std::optional(inserted(end + 1, lines + "\n"));
}

}  // namespace rt
