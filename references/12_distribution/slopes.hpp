// How the error falls with the number of samples, for integrands of different smoothness and dimension, and
// what blocks of pixels gain that share one sequence: as tables, and as curves.
#pragma once

#include "chapters/12_distribution/samples.hpp"
#include "chapters/12_distribution/sobol.hpp"
#include "common/math/mixed.hpp"
#include "references/figures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rt::figures::slopes {

inline constexpr std::size_t most = 8;  ///< dimensions
using Point = std::array<Real, most>;

// Methods ------------------------------------------------------------------------------------------------

enum Method { Independent, Stratified, Padded, Reordered, Whole };
inline constexpr std::size_t methods = 5;
inline constexpr std::array<const char*, methods> method_names{
    "independent", "stratified pairs", "Sobol' pairs", "Sobol' pairs in any order", "Sobol' in all"};

/// Sample `index` of `count` in eight dimensions, by pairs (0, 1), (2, 3), …
inline Point point_of(Method method, std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    Point p{};
    for (std::size_t d = 0; d < most; d += 2) {
        const std::uint64_t own = mixed(mixed(7, key), d);
        const auto dimension = static_cast<std::uint32_t>(d);
        Vec2 pair{0};
        switch (method) {
            case Independent:
                pair = {real_of(mixed(mixed(own, 1), index)), real_of(mixed(mixed(own, 2), index))};
                break;
            case Stratified:
                pair = stratified_point(index, count, own);
                break;
            case Padded:
                pair = sobol_point(index, own);
                break;
            // Not scrambled in blocks of blocks, but in any order at all: no net before all are there.
            case Reordered:
                pair = sobol_point(permuted(index, count, mixed(own, 3)), own);
                break;
            case Whole:
                pair = Vec2(owen_scrambled(sobol_bits(index, dimension), mixed(own, 1)),
                            owen_scrambled(sobol_bits(index, dimension + 1), mixed(own, 2))) *
                       0x1p-32;
                break;
        }
        p[d] = pair.x, p[d + 1] = pair.y;
    }
    return p;
}

/// One dimension alone is stratified by itself, not as the shadow of a pair.
inline Real number_of(Method method, std::uint32_t index, std::uint32_t count, std::uint64_t key,
                      const Point& point) {
    return method == Stratified ? stratified_number(index, count, mixed(mixed(8, key), 0)) : point[0];
}

// Integrands ---------------------------------------------------------------------------------------------

/// Of each trial its own: numbers by which the integrands differ.
struct Parameters {
    Point a{}, c{}, log_mean{};  ///< log_mean: of e^(a x), x from 0 to 1
    Real edge = 0;
};

inline Parameters parameters_of(std::uint64_t trial) {
    Parameters p;
    std::uint64_t use = 0;
    const auto next = [&] { return real_of(mixed(mixed(99, trial), use++)); };
    for (Real& a : p.a) {
        a = 0.5 + next();
        if (next() < 0.5) a = -a;
    }
    for (std::size_t d = 0; d < most; ++d) p.log_mean[d] = std::log(std::expm1(p.a[d]) / p.a[d]);
    for (Real& c : p.c) c = next();
    p.edge = next();
    return p;
}

enum Kind { Box, Edge, Smooth, EdgeSum, SmoothSum };

struct Integrand {
    const char* name;
    Kind kind;
    std::size_t d;
};

inline constexpr std::array<Integrand, 11> integrands{{{"step", Box, 1},
                                                       {"smooth", Smooth, 1},
                                                       {"box", Box, 2},
                                                       {"edge", Edge, 2},
                                                       {"smooth", Smooth, 2},
                                                       {"edge", Edge, 4},
                                                       {"smooth", Smooth, 4},
                                                       {"sum of edges", EdgeSum, 4},
                                                       {"sum of smooth", SmoothSum, 4},
                                                       {"smooth", Smooth, 8},
                                                       {"sum of smooth", SmoothSum, 8}}};

