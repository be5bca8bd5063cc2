// A C++ source cut into words, numbers, quoted texts and signs, without compiling it.
#include "common/workbook/lexemes.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace rt {

namespace {

/// Those of more than one character, the longest first, so that the first that fits is the one.
constexpr std::array<std::string_view, 27> long_signs{
    "<<=", ">>=", "<=>", "...", "->*", "->", "++", "--", "<<", ">>", "<=", ">=", "==", "!=",
    "&&",  "||",  "+=",  "-=",  "*=",  "/=", "%=", "&=", "|=", "^=", "::", ".*", "##"};

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

    std::vector<Lexeme> all() {
        while (at_ < text_.size()) step();
        return std::move(lexemes_);
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

    /// What was read from `begin` on.
    void add(Lexeme::Kind kind, std::size_t begin, int line) {
        lexemes_.push_back({kind, text_.substr(begin, at_ - begin), begin, line});
    }

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
            sign();
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
        const std::size_t begin = at_;
        while (is_of_name(peek()) || peek() == '.' || peek() == '\'' ||
               ((peek() == '+' || peek() == '-') &&
                std::string_view("eEpP").find(text_[at_ - 1]) != std::string_view::npos))
            advance(1);
        add(Lexeme::Kind::Number, begin, line_);
    }

    void word() {
        const std::size_t begin = at_;
        const int line = line_;
        while (is_of_name(peek())) advance(1);
        if (peek() == '"' && text_[at_ - 1] == 'R') {
            rest_of_raw_string();
            add(Lexeme::Kind::Quoted, begin, line);
        } else {
            add(Lexeme::Kind::Word, begin, line);
        }
    }

    void quoted() {
        const std::size_t begin = at_;
        const int line = line_;
        const char quote = peek();
        advance(1);
        while (at_ < text_.size() && peek() != quote && peek() != '\n') advance(peek() == '\\' ? 2 : 1);
        if (peek() == quote) advance(1);
        add(Lexeme::Kind::Quoted, begin, line);
    }

    /// Of R"name( … )name", from the quote on.
    void rest_of_raw_string() {
        const auto open = text_.find('(', at_);
        if (open == std::string_view::npos) return advance(text_.size() - at_);
        const std::string end = ")" + std::string(text_.substr(at_ + 1, open - at_ - 1)) + "\"";
        advance(open + 1 - at_);
        skip_past(end);
    }

    void sign() {
        const std::size_t begin = at_;
        const auto found =
            std::find_if(long_signs.begin(), long_signs.end(), [&](std::string_view s) { return is_at(s); });
        advance(found == long_signs.end() ? 1 : found->size());
        add(Lexeme::Kind::Sign, begin, line_);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<Lexeme> lexemes_;
};

}  // namespace

std::vector<Lexeme> lexemes_of(std::string_view source) { return Lexer(source).all(); }

}  // namespace rt
