// Pictures of many samples a pixel, and how wrong they probably are.
#include "common/render/sampled.hpp"

#include "chapters/08_antialiasing/estimate.hpp"
#include "chapters/08_antialiasing/film.hpp"
#include "chapters/08_antialiasing/samples.hpp"
#include "common/render/shade.hpp"
#include "common/render/tiles.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Passes whose samples must be independent have different numbers. Those of a picture are 0, 1, 2, ...
constexpr std::uint64_t probe_pass = std::uint64_t(1) << 40;
constexpr std::uint64_t pilot_pass = std::uint64_t(1) << 41;
constexpr std::uint64_t pattern_pass = std::uint64_t(1) << 42;
constexpr std::uint64_t choice_pass = std::uint64_t(1) << 43;

constexpr std::size_t film_part = 1 << 16;    ///< samples that are put on the film together
constexpr std::size_t poisson_patterns = 64;  ///< that the pixels of a picture share
constexpr int passes_wanted = 16;             ///< for a given time or error: so that one more is a small step
constexpr int least_passes = 4;  ///< for a given error: two that agree by chance would end the picture

/// The patterns of samples that a picture's pixels have.
struct Patterns {
    std::uint64_t seed;
    std::uint64_t width;  ///< of the picture
    Sampler sampler;
    int count;                         ///< samples a pixel
    std::vector<PoissonDisk> poisson;  ///< of `count` samples each

    Patterns(const World& world, Sampler kind, int samples)
        : seed(world.sampling.seed),
          width(static_cast<std::uint64_t>(world.view.width)),
          sampler(kind),
          count(samples) {
        if (sampler != Sampler::Poisson) return;
        for (std::uint64_t i = 0; i < poisson_patterns; ++i)
            poisson.push_back(poisson_disk_samples(count, random_for(seed, i, pattern_pass)));
    }

    std::uint64_t index(int x, int y) const {
        return static_cast<std::uint64_t>(y) * width + static_cast<std::uint64_t>(x);
    }

    /// The pattern of one pixel in one pass; `samples` are as many as `count` unless the picture is adaptive.
    /// Patterns without anything random are moved at random in all passes but number 0.
    std::vector<PixelSample> of(int x, int y, std::uint64_t pass, int samples) const {
        Random random = random_for(seed, index(x, y), pass);
        std::uint64_t& drawn = ray_counts().random_numbers;
        switch (sampler) {
            case Sampler::Random:
                drawn += 2 * static_cast<std::uint64_t>(samples);
                return random_samples(samples, random);
            case Sampler::Jittered:
                drawn += 2 * static_cast<std::uint64_t>(samples);
                return jittered_samples(samples, random);
            case Sampler::Poisson: {
                drawn += 3;
                const std::size_t which = random_index(random, poisson.size());
                return moved(poisson[which].samples, random_point(random));
            }
            case Sampler::Regular:
                return shifted(regular_samples(samples), pass, random);
            case Sampler::Trapezoid:
                return shifted(trapezoid_samples(samples), pass, random);
            case Sampler::Centered:
                return shifted(centered_samples(samples), pass, random);
        }
        return {};
    }

    /// The pattern moved on the torus.
    static std::vector<PixelSample> moved(std::vector<PixelSample> samples, const Vec2& by) {
        for (PixelSample& sample : samples) {
            sample.at += by;
            if (sample.at.x >= 1) sample.at.x -= 1;
            if (sample.at.y >= 1) sample.at.y -= 1;
        }
        return samples;
    }
    static std::vector<PixelSample> shifted(std::vector<PixelSample> samples, std::uint64_t pass,
                                            Random random) {
        if (pass == 0) return samples;
        ray_counts().random_numbers += 2;
        return moved(std::move(samples), random_point(random));
    }
};

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
    if (sampler == Sampler::Random || sampler == Sampler::Jittered || sampler == Sampler::Poisson)
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

/// What is known of a pixel after some passes.
struct Running {
    FilmPixel sum;       ///< of the passes' colours; its weight is their number
    Vec3 mean{0};        ///< of the passes' colours,
    Vec3 deviations{0};  ///< and the sum of their square deviations from it (Welford 1962)

    void take(const Vec3& color) {
        sum = add(sum, color, 1);
        const Vec3 from_old = color - mean;
        mean += from_old / sum.weight;
        deviations += from_old * (color - mean);
    }
};

Real sum_of(const Vec3& v) { return v.x + v.y + v.z; }

