// What the tests of glossy lobes share: where directions around an axis are on a chart.
#pragma once

#include "tests/11_textures/lobe_checks.hpp"

#include <cmath>

namespace rt::test {

/// Directions around a unit vector: equal areas for equal shares of Phong's lobe. The angle θ is known by
/// 1 − cos θ, which is half the square of the distance between the ends of the two vectors.
inline Chart around(const Vec3& axis, Real exponent, bool above_surface = true) {
    const Vec3 side = normalize(cross(axis, std::abs(axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(0, 1, 0)));
    const Vec3 front = cross(side, axis);
    const auto at = [=](Real a, Real b) -> std::optional<ChartPoint> {
        const Real missing = -std::expm1(std::log(a) / (1 + exponent));
        const Real flat = std::sqrt(missing * (2 - missing)), turn = radians(360 * b);
        const Vec3 l =
            normalize((1 - missing) * axis + flat * std::sin(turn) * side + flat * std::cos(turn) * front);
        if (above_surface && !(l.z > 0)) return std::nullopt;
        return ChartPoint{l, 2 * pi / (1 + exponent) * (1 - missing) / a};
    };
    const auto find = [=](const Vec3& l) -> std::optional<Vec2> {
        const Vec3 gap = l - axis;
        const Real missing = dot(gap, gap) / 2;
        if (missing > 1 || (above_surface && !(l.z > 0))) return std::nullopt;
        const Real share = std::exp((1 + exponent) * std::log1p(-std::min(missing, 1 - 0x1p-53)));
        return Vec2(share, turn_of({dot(l, front), dot(l, side), 0}));
    };
    return {at, find};
}

}  // namespace rt::test
