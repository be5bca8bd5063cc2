// Random numbers that are spread evenly over the samples of a pixel: chapter 12's, as streams ask for them.
#include "chapters/12_distribution/samples.hpp"
#include "chapters/12_distribution/sobol.hpp"
#include "common/world/stream.hpp"

namespace rt {
namespace {

/// What tells one dimension of one picture from another, and one pixel from another unless `shared`.
std::uint64_t key_of(const Stream& stream, bool shared) {
    const std::uint64_t pixel =
        shared ? 0 : std::uint64_t(std::uint32_t(stream.y)) << 32 | std::uint32_t(stream.x);
    return mixed(mixed(mixed(0, stream.seed), pixel), first_stream + stream.dimension);
}

/// The point of the sequence that all pixels share.
Vec2 shared_point(const Stream& stream) {
    const std::uint32_t first = pixel_start(std::uint32_t(stream.x), std::uint32_t(stream.y), stream.count,
                                            mixed(stream.seed, first_stream));
    return sobol_point(first + stream.sample, key_of(stream, true));
}

/// Number `index` of `count` parts.
std::uint32_t part_of(const Stream& stream) {
    return permuted(stream.sample % stream.count, stream.count, key_of(stream, true));
}

}  // namespace

Real spread_real(const Stream& stream) {
    if (stream.spread == Spread::Sobol) return shared_point(stream).x;
    if (stream.spread == Spread::Fixed) return (part_of(stream) + Real(0.5)) / stream.count;
    return stratified_number(stream.sample % stream.count, stream.count, key_of(stream, false));
}

Vec2 spread_point(const Stream& stream) {
    if (stream.spread == Spread::Sobol) return shared_point(stream);
    if (stream.spread == Spread::Fixed) {
        const auto [low, high] = stratum(part_of(stream), stream.count);
        return (low + high) / Real(2);
    }
    return stratified_point(stream.sample % stream.count, stream.count, key_of(stream, false));
}

}  // namespace rt
