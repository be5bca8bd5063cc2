// The exact judge of lines and surfaces f = 0 where f is a polynomial.
// On a line f is a polynomial in one variable, whose coefficients are whole numbers times a power of two. Its
// roots are isolated by Descartes's rule of signs and bisection (Collins & Akritas 1976).
#include "tests/oracle/implicit.hpp"

#include "tests/oracle/exact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace rt::oracle {
namespace {

int sign_of(const Exact& x) { return static_cast<int>(CGAL::sign(x)); }

/// c[0] + c[1]·λ + …, all over the same divisor.
struct Polynomial {
    std::vector<Exact> c;
    Exact divisor = 1;
};

Polynomial times(const Polynomial& p, const Exact& factor) {
    Polynomial product = p;
    for (Exact& c : product.c) c = c * factor;
    return product;
}

Polynomial sum(const Polynomial& p, const Polynomial& q) {
    if (p.divisor != q.divisor) {
        Polynomial a = times(p, q.divisor), b = times(q, p.divisor);
        a.divisor = b.divisor = p.divisor * q.divisor;
        return sum(a, b);
    }
    Polynomial total = p.c.size() < q.c.size() ? q : p;
    const Polynomial& other = p.c.size() < q.c.size() ? p : q;
    for (std::size_t i = 0; i < other.c.size(); ++i) total.c[i] = total.c[i] + other.c[i];
    return total;
}

Polynomial product(const Polynomial& p, const Polynomial& q) {
    Polynomial result{std::vector<Exact>(p.c.size() + q.c.size() - 1, Exact(0)), p.divisor * q.divisor};
    for (std::size_t i = 0; i < p.c.size(); ++i)
        for (std::size_t j = 0; j < q.c.size(); ++j) result.c[i + j] = result.c[i + j] + p.c[i] * q.c[j];
    return result;
}

Polynomial quotient(const Polynomial& p, const Polynomial& q) {
    if (q.c.size() != 1) throw std::logic_error("not a polynomial: it is divided by one");
    Polynomial result = times(p, q.divisor);
    result.divisor = p.divisor * q.c[0];
    return result;
}

Polynomial operation(const Instruction& step, const std::vector<Polynomial>& stack, const Vec3& start,
                     const Vec3& way) {
    const auto coordinate = [&](int i) { return Polynomial{{Exact(start[i]), Exact(way[i])}}; };
    const auto& last = stack.back();
    const auto first = [&]() -> const Polynomial& { return stack[stack.size() - 2]; };
    switch (step.operation) {
        case Operation::Constant:
            return {{Exact(step.constant)}};
        case Operation::X:
            return coordinate(0);
        case Operation::Y:
            return coordinate(1);
        case Operation::Z:
            return coordinate(2);
        case Operation::Negate:
            return times(last, Exact(-1));
        case Operation::Power: {
            if (step.exponent < 0) throw std::logic_error("not a polynomial: a negative power");
            Polynomial power{{Exact(1)}};
            for (int i = 0; i < step.exponent; ++i) power = product(power, last);
            return power;
        }
        case Operation::Add:
            return sum(first(), last);
        case Operation::Subtract:
            return sum(first(), times(last, Exact(-1)));
        case Operation::Multiply:
            return product(first(), last);
        case Operation::Divide:
            return quotient(first(), last);
        default:
            throw std::logic_error("not a polynomial: it has a function");
    }
}

Polynomial on_line(const Formula& f, const Vec3& start, const Vec3& way) {
    std::vector<Polynomial> stack;
    for (const Instruction& step : f.steps) {
        if (stack.empty()) stack.reserve(most_numbers + 1);
        Polynomial result = numbers_taken(step.operation) == 0
                                ? operation(step, std::vector<Polynomial>(1), start, way)
                                : operation(step, stack, start, way);
        stack.resize(stack.size() - numbers_taken(step.operation));
        stack.push_back(std::move(result));
    }
    if (sign_of(stack[0].divisor) > 0) return stack[0];
    stack[0].divisor = -stack[0].divisor;
    return times(stack[0], Exact(-1));
}

/// What f would be if all that it subtracts were added, for sizes of x, y and z.
Real magnitude(const Formula& f, const Vec3& sizes) {
    std::vector<Real> stack;
    for (const Instruction& step : f.steps) {
        const Real last = stack.empty() ? 0 : stack.back(),
                   first = stack.size() < 2 ? 0 : stack[stack.size() - 2];
        Real result = 0;
        switch (step.operation) {
            case Operation::Constant:
                result = std::abs(step.constant);
                break;
            case Operation::X:
                result = sizes.x;
                break;
            case Operation::Y:
                result = sizes.y;
                break;
            case Operation::Z:
                result = sizes.z;
                break;
            case Operation::Power:
                result = std::pow(last, step.exponent);
                break;
            case Operation::Add:
            case Operation::Subtract:
                result = first + last;
                break;
            case Operation::Multiply:
                result = first * last;
                break;
            case Operation::Divide:
                result = first / last;
                break;
            default:
                result = last;
        }
        stack.resize(stack.size() - numbers_taken(step.operation));
        stack.push_back(result);
    }
    return stack[0];
}

// ------------------------------------------------------------------------------------------------- roots

/// The polynomial of x + 1.
std::vector<Exact> shifted(std::vector<Exact> c) {
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
        for (std::size_t j = c.size() - 1; j-- > i;) c[j] = c[j] + c[j + 1];
    return c;
}

/// As many as there are roots in (0, 1), or an even number more.
int most_roots(const std::vector<Exact>& c) {
    const std::vector<Exact> mapped = shifted({c.rbegin(), c.rend()});
    int alternations = 0, last = 0;
    for (const Exact& one : mapped) {
        const int sign = sign_of(one);
        if (sign != 0 && last != 0 && sign != last) ++alternations;
        if (sign != 0) last = sign;
    }
    return alternations;
}

/// Parts of (0, 1) that hold one root each, or roots that are close together; in order, none before its
/// forerunner's end.
struct RootFinder {
    struct Part {
        Real low, high;
    };
    std::vector<Part> parts{};

