// What the tests of steps 12.19 and 12.20 share: worlds, and means of many samples.
#pragma once

#include "chapters/12_distribution/distributed.hpp"
#include "common/render/compile.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace rt::test {

/// The world of a scene's text, in which nothing glows by itself that does not say so.
inline World world_with(const std::string& text) {
    const std::string camera = "size 4 4\ncamera 0 0 5 0 0 0 0 1 0 45\nambient 0 0 0\n";
    return compile(parse_scene_text(camera + text, "test.scene"));
}

/// The numbers of sample `index`, independent of all others.
inline Stream stream_number(std::uint64_t seed, int index) {
    return {.seed = seed + case_seed * 0x9e3779b97f4a7c15, .sample = static_cast<std::uint32_t>(index)};
}

/// The mean of many numbers.
struct Mean {
    Real value = 0;
    Real bound = 0;  ///< six times its standard error: chance exceeds it twice in 10⁹ times
};

/// The mean of sample(0), sample(1), …, sample(count − 1), which are jobs that run together.
template <class Sample>
Mean mean_of_samples(int count, const Sample& sample) {
    std::vector<Real> all(static_cast<std::size_t>(count));
    together(all.size(), [&](std::size_t i) { all[i] = sample(static_cast<int>(i)); });
    Real sum = 0, squares = 0;
    for (const Real one : all) {
        sum += one;
        squares += one * one;
    }
    const Real mean = sum / count, variance = std::max(squares / count - mean * mean, Real(0));
    return {mean, 6 * std::sqrt(variance / count) + gamma(count) * std::abs(mean)};
}

}  // namespace rt::test
