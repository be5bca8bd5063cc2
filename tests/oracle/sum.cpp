// The exact judge of sums of products.
#include "tests/oracle/sum.hpp"

#include <CGAL/Gmpq.h>

namespace rt::oracle {
namespace {

CGAL::Gmpq sum_of(std::span<const Product> products) {
    CGAL::Gmpq sum(0);
    for (const auto& [a, b, c] : products) sum += CGAL::Gmpq(a) * CGAL::Gmpq(b) * CGAL::Gmpq(c);
    return sum;
}

}  // namespace

int sign_of_sum(std::span<const Product> products) { return static_cast<int>(CGAL::sign(sum_of(products))); }

Real relative_error(std::span<const Product> products, Real mantissa, int exponent) {
    const CGAL::Gmpq sum = sum_of(products);
    CGAL::Gmpq answer(mantissa);
    const CGAL::Gmpq factor(exponent < 0 ? 0.5 : 2.0);
    for (int i = 0; i < std::abs(exponent); ++i) answer *= factor;
    return CGAL::to_double((answer - sum) / CGAL::abs(sum));
}

}  // namespace rt::oracle
