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
    if (is_random(sampler)) return independent;
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
    Real sampling = 0, averaging = 0;
    std::size_t pixels = 0;

    void take(const Vec3& first, const Vec3& second, Real scale) {
        const Vec3 both[2] = {first, second};
        // The variance of one estimate is twice that of the mean of two.
        const Vec3 error = estimate(both).standard_error;
        sampling += 2 * scale * sum_of(error * error);
        ++pixels;
    }

    /// Two independent estimates of what averaging changes. The mean of their product is the square of what
    /// both are on average, without the noise of either.
    void take_changes(const Vec3& first, const Vec3& second) { averaging += dot(first, second); }

    PictureError means() const {
        if (pixels == 0) return {};
        const Real n = static_cast<Real>(3 * pixels);
        return {std::sqrt(sampling / n), std::sqrt(std::max(Real(0), averaging / n))};
    }
};

/// What other patterns tell of one tile, beside the pass that made the picture.
struct ProbedTile {
    const SampledPicture& picture;
    Pass first, second;
    Real scale;
    /// Two independent passes that tell what averaging changes: those above where they are random.
    Pass change_first, change_second;

    bool has_own_changes() const { return change_first.number != first.number; }
    Pass unaveraged(const Pass& pass) const { return {pass.patterns, pass.number, picture.unaveraged}; }

    SquareErrors by_pixels(const Tile& tile, const Places& places) const {
        SquareErrors errors;
        each_pixel(tile, [&](int x, int y) {
            if (!places.has(picture.index(x, y))) return;
            const auto color = [&](const Pass& pass) { return color_of_pixel(picture, pass, x, y); };
            Vec3 one = picture.pixels[picture.index(x, y)].mean, other = color(second);
            errors.take(one, other, scale);
            if (!picture.unaveraged) return;
            if (has_own_changes()) one = color(change_first), other = color(change_second);
            errors.take_changes(one - color(unaveraged(change_first)),
                                other - color(unaveraged(change_second)));
        });
        return errors;
    }

    SquareErrors by_film(const Tile& tile) const {
        const auto colors = [&](const Pass& pass) {
            std::vector<Vec3> all;
            for (const FilmPixel& pixel : film_of_tile(picture, pass, reached(picture, tile), tile))
                all.push_back(color_of(pixel));
            return all;
        };
        std::vector<Vec3> one, other = colors(second);
        each_pixel(tile, [&](int x, int y) { one.push_back(picture.pixels[picture.index(x, y)].mean); });
        SquareErrors errors;
        for (std::size_t i = 0; i < one.size(); ++i) errors.take(one[i], other[i], scale);
        if (!picture.unaveraged) return errors;
        if (has_own_changes()) one = colors(change_first), other = colors(change_second);
        const std::vector<Vec3> plain_one = colors(unaveraged(change_first)),
                                plain_other = colors(unaveraged(change_second));
        for (std::size_t i = 0; i < one.size(); ++i)
            errors.take_changes(one[i] - plain_one[i], other[i] - plain_other[i]);
        return errors;
    }
};

}  // namespace

Real PictureError::whole() const { return std::hypot(sampling, averaging); }

void watch_averaging(SampledPicture& picture) {
    if (!picture.unaveraged) return;
    const Places places(picture);
    picture.changes.assign(picture.pixels.size(), {});
    picture.is_watched.resize(has_wide_filter(picture) ? picture.tiles.size() : picture.pixels.size());
    for (std::size_t i = 0; i < picture.is_watched.size(); ++i) picture.is_watched[i] = places.has(i);
}

std::optional<PictureError> error_of_passes(const SampledPicture& picture) {
    SquareErrors all, watched;
    for (const PassedPixel& pixel : picture.pixels) {
        const Real n = pixel.sum.weight;
        if (n < 2) continue;
        all.sampling += sum_of(pixel.deviations) / (n * (n - 1));
        ++all.pixels;
    }
    if (all.pixels == 0) return std::nullopt;
    for (const PassedPixel& change : picture.changes) {
        const Real n = change.sum.weight;
        if (n < 2) continue;
        // The square of a mean is too large by the mean's own variance.
        watched.averaging += dot(change.mean, change.mean) - sum_of(change.deviations) / (n * (n - 1));
        ++watched.pixels;
    }
    return PictureError{all.means().sampling, watched.means().averaging};
}

PictureError error_by_probes(SampledPicture& picture, const Patterns& patterns) {
    const Probe other = probe_of(patterns.sampler, patterns.count);
    const Patterns probes =
        other.count == patterns.count ? patterns : patterns_for(picture.world, patterns.sampler, other.count);
    const Places places(picture);
    // What regular patterns alias is the same in the picture and in its probe.
    const bool random = is_random(patterns.sampler);
    const Patterns jittered{Sampler::Jittered, patterns.count};
    const Pass first{patterns, 0, picture.color}, second{probes, other.pass, picture.color};
    const ProbedTile probed{picture,
                            first,
                            second,
                            other.scale,
                            random ? first : Pass{jittered, probe_pass + 1, picture.color},
                            random ? second : Pass{jittered, probe_pass + 2, picture.color}};
    const std::vector<Tile>& tiles = picture.tiles;
    std::vector<SquareErrors> errors(tiles.size());
    const auto probe_tile = [&](std::size_t i) {
        if (!has_wide_filter(picture))
            errors[i] = probed.by_pixels(tiles[i], places);
        else if (places.has(i))
            errors[i] = probed.by_film(tiles[i]);
    };
    in_parallel(tiles.size(), picture.rays, probe_tile, {});
    SquareErrors all;
    for (const SquareErrors& one : errors)
        all = {all.sampling + one.sampling, all.averaging + one.averaging, all.pixels + one.pixels};
    return all.means();
}

}  // namespace rt
