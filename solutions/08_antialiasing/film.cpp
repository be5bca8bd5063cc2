// From samples to pixels: filters, and sums that keep what rounding takes away.
#include "chapters/08_antialiasing/film.hpp"

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
    // [exercise 08.6] Add the term to before.sum. What did rounding take away? Of the two numbers that were
    // added, the greater (by its absolute value) lost nothing: subtract the new sum from it and what comes
    // out, exactly, is minus the part of the smaller that arrived. Add the smaller, and you have the part
    // that did not. It is added to `lost` (Neumaier 1974).
    const Real sum = before.sum + term;
    const bool grows = std::abs(term) > std::abs(before.sum);
    const Real greater = grows ? term : before.sum, smaller = grows ? before.sum : term;
    return {sum, before.lost + ((greater - sum) + smaller)};
    // [/exercise]
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
    // [exercise 08.5] Return 0 if |offset.x| or |offset.y| is greater than the radius, else f(x)·f(y). With
    // t = |x|/r, from 0 to 1, the four kinds of f are
    //   Box       1
    //   Tent      1 − t
    //   Gaussian  e^(−4.5 t²) − e^(−4.5)
    //   Mitchell  (21 s³ − 36 s² + 16)/18 where s = 2t < 1, else (2 − s)²·(8 − 7s)/18
    const auto along_axis = [&filter](Real x) -> Real {
        const Real t = std::abs(x) / filter.radius;
        const Real s = 2 * t;
        if (filter.kind == FilterKind::Box) return 1;
        if (filter.kind == FilterKind::Tent) return 1 - t;
        if (filter.kind == FilterKind::Gaussian) return std::exp(-4.5 * t * t) - std::exp(-4.5);
        return (s < 1 ? (21 * s - 36) * s * s + 16 : (2 - s) * (2 - s) * (8 - 7 * s)) / 18;
    };
    if (std::abs(offset.x) > filter.radius || std::abs(offset.y) > filter.radius) return 0;
    return along_axis(offset.x) * along_axis(offset.y);
    // [/exercise]
}

FilmPixel add(const FilmPixel& pixel, const Vec3& color, Real weight) {
    // Nothing of an infinite colour is nothing, not NaN.
    return weight == 0 ? pixel : plus(pixel, weight * color, weight);
}

Vec3 color_of(const FilmPixel& pixel) {
    // [exercise 08.6] What rounding took away comes back here: (sum + lost)/(weight + lost_weight). Where no
    // sample arrived that weight is 0, and the colour black.
    const Real weight = pixel.weight + pixel.lost_weight;
    return weight == 0 ? Vec3(0) : (pixel.sum + pixel.lost) / weight;
    // [/exercise]
}

FilmPixel merge(const FilmPixel& a, const FilmPixel& b) {
    FilmPixel both = plus(a, b.sum, b.weight);
    both.lost += b.lost;
    both.lost_weight += b.lost_weight;
    return both;
}

std::vector<FilmPixel> film_of(std::span<const FilmSample> samples, const Filter& filter, const Tile& area) {
    // [exercise 08.6] One FilmPixel for each pixel of `area`, row by row. The centre of the pixel (x, y) is
    // (x + ½, y + ½), and the filter reaches `radius` to each side: so a sample reaches the columns from
    // ceil(at.x − radius − ½) to floor(at.x + radius − ½), and the rows likewise; those outside the area do
    // not count. `add` it to each of these pixels, with weight sample.weight · filter_weight(at − centre).
    if (area.x0 >= area.x1 || area.y0 >= area.y1) return {};
    const int width = area.x1 - area.x0;
    std::vector<FilmPixel> pixels(static_cast<std::size_t>(width * (area.y1 - area.y0)));
    // Centres are exact, so rounding only ever lets in a pixel too many, and filter_weight finds that out.
    const auto first = [&filter](Real at, int begin, int end) {
        return static_cast<int>(std::clamp(std::ceil(at - filter.radius - 0.5), Real(begin), Real(end)));
    };
    const auto last = [&filter](Real at, int begin, int end) {
        return static_cast<int>(
            std::clamp(std::floor(at + filter.radius - 0.5), Real(begin) - 1, Real(end) - 1));
    };
    for (const FilmSample& sample : samples) {
        const int x0 = first(sample.at.x, area.x0, area.x1), x1 = last(sample.at.x, area.x0, area.x1);
        const int y0 = first(sample.at.y, area.y0, area.y1), y1 = last(sample.at.y, area.y0, area.y1);
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                FilmPixel& pixel = pixels[static_cast<std::size_t>((y - area.y0) * width + (x - area.x0))];
                const Real weight = filter_weight(filter, sample.at - Vec2(x + 0.5, y + 0.5));
                pixel = add(pixel, sample.color, sample.weight * weight);
            }
        }
    }
    return pixels;
    // [/exercise]
}

}  // namespace rt
