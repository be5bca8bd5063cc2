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

std::vector<Stratum> strata(int count) {
    // [exercise 08.1] Divide the square into whole_root(count) rows. Row j of r holds the parts from
    // first = floor(j·count/r) up to, but without, last = floor((j + 1)·count/r). Each part has the area
    // 1/count, so the row reaches from y = first/count to last/count. Side by side in it, its parts divide
    // 0 ≤ x < 1 evenly. Compute each edge with one division, and neighbours agree on where they meet.
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
    // [exercise 08.1] One sample in the middle of each stratum, each with the weight 1/count.
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (const Stratum& part : strata(count)) {
        samples.push_back({(part.low + part.high) / Real(2), Real(1) / count});
    }
    return samples;
    // [/exercise]
}

Vec3 sample_pixel(const World& world, int x, int y, std::span<const PixelSample> samples, RayColor color,
                  Stream stream) {
    // [exercise 08.1] For each sample ask camera_ray for the ray through the point (x + at.x, y + at.y) of
    // the picture, and `color` for the colour along it. Return the sum of weight · colour. Both are handed
    // the sample's own random numbers, and change them: a copy of `stream`, whose number `sample` is then one
    // higher for the next.
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

std::vector<PixelSample> jittered_samples(int count, Random random) {
    // [exercise 08.2] For each stratum in order: one point u of the unit square by random_point(random), and
    // the sample lies at low + u·(high − low). The strata contain their low edges but not their high ones,
    // and the sum may be rounded up to the high edge: then take the low edge in that coordinate.
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
    // [exercise 08.4] With m = whole_root(max(count, 4)) − 1 cells along each side, samples lie at (i/m, j/m)
    // for i and j from 0 to m, row by row. Start from the weight 1/m². Halve it if i is 0 or m, and halve it
    // (once more) if j is.
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
    // [exercise 08.4] With n = whole_root(max(count, 2) − 1): the n² regular samples, then one at (½, ½). All
    // have the weight 1/(n² + 1).
    const int n = whole_root(std::max(count, 2) - 1);
    std::vector<PixelSample> samples = regular_samples(n * n);
    samples.push_back({Vec2(0.5), 0});
    for (PixelSample& sample : samples) sample.weight = Real(1) / (n * n + 1);
    return samples;
    // [/exercise]
}

}  // namespace rt
