// Points that fill the square evenly, however many there are: Halton's sequence.
#include "chapters/08_antialiasing/samples.hpp"

#include <glm/common.hpp>

#include <cmath>

namespace rt {

Real radical_inverse(int index, int base) {
    // [exercise 08.12] The digits of the index in this base, mirrored at the point: the last digit of the
    // index becomes the first one after the point.
    long long mirrored = 0, scale = 1;
    for (; index > 0; index /= base) {
        mirrored = mirrored * base + index % base;
        scale *= base;
    }
    return static_cast<Real>(mirrored) / static_cast<Real>(scale);
    // [/exercise]
}

std::vector<PixelSample> halton_samples(int count, Random random) {
    // [exercise 08.12] `count` samples of equal weight at Halton's points, whose coordinates are the radical
    // inverses of 0, 1, 2 … in the bases 2 and 3. All are moved by one random_point(random), and those that
    // leave the pixel come in again on the other side.
    std::vector<PixelSample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    const Vec2 by = random_point(random);
    for (int i = 0; i < count; ++i) {
        const Vec2 point(radical_inverse(i, 2), radical_inverse(i, 3));
        samples.push_back({glm::fract(point + by), Real(1) / count});
    }
    return samples;
    // [/exercise]
}

}  // namespace rt
