// From samples to pixels: filters, and sums that keep what rounding takes away.
#include "chapters/08_antialiasing/film.hpp"

#include "common/math/todo.hpp"

#include <glm/common.hpp>

#include <cmath>

namespace rt {
namespace {

/// A sum of many numbers, and what rounding took away from it.
struct Sum {
    Real sum = 0;
    Real lost = 0;
};

[[maybe_unused]] Sum plus(const Sum& before, Real term) {
    // 08.7  Return the sum of before.sum and the term as rounding leaves it, and in `lost` all that
    // was lost so far: before.lost, and what the rounding of this sum took away, exactly (Neumaier 1974).
    return todo("08.7");
}

/// `pixel` with a sum of colours and a sum of weights added.
[[maybe_unused]] FilmPixel plus(FilmPixel pixel, const Vec3& color, Real weight) {
    for (int i = 0; i < 3; ++i) {
        const Sum sum = plus(Sum{pixel.sum[i], pixel.lost[i]}, color[i]);
        pixel.sum[i] = sum.sum;
        // An infinite sum has lost nothing that a number could say.
        pixel.lost[i] = std::isfinite(sum.sum) ? sum.lost : 0;
    }
    const Sum sum = plus(Sum{pixel.weight, pixel.lost_weight}, weight);
    pixel.weight = sum.sum;
    pixel.lost_weight = sum.lost;
    return pixel;
}

}  // namespace

Real filter_weight(const Filter& filter, const Vec2& offset) {
    // 08.6  Return 0 if |offset.x| or |offset.y| is greater than the radius, else f(x)·f(y). With
    // t = |x|/r, from 0 to 1, the four kinds of f are
    //   Box       1
    //   Tent      1 − t
    //   Gaussian  e^(−4.5 t²) − e^(−4.5)
    //   Mitchell  (21 z³ − 36 z² + 16)/18 where z = 2t < 1, else (2 − z)²·(8 − 7z)/18
    return todo("08.6");
}

FilmPixel add(const FilmPixel& pixel, const Vec3& color, Real weight) {
    // Nothing of an infinite colour is nothing, not NaN.
    return weight == 0 ? pixel : plus(pixel, weight * color, weight);
}

Vec3 color_of(const FilmPixel& pixel) {
    // 08.7  The weighted mean, from the sums with what they lost. Black if the weights sum to 0.
    return todo("08.7");
}

FilmPixel merge(const FilmPixel& a, const FilmPixel& b) {
    FilmPixel both = plus(a, b.sum, b.weight);
    both.lost += b.lost;
    both.lost_weight += b.lost_weight;
    return both;
}

Tile pixels_reached(const Vec2& at, const Filter& filter, const Tile& area) {
    // 08.8  Which pixels (x, y) of `area` have their centre (x + ½, y + ½) at most the radius away
    // from `at`, along x and along y? Return them as a Tile, whose x1 and y1 are one more than the last
    // column and row. Where a tile begins at its end, there are none.
    return todo("08.8");
}

std::vector<FilmPixel> film_of(std::span<const FilmSample> samples, const Filter& filter, const Tile& area) {
    // 08.8  One FilmPixel for each pixel of `area`, row by row; none if the area is empty. `add`
    // each sample to all the pixels that it reaches, with weight sample.weight · filter_weight(at − centre).
    return todo("08.8");
}

}  // namespace rt
