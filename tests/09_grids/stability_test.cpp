// Grids against asking every shape, to the bit, on scenes and rays made to break them.
// Families and demand: tests/stability/grids.hpp.
#include "common/math/error.hpp"
#include "tests/09_grids/visits.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/box.hpp"
#include "tests/stability/check.hpp"
#include "tests/stability/grids.hpp"
#include "tests/support.hpp"

#include <iostream>

using namespace rt;
using namespace rt::stability;
using namespace rt::test;

namespace {

constexpr std::uint64_t seed = 9;
constexpr std::size_t rays_a_scene = 100;

using Judge = Verdict (*)(const GridScene&, std::span<const GridQuestion>);

void check_families(Judge judge, int rays, bool nested) {
    for (const GridFamily& family : grid_families()) {
        Verdict verdict;
        const auto scenes = static_cast<std::size_t>(rays) / rays_a_scene / grid_families().size() + 1;
        for (std::uint64_t k = 0; k < scenes; ++k) {
            const GridScene scene = make_scene(family, seed + k, nested);
            add(verdict, judge(scene, make_questions(scene, rays_a_scene, seed + k)));
            if (verdict.mismatches > 0) break;
        }
        INFO("what is found by a grid, expected what is found by asking every shape");
        check_right(std::string(family.name) + " (" + family.extremes + ")", verdict);
    }
}

}  // namespace

