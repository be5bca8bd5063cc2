// What remains of C++ when names, values and layout are forgotten.
#include "common/similarity/tokens.hpp"

#include "common/workbook/lexemes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace rt {
namespace {

constexpr std::uint16_t a_name = 1, a_literal = 2, first_keyword = 3, first_operator = 100;

/// Keywords that are of a kind of their own; types that are built in are not among them.
constexpr std::array<std::string_view, 38> keywords{
    "alignof",    "break",     "case",     "catch",       "class",
    "const_cast", "continue",  "co_await", "co_return",   "co_yield",
    "decltype",   "default",   "delete",   "do",          "dynamic_cast",
    "else",       "enum",      "for",      "friend",      "goto",
    "if",         "namespace", "new",      "operator",    "reinterpret_cast",
    "requires",   "return",    "sizeof",   "static_cast", "struct",
    "switch",     "template",  "this",     "throw",       "try",
    "typeid",     "using",     "while"};
constexpr std::array<std::string_view, 3> literal_words{"true", "false", "nullptr"};
constexpr std::array<std::string_view, 14> dropped_words{
    "const",  "consteval", "constexpr", "constinit", "explicit", "extern", "final",
    "inline", "mutable",   "noexcept",  "override",  "register", "static", "volatile"};

constexpr std::array<std::string_view, 49> operators{
    "<<=", ">>=", "<=>", "...", "->*", "->", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "+=",
    "-=",  "*=",  "/=",  "%=",  "&=",  "|=", "^=", "::", ".*", "##", "+",  "-",  "*",  "/",  "%",  "&",  "|",
    "^",   "~",   "!",   "=",   "<",   ">",  "?",  ":",  ";",  ",",  ".",  "(",  ")",  "[",  "]"};

struct OtherSpelling {
    std::string_view word, meaning;
};
constexpr std::array<OtherSpelling, 11> other_spellings{{{"and", "&&"},
                                                         {"and_eq", "&="},
                                                         {"bitand", "&"},
                                                         {"bitor", "|"},
                                                         {"compl", "~"},
                                                         {"not", "!"},
                                                         {"not_eq", "!="},
                                                         {"or", "||"},
                                                         {"or_eq", "|="},
                                                         {"xor", "^"},
                                                         {"xor_eq", "^="}}};

template <std::size_t N>
std::optional<std::size_t> index_in(const std::array<std::string_view, N>& words, std::string_view word) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) return {};
    return static_cast<std::size_t>(found - words.begin());
}

std::uint16_t kind_of_operator(std::size_t index) {
    return static_cast<std::uint16_t>(first_operator + index);
}

/// The kind of a word; 0 if it is dropped.
std::uint16_t kind_of_word(std::string_view word) {
    if (index_in(dropped_words, word)) return 0;
    if (const auto keyword = index_in(keywords, word))
        return static_cast<std::uint16_t>(first_keyword + *keyword);
    if (index_in(literal_words, word)) return a_literal;
    for (const OtherSpelling& other : other_spellings)
        if (other.word == word) return kind_of_operator(*index_in(operators, other.meaning));
    return a_name;
}

/// The kind of a sign; 0 for braces, and for what is no C++.
std::uint16_t kind_of_sign(std::string_view sign) {
    const auto found = index_in(operators, sign);
    return found ? kind_of_operator(*found) : std::uint16_t{0};
}

}  // namespace

std::vector<Token> tokens_of(std::string_view source) {
    std::vector<Token> tokens;
    for (const Lexeme& lexeme : lexemes_of(source)) {
        // What stands in front of `::` says only where the name behind it is found.
        if (lexeme.is("::")) {
            if (!tokens.empty() && tokens.back().kind == a_name) tokens.pop_back();
            continue;
        }
        const std::uint16_t kind = lexeme.kind == Lexeme::Kind::Word   ? kind_of_word(lexeme.text)
                                   : lexeme.kind == Lexeme::Kind::Sign ? kind_of_sign(lexeme.text)
                                                                       : a_literal;
        if (kind != 0) tokens.push_back({kind, lexeme.line});
    }
    return tokens;
}

}  // namespace rt
