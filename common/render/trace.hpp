// The ray tree of one camera ray, written down: what was hit, what each light gave, what went on.
#pragma once

#include "chapters/05_lighting/lighting.hpp"
#include "chapters/07_recursion/radiance.hpp"
#include "common/world/stream.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rt {

/// What one light gave to one hit.
struct LightRecord {
    std::uint32_t light = 0;  ///< its number in the world: point lights, directional ones, area lights
    LightSample sample;
    Vec3 visible{1};           ///< which part of it arrived
    Vec3 contribution{0};      ///< to the radiance at the hit, before the ray's weight
    std::optional<Vec3> lobe;  ///< of the finish, 1/sr, where there is one
};

/// How far what goes on from a hit is spread.
struct SpreadRecord {
    Real gloss = 0, translucency = 0;  ///< exponents of the lobes; 0 is not
    Real alpha = 0;                    ///< of the facets that rays meet instead; 0 is none
};

/// One ray of the tree.
struct TraceRecord {
    Branch branch;                 ///< its weight before absorption
    int parent = -1;               ///< index of the ray that spawned it; −1 for the camera ray
    std::optional<Hit> hit;        ///< nothing: the background was seen
    Surface surface;               ///< where there is a hit
    Vec3 normal{0};                ///< shading normal turned to the viewer
    std::uint32_t material = 0;    ///< index into World::materials
    Vec3 weight{1};                ///< after absorption on the way to the hit
    Vec3 local{0};                 ///< radiance of the hit itself, or the background
    std::optional<Finish> finish;  ///< here, if it is not the plain one
    Vec3 skylight{0};              ///< in `local`
    SpreadRecord spread;
    std::vector<LightRecord> lights;  ///< those in front of the surface, in the world's order; of rough glass
                                      ///< then those behind
};

/// The tree of `ray`, in the order in which `radiance` walks it. The sum of weight · local over it is the
/// pixel's colour. Worlds that are not ray traced (flat, normals, ...) have one record. The tree ends with
/// `most` records, though it may go on: a ray that meets glass has two more at every level.
std::vector<TraceRecord> trace_tree(const World& world, const Ray& ray, std::size_t most = SIZE_MAX);

/// The tree of one sample of a world whose rays draw random numbers (`needs.distribution`): the numbers are
/// those of `stream`, as the renderer asks for them after the camera. A ray that hits an area light ends
/// there.
std::vector<TraceRecord> trace_sample(const World& world, const Ray& ray, Stream stream,
                                      std::size_t most = SIZE_MAX);

}  // namespace rt
