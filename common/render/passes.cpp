// Passes over a picture, each of which gives all its pixels new samples.
#include "common/render/passes.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr std::size_t film_part = 1 << 16;  ///< samples that are put on the film together

int margin(const SampledPicture& picture) {
    return static_cast<int>(std::ceil(picture.world.sampling.filter.radius));
}

int count_of(const SampledPicture& picture, const Patterns& patterns, int x, int y) {
    return picture.counts.empty() ? patterns.count : picture.counts[picture.index(x, y)];
}

/// The random numbers of the pixel's first sample.
Stream stream_of(const SampledPicture& picture, const Patterns& patterns, int x, int y, std::uint64_t pass) {
    return stream_of(picture.world, patterns, x, y, pass, count_of(picture, patterns, x, y));
}

/// The pixel's samples, counted as camera rays.
std::vector<PixelSample> samples_of(const SampledPicture& picture, const Patterns& patterns, int x, int y,
                                    std::uint64_t pass) {
    const int count = count_of(picture, patterns, x, y);
    std::vector<PixelSample> samples = pattern_of(picture.world, patterns, x, y, pass, count);
    ray_counts().camera += samples.size();
    return samples;
}

void take(PassedPixel& pixel, const Vec3& color) {
    pixel.sum = add(pixel.sum, color, 1);
    const Vec3 from_old = color - pixel.mean;
    pixel.mean += from_old / pixel.sum.weight;
    pixel.deviations += from_old * (color - pixel.mean);
}

bool watches(const SampledPicture& picture, std::size_t i) {
    return !picture.is_watched.empty() && picture.is_watched[i];
}

/// What `of`, a function of the pass, returns if textures are not averaged. These camera rays are none of the
/// picture's samples.
template <class Of>
auto unaveraged(const SampledPicture& picture, const Pass& pass, const Of& of) {
    const std::uint64_t samples = ray_counts().camera;
    const auto result = of(Pass{pass.patterns, pass.number, picture.unaveraged});
    ray_counts().camera = samples;
    return result;
}

/// Each pixel takes the mean of its own samples.
void make_box_pass(SampledPicture& picture, const Patterns& patterns, std::uint64_t number,
                   const std::function<bool()>& stop, const std::function<void(std::size_t)>& done) {
    const Pass pass{patterns, number, picture.color};
    in_parallel(
        picture.tiles.size(), picture.rays,
        [&](std::size_t i) {
            if (stop && stop()) return;
            each_pixel(picture.tiles[i], [&](int x, int y) {
                const std::size_t at = picture.index(x, y);
                const auto color_of_this = [&](const Pass& of) { return color_of_pixel(picture, of, x, y); };
                const Vec3 color = color_of_this(pass);
                take(picture.pixels[at], color);
                if (watches(picture, at))
                    take(picture.changes[at], color - unaveraged(picture, pass, color_of_this));
            });
        },
        done);
}

/// Each pixel takes the mean of all the samples that its filter reaches. Tiles make sums for their
/// neighbours' pixels too; they are put together in the order of the tiles, so that the number of threads
/// does not matter.
void make_wide_pass(SampledPicture& picture, const Patterns& patterns, std::uint64_t number,
                    const std::function<void(std::size_t)>& done) {
    const Pass pass{patterns, number, picture.color};
    const std::vector<Tile>& tiles = picture.tiles;
    std::vector<std::vector<FilmPixel>> sums(tiles.size());
    in_parallel(
        tiles.size(), picture.rays,
        [&](std::size_t i) { sums[i] = film_of_tile(picture, pass, tiles[i], reached(picture, tiles[i])); },
        done);
    std::vector<FilmPixel> whole(picture.pixels.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        auto sum = sums[i].begin();
        each_pixel(reached(picture, tiles[i]), [&](int x, int y) {
            FilmPixel& pixel = whole[picture.index(x, y)];
            pixel = merge(pixel, *sum++);
        });
    }
    for (std::size_t i = 0; i < whole.size(); ++i) take(picture.pixels[i], color_of(whole[i]));
    if (picture.is_watched.empty()) return;
    in_parallel(tiles.size(), picture.rays,
                [&](std::size_t i) {
                    if (!watches(picture, i)) return;
                    const std::vector<FilmPixel> other = unaveraged(picture, pass, [&](const Pass& of) {
                        return film_of_tile(picture, of, reached(picture, tiles[i]), tiles[i]);
                    });
                    auto sum = other.begin();
                    each_pixel(tiles[i], [&](int x, int y) {
                        const std::size_t at = picture.index(x, y);
                        take(picture.changes[at], color_of(whole[at]) - color_of(*sum++));
                    });
                },
                {});
}

}  // namespace

SampledPicture::SampledPicture(const World& of, RayColor color_of_ray)
    : world(of),
      color(color_of_ray),
      tiles(tiles_of(of.view)),
      pixels(static_cast<std::size_t>(of.view.width) * static_cast<std::size_t>(of.view.height)) {}

bool has_wide_filter(const SampledPicture& picture) { return !takes_its_own(picture.world.sampling.filter); }

Tile in_picture(const SampledPicture& picture, const Tile& area) {
    const View& view = picture.world.view;
    return {std::max(area.x0, 0), std::max(area.y0, 0), std::min(area.x1, view.width),
            std::min(area.y1, view.height)};
}

Tile reached(const SampledPicture& picture, const Tile& tile) {
    return in_picture(picture, grown(tile, margin(picture)));
}

Vec3 color_at(const SampledPicture& picture, int x, int y, const Vec2& at, const Stream& stream) {
    const PixelSample alone{at, 1};
    return sample_pixel(picture.world, x, y, {&alone, 1}, picture.color, stream);
}

Vec3 color_of_pixel(const SampledPicture& picture, const Pass& pass, int x, int y) {
    return sample_pixel(picture.world, x, y, samples_of(picture, pass.patterns, x, y, pass.number),
                        pass.color, stream_of(picture, pass.patterns, x, y, pass.number));
}

std::vector<FilmPixel> film_of_tile(const SampledPicture& picture, const Pass& pass, const Tile& sampled,
                                    const Tile& area) {
    std::vector<FilmPixel> sums(static_cast<std::size_t>(width(area)) *
                                static_cast<std::size_t>(height(area)));
    std::vector<FilmSample> samples;
    // Part by part, so that not all the samples of many are kept at once.
    const auto expose = [&] {
        const std::vector<FilmPixel> part = film_of(samples, picture.world.sampling.filter, area);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = merge(sums[i], part[i]);
        samples.clear();
    };
    each_pixel(sampled, [&](int x, int y) {
        Stream stream = stream_of(picture, pass.patterns, x, y, pass.number);
        for (const PixelSample& sample : samples_of(picture, pass.patterns, x, y, pass.number)) {
            const PixelSample alone{sample.at, 1};
            const Vec3 color = sample_pixel(picture.world, x, y, {&alone, 1}, pass.color, stream);
            samples.push_back({Vec2(x + sample.at.x, y + sample.at.y), color, sample.weight});
            ++stream.sample;
        }
        if (samples.size() >= film_part) expose();
    });
    expose();
    return sums;
}

void make_pass(SampledPicture& picture, const Patterns& patterns, std::uint64_t pass,
               const std::function<bool()>& stop, const std::function<void(std::size_t)>& done) {
    if (has_wide_filter(picture))
        make_wide_pass(picture, patterns, pass, done);
    else
        make_box_pass(picture, patterns, pass, stop, done);
}

}  // namespace rt
