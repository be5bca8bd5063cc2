// Shapes so far out that an accelerator is better without them.
#include "common/render/outliers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

/// The middle of three numbers at least: that of an odd number of them.
Real median(std::vector<Real> numbers) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

/// How far each box reaches from where most of them are, along the axis where that is farthest.
std::vector<Real> reaches(const std::vector<Bounds>& bounds) {
    Vec3 center;
    for (int a = 0; a < 3; ++a) {
        std::vector<Real> middles;
        for (const std::size_t i : sample(bounds.size(), 1000))
            middles.push_back(bounds[i].low[a] / 2 + bounds[i].high[a] / 2);
        center[a] = median(middles);
    }
    std::vector<Real> reach;
    reach.reserve(bounds.size());
    for (const Bounds& box : bounds) {
        const Vec3 away = glm::max(glm::abs(box.low - center), glm::abs(box.high - center));
        reach.push_back(max_component(away));
    }
    return reach;
}

}  // namespace

std::vector<std::size_t> sample(std::size_t size, std::size_t count) {
    std::vector<std::size_t> chosen;
    const std::size_t step = std::max<std::size_t>(1, size / std::max<std::size_t>(1, count));
    for (std::size_t i = step / 2; i < size; i += step) chosen.push_back(i);
    return chosen;
}

std::vector<std::uint32_t> outliers(const std::vector<Bounds>& bounds) {
    // To ask one of them costs every ray 1; a box half as large is worth about this much to it.
    constexpr Real octave = 16;
    const std::size_t most = std::min<std::size_t>(64, bounds.size() / 8);
    const std::vector<Real> reach = reaches(bounds);
    std::vector<std::uint32_t> order(bounds.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto farther = [&](std::uint32_t i, std::uint32_t k) { return reach[i] > reach[k]; };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most + 1), order.end(),
                      farther);
    const Real least = reach[order[most]];
    std::size_t best = 0;
    Real best_cost = infinity;
    for (std::size_t k = 0; k <= most; ++k) {
        const Real cost = static_cast<Real>(k) + octave * std::log2(reach[order[k]] / least);
        if (cost < best_cost) best = k, best_cost = cost;
    }
    // A little farther out than the others is no outlier.
    const Real gain = octave * std::log2(reach[order[0]] / least) - best_cost;
    order.resize(gain > 2 * octave ? best : 0);
    std::ranges::sort(order);
    return order;
}

}  // namespace rt