/// The half space Σ a x < h in d dimensions from `first` on leaves between ¼ and ¾ of the way.
inline Real height(const Parameters& p, std::size_t first, std::size_t d) {
    Real low = 0, high = 0;
    for (std::size_t j = first; j < first + d; ++j) (p.a[j] < 0 ? low : high) += p.a[j];
    return low + (high - low) * (0.25 + 0.5 * p.edge);
}

inline Real in_half_space(const Parameters& p, const Point& x, std::size_t first, std::size_t d) {
    Real sum = 0;
    for (std::size_t j = first; j < first + d; ++j) sum += p.a[j] * x[j];
    return sum < height(p, first, d) ? 1 : 0;
}

/// Its volume in the unit cube, by inclusion and exclusion of the corners.
inline Real half_space(const Parameters& p, std::size_t first, std::size_t d) {
    Real h = height(p, first, d), product = 1, sum = 0;
    for (std::size_t j = first; j < first + d; ++j) {
        product *= std::abs(p.a[j]) * static_cast<Real>(j - first + 1);
        if (p.a[j] < 0) h -= p.a[j];
    }
    for (std::size_t corner = 0; corner < std::size_t(1) << d; ++corner) {
        Real rest = h, sign = 1;
        for (std::size_t j = 0; j < d; ++j)
            if (corner >> j & 1) rest -= std::abs(p.a[first + j]), sign = -sign;
        if (rest > 0) sum += sign * std::pow(rest, static_cast<Real>(d));
    }
    return sum / product;
}

/// e^(Σ a x), divided by its mean.
inline Real smooth(const Parameters& p, const Point& x, std::size_t first, std::size_t d) {
    Real sum = 0;
    for (std::size_t j = first; j < first + d; ++j) sum += p.a[j] * x[j] - p.log_mean[j];
    return std::exp(sum);
}

inline Real value(const Integrand& f, const Parameters& p, const Point& x) {
    Real sum = 0;
    switch (f.kind) {
        case Box:
            for (std::size_t j = 0; j < f.d; ++j)
                if (!(x[j] < std::pow(p.c[j], 1 / static_cast<Real>(f.d)))) return 0;
            return 1;
        case Edge:
            return in_half_space(p, x, 0, f.d);
        case Smooth:
            return smooth(p, x, 0, f.d);
        case EdgeSum:
            for (std::size_t j = 0; j < f.d; j += 2) sum += in_half_space(p, x, j, 2);
            break;
        case SmoothSum:
            for (std::size_t j = 0; j < f.d; j += 2) sum += smooth(p, x, j, 2);
            break;
    }
    return sum;
}

inline Real mean(const Integrand& f, const Parameters& p) {
    Real sum = 0, product = 1;
    switch (f.kind) {
        case Box:
            for (std::size_t j = 0; j < f.d; ++j) product *= std::pow(p.c[j], 1 / static_cast<Real>(f.d));
            return product;
        case Edge:
            return half_space(p, 0, f.d);
        case Smooth:
            return 1;
        case EdgeSum:
            for (std::size_t j = 0; j < f.d; j += 2) sum += half_space(p, j, 2);
            return sum;
        case SmoothSum:
            return static_cast<Real>(f.d) / 2;
    }
    return sum;
}

/// What theory says of n → ∞, of nets up to logarithms: Owen 1997, Mitchell 1996, He & Wang 2015.
inline Real theory(const Integrand& f, Method method) {
    const bool is_sum = f.kind == EdgeSum || f.kind == SmoothSum;
    const bool is_smooth = f.kind == Smooth || f.kind == SmoothSum;
    const std::size_t d = is_sum ? 2 : f.d;
    if (method == Independent) return -0.5;
    if (d == 1) return is_smooth ? -1.5 : -1;
    // Pairs are paired at random: what no pair alone explains converges as if it were independent.
    if (method != Whole && d > 2) return -0.5;
    if (method == Stratified) return is_smooth ? -1 : -0.75;
    if (is_smooth) return -1.5;
    if (f.kind == Box) return -1;
    return -0.5 - 0.5 / static_cast<Real>(d);
}

// Errors and fits ----------------------------------------------------------------------------------------

