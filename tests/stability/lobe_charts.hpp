// Sums of a lobe over all directions, and whether samples are as dense as they claim: for tests of lobes and
// for the figures of their lesson.
#pragma once

#include "chapters/11_textures/lobe.hpp"
#include "tests/chi_square.hpp"
#include "tests/show.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace rt::test {

/// The direction `theta` degrees from the normal, turned by `phi` degrees.
inline Vec3 towards(Real theta, Real phi = 0) {
    const Real t = radians(theta), p = radians(phi);
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

/// The direction whose cosine with the normal is `cosine`, turned by `phi` degrees: to grazing ones.
inline Vec3 at_cosine(Real cosine, Real phi = 0) {
    const Real sine = std::sqrt((1 - cosine) * (1 + cosine)), p = radians(phi);
    return {sine * std::cos(p), sine * std::sin(p), cosine};
}

/// A direction and how many steradians there are to a unit of the chart's area, around it.
struct ChartPoint {
    Vec3 direction{0};
    Real steradians = 0;
};

/// A map of directions onto the unit square, made so that the lobe that is looked at is nearly even on it.
struct Chart {
    std::function<std::optional<ChartPoint>(Real a, Real b)> at;
    std::function<std::optional<Vec2>(const Vec3&)> find;
};

/// The angle of v around the normal as a part of the circle, in [0, 1).
inline Real turn_of(const Vec3& v) {
    const Real turn = std::atan2(v.y, v.x) / (2 * pi);
    return turn < 0 ? std::min(turn + 1, 0x1.fffffffffffffp-1) : turn;
}

/// All directions above the surface; equal areas for equal solid angles.
inline Chart dome() {
    return {[](Real a, Real b) -> std::optional<ChartPoint> {
                const Real phi = 2 * pi * b, flat = std::sqrt((1 - a) * (1 + a));
                return ChartPoint{{flat * std::cos(phi), flat * std::sin(phi), a}, 2 * pi};
            },
            [](const Vec3& l) -> std::optional<Vec2> {
                if (!(l.z > 0)) return std::nullopt;
                return Vec2(l.z, turn_of(l));
            }};
}

/// Normals of facets around the surface's, with tan²θ = width²·(1/(1 − a)² − 1): as many as there are of
/// GGX's where a is small, and more near the horizon, where a slanted viewer sees more.
inline ChartPoint facet_at(Real width, Real a, Real b) {
    const Real rest = 1 - a, square = width * width * a * (2 - a) / (rest * rest);
    const Real cosine = 1 / std::sqrt(1 + square), sine = std::sqrt(square) * cosine, phi = 2 * pi * b;
    const Real density = 2 * pi * std::pow(cosine / rest, 3) * width * width;
    return {{sine * std::cos(phi), sine * std::sin(phi), cosine}, density};
}

inline Vec2 facet_place(Real width, const Vec3& h) {
    const Real flat = h.x * h.x + h.y * h.y, steep = width * width * h.z * h.z, all = flat + steep;
    return {flat / (all + std::sqrt(all * steep)), turn_of(h)};
}

/// What facets around the normal mirror to the viewer v, on either side of the surface, but not through it.
inline Chart mirrored_by_facets(Real width, const Vec3& v) {
    const Real side = v.z > 0 ? 1 : -1;
    return {[=](Real a, Real b) -> std::optional<ChartPoint> {
                const ChartPoint h = facet_at(width, a, b);
                const Real across = dot(h.direction, v);
                if (!(across * side > 0)) return std::nullopt;
                const Vec3 l = normalize(2 * across * h.direction - v);
                if (!(l.z * side > 0)) return std::nullopt;
                return ChartPoint{l, 4 * std::abs(across) * h.steradians};
            },
            [=](const Vec3& l) -> std::optional<Vec2> {
                if (!(l.z * side > 0)) return std::nullopt;
                return facet_place(width, side * normalize(l + v));
            }};
}

/// What facets around the normal bend to the viewer v. `ior_v` is of the viewer's side, `ior_l` of the other.
inline Chart bent_by_facets(Real width, const Vec3& v, Real ior_v, Real ior_l) {
    const Real side = v.z > 0 ? 1 : -1, from_dense = ior_v > ior_l ? 1 : -1;
    return {[=](Real a, Real b) -> std::optional<ChartPoint> {
                const ChartPoint h = facet_at(width, a, b);
                const Vec3 n = side * h.direction;
                const Real cos_v = dot(n, v), ratio = ior_v / ior_l;
                const Real square = 1 - ratio * ratio * (1 - cos_v * cos_v);
                if (!(cos_v > 0) || !(square > 0)) return std::nullopt;
                const Real cos_l = std::sqrt(square);
                const Vec3 l = normalize(-ratio * v + (ratio * cos_v - cos_l) * n);
                if (!(l.z * side < 0)) return std::nullopt;
                const Real turned = ior_v * cos_v - ior_l * cos_l;
                return ChartPoint{l, h.steradians * turned * turned / (ior_l * ior_l * cos_l)};
            },
            [=](const Vec3& l) -> std::optional<Vec2> {
                if (!(l.z * side < 0)) return std::nullopt;
                const Vec3 h = side * from_dense * normalize(ior_v * v + ior_l * l);
                return facet_place(width, h.z > 0 ? h : -h);
            }};
}

/// Integral of value(l) over the directions l of the chart, by the midpoint rule on n × n cells.
template <class Value>
auto sum_over(const Chart& chart, int n, Value value) {
    using Term = decltype(value(Vec3(0)) * 1.0);
    const auto row = static_cast<std::size_t>(n);
    std::vector<Term> terms(row * row, Term(0));
    together(terms.size(), [&](std::size_t cell) {
        const Real a = (static_cast<Real>(cell / row) + 0.5) / n,
                   b = (static_cast<Real>(cell % row) + 0.5) / n;
        if (const auto p = chart.at(a, b))
            terms[cell] = value(p->direction) * (p->steradians / (Real(n) * n));
    });
    return std::accumulate(terms.begin(), terms.end(), Term(0));
}

/// Pearson's χ² of samples, and the limit that right ones exceed once in ten million times.
struct SampleReport {
    Real statistic = 0;
    Real limit = 0;
    int classes = 0;
    std::string worst;  ///< the class that differs most
    std::string stray;  ///< a direction that no chart has: there should be none
};

/// The patch (i, j) of n × n, by one of its directions and the part of a patch's steradians that the chart
/// has there. It is looked at in 5 × 5 places, because at the horizon a chart ends in the middle of patches.
inline ChartPoint patch_of(const Chart& chart, int i, int j, int n) {
    constexpr int places = 5;
    std::array<ChartPoint, places * places> there;
    std::size_t count = 0;
    for (int k = 0; k < places * places; ++k) {
        const Real x = i + (k / places + 0.5) / places, y = j + (k % places + 0.5) / places;
        if (const auto p = chart.at(x / n, y / n)) there[count++] = *p;
    }
    if (count == 0) return {};
    const ChartPoint middle = there[count / 2];
    return {middle.direction, middle.steradians * static_cast<Real>(count) / (Real(n) * n * places * places)};
}

/// Whether directions drawn by `draw(random)` (nothing, or a LobeSample) have the density pdf(l). The classes
/// are the cells of charts that do not overlap, the mirror's direction with probability `mirrored`, and none
/// at all. What a cell should have is the pdf's integral, by one point in each of 12 × 12 patches; none at
/// all is what is missing to 1, and may be off by 0.002 for the integral's sake. Classes that should have
/// fewer than 10 are thrown together. As in Nori (Jakob 2015).
template <class Draw, class Pdf>
SampleReport compare_samples(const std::vector<Chart>& charts, Draw draw, Pdf pdf, int samples,
                             std::uint64_t seed, Real mirrored = 0) {
    constexpr int side = 8, fine = 12;
    const std::size_t cells = charts.size() * side * side;
    std::vector<Real> expected(cells + 2, 0), found(cells + 2, 0);
    const auto cell_of = [](std::size_t chart, const Vec2& at) {
        const auto index = [](Real x) {
            return static_cast<std::size_t>(std::clamp(static_cast<int>(x * side), 0, side - 1));
        };
        return (chart * side + index(at.x)) * side + index(at.y);
    };
    Real all = mirrored;
    for (std::size_t c = 0; c < charts.size(); ++c)
        together(std::size_t{side * fine} * side * fine, [&](std::size_t k) {
            const int i = static_cast<int>(k) / (side * fine), j = static_cast<int>(k) % (side * fine);
            const ChartPoint patch = patch_of(charts[c], i, j, side * fine);
            if (patch.steradians == 0) return;
            const Real part = pdf(patch.direction) * patch.steradians;
            expected[cell_of(c, Vec2(i + 0.5, j + 0.5) / Real(side * fine))] += samples * part;
            all += part;
        });
    expected[cells] = samples * mirrored;
    expected[cells + 1] = samples * std::max(1 - all, Real(0));
    SampleReport report;
    Random random(seed);
    together(static_cast<std::size_t>(samples), [&](std::size_t) {
        const Real x = random.uniform(0, 1), y = random.uniform(0, 1), z = random.uniform(0, 1);
        const std::optional<LobeSample> drawn = draw(Vec3(x, y, z));
        std::size_t where = cells + 1;
        bool is_stray = drawn && !std::isinf(drawn->pdf);
        if (drawn && !is_stray) where = cells;
        for (std::size_t c = 0; is_stray && c < charts.size(); ++c)
            if (const auto at = charts[c].find(drawn->to_light)) {
                where = cell_of(c, *at);
                is_stray = false;
            }
        if (is_stray) report.stray = show(drawn->to_light);
        ++found[where];
    });
    Real few_expected = 0, few_found = 0, greatest = -1;
    const auto count = [&](Real f, Real e, const std::string& name, Real allowed = 0) {
        const Real off = std::max(std::abs(f - e) - allowed, Real(0)), term = off * off / e;
        report.statistic += term;
        ++report.classes;
        if (!(term <= greatest)) {
            greatest = term;
            report.worst = name + ": " + std::to_string(static_cast<int>(f)) + " samples, " +
                           std::to_string(e) + " expected";
        }
    };
    for (std::size_t c = 0; c < expected.size(); ++c) {
        if (!(expected[c] < 10)) {
            const std::string name = c == cells       ? "the mirror's direction"
                                     : c == cells + 1 ? "no direction"
                                                      : "cell " + std::to_string(c);
            count(found[c], expected[c], name, c == cells + 1 ? 0.002 * samples : 0);
        } else {
            few_expected += expected[c];
            few_found += found[c];
        }
    }
    // Where there should be fewer than 10 in all, the integral may be wrong by as many.
    if (few_expected >= 10)
        count(few_found, few_expected, "rare cells together");
    else if (few_found > 10)
        count(few_found, 10, "where hardly any should be");
    report.limit = chi_square_limit(static_cast<std::size_t>(std::max(report.classes, 2)));
    return report;
}

}  // namespace rt::test
