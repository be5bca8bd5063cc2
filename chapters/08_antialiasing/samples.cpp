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

Vec3 sample_pixel(const World& world, int x, int y, std::span<const PixelSample> samples, RayColor color,
                  Stream stream) {
    // 08.1  Each sample has a colour: that of the ray through the point (x + at.x, y + at.y) of the
    // picture. Return the sum of weight · colour. The camera and `color` draw their random numbers from a
    // copy of `stream` whose number `sample` is i higher for sample i.
    return todo("08.1");
}

std::vector<PixelSample> random_samples(int count, Random random) {
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) samples.push_back({random_point(random), Real(1) / count});
    return samples;
}

std::vector<Stratum> strata(int count) {
    // 08.2  Divide the square into whole_root(count) rows and each row into parts, as the contract
    // says. All parts have the area 1/count. Parts that meet have the same number, to the bit, for the edge
    // between them.
    return todo("08.2");
}

std::vector<PixelSample> regular_samples(int count) {
    // 08.2  One sample in the middle of each stratum, all of equal weight.
    return todo("08.2");
}

std::vector<PixelSample> jittered_samples(int count, Random random) {
    // 08.3  One sample in each stratum, in their order, at a random place: random_point(random)
    // draws a point of the unit square. A stratum contains its low edges but not its high ones. Rounding may
    // put a sample on a high edge: then it belongs on the low one instead.
    return todo("08.3");
}

std::vector<PixelSample> trapezoid_samples(int count) {
    // 08.5  Samples at all corners of m × m cells, row by row, with m = whole_root(max(count, 4)) −
    // 1. Each counts 1/m², half of that on the left or right edge of the pixel, and half again on the upper
    // or lower one.
    return todo("08.5");
}

std::vector<PixelSample> centered_samples(int count) {
    // 08.5  The m² regular samples and then one at (½, ½), all of equal weight, with m =
    // whole_root(max(count, 2) − 1).
    return todo("08.5");
}

}  // namespace rt
