// Rough mirrors and rough glass: facets of GGX in the tree of rays.
#pragma once

#include "chapters/07_recursion/radiance.hpp"
#include "common/world/query.hpp"

#include <vector>

namespace rt {

/// α of what this material's `brdf ggx` sends on: mirrored and refracted rays. 0 if they are not spread so,
/// also where the material has neither.
Real facet_alpha(const World& world, const Material& material);

/// What goes on from a hit: what `scatter` of chapter 7 sends on (07.5), spread as the material says, by a
/// facet or in a lobe (12.19). Asks for the random numbers in the order of 12.20, which pushes them in this
/// order.
std::vector<Branch> spread_branches(const World& world, const Branch& incoming, const Hit& hit,
                                    const Surface& surface, const Material& material, Stream& stream);

/// Radiance along a camera ray, as `distributed` of chapter 12 has it (12.20); but where `facet_alpha` is
/// greater than 0, a ray meets a random facet of the surface, one of those that are seen (11.17), and goes on
/// as at a smooth surface with the facet's normal: so mirrors, and glass with Fresnel's part of the facet
/// (Walter and others 2007). Of what goes on, the part counts that no other facet hides; what would leave on
/// the wrong side met a second facet, and is lost.
Vec3 rough_distributed(const World& world, const Ray& ray, Stream& stream);

}  // namespace rt
