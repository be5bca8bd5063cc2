// How many cells, which shapes are in them, and grids inside grids.
#include "chapters/09_grids/build.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "tests/09_grids/visits.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <numeric>

using namespace rt;
using rt::test::cases;
using rt::test::for_each_cell;
using rt::test::items_of;
using rt::test::or_say;
using rt::test::Random;
using rt::test::show;
using rt::test::unit_cells;

namespace {

const Bounds unit_box{Vec3(0), Vec3(1)};

void check_resolution(const Bounds& box, std::size_t count, Real density, const Cells& cells,
                      int most = 1024) {
    INFO("how many cells there are along x, y and z for " << count << " shapes in a " << box << ", density "
                                                          << density << ", at most " << most
                                                          << " along an axis");
    CHECK(grid_resolution(box, count, density, most) == cells);
}

/// Whether a shape is taken for one that overlaps a box.
template <class Shape>
void check_overlaps(const Shape& shape, const Bounds& box) {
    INFO(shape << " and the " << box);
    CHECK(test::or_say(overlaps(shape, box), "they do not overlap, expected that they do"));
}
template <class Shape>
void check_apart(const Shape& shape, const Bounds& box, const std::string& because = "") {
    INFO(shape << " and the " << box << (because.empty() ? "" : ": " + because));
    CHECK(test::or_say(!overlaps(shape, box), "they overlap, expected that they do not"));
}

Real total(const Cells& cells) {
    return static_cast<Real>(cells.x) * static_cast<Real>(cells.y) * static_cast<Real>(cells.z);
}

Bounds box_of(const Vec3& edges) { return {Vec3(0), edges}; }

/// The margin as the contract has it.
Real margin_for(const Bounds& around) {
    const Vec3 edges = around.high - around.low;
    const Vec3 size = glm::max(glm::abs(around.low), glm::abs(around.high));
    return 0x1p-30 * max_component(edges) + 0x1p-44 * max_component(size);
}

/// What is left of a polygon on one side of a plane of the box.
std::vector<Vec3> cut(const std::vector<Vec3>& polygon, int axis, Real at, Real sign) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const Real hp = sign * (p[axis] - at), hq = sign * (q[axis] - at);
        if (hp <= 0) kept.push_back(p);
        if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) kept.push_back(p + hp / (hp - hq) * (q - p));
    }
    return kept;
}

/// Whether the triangle has points in the box, by cutting it down to the box (Sutherland & Hodgman 1974).
bool meets(const Triangle& t, const Bounds& box) {
    std::vector<Vec3> polygon{t.a, t.b, t.c};
    for (int a = 0; a < 3; ++a) polygon = cut(cut(polygon, a, box.high[a], 1), a, box.low[a], -1);
    return !polygon.empty();
}

Triangle some_triangle(Random& random, Real size) {
    const Vec3 place = random.in_cube();
    return {place + size * random.in_cube(), place + size * random.in_cube(),
            place + size * random.in_cube()};
}

/// A box, flat now and then.
Bounds some_box(Random& random) {
    const Vec3 p = random.in_cube(), q = random.in_cube();
    Bounds box{glm::min(p, q), glm::max(p, q)};
    if (random.index(4) == 0) box.high.y = box.low.y;
    return box;
}

constexpr Real slack = 1e-12;  // more than the rounding of numbers of size 10

std::vector<Triangle> some_triangles(Random& random, int count) {
    std::vector<Triangle> triangles;
    for (int k = 0; k < count; ++k) triangles.push_back(some_triangle(random, random.magnitude(-2, 0)));
    return triangles;
}

Grid grid_of(const std::vector<Triangle>& triangles, const GridOptions& options) {
    return build_grid(std::span<const Triangle>(triangles), options);
}

void check_items(const Grid& grid, const Cells& cell, const std::vector<std::uint32_t>& expected) {
    INFO("the shapes that the cell " << cell << " lists");
    const std::vector<std::uint32_t> items = items_of(grid, cell);
    CHECK(test::or_say(items == expected, show(items) + ", expected " + show(expected)));
}

/// The cells of the block that list the shape, in any order.
void check_listed(const GridShape& shape, const CellBlock& block, const Overlaps& overlaps, std::uint32_t i,
                  const std::vector<Cells>& expected, Real margin = 0) {
    INFO("the cells from " << block.low << " to " << block.high << " that shape " << i << " is in");
    std::vector<std::uint32_t> numbers = cells_with(shape, block, overlaps, i, margin);
    std::ranges::sort(numbers);
    std::vector<Cells> listed;
    for (const std::uint32_t number : numbers) {
        const int n = static_cast<int>(number), yz = n / shape.cells.x;
        listed.emplace_back(n % shape.cells.x, yz % shape.cells.y, yz / shape.cells.y);
    }
    CHECK(test::or_say(listed == expected,
                       "listed: " + test::show_all(listed) + "; expected: " + test::show_all(expected)));
}

