// The cells along a ray: which, in which order, and for which part of the ray.
#include "tests/09_grids/visits.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/box.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

/// The cells of a walk, in order.
void check_cells(const GridShape& shape, const Ray& ray, const std::vector<Cells>& expected,
                 Interval range = {}) {
    INFO("the walk of the " << ray << " in " << range << " through " << shape.cells << " cells of edge 1");
    const std::vector<Cells> cells = cells_of(cells_along(shape, ray, range));
    CHECK(or_say(cells == expected, first_difference(cells, expected) + "\nvisited: " + show_all(cells)));
}

/// The part of the ray that is in the cell of one of `count` visits, numbered from 0.
void check_visit(const std::vector<CellVisit>& visits, int number, int count, Interval expected) {
    {
        INFO("how many cells are visited");
        REQUIRE(visits.size() == static_cast<std::size_t>(count));
    }
    const CellVisit& visit = visits[static_cast<std::size_t>(number)];
    const std::string which =
        "visit " + show(number + 1) + " of " + show(count) + ", cell " + show(visit.cell);
    {
        INFO(which << ": the t at which the ray enters the cell");
        CHECK(near(visit.t.min, expected.min, 16 * unit_roundoff * expected.min));
    }
    INFO(which << ": the t at which the ray leaves the cell, or the range ends");
    CHECK(near(visit.t.max, expected.max, 16 * unit_roundoff * expected.max));
}

/// Whether the visits follow one another and the ray.
void check_no_fault(const GridShape& shape, const Ray& ray, const std::vector<CellVisit>& visits) {
    const std::string fault = fault_of(shape, ray, visits);
    CHECK(or_say(fault.empty(), fault));
}

void check_boundaries(const GridShape& shape, const Ray& ray, int axis, const Boundaries& expected) {
    const Boundaries found = boundaries_along(shape, ray, axis);
    INFO(shape.cells << " cells in a " << shape.box << ", " << ray << ": the boundaries along axis number "
                     << axis);
    {
        INFO("step and last boundary");
        CHECK(or_say(found.step == expected.step && found.last == expected.last,
                     "step " + show(found.step) + " and last " + show(found.last) + ", expected " +
                         show(expected.step) + " and " + show(expected.last)));
    }
    if (expected.step == 0) return;
    {
        INFO("t0, where boundary number 0 is met");
        CHECK(near(found.t0, expected.t0, 8 * unit_roundoff * std::abs(expected.t0)));
    }
    INFO("delta, how much later the next one is");
    CHECK(near(found.delta, expected.delta, 8 * unit_roundoff * std::abs(expected.delta)));
}

/// The cell along x of four cells of edge 1, by boundaries that the test works out.
void check_cell(const Ray& ray, Real t, int expected) {
    const Real d = ray.direction.x;
    Boundaries boundaries;
    if (d != 0)
        boundaries = {.t0 = -ray.origin.x / d, .delta = 1 / d, .step = d > 0 ? 1 : -1, .last = d > 0 ? 4 : 0};
    INFO("4 cells of edge 1 along x, " << ray << ": the cell at t = " << t << ", counted from 0");
    CHECK(cell_at(unit_cells({4, 1, 1}), ray, 0, boundaries, t) == expected);
}

}  // namespace

TEST_CASE("by hand: the lesson's walk meets boundaries at 0.8 and every 1 after, at 0.2 and every 2 after",
          "[09.9]") {
    const Ray ray{{-0.8, -0.1, 0.5}, {1, 0.5, 0}};
    check_boundaries(unit_cells({8, 5, 1}), ray, 0, {.t0 = 0.8, .delta = 1, .step = 1, .last = 8});
    check_boundaries(unit_cells({8, 5, 1}), ray, 1, {.t0 = 0.2, .delta = 2, .step = 1, .last = 5});
}

TEST_CASE("boundaries are met at equal distances, going up or going down", "[09.9]") {
    const GridShape shape = unit_cells({4, 3, 2});
    const Ray ray{{-1, 4, 0.5}, {2, -0.5, 0}};
    check_boundaries(shape, ray, 0, {.t0 = 0.5, .delta = 0.5, .step = 1, .last = 4});
    check_boundaries(shape, ray, 1, {.t0 = 8, .delta = -2, .step = -1, .last = 0});
    // Eight cells of edge 1/4 from x = 10 to 12, from the middle of them.
    const GridShape fine{{{10, 0, 0}, {12, 1, 1}}, {8, 1, 1}};
    check_boundaries(fine, {{11, 0.5, 0.5}, {1, 0, 0}}, 0, {.t0 = -1, .delta = 0.25, .step = 1, .last = 8});
    check_boundaries(fine, {{11, 0.5, 0.5}, {-1, 0, 0}}, 0, {.t0 = 1, .delta = -0.25, .step = -1, .last = 0});
}

