// Where the samples of a pixel lie, and the colour that they make.
#include "chapters/08_antialiasing/samples.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The greatest whole number whose square is at most n ≥ 0. The root of a whole number below 2^31 is so far
/// from the next whole number, unless it is one, that rounding never reaches it.
[[maybe_unused]] int whole_root(int n) { return static_cast<int>(std::sqrt(static_cast<Real>(n))); }

}  // namespace

Vec3 sample_pixel(const World& world, int x, int y, std::span<const PixelSample> samples, RayColor color,
                  Stream stream) {
    // [exercise 08.1] Each sample has a colour: that of the ray through the point (x + at.x, y + at.y) of the
    // picture. Return the sum of weight · colour. The camera and `color` draw their random numbers from a
    // copy of `stream` whose number `sample` is i higher for sample i.
    Vec3 sum(0);
    for (const PixelSample& sample : samples) {
        Stream own = stream;
        const Ray ray = camera_ray(world, {x + sample.at.x, y + sample.at.y}, own);
        sum += sample.weight * color(world, ray, own);
        ++stream.sample;
    }
    return sum;
    // [/exercise]
}

std::vector<PixelSample> random_samples(int count, Random random) {
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) samples.push_back({random_point(random), Real(1) / count});
    return samples;
}

std::vector<Stratum> strata(int count) {
    // [exercise 08.2] Divide the square into whole_root(count) rows and each row into parts, as the contract
    // says. All parts have the area 1/count. Parts that meet have the same number, to the bit, for the edge
    // between them.
    std::vector<Stratum> parts;
    parts.reserve(static_cast<std::size_t>(count));
    const int rows = whole_root(count);
    const Real all = count;
    int first = 0;
    for (int row = 1; row <= rows; ++row) {
        const int last = static_cast<int>(static_cast<long long>(row) * count / rows);
        const int columns = last - first;
        for (Real i = 0; i < columns; ++i) {
            parts.push_back({{i / columns, first / all}, {(i + 1) / columns, last / all}});
        }
        first = last;
    }
    return parts;
    // [/exercise]
}

std::vector<PixelSample> regular_samples(int count) {
    // [exercise 08.2] One sample in the middle of each stratum, all of equal weight.
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (const Stratum& part : strata(count)) {
        samples.push_back({(part.low + part.high) / Real(2), Real(1) / count});
    }
    return samples;
    // [/exercise]
}

std::vector<PixelSample> jittered_samples(int count, Random random) {
    // [exercise 08.3] One sample in each stratum, in their order, at a random place: random_point(random)
    // draws a point of the unit square. A stratum contains its low edges but not its high ones. Rounding may
    // put a sample on a high edge: then it belongs on the low one instead.
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (const auto& [low, high] : strata(count)) {
        Vec2 at = low + random_point(random) * (high - low);
        if (at.x >= high.x) at.x = low.x;
        if (at.y >= high.y) at.y = low.y;
        samples.push_back({at, Real(1) / count});
    }
    return samples;
    // [/exercise]
}

std::vector<PixelSample> trapezoid_samples(int count) {
    // [exercise 08.5] Samples at all corners of m × m cells, row by row, with m = whole_root(max(count, 4)) −
    // 1. Each counts 1/m², half of that on the left or right edge of the pixel, and half again on the upper
    // or lower one.
    const int m = whole_root(std::max(count, 4)) - 1;
    const auto part = [m](int i) { return (i == 0 || i == m ? Real(0.5) : Real(1)) / m; };
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>((m + 1) * (m + 1)));
    for (int j = 0; j <= m; ++j) {
        for (int i = 0; i <= m; ++i) samples.push_back({Vec2(i, j) / Real(m), part(i) * part(j)});
    }
    return samples;
    // [/exercise]
}

std::vector<PixelSample> centered_samples(int count) {
    // [exercise 08.5] The m² regular samples and then one at (½, ½), all of equal weight, with m =
    // whole_root(max(count, 2) − 1).
    const int m = whole_root(std::max(count, 2) - 1);
    std::vector<PixelSample> samples = regular_samples(m * m);
    samples.push_back({Vec2(0.5), 0});
    for (PixelSample& sample : samples) sample.weight = Real(1) / (m * m + 1);
    return samples;
    // [/exercise]
}

}  // namespace rt
