// Distribution ray tracing: the tree of chapter 7, each of whose rays asks a random one of all that blurs.
#pragma once

#include "chapters/07_recursion/radiance.hpp"

#include <optional>

namespace rt {

/// [12.19] The branch with another direction: a random one around its own (12.16, with this exponent), and as
/// right as 12.16 promises. Nothing if that does not lie on the side of the flat surface on which the
/// branch's own direction lies, because it is on the other side or along the surface: this light is lost. All
/// else stays as it is. `branch.ray.direction` is a unit vector, the exponent in [0, 1e8], `random` of [0,
/// 1)².
std::optional<Branch> spread(const Branch& branch, const Surface& surface, Real exponent, const Vec2& random);

/// [12.20] Radiance along a camera ray, by one random answer to each question that has many: what `radiance`
/// of chapter 7 says (07.6), but for three things. The light at a hit is that of all lights at the time of
/// the ray (`local_light` with time and stream). A ray that hits an area light shows what `light_at` says,
/// and ends there. And a branch that `scatter` returns is spread where `gloss_of` is greater than 0, each
/// with a point of its own from the stream; where it is lost, the others go on.
///
/// All rays of the tree have the time of the camera ray. Without area lights, gloss and motion it is
/// `radiance`, up to rounding, and asks for no random number. Cook, Porter & Carpenter, Distributed ray
/// tracing, 1984.
Vec3 distributed(const World& world, const Ray& ray, Stream& stream);

}  // namespace rt