inline constexpr std::size_t batches = 20;
inline constexpr std::uint64_t trials = 1000;
inline constexpr std::array<std::uint32_t, 5> counts{4, 16, 64, 256, 1024};

/// Means of squared errors: of each batch of trials, for each number of samples.
using Squares = std::array<std::array<Real, counts.size()>, batches>;
/// For each method and integrand.
using Errors = std::array<std::array<Squares, integrands.size()>, methods>;

inline Errors measured() {
    Errors squares{};
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        const Parameters p = parameters_of(trial);
        std::array<Real, integrands.size()> means{};
        for (std::size_t f = 0; f < integrands.size(); ++f) means[f] = mean(integrands[f], p);
        for (std::size_t m = 0; m < methods; ++m)
            for (std::size_t level = 0; level < counts.size(); ++level) {
                const std::uint64_t key = mixed(mixed(mixed(11, trial), m), level);
                std::array<Real, integrands.size()> sums{};
                for (std::uint32_t i = 0; i < counts[level]; ++i) {
                    const auto method = static_cast<Method>(m);
                    const Point x = point_of(method, i, counts[level], key);
                    const Point alone{number_of(method, i, counts[level], key, x)};
                    for (std::size_t f = 0; f < integrands.size(); ++f)
                        sums[f] += value(integrands[f], p, integrands[f].d == 1 ? alone : x) - means[f];
                }
                for (std::size_t f = 0; f < integrands.size(); ++f) {
                    const Real error = sums[f] / counts[level];
                    squares[m][f][trial * batches / trials][level] += error * error * batches / trials;
                }
            }
    }
    return squares;
}

inline Real rms(const Squares& squares, std::size_t level) {
    Real sum = 0;
    for (const auto& batch : squares) sum += batch[level] / batches;
    return std::sqrt(sum);
}

/// Of the line through log n and log RMS (least squares), one batch left out.
inline Real slope_without(const Squares& squares, std::size_t left_out) {
    std::array<Real, counts.size()> x{}, y{};
    Real mx = 0, my = 0, xy = 0, xx = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t batch = 0; batch < batches; ++batch)
            if (batch != left_out) y[i] += squares[batch][i];
        x[i] = std::log(counts[i]), y[i] = std::log(y[i]) / 2;
        mx += x[i] / counts.size(), my += y[i] / counts.size();
    }
    for (std::size_t i = 0; i < counts.size(); ++i)
        xy += (x[i] - mx) * (y[i] - my), xx += (x[i] - mx) * (x[i] - mx);
    return xy / xx;
}

/// 95 % of confidence by the jackknife over batches; Student's t of 19 degrees of freedom is 2.093.
inline Real plus_minus(const Squares& squares) {
    std::array<Real, batches> left{};
    Real middle = 0, spread = 0;
    for (std::size_t batch = 0; batch < batches; ++batch)
        middle += (left[batch] = slope_without(squares, batch)) / batches;
    for (const Real slope : left) spread += (slope - middle) * (slope - middle);
    return 2.093 * std::sqrt(spread * (batches - 1) / batches);
}

inline std::string table(const Errors& errors) {
    std::string text = "integrand,dimensions,method,slope,plus_minus,theory,rms_16,rms_1024\n";
    for (std::size_t f = 0; f < integrands.size(); ++f)
        for (std::size_t m = 0; m < methods; ++m) {
            const Squares& squares = errors[m][f];
            text +=
                fmt::format("{},{},{},{:.2f},{:.2f},{},{:.2g},{:.2g}\n", integrands[f].name, integrands[f].d,
                            method_names[m], slope_without(squares, batches), plus_minus(squares),
                            theory(integrands[f], static_cast<Method>(m)), rms(squares, 1), rms(squares, 4));
        }
    return text;
}

