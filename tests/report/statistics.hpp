// Few numbers from many measurements: medians, quantiles, and the exponent of a power law with its
// confidence.
#pragma once

#include <span>
#include <vector>

namespace rt::report {

/// The middle value, or the mean of the middle two; 0 of nothing.
double median(std::vector<double> values);

/// The smallest value that is not exceeded by at least the part `p` in [0, 1] of them; 0 of nothing.
double quantile(std::vector<double> values, double p);

/// Square root of the mean square; 0 of nothing.
double root_mean_square(std::span<const double> values);

/// y = 10^intercept · x^slope, fitted by least squares to the logarithms.
struct PowerLaw {
    double slope = 0;
    double low = 0, high = 0;  ///< the slope's 95 % confidence interval; infinite for fewer than 3 points
    double intercept = 0;      ///< decimal logarithm of y at x = 1
    int points = 0;            ///< pairs used: both numbers finite and positive
};

/// The confidence interval takes the points' distances from the line for independent normal errors (Student's
/// t). Where the line is curved that makes it wide, as it should be.
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace rt::report
