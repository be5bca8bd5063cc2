// All lobes under one name, as light transport asks them.
//
// To add a lobe: write its struct with `evaluate`, `pdf` and `sample` in a file of its own, and add it to
// `Lobe`.
#pragma once

#include "chapters/11_textures/coat.hpp"
#include "chapters/11_textures/lobe.hpp"
#include "chapters/11_textures/matte.hpp"
#include "chapters/11_textures/microfacet.hpp"
#include "chapters/11_textures/rough_glass.hpp"
#include "chapters/11_textures/sheen.hpp"
#include "common/math/vec.hpp"

#include <optional>
#include <variant>

namespace rt {

/// How a surface scatters light. Only RoughGlass has something below the surface.
using Lobe = std::variant<Matte, RoughMetal, RoughGlass, Velvet, Coated>;

/// The lobe f in 1/sr, without the cosine; 0 where the lobe sends nothing. Given.
Vec3 evaluate(const Lobe& lobe, const Vec3& to_light, const Vec3& to_viewer);

/// The density of sample's directions per sr. It sums to at most 1 over all directions to the light; what is
/// missing is what `sample` answers with nothing or with an infinite density. Given.
Real pdf(const Lobe& lobe, const Vec3& to_light, const Vec3& to_viewer);

/// A direction from which light is to be fetched, by three random numbers in [0, 1): x and y for the
/// direction, z for a choice. Nothing where light is lost: that counts as a sample of 0. Given.
std::optional<LobeSample> sample(const Lobe& lobe, const Vec3& to_viewer, const Vec3& random);

}  // namespace rt
