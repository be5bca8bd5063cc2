// Pictures of many samples a pixel: of a given number, or until time is over or the error small enough.
#include "common/render/sampled.hpp"

#include "common/math/stopwatch.hpp"
#include "common/render/adaptive.hpp"
#include "common/render/integrators.hpp"
#include "common/render/passes.hpp"
#include "common/render/picture_error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr int passes_wanted = 16;  ///< for a given time or error: so that one more is a small step
constexpr int least_passes = 4;    ///< for a given error: two that agree by chance would end the picture

Real mean_count(std::uint64_t rays, const SampledPicture& picture) {
    return static_cast<Real>(rays) / static_cast<Real>(picture.pixels.size());
}

void report(const RenderOptions& options, Real fraction) {
    if (options.progress) options.progress(std::min(fraction, Real(1)));
}

/// One pass with the samples that the scene asks for.
void make_given(SampledPicture& picture, const RenderOptions& options, RenderResult& result) {
    const Sampling& sampling = picture.world.sampling;
    int count = sampling.count;
    if (sampling.adaptive && count >= 4) {
        const int pilot = std::clamp(count / 4, 1, 8) + 1;
        count -= pilot;
        adapt_counts(picture, pilot, count);
    }
    // A single sample is at the centre.
    const Patterns patterns =
        patterns_for(picture.world, count == 1 ? Sampler::Regular : sampling.sampler, count);
    make_pass(picture, patterns, 0, {}, [&](std::size_t done) {
        report(options, static_cast<Real>(done) / static_cast<Real>(picture.tiles.size()));
    });
    result.samples_per_pixel = mean_count(picture.rays.camera, picture);
    if (options.estimate && result.samples_per_pixel > 1)
        result.rms_error = error_by_probes(picture, patterns).whole();
}

/// Passes until time is over or the error small enough.
struct Passes {
    SampledPicture& picture;
    const RenderOptions& options;
    Stopwatch watch{};
    std::uint64_t last = 0;           ///< number of the last pass
    double pass_seconds = 0;          ///< that one takes, about
    std::uint64_t rays_for_trial{0};  ///< camera rays of passes that were thrown away

    bool is_empty() const { return picture.pixels.front().sum.weight == 0; }

    Patterns patterns_of(int samples) {
        const Sampling& sampling = picture.world.sampling;
        if (sampling.adaptive) adapt_counts(picture, std::clamp(samples / 4, 2, 8), samples);
        return patterns_for(picture.world, sampling.sampler, samples);
    }

    void make_another(const Patterns& patterns, const std::function<bool()>& stop) {
        make_pass(picture, patterns, ++last, stop, {});
    }

    /// The patterns of good passes. The first passes have few samples, and tell how many a good pass has; if
    /// that is more they are thrown away.
    Patterns try_out() {
        const Sampling& sampling = picture.world.sampling;
        Patterns patterns = patterns_of(sampling.adaptive ? 2 : 1);
        const Stopwatch of_pass;
        make_another(patterns, {});
        pass_seconds = of_pass.seconds();
        Real wanted = infinity;
        if (options.error) {
            make_another(patterns, {});
            const Real error = error_of_passes(picture)->sampling * std::sqrt(Real(2));
            const Real power = sampling.sampler == Sampler::Random ? 0.5 : 0.75;
            wanted = std::pow(error / (*options.error * std::sqrt(Real(passes_wanted))), 1 / power);
        }
        if (options.seconds) wanted = std::min(wanted, *options.seconds / (pass_seconds * passes_wanted));
        if (!(wanted >= 2)) return patterns;
        const auto more = static_cast<int>(std::min(wanted, Real(4096)));
        picture.pixels.assign(picture.pixels.size(), {});
        picture.changes.assign(picture.changes.size(), {});
        rays_for_trial = picture.rays.camera;
        pass_seconds *= more;
        return patterns_of(patterns.count * more);
    }

    bool enough() const {
        if (is_empty()) return false;
        if (options.seconds) {
            // A wide filter needs whole passes: the nearer end is taken.
            const double rest = *options.seconds - watch.seconds();
            if (rest <= 0 || (has_wide_filter(picture) && rest < pass_seconds / 2)) return true;
        }
        if (!options.error) return false;
        if (picture.pixels.front().sum.weight < least_passes) return false;
        const std::optional<PictureError> found = error_of_passes(picture);
        if (!found) return false;
        const Real error = found->whole();
        // It does not get better where a colour is infinite, or where textures are averaged over too much.
        if (!std::isfinite(error) || found->sampling <= *options.error / 2) return true;
        report(options, (*options.error / error) * (*options.error / error));
        return error <= *options.error;
    }
};

void make_until(SampledPicture& picture, const RenderOptions& options, RenderResult& result) {
    watch_averaging(picture);
    Passes passes{picture, options};
    const Patterns patterns = passes.try_out();
    const auto late = [&] { return options.seconds && passes.watch.seconds() >= *options.seconds; };
    while (!passes.enough()) {
        // Each pixel gets a colour, however late it is.
        passes.make_another(patterns,
                            passes.is_empty() ? std::function<bool()>() : std::function<bool()>(late));
        if (options.seconds) report(options, passes.watch.seconds() / *options.seconds);
    }
    if (const std::optional<PictureError> error = error_of_passes(picture)) result.rms_error = error->whole();
    result.samples_per_pixel = mean_count(picture.rays.camera - passes.rays_for_trial, picture);
}

}  // namespace

void render_sampled(const World& world, const RenderOptions& options, RenderResult& result) {
    SampledPicture picture(world, options.color ? options.color : color_function(world));
    if (!options.color) picture.unaveraged = unaveraged_color_function(world);
    if (options.seconds || options.error)
        make_until(picture, options, result);
    else
        make_given(picture, options, result);
    result.rays = picture.rays;
    result.counts = std::move(picture.counts);
    result.image = make_image(world.view.width, world.view.height);
    each_pixel({0, 0, world.view.width, world.view.height}, [&](int x, int y) {
        pixel(result.image, x, y) = color_of(picture.pixels[picture.index(x, y)].sum);
    });
}

}  // namespace rt
