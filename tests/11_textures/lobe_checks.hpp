// What the tests of lobes share.
#pragma once

#include "tests/catch.hpp"
#include "tests/stability/lobe_charts.hpp"

namespace rt::test {

inline bool is_valid(const Vec3& f) { return is_finite(f) && f.x >= 0 && f.y >= 0 && f.z >= 0; }

inline void check_report(const SampleReport& report) {
    INFO("directions where there should be none, such as " << report.stray);
    CHECK(report.stray.empty());
    INFO("chi-square of " << report.classes << " classes: " << report.statistic << "; right samples exceed "
                          << report.limit << " once in ten million times");
    INFO("worst class: " << report.worst);
    CHECK(report.statistic < report.limit);
}

}  // namespace rt::test
