// What programs that write scenes share: the same text on every machine.
#pragma once

#include "common/math/vec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace rt {

/// Rounded to `decimals`, without trailing zeros; the last bits of a machine's sine do not show.
inline std::string number(Real x, int decimals = 2) {
    const Real unit = std::pow(Real(10), decimals);
    // Adding zero makes -0 a 0.
    return fmt::format("{:.10g}", std::round(x * unit) / unit + 0.0);
}

inline std::string line(std::string_view word, const Vec3& v, int decimals = 2) {
    return fmt::format("{} {} {} {}\n", word, number(v.x, decimals), number(v.y, decimals),
                       number(v.z, decimals));
}

/// A number in [0, 1) that looks random (a hash by multiplication and shifts).
inline Real scatter(std::uint32_t i) {
    i = (i ^ (i >> 16)) * 0x7feb352du;
    i = (i ^ (i >> 15)) * 0x846ca68bu;
    return static_cast<Real>(i ^ (i >> 16)) * 0x1p-32;
}

}  // namespace rt
