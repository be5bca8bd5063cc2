// The maps of chapter 4 against exact arithmetic, on cases made to break them.
// Demands and condition numbers: tests/stability/transforms.hpp.
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "tests/stability/check.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/transforms.hpp"

#include <string>

using namespace rt;
using namespace rt::stability;

namespace {

constexpr std::uint64_t seed = 4;

Tally tally("04 transforms");

}  // namespace

TEST_CASE("a matrix times its inverse is the identity, on extreme cases, and a singular one has none",
          "[04.4][stability]") {
    for (const MatrixFamily& family : matrix_families()) {
        const auto questions = family.make(how_many(tally, 50'000), seed);
        check(tally, family.name,
              judge(questions, ask<std::optional<Mat4>>(questions, [](const Mat4& m) { return inverse(m); })),
              judge(some(questions), ask<std::optional<Mat4>>(
                                         some(questions), [](const Mat4& m) { return naive::inverse(m); })));
    }
}

TEST_CASE("normals stay at right angles to the surface, on extreme cases", "[04.5][stability]") {
    for (const MatrixFamily& family : matrix_families().first(6)) {
        const auto questions = normal_cases(family, how_many(tally, 30'000), seed + 1);
        const auto moved = [](const NormalCase& q) {
            Surface local;
            local.normal = local.shading_normal = normalize(q.normal);
            return to_world(q.transform, local).normal;
        };
        const auto naive = [](const NormalCase& q) {
            return normalize(naive::transform_normal(q.transform.to_world, q.normal));
        };
        check(tally, family.name, judge(questions, ask<Vec3>(questions, moved)),
              judge(some(questions), ask<Vec3>(some(questions), naive)));
    }
}

TEST_CASE("hits with ellipsoids are right on extreme cases", "[04.6][stability]") {
    const auto stable = [](const EllipsoidCase& q) { return intersect(q.ellipsoid, q.ray, Interval{}); };
    const auto naive = [](const EllipsoidCase& q) {
        return naive::intersect(Sphere{Vec3(0), 1}, naive::to_local(q.ellipsoid.transform, q.ray),
                                Interval{});
    };
    for (const EllipsoidFamily& family : ellipsoid_families()) {
        const auto questions = family.make(how_many(tally, 50'000), seed + 2);
        check(tally, family.name, judge(questions, ask<std::optional<Hit>>(questions, stable)),
              judge(some(questions), ask<std::optional<Hit>>(some(questions), naive)));
    }
}
