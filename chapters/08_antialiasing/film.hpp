// From samples to pixels: filters, and sums that keep what rounding takes away.
#pragma once

#include "common/scene/sampling.hpp"
#include "common/world/view.hpp"

#include <span>
#include <vector>

namespace rt {

/// [08.6] Weight of a sample that lies `offset` from the pixel's centre, in pixels; 0 where |x| or |y| is
/// greater than the radius. Separable, a product f(x)·f(y) with r the radius:
///   Box       f(x) = 1
///   Tent      f(x) = 1 − |x|/r
///   Gaussian  f(x) = e^(−x²/(2σ²)) − e^(−r²/(2σ²)), σ = r/3: a bell, lowered to reach 0 at r
///   Mitchell  the cubic of Mitchell & Netravali 1988 with B = C = 1/3, stretched to end at r; negative from
///             4r/7 on
Real filter_weight(const Filter& filter, const Vec2& offset);

/// A sum of colours with their weights. The true sums are `sum` + `lost` and `weight` + `lost_weight`,
/// nearly.
struct FilmPixel {
    Vec3 sum{0};
    Vec3 lost{0};  ///< what rounding took away from `sum` so far
    Real weight = 0;
    Real lost_weight = 0;  ///< what rounding took away from `weight`
};

/// [08.7] The sum with weight · color added, by Neumaier's compensated summation (1974): the error of each
/// addition is kept in `lost`, so that it does not grow with the number of samples.
FilmPixel add(const FilmPixel& pixel, const Vec3& color, Real weight);

/// [08.7] The weighted mean: the true sum of colours, divided by that of the weights; black where that is 0.
Vec3 color_of(const FilmPixel& pixel);

/// The sum of two sums, its own rounding error kept. Given.
FilmPixel merge(const FilmPixel& a, const FilmPixel& b);

/// A sample in the picture.
struct FilmSample {
    Vec2 at{0};  ///< in pixels from the picture's top left corner
    Vec3 color{0};
    Real weight = 1;  ///< what area it stands for, in pixels
};

/// [08.8] The pixels of `area` whose centres are at most the filter's radius away from `at`, along x and
/// along y: all of them, and where rounding hides that the filter just ends before it, one column or row
/// more. Where there are none, the tile's x0 ≥ x1 or y0 ≥ y1.
Tile pixels_reached(const Vec2& at, const Filter& filter, const Tile& area);

/// [08.8] Sums over the samples for each pixel of `area`, row by row: each sample is added to every pixel
/// whose filter reaches it, with weight sample.weight · filter_weight(sample.at − the pixel's centre).
/// Samples are added in their order. An empty area has no sums.
std::vector<FilmPixel> film_of(std::span<const FilmSample> samples, const Filter& filter, const Tile& area);

}  // namespace rt
