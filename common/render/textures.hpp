// What varies a material at a hit: pictures, patterns, bumps.
#pragma once

#include "chapters/11_textures/footprint.hpp"
#include "common/world/query.hpp"

namespace rt {

/// Multiplies the colours of `material`, that of the hit in a world whose needs say `textures`, by its
/// texture there; `seen` is the footprint of what a pixel sees, or null where nobody knows.
void apply_texture(const World& world, const Hit& hit, const Surface& surface, const Footprint* seen,
                   Material& material);

/// Turns the shading normal as the normal map and the bumps of the hit's material say, in a world whose needs
/// say `bumps`; `seen` as above.
void apply_bumps(const World& world, const Ray& ray, const Hit& hit, const Footprint* seen, Surface& surface);

/// As `surface_at`, but without these.
Surface surface_without_bumps(const World& world, const Ray& ray, const Hit& hit);

}  // namespace rt
