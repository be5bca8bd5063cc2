// What the tests of lobes share.
#pragma once

#include "tests/catch.hpp"
#include "tests/stability/lobe_charts.hpp"
#include "tests/support.hpp"

#include <cmath>

namespace rt::test {

/// Straight up, and 60 degrees from the normal to either side, by hand: (±√3/2, 0, 1/2).
inline const Vec3 up{0, 0, 1}, right{std::sqrt(3.0) / 2, 0, 0.5}, left{-std::sqrt(3.0) / 2, 0, 0.5};

/// Any direction above the surface.
inline Vec3 upper(Random& random) {
    const Vec3 w = random.direction();
    return {w.x, w.y, std::abs(w.z)};
}

inline bool is_valid(const Vec3& f) { return is_finite(f) && f.x >= 0 && f.y >= 0 && f.z >= 0; }

/// Fresnel's reflected part by Snell's angles: sin² and tan² of difference and sum (Fresnel 1823).
inline Real mirrored_by_angles(Real cosine, Real n_before, Real n_behind) {
    if (cosine > 1 - 1e-9) return std::pow((n_before - n_behind) / (n_before + n_behind), 2);
    const Real before = std::acos(cosine), sine = std::sin(before) * n_before / n_behind;
    if (sine >= 1) return 1;
    const Real behind = std::asin(sine);
    const Real across = std::sin(before - behind) / std::sin(before + behind);
    const Real along = std::tan(before - behind) / std::tan(before + behind);
    return (across * across + along * along) / 2;
}

/// Of a lobe that reflects alone there is nothing where a direction is not above the surface.
template <class Kind>
void check_below(const Kind& lobe) {
    for (const Vec3& below : {Vec3(0, 0, -1), Vec3(right.x, 0, -right.z), Vec3(1, 0, 0)}) {
        INFO("one direction is " << below << ", the other " << right);
        CHECK(test::near_color(evaluate(lobe, below, right), Vec3(0), 0));
        CHECK(test::near_color(evaluate(lobe, right, below), Vec3(0), 0));
        CHECK(near(pdf(lobe, below, right), 0, 0));
        CHECK(near(pdf(lobe, right, below), 0, 0));
    }
}

/// And no light is drawn for a viewer who is not above the surface.
template <class Kind>
void check_nothing_drawn_below(const Kind& lobe) {
    for (const Vec3& below : {Vec3(0, 0, -1), Vec3(right.x, 0, -right.z), Vec3(1, 0, 0)}) {
        INFO("to the viewer " << below << ", who is not above the surface");
        CHECK(or_say(!sample(lobe, below, Vec3(0.25)).has_value(), "light is drawn for him"));
    }
}

inline void check_report(const SampleReport& report) {
    INFO("directions where there should be none, such as " << report.stray);
    CHECK(report.stray.empty());
    INFO("chi-square of " << report.classes << " classes: " << report.statistic << "; right samples exceed "
                          << report.limit << " once in ten million times");
    INFO("worst class: " << report.worst);
    CHECK(report.statistic < report.limit);
}

}  // namespace rt::test
