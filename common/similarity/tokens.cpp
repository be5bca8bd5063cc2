// What remains of C++ when names, values and layout are forgotten.
#include "common/similarity/tokens.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

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

/// The longest first, so that the first that fits is the one.
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

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
/// Also of a name in another script, whose bytes are not ASCII.
bool is_of_name(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
           (c & 0x80) != 0;
}

class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> all() {
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
    bool is_at(std::string_view what) const { return text_.substr(at_).starts_with(what); }

    void advance(std::size_t count) {
        const std::size_t end = std::min(at_ + count, text_.size());
        for (; at_ < end; ++at_)
            if (text_[at_] == '\n') ++line_;
    }
    /// To behind the next `end`, or to the end of the text.
    void skip_past(std::string_view end) {
        const auto found = text_.find(end, at_);
        advance(found == std::string_view::npos ? text_.size() - at_ : found + end.size() - at_);
    }

    void add(std::uint16_t kind) { tokens_.push_back({kind, line_}); }

    void step() {
        const char c = peek();
        if (is_blank(c) || (c == '\\' && (peek(1) == '\n' || peek(1) == '\r'))) {
            advance(1);
        } else if (is_at("//")) {
            rest_of_line();
        } else if (is_at("/*")) {
            advance(2);
            skip_past("*/");
        } else if (c == '#') {
            directive();
        } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
            number();
        } else if (is_of_name(c)) {
            word();
        } else if (c == '"' || c == '\'') {
            quoted();
        } else {
            symbol();
        }
    }

    /// A line that ends with a backslash goes on in the next.
    void rest_of_line() {
        while (at_ < text_.size() && peek() != '\n') advance(peek() == '\\' ? (peek(1) == '\r' ? 3 : 2) : 1);
    }

    /// What #define and #if say is looked at; #include and #pragma compute nothing.
    void directive() {
        advance(1);
        while (peek() == ' ' || peek() == '\t') advance(1);
        if (is_at("include") || is_at("pragma")) rest_of_line();
    }

    void number() {
        add(a_literal);
        while (is_of_name(peek()) || peek() == '.' || peek() == '\'' ||
               ((peek() == '+' || peek() == '-') &&
                std::string_view("eEpP").find(text_[at_ - 1]) != std::string_view::npos))
            advance(1);
    }

    void word() {
        const std::size_t begin = at_;
        const int line = line_;
        while (is_of_name(peek())) advance(1);
        const std::string_view word = text_.substr(begin, at_ - begin);
        if (peek() == '"' && word.ends_with('R')) return raw_string(line);
        if (index_in(dropped_words, word)) return;
        if (const auto keyword = index_in(keywords, word))
            return tokens_.push_back({static_cast<std::uint16_t>(first_keyword + *keyword), line});
        if (index_in(literal_words, word)) return tokens_.push_back({a_literal, line});
        for (const OtherSpelling& other : other_spellings)
            if (other.word == word)
                return tokens_.push_back({kind_of_operator(*index_in(operators, other.meaning)), line});
        tokens_.push_back({a_name, line});
    }

    void quoted() {
        add(a_literal);
        const char quote = peek();
        advance(1);
        while (at_ < text_.size() && peek() != quote && peek() != '\n') advance(peek() == '\\' ? 2 : 1);
        if (peek() == quote) advance(1);
    }

    /// R"name( … )name".
    void raw_string(int line) {
        tokens_.push_back({a_literal, line});
        const auto open = text_.find('(', at_);
        if (open == std::string_view::npos) return advance(text_.size() - at_);
        const std::string end = ")" + std::string(text_.substr(at_ + 1, open - at_ - 1)) + "\"";
        advance(open + 1 - at_);
        skip_past(end);
    }

    void symbol() {
        for (std::size_t i = 0; i < operators.size(); ++i) {
            if (!is_at(operators[i])) continue;
            // What stands in front of `::` says only where the name behind it is found.
            if (operators[i] != "::")
                add(kind_of_operator(i));
            else if (!tokens_.empty() && tokens_.back().kind == a_name)
                tokens_.pop_back();
            return advance(operators[i].size());
        }
        advance(1);  // braces, and what is no C++
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view source) { return Lexer(source).all(); }

}  // namespace rt
