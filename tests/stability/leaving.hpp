// Rays that leave a surface where another ray met it, from where chapter 6 lets them start: what shadows,
// mirrors and glass ask of chapter 10's surfaces.
#pragma once

#include "chapters/06_shadows/shadow.hpp"
#include "chapters/10_surfaces/box.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/quadric.hpp"
#include "chapters/10_surfaces/torus.hpp"
#include "tests/stability/implicits.hpp"
#include "tests/stability/solids.hpp"
#include "tests/stability/tori.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace rt::stability {

/// Those that go outward, or those that go inward.
template <class Case>
struct LeavingRays {
    bool outward = false;
    std::vector<Case> cases{};
    std::vector<bool> goes_back{};  ///< to the side that the first ray came from
};

/// Demands: outward rays must begin outside of the solid, and inward ones inside of it; in a box, where the
/// gap or the solid is too thin for both, those that go back. And they must hit what is there, not what they
/// leave.
Verdict judge_leaving(const LeavingRays<SolidCase<Box>>& rays, std::span<const std::optional<Hit>> answers);
Verdict judge_leaving(const LeavingRays<SolidCase<Cone>>& rays, std::span<const std::optional<Hit>> answers);
Verdict judge_leaving(const LeavingRays<TorusCase>& rays, std::span<const std::optional<Hit>> answers);
Verdict judge_leaving(const LeavingRays<SolidCase<Implicit>>& rays,
                      std::span<const std::optional<Hit>> answers);
Verdict judge_leaving(const LeavingRays<SolidCase<Quadric>>& rays,
                      std::span<const std::optional<Hit>> answers);

/// Where a leaving ray begins: as chapter 6 says, or, by the textbook, in the point of the first ray at t.
enum class Start { Offset, AtHit };

/// One such ray for each of the rays that hit, in all directions, many of them along the surface: those that
/// go inward, and those that go outward.
template <class Case>
std::array<LeavingRays<Case>, 2> leaving_rays(const std::vector<Case>& first, std::uint64_t seed,
                                              Start start) {
    test::Random random(seed);
    std::array<LeavingRays<Case>, 2> leaving{{{.outward = false}, {.outward = true}}};
    for (const auto& [shape, ray] : first) {
        const std::optional<Hit> hit = intersect(shape, ray, Interval{});
        if (!hit) continue;
        const Surface surface = surface_at(shape, ray, *hit);
        const Real cosine = random.sign() * random.magnitude(-6, 0);
        const Vec3 across = random.perpendicular_to(surface.normal);
        const Vec3 d = normalize(cosine * surface.normal + std::sqrt(1 - cosine * cosine) * across);
        LeavingRays<Case>& rays = leaving[cosine > 0];
        rays.cases.push_back(
            {shape, {start == Start::Offset ? offset_origin(surface, d) : point_at(ray, hit->t), d}});
        rays.goes_back.push_back(cosine * dot(surface.normal, ray.direction) < 0);
    }
    return leaving;
}

/// The verdict on both.
template <class Case>
Verdict leave(const std::vector<Case>& first, std::uint64_t seed, Start start = Start::Offset) {
    Verdict verdict;
    for (const LeavingRays<Case>& rays : leaving_rays(first, seed, start)) {
        std::vector<std::optional<Hit>> answers;
        for (const auto& [shape, ray] : rays.cases) answers.push_back(intersect(shape, ray, Interval{}));
        add(verdict, judge_leaving(rays, answers));
    }
    return verdict;
}

}  // namespace rt::stability
