// Where the samples of a pixel lie, and what each counts.
#pragma once

#include "chapters/01_ray_casting/raycast.hpp"
#include "common/math/random.hpp"

#include <span>
#include <vector>

namespace rt {

/// One sample of a pixel.
struct PixelSample {
    Vec2 at{0.5};  ///< place in the pixel, from its top left corner: x to the right and y downwards, 0 to 1
    Real weight = 1;  ///< what part of the pixel it stands for; the weights of a pattern sum to 1
};

/// [08.1] Colour of the pixel (x, y) of the picture: the weighted mean of `color` of the rays through its
/// samples. The picture's point (x + at.x, y + at.y) belongs to the sample at `at`. `stream` is the first
/// sample's; of sample i the number `sample` is i higher. The camera asks it first, then `color`.
Vec3 sample_pixel(const World& world, int x, int y, std::span<const PixelSample> samples, RayColor color,
                  Stream stream);

/// `count` samples of equal weight, uniform and independent of each other. Given.
std::vector<PixelSample> random_samples(int count, Random random);

/// A part of the unit square: low ≤ (x, y) < high.
struct Stratum {
    Vec2 low{0};
    Vec2 high{1};
};

/// [08.2] The unit square in `count` ≥ 1 parts of equal area, row by row from the top left. There are
/// floor(√count) rows; row j of r holds the parts from floor(j·count/r) up to floor((j + 1)·count/r), side by
/// side, and is as high as it needs to be for equal areas. For count = n² these are n × n squares.
std::vector<Stratum> strata(int count);

/// [08.2] `count` samples in the middles of the strata, of equal weight.
std::vector<PixelSample> regular_samples(int count);

/// [08.3] `count` samples of equal weight, each uniform in its own stratum: for each stratum in order one
/// random_point (Cook, Porter & Carpenter 1984).
std::vector<PixelSample> jittered_samples(int count, Random random);

/// Distance of two points of the unit square on the torus: right and left edges are joined, and upper and
/// lower ones, as if the pattern were repeated in the neighbouring pixels. Given.
Real torus_distance(const Vec2& a, const Vec2& b);

/// A pattern of samples and the least distance between any two of them, on the torus.
struct PoissonDisk {
    std::vector<PixelSample> samples;
    Real distance = 0;  ///< in pixels; ∞ for a single sample
};

/// [08.4] `count` samples of equal weight, uniform but for this: no two are nearer than the distance
/// returned, which shrinks from 0.7 √(2/(√3·count)) by a factor 0.95 each time 32·count darts in a row were
/// refused (dart throwing, Cook 1986; shrinking as McCool & Fiume 1992). √(2/(√3·count)) is the distance in
/// the densest packing.
PoissonDisk poisson_disk_samples(int count, Random random);

/// [08.5] The trapezoid rule on (m + 1) × (m + 1) corners of m × m cells, row by row: the greatest such m ≥ 1
/// with (m + 1)² ≤ max(count, 4). Samples on the pixel's edges count half, in its corners a quarter.
/// The same as POV-Ray's antialiasing method 2 without its threshold.
std::vector<PixelSample> trapezoid_samples(int count);

/// [08.5] m × m regular samples, then one in the middle, all of equal weight: the greatest m ≥ 1 with m² + 1
/// ≤ max(count, 2). The same as POV-Ray's antialiasing method 1 without its threshold.
std::vector<PixelSample> centered_samples(int count);

/// [08.12] Optional. The digits of index ≥ 0 in this base ≥ 2, mirrored at the point: 6 is 110 in base 2 and
/// becomes 0.011, which is 3/8. In [0, 1), and right to a few roundings.
Real radical_inverse(int index, int base);

/// [08.12] Optional. The first `count` points of Halton's sequence, of equal weight: point i, from 0 on, is
/// radical_inverse(i, 2) across and radical_inverse(i, 3) down. All are moved by the same random_point, on
/// the torus.
std::vector<PixelSample> halton_samples(int count, Random random);

}  // namespace rt
