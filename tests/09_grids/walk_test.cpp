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

/// Whether the visits follow one another and the ray.
void check_no_fault(const GridShape& shape, const Ray& ray, const std::vector<CellVisit>& visits) {
    const std::string fault = fault_of(shape, ray, visits);
    CHECK(or_say(fault.empty(), fault));
}

}  // namespace

TEST_CASE("a ray along an axis visits a row of cells", "[09.6]") {
    const GridShape shape = unit_cells({4, 3, 3});
    const Ray ray{{-1, 1.5, 0.5}, {1, 0, -0.0}};
    check_cells(shape, ray, {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}});
    const std::vector<CellVisit> visits = cells_along(shape, ray, {});
    {
        INFO("the t at which the "
             << ray << " enters the first of 4 cells of edge 1, enters the second, leaves the last");
        REQUIRE(visits.size() == 4);
        CHECK(visits[0].t.min == Approx(1));
        CHECK(visits[1].t.min == 2);
        CHECK(visits[3].t.max == Approx(5));
    }
    // And back.
    check_cells(shape, {{9, 1.5, 0.5}, {-2, 0, 0}}, {{3, 1, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST_CASE("a slanted ray takes one step at a time", "[09.6]") {
    // Half as steep as the diagonal, from y = 1/4: it comes to y = 1 at x = 1.5, and to y = 2 at x = 3.5.
    const Ray ray{{0, 0.25, 0.5}, {1, 0.5, 0}};
    check_cells(unit_cells({4, 4, 1}), ray,
                {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0}});
    const std::vector<CellVisit> visits = cells_along(unit_cells({4, 4, 1}), ray, {});
    INFO("the t at which the " << ray << " enters and leaves the third of six cells");
    REQUIRE(visits.size() == 6);
    CHECK(visits[2].t.min == 1.5);
    CHECK(visits[2].t.max == 2);
}

TEST_CASE("the range cuts the walk", "[09.6]") {
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

TEST_CASE("from a face, an edge or a corner of a cell the walk goes on from there", "[09.6]") {
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

TEST_CASE("an exact diagonal passes from corner to corner", "[09.6]") {
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

TEST_CASE("the walk that was reported to lose its way in cells of 16", "[09.6]") {
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

TEST_CASE("a walk ends whatever the numbers", "[09.6]") {
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
