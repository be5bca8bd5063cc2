// The patterns of samples that the pixels of a picture have, pass by pass.
#include "common/render/patterns.hpp"

namespace rt {
namespace {

constexpr std::uint64_t poisson_patterns = 64;

/// The pattern moved on the torus.
std::vector<PixelSample> moved(std::vector<PixelSample> samples, const Vec2& by) {
    for (PixelSample& sample : samples) {
        sample.at += by;
        if (sample.at.x >= 1) sample.at.x -= 1;
        if (sample.at.y >= 1) sample.at.y -= 1;
    }
    return samples;
}

/// A pattern that is not random is the same in all pixels; only further passes move it.
std::vector<PixelSample> shifted(std::vector<PixelSample> samples, std::uint64_t pass, Random random) {
    if (pass == 0) return samples;
    ray_counts().random_numbers += 2;
    return moved(std::move(samples), random_point(random));
}

/// How all else of the samples of a pixel is spread whose places are of this kind.
Spread spread_of(Sampler sampler) {
    switch (sampler) {
        case Sampler::Random:
            return Spread::Independent;
        case Sampler::Jittered:
        case Sampler::Poisson:
            return Spread::Stratified;
        case Sampler::Regular:
        case Sampler::Trapezoid:
        case Sampler::Centered:
            return Spread::Fixed;
        case Sampler::Sobol:
            return Spread::Sobol;
    }
    return Spread::Independent;
}

/// The numbers that place the samples on scrambled Sobol' points: the first two of their streams.
std::vector<PixelSample> sobol_samples(Stream stream) {
    std::vector<PixelSample> samples;
    for (std::uint32_t i = 0; i < stream.count; ++i, ++stream.sample)
        samples.push_back({spread_point(stream), Real(1) / stream.count});
    return samples;
}

}  // namespace

Patterns patterns_for(const World& world, Sampler sampler, int count) {
    Patterns patterns{sampler, count};
    if (sampler == Sampler::Poisson)
        for (std::uint64_t i = 0; i < poisson_patterns; ++i)
            patterns.poisson.push_back(
                poisson_disk_samples(count, random_for(world.sampling.seed, i, pattern_pass)));
    return patterns;
}

std::vector<PixelSample> pattern_of(const World& world, const Patterns& patterns, int x, int y,
                                    std::uint64_t pass, int samples) {
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(world.view.width) +
                                static_cast<std::uint64_t>(x);
    Random random = random_for(world.sampling.seed, pixel, pass);
    std::uint64_t& drawn = ray_counts().random_numbers;
    switch (patterns.sampler) {
        case Sampler::Random:
            drawn += 2 * static_cast<std::uint64_t>(samples);
            return random_samples(samples, random);
        case Sampler::Jittered:
            drawn += 2 * static_cast<std::uint64_t>(samples);
            return jittered_samples(samples, random);
        case Sampler::Poisson: {
            drawn += 3;
            const std::size_t which = random_index(random, patterns.poisson.size());
            return moved(patterns.poisson[which].samples, random_point(random));
        }
        case Sampler::Regular:
            return shifted(regular_samples(samples), pass, random);
        case Sampler::Trapezoid:
            return shifted(trapezoid_samples(samples), pass, random);
        case Sampler::Centered:
            return shifted(centered_samples(samples), pass, random);
        case Sampler::Sobol:
            drawn += 2 * static_cast<std::uint64_t>(samples);
            return sobol_samples(stream_of(world, patterns, x, y, pass, samples));
    }
    return {};
}

Stream stream_of(const World& world, const Patterns& patterns, int x, int y, std::uint64_t pass,
                 int samples) {
    Stream stream = stream_of(world, x, y);
    if (pass != 0) stream.seed = mixed(stream.seed, pass);
    stream.count = static_cast<std::uint32_t>(samples);
    // A single sample is at the centre, whatever the scene says; all else about it is as the scene says.
    stream.spread = spread_of(samples == 1 ? world.sampling.sampler : patterns.sampler);
    // A pattern that is not random is moved by further passes, which would be of no use if they had the same
    // numbers.
    if (stream.spread == Spread::Fixed && pass != 0) stream.spread = Spread::Stratified;
    return stream;
}

}  // namespace rt
