// Mutants of a solution: each differs from it at one place, as a slip of the pen would.
#include "common/evidence/mutants.hpp"

#include "common/workbook/exercise.hpp"
#include "common/workbook/functions.hpp"
#include "common/workbook/lexemes.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace rt {

namespace {

using Kind = Lexeme::Kind;
using Exchanges = std::map<std::string_view, std::vector<std::string>>;

/// Operators between two operands.
const Exchanges other_operators{
    {"<", {"<=", ">="}}, {"<=", {"<", ">"}},  {">", {">=", "<="}}, {">=", {">", "<"}},  {"==", {"!="}},
    {"!=", {"=="}},      {"+", {"-"}},        {"-", {"+"}},        {"*", {"/"}},        {"/", {"*"}},
    {"%", {"/"}},        {"&&", {"||"}},      {"||", {"&&"}},      {"&", {"|"}},        {"|", {"&"}},
    {"^", {"|"}},        {"<<", {">>"}},      {">>", {"<<"}},      {"+=", {"-=", "="}}, {"-=", {"+=", "="}},
    {"*=", {"/=", "="}}, {"/=", {"*=", "="}}, {"|=", {"&=", "="}}, {"&=", {"|=", "="}}, {"^=", {"|=", "="}},
    {"<<=", {">>="}},    {">>=", {"<<="}}};

const Exchanges other_words{{"true", {"false"}},
                            {"false", {"true"}},
                            {"min", {"max"}},
                            {"max", {"min"}},
                            {"floor", {"ceil"}},
                            {"ceil", {"floor"}},
                            {"sin", {"cos"}},
                            {"cos", {"sin"}},
                            {"any_of", {"all_of"}},
                            {"all_of", {"any_of"}},
                            {"none_of", {"any_of"}},
                            {"lower_bound", {"upper_bound"}},
                            {"upper_bound", {"lower_bound"}}};
/// Only of members.
const Exchanges other_members{{"x", {"y"}}, {"y", {"x"}}, {"z", {"x"}}};

/// Functions to which the order of two arguments is the same.
const std::set<std::string_view> symmetric{"dot", "min", "max", "minmax", "hypot", "distance", "swap"};
const std::set<std::string_view> with_parentheses{"if",    "while",  "for",   "switch",
                                                  "catch", "return", "sizeof"};
const std::set<std::string_view> of_declarations{"const", "constexpr", "auto", "using", "static", "struct"};

/// A part of the lexemes: from `first` to before `last`.
struct Range {
    std::size_t first = 0, last = 0;
    bool empty() const { return first >= last; }
};

/// Makes the mutants of one exercise, whose lexemes are `part` of the file's.
class Mutator {
public:
    Mutator(std::string_view text, const std::vector<Lexeme>& lexemes, Range part, std::string step)
        : text_(text), lexemes_(lexemes), part_(part), step_(std::move(step)) {}

    std::vector<Mutant> all() {
        for (std::size_t i = part_.first; i < part_.last; ++i) {
            if (at(i).is("reserve") && at(i + 1).is("(")) i = matching(i + 1);
            if (lexemes_[i].kind == Kind::Sign) change_sign(i);
            if (lexemes_[i].kind == Kind::Word) change_word(i);
            if (lexemes_[i].kind == Kind::Number) change_number(i);
        }
        for (std::size_t i = part_.first; i < part_.last;) i = leave_out_statements(i);
        std::stable_sort(mutants_.begin(), mutants_.end(),
                         [](const Mutant& a, const Mutant& b) { return a.begin < b.begin; });
        return std::move(mutants_);
    }

private:
    /// The lexeme; outside of the exercise, nothing.
    const Lexeme& at(std::size_t i) const {
        static const Lexeme none;
        return i >= part_.first && i < part_.last ? lexemes_[i] : none;
    }
    const Lexeme& before(std::size_t i) const { return at(i - 1); }
    bool blank_before(std::size_t i) const { return at(i).begin > before(i).end(); }
    bool blank_after(std::size_t i) const { return at(i + 1).begin > at(i).end(); }
    bool between_operands(std::size_t i) const { return blank_before(i) && blank_after(i); }

