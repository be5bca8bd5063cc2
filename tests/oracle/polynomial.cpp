// The exact judge of polynomials.
#include "tests/oracle/polynomial.hpp"

#include "tests/oracle/sturm.hpp"

#include <algorithm>

namespace rt::oracle {
namespace {

/// The polynomial plus `part`·Σ|aᵢtⁱ|, for the t of one sign.
Sturm moved(const Coefficients& a, Real part, bool negative_side) {
    std::vector<Exact> moved;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool grows = (a[i] > 0) != (negative_side && i % 2 == 1);
        moved.push_back(Exact(a[i]) * (Exact(1) + (grows ? Exact(part) : -Exact(part))));
    }
    return Sturm(std::move(moved));
}

/// Between the ends; `sign` is 1 for positive, −1 for negative or 0.
bool has_sign(const Sturm& p, Interval range, int sign) {
    const Exact low(range.min), high(range.max), middle = (low + high) * Exact(0.5);
    if (low == high) return true;
    const int at_end = p.sign_at(high) == 0 ? 1 : 0;
    return p.sign_at(middle) == sign && p.roots(low, high) == at_end;
}

/// What `is_so` says of both sides of 0.
template <class IsSo>
bool on_both_sides(const Coefficients& a, Interval range, Real part, IsSo is_so) {
    if (range.min < 0 && !is_so(moved(a, part, true), Interval{range.min, std::min<Real>(range.max, 0)}))
        return false;
    return range.max < 0 || is_so(moved(a, part, false), Interval{std::max<Real>(range.min, 0), range.max});
}

}  // namespace

int count_roots(const Coefficients& a, Interval range, Real part) {
    int roots = 0;
    if (range.min < 0)
        roots += moved(a, part, true).roots(Exact(range.min), Exact(std::min<Real>(range.max, 0)));
    if (range.max > 0)
        roots += moved(a, part, false).roots(Exact(std::max<Real>(range.min, 0)), Exact(range.max));
    return roots;
}

bool can_be_positive(const Coefficients& a, Interval range, Real relative) {
    return on_both_sides(a, range, relative,
                         [](const Sturm& p, Interval part) { return has_sign(p, part, 1); });
}

bool can_be_not_positive(const Coefficients& a, Interval range, Real relative) {
    return on_both_sides(a, range, -relative,
                         [](const Sturm& p, Interval part) { return has_sign(p, part, -1); });
}

Real residual(const Coefficients& a, Real t) {
    Exact value(0), size(0);
    const Exact at(t), at_size(std::abs(t));
    for (std::size_t i = a.size(); i-- > 0;) {
        value = value * at + Exact(a[i]);
        size = size * at_size + Exact(std::abs(a[i]));
    }
    if (CGAL::sign(value) == 0) return 0;
    return std::abs(CGAL::to_double(value) / CGAL::to_double(size));
}

}  // namespace rt::oracle
