// A function of x, y and z, as a scene file writes it, read once into a small program.
#include "common/scene/formula.hpp"

#include "common/math/printable.hpp"
#include "common/scene/evaluate.hpp"
#include "common/scene/suggest.hpp"
#include "common/scene/text.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }
constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }

struct Function {
    std::string_view name;
    Operation operation;
    int arguments;
};

constexpr Function functions[] = {
    {"sqrt", Operation::SquareRoot, 1}, {"exp", Operation::Exponential, 1}, {"log", Operation::Logarithm, 1},
    {"sin", Operation::Sine, 1},        {"cos", Operation::Cosine, 1},      {"abs", Operation::Absolute, 1},
    {"min", Operation::Minimum, 2},     {"max", Operation::Maximum, 2},
};

/// Recursive descent: sum, product, sign, power, atom; each appends its steps.
struct Reader {
    std::string_view text;
    std::size_t at = 0;
    std::vector<Instruction> steps{};
    std::size_t numbers = 0;  ///< on the stack, so far
    int nested = 0;

    [[noreturn]] void fail(const std::string& what, std::size_t where) const {
        throw FormulaError(what, where);
    }

    char next() {
        while (at < text.size() && is_blank(text[at])) ++at;
        return at < text.size() ? text[at] : '\0';
    }
    /// The character that stands here, in quotes: a minus sign of a text processor has several bytes.
    std::string quoted_here() const {
        const std::string_view rest = text.substr(at);
        return quoted(rest.substr(0, std::max<std::size_t>(1, utf8_length(rest))));
    }
    bool take(char c) {
        if (next() != c) return false;
        ++at;
        return true;
    }

    void push(Instruction step) {
        if (++numbers > most_numbers)
            fail("too deeply nested: more than " + std::to_string(most_numbers) +
                     " numbers wait for each other",
                 at);
        steps.push_back(step);
    }

    bool is_constant(std::size_t from_end) const {
        return steps.size() > from_end && steps[steps.size() - 1 - from_end].operation == Operation::Constant;
    }

    /// An operation on the last `arguments` numbers; done at once where all are constants.
    void apply(Instruction step, std::size_t arguments, std::size_t where) {
        numbers -= arguments - 1;
        const bool known = is_constant(0) && (arguments == 1 || is_constant(1));
        steps.push_back(step);
        if (!known) return;
        const auto first = steps.end() - static_cast<std::ptrdiff_t>(arguments) - 1;
        const Real value = value_at({{first, steps.end()}, {}}, Vec3(0));
        if (std::isnan(value)) fail("this has no value", where);
        if (!std::isfinite(value)) fail("not a finite number: " + shown(value), where);
        steps.erase(first, steps.end());
        steps.push_back({.constant = value});
    }

    /// Two numbers to one; x*x is a square, which is known to be nowhere negative.
    void combine(Operation operation, std::size_t where) {
        const std::size_t size = steps.size();
        const bool variables = size >= 2 && operation == Operation::Multiply &&
                               Operation::X <= steps[size - 1].operation &&
                               steps[size - 1].operation <= Operation::Z;
        if (variables && steps[size - 1].operation == steps[size - 2].operation) {
            steps.pop_back();
            --numbers;
            return apply({.operation = Operation::Power, .exponent = 2}, 1, where);
        }
        apply({.operation = operation}, 2, where);
    }

    void sum() {
        product();
        for (char c = next(); c == '+' || c == '-'; c = next()) {
            const std::size_t where = at++;
            product();
            combine(c == '+' ? Operation::Add : Operation::Subtract, where);
        }
    }
    void product() {
        sign();
        for (char c = next(); c == '*' || c == '/'; c = next()) {
            const std::size_t where = at++;
            sign();
            combine(c == '*' ? Operation::Multiply : Operation::Divide, where);
        }
    }
    void sign() {
        if (++nested > 200) fail("too deeply nested", at);
        const std::size_t where = at;
        if (take('-')) {
            sign();
            apply({.operation = Operation::Negate}, 1, where);
        } else if (take('+')) {
            sign();
        } else {
            raised();
        }
        --nested;
    }
    void raised() {
        atom();
        if (next() != '^') return;
        const std::size_t where = at++;
        sign();
        if (!is_constant(0)) return general_power(where);
        const Real exponent = steps.back().constant;
        if (exponent != std::floor(exponent) || std::abs(exponent) > greatest_exponent)
            return general_power(where);
        steps.pop_back();
        --numbers;
        apply({.operation = Operation::Power, .exponent = static_cast<int>(exponent)}, 1, where);
    }
    /// a^b = exp(b·log a).
    void general_power(std::size_t where) {
        if (is_constant(0) && steps.back().constant == 0.5) {
            steps.pop_back();
            --numbers;
            return apply({.operation = Operation::SquareRoot}, 1, where);
        }
        const auto base_end = steps.begin() + static_cast<std::ptrdiff_t>(end_of_base());
        const std::vector<Instruction> exponent(base_end, steps.end());
        steps.erase(base_end, steps.end());
        apply({.operation = Operation::Logarithm}, 1, where);
        steps.insert(steps.end(), exponent.begin(), exponent.end());
        apply({.operation = Operation::Multiply}, 2, where);
        apply({.operation = Operation::Exponential}, 1, where);
    }
    /// Where the program of the last number but one ends: in front of as many steps as make one number.
    std::size_t end_of_base() const {
        std::size_t i = steps.size();
        for (int missing = 1; missing > 0;)
            missing += static_cast<int>(numbers_taken(steps[--i].operation)) - 1;
        return i;
    }

