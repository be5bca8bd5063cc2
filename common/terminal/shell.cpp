// Words for a shell.
#include "common/terminal/shell.hpp"

#include <algorithm>

namespace rt {

namespace {

/// Whether the byte means nothing to a shell wherever it stands in a word.
bool is_plain(char c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return letter || std::string_view("_-./:@%+,").find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_word(std::string_view text) {
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
    std::string word = "'";
    for (const char c : text) {
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    }
    return word + "'";
}

std::string shell_words(const std::vector<std::string>& texts, std::string_view between) {
    std::string words;
    for (const std::string& text : texts) {
        if (!words.empty()) words += between;
        words += shell_word(text);
    }
    return words;
}

}  // namespace rt
