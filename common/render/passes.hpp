// Passes over a picture, each of which gives all its pixels new samples, and what is known after them.
#pragma once

#include "chapters/08_antialiasing/film.hpp"
#include "common/render/patterns.hpp"
#include "common/render/tiles.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rt {

/// What is known of a pixel after some passes.
struct PassedPixel {
    FilmPixel sum;       ///< of the passes' colours; its weight is their number
    Vec3 mean{0};        ///< of the passes' colours,
    Vec3 deviations{0};  ///< and the sum of their square deviations from it (Welford 1962)
};

/// A picture of many samples a pixel, in the making.
struct SampledPicture {
    const World& world;
    RayColor color;
    RayCounts rays{};
    std::vector<Tile> tiles;
    std::vector<PassedPixel> pixels;
    RayColor unaveraged = nullptr;  ///< where textures are averaged: the same without that
    /// Of the pixels that are watched, by how much a pass's colours are greater than those of the same
    /// samples by `unaveraged`. Which ones are, or which tiles where the filter is wide, is empty where
    /// nobody asks.
    std::vector<PassedPixel> changes{};
    std::vector<char> is_watched{};
    std::vector<int> counts{};  ///< samples of each pixel in a pass, where they are adaptive; else empty

    SampledPicture(const World& of, RayColor color_of_ray);

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(world.view.width) +
               static_cast<std::size_t>(x);
    }
};

/// Whether pixels also take samples of their neighbours.
bool has_wide_filter(const SampledPicture& picture);

/// Calls visit(x, y) for each pixel of the tile, row by row.
template <class Visit>
void each_pixel(const Tile& tile, Visit visit) {
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) visit(x, y);
}

/// The part of `area` that is in the picture.
Tile in_picture(const SampledPicture& picture, const Tile& area);

/// The tile and all around that its pixels' filter reaches, in the picture.
Tile reached(const SampledPicture& picture, const Tile& tile);

/// A pass over the picture, in which a function colours the rays: mostly the picture's.
struct Pass {
    const Patterns& patterns;
    std::uint64_t number;
    RayColor color;
};

/// The colour of one sample alone, whatever its weight.
Vec3 color_at(const SampledPicture& picture, int x, int y, const Vec2& at, const Stream& stream);

/// The colour of a pixel from its own samples in a pass.
Vec3 color_of_pixel(const SampledPicture& picture, const Pass& pass, int x, int y);

/// Sums for the pixels of `area`, over the samples of those in `sampled`.
std::vector<FilmPixel> film_of_tile(const SampledPicture& picture, const Pass& pass, const Tile& sampled,
                                    const Tile& area);

/// One more colour for each pixel, on all threads of the current arena; where no filter is wide, none for
/// tiles that `stop` forbids. `done` is told the number of finished tiles. Both may be empty.
void make_pass(SampledPicture& picture, const Patterns& patterns, std::uint64_t pass,
               const std::function<bool()>& stop, const std::function<void(std::size_t)>& done);

}  // namespace rt