struct Picture {
    const World& world;
    const RenderOptions& options;
    RenderResult& result;
    Clock::time_point start = Clock::now();
    RayColor color = color_function(world);
    std::vector<Tile> tiles = tiles_of(world.view);
    std::vector<Running> pixels = std::vector<Running>(size());
    std::vector<int> counts{};  ///< samples of each pixel in a pass, where they are adaptive; else empty

    std::size_t size() const {
        return static_cast<std::size_t>(world.view.width) * static_cast<std::size_t>(world.view.height);
    }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(world.view.width) +
               static_cast<std::size_t>(x);
    }
    bool wide_filter() const {
        return world.sampling.filter.kind != FilterKind::Box || world.sampling.filter.radius != 0.5;
    }
    int margin() const { return static_cast<int>(std::ceil(world.sampling.filter.radius)); }

    /// The part of `area` that is in the picture.
    Tile in_picture(const Tile& area) const {
        return {std::max(area.x0, 0), std::max(area.y0, 0), std::min(area.x1, world.view.width),
                std::min(area.y1, world.view.height)};
    }

    template <class Visit>
    void each_pixel(const Tile& tile, Visit visit) const {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) visit(x, y);
    }

    /// The colour of one sample alone.
    Vec3 color_at(int x, int y, const Vec2& at) const {
        const PixelSample alone{at, 1};
        return sample_pixel(world, x, y, {&alone, 1}, color);
    }

    std::vector<PixelSample> pattern(const Patterns& patterns, int x, int y, std::uint64_t pass) const {
        const std::vector<PixelSample> samples =
            patterns.of(x, y, pass, counts.empty() ? patterns.count : counts[index(x, y)]);
        ray_counts().camera += samples.size();
        return samples;
    }

    /// Sums for the pixels of `area`, over the samples of those in `sampled`.
    std::vector<FilmPixel> film(const Patterns& patterns, const Tile& sampled, std::uint64_t pass,
                                const Tile& area) const {
        std::vector<FilmPixel> sums(static_cast<std::size_t>(width(area)) *
                                    static_cast<std::size_t>(height(area)));
        std::vector<FilmSample> samples;
        // Part by part, so that not all the samples of many are kept at once.
        const auto expose = [&] {
            const std::vector<FilmPixel> part = film_of(samples, world.sampling.filter, area);
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = merge(sums[i], part[i]);
            samples.clear();
        };
        each_pixel(sampled, [&](int x, int y) {
            for (const PixelSample& sample : pattern(patterns, x, y, pass)) {
                const Vec2 at(x + sample.at.x, y + sample.at.y);
                samples.push_back({at, color_at(x, y, sample.at), sample.weight});
            }
            if (samples.size() >= film_part) expose();
        });
        expose();
        return sums;
    }

    void make_pass(const Patterns& patterns, std::uint64_t pass, const std::function<bool()>& stop,
                   const std::function<void(std::size_t)>& done) {
        if (wide_filter())
            make_wide_pass(patterns, pass, done);
        else
            make_box_pass(patterns, pass, stop, done);
    }

    /// One more colour for each pixel, from its own samples; none for tiles that `stop` forbids.
    void make_box_pass(const Patterns& patterns, std::uint64_t pass, const std::function<bool()>& stop,
                       const std::function<void(std::size_t)>& done) {
        in_parallel(
            tiles.size(), result.rays,
            [&](std::size_t i) {
                if (stop && stop()) return;
                each_pixel(tiles[i], [&](int x, int y) {
                    pixels[index(x, y)].take(sample_pixel(world, x, y, pattern(patterns, x, y, pass), color));
                });
            },
            done);
    }

    /// One more colour for each pixel, from all the samples that its filter reaches. Tiles make sums for
    /// their neighbours' pixels too; they are put together in the order of the tiles, so that the number of
    /// threads does not matter.
    void make_wide_pass(const Patterns& patterns, std::uint64_t pass,
                        const std::function<void(std::size_t)>& done) {
        std::vector<std::vector<FilmPixel>> sums(tiles.size());
        const auto area = [&](std::size_t i) { return in_picture(grown(tiles[i], margin())); };
        in_parallel(
            tiles.size(), result.rays,
            [&](std::size_t i) { sums[i] = film(patterns, tiles[i], pass, area(i)); }, done);
        std::vector<FilmPixel> whole(size());
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            auto sum = sums[i].begin();
            each_pixel(area(i), [&](int x, int y) {
                FilmPixel& pixel = whole[index(x, y)];
                pixel = merge(pixel, *sum++);
            });
        }
        for (std::size_t i = 0; i < whole.size(); ++i) pixels[i].take(color_of(whole[i]));
    }

    /// The root mean square error of the mean of the passes, from the variance between them.
    std::optional<Real> error_of_passes() const {
        Real sum = 0;
        std::size_t counted = 0;
        for (const Running& pixel : pixels) {
            const Real n = pixel.sum.weight;
            if (n < 2) continue;
            sum += sum_of(pixel.deviations) / (n * (n - 1));
            ++counted;
        }
        if (counted == 0) return std::nullopt;
        return std::sqrt(sum / static_cast<Real>(3 * counted));
    }

    /// The root mean square error of a picture that is one pass, from second patterns in some places.
    Real error_by_probes(const Patterns& patterns) {
        struct Sum {
            Real squares = 0;
            std::size_t pixels = 0;
        };
        std::vector<Sum> sums(tiles.size());
        const Probe other = probe_of(patterns.sampler, patterns.count);
        const Patterns probes =
            other.count == patterns.count ? patterns : Patterns(world, patterns.sampler, other.count);
        const auto probe = [&](Sum& sum, int x, int y, const Vec3& second) {
            const Vec3 both[2] = {pixels[index(x, y)].mean, second};
            // The variance of one estimate is twice that of the mean of two.
            const Vec3 error = estimate(both).standard_error;
            sum.squares += 2 * other.scale * sum_of(error * error);
            ++sum.pixels;
        };
        const std::uint64_t seed = world.sampling.seed;
        // A sixteenth of the pixels, or an eighth of the tiles; more of small pictures.
        // Where samples are adaptive, what is left of the error is in few pixels.
        const Real least = world.sampling.adaptive ? 1. / 4 : 1. / 16;
        const Real part = wide_filter() ? std::max(1. / 8, 32. / static_cast<Real>(tiles.size()))
                                        : std::max(least, 4096. / static_cast<Real>(size()));
        const auto chosen = [&](std::uint64_t i) {
            Random random = random_for(seed, i, choice_pass);
            return random_real(random) < part;
        };
        in_parallel(tiles.size(), result.rays,
                    [&](std::size_t i) {
                        if (!wide_filter()) {
                            each_pixel(tiles[i], [&](int x, int y) {
                                if (!chosen(patterns.index(x, y))) return;
                                probe(sums[i], x, y,
                                      sample_pixel(world, x, y, pattern(probes, x, y, other.pass), color));
                            });
                        } else if (chosen(i)) {
                            const Tile area = in_picture(grown(tiles[i], margin()));
                            const std::vector<FilmPixel> second = film(probes, area, other.pass, tiles[i]);
                            auto pixel = second.begin();
                            each_pixel(tiles[i],
                                       [&](int x, int y) { probe(sums[i], x, y, color_of(*pixel++)); });
                        }
                    },
                    {});
        Sum total;
        for (const Sum& sum : sums) total = {total.squares + sum.squares, total.pixels + sum.pixels};
        return total.pixels == 0 ? 0 : std::sqrt(total.squares / static_cast<Real>(3 * total.pixels));
    }

    /// The number of samples of each pixel in a pass, `mean` on average, from a pilot of so many samples a
    /// pixel that looks where colours differ. The pilot's own samples are not part of the picture: a mean of
    /// samples that decided their number would be biased (Kirk & Arvo 1991).
    void look_where(int pilot, int mean) {
        counts.clear();
        std::vector<Real> deviation(size());
        in_parallel(tiles.size(), result.rays,
                    [&](std::size_t i) {
                        std::vector<Vec3> colors;
                        each_pixel(tiles[i], [&](int x, int y) {
                            colors.clear();
                            for (const PixelSample& sample : random_samples(
                                     pilot, random_for(world.sampling.seed, index(x, y), pilot_pass))) {
                                colors.push_back(color_at(x, y, sample.at));
                            }
                            ray_counts().camera += static_cast<std::uint64_t>(pilot);
                            ray_counts().random_numbers += 2 * static_cast<std::uint64_t>(pilot);
                            const Vec3 error = estimate(colors).standard_error;
                            const Real found = std::sqrt(sum_of(error * error) * pilot);
                            // More samples do not help where a colour is infinite.
                            deviation[index(x, y)] = std::isfinite(found) ? found : 0;
                        });
                    },
                    {});
        const Real average =
            std::accumulate(deviation.begin(), deviation.end(), Real(0)) / static_cast<Real>(size());
        // No pixel gets more than 64 times the mean: what happens in a few pixels is not all of the picture.
        const Real least = std::max(average, *std::max_element(deviation.begin(), deviation.end()) / 64);
        // An edge that the pilot missed is near others that it found; and nothing is ever quite sure.
        std::vector<Real> around(size());
        each_pixel(in_picture({0, 0, world.view.width, world.view.height}), [&](int x, int y) {
            Real most = least;
            each_pixel(in_picture({x - 1, y - 1, x + 2, y + 2}),
                       [&](int i, int j) { most = std::max(most, deviation[index(i, j)]); });
            around[index(x, y)] = most;
        });
        counts = sample_counts(around, static_cast<long long>(mean) * static_cast<long long>(size()));
    }

    /// One pass with the samples that the scene asks for.
    void make_given() {
        int count = world.sampling.count;
        if (world.sampling.adaptive && count >= 4) {
            const int pilot = std::clamp(count / 4, 1, 8) + 1;
            count -= pilot;
            look_where(pilot, count);
        }
        // A single sample is at the centre.
        const Patterns patterns(world, count == 1 ? Sampler::Regular : world.sampling.sampler, count);
        make_pass(patterns, 0, {}, [&](std::size_t done) {
            report(static_cast<Real>(done) / static_cast<Real>(tiles.size()));
        });
        result.samples_per_pixel = static_cast<Real>(result.rays.camera) / static_cast<Real>(size());
        if (options.estimate && result.samples_per_pixel > 1) result.rms_error = error_by_probes(patterns);
    }

    /// Passes until time is over or the error small enough.
    void make_until() {
        const bool adaptive = world.sampling.adaptive;
        const auto patterns_of = [&](int samples) {
            if (adaptive) look_where(std::clamp(samples / 4, 2, 8), samples);
            return Patterns(world, world.sampling.sampler, samples);
        };
        // The first passes have few samples, and tell how many a good pass has. If that is more they are
        // thrown away.
        std::uint64_t before = 0;
        Patterns patterns = patterns_of(adaptive ? 2 : 1);
        std::uint64_t pass = 0;
        const auto make_another = [&](const std::function<bool()>& stop) {
            make_pass(patterns, ++pass, stop, {});
        };
        const double pass_start = seconds_since(start);
        make_another({});
        double pass_seconds = seconds_since(start) - pass_start;
        Real wanted = infinity;
        if (options.error) {
            make_another({});
            const Real error = *error_of_passes() * std::sqrt(Real(2));
            const Real power = world.sampling.sampler == Sampler::Random ? 0.5 : 0.75;
            wanted = std::pow(error / (*options.error * std::sqrt(Real(passes_wanted))), 1 / power);
        }
        if (options.seconds) wanted = std::min(wanted, *options.seconds / (pass_seconds * passes_wanted));
        if (wanted >= 2) {
            const auto more = static_cast<int>(std::min(wanted, Real(4096)));
            pixels.assign(size(), {});
            before = result.rays.camera;
            patterns = patterns_of(patterns.count * more);
            pass_seconds *= more;
        }
        const auto late = [&] { return options.seconds && seconds_since(start) >= *options.seconds; };
        while (!enough(pass_seconds)) {
            // Each pixel gets a colour, however late it is.
            const bool first = pixels.front().sum.weight == 0;
            make_another(first ? std::function<bool()>() : std::function<bool()>(late));
            if (options.seconds) report(seconds_since(start) / *options.seconds);
        }
        result.rms_error = error_of_passes();
        result.samples_per_pixel = static_cast<Real>(result.rays.camera - before) / static_cast<Real>(size());
    }

    bool enough(double pass_seconds) const {
        if (pixels.front().sum.weight == 0) return false;
        if (options.seconds) {
            // A wide filter needs whole passes: the nearer end is taken.
            const double rest = *options.seconds - seconds_since(start);
            if (rest <= 0 || (wide_filter() && rest < pass_seconds / 2)) return true;
        }
        if (!options.error) return false;
        if (pixels.front().sum.weight < least_passes) return false;
        const std::optional<Real> error = error_of_passes();
        // It does not get better where a colour is infinite.
        if (error && !std::isfinite(*error)) return true;
        if (error) report(std::min((*options.error / *error) * (*options.error / *error), Real(1)));
        return error && *error <= *options.error;
    }

    void report(Real fraction) const {
        if (options.progress) options.progress(std::min(fraction, Real(1)));
    }
};

}  // namespace

void render_sampled(const World& world, const RenderOptions& options, RenderResult& result) {
    Picture picture{world, options, result};
    if (options.seconds || options.error)
        picture.make_until();
    else
        picture.make_given();
    result.counts = std::move(picture.counts);
    result.image = make_image(world.view.width, world.view.height);
    for (int y = 0; y < result.image.height; ++y)
        for (int x = 0; x < result.image.width; ++x)
            pixel(result.image, x, y) = color_of(picture.pixels[picture.index(x, y)].sum);
}

}  // namespace rt
