// Changes to the solution: known mistakes, which the tests must catch, and right variants, which they must
// accept.
#include "common/workbook/mistake.hpp"

#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"

#include <algorithm>

namespace rt {

namespace {

int occurrences(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// The rest of a line `key value`, without the blanks between; nothing if it has another key.
bool read_key(const std::string& line, std::string_view key, std::string& value) {
    if (!line.starts_with(key)) return false;
    const auto start = line.find_first_not_of(" \t", key.size());
    if (start == key.size() || start == std::string::npos) return false;
    value = line.substr(start);
    return true;
}

}  // namespace

Mistake parse_mistake(std::string_view text, const std::string& name) {
    enum class Part { Head, From, To };
    Mistake mistake;
    Part part = Part::Head;
    const std::vector<std::string> lines = split_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        const int number = static_cast<int>(i) + 1;
        if (line == "--- replace") {
            if (part == Part::From) fail_at(name, number, "the group before has no '--- with'");
            mistake.replacements.push_back({"", "", number});
            part = Part::From;
        } else if (line == "--- with") {
            if (part != Part::From) fail_at(name, number, "'--- with' without a '--- replace' before it");
            part = Part::To;
        } else if (line == "--- end") {
            if (part != Part::To) fail_at(name, number, "'--- end' without a '--- with' before it");
            part = Part::Head;
        } else if (part == Part::From) {
            mistake.replacements.back().from += line + "\n";
        } else if (part == Part::To) {
            mistake.replacements.back().to += line + "\n";
        } else if (!line.empty() && !read_key(line, "step", mistake.step) &&
                   !read_key(line, "file", mistake.file) && !read_key(line, "why", mistake.why) &&
                   !read_key(line, "shows", mistake.shows)) {
            fail_at(name, number,
                    "expected 'step', 'file', 'why', 'shows' or '--- replace', not '" + line + "'");
        }
    }
    const int last = static_cast<int>(std::max<std::size_t>(lines.size(), 1));
    if (part != Part::Head) fail_at(name, last, "the last group is not closed; expected '--- end'");
    if (!is_step_id(mistake.step)) fail_at(name, 1, "expected a line 'step NN.S', such as 'step 02.1'");
    if (mistake.file.empty()) fail_at(name, 1, "expected a line 'file x.cpp'");
    if (mistake.why.empty()) fail_at(name, 1, "expected a line 'why …'");
    if (mistake.replacements.empty())
        fail_at(name, last, "expected a group '--- replace', '--- with', '--- end'");
    for (const Replacement& replacement : mistake.replacements)
        if (replacement.from.empty()) fail_at(name, replacement.line, "nothing to replace");
    return mistake;
}

std::string apply_mistake(const Mistake& mistake, const std::string& solution, const std::string& name) {
    std::string text = solution;
    for (const Replacement& replacement : mistake.replacements) {
        const int count = occurrences(text, replacement.from);
        if (count != 1) {
            const std::string found =
                count == 0 ? "does not stand" : "stands " + std::to_string(count) + " times";
            fail_at(name, replacement.line,
                    "the text to replace " + found + " in " + mistake.file + "; expected once");
        }
        text.replace(text.find(replacement.from), replacement.from.size(), replacement.to);
    }
    return text;
}

}  // namespace rt
