// Where the samples of a pixel lie, and the colour that they make.
#include "chapters/08_antialiasing/samples.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// The greatest whole number whose square is at most n ≥ 0. The root of a whole number below 2^31 is so far
/// from the next whole number, unless it is one, that rounding never reaches it.
[[maybe_unused]] int whole_root(int n) { return static_cast<int>(std::sqrt(static_cast<Real>(n))); }

}  // namespace

std::vector<Stratum> strata(int count) {
    // 08.1  Divide the square into whole_root(count) rows. Row j of r holds the parts from
    // first = floor(j·count/r) up to, but without, last = floor((j + 1)·count/r). Each part has the area
    // 1/count, so the row reaches from y = first/count to last/count. Side by side in it, its parts divide
    // 0 ≤ x < 1 evenly. Compute each edge with one division, and neighbours agree on where they meet.
    return todo("08.1");
}

std::vector<PixelSample> regular_samples(int count) {
    // 08.1  One sample in the middle of each stratum, each with the weight 1/count.
    return todo("08.1");
}

Vec3 sample_pixel(const World& world, int x, int y, std::span<const PixelSample> samples, RayColor color,
                  Stream stream) {
    // 08.1  For each sample ask camera_ray for the ray through the point (x + at.x, y + at.y) of
    // the picture, and `color` for the colour along it. Return the sum of weight · colour. Both are handed
    // the sample's own random numbers, and change them: a copy of `stream`, whose number `sample` is then one
    // higher for the next.
    return todo("08.1");
}

std::vector<PixelSample> random_samples(int count, Random random) {
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) samples.push_back({random_point(random), Real(1) / count});
    return samples;
}

std::vector<PixelSample> jittered_samples(int count, Random random) {
    // 08.2  For each stratum in order: one point u of the unit square by random_point(random), and
    // the sample lies at low + u·(high − low). The strata contain their low edges but not their high ones,
    // and the sum may be rounded up to the high edge: then take the low edge in that coordinate.
    return todo("08.2");
}

std::vector<PixelSample> trapezoid_samples(int count) {
    // 08.4  With m = whole_root(max(count, 4)) − 1 cells along each side, samples lie at (i/m, j/m)
    // for i and j from 0 to m, row by row. Start from the weight 1/m². Halve it if i is 0 or m, and halve it
    // (once more) if j is.
    return todo("08.4");
}

std::vector<PixelSample> centered_samples(int count) {
    // 08.4  With n = whole_root(max(count, 2) − 1): the n² regular samples, then one at (½, ½). All
    // have the weight 1/(n² + 1).
    return todo("08.4");
}

}  // namespace rt
