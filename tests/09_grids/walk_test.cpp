// The cells along a ray: which, in which order, and for which part of the ray.
#include "common/math/error.hpp"
#include "tests/09_grids/show.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/box.hpp"
#include "tests/stability/grids.hpp"
#include "tests/support.hpp"

#include <cstdlib>

using namespace rt;
using rt::test::cases;
using rt::test::Random;
using rt::test::show;

namespace {

/// A box from 0 to the numbers of its cells: cells of edge 1.
GridShape unit_cells(const Cells& cells) { return {{Vec3(0), Vec3(cells)}, cells}; }

std::string show_all(const std::vector<Cells>& cells) {
    std::string text;
    for (const Cells& cell : cells) text += (text.empty() ? "" : " ") + show(cell);
    return text;
}

std::vector<Cells> cells_of(const std::vector<CellVisit>& visits) {
    std::vector<Cells> cells;
    for (const CellVisit& visit : visits) cells.push_back(visit.cell);
    return cells;
}

int steps_between(const Cells& a, const Cells& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

/// How far, in units of u times the size of the numbers, the ray may be outside the cell that it is said to
/// be in: 4 roundings a boundary in t, 2 in the box, and 3 in each of near and far.
constexpr Real allowed = 16;

/// What is wrong with the visits, whatever the order of cells; empty if nothing is.
std::string fault_of(const GridShape& shape, const Ray& ray, const std::vector<CellVisit>& visits) {
    const Cells& n = shape.cells;
    if (visits.size() > static_cast<std::size_t>(n.x + n.y + n.z + 1))
        return "more visits than nx + ny + nz + 1";
    const Vec3 size =
        glm::max(glm::max(glm::abs(shape.box.low), glm::abs(shape.box.high)), glm::abs(ray.origin));
    const Real unit = unit_roundoff * std::max({size.x, size.y, size.z});
    for (std::size_t i = 0; i < visits.size(); ++i) {
        const auto& [cell, t] = visits[i];
        const std::string which = "visit " + std::to_string(i) + " of cell " + show(cell);
        if (glm::any(glm::lessThan(cell, Cells(0))) || glm::any(glm::greaterThanEqual(cell, n)))
            return which + " is outside the grid";
        if (!(t.min <= t.max)) return which + " ends before it begins";
        if (i > 0 && t.min != visits[i - 1].t.max) return which + " does not begin where the last one ends";
        if (i > 0 && steps_between(cell, visits[i - 1].cell) != 1)
            return which + " is not next to the last one";
        for (const Real s : {t.min, t.max, t.min + (t.max - t.min) / 2})
            if (oracle::distance_from_cell(shape, cell, ray, s) > allowed * unit)
                return which + ": the ray is not there at t = " + stability::literal(s);
    }
    return {};
}

}  // namespace

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
        CHECK(fault_of(shape, ray, visits) == "");
        const oracle::WalkTruth truth = oracle::judge_walk(shape, ray, {0, 1});
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

TEST_CASE("the walk is exact, and the one that adds up is not", "[09.6][stability]") {
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
        CHECK(fault_of(shape, ray, visits) == "");

        // Boundaries that are nearer to each other than rounding may be crossed in either order.
        const oracle::WalkTruth truth = oracle::judge_walk(shape, ray, *part);
        if (truth.least_gap <= 16 * unit_roundoff) {
            ++undecided;
            continue;
        }
        CHECK(show_all(cells_of(visits)) == show_all(truth.cells));
        if (cells_of(naive::cells_along(shape, ray, *part)) != truth.cells) ++wrong_when_adding;
    }
    CHECK(undecided < all / 2);

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
    CAPTURE(wrong_when_adding, farthest, farthest_added);
    CHECK(farthest <= allowed);
    CHECK(farthest_added > 4 * allowed);
}