TEST_CASE("no part of a ray in a box is lost, and little is added, against exact arithmetic",
          "[09.2][stability]") {
    // Near and far are each off by 3 roundings of the distance, and 3 more for the widening; a little for
    // second order. In units of u.
    const Real allowed = 7;
    Random random(94);
    const auto whole = [&] { return static_cast<Real>(random.index(5)) - 2; };
    int met = 0, lost_by_naive = 0;
    const int all = cases(20'000);
    for (int k = 0; k < all; ++k) {
        const bool is_whole = random.index(2) == 0;
        const Real scale = is_whole ? 1 : random.magnitude(-9, 9);
        const auto place = [&] {
            return is_whole ? Vec3(whole(), whole(), whole()) : scale * random.in_cube();
        };
        const Vec3 p = place(), q = place();
        Bounds box{glm::min(p, q), glm::max(p, q)};
        if (random.index(4) == 0) box.high[static_cast<int>(random.index(3))] = box.low.x;
        box = {glm::min(box.low, box.high), glm::max(box.low, box.high)};

        // From a place that often lies in a plane of the box, to another, or along an axis.
        Ray ray{place(), place()};
        for (int a = 0; a < 3; ++a) {
            if (random.index(4) == 0) ray.origin[a] = random.index(2) == 0 ? box.low[a] : box.high[a];
            if (random.index(4) == 0) ray.direction[a] = random.index(2) == 0 ? 0.0 : -0.0;
        }
        if (random.index(2) == 0) ray.origin -= random.uniform(0, 3) * ray.direction;
        Interval range;
        if (random.index(4) == 0) range = {-infinity, infinity};
        if (random.index(4) == 0) range.max = random.uniform(0, 2);

        const std::optional<Interval> actual = clip(box, ray, range);
        const oracle::ClipTruth truth = oracle::judge_clip(box, ray, range, actual);
        INFO("case " << k << ": " << box << ", " << show(ray) << " in " << range);
        const Interval exact{truth.near, truth.far};
        INFO("exact: " << (truth.inside ? "inside " : "outside ") << exact);
        INFO("actual: " << (actual ? "inside " : "outside ") << actual.value_or(Interval{}));
        CHECK(or_say(!truth.lost,
                     "a part of the ray that is in the box is lost, if only in the last digit: rounding must "
                     "be allowed for"));
        INFO("by how much too much there is, in roundings of the distance");
        CHECK(truth.excess <= (truth.inside ? allowed : 2 * allowed));
        met += truth.inside ? 1 : 0;
        if (oracle::judge_clip(box, ray, range, naive::clip(box, ray, range)).lost) ++lost_by_naive;
    }
    CHECK(met > all / 5);
    INFO("the naive slab test has to fail here, else the cases show nothing; it lost " << lost_by_naive);
    CHECK(lost_by_naive > all / 100);
}

TEST_CASE("the walk is exact, and the one that adds up is not", "[09.11][stability]") {
    Random random(920);
    int undecided = 0, wrong_when_adding = 0;
    const int all = cases(1000);
    for (int k = 0; k < all; ++k) {
        const auto count = [&] {
            return 1 + static_cast<std::int32_t>(random.index(random.index(4) == 0 ? 100 : 12));
        };
        const Cells cells(count(), count(), count());
        const Vec3 low = random.index(2) == 0 ? Vec3(0) : random.magnitude(-3, 3) * random.in_cube();
        const Vec3 edges = random.index(2) == 0 ? Vec3(cells) : Vec3(random.uniform(0.5, 2)) * Vec3(cells);
        const GridShape shape{{low, low + edges}, cells};
        const Vec3 size = edges / Vec3(cells);
        const auto place = [&] {
            Vec3 p;
            for (int a = 0; a < 3; ++a) {
                const Real inside = random.uniform(-0.2, cells[a] * 1.2);
                p[a] = low[a] + (random.index(3) == 0 ? std::floor(inside) : inside) * size[a];
            }
            return p;
        };
        Ray ray{place(), Vec3(0)};
        ray.direction = place() - ray.origin;
        for (int a = 0; a < 3; ++a)
            if (random.index(5) == 0) ray.direction[a] = random.index(2) == 0 ? 0.0 : -0.0;
        if (ray.direction == Vec3(0)) continue;
        const std::optional<Interval> part = clip(shape.box, ray, {});
        if (!part) continue;

        const std::vector<CellVisit> visits = cells_along(shape, ray, {});
        INFO("case " << k << ": " << shape.box << ", cells " << show(cells) << ", " << show(ray));
        const std::string fault = fault_of(shape, ray, visits);
        CHECK(or_say(fault.empty(), fault));

        // Boundaries that are nearer to each other than rounding may be crossed in either order.
        const oracle::WalkTruth truth = oracle::judge_walk(shape, ray, *part);
        if (truth.least_gap <= 16 * unit_roundoff) {
            ++undecided;
            continue;
        }
        const std::string difference = first_difference(cells_of(visits), truth.cells);
        CHECK(or_say(difference.empty(), difference));
        if (cells_of(naive::cells_along(shape, ray, *part)) != truth.cells) ++wrong_when_adding;
    }
    CHECK(undecided < demanded(all / 2, all * 9 / 10));

    INFO("a long walk by additions has to lose its way, else nothing is shown");
    const GridShape fine{{Vec3(0), Vec3(1000)}, Cells(1000)};
    Real farthest_added = 0, farthest = 0;
    for (int k = 0; k < 5; ++k) {
        const Ray ray{Vec3(0.1, 0.2, 0.3) + 0.1 * random.in_cube(),
                      Vec3(1, 0.997, 0.31) + 0.01 * random.in_cube()};
        const auto error_of = [&](const std::vector<CellVisit>& visits) {
            Real error = 0;
            for (std::size_t i = 0; i < visits.size(); i += 97)
                error =
                    std::max(error, oracle::distance_from_cell(fine, visits[i].cell, ray, visits[i].t.min));
            return error / (1000 * unit_roundoff);
        };
        farthest = std::max(farthest, error_of(cells_along(fine, ray, {})));
        farthest_added = std::max(farthest_added, error_of(naive::cells_along(fine, ray, {0, 990})));
    }
    INFO(
        "how far outside of its cell the ray is at most, in roundings: by the walk, and by one that adds up");
    CHECK(farthest <= allowed_outside);
    CHECK(farthest_added > 4 * allowed_outside);
}

TEST_CASE("the nearest hit by a grid is, to the bit, the nearest of all", "[09.12][stability]") {
    check_families(judge_nearest, cases(50'000), false);
}

TEST_CASE("a grid finds a hit of a shadow ray if and only if there is one", "[09.12][stability]") {
    check_families(judge_any, cases(25'000), false);
}

TEST_CASE("the nearest hit by grids in grids is, to the bit, the nearest of all", "[09.14][stability]") {
    check_families(judge_nearest, cases(50'000), true);
}

TEST_CASE("grids in grids find a hit of a shadow ray if and only if there is one", "[09.14][stability]") {
    check_families(judge_any, cases(25'000), true);
}

TEST_CASE("a search that stops at the first hit fails on the families", "[stability]") {
    std::size_t wrong = 0, asked = 0;
    for (const GridFamily& family : grid_families())
        for (std::uint64_t k = 0; k < 20; ++k) {
            const GridScene scene = make_scene(family, seed + k);
            const auto* triangles = std::get_if<std::vector<Triangle>>(&scene.shapes);
            if (!triangles || !scene.grid.grids.empty()) continue;
            for (const GridQuestion& question : make_questions(scene, 50, seed + k)) {
                const std::optional<Hit> right = nearest_of_all(scene, question);
                const std::optional<Hit> naive =
                    naive::closest_hit(scene.grid, *triangles, question.ray, question.range);
                ++asked;
                wrong +=
                    right.has_value() != naive.has_value() || (right && right->primitive != naive->primitive);
            }
        }
    INFO(wrong << " of " << asked << " rays");
    CHECK(wrong > asked / 1000);
}
