// What the readers of scene and mesh files share: whole files, lines, words and numbers.
#pragma once

#include "common/math/vec.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A number as a file writes it, or what is wrong with the word.
struct ParsedNumber {
    Real value = 0;
    std::string_view problem;  ///< continues "'word' …"; empty where all is well
};

/// Whether the character separates words.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

/// The whole word as a decimal number: `1`, `+1`, `.5`, `5.`, `1e-3`, correctly rounded, in the C locale
/// whatever the program's. NaN, infinity and what a double cannot hold are problems.
ParsedNumber parse_number(std::string_view word);

/// The word in quotes, fit for one line of a terminal: control characters become `?`, and after 40 bytes
/// comes an ellipsis.
std::string quoted(std::string_view word);

/// A value as a message shows it: the shortest decimal number that reads back as the same double.
std::string shown(Real value);

/// Fills `words` with the words of a line, up to a comment; they are parts of `line`. A `#` begins a comment,
/// but not in NaN and infinity as some compilers print them (`-1.#IND`). Returns the `#` of a comment that
/// begins inside a word, else null: it deserves a warning, because `4#8` reads as 4.
const char* split_words(std::string_view line, std::vector<std::string_view>& words);

/// What that warning says.
inline constexpr std::string_view comment_inside_word =
    "a comment begins inside a word; put a blank before the '#'";

/// Takes the next line, without its end, off the front of `text`; `text` must not be empty. Lines end with
/// "\n", "\r\n" or "\r", even mixed; the last one may end with the text.
std::string_view take_line(std::string_view& text);

/// Throws InputError `name:line:column: …` for UTF-16 and for a zero byte, which no text has.
void check_is_text(std::string_view text, const std::string& name);

/// The content of a text file. Throws InputError, with `name` in front and the reason, where there is no such
/// file (with a suggestion where one of a similar name is beside it) or it is a directory, and where
/// `read_file` throws.
std::string read_text(const std::filesystem::path& path, const std::string& name);

/// A byte order mark of UTF-8 taken off the front.
std::string_view without_bom(std::string_view text);

}  // namespace rt