TEST_CASE("a ray that is parallel to the boundaries, or nearly, meets none", "[09.9]") {
    const Real tiny = std::numeric_limits<Real>::denorm_min();
    const GridShape shape = unit_cells({4, 3, 2});
    for (const Real d : {0.0, -0.0, tiny, -tiny})
        for (const Real x : {-1.0, 0.0, 0.5, 2.0, 4.0})
            check_boundaries(shape, {{x, 1, 1}, {d, 1, 0}}, 0, {});
}

TEST_CASE("going up, the number of the cell at t is how many boundaries have been met", "[09.10]") {
    // The boundaries 0, 1, 2, 3 and 4 are met at t = 1, 2, 3, 4 and 5.
    const Ray up{{-1, 0.5, 0.5}, {1, 0, 0}};
    check_cell(up, 1.5, 0);
    check_cell(up, 2.5, 1);
    check_cell(up, 4.5, 3);
    // At a boundary the ray is in the cell behind it.
    check_cell(up, 1, 0);
    check_cell(up, 2, 1);
    check_cell(up, 4, 3);
    // Before the grid it is in the first cell, behind it in the last.
    check_cell(up, -99, 0);
    check_cell(up, 5, 3);
    check_cell(up, 99, 3);
}

TEST_CASE("going down, it comes from the last cell", "[09.10]") {
    // The boundaries 4, 3, 2, 1 and 0 are met at t = 1, 2, 3, 4 and 5.
    const Ray down{{5, 0.5, 0.5}, {-1, 0, 0}};
    check_cell(down, 1.5, 3);
    check_cell(down, 2.5, 2);
    check_cell(down, 4.5, 0);
    check_cell(down, 1, 3);
    check_cell(down, 2, 2);
    check_cell(down, 4, 0);
    check_cell(down, -99, 3);
    check_cell(down, 5, 0);
    check_cell(down, 99, 0);
}

TEST_CASE("where no boundary is met, the cell is that of the origin", "[09.10]") {
    for (const Real t : {0.0, 7.0}) {
        check_cell({{0.5, 0, 0}, {0, 1, 0}}, t, 0);
        check_cell({{2.5, 0, 0}, {-0.0, 1, 0}}, t, 2);
        check_cell({{3.5, 0, 0}, {0, 1, 0}}, t, 3);
        check_cell({{-1, 0, 0}, {0, 1, 0}}, t, 0);
        check_cell({{9, 0, 0}, {0, 1, 0}}, t, 3);
    }
}

TEST_CASE("the cell is one of the grid's, also where t or the ray is not a number", "[09.10]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Boundaries up{.t0 = 0, .delta = 1, .step = 1, .last = 4}, none;
    const auto check = [&](const Ray& ray, const Boundaries& boundaries, Real t) {
        const int cell = cell_at(unit_cells({4, 1, 1}), ray, 0, boundaries, t);
        INFO("4 cells along x, " << ray << ": the cell at t = " << t);
        CHECK(or_say(0 <= cell && cell < 4, "cell number " + std::to_string(cell) + ", expected 0 to 3"));
    };
    check({{0, 0.5, 0.5}, {1, 0, 0}}, up, nan);
    check({{nan, 0.5, 0.5}, {1, 0, 0}}, none, 1);
    check({{nan, 0.5, 0.5}, {0, 1, 0}}, none, nan);
}

