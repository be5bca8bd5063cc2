// Few numbers from many measurements.
#include "tests/report/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace rt::report {
namespace {

/// The 97.5 % quantile of Student's t, for so many degrees of freedom.
double student(std::size_t freedom) {
    constexpr std::array<double, 11> table{0,     12.706, 4.303, 3.182, 2.776, 2.571,
                                           2.447, 2.365,  2.306, 2.262, 2.228};
    // From 10 on the first terms of the expansion about the normal quantile 1.960 are good to 0.005.
    return freedom < table.size() ? table[freedom] : 1.960 + 2.372 / static_cast<double>(freedom);
}

}  // namespace

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double quantile(std::vector<double> values, double p) {
    if (values.empty()) return 0;
    const auto needed = static_cast<std::size_t>(std::ceil(p * static_cast<double>(values.size())));
    const std::size_t index = std::clamp<std::size_t>(needed, 1, values.size()) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
    return values[index];
}

double root_mean_square(std::span<const double> values) {
    if (values.empty()) return 0;
    double sum = 0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
        if (x[i] > 0 && y[i] > 0 && std::isfinite(x[i]) && std::isfinite(y[i]))
            points.emplace_back(std::log10(x[i]), std::log10(y[i]));

    const double infinity = std::numeric_limits<double>::infinity();
    PowerLaw law{0, -infinity, infinity, 0, static_cast<int>(points.size())};
    if (points.size() < 2) return law;
    const auto n = static_cast<double>(points.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0, residual = 0;
    for (const auto& [a, b] : points) mean_x += a / n, mean_y += b / n;
    for (const auto& [a, b] : points) xx += (a - mean_x) * (a - mean_x), xy += (a - mean_x) * (b - mean_y);
    if (xx == 0) return law;
    law.slope = xy / xx;
    law.intercept = mean_y - law.slope * mean_x;
    if (points.size() < 3) return law;
    for (const auto& [a, b] : points) residual += std::pow(b - law.intercept - law.slope * a, 2);
    const double half = student(points.size() - 2) * std::sqrt(residual / (n - 2) / xx);
    law.low = law.slope - half;
    law.high = law.slope + half;
    return law;
}

}  // namespace rt::report
