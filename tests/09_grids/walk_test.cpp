// The cells along a ray: which, in which order, and for which part of the ray.
#include "tests/09_grids/visits.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/box.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

TEST_CASE("a ray along an axis visits a row of cells", "[09.6]") {
    const std::vector<CellVisit> visits =
        cells_along(unit_cells({4, 3, 3}), {{-1, 1.5, 0.5}, {1, 0, -0.0}}, {});
    REQUIRE(cells_of(visits) == std::vector<Cells>{{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}});
    CHECK(visits[0].t.min == Approx(1));
    CHECK(visits[1].t.min == 2);
    CHECK(visits[3].t.max == Approx(5));
    INFO("and back");
    CHECK(cells_of(cells_along(unit_cells({4, 3, 3}), {{9, 1.5, 0.5}, {-2, 0, 0}}, {})) ==
          std::vector<Cells>{{3, 1, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST_CASE("a slanted ray takes one step at a time", "[09.6]") {
    // Half as steep as the diagonal, from y = 1/4: it comes to y = 1 at x = 1.5, and to y = 2 at x = 3.5.
    const std::vector<CellVisit> visits =
        cells_along(unit_cells({4, 4, 1}), {{0, 0.25, 0.5}, {1, 0.5, 0}}, {});
    CHECK(cells_of(visits) ==
          std::vector<Cells>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0}});
    REQUIRE(visits.size() == 6);
    CHECK(visits[2].t.min == 1.5);
    CHECK(visits[2].t.max == 2);
}

TEST_CASE("the range cuts the walk", "[09.6]") {
    const GridShape shape = unit_cells({8, 1, 1});
    const Ray ray{{0, 0.5, 0.5}, {1, 0, 0}};
    CHECK(cells_of(cells_along(shape, ray, {2.5, 4.5})) ==
          std::vector<Cells>{{2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
    INFO("the end of the range counts: at t = 4 the ray is in cell 4");
    CHECK(cells_of(cells_along(shape, ray, {2.5, 4})) == std::vector<Cells>{{2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
    CHECK(cells_of(cells_along(shape, ray, {3, 3.5})) == std::vector<Cells>{{3, 0, 0}});
    CHECK(cells_along(shape, ray, {9, 10}).empty());
    CHECK(cells_along(shape, {{0, 2, 0}, {1, 0, 0}}, {}).empty());
    CHECK(cells_of(cells_along(shape, {{5.5, 0.5, 0.5}, {1, 0, 0}}, {-infinity, 0})).size() == 6);
}

TEST_CASE("from a face, an edge or a corner of a cell the walk goes on from there", "[09.6]") {
    const GridShape shape = unit_cells({4, 4, 4});
    for (const Vec3& from : {Vec3(2, 1.5, 1.5), Vec3(2, 2, 1.5), Vec3(2, 2, 2), Vec3(0, 0, 0), Vec3(4, 4, 4)})
        for (const Vec3& d : {Vec3(1, 0, 0), Vec3(-1, 0.0, -0.0), Vec3(0, 0, -1), Vec3(1, 1, 1),
                              Vec3(-1, -1, -1), Vec3(1, -1, 0), Vec3(-1, 0.25, 0.5)}) {
            const std::vector<CellVisit> visits = cells_along(shape, {from, d}, {});
            INFO("from " << show(from) << " along " << show(d) << ": " << show_all(cells_of(visits)));
            CHECK(fault_of(shape, {from, d}, visits) == "");
            REQUIRE_FALSE(visits.empty());
        }
}

TEST_CASE("an exact diagonal passes from corner to corner", "[09.6]") {
    for (const Real sign : {1.0, -1.0}) {
        const GridShape shape = unit_cells({5, 5, 5});
        const Ray ray{Vec3(2.5) - 4 * sign * Vec3(1), Vec3(sign)};
        const std::vector<CellVisit> visits = cells_along(shape, ray, {});
        INFO(show_all(cells_of(visits)));
        CHECK(fault_of(shape, ray, visits) == "");
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
        INFO(show(ray) << ": " << visits.size() << " visits; "
                       << first_difference(cells_of(visits), truth.cells));
        CHECK(fault_of(shape, ray, visits) == "");
        // There are 67 boundaries from −668 to 404, 18 from −340 to −64 and 54 from 77 to −784; those at −64
        // and −784 are crossed at the end of the way there, and not at all at the beginning of the way back.
        CHECK(truth.cells.size() == (ray.origin == from ? 1 + 67 + 18 + 54 : 1 + 67 + 17 + 53));
        CHECK(visits.size() == truth.cells.size());
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
                CAPTURE(show(from), show(d), range);
                CHECK(visits.size() <= 7 + 5 + 3 + 1);
                for (const CellVisit& visit : visits)
                    CHECK((glm::all(glm::greaterThanEqual(visit.cell, Cells(0))) &&
                           glm::all(glm::lessThan(visit.cell, shape.cells))));
            }
    INFO("a direction so small along x that the ray stays in its column");
    CHECK(cells_along(shape, {{3.5, 0, 1.5}, {least, 1, 0}}, {}).size() == 5);
}
