// More samples where the colours of a pixel differ more.
#include "common/render/adaptive.hpp"

#include "chapters/08_antialiasing/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

/// The standard deviation of one sample in each pixel, by `pilot` samples.
std::vector<Real> deviations_by(SampledPicture& picture, int pilot) {
    const std::uint64_t seed = picture.world.sampling.seed;
    std::vector<Real> deviations(picture.pixels.size());
    const auto look = [&](std::size_t i) {
        std::vector<Vec3> colors;
        each_pixel(picture.tiles[i], [&](int x, int y) {
            const std::size_t pixel = picture.index(x, y);
            Stream stream = stream_of(picture.world, {Sampler::Random, pilot}, x, y, pilot_pass, pilot);
            colors.clear();
            for (const PixelSample& sample : random_samples(pilot, random_for(seed, pixel, pilot_pass))) {
                colors.push_back(color_at(picture, x, y, sample.at, stream));
                ++stream.sample;
            }
            ray_counts().camera += static_cast<std::uint64_t>(pilot);
            ray_counts().random_numbers += 2 * static_cast<std::uint64_t>(pilot);
            const Vec3 error = estimate(colors).standard_error;
            const Vec3 squares = error * error;
            const Real found = std::sqrt((squares.x + squares.y + squares.z) * pilot);
            // More samples do not help where a colour is infinite.
            deviations[pixel] = std::isfinite(found) ? found : 0;
        });
    };
    in_parallel(picture.tiles.size(), picture.rays, look, {});
    return deviations;
}

/// The greatest deviation in each pixel and those around it, and at least `least`: an edge that the pilot
/// missed is near others that it found; and nothing is ever quite sure.
std::vector<Real> greatest_around(const SampledPicture& picture, const std::vector<Real>& deviations,
                                  Real least) {
    std::vector<Real> around(deviations.size());
    const View& view = picture.world.view;
    each_pixel({0, 0, view.width, view.height}, [&](int x, int y) {
        Real most = least;
        each_pixel(in_picture(picture, {x - 1, y - 1, x + 2, y + 2}),
                   [&](int i, int j) { most = std::max(most, deviations[picture.index(i, j)]); });
        around[picture.index(x, y)] = most;
    });
    return around;
}

}  // namespace

void adapt_counts(SampledPicture& picture, int pilot, int mean) {
    picture.counts.clear();
    const std::vector<Real> deviations = deviations_by(picture, pilot);
    const std::size_t size = deviations.size();
    const Real average =
        std::accumulate(deviations.begin(), deviations.end(), Real(0)) / static_cast<Real>(size);
    // No pixel gets more than 64 times the mean: what happens in a few pixels is not all of the picture.
    const Real least = std::max(average, *std::max_element(deviations.begin(), deviations.end()) / 64);
    picture.counts = sample_counts(greatest_around(picture, deviations, least),
                                   static_cast<long long>(mean) * static_cast<long long>(size));
}

}  // namespace rt
