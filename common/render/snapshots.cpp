// The snapshots of which a blurred picture is the mean.
#include "common/render/snapshots.hpp"

#include "chapters/12_distribution/area_light.hpp"
#include "chapters/12_distribution/lens.hpp"
#include "chapters/12_distribution/samples.hpp"
#include "common/render/compile.hpp"
#include "common/render/patterns.hpp"
#include "common/world/query.hpp"

namespace rt {
namespace {

/// As visit_area_light (common/render/area_lights.hpp) draws them.
void add_points(Snapshot& snapshot, const AreaLight& light, const LightSamples& samples, Stream& stream) {
    const auto count = static_cast<std::uint32_t>(samples.count);
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec2 random = next_point(stream);
        if (samples.stratified) {
            const Stratum cell = stratum(i, count);
            random = cell.low + random * (cell.high - cell.low);
        }
        const LightPoint on =
            std::visit([&](const auto& shape) { return point_on(shape, random); }, light.shape);
        snapshot.lights.push_back({on.point, on.normal, light.radiance / (pi * on.pdf * count)});
    }
}

/// The place on a lens, in world units.
Vec2 place_on(const Lens& lens, const Vec2& random) {
    return lens.radius *
           (lens.sides == 0 ? disc_point(random) : polygon_point(lens.sides, lens.turn, random));
}

}  // namespace

std::vector<Snapshot> snapshots_of(const Scene& scene) {
    const int count = snapshot_count(scene);
    if (count == 0) return {};
    const World world = compile(scene);
    const bool shared = shares_samples(scene);
    const Sampler own = count == 1 ? Sampler::Regular : scene.sampling.sampler;
    const Patterns patterns = patterns_for(world, shared ? own : Sampler::Sobol, count);
    // Where each place would ask points of its own, a snapshot asks one point of each light, for all places.
    const LightSamples samples = shared ? scene.light_samples : LightSamples{.count = 1};
    Stream stream = stream_of(world, patterns, 0, 0, 0, count);
    std::vector<Snapshot> snapshots;
    for (const PixelSample& sample : pattern_of(world, patterns, 0, 0, 0, count)) {
        Stream numbers = stream;
        ++stream.sample;
        const CameraSample camera = camera_sample(world, sample.at, numbers);
        Snapshot snapshot{.at = sample.at, .weight = sample.weight, .time = camera.time};
        if (world.needs.lens) snapshot.lens = place_on(world.blur.lens, camera.lens);
        for (const AreaLight& light : world.area_lights.lights) add_points(snapshot, light, samples, numbers);
        snapshots.push_back(std::move(snapshot));
    }
    return snapshots;
}

}  // namespace rt