/// The lists, a vector for each cell.
void check_lists(const CellLists& lists, const std::vector<std::vector<std::uint32_t>>& expected) {
    {
        INFO(
            "how many numbers `first` has, one more than cells; and how many items there are, at least as "
            "many "
            "as the greatest of them");
        REQUIRE(lists.first.size() == expected.size() + 1);
        REQUIRE(lists.items.size() >= *std::ranges::max_element(lists.first));
    }
    for (std::size_t cell = 0; cell < expected.size(); ++cell) {
        const auto begin = static_cast<std::ptrdiff_t>(lists.first[cell]);
        const auto end = std::max(begin, static_cast<std::ptrdiff_t>(lists.first[cell + 1]));
        const std::vector<std::uint32_t> items(lists.items.begin() + begin, lists.items.begin() + end);
        INFO("what cell " << cell << " lists, from place " << begin << " of `items` up to place "
                          << lists.first[cell + 1]);
        CHECK(test::or_say(items == expected[cell], show(items) + ", expected " + show(expected[cell])));
    }
}

/// The greatest number of grids inside each other.
int depth_of(const Grid& grid) {
    int deepest = 0;
    for (const Grid& inner : grid.grids) deepest = std::max(deepest, depth_of(inner));
    return deepest + 1;
}

/// Whether the cell, of the grid or of one in it, in which the point is, lists the shape.
bool lists(const Grid& grid, const Vec3& point, std::uint32_t shape) {
    const Cells& n = grid.shape.cells;
    const Vec3 place = (point - grid.shape.box.low) / (grid.shape.box.high - grid.shape.box.low) * Vec3(n);
    const Cells cell = glm::clamp(Cells(glm::floor(place)), Cells(0), n - 1);
    const auto number = static_cast<std::size_t>((cell.z * n.y + cell.y) * n.x + cell.x);
    if (!grid.inner.empty() && grid.inner[number] > 0)
        return lists(grid.grids[grid.inner[number] - 1], point, shape);
    const std::vector<std::uint32_t> items = items_of(grid, cell);
    return std::ranges::find(items, shape) != items.end();
}

}  // namespace

TEST_CASE("a cube gets as many cells along each axis", "[09.3]") {
    check_resolution(unit_box, 1000, 1, Cells(10));
    check_resolution(unit_box, 250, 4, Cells(10));
    check_resolution({Vec3(-3), Vec3(-1)}, 27, 1, Cells(3));
    // A count of cells that is no cube: 100 = 4.64 cubed.
    check_resolution(unit_box, 100, 1, Cells(5));
}

TEST_CASE("a longer edge gets more cells: they are cubes", "[09.3]") {
    check_resolution(box_of({4, 2, 1}), 64, 1, Cells(8, 4, 2));
    check_resolution(box_of({1, 4, 2}), 64, 1, Cells(2, 8, 4));
    check_resolution(box_of({10, 10, 1}), 100, 8, Cells(20, 20, 2));
}

TEST_CASE("a thin axis gets one cell, and the others share", "[09.3]") {
    check_resolution(box_of({100, 100, 1}), 100, 4, Cells(20, 20, 1));
    check_resolution(box_of({100, 0, 100}), 100, 4, Cells(20, 1, 20));
    check_resolution(box_of({1, 1000, 1}), 10, 4, Cells(1, 40, 1));
    check_resolution(box_of({0, 0, 7}), 10, 4, Cells(1, 1, 40));
    // A point, an empty box, and no shapes.
    check_resolution(box_of({0, 0, 0}), 10, 4, Cells(1));
    check_resolution(Bounds{}, 10, 4, Cells(1));
    check_resolution(unit_box, 0, 4, Cells(1));
}

TEST_CASE("there are never more cells than allowed", "[09.3]") {
    check_resolution(box_of({0, 0, 7}), 1'000'000, 4, Cells(1, 1, 1024));
    check_resolution(unit_box, 1'000'000'000, 64, Cells(100), 100);
    check_resolution(box_of({1, 1e-300, 1e-300}), 1'000'000, 4, Cells(1024, 1, 1));
}

TEST_CASE("the number of cells is near density times shapes, and cells are nearly cubes", "[09.3]") {
    Random random(96);
    for (int k = 0; k < cases(2000); ++k) {
        const Vec3 edges(random.magnitude(-1, 1), random.magnitude(-1, 1), random.magnitude(-1, 1));
        const auto count = static_cast<std::size_t>(random.magnitude(2, 6));
        const Real density = random.uniform(1, 8);
        const Cells cells = grid_resolution(box_of(edges), count, density);
        INFO("edges " << edges << ", " << count << " shapes, density " << density << ": " << cells
                      << " cells");
        // Rounding makes at most 1.5 of 1, along each of three axes; it makes 1 of no less than 1.5.
        const Real wanted = density * static_cast<Real>(count);
        {
            INFO("how many in all");
            CHECK(total(cells) < 3.4 * wanted);
            CHECK(total(cells) > wanted / 3.4);
        }
        Vec3 size = edges / Vec3(cells);
        std::sort(&size.x, &size.x + 3);
        if (std::min({cells.x, cells.y, cells.z}) >= 8 && std::max({cells.x, cells.y, cells.z}) < 1024) {
            INFO("the longest and the shortest edge of a cell, and how many cells in all");
            CHECK(size.z <= 1.14 * size.x);
            CHECK(total(cells) == Approx(wanted).epsilon(0.2));
        }
    }
}

TEST_CASE("a box larger by a power of two gets the same cells", "[09.3]") {
    Random random(97);
    for (int k = 0; k < cases(2000); ++k) {
        const Vec3 edges(random.magnitude(-4, 0), random.magnitude(-4, 0), random.magnitude(-4, 0));
        const std::size_t count = 1 + random.index(100'000);
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(1200)) - 600);
        INFO("edges " << edges << ", " << count << " shapes: the cells, expected those of a box " << scale
                      << " times as large");
        CHECK(grid_resolution(box_of(edges), count, 4) == grid_resolution(box_of(scale * edges), count, 4));
    }
}

