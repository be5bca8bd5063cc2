// How wrong a picture of many samples a pixel probably is.
#include "common/render/picture_error.hpp"

#include "chapters/08_antialiasing/estimate.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

Real sum_of(const Vec3& v) { return v.x + v.y + v.z; }

/// A second pattern that tells how wrong a first one is.
struct Probe {
    int count;           ///< of its samples
    std::uint64_t pass;  ///< for which it is made
    Real scale;          ///< by which the variance between the two is that of two independent patterns
};

/// For random patterns one more of the same kind. Patterns that are not random have no independent ones:
/// there it is one of about half as many samples along each axis. With k times as many the error is k² times
/// as small where colours are smooth, k^1.5 times at edges, and as great where everything is aliased; at
/// edges and there the two errors are as good as independent. So the difference is k² − 1, √(k³ + 1) or √2
/// times the first pattern's error, for k = 2 from √2 to 3: the middle, 2.06, is at most 1.46 times wrong.
Probe probe_of(Sampler sampler, int count) {
    const Probe independent{count, probe_pass, 1};
    if (sampler == Sampler::Random || sampler == Sampler::Jittered || sampler == Sampler::Poisson ||
        sampler == Sampler::Sobol)
        return independent;
    const int more = sampler == Sampler::Centered ? 1 : 0;
    const int ends = sampler == Sampler::Trapezoid ? 1 : 0;
    const int side = static_cast<int>(std::sqrt(static_cast<Real>(count - more))) - ends;
    if (side < 2) return independent;  // moved at random
    const int half = (side + 1) / 2;
    const Real k = static_cast<Real>(side) / half;
    const Real smooth = k * k - 1, edges = std::sqrt(k * k * k + 1), aliased = std::sqrt(Real(2));
    return {(half + ends) * (half + ends) + more, 0,
            2 / (std::min(smooth, aliased) * std::max(smooth, edges))};
}

/// The places of probes: a sixteenth of the pixels, or an eighth of the tiles; more of small pictures.
struct Places {
    std::uint64_t seed;
    Real part;

    explicit Places(const SampledPicture& picture) : seed(picture.world.sampling.seed) {
        // Where samples are adaptive, what is left of the error is in few pixels.
        const Real least = picture.world.sampling.adaptive ? 1. / 4 : 1. / 16;
        part = has_wide_filter(picture) ? std::max(1. / 8, 32. / static_cast<Real>(picture.tiles.size()))
                                        : std::max(least, 4096. / static_cast<Real>(picture.pixels.size()));
    }

    /// Whether the pixel or tile number `i` is one.
    bool has(std::uint64_t i) const {
        Random random = random_for(seed, i, choice_pass);
        return random_real(random) < part;
    }
};

/// Square errors of some pixels, over all channels.
struct SquareErrors {
    Real sum = 0;
    std::size_t pixels = 0;

    void take(const Vec3& first, const Vec3& second, Real scale) {
        const Vec3 both[2] = {first, second};
        // The variance of one estimate is twice that of the mean of two.
        const Vec3 error = estimate(both).standard_error;
        sum += 2 * scale * sum_of(error * error);
        ++pixels;
    }
};

}  // namespace

std::optional<Real> error_of_passes(const SampledPicture& picture) {
    Real sum = 0;
    std::size_t counted = 0;
    for (const PassedPixel& pixel : picture.pixels) {
        const Real n = pixel.sum.weight;
        if (n < 2) continue;
        sum += sum_of(pixel.deviations) / (n * (n - 1));
        ++counted;
    }
    if (counted == 0) return std::nullopt;
    return std::sqrt(sum / static_cast<Real>(3 * counted));
}

Real error_by_probes(SampledPicture& picture, const Patterns& patterns) {
    const std::vector<Tile>& tiles = picture.tiles;
    const Probe other = probe_of(patterns.sampler, patterns.count);
    const Patterns probes =
        other.count == patterns.count ? patterns : patterns_for(picture.world, patterns.sampler, other.count);
    const Places places(picture);
    std::vector<SquareErrors> errors(tiles.size());
    const auto probe_tile = [&](std::size_t i) {
        const auto mean = [&](int x, int y) { return picture.pixels[picture.index(x, y)].mean; };
        if (!has_wide_filter(picture)) {
            each_pixel(tiles[i], [&](int x, int y) {
                if (!places.has(picture.index(x, y))) return;
                errors[i].take(mean(x, y), color_of_pixel(picture, probes, x, y, other.pass), other.scale);
            });
        } else if (places.has(i)) {
            const std::vector<FilmPixel> second =
                film_of_tile(picture, probes, reached(picture, tiles[i]), other.pass, tiles[i]);
            auto pixel = second.begin();
            each_pixel(tiles[i],
                       [&](int x, int y) { errors[i].take(mean(x, y), color_of(*pixel++), other.scale); });
        }
    };
    in_parallel(tiles.size(), picture.rays, probe_tile, {});
    SquareErrors all;
    for (const SquareErrors& one : errors) all = {all.sum + one.sum, all.pixels + one.pixels};
    return all.pixels == 0 ? 0 : std::sqrt(all.sum / static_cast<Real>(3 * all.pixels));
}

}  // namespace rt
