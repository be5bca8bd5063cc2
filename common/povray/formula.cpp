// Formulas as POV-Ray writes them: as a function, or multiplied out for its `polynomial`.
#include "common/povray/formula.hpp"

#include "common/povray/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace rt::povray {
namespace {

// ----------------------------------------------------------------------------------------------- functions

/// Least in front: what stands beside an operator is put in parentheses where it binds less.
enum class Binds { Sum, Product, Sign, Alone };

struct Term {
    std::string text;
    Binds binds = Binds::Alone;

    std::string at_least(Binds binds_least) const { return binds < binds_least ? "(" + text + ")" : text; }
};

/// The text of the program's last operation, whose numbers are the last terms.
Term term_of(const Instruction& step, std::span<const Term> terms) {
    const auto call = [&](std::string_view name) {
        return Term{fmt::format("{}({})", name, terms.back().text)};
    };
    const auto pair = [&](std::string_view name) {
        return Term{fmt::format("{}({}, {})", name, terms[terms.size() - 2].text, terms.back().text)};
    };
    const auto between = [&](std::string_view sign, Binds binds) {
        const Binds after =
            sign == "+" || sign == "*" ? binds : static_cast<Binds>(static_cast<int>(binds) + 1);
        return Term{terms[terms.size() - 2].at_least(binds) + fmt::format(" {} ", sign) +
                        terms.back().at_least(std::max(after, binds)),
                    binds};
    };
    switch (step.operation) {
        case Operation::Constant:
            return {number(step.constant), step.constant < 0 ? Binds::Sum : Binds::Alone};
        case Operation::X:
            return {"x"};
        case Operation::Y:
            return {"y"};
        case Operation::Z:
            return {"z"};
        case Operation::Negate:
            return {"-" + terms.back().at_least(Binds::Alone), Binds::Sum};
        case Operation::Power:
            return {fmt::format("pow({}, {})", terms.back().text, step.exponent)};
        case Operation::SquareRoot:
            return call("sqrt");
        case Operation::Exponential:
            return call("exp");
        case Operation::Logarithm:
            return call("ln");
        case Operation::Sine:
            return call("sin");
        case Operation::Cosine:
            return call("cos");
        case Operation::Absolute:
            return call("abs");
        case Operation::Add:
            return between("+", Binds::Sum);
        case Operation::Subtract:
            return between("-", Binds::Sum);
        case Operation::Multiply:
            return between("*", Binds::Product);
        case Operation::Divide:
            return between("/", Binds::Product);
        case Operation::Minimum:
            return pair("min");
        case Operation::Maximum:
            return pair("max");
    }
    return {};
}

// --------------------------------------------------------------------------------------------- polynomials

using Terms = std::optional<PolynomialTerms>;

Terms sum(const Terms& a, const Terms& b, Real factor) {
    if (!a || !b) return std::nullopt;
    PolynomialTerms total = *a;
    for (const auto& [exponents, coefficient] : *b) total[exponents] += factor * coefficient;
    std::erase_if(total, [](const auto& term) { return term.second == 0; });
    return total;
}

Terms product(const Terms& a, const Terms& b) {
    if (!a || !b || degree_of(*a) + degree_of(*b) > greatest_degree) return std::nullopt;
    PolynomialTerms total;
    for (const auto& [e, p] : *a)
        for (const auto& [f, q] : *b) total[{e[0] + f[0], e[1] + f[1], e[2] + f[2]}] += p * q;
    std::erase_if(total, [](const auto& term) { return term.second == 0; });
    return total;
}

Terms power(const Terms& a, int exponent) {
    if (exponent < 0) return std::nullopt;
    Terms result = PolynomialTerms{{{0, 0, 0}, 1}};
    for (int i = 0; i < exponent; ++i) result = product(result, a);
    return result;
}

Terms quotient(const Terms& a, const Terms& b) {
    if (!b || b->size() != 1 || degree_of(*b) > 0) return std::nullopt;
    return product(a, PolynomialTerms{{{0, 0, 0}, 1 / b->begin()->second}});
}

}  // namespace

std::string function_of(const Formula& f) {
    std::vector<Term> terms;
    for (const Instruction& step : f.steps) {
        const Term term = term_of(step, terms);
        terms.resize(terms.size() - numbers_taken(step.operation));
        terms.push_back(term);
    }
    return terms.back().text;
}

std::optional<PolynomialTerms> terms_of(const Formula& f) {
    std::vector<Terms> stack;
    const auto combine = [&](auto by) {
        const Terms last = stack.back();
        stack.pop_back();
        stack.back() = by(stack.back(), last);
    };
    for (const Instruction& step : f.steps) switch (step.operation) {
            case Operation::Constant:
                stack.push_back(sum(PolynomialTerms{}, PolynomialTerms{{{0, 0, 0}, 1}}, step.constant));
                break;
            case Operation::X:
                stack.push_back(PolynomialTerms{{{1, 0, 0}, 1}});
                break;
            case Operation::Y:
                stack.push_back(PolynomialTerms{{{0, 1, 0}, 1}});
                break;
            case Operation::Z:
                stack.push_back(PolynomialTerms{{{0, 0, 1}, 1}});
                break;
            case Operation::Negate:
                stack.back() = sum(PolynomialTerms{}, stack.back(), -1);
                break;
            case Operation::Power:
                stack.back() = power(stack.back(), step.exponent);
                break;
            case Operation::Add:
                combine([](const Terms& a, const Terms& b) { return sum(a, b, 1); });
                break;
            case Operation::Subtract:
                combine([](const Terms& a, const Terms& b) { return sum(a, b, -1); });
                break;
            case Operation::Multiply:
                combine(product);
                break;
            case Operation::Divide:
                combine(quotient);
                break;
            default:
                return std::nullopt;
        }
    return stack.back();
}

int degree_of(const PolynomialTerms& terms) {
    int degree = 0;
    for (const auto& [exponents, coefficient] : terms)
        degree = std::max(degree, exponents[0] + exponents[1] + exponents[2]);
    return degree;
}

}  // namespace rt::povray
