// What the tests of step 12.18 share: both ways of choosing, and how lights are named.
#pragma once

#include "tests/12_distribution/light_checks.hpp"

#include <array>
#include <string>
#include <variant>

namespace rt::test {

inline constexpr std::array both_ways{LightSampling::Area, LightSampling::Angle};

inline std::string name_of(LightSampling how) {
    return how == LightSampling::Area ? "chosen by area" : "chosen by angle";
}

inline std::string name_of(const AreaLight& light) {
    return std::visit([](const auto& shape) { return show(shape); }, light.shape);
}

}  // namespace rt::test