TEST_CASE("boxes overlap where they have a point in common", "[09.4]") {
    const Bounds box{Vec3(0), Vec3(2)};
    check_overlaps(Bounds{Vec3(1), Vec3(3)}, box);
    check_overlaps(Bounds{Vec3(-1), Vec3(1)}, box);
    // One in the other, either way; and two that cross, with no corner in each other.
    check_overlaps(Bounds{Vec3(0.5), Vec3(1)}, box);
    check_overlaps(Bounds{Vec3(-5), Vec3(5)}, box);
    check_overlaps(Bounds{{-1, 0.5, 0.5}, {3, 1, 1}}, box);
    // Touching in a face, an edge and a corner.
    check_overlaps(Bounds{{2, 0, 0}, {3, 1, 1}}, box);
    check_overlaps(Bounds{{-1, -1, 0}, {0, 0, 1}}, box);
    check_overlaps(Bounds{Vec3(2), Vec3(3)}, box);
}

TEST_CASE("boxes are apart where along one axis one of them ends before the other begins", "[09.4]") {
    const Bounds box{Vec3(0), Vec3(2)};
    for (int axis = 0; axis < 3; ++axis)
        for (const Real by : {-3.0, 3.0}) {
            Bounds other{Vec3(0.5), Vec3(1)};
            other.low[axis] += by;
            other.high[axis] += by;
            check_apart(other, box);
            check_apart(box, other);
        }
    check_apart(Bounds{}, box);
}

TEST_CASE("a sphere is where its surface is", "[09.5]") {
    const Sphere sphere{{0, 0, 0}, 1};
    check_overlaps(sphere, {Vec3(-2), Vec3(2)});
    check_overlaps(sphere, {{0.9, -0.1, -0.1}, {1.1, 0.1, 0.1}});
    // Touched from outside.
    check_overlaps(sphere, {{1, 0, 0}, {2, 1, 1}});
    // Near a corner of the sphere's box, where the sphere is not.
    check_overlaps(sphere, {Vec3(0.5), Vec3(1)});
    check_apart(sphere, {Vec3(0.6), Vec3(1)});
    // Far away, and inside, where there is no surface.
    check_apart(sphere, {{1.1, 0, 0}, {2, 1, 1}});
    check_apart(sphere, {Vec3(-0.5), Vec3(0.5)});
    check_apart(sphere, {{0.1, 0.1, 0.1}, {0.5, 0.5, 0.5}});
}

TEST_CASE("a sphere that is not of radius 1, beside a face of the box", "[09.5]") {
    // It comes to x = 3, and at y or z = 1.2 to x = 2.6.
    const Sphere sphere{{1, 0, 0}, 2};
    check_overlaps(sphere, {{2.9, -5, -5}, {9, 5, 5}});
    check_apart(sphere, {{3.1, -5, -5}, {9, 5, 5}});
    check_overlaps(sphere, {{2.5, 1.2, 0}, {3, 2, 1}});
    check_apart(sphere, {{2.7, 1.2, 0}, {3, 2, 1}});
    check_apart(sphere, {{-0.1, -1.1, -1.1}, {2.1, 1.1, 1.1}});
    check_overlaps(sphere, {{-0.1, -1.3, -1.3}, {2.1, 1.3, 1.3}});
}

