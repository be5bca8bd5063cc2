// Families of extreme cases for chapter 6, and their judge: surfaces of every kind, far away, tiny, huge or
// slanted, seen by a ray and lit at a grazing angle.
// A family makes any number of cases from a seed; shadow rays are collected first and judged together.
//
// Demands, with b = Σ |nᵢ|·errorᵢ the error bound of the point along the normal: a shadow ray never meets the
// surface that it starts on (a self hit), and never misses an occluder that is parallel to the surface, at a
// gap of 64·b or more, and large enough to cover the ray (a lost occluder). Either alone would be easy.
#pragma once

#include "chapters/06_shadows/shadow.hpp"
#include "tests/support.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace rt::stability {

/// A triangle of a mesh that stands somewhere under a transform.
struct PlacedTriangle {
    Transform transform;
    Triangle triangle;  ///< in local space
};

using AnyShape = std::variant<Plane, Sphere, Triangle, Polygon, Ellipsoid, PlacedTriangle>;

struct ShadowCase {
    AnyShape shape;
    Surface surface;    ///< of the shape, where a ray met it
    LightSample light;  ///< on either side of the surface, for a sphere or ellipsoid outside
    std::variant<Plane, Triangle> occluder;  ///< between the surface and the light
    Real gap = 0;                            ///< of the occluder, along the normal
};

struct ShadowFamily {
    const char* name;
    const char* extremes;                                     ///< what is extreme in it
    std::optional<ShadowCase> (*make)(test::Random& random);  ///< nothing where the ray misses the shape
};

/// All the families.
std::span<const ShadowFamily> shadow_families();

/// So many cases of a family.
std::vector<ShadowCase> make_cases(const ShadowFamily& family, std::size_t count, std::uint64_t seed);

struct ShadowVerdict {
    std::size_t cases = 0;
    std::size_t self_hits = 0;
    std::size_t lost = 0;
    std::string first_self_hit;  ///< the first case of each kind, as numbers that can be pasted; or empty
    std::string first_lost;
};

/// Judges one shadow ray a case.
ShadowVerdict judge(std::span<const ShadowCase> cases, std::span<const ShadowRay> answers);

void add(ShadowVerdict& total, const ShadowVerdict& batch);

/// One line of counts, then the first failures.
std::string describe(const ShadowVerdict& verdict);

}  // namespace rt::stability

namespace rt::naive {

/// From the point itself, all hits beyond 0.
ShadowRay shadow_ray_without_offset(const Surface& surface, const LightSample& light);

/// From the point itself, hits beyond `epsilon` (naive.hpp).
ShadowRay shadow_ray_with_epsilon(const Surface& surface, const LightSample& light);

/// From the point moved by 256 ulps a coordinate along the normal, or by 1/65536 where the coordinate is
/// below 1/32 (Wächter & Binder 2019, their method for single precision with their constants, here in
/// double).
ShadowRay shadow_ray_by_integers(const Surface& surface, const LightSample& light);

}  // namespace rt::naive
