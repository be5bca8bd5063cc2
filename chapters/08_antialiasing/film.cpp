// From samples to pixels: filters, and sums that keep what rounding takes away.
#include "chapters/08_antialiasing/film.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// A sum of many numbers, and what rounding took away from it.
struct Sum {
    Real sum = 0;
    Real lost = 0;
};

[[maybe_unused]] Sum plus(const Sum& before, Real term) {
    // 08.6  Add the term to before.sum. What did rounding take away? Of the two numbers that were
    // added, the greater (by its absolute value) lost nothing: subtract the new sum from it and what comes
    // out, exactly, is minus the part of the smaller that arrived. Add the smaller, and you have the part
    // that did not. It is added to `lost` (Neumaier 1974).
    return todo("08.6");
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
    // 08.5  Return 0 if |offset.x| or |offset.y| is greater than the radius, else f(x)·f(y). With
    // t = |x|/r, from 0 to 1, the four kinds of f are
    //   Box       1
    //   Tent      1 − t
    //   Gaussian  e^(−4.5 t²) − e^(−4.5)
    //   Mitchell  (21 s³ − 36 s² + 16)/18 where s = 2t < 1, else (2 − s)²·(8 − 7s)/18
    return todo("08.5");
}

FilmPixel add(const FilmPixel& pixel, const Vec3& color, Real weight) {
    // Nothing of an infinite colour is nothing, not NaN.
    return weight == 0 ? pixel : plus(pixel, weight * color, weight);
}

Vec3 color_of(const FilmPixel& pixel) {
    // 08.6  What rounding took away comes back here: (sum + lost)/(weight + lost_weight). Where no
    // sample arrived that weight is 0, and the colour black.
    return todo("08.6");
}

FilmPixel merge(const FilmPixel& a, const FilmPixel& b) {
    FilmPixel both = plus(a, b.sum, b.weight);
    both.lost += b.lost;
    both.lost_weight += b.lost_weight;
    return both;
}

std::vector<FilmPixel> film_of(std::span<const FilmSample> samples, const Filter& filter, const Tile& area) {
    // 08.6  One FilmPixel for each pixel of `area`, row by row. The centre of the pixel (x, y) is
    // (x + ½, y + ½), and the filter reaches `radius` to each side: so a sample reaches the columns from
    // ceil(at.x − radius − ½) to floor(at.x + radius − ½), and the rows likewise; those outside the area do
    // not count. `add` it to each of these pixels, with weight sample.weight · filter_weight(at − centre).
    return todo("08.6");
}

}  // namespace rt