TEST_CASE("a sphere that overlaps a box is never missed, and none is made up", "[09.5]") {
    Random random(98);
    for (int k = 0; k < cases(20'000); ++k) {
        const Bounds box = some_box(random);
        const Sphere sphere{random.in_cube(), random.magnitude(-2, 0.5)};
        const Vec3 nearest = glm::clamp(sphere.center, box.low, box.high);
        const Vec3 farthest = glm::max(glm::abs(box.low - sphere.center), glm::abs(box.high - sphere.center));
        const bool apart = length(nearest - sphere.center) > sphere.radius + slack;
        const bool inside = length(farthest) < sphere.radius - slack;
        if (apart || inside) check_apart(sphere, box);
        const Vec3 on_sphere = sphere.center + sphere.radius * random.direction();
        check_overlaps(sphere, grown({on_sphere, on_sphere}, slack));
    }
}

TEST_CASE("a triangle is apart from a box along an axis, or along its normal", "[09.6]") {
    const Triangle slanted{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
    check_overlaps(slanted, {Vec3(0.9), Vec3(1.1)});
    const char* const normal = "the triangle's normal parts them";
    check_apart(slanted, {Vec3(0), Vec3(0.9)}, normal);
    check_apart(slanted, {Vec3(1.1), Vec3(2)}, normal);
    check_apart(slanted, {{4, 0, 0}, {5, 1, 1}}, "the box's axis x parts them");
    check_apart(slanted, {{0, -2, 0}, {1, -1, 1}}, "the box's axis y parts them");
    check_apart(slanted, {{0, 0, 3.1}, {1, 1, 4}}, "the box's axis z parts them");
}

TEST_CASE("a triangle is apart from a box along an edge times an axis", "[09.6]") {
    const Bounds cube{Vec3(-1), Vec3(1)};
    // In a plane across an axis, only the triangle's edge from (2.5, -0.3) to (-0.3, 2.5) parts it from the
    // cube, times that axis. It is put across each axis, and begins at each of its corners.
    const std::array flat{Vec3(2.5, -0.3, 0), Vec3(-0.3, 2.5, 0), Vec3(3, 3, 0)};
    const char* const edges[] = {"from a to b", "from c to a", "from b to c"};
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t first = 0; first < 3; ++first) {
            const auto corner = [&](std::size_t k) {
                const Vec3& p = flat[(k + first) % 3];
                return axis == 2 ? p : axis == 1 ? Vec3(p.y, p.z, p.x) : Vec3(p.z, p.x, p.y);
            };
            check_apart(
                Triangle{corner(0), corner(1), corner(2)}, cube,
                std::string("the edge ") + edges[first] + " times the axis " + "xyz"[axis] + " parts them");
        }
    check_overlaps(Triangle{{2.2, -0.3, 0}, {-0.3, 2.2, 0}, {3, 3, 0}}, cube);
}

TEST_CASE("a triangle inside a box, and a box in the middle of a triangle", "[09.6]") {
    const Bounds cube{Vec3(-1), Vec3(1)};
    check_overlaps(Triangle{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, cube);
    check_overlaps(Triangle{{-9, -9, 0.5}, {9, -9, 0.5}, {0, 9, 0.5}}, cube);
    check_overlaps(Triangle{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, cube);
}

TEST_CASE("a triangle that overlaps a box is never missed, and none is made up", "[09.6]") {
    Random random(98);
    int yes = 0, no = 0;
    for (int k = 0; k < cases(20'000); ++k) {
        const Bounds box = some_box(random);
        const Triangle t = some_triangle(random, random.magnitude(-3, 1));
        if (meets(t, box)) check_overlaps(t, grown(box, slack));
        if (!meets(t, grown(box, slack))) check_apart(t, box);
        (overlaps(t, box) ? yes : no) += 1;
    }
    INFO("how many triangles overlap, and how many do not");
    CHECK(yes > cases(20'000) / 20);
    CHECK(no > cases(20'000) / 20);
}

TEST_CASE("tiny triangles, whose edges' products underflow, are found where they are", "[09.6]") {
    const Real s = 1e-170;
    const auto at = [&](const Vec3& p) { return Triangle{p, p + Vec3(s, 0, 0), p + Vec3(0, s, s)}; };
    for (const Real x : {0.0, 0.5, 1.0}) check_overlaps(at(Vec3(x)), unit_box);
    check_apart(at({1 + 1e-9, 0, 0}), unit_box);
    // Tiny against a box that is as tiny.
    check_overlaps(at(Vec3(0)), {Vec3(0), Vec3(s)});
    // Where products underflow, 'may be' is a right answer about a tiny triangle beside a box as tiny.
}

TEST_CASE("a large slanted triangle is in as many cells as its area asks for", "[09.6]") {
    const int n = 32;
    const Triangle diagonal{{0, 0, 0}, {1, 1, 0}, {0, 0.5, 1}};
    const GridShape shape{unit_box, Cells(n)};
    int in = 0;
    for_each_cell(shape.cells, [&](const Cells& cell) { in += overlaps(diagonal, cell_box(shape, cell)); });
    INFO("of " << n * n * n << " cells, how many it is in; its box alone would be in half of them");
    CHECK(in > n * n / 2);
    CHECK(in < 3 * n * n);
}

TEST_CASE("the cells of a shape are those of the block that it overlaps", "[09.7]") {
    // A sheet along z that passes from (0.5, 0) to (4, 3.5) through cells of edge 1.
    const Overlaps sheet = [](std::uint32_t, const Bounds& box) {
        return box.low.x - box.high.y <= 0.5 && box.high.x - box.low.y >= 0.5;
    };
    const GridShape shape = unit_cells({4, 4, 1});
    INFO("a sheet through 4 x 4 x 1 cells of edge 1, from x = 0.5 at y = 0 to x = 4 at y = 3.5");
    check_listed(shape, {Cells(0), {3, 3, 0}}, sheet, 0,
                 {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {3, 2, 0}, {3, 3, 0}});
    check_listed(shape, {{1, 1, 0}, {2, 2, 0}}, sheet, 0, {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}});
    check_listed(shape, {{3, 0, 0}, {3, 0, 0}}, sheet, 0, {});
}

TEST_CASE("a cell is a block of one, and the numbers of cells go along x, then y, then z", "[09.7]") {
    const Overlaps everywhere = [](std::uint32_t, const Bounds&) { return true; };
    const GridShape shape = unit_cells({4, 3, 2});
    INFO("a shape that is everywhere, in 4 x 3 x 2 cells");
    check_listed(shape, {{2, 1, 1}, {2, 1, 1}}, everywhere, 0, {{2, 1, 1}});
    check_listed(shape, {{1, 2, 0}, {3, 2, 1}}, everywhere, 0,
                 {{1, 2, 0}, {2, 2, 0}, {3, 2, 0}, {1, 2, 1}, {2, 2, 1}, {3, 2, 1}});
}

TEST_CASE("a shape is in the cells that it comes within the margin of", "[09.7]") {
    // Number 0 ends just before the boundary at x = 1, number 1 a little earlier, number 2 behind the grid.
    const Real places[] = {0.95, 0.85, 8.05};
    const Overlaps small = [&](std::uint32_t i, const Bounds& box) {
        return box.low.x <= places[i] && places[i] <= box.high.x;
    };
    const GridShape shape = unit_cells({8, 1, 1});
    const CellBlock all{Cells(0), {7, 0, 0}};
    INFO("shapes at x = 0.95, 0.85 and 8.05 in a row of 8 cells of edge 1; the margin is 0.125");
    check_listed(shape, all, small, 0, {{0, 0, 0}, {1, 0, 0}}, 0.125);
    check_listed(shape, all, small, 1, {{0, 0, 0}}, 0.125);
    check_listed(shape, all, small, 2, {{7, 0, 0}}, 0.125);
}

TEST_CASE("by hand: four lists in one array", "[09.8]") {
    // Shape 3 is in the cells 0 and 1, shape 5 in cell 1, shape 8 in the cells 3, 1 and 0.
    const std::vector<std::uint32_t> numbers{0, 1, 1, 3, 1, 0}, ends{2, 3, 6}, shapes{3, 5, 8};
    const CellLists lists = lists_by_cell(4, numbers, ends, shapes);
    INFO("shape 3 in the cells 0 and 1, shape 5 in cell 1, shape 8 in the cells 3, 1 and 0, of four cells");
    check_lists(lists, {{3, 8}, {3, 5, 8}, {}, {8}});
    INFO("no shapes in two cells");
    check_lists(lists_by_cell(2, {}, {}, {}), {{}, {}});
}

TEST_CASE("each cell lists the shapes that are in it, in order", "[09.8]") {
    Random random(99);
    for (int k = 0; k < cases(100); ++k) {
        const std::size_t count = 1 + random.index(20);
        std::vector<std::vector<std::uint32_t>> expected(count);
        std::vector<std::uint32_t> numbers, ends, shapes;
        for (std::uint32_t i = 0; i < 30; ++i) {
            shapes.push_back(2 * i + 1);
            for (std::uint32_t cell = 0; cell < count; ++cell) {
                if (random.index(4) > 0) continue;
                numbers.push_back(cell);
                expected[cell].push_back(shapes.back());
            }
            ends.push_back(static_cast<std::uint32_t>(numbers.size()));
        }
        INFO("30 shapes with odd numbers in " << count << " cells");
        check_lists(lists_by_cell(count, numbers, ends, shapes), expected);
    }
}

TEST_CASE("every shape is in exactly the cells that it overlaps, in ascending order", "[09.8]") {
    Random random(99);
    for (int k = 0; k < cases(40); ++k) {
        const std::vector<Triangle> triangles =
            some_triangles(random, 1 + static_cast<int>(random.index(60)));
        Bounds around;
        for (const Triangle& t : triangles) around = merge(around, bounds_of(t));
        const Real margin = margin_for(around);
        const Grid grid = grid_of(triangles, {.density = random.uniform(1, 6), .nested = false});

        INFO(triangles.size() << " triangles in " << grid.shape.cells << " cells");
        CHECK(test::or_say(grid.shape.box == grown(around, margin),
                           show(grid.shape.box) + ", expected " + show(grown(around, margin))));
        {
            INFO(
                "how many numbers `first` has, one more than cells; its last, the number of items; and inner "
                "grids");
            REQUIRE(grid.first.size() == static_cast<std::size_t>(total(grid.shape.cells)) + 1);
            REQUIRE(grid.first.back() == grid.items.size());
            CHECK(grid.inner.size() == 0);
        }
        int wrong = 0;
        std::string first_wrong;
        for_each_cell(grid.shape.cells, [&](const Cells& cell) {
            std::vector<std::uint32_t> expected;
            const Bounds box = grown(cell_box(grid.shape, cell), margin);
            for (std::uint32_t i = 0; i < triangles.size(); ++i)
                if (overlaps(triangles[i], box)) expected.push_back(i);
            if (expected != items_of(grid, cell) && wrong++ == 0)
                first_wrong = show(cell) + " of " + show(grid.shape.cells) + " lists " +
                              show(items_of(grid, cell)) + ", expected " + show(expected);
        });
        CHECK(test::or_say(wrong == 0, show(wrong) + " of the cells are wrong; the first: " + first_wrong));
    }
}

TEST_CASE("a shape that ends at a boundary is in the cells on both sides", "[09.8]") {
    // Eight cubes of edge 1, and a boundary at x = 1; the last triangle is half a margin beyond it.
    std::vector<Triangle> triangles;
    for (int k = 0; k < 2; ++k) triangles.push_back({Vec3(2 * k), Vec3(2 * k, 2 * k, 1), Vec3(2 * k, 1, 1)});
    const Real x = 1 + margin_for({Vec3(0), Vec3(2)}) / 2;
    triangles.push_back({{x, 0.25, 0.25}, {x, 0.75, 0.25}, {x, 0.25, 0.75}});
    const Grid grid = grid_of(triangles, {.density = 2.7, .nested = false});
    INFO(
        "three triangles in 2 x 2 x 2 cells of edge 1; number 2 lies at x = 1, half a margin beyond the "
        "boundary");
    REQUIRE(grid.shape.cells == Cells(2));
    check_items(grid, {0, 0, 0}, {0, 2});
    check_items(grid, {1, 0, 0}, {1, 2});
    check_items(grid, {0, 1, 0}, {0});
}

TEST_CASE("the inside of a sphere is empty, and so are shapes without a point", "[09.8]") {
    const std::vector<Sphere> spheres{{{0, 0, 0}, 1}};
    const Grid grid = build_grid(std::span<const Sphere>(spheres), {.density = 729, .nested = false});
    INFO("a sphere in 9 x 9 x 9 cells");
    REQUIRE(grid.shape.cells == Cells(9));
    check_items(grid, Cells(4), {});  // in the middle
    check_items(grid, Cells(0), {});  // in a corner of its box
    check_items(grid, Cells(0, 4, 4), {0});

    const std::vector<Bounds> bounds{Bounds{}, unit_box, Bounds{}};
    const Grid one =
        build_grid(bounds, [&](std::uint32_t i, const Bounds& box) { return overlaps(bounds[i], box); },
                   {.nested = false});
    INFO(
        "three boxes, of which the first and the last are empty: how often number 1 is listed, expected all "
        "items");
    CHECK(std::ranges::count(one.items, 1u) == static_cast<std::ptrdiff_t>(one.items.size()));
    CHECK(one.items.size() > 0);
    const Grid none = build_grid(std::span<const Triangle>(), {});
    INFO("no shapes at all: items, and numbers in `first`");
    CHECK(none.items.size() == 0);
    CHECK(none.first.size() > 0);
}

TEST_CASE("by hand: four shapes are a crowd where three are allowed, and none where four are", "[09.13]") {
    // Of five cells along x, the first has four small boxes side by side, the last a fifth.
    std::vector<Bounds> bounds;
    for (const Real x : {0.0, 0.1, 0.2, 0.3, 10.0}) bounds.push_back({{x, 0, 0}, {x + 0.01, 0.01, 0.01}});
    const Overlaps along_x = [&](std::uint32_t i, const Bounds& box) {
        return bounds[i].low.x <= box.high.x && box.low.x <= bounds[i].high.x;
    };
    const auto grid_with = [&](int crowd) {
        return build_grid(bounds, along_x, {.density = 1, .crowd = crowd});
    };
    {
        INFO("a cell with 4 shapes where `crowd` is 4: how many inner grids there are");
        CHECK(grid_with(4).grids.size() == 0);
    }
    const Grid grid = grid_with(3);
    {
        INFO(
            "a cell with 4 shapes where `crowd` is 3: how many inner grids there are. Over these shapes it "
            "has 4 "
            "cells along x, which list one shape each: a quarter of them, which is not too much");
        REQUIRE(grid.grids.size() == 1);
    }
    INFO("the inner grid over 4 shapes: how many cells it has along x, y and z");
    CHECK(grid.grids[0].shape.cells == Cells(4, 1, 1));
}

TEST_CASE("a crowded cell gets a grid of its own, and no more of them than allowed", "[09.13]") {
    // A crowd of 400 in a ten-thousandth of the floor.
    Random random(912);
    std::vector<Triangle> triangles{{{-1e4, 0, -1e4}, {1e4, 0, -1e4}, {0, 0, 1e4}}};
    for (int k = 0; k < 400; ++k) triangles.push_back(some_triangle(random, 0.1));

    const Grid uniform = grid_of(triangles, {.nested = false});
    INFO("400 triangles in a small part of a large one");
    {
        INFO("inner grids, where nested is false");
        CHECK(uniform.grids.size() == 0);
        CHECK(uniform.inner.size() == 0);
    }
    const Grid nested = grid_of(triangles, {});
    {
        INFO("inner grids, where a cell is crowded");
        REQUIRE(nested.grids.size() > 0);
    }
    for (const int most : {1, 2, 4}) {
        INFO("how many grids are inside each other, the outermost counted, where `depth` allows "
             << most << " of them");
        if (most <= 2)
            CHECK(depth_of(grid_of(triangles, {.depth = most})) == most);
        else
            CHECK(depth_of(grid_of(triangles, {.depth = most})) <= most);
    }
    {
        INFO("inner grids, where 1000 are not a crowd yet");
        CHECK(grid_of(triangles, {.crowd = 1000}).grids.size() == 0);
    }
    INFO("numbers in `inner` and 1 more, those in `first`");
    REQUIRE(nested.inner.size() + 1 == nested.first.size());
    std::size_t with_grid = 0;
    for (std::size_t number = 0; number < nested.inner.size(); ++number) {
        if (nested.inner[number] == 0) continue;
        ++with_grid;
        INFO("cell " << number << " has a grid, and so no items of its own");
        CHECK(nested.first[number] == nested.first[number + 1]);
        REQUIRE(nested.inner[number] <= nested.grids.size());
        CHECK(nested.grids[nested.inner[number] - 1].reach == nested.reach);
    }
    CHECK(with_grid == nested.grids.size());
}

TEST_CASE("a crowd inside a crowd gets a grid inside the inner grid", "[09.13]") {
    // 300 triangles all over the cube, 300 in a thousandth of it, and 300 in a thousandth of that.
    Random random(914);
    std::vector<Triangle> triangles;
    for (const Real size : {1.0, 1e-3, 1e-6})
        for (int k = 0; k < 300; ++k) {
            const Vec3 p = size * random.in_cube();
            triangles.push_back({p, p + 0.01 * size * random.in_cube(), p + 0.01 * size * random.in_cube()});
        }
    for (const int most : {3, 2, 1}) {
        INFO(
            "a crowd inside a crowd inside a third: how many grids are inside each other, the outermost "
            "counted, where `depth` allows "
            << most << " of them");
        CHECK(depth_of(grid_of(triangles, {.depth = most})) == most);
    }
}

TEST_CASE("scenes without thickness, of one point, or of the same shape again and again get grids",
          "[09.13]") {
    Random random(910);
    std::vector<Triangle> flat = some_triangles(random, 500);
    for (Triangle& t : flat) t.a.y = t.b.y = t.c.y = 3;
    const Grid sheet = grid_of(flat, {.nested = false});
    {
        INFO("500 triangles in a plane of constant y: how many cells there are along y");
        CHECK(sheet.shape.cells.y == 1);
    }
    {
        INFO("500 triangles in a plane of constant y: how many cells there are in all");
        CHECK(total(sheet.shape.cells) > 1000);
    }

    const std::vector<Triangle> point(100, Triangle{Vec3(0.1), Vec3(0.1), Vec3(0.1)});
    {
        INFO("a hundred triangles in one point: how many cells there are along x, y and z");
        CHECK(grid_of(point, {}).shape.cells == Cells(1));
    }

    const std::vector<Triangle> same(400, Triangle{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}});
    const Grid grid = grid_of(same, {});
    INFO(same.size() << " times the same triangle: how many bytes the grid takes");
    CHECK(bytes_of(grid) < 1000 * same.size());
}

TEST_CASE("a scene larger by a power of two gets the same grid", "[09.13]") {
    Random random(911);
    const std::vector<Triangle> triangles = some_triangles(random, 200);
    const Grid grid = grid_of(triangles, {});
    for (const int k : {-300, -40, 1, 40, 300}) {
        std::vector<Triangle> scaled = triangles;
        for (Triangle& t : scaled)
            for (Vec3* p : {&t.a, &t.b, &t.c}) *p *= std::ldexp(1.0, k);
        const Grid other = grid_of(scaled, {});
        INFO("200 triangles, and 2^" << k << " times as large");
        CHECK(test::or_say(grid.first == other.first, "`first` differs"));
        CHECK(test::or_say(grid.items == other.items, "`items` differ"));
        CHECK(test::or_say(grid.inner == other.inner, "`inner` differs"));
    }
}

TEST_CASE("wherever a shape has a point, the cell there lists the shape, in inner grids too", "[09.13]") {
    Random random(913);
    for (int k = 0; k < cases(60); ++k) {
        std::vector<Triangle> triangles = some_triangles(random, 100);
        for (std::size_t i = 0; i < 70; ++i)  // most in a small part
            for (Vec3* p : {&triangles[i].a, &triangles[i].b, &triangles[i].c}) *p *= 0.001;
        const Grid grid = grid_of(triangles, {.density = random.uniform(1, 8), .crowd = 4});
        INFO("100 triangles, most in a small part, in a grid of grids: how many inner grids there are");
        CHECK(grid.grids.size() > 0);
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const Triangle& t = triangles[i];
            const Real b = random.uniform(0, 1), c = random.uniform(0, 1 - b);
            const Vec3 point = (1 - b - c) * t.a + b * t.b + c * t.c;
            if (lists(grid, point, i) && lists(grid, t.a, i) && lists(grid, t.b, i)) continue;
            INFO("triangle " << i << " " << show(t) << ", point " << show(point));
            FAIL("it is not listed in the cell of each of its points");
        }
    }
}

TEST_CASE("maps that rounding distorts widen the margin", "[09.8]") {
    const auto transform_of = [](const Mat4& m) { return Transform{m, *inverse(m)}; };
    INFO("by how much a map distorts: along the axes, behind a rotation, slanted by 10^4");
    CHECK(distortion_of(transform_of(translation({1, 2, 3}) * scaling({1e4, 1, 1e-4}))) == 1);
    CHECK(distortion_of(transform_of(rotation({1, 1, 1}, 1) * scaling({1e4, 1, 1e-4}))) <= 3.01);
    const Mat4 slanted = scaling({1e4, 1, 1}) * rotation({0, 0, 1}, pi / 4);
    CHECK(distortion_of(transform_of(slanted)) == Approx(1e4).epsilon(0.01));

    const std::vector<Ellipsoid> ellipsoids(2, {transform_of(slanted), {}});
    const Grid grid = build_grid(std::span<const Ellipsoid>(ellipsoids), {.nested = false});
    const Bounds box = bounds_of(ellipsoids[0]);
    CHECK(grid.shape.box.high.x - box.high.x == Approx(1e4 * margin_for(box)).epsilon(0.01));
}

// 09.15 --------------------------------------------------------------------------------------------------

namespace {

/// Where something is listed: the lists' beginnings of cells of which these are not empty.
std::vector<std::uint32_t> beginnings(std::size_t count, const std::vector<std::size_t>& full) {
    std::vector<std::uint32_t> first(count + 1, 0);
    for (const std::size_t cell : full)
        for (std::size_t c = cell + 1; c <= count; ++c) ++first[c];
    return first;
}

void check_steps(const Cells& cells, const std::vector<std::size_t>& full, const std::vector<int>& expected) {
    std::string which;
    for (const std::size_t cell : full) which += " " + std::to_string(cell);
    const std::vector<int> steps = king_steps(cells, beginnings(expected.size(), full));
    INFO(show(cells) << " cells, of which these list something, by number:"
                     << (which.empty() ? " none" : which));
    INFO("the king's distances of all cells, in the order of their numbers");
    CHECK(or_say(steps == expected, show(steps) + ", expected " + show(expected)));
}

}  // namespace

TEST_CASE("by hand: in a row of six cells, distances fall to the full one and rise behind it", "[09.15]") {
    check_steps({6, 1, 1}, {4}, {4, 3, 2, 1, 0, 1});
    check_steps({1, 6, 1}, {4}, {4, 3, 2, 1, 0, 1});
    check_steps({6, 1, 1}, {0, 4}, {0, 1, 2, 1, 0, 1});
}

TEST_CASE("by hand: on a board the king goes along diagonals", "[09.15]") {
    check_steps({5, 3, 1}, {0}, {0, 1, 2, 3, 4, 1, 1, 2, 3, 4, 2, 2, 2, 3, 4});
}

TEST_CASE("floors of a house are a step apart", "[09.15]") {
    check_steps({2, 1, 3}, {0}, {0, 1, 1, 1, 2, 2});
}

TEST_CASE("where nothing is listed, the distance is the greatest number of cells", "[09.15]") {
    check_steps({3, 1, 2}, {}, {3, 3, 3, 3, 3, 3});
}

TEST_CASE("each distance is that to the nearest full cell", "[09.15]") {
    Random random(915);
    for (int round = 0; round < cases(50); ++round) {
        const Cells cells(1 + static_cast<int>(random.index(6)), 1 + static_cast<int>(random.index(6)),
                          1 + static_cast<int>(random.index(6)));
        const auto count = static_cast<std::size_t>(cells.x * cells.y * cells.z);
        std::vector<std::size_t> full;
        for (std::size_t c = 0; c < count; ++c)
            if (random.index(12) == 0) full.push_back(c);
        const auto place = [&](std::size_t c) {
            const int n = static_cast<int>(c);
            return Cells(n % cells.x, n / cells.x % cells.y, n / (cells.x * cells.y));
        };
        std::vector<int> expected(count, std::max({cells.x, cells.y, cells.z}));
        for (std::size_t c = 0; c < count; ++c)
            for (const std::size_t other : full) {
                const Cells away = glm::abs(place(c) - place(other));
                expected[c] = std::min(expected[c], std::max({away.x, away.y, away.z}));
            }
        check_steps(cells, full, expected);
    }
}
