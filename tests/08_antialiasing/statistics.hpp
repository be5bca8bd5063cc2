// What tests of random things need: statistics that a right program exceeds less than once in a million runs.
#pragma once

#include "chapters/08_antialiasing/samples.hpp"
#include "tests/chi_square.hpp"
#include "tests/stability/coverage.hpp"

#include <cmath>
#include <vector>

namespace rt::test {

/// Student's t of numbers whose expectation is said to be `expected`: how many of its standard errors the
/// mean is away. 0 where all numbers are `expected` to 12 digits, and ∞ where they are equal but something
/// else.
inline Real t_statistic(const std::vector<Real>& numbers, Real expected) {
    const auto n = static_cast<Real>(numbers.size());
    Real sum = 0, squares = 0;
    for (const Real number : numbers) sum += number - expected;
    const Real mean = sum / n;
    for (const Real number : numbers) squares += (number - expected - mean) * (number - expected - mean);
    if (std::abs(mean) <= 1e-12 && squares <= 1e-24 * n) return 0;
    return mean / std::sqrt(squares / (n - 1) / n);
}

/// With a hundred numbers or more, |t| of a right program exceeds this once in thirty million times or less.
/// No test asks for more than thirty, so a right program fails less than once in a million times.
inline constexpr Real t_limit = 6;

/// Weighted mean of a shape's values at the samples: what sampling makes of its coverage of the unit square.
template <class Shape>
Real sampled(const Shape& shape, const std::vector<PixelSample>& samples) {
    Real sum = 0;
    for (const PixelSample& sample : samples) sum += sample.weight * value(shape, sample.at);
    return sum;
}

/// Coverage of the unit square.
template <class Shape>
Real truth(const Shape& shape) {
    return mean(shape, Vec2(0), Vec2(1));
}

/// Student's t of what patterns make of a shape, against its coverage; `pattern` makes number i of them.
template <class Shape, class Pattern>
Real t_of(const Shape& shape, int patterns, Pattern pattern) {
    std::vector<Real> means;
    for (int i = 0; i < patterns; ++i)
        means.push_back(sampled(shape, pattern(static_cast<std::uint64_t>(i))));
    return t_statistic(means, truth(shape));
}

/// An edge in any direction at any place, such that each line through the unit square is equally likely (and
/// some pass it by). Then the mean square error of stratified samples is exactly proportional to n^-1.5 on
/// n = k² strata: a small square sees the edges that a large one sees, only fewer of them.
inline HalfPlane any_edge(rt::Random& random) {
    const Real angle = 2 * pi * random_real(random), half_diagonal = std::sqrt(0.5);
    const Vec2 n(std::cos(angle), std::sin(angle));
    return {n, dot(n, Vec2(0.5)) + half_diagonal * (2 * random_real(random) - 1)};
}

/// Something smooth: its slope is at most 1 or so.
inline ZonePlate any_smooth(rt::Random& random) { return {2.0 * random_point(random) - Vec2(0.5), 0.5}; }

/// Root mean square error of what patterns of n samples make of shapes.
template <class Shape, class Pattern>
Real rms_error(int trials, int n, Shape any_shape, Pattern pattern) {
    Real sum = 0;
    for (int i = 0; i < trials; ++i) {
        const auto trial = static_cast<std::uint64_t>(i);
        rt::Random place = random_for(802, trial, static_cast<std::uint64_t>(n));
        const auto shape = any_shape(place);
        const Real error =
            sampled(shape, pattern(n, random_for(803, trial, static_cast<std::uint64_t>(n)))) - truth(shape);
        sum += error * error;
    }
    return std::sqrt(sum / trials);
}

/// Slope of the straight line through (log x, log y), by least squares.
inline Real log_slope(const std::vector<Real>& x, const std::vector<Real>& y) {
    Real mean_x = 0, mean_y = 0, xy = 0, xx = 0;
    const auto n = static_cast<Real>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
        xx += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    }
    return xy / xx;
}

/// How the error falls with n = 4, 16, ..., 1024 samples: the exponent of n.
template <class Shape, class Pattern>
Real error_slope(int trials, Shape any_shape, Pattern pattern) {
    std::vector<Real> counts, errors;
    for (int n = 4; n <= 1024; n *= 4) {
        counts.push_back(n);
        errors.push_back(rms_error(trials, n, any_shape, pattern));
    }
    return log_slope(counts, errors);
}

}  // namespace rt::test