    void replace(std::size_t begin, std::size_t end, std::string replacement) {
        const std::size_t line_begin = text_.rfind('\n', begin) + 1;
        const std::size_t line_end = std::min(text_.find('\n', end), text_.size());
        const std::string_view head = text_.substr(line_begin, begin - line_begin);
        const std::string_view tail = text_.substr(end, line_end - end);
        Mutant mutant{step_, begin, end - begin, std::move(replacement), 0, "", ""};
        mutant.line = 1 + static_cast<int>(std::count(
                              text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
        mutant.from = in_one_line(text_.substr(line_begin, line_end - line_begin));
        mutant.to = in_one_line(std::string(head) + mutant.replacement + std::string(tail));
        mutants_.push_back(std::move(mutant));
    }
    void replace(const Lexeme& lexeme, std::string replacement) {
        replace(lexeme.begin, lexeme.end(), std::move(replacement));
    }
    void replace(Range range, std::string replacement) {
        replace(at(range.first).begin, at(range.last - 1).end(), std::move(replacement));
    }
    void exchange(const Lexeme& lexeme, const Exchanges& exchanges) {
        const auto found = exchanges.find(lexeme.text);
        if (found == exchanges.end()) return;
        for (const std::string& other : found->second) replace(lexeme, other);
    }

    void change_sign(std::size_t i) {
        const Lexeme& sign = at(i);
        if (sign.is("++")) return replace(sign, "--");
        if (sign.is("--")) return replace(sign, "++");
        if (sign.is("?")) {
            replace(sign, "|| true ?");
            return replace(sign, "&& false ?");
        }
        if (sign.is("(") || sign.is("{")) return change_list(i);
        if (between_operands(i)) return exchange(sign, other_operators);
        if (sign.is("!") || sign.is("-") || sign.is("~")) replace(sign, "");
    }

    void change_word(std::size_t i) {
        const Lexeme& word = at(i);
        exchange(word, other_words);
        if (before(i).is(".") && !at(i + 1).is("(")) exchange(word, other_members);
        if ((word.is("if") || word.is("while") || word.is("for")) && at(i + 1).is("(")) change_condition(i);
    }

    void change_number(std::size_t i) {
        const Lexeme& number = at(i);
        std::string digits(number.text);
        std::erase(digits, '\'');
        const bool template_argument = at(i + 1).is(">") && !blank_after(i);
        if (template_argument) return;
        const std::size_t end = std::min(digits.find_first_not_of("0123456789"), digits.size());
        const std::string suffix = digits.substr(end);
        if (end == 0 || end > 9 || suffix.find_first_not_of("uUlL") != std::string::npos)
            return replace(number, "(2 * " + digits + ")");
        const int value = std::stoi(digits);
        replace(number, std::to_string(value + 1) + suffix);
        if (value > 0) replace(number, std::to_string(value - 1) + suffix);
    }

    /// Of `if (…)`, `while (…)` or `for (…)` at i. Loops without an end are not made.
    void change_condition(std::size_t i) {
        const std::size_t close = matching(i + 1);
        Range condition{i + 2, close};
        std::vector<std::size_t> semicolons;
        for (std::size_t k = condition.first; k < close; k = is_open(k) ? matching(k) + 1 : k + 1)
            if (at(k).is(";")) semicolons.push_back(k);
        const bool loop = at(i).is("for");
        if (loop && semicolons.size() != 2) return;
        if (!semicolons.empty()) condition = {semicolons[0] + 1, loop ? semicolons[1] : close};
        if (condition.empty() || of_declarations.contains(at(condition.first).text)) return;
        if (at(i).is("if")) replace(condition, "true");
        replace(condition, "false");
    }

    // ------------------------------------------------------------------------------ lists of arguments
    bool is_open(std::size_t i) const { return at(i).is("(") || at(i).is("[") || at(i).is("{"); }
    bool is_close(std::size_t i) const { return at(i).is(")") || at(i).is("]") || at(i).is("}"); }

    /// The place of what closes the bracket at i.
    std::size_t matching(std::size_t i) const {
        int depth = 0;
        for (; i < part_.last; ++i) {
            if (is_open(i)) ++depth;
            if (is_close(i) && --depth == 0) return i;
        }
        return part_.last;
    }

    /// Whether the bracket at i opens values: of a call, or in braces.
    bool opens_values(std::size_t i) const {
        const Lexeme& last = before(i);
        const bool after_name = last.kind == Kind::Word && !blank_before(i);
        if (at(i).is("(")) return after_name && !with_parentheses.contains(last.text);
        return after_name || last.is("return") || last.is("(") || last.is(",") || last.is("=") ||
               last.is("{");
    }

    std::vector<Range> arguments(std::size_t open) const {
        const std::size_t close = matching(open);
        std::vector<Range> list{{open + 1, close}};
        int templates = 0;
        for (std::size_t k = open + 1; k < close; k = is_open(k) ? matching(k) + 1 : k + 1) {
            if (at(k).is("<") && !blank_before(k)) ++templates;
            if (at(k).is(">") && !blank_before(k)) --templates;
            if (!at(k).is(",") || templates > 0) continue;
            list.back().last = k;
            list.push_back({k + 1, close});
        }
        if (list.back().empty()) list.pop_back();
        return list;
    }

    std::string text_of(Range range) const {
        return std::string(
            text_.substr(at(range.first).begin, at(range.last - 1).end() - at(range.first).begin));
    }

    void change_list(std::size_t open) {
        if (!opens_values(open)) return;
        const std::vector<Range> list = arguments(open);
        const bool call = at(open).is("(");
        if (call && list.size() == 1) return leave_out_call(open);
        // Also of min({a, b}).
        if (symmetric.contains(at(call ? open - 1 : open - 2).text)) return;
        for (std::size_t k = 0; k + 1 < list.size(); ++k) {
            const Range one = list[k], other = list[k + 1];
            const bool named = at(one.first).is(".") || at(one.first).is("[") || at(other.first).is("[");
            const std::string a = text_of(one), b = text_of(other);
            if (named || a == b) continue;
            const std::size_t begin = at(one.first).begin, end = at(other.last - 1).end();
            const std::size_t between = begin + a.size();
            replace(begin, end, b + std::string(text_.substr(between, at(other.first).begin - between)) + a);
        }
    }

    /// `std::sqrt(x)` becomes `(x)`; neither a member's call nor a declaration such as `Real x(1)`.
    void leave_out_call(std::size_t open) {
        std::size_t name = open - 1;
        while (before(name).is("::") && at(name - 2).kind == Kind::Word) name -= 2;
        const Lexeme& last = before(name);
        const bool declared = last.kind == Kind::Word && !last.is("return");
        if (last.is(".") || last.is("->") || last.is(">") || last.is("::") || declared) return;
        replace(at(name).begin, at(open).begin, "");
    }

    // -------------------------------------------------------------------------------------- statements
    /// Leaves out each statement of those that begin at i; returns the place after them.
    std::size_t leave_out_statements(std::size_t i) {
        const Lexeme& first = at(i);
        if (first.is("{")) {
            for (++i; i < part_.last && !at(i).is("}");) i = leave_out_statements(i);
            return i + 1;
        }
        if (first.is("else") || first.is("do")) return leave_out_statements(i + 1);
        if (with_parentheses.contains(first.text) && at(i + 1).is("("))
            return first.is("return") ? after_simple(i) : leave_out_statements(matching(i + 1) + 1);
        if (first.is("if")) return leave_out_statements(matching(i + 2) + 1);  // if constexpr (
        if (first.is("case") || first.is("default")) {
            while (i < part_.last && !at(i).is(":")) ++i;
            return i + 1;
        }
        const std::size_t after = after_simple(i);
        std::size_t open = i;
        while (open < after && !at(open).is("(")) ++open;
        const bool reserves = at(open - 1).is("reserve");
        if (!is_declaration(i) && !first.is("return") && !reserves && after > i + 1) replace({i, after}, ";");
        return after;
    }

    /// After the semicolon of the statement at i. What stands in the bodies of its lambdas is left out, too.
    std::size_t after_simple(std::size_t i) {
        for (; i < part_.last && !at(i).is(";") && !at(i).is("}"); ++i) {
            if (at(i).is("(") && before(i).is("]"))
                i = matching(i);  // the parameters of a lambda
            else if (at(i).is("{") && !opens_values(i))
                i = leave_out_statements(i) - 1;
        }
        return i + 1;
    }

    /// Whether a statement begins with two names, such as `Real x`, or with what only a declaration can.
    bool is_declaration(std::size_t i) const {
        if (of_declarations.contains(at(i).text)) return true;
        while (at(i).kind == Kind::Word && at(i + 1).is("::")) i += 2;
        if (at(i).kind != Kind::Word) return false;
        ++i;
        if (at(i).is("<") && !blank_before(i))
            while (i < part_.last && !at(i - 1).is(">")) ++i;
        if (at(i).is("&") || at(i).is("*")) ++i;
        return at(i).kind == Kind::Word;
    }

    std::string_view text_;
    const std::vector<Lexeme>& lexemes_;
    Range part_;
    std::string step_;
    std::vector<Mutant> mutants_;
};

}  // namespace

std::vector<Mutant> mutants_of(std::string_view solution, const std::string& file) {
    const std::vector<Lexeme> lexemes = lexemes_of(solution);
    std::vector<Mutant> mutants;
    for (const ExerciseRegion& region : exercise_regions(solution, file)) {
        const auto from_line = [&](int line) {
            const auto found = std::find_if(lexemes.begin(), lexemes.end(),
                                            [&](const Lexeme& lexeme) { return lexeme.line >= line; });
            return static_cast<std::size_t>(found - lexemes.begin());
        };
        const Range part{from_line(region.first_line), from_line(region.last_line)};
        const std::vector<Mutant> more = Mutator(solution, lexemes, part, region.step).all();
        mutants.insert(mutants.end(), more.begin(), more.end());
    }
    return mutants;
}

std::string mutated(std::string_view solution, const Mutant& mutant) {
    return std::string(solution).replace(mutant.begin, mutant.length, mutant.replacement);
}

}  // namespace rt