    void atom() {
        const char c = next();
        const std::size_t where = at;
        if (is_digit(c) || c == '.') return number();
        if (is_letter(c)) return word();
        if (take('(')) {
            sum();
            if (!take(')')) fail_closing(where);
            return;
        }
        if (c == '\0') fail("the expression ends where a number, x, y, z or a function should follow", where);
        fail("a number, x, y, z, a function or '(' should be here, not " + quoted_here(), where);
    }
    [[noreturn]] void fail_closing(std::size_t opening) {
        if (next() == '\0') fail("this '(' is never closed", opening);
        fail("an operator or ')' should be here, not " + quoted_here(), at);
    }

    void number() {
        const std::size_t begin = at;
        const auto digits = [&] {
            while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
        };
        digits();
        // An exponent, if it has digits: 2exp(x) is none.
        std::size_t after = at + 1;
        if (after < text.size() && (text[after] == '+' || text[after] == '-')) ++after;
        if (at < text.size() && (text[at] == 'e' || text[at] == 'E') && after < text.size() &&
            is_digit(text[after])) {
            at = after;
            digits();
        }
        const std::string_view digits_of_it = text.substr(begin, at - begin);
        const ParsedNumber parsed = parse_number(digits_of_it);
        if (!parsed.problem.empty()) fail(quoted(digits_of_it) + " " + std::string(parsed.problem), begin);
        push({.constant = parsed.value});
    }

    void word() {
        const std::size_t begin = at;
        while (at < text.size() && (is_letter(text[at]) || is_digit(text[at]))) ++at;
        const std::string_view name = text.substr(begin, at - begin);
        if (name.size() == 1 && 'x' <= name[0] && name[0] <= 'z')
            return push(
                {.operation = static_cast<Operation>(static_cast<int>(Operation::X) + (name[0] - 'x'))});
        const auto* function = std::ranges::find(functions, name, &Function::name);
        if (function == std::end(functions)) fail_unknown(name, begin);
        call(*function, begin);
    }
    void call(const Function& function, std::size_t begin) {
        const auto wrong_count = [&] {
            fail(quoted(function.name) + " takes " + (function.arguments == 1 ? "1 number" : "2 numbers") +
                     " in parentheses" + (function.arguments == 1 ? "" : ", with a comma between them"),
                 begin);
        };
        next();
        const std::size_t opening = at;
        if (!take('(')) wrong_count();
        sum();
        if (function.arguments == 2) {
            if (!take(',')) wrong_count();
            sum();
        }
        if (next() == ',') wrong_count();
        if (!take(')')) fail_closing(opening);
        apply({.operation = function.operation}, static_cast<std::size_t>(function.arguments), begin);
    }
    [[noreturn]] void fail_unknown(std::string_view name, std::size_t begin) const {
        std::vector<std::string_view> names{"x", "y", "z"};
        for (const Function& function : functions) names.push_back(function.name);
        fail("unknown name " + quoted(name) + did_you_mean(name, names), begin);
    }
};

}  // namespace

Formula parse_formula(std::string_view text) {
    Reader reader{text};
    reader.sum();
    const char rest = reader.next();
    if (rest == ')') reader.fail("there is no '(' to this ')'", reader.at);
    if (rest != '\0') reader.fail("an operator should be here, not " + reader.quoted_here(), reader.at);
    const auto is_variable = [](const Instruction& step) {
        return Operation::X <= step.operation && step.operation <= Operation::Z;
    };
    if (std::ranges::none_of(reader.steps, is_variable))
        reader.fail("there is no x, y or z in it, so it has no surface", 0);
    return {std::move(reader.steps), std::string(text)};
}

Formula in_other_unit(const Formula& f, Real factor) {
    Formula scaled{{}, f.text};
    for (const Instruction& step : f.steps) {
        scaled.steps.push_back(step);
        if (step.operation < Operation::X || step.operation > Operation::Z) continue;
        scaled.steps.push_back({.constant = 1 / factor});
        scaled.steps.push_back({.operation = Operation::Multiply});
    }
    return scaled;
}

}  // namespace rt
