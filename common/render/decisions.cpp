// The discrete decisions behind each pixel: where two ray tracers may rightly differ.
#include "common/render/decisions.hpp"

#include "common/math/random.hpp"

#include <tbb/parallel_for.h>

#include <functional>

namespace rt {
namespace {

void mix(std::uint64_t& hash, std::uint64_t value) { hash = mixed(hash, value); }

/// The decision that is the same all over the pixel; if there is none, one that no other pixel has.
std::uint64_t decision_of_pixel(const World& world, int x, int y) {
    const auto decided_by = [&](const CameraSample& sample) {
        return decision(world, trace_tree(world, camera_ray(world, sample)));
    };
    const std::uint64_t middle = decided_by({{x + 0.5, y + 0.5}});
    if (!world.needs.samples) return middle;
    Stream stream = stream_of(world, x, y);
    for (int j = 0; j <= 8; ++j)
        for (int i = 0; i <= 8; ++i, ++stream.sample) {
            Stream own = stream;
            const Vec2 at = Vec2(x, y) + Vec2(i, j) / Real(8);
            // Of a blurred picture, also at other times and places of the lens.
            if (decided_by(camera_sample(world, at, own)) != middle)
                return mixed(mixed(middle, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y));
        }
    return middle;
}

}  // namespace

std::uint64_t decision(const World& world, const std::vector<TraceRecord>& tree) {
    std::uint64_t hash = 0;
    for (const TraceRecord& record : tree) {
        mix(hash, static_cast<std::uint64_t>(record.branch.kind));
        mix(hash, record.hit ? std::uint64_t{record.hit->primitive} + 1 : 0);
        if (!record.hit) continue;
        mix(hash, record.hit->element);
        mix(hash, record.material);
        // The lights that were asked, by where they stand, and what came through of each.
        for (const LightRecord& light : record.lights) {
            mix(hash, static_cast<std::uint64_t>(&light - record.lights.data()));
            for (int i = 0; i < 3; ++i) mix(hash, std::hash<Real>{}(light.visible[i]));
        }
    }
    mix(hash, world.groups.size());
    return hash;
}

std::vector<std::uint64_t> decisions(const World& world) {
    const View& view = world.view;
    std::vector<std::uint64_t> result(static_cast<std::size_t>(view.width) *
                                      static_cast<std::size_t>(view.height));
    if (!row_of(world.integrator).objects) return result;
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x)
            result[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
                   static_cast<std::size_t>(x)] = decision_of_pixel(world, x, y);
    });
    return result;
}

}  // namespace rt
