// Whether a picture agrees with its reference: the gate of tour and references.
#include "common/evidence/agreement.hpp"

#include "common/image/image.hpp"
#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace rt {
namespace {

bool is_silhouette(std::span<const std::uint64_t> decisions, int width, int height, int x, int y) {
    const auto at = [&](int i, int j) {
        return decisions[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(i)];
    };
    for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i)
            if (at(i, j) != at(x, y)) return true;
    return false;
}

/// Greatest difference of a channel, in steps of 1/65535; a NaN differs from everything by the whole range.
Real steps_between(const Vec3& a, const Vec3& b) {
    Real greatest = 0;
    for (int c = 0; c < 3; ++c) {
        const bool broken = std::isnan(a[c]) || std::isnan(b[c]);
        greatest = std::max(greatest, broken ? 1 : std::abs(displayable(a[c]) - displayable(b[c])));
    }
    return greatest * 65535;
}

void require_same_size(const Image& image, const Image& reference) {
    if (image.width != reference.width || image.height != reference.height)
        throw InputError(fmt::format("the picture has {} x {} pixels and its reference {} x {}", image.width,
                                     image.height, reference.width, reference.height));
}

}  // namespace

Agreement judge_samples(const Image& image, const Image& reference, Real rms_error) {
    require_same_size(image, reference);
    Agreement agreement;
    Real squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        agreement.greatest =
            std::max(agreement.greatest, steps_between(image.pixels[i], reference.pixels[i]));
        const Vec3 difference = image.pixels[i] - reference.pixels[i];
        squares += glm::dot(difference, difference);
    }
    agreement.ratio = std::sqrt(squares / static_cast<Real>(3 * image.pixels.size())) / rms_error;
    agreement.passed = *agreement.ratio <= gate_ratio && *agreement.ratio >= 1 / gate_ratio;
    return agreement;
}

Agreement judge(const Image& image, const Image& reference,
                const std::function<std::vector<std::uint64_t>()>& decisions) {
    require_same_size(image, reference);
    Agreement agreement;
    std::vector<std::size_t> over;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Real steps = steps_between(image.pixels[i], reference.pixels[i]);
        agreement.greatest = std::max(agreement.greatest, steps);
        if (steps > gate_steps) over.push_back(i);
    }
    agreement.over = over.size();
    if (!over.empty()) {
        const std::vector<std::uint64_t> decided = decisions();
        const auto width = static_cast<std::size_t>(image.width);
        for (const std::size_t i : over)
            if (!is_silhouette(decided, image.width, image.height, static_cast<int>(i % width),
                               static_cast<int>(i / width)))
                ++agreement.unexplained;
    }
    agreement.passed = agreement.unexplained == 0 && static_cast<Real>(agreement.over) <=
                                                         gate_share * static_cast<Real>(image.pixels.size());
    return agreement;
}

}  // namespace rt
