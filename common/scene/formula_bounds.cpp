// What is known of an expression in a box, as a rule by interval arithmetic.
#include "common/scene/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rt {
namespace {

/// Calls `see` with x, y and z of each part of the box.
template <class See>
void for_parts(const Vec3& low, const Vec3& high, See see) {
    constexpr int parts = 16;
    const auto end = [&](int i, int axis) {
        return i == parts ? high[axis] : low[axis] + i * ((high[axis] - low[axis]) / parts);
    };
    const auto part = [&](int i, int axis) { return Enclosure{end(i, axis), end(i + 1, axis)}; };
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j)
            for (int k = 0; k < parts; ++k) see(part(i, 0), part(j, 1), part(k, 2));
}

}  // namespace

Real lipschitz_bound(const Formula& f, const Vec3& low, const Vec3& high) {
    Real greatest = 0;
    for_parts(low, high, [&](const Enclosure& x, const Enclosure& y, const Enclosure& z) {
        const Dual<Enclosure, 3> there = with_gradient(f, x, y, z);
        if (is_empty(there.value)) return;
        Enclosure square{0, 0};
        for (const Enclosure& slope : there.slope) square = square + power(slope, 2);
        greatest = std::max(greatest, square.high);
    });
    return greatest < infinity ? rounded_up(std::sqrt(greatest)) : infinity;
}

PartOfBox not_positive(const Formula& f, const Vec3& low, const Vec3& high) {
    PartOfBox part;
    for_parts(low, high, [&](const Enclosure& x, const Enclosure& y, const Enclosure& z) {
        if (!(evaluate(f, x, y, z).low <= 0)) return;
        part.low = glm::min(part.low, Vec3(x.low, y.low, z.low));
        part.high = glm::max(part.high, Vec3(x.high, y.high, z.high));
    });
    return part;
}

Real small_value(const Formula& f, const Vec3& low, const Vec3& high) {
    const auto middle = [](const Enclosure& a) { return a.low + (a.high - a.low) / 2; };
    std::vector<Real> values;
    for_parts(low, high, [&](const Enclosure& x, const Enclosure& y, const Enclosure& z) {
        const Real value = std::abs(value_at(f, Vec3(middle(x), middle(y), middle(z))));
        if (!std::isnan(value)) values.push_back(value);
    });
    if (values.empty()) return 0;
    const auto tenth = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 10);
    std::ranges::nth_element(values, tenth);
    return *tenth;
}

}  // namespace rt