/// The same as the lesson shows it: a line for each integrand, the slopes of all methods, then their errors.
inline std::string lesson_table(const Errors& errors) {
    std::string text = "function (dimensions)";
    for (const char* column : {"", "rms 16 ", "rms 1024 "})
        for (const char* method : method_names) text += fmt::format(",{}{}", column, method);
    text += '\n';
    for (std::size_t f = 0; f < integrands.size(); ++f) {
        text += fmt::format("{} ({})", integrands[f].name, integrands[f].d);
        for (std::size_t m = 0; m < methods; ++m)
            text += fmt::format(",{:.2f}", slope_without(errors[m][f], batches));
        for (const std::size_t level : {1u, 4u})
            for (std::size_t m = 0; m < methods; ++m)
                text += fmt::format(",{:.2g}", rms(errors[m][f], level));
        text += '\n';
    }
    return text;
}

/// RMS error against the number of samples: smooth functions of two, of four in pairs, and of four together.
inline Svg curves(const Errors& errors) {
    Svg svg{960, 360};
    const std::array<const char*, methods> colors{grey, orange, blue, green, red};
    const auto panel = [&](Real left, const char* title, std::size_t f) {
        const Plot plot{{left, 40}, {230, 240}, {4, 1024, true}, {1e-5, 1, true}};
        draw_axes(svg, plot, {{4, "4"}, {16, "16"}, {64, "64"}, {256, "256"}, {1024, "1024"}},
                  decades(-5, 0));
        text(svg, {left + 115, 24}, title, heading);
        text(svg, {left + 115, 322}, "samples", middle(note));
        for (const std::size_t m : {0u, 1u, 2u, 4u}) {
            std::vector<Vec2> points;
            for (std::size_t level = 0; level < counts.size(); ++level)
                points.push_back(plot.place(counts[level], rms(errors[m][f], level)));
            polyline(svg, points, {.stroke = colors[m], .width = 2});
            for (const Vec2& p : points) dot_at(svg, p, colors[m]);
        }
    };
    panel(60, "smooth, 2 dimensions", 4);
    panel(380, "sum of smooth, 4", 8);
    panel(700, "smooth, 4", 6);
    SvgFont upwards = middle(note);
    upwards.turn = -90;
    text(svg, {14, 160}, "RMS error", upwards);
    Real x = 150;
    for (const std::size_t m : {0u, 1u, 2u, 4u}) {
        text(svg, {x, 350}, method_names[m], {.size = 17, .color = colors[m]});
        x += 190;
    }
    return svg;
}

// Blocks of pixels ---------------------------------------------------------------------------------------

/// RMS errors of the means of blocks of pixels of 4 samples each, of a smooth integrand that is the same in
/// all of them: with keys of their own, and with one sequence for all.
inline std::string blocks() {
    constexpr std::uint32_t count = 4, widest = 16;
    std::array<std::array<Real, 5>, 2> squares{};
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        const Parameters p = parameters_of(trial);
        for (std::size_t shared = 0; shared < 2; ++shared) {
            std::array<Real, widest * widest> errors{};
            const std::uint64_t key = mixed(mixed(5, trial), 0);
            for (std::uint32_t at = 0; at < widest * widest; ++at) {
                const std::uint32_t start =
                    shared == 1 ? pixel_start(64 + at % widest, 32 + at / widest, count, key) : 0;
                Real sum = 0;
                for (std::uint32_t i = 0; i < count; ++i) {
                    const Vec2 u = sobol_point(start + i, shared == 1 ? key : mixed(key, at + 1));
                    sum += smooth(p, {u.x, u.y}, 0, 2);
                }
                errors[at] = sum / count - 1;
            }
            for (std::uint32_t k = 0; k < 5; ++k) {
                const std::uint32_t side = 1u << k;  // the block at (64, 32): multiples of 16
                Real sum = 0;
                for (std::uint32_t at = 0; at < side * side; ++at)
                    sum += errors[at / side * widest + at % side];
                sum /= side * side;
                squares[shared][k] += sum * sum / trials;
            }
        }
    }
    std::string text = "pixels on a side,a key for each pixel,one sequence\n";
    for (std::size_t k = 0; k < 5; ++k)
        text += fmt::format("{},{:.2g},{:.2g}\n", 1 << k, std::sqrt(squares[0][k]), std::sqrt(squares[1][k]));
    return text;
}

}  // namespace rt::figures::slopes