    void add(Real low, Real high) {
        if (!parts.empty() && parts.back().high == low && high - parts.back().low < 0x1p-37)
            parts.back().high = high;
        else
            parts.push_back({low, high});
    }

    /// The roots of the polynomial of (λ − low)/width in the open part.
    void find(const std::vector<Exact>& c, Real low, Real width) {
        const int most = most_roots(c);
        if (most == 0) return;
        if (most == 1 || width < 0x1p-39) return add(low, low + width);
        std::vector<Exact> left = c;
        Exact factor(1);
        for (std::size_t i = left.size(); i-- > 0; factor = factor * Exact(2)) left[i] = left[i] * factor;
        std::vector<Exact> right = shifted(left);
        find(left, low, width / 2);
        if (sign_of(right[0]) == 0) add(low + width / 2, low + width / 2);
        find(right, low + width / 2, width / 2);
    }
};

Exact value(const std::vector<Exact>& c, Real lambda) {
    const Exact x(lambda);
    Exact y(0);
    for (std::size_t i = c.size(); i-- > 0;) y = y * x + c[i];
    return y;
}

std::vector<Exact> derivative(const std::vector<Exact>& c) {
    std::vector<Exact> slopes;
    for (std::size_t i = 1; i < c.size(); ++i) slopes.push_back(c[i] * Exact(static_cast<double>(i)));
    return slopes;
}

}  // namespace

NearRoot near_root(const Formula& f, const Vec3& start, const Vec3& way, Real lambda) {
    const Polynomial polynomial = on_line(f, start, way);
    const std::vector<Exact> first = derivative(polynomial.c), second = derivative(first);
    const auto at_lambda = [&](const std::vector<Exact>& c) { return CGAL::to_double(value(c, lambda)); };
    const Real slope = at_lambda(first), divisor = CGAL::to_double(polynomial.divisor);
    return {-at_lambda(polynomial.c) / slope, slope / divisor, at_lambda(second) / divisor,
            magnitude(f, abs(start + lambda * way))};
}

int sign_on_line(const Formula& f, const Vec3& start, const Vec3& way, Real lambda) {
    return sign_of(value(on_line(f, start, way).c, lambda));
}

LineTruth judge_line(const Formula& f, const Vec3& start, const Vec3& way, Real rounding,
                     std::optional<Real> proposed, Real slack) {
    const Polynomial polynomial = on_line(f, start, way);
    const std::vector<Exact>& c = polynomial.c;
    const Real divisor = CGAL::to_double(polynomial.divisor);
    const auto clear_sign = [&](Real lambda) {
        const Exact exact = value(c, lambda);
        const Real bound = 3 * rounding * divisor * magnitude(f, abs(start) + std::abs(lambda) * abs(way));
        return std::abs(CGAL::to_double(exact)) > bound ? sign_of(exact) : 0;
    };
    RootFinder finder;
    finder.find(c, 0, 1);
    LineTruth truth;
    truth.roots = static_cast<int>(finder.parts.size());

    // In each stretch between roots, and in each that holds a root: where does f clearly have a sign?
    int last = 0;
    const Real end = proposed ? *proposed - slack : 1;
    const auto look = [&](Real low, Real high) {
        bool any = false;
        for (const Real part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Real lambda = std::min(low + part * (high - low), end);
            const int sign = lambda < low ? 0 : clear_sign(lambda);
            any |= sign != 0;
            truth.is_overlooked |= sign * last < 0;
            if (sign != 0) last = sign;
        }
        if (high <= end) truth.has_hidden |= !any;
    };
    Real from = 0;
    for (const auto& [low, high] : finder.parts) {
        look(from, low);
        if (high - low >= 0x1p-39) look(low, high);
        from = high;
    }
    look(from, 1);
    if (proposed)
        truth.is_on = clear_sign(*proposed) == 0 ||
                      sign_of(value(c, *proposed - slack)) * sign_of(value(c, *proposed + slack)) <= 0;
    return truth;
}

}  // namespace rt::oracle
