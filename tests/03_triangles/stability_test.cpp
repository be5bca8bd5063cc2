// The triangles and polygons of chapter 3 against exact arithmetic, on cases made to break them.
// Demands and condition numbers: tests/stability/triangles.hpp.
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "tests/oracle/polygon.hpp"
#include "tests/oracle/triangle.hpp"
#include "tests/stability/check.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/triangles.hpp"

#include <algorithm>
#include <string>

using namespace rt;
using namespace rt::stability;

namespace {

constexpr std::uint64_t seed = 3;

Tally tally("03 triangles");

std::optional<Hit> stable_hit(const TriangleCase& question) {
    return intersect(question.triangle, question.ray, Interval{});
}

std::optional<Hit> naive_hit(const TriangleCase& question) {
    return naive::intersect(question.triangle, question.ray, Interval{});
}

template <class Method>
std::vector<OutlineAnswer> ask_outlines(const std::vector<OutlineCase>& questions, Method inside) {
    return ask<OutlineAnswer>(questions, [&](const OutlineCase& question) {
        return OutlineAnswer{inside(question.whole, question.point), inside(question.left, question.point),
                             inside(question.right, question.point)};
    });
}

}  // namespace

TEST_CASE("a point on the cut between two polygons is in exactly one of them", "[03.2][stability]") {
    const auto questions = outline_cases(how_many(tally, 100'000), seed);
    check(tally, "polygons cut in two", judge(questions, ask_outlines(questions, point_in_polygon)),
          judge(some(questions), ask_outlines(some(questions), naive::point_in_polygon)));
}

TEST_CASE("barycentric coordinates of slivers are as right as their shape allows", "[03.3][stability]") {
    const auto questions = weight_cases(how_many(tally, 100'000), seed);
    const auto weights = [](const WeightCase& question) {
        return barycentric(question.triangle, question.point);
    };
    const auto naive_weights = [](const WeightCase& question) {
        return naive::barycentric(question.triangle, question.point);
    };
    // Whoever uses dot products has solved the step, though slivers show that areas are better.
    check(tally, "weights in sixteenths",
          judge(questions, ask<std::optional<Vec3>>(questions, weights), WeightsFrom::DotProducts),
          judge(some(questions), ask<std::optional<Vec3>>(some(questions), naive_weights)));
}

TEST_CASE("the sign of an edge function is exact", "[03.5][stability]") {
    const auto questions = turn_cases(how_many(tally, 100'000), seed);
    const auto turn = [](const TurnCase& question) { return edge_function(question.p, question.q); };
    const auto rounded = [](const TurnCase& question) {
        return question.p.x * question.q.y - question.p.y * question.q.x;
    };
    check(tally, "nearly parallel vectors", judge(questions, ask<Real>(questions, turn)),
          judge(some(questions), ask<Real>(some(questions), rounded)));
}

TEST_CASE("the hit with a triangle is right on extreme cases", "[03.7][stability]") {
    for (const TriangleFamily& family : triangle_families()) {
        const auto questions = family.make(how_many(tally, 100'000), seed);
        check(tally, family.name, judge(questions, ask<std::optional<Hit>>(questions, stable_hit)),
              judge(some(questions), ask<std::optional<Hit>>(some(questions), naive_hit)));
    }
}

TEST_CASE("the unit normal is right for every shape and every order of the corners", "[03.3][stability]") {
    const auto textbook = [](const TriangleCase& question) { return naive::unit_normal(question.triangle); };
    const auto normal = [](const TriangleCase& question) { return unit_normal(question.triangle); };
    for (const TriangleFamily& family : triangle_families()) {
        const auto questions = family.make(how_many(tally, 30'000), seed);
        const Verdict naive = judge_normals(some(questions), ask<Vec3>(some(questions), textbook));
        const Verdict stable = judge_normals(questions, ask<Vec3>(questions, normal));
        add(tally.stable, stable);
        add(tally.naive, naive);
        check_right(family.name, stable);
    }
    INFO("the textbook's normal has to fail somewhere");
    CHECK(tally.naive.mismatches > 0);
}

TEST_CASE("a ray at the seam of tiles hits exactly one of them", "[03.10][stability]") {
    const auto questions = tiles_cases(how_many(tally, 100'000), seed);
    const auto hits = [](const TilesCase& question) { return tiles_hit(question, rt::intersect); };
    const auto textbook = [](const TilesCase& question) { return tiles_hit(question, naive::intersect); };
    check(tally, "tiles of a plane", judge(questions, ask<std::size_t>(questions, hits)),
          judge(some(questions), ask<std::size_t>(some(questions), textbook)));
}

TEST_CASE("no ray slips through between two triangles", "[03.7][stability]") {
    for (const SurfaceFamily& family : surface_families()) {
        const std::size_t rays = how_many(tally, family.triangles > 100 ? 500 : 100'000);
        // In parts, because a million cases at once fill the memory rather than the test.
        const std::size_t part = std::max<std::size_t>(1, 20'000 / family.triangles);
        Verdict stable, naive;
        for (std::size_t first = 0; first < rays; first += part) {
            const Bundles bundles = family.make(std::min(part, rays - first), seed + first);
            add(stable, judge(bundles, ask<std::optional<Hit>>(bundles.cases, stable_hit)));
            if (first < rays / 10 + 1)
                add(naive, judge(bundles, ask<std::optional<Hit>>(bundles.cases, naive_hit)));
        }
        check(tally, family.name, stable, naive);
    }
}

TEST_CASE("the nearest of many triangles is, to the bit, the nearest of one at a time", "[03.9][stability]") {
    for (const SurfaceFamily& family : surface_families()) {
        const Bundles bundles = family.make(how_many(tally, family.triangles > 100 ? 100 : 20'000), seed);
        std::vector<Triangle> triangles;
        std::size_t wrong = 0;
        for (const Bundle& bundle : bundles.bundles) {
            triangles.clear();
            std::optional<Hit> expected;
            const Ray& ray = bundles.cases[bundle.first].ray;
            for (std::size_t i = 0; i < bundle.count; ++i)
                triangles.push_back(bundles.cases[bundle.first + i].triangle);
            const auto hits = ask<std::optional<Hit>>(
                triangles, [&](const Triangle& triangle) { return intersect(triangle, ray, Interval{}); });
            for (std::size_t i = 0; i < hits.size(); ++i) {
                if (!hits[i] || (expected && expected->t <= hits[i]->t)) continue;
                expected = hits[i];
                expected->primitive = static_cast<std::uint32_t>(i);
            }
            const std::optional<Hit> nearest = closest_hit(triangles, ray, Interval{});
            const bool same = expected.has_value() == nearest.has_value() &&
                              (!nearest || (nearest->t == expected->t && nearest->uv == expected->uv &&
                                            nearest->primitive == expected->primitive));
            if (!same || any_hit(triangles, ray, Interval{}) != expected.has_value()) ++wrong;
        }
        INFO(family.name << ": " << wrong << " of " << bundles.bundles.size() << " rays differ");
        CHECK(wrong == 0);
    }
}

TEST_CASE("the judge of triangles agrees with CGAL's own predicate", "[stability]") {
    std::size_t asked = 0, different = 0, exactly_on_an_edge = 0;
    for (const SurfaceFamily& family : surface_families()) {
        if (family.triangles > 100) continue;
        for (const TriangleCase& item : family.make(how_many(tally, 2'000), seed + 1).cases) {
            const std::optional<bool> right = oracle::cgal_ray_meets_triangle(item.triangle, item.ray);
            if (!right) continue;
            const oracle::TriangleTruth truth = oracle::judge_triangle(item.triangle, item.ray, 0);
            // CGAL lets a ray in the plane of a triangle hit it; the course calls that a miss.
            if (truth.sum == 0) continue;
            ++asked;
            if (*right != truth.hit) ++different;
            const Vec3& v = truth.volumes;
            if (truth.hit && (v.x == 0 || v.y == 0 || v.z == 0)) ++exactly_on_an_edge;
        }
    }
    CHECK(different == 0);
    INFO("of " << asked
               << " cases, this many pass exactly through an edge or corner: " << exactly_on_an_edge);
    CHECK(exactly_on_an_edge > asked / 10);
}