TEST_CASE("where division rounds to the wrong side of a boundary, the boundary itself decides", "[09.10]") {
    Random random(921);
    for (int k = 0; k < cases(20'000); ++k) {
        const int n = 2 + static_cast<int>(random.index(60));
        const bool up = random.index(2) == 0;
        const Boundaries all{.t0 = random.uniform(-3, 3),
                             .delta = (up ? 1 : -1) * random.uniform(0.01, 1),
                             .step = up ? 1 : -1,
                             .last = up ? n : 0};
        // At a boundary, or a rounding before it or after it.
        const Real met =
            all.t0 + (1 + static_cast<int>(random.index(static_cast<std::size_t>(n - 1)))) * all.delta;
        const Real t = random.index(3) == 0 ? met : std::nextafter(met, random.index(2) == 0 ? -9 : 99);
        int passed = 0;
        for (int i = 1; i < n; ++i) passed += all.t0 + i * all.delta <= t ? 1 : 0;
        INFO(n << " cells, boundary i is met at t = " << all.t0 << " + i * " << all.delta
               << ", as it is computed: " << passed << " of those between two cells are met up to t = " << t
               << "; the cell there, going " << (up ? "up" : "down"));
        const Real slope = 1 / all.delta;
        const Ray ray{{-all.t0 * slope, 0.5, 0.5}, {slope, 0, 0}};
        REQUIRE(cell_at(unit_cells({n, 1, 1}), ray, 0, all, t) == (up ? passed : n - 1 - passed));
    }
}

TEST_CASE("by hand: the lesson's walk through cells of edge 1", "[09.11]") {
    check_cells(unit_cells({8, 5, 1}), {{-0.8, -0.1, 0.5}, {1, 0.5, 0}},
                {{0, 0, 0},
                 {1, 0, 0},
                 {1, 1, 0},
                 {2, 1, 0},
                 {3, 1, 0},
                 {3, 2, 0},
                 {4, 2, 0},
                 {5, 2, 0},
                 {5, 3, 0},
                 {6, 3, 0},
                 {7, 3, 0},
                 {7, 4, 0}});
}

TEST_CASE("a ray along an axis visits a row of cells", "[09.11]") {
    const GridShape shape = unit_cells({4, 3, 3});
    const Ray ray{{-1, 1.5, 0.5}, {1, 0, -0.0}};
    check_cells(shape, ray, {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}});
    {
        const std::vector<CellVisit> visits = cells_along(shape, ray, {});
        INFO("the walk of the " << ray << " through a row of 4 cells of edge 1");
        for (int k = 0; k < 4; ++k) check_visit(visits, k, 4, {k + 1.0, k + 2.0});
    }
    // And back.
    check_cells(shape, {{9, 1.5, 0.5}, {-2, 0, 0}}, {{3, 1, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST_CASE("a slanted ray takes one step at a time", "[09.11]") {
    // Half as steep as the diagonal, from y = 1/4: it comes to y = 1 at x = 1.5, and to y = 2 at x = 3.5.
    const Ray ray{{0, 0.25, 0.5}, {1, 0.5, 0}};
    check_cells(unit_cells({4, 4, 1}), ray,
                {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0}});
    const std::vector<CellVisit> visits = cells_along(unit_cells({4, 4, 1}), ray, {});
    INFO("the walk of the " << ray << " through 4 x 4 cells of edge 1");
    check_visit(visits, 2, 6, {1.5, 2});
}

TEST_CASE("the range cuts the walk", "[09.11]") {
    const GridShape shape = unit_cells({8, 1, 1});
    const Ray ray{{0, 0.5, 0.5}, {1, 0, 0}};
    check_cells(shape, ray, {{2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {2.5, 4.5});
    // The end of the range counts: at t = 4 the ray is in cell 4.
    check_cells(shape, ray, {{2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {2.5, 4});
    check_cells(shape, ray, {{3, 0, 0}}, {3, 3.5});
    check_cells(shape, ray, {}, {9, 10});
    check_cells(shape, {{0, 2, 0}, {1, 0, 0}}, {});
    check_cells(shape, {{5.5, 0.5, 0.5}, {1, 0, 0}},
                {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}, {-infinity, 0});
}

TEST_CASE("the first visit begins where the range does, and the last one ends with it", "[09.11]") {
    const Ray ray{{0, 0.5, 0.5}, {1, 0, 0}};
    const std::vector<CellVisit> visits = cells_along(unit_cells({8, 1, 1}), ray, {2.5, 4.25});
    INFO("the walk of the " << ray << " in (2.5, 4.25] through a row of 8 cells of edge 1");
    check_visit(visits, 0, 3, {2.5, 3});
    check_visit(visits, 1, 3, {3, 4});
    check_visit(visits, 2, 3, {4, 4.25});
}

TEST_CASE("from a face, an edge or a corner of a cell the walk goes on from there", "[09.11]") {
    const GridShape shape = unit_cells({4, 4, 4});
    for (const Vec3& from : {Vec3(2, 1.5, 1.5), Vec3(2, 2, 1.5), Vec3(2, 2, 2), Vec3(0, 0, 0), Vec3(4, 4, 4)})
        for (const Vec3& d : {Vec3(1, 0, 0), Vec3(-1, 0.0, -0.0), Vec3(0, 0, -1), Vec3(1, 1, 1),
                              Vec3(-1, -1, -1), Vec3(1, -1, 0), Vec3(-1, 0.25, 0.5)}) {
            const std::vector<CellVisit> visits = cells_along(shape, {from, d}, {});
            INFO("from " << show(from) << " along " << show(d) << ": " << show_all(cells_of(visits)));
            check_no_fault(shape, {from, d}, visits);
            REQUIRE(or_say(!visits.empty(), "no cell is visited"));
        }
}

TEST_CASE("an exact diagonal passes from corner to corner", "[09.11]") {
    for (const Real sign : {1.0, -1.0}) {
        const GridShape shape = unit_cells({5, 5, 5});
        const Ray ray{Vec3(2.5) - 4 * sign * Vec3(1), Vec3(sign)};
        const std::vector<CellVisit> visits = cells_along(shape, ray, {});
        INFO("the walk of the " << ray
                                << " through the corners of 5 x 5 x 5 cells: " << show_all(cells_of(visits)));
        check_no_fault(shape, ray, visits);
        INFO("how many cells are visited, and how many of them for more than a point");
        CHECK(visits.size() <= 16);
        // The cells on the diagonal are visited for a while, those between for one point.
        int inside = 0;
        for (const CellVisit& visit : visits) inside += visit.t.max > visit.t.min;
        CHECK(inside == 5);
    }
}

TEST_CASE("the walk that was reported to lose its way in cells of 16", "[09.11]") {
    const GridShape shape{{Vec3(-1024), Vec3(1024)}, Cells(128)};
    const Vec3 from(-668, -340, 77), to(404, -64, -784);
    for (const Ray& ray : {Ray{from, to - from}, Ray{to, from - to}}) {
        const std::vector<CellVisit> visits = cells_along(shape, ray, {0, 1});
        const oracle::WalkTruth truth = oracle::judge_walk(shape, ray, {0, 1});
        // Where the ray crosses two boundaries at once, as at its end, either may come first.
        INFO(ray << ", 128 cells of edge 16 along each axis");
        check_no_fault(shape, ray, visits);
        // There are 67 boundaries from −668 to 404, 18 from −340 to −64 and 54 from 77 to −784; those at −64
        // and −784 are crossed at the end of the way there, and not at all at the beginning of the way back.
        REQUIRE(truth.cells.size() == (ray.origin == from ? 1 + 67 + 18 + 54 : 1 + 67 + 17 + 53));
        CHECK(or_say(visits.size() == truth.cells.size(),
                     show(visits.size()) + " visits, expected " + show(truth.cells.size()) +
                         "; the first that differs: " + first_difference(cells_of(visits), truth.cells)));
        INFO("the last cell");
        CHECK(visits.back().cell == truth.cells.back());
    }
}

TEST_CASE("a walk ends whatever the numbers", "[09.11]") {
    const Real huge = 1e300, tiny = 1e-300, least = std::numeric_limits<Real>::denorm_min();
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const GridShape shape = unit_cells({7, 5, 3});
    for (const Vec3& from :
         {Vec3(1, 2, 1), Vec3(huge), Vec3(-huge, 0, 0), Vec3(0, tiny, least), Vec3(nan, 1, 1)})
        for (const Vec3& d : {Vec3(0), Vec3(tiny), Vec3(huge, 1, tiny), Vec3(least, 1, 0), Vec3(-least),
                              Vec3(infinity, 1, 0), Vec3(nan, 1, 1)})
            for (const Interval range : {Interval{}, Interval{-infinity, infinity}, Interval{nan, nan}}) {
                const std::vector<CellVisit> visits = cells_along(shape, {from, d}, range);
                INFO("ray from " << from << " along " << d << " in " << range
                                 << ", 7 x 5 x 3 cells: how many are visited, and that they exist");
                CHECK(visits.size() <= 7 + 5 + 3 + 1);
                for (const CellVisit& visit : visits)
                    CHECK(or_say(glm::all(glm::greaterThanEqual(visit.cell, Cells(0))) &&
                                     glm::all(glm::lessThan(visit.cell, shape.cells)),
                                 "there is no cell " + show(visit.cell)));
            }
    INFO("a direction so small along x that the ray stays in its column: how many cells are visited");
    CHECK(cells_along(shape, {{3.5, 0, 1.5}, {least, 1, 0}}, {}).size() == 5);
}
