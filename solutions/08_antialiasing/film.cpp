// From samples to pixels: filters, and sums that keep what rounding takes away.
#include "chapters/08_antialiasing/film.hpp"

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
    // [exercise 08.7] Return the sum of before.sum and the term as rounding leaves it, and in `lost` all that
    // was lost so far: before.lost, and what the rounding of this sum took away, exactly (Neumaier 1974).
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
    // [exercise 08.6] Return 0 if |offset.x| or |offset.y| is greater than the radius, else f(x)·f(y). With
    // t = |x|/r, from 0 to 1, the four kinds of f are
    //   Box       1
    //   Tent      1 − t
    //   Gaussian  e^(−4.5 t²) − e^(−4.5)
    //   Mitchell  (21 z³ − 36 z² + 16)/18 where z = 2t < 1, else (2 − z)²·(8 − 7z)/18
    const auto along_axis = [&filter](Real x) -> Real {
        const Real t = std::abs(x) / filter.radius;
        const Real z = 2 * t;
        if (filter.kind == FilterKind::Box) return 1;
        if (filter.kind == FilterKind::Tent) return 1 - t;
        if (filter.kind == FilterKind::Gaussian) return std::exp(-4.5 * t * t) - std::exp(-4.5);
        return (z < 1 ? (21 * z - 36) * z * z + 16 : (2 - z) * (2 - z) * (8 - 7 * z)) / 18;
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
    // [exercise 08.7] The weighted mean, from the sums with what they lost. Black if the weights sum to 0.
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

Tile pixels_reached(const Vec2& at, const Filter& filter, const Tile& area) {
    // [exercise 08.8] Which pixels (x, y) of `area` have their centre (x + ½, y + ½) at most the radius away
    // from `at`, along x and along y? Return them as a Tile, whose x1 and y1 are one more than the last
    // column and row. Where a tile begins at its end, there are none.
    const Vec2 low(area.x0, area.y0), high(area.x1, area.y1);
    // Centres are exact, so rounding only ever lets in a pixel too many, and filter_weight finds that out.
    const Vec2 begin = glm::clamp(glm::ceil(at - filter.radius - 0.5), low, high);
    const Vec2 end = glm::clamp(glm::floor(at + filter.radius - 0.5) + 1.0, low, high);
    return {static_cast<int>(begin.x), static_cast<int>(begin.y), static_cast<int>(end.x),
            static_cast<int>(end.y)};
    // [/exercise]
}

std::vector<FilmPixel> film_of(std::span<const FilmSample> samples, const Filter& filter, const Tile& area) {
    // [exercise 08.8] One FilmPixel for each pixel of `area`, row by row; none if the area is empty. `add`
    // each sample to all the pixels that it reaches, with weight sample.weight · filter_weight(at − centre).
    if (area.x0 >= area.x1 || area.y0 >= area.y1) return {};
    const int width = area.x1 - area.x0;
    std::vector<FilmPixel> pixels(static_cast<std::size_t>(width * (area.y1 - area.y0)));
    for (const FilmSample& sample : samples) {
        const Tile reached = pixels_reached(sample.at, filter, area);
        for (int y = reached.y0; y < reached.y1; ++y) {
            for (int x = reached.x0; x < reached.x1; ++x) {
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
