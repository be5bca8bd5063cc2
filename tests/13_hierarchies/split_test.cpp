// How shapes are parted, and what that is expected to cost.
#include "tests/13_hierarchies/trees.hpp"
#include "tests/catch.hpp"

#include <functional>
#include <numeric>

using namespace rt;
using namespace rt::test;

namespace {

std::vector<std::uint32_t> numbers_up_to(std::size_t count) {
    std::vector<std::uint32_t> items(count);
    std::iota(items.begin(), items.end(), 0u);
    return items;
}

using Splitting = std::function<std::size_t(std::span<const Bounds>, std::span<std::uint32_t>)>;

std::size_t in_halves(std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
    return split_in_halves(boxes, items);
}
Splitting by_sweep(const SplitCosts& costs = {}) {
    return [=](std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
        return split_by_sweep(boxes, items, costs);
    };
}
Splitting by_bins(const SplitCosts& costs = {}) {
    return [=](std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
        return split_by_bins(boxes, items, costs);
    };
}

/// Holds how `items` are parted against the numbers that the first child is to get.
void check_parts(const Splitting& split, const std::vector<Bounds>& boxes, std::vector<std::uint32_t> items,
                 const std::vector<std::uint32_t>& first) {
    const std::vector<std::uint32_t> before = items;
    const std::size_t count = split(boxes, items);
    INFO("items " << before << ", of which the first child is to get " << first);
    {
        INFO("how many it gets");
        REQUIRE(count == first.size());
    }
    {
        INFO("which come first");
        CHECK(same_numbers(std::span(items).first(count), first));
    }
    INFO("all the items afterwards");
    CHECK(same_numbers(items, before));
}

/// The same of all the boxes.
void check_parts(const Splitting& split, const std::vector<Bounds>& boxes,
                 const std::vector<std::uint32_t>& first) {
    check_parts(split, boxes, numbers_up_to(boxes.size()), first);
}

std::vector<Bounds> cubes_at(const std::vector<Real>& places) {
    std::vector<Bounds> boxes;
    for (const Real x : places) boxes.push_back(cube_at(x));
    return boxes;
}

Bounds cube_around(const Vec3& middle, Real edge) { return {middle - edge / 2, middle + edge / 2}; }

/// The same boxes with axis 0 turned to `axis`, and so on.
std::vector<Bounds> turned(std::vector<Bounds> boxes, int axis) {
    const auto turn = [&](const Vec3& v) {
        Vec3 w;
        for (int a = 0; a < 3; ++a) w[(a + axis) % 3] = v[a];
        return w;
    };
    for (Bounds& box : boxes) box = {turn(box.low), turn(box.high)};
    return boxes;
}

/// Four small cubes around one middle, numbers 0 to 3, and four large ones, 4 to 7.
std::vector<Bounds> nested_cubes() {
    std::vector<Bounds> boxes(4, cube_around({0, 0, 0}, 1));
    boxes.resize(8, cube_around({0, 0, 0}, 16));
    return boxes;
}

}  // namespace

// ------------------------------------------------------------------------------------------ in halves

TEST_CASE("four cubes in a row are parted in the middle", "[13.3]") {
    INFO("cubes of edge 1 at x = 6, 2, 4 and 0");
    check_parts(in_halves, cubes_at({6, 2, 4, 0}), {1, 3});
}

TEST_CASE("of an odd number the first part has one less", "[13.3]") {
    {
        INFO("cubes of edge 1 at x = 8, 0, 6, 2 and 4");
        check_parts(in_halves, cubes_at({8, 0, 6, 2, 4}), {1, 3});
    }
    INFO("cubes of edge 1 at x = 5, 0 and 9");
    check_parts(in_halves, cubes_at({5, 0, 9}), {1});
}

TEST_CASE("halves are made along the axis in which the middles reach farthest", "[13.3]") {
    for (const int axis : {0, 1, 2}) {
        const std::vector<Bounds> boxes = turned({cube_around({0, 3, 1}, 1), cube_around({9, 2, 0}, 1),
                                                  cube_around({1, 1, 3}, 1), cube_around({8, 0, 2}, 1)},
                                                 axis);
        INFO("cubes in two pairs, far apart along axis " << axis << " and near each other along the others");
        check_parts(in_halves, boxes, {0, 2});
    }
}

TEST_CASE("of two axes along which the middles reach equally far the first is taken", "[13.3]") {
    const std::vector<Bounds> boxes{cube_around({4, 0, 0}, 1), cube_around({0, 4, 0}, 1)};
    INFO("two cubes, one 4 farther along x, the other 4 farther along y");
    check_parts(in_halves, boxes, {1});
    const std::vector<Bounds> other{cube_around({0, 4, 0}, 1), cube_around({0, 0, 4}, 1)};
    INFO("two cubes, one 4 farther along y, the other 4 farther along z");
    check_parts(in_halves, other, {1});
}

TEST_CASE("it is the middles that are put in order, not where boxes begin or end", "[13.3]") {
    const std::vector<Bounds> boxes{part_of_row(-10, 30), part_of_row(0, 2), part_of_row(14, 15),
                                    part_of_row(3, 4)};
    INFO("boxes along x from -10 to 30, 0 to 2, 14 to 15 and 3 to 4, whose middles are 10, 1, 14.5 and 3.5");
    check_parts(in_halves, boxes, {1, 3});
    // A box that is long along y has its middle where the others have theirs.
    const std::vector<Bounds> tower{{{0, -50, 0}, {1, 51, 1}}, cube_at(2), cube_at(4), cube_at(6)};
    INFO("a tower from y = -50 to 51 at x = 0, and cubes of edge 1 at x = 2, 4 and 6");
    check_parts(in_halves, tower, {0, 1});
}

TEST_CASE("only the items are parted, whatever other boxes there are", "[13.3]") {
    const std::vector<Bounds> boxes = cubes_at({100, 6, -50, 2, 4, 0});
    INFO("cubes of edge 1 at x = 100, 6, -50, 2, 4 and 0");
    check_parts(in_halves, boxes, {4, 1, 5, 3}, {3, 5});
}

TEST_CASE("shapes in one place are parted by number", "[13.3]") {
    const std::vector<Bounds> boxes(5, cube_at(3));
    std::vector<std::uint32_t> items = numbers_up_to(5);
    INFO("five times the same box: how many go to the first part");
    CHECK(split_in_halves(boxes, items) == 2);
    INFO("all the items afterwards");
    CHECK(same_numbers(items, {0, 1, 2, 3, 4}));
}

// ------------------------------------------------------------------------------ areas and probabilities

TEST_CASE("half the area of a box", "[13.5]") {
    const auto check = [](const Bounds& box, Real expected) {
        INFO("half the surface of a " << box);
        CHECK(near(half_area(box), expected, 1e-12 * expected));
    };
    check({{0, 0, 0}, {1, 2, 3}}, 11);
    check({{0, 0, 0}, {1, 1, 1}}, 3);
    check({{-1, -1, -1}, {1, 1, 1}}, 12);
    check({{-5, 10, 2}, {5, 20, 4}}, 140);
}

TEST_CASE("half the area of a box without thickness", "[13.5]") {
    const auto check = [](const char* what, const Bounds& box, Real expected) {
        INFO("half the surface of " << what << ", a " << box);
        CHECK(near(half_area(box), expected, 1e-12));
    };
    check("a rectangle", {{0, 0, 5}, {2, 3, 5}}, 6);
    check("a rectangle", {{0, 4, 0}, {2, 4, 3}}, 6);
    check("a line", {{0, 0, 0}, {7, 0, 0}}, 0);
    check("a point", {{1, 2, 3}, {1, 2, 3}}, 0);
}

TEST_CASE("an empty box has no area", "[13.5]") {
    {
        INFO("half the surface of the box that is empty along all axes");
        CHECK(near(half_area(Bounds{}), 0, 0));
    }
    INFO("half the surface of a box that is empty along y alone, from 1 to -1");
    CHECK(near(half_area({{0, 1, 0}, {1, -1, 1}}), 0, 0));
}

TEST_CASE("the cost of a row of four", "[13.6]") {
    // Half areas: root 7 + 7 + 1 = 15, pairs 3 + 3 + 1 = 7, leaves 3.
    const Hierarchy tree = row_of_four();
    INFO(four_in_words << ": half the areas are 15, 7 and 3");
    {
        INFO("the cost with 1 a node and 1 a shape: 1 + 2 · 7/15 + 4 · 3/15");
        CHECK(near(predicted_cost(tree), 41.0 / 15, 1e-12));
    }
    {
        INFO("the cost with 2 a node and 1 a shape");
        CHECK(near(predicted_cost(tree, {2, 1}), 70.0 / 15, 1e-12));
    }
    INFO("the cost with 1 a node and 5 a shape");
    CHECK(near(predicted_cost(tree, {1, 5}), 89.0 / 15, 1e-12));
}

TEST_CASE("a leaf costs as much as it has shapes", "[13.6]") {
    {
        INFO("a root that is a leaf of 5 shapes, 1 a shape, then 3 a shape");
        CHECK(near(predicted_cost(tree_of({leaf(cube_at(0), 0, 5)})), 5, 1e-12));
        CHECK(near(predicted_cost(tree_of({leaf(cube_at(0), 0, 5)}), {1, 3}), 15, 1e-12));
    }
    const Hierarchy tree =
        tree_of({inner_node({{0, 0, 0}, {2, 1, 1}}, 1), leaf(cube_at(0), 0, 3), leaf(cube_at(1), 3, 7)});
    INFO("two cubes of edge 1 that touch, with 3 and 7 shapes: 1 + 3 · 3/5 + 7 · 3/5");
    CHECK(near(predicted_cost(tree), 7, 1e-12));
}

TEST_CASE("probabilities are those of the root's box, not of the parent's", "[13.6]") {
    // Half areas: root 8 · 1 + 8 + 1 = 17, its first child 3 and that's children 3 and 0.
    const Hierarchy tree = tree_of({inner_node(part_of_row(0, 8), 1), inner_node(cube_at(0), 3),
                                    leaf(cube_at(7), 2), leaf(cube_at(0), 0), leaf(cube_at(0), 1)});
    INFO("a cube with two leaves as large as itself, and another cube beside it: 1 + 4 · 3/17");
    CHECK(near(predicted_cost(tree), 29.0 / 17, 1e-12));
}

TEST_CASE("the cost where there is no area, and where there is nothing", "[13.6]") {
    const auto along = [](Real from, Real to) { return Bounds{{from, 0, 0}, {to, 0, 0}}; };
    const Hierarchy line =
        tree_of({inner_node(along(0, 5), 1), leaf(along(0, 1), 0, 2), leaf(along(3, 5), 2)});
    {
        INFO("all in one line, so that the root has no area: a node, then 2 shapes, then 1");
        CHECK(near(predicted_cost(line), 4, 1e-12));
    }
    INFO("a hierarchy without nodes");
    CHECK(near(predicted_cost(Hierarchy{}), 0, 0));
}

// ------------------------------------------------------------------------------------------ the best cut

namespace {

std::vector<Bin> bins_of(const std::vector<Bounds>& boxes) {
    std::vector<Bin> bins;
    for (const Bounds& box : boxes) bins.push_back({box, 1});
    return bins;
}

void check_cut(const std::vector<Bin>& bins, std::size_t at, Real cost, const SplitCosts& costs = {}) {
    const Cut cut = cheapest_cut(bins, costs);
    INFO("bins " << bins << ", with " << costs.node << " a node and " << costs.shape
                 << " a shape; answered: " << cut);
    {
        INFO("how many bins are before the cut");
        CHECK(cut.at == at);
    }
    INFO("what it costs");
    CHECK(near(cut.cost, cost, cost == infinity ? 0 : 1e-12 * cost));
}

}  // namespace

TEST_CASE("four cubes in a row are cut in the middle", "[13.7]") {
    // Half areas: all 15; one cube 3, two 7, three 11. In the middle 1 + 2 · 7/15 + 2 · 7/15; beside the
    // first 1 + 1 · 3/15 + 3 · 11/15 = 51/15.
    check_cut(bins_of(cubes_at({0, 2, 4, 6})), 2, 43.0 / 15);
}

TEST_CASE("a cut goes where there is a gap", "[13.7]") {
    // Half areas: all 2 · 21 + 1 = 43; the two cubes from x = 0 to 2 have 5, that at 20 has 3.
    check_cut(bins_of(cubes_at({0, 1, 20})), 2, 1 + (2 * 5 + 3) / 43.0);
    check_cut(bins_of(cubes_at({0, 19, 20})), 1, 1 + (3 + 2 * 5) / 43.0);
}

TEST_CASE("a few shapes in a large box are parted from many in a small one", "[13.7]") {
    // A stadium and a teapot: half areas 3 · 64 and 3; many shapes count by how many they are.
    const Bounds stadium = cube_around({0, 0, 0}, 8), teapot = cube_around({1, 0, 0}, 1);
    check_cut({{stadium, 1}, {teapot, 100}, {teapot, 100}}, 1, 1 + 1 + 200 * 3 / 192.0);
    check_cut({{teapot, 100}, {teapot, 100}, {stadium, 2}}, 2, 1 + 200 * 3 / 192.0 + 2);
}

TEST_CASE("what a node and a shape cost", "[13.7]") {
    check_cut(bins_of(cubes_at({0, 2, 4, 6})), 2, 10 + 3 * 28 / 15.0, {10, 3});
    check_cut({{cube_at(0), 4}, {cube_at(1), 6}}, 1, 0.5 + 7 * 10 * 3 / 5.0, {0.5, 7});
}

TEST_CASE("of cuts that cost the same the first is taken", "[13.7]") {
    const Bin none, one{cube_at(0), 1}, other{cube_at(1), 1};
    INFO("behind the first bin, or behind the empty one after it");
    check_cut({one, none, other}, 1, 1 + 6.0 / 5);
    INFO("three times the same box: behind the first bin or the second");
    check_cut({one, one, one}, 1, 1 + 3);
}

TEST_CASE("each side of a cut has a shape", "[13.7]") {
    const Bin none, one{cube_at(0), 1}, other{cube_at(1), 1};
    // Half areas: all 5, a cube 3.
    const Real cost = 1 + 6.0 / 5;
    check_cut({none, one, other}, 2, cost);
    check_cut({one, other, none}, 1, cost);
    check_cut({none, none, one, none, other, none}, 3, cost);
}

TEST_CASE("where there is no cut", "[13.7]") {
    check_cut({}, 0, infinity);
    check_cut({{cube_at(0), 3}}, 0, infinity);
    check_cut({{}, {cube_at(0), 3}, {}}, 0, infinity);
}

TEST_CASE("where nothing has an area, every side is met", "[13.7]") {
    const auto along = [](Real from, Real to) { return Bounds{{from, 0, 0}, {to, 0, 0}}; };
    check_cut({{along(0, 1), 2}, {along(2, 3), 1}, {along(8, 9), 4}}, 1, 1 + 7);
}

TEST_CASE("a side without area is never met, if others have one", "[13.7]") {
    // A point far away, and a cube: the box around both has half the area 2 · 10 + 1.
    const Vec3 far(10, 0, 0);
    check_cut({{cube_at(0), 5}, {{far, far}, 7}}, 1, 1 + 5 * 3 / 21.0);
}

// --------------------------------------------------------------------------------------------- the sweep

TEST_CASE("a sweep parts a row in the middle, whatever the order of the items", "[13.8]") {
    INFO("cubes of edge 1 at x = 6, 2, 4 and 0");
    check_parts(by_sweep(), cubes_at({6, 2, 4, 0}), {1, 3});
    check_parts(by_sweep(), cubes_at({6, 2, 4, 0}), {2, 0, 3, 1}, {1, 3});
}

TEST_CASE("a sweep cuts where there is a gap, not in the middle", "[13.8]") {
    INFO("cubes of edge 1 at x = 40, 0, 1, 2, 3 and 41");
    check_parts(by_sweep(), cubes_at({40, 0, 1, 2, 3, 41}), {1, 2, 3, 4});
}

TEST_CASE("a sweep looks along all axes", "[13.8]") {
    for (const int axis : {0, 1, 2}) {
        INFO("cubes of edge 1 along axis " << axis << " at 6, 2, 4 and 0");
        check_parts(by_sweep(), turned(cubes_at({6, 2, 4, 0}), axis), {1, 3});
    }
    // Along x the middles reach farther, but all that is between them is full.
    const std::vector<Bounds> boxes{{{0, 0, 0}, {10, 1, 10}},
                                    {{1, 8, 0}, {11, 9, 10}},
                                    {{2, 0, 0}, {20, 1, 10}},
                                    {{3, 8, 0}, {21, 9, 10}}};
    INFO("two floors of long boxes, y = 0 to 1 and y = 8 to 9, which overlap along x");
    check_parts(by_sweep(), boxes, {0, 2});
}

TEST_CASE("of cuts along two axes that cost the same, a sweep takes the first axis", "[13.8]") {
    const std::vector<Bounds> boxes{
        {{2, 2, 0}, {3, 3, 1}}, {{0, 2, 0}, {1, 3, 1}}, {{2, 0, 0}, {3, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}};
    INFO("four cubes of edge 1 with corners at x and y of 0 and 2, numbers 1 and 3 at x = 0");
    check_parts(by_sweep(), boxes, {1, 3});
}

TEST_CASE("shapes stay together where that costs no more", "[13.8]") {
    {
        INFO("two equal boxes: a leaf costs 2, a cut 1 + 1 + 1");
        check_parts(by_sweep(), {cube_at(0), cube_at(0)}, {});
    }
    // Two squares side by side: each is met by half of the rays that meet both.
    const std::vector<Bounds> squares{{{0, 0, 0}, {1, 1, 0}}, {{1, 0, 0}, {2, 1, 0}}};
    {
        INFO("two squares: a leaf costs 2, a cut 1 + 1/2 + 1/2");
        check_parts(by_sweep(), squares, {});
    }
    {
        INFO("the same where a node costs 0.5: a cut costs 0.5 + 1/2 + 1/2");
        check_parts(by_sweep({0.5, 1}), squares, {0});
    }
    INFO("the same where a shape costs 3: a leaf costs 6, a cut 1 + 3/2 + 3/2");
    check_parts(by_sweep({1, 3}), squares, {0});
}

TEST_CASE("of equal middles the lower number is first in the row", "[13.8]") {
    INFO(
        "eight cubes with one middle, numbers 0 to 3 of edge 1 and 4 to 7 of edge 16: 1 + 4/256 + 4 is less "
        "than 8");
    check_parts(by_sweep(), nested_cubes(), {6, 1, 4, 3, 0, 5, 7, 2}, {0, 1, 2, 3});
}

TEST_CASE("a sweep looks at the items only", "[13.8]") {
    INFO("cubes of edge 1 at x = 100, 6, -50, 2, 4 and 0");
    check_parts(by_sweep(), cubes_at({100, 6, -50, 2, 4, 0}), {4, 1, 5, 3}, {3, 5});
}

TEST_CASE("a sweep puts shapes in order by their middles", "[13.8]") {
    // By where they begin, the long box would come first; its middle is that of the cubes on the right.
    const std::vector<Bounds> boxes{part_of_row(40, 41), part_of_row(0, 1),   part_of_row(-1, 81),
                                    part_of_row(2, 3),   part_of_row(42, 43), part_of_row(4, 5)};
    INFO(
        "cubes of edge 1 at x = 40, 0, 2, 42 and 4, and as number 2 a box from -1 to 81, whose middle is 40");
    check_parts(by_sweep(), boxes, {1, 3, 5});
}

// ---------------------------------------------------------------------------------------------- the bins

namespace {

void check_bins(const std::vector<Bounds>& boxes, std::vector<std::uint32_t> items, int axis,
                const std::vector<Bin>& expected) {
    const std::vector<Bin> bins = bins_along(boxes, items, axis, expected.size());
    INFO("items " << items << " in " << expected.size() << " bins along axis " << axis
                  << "; answered: " << bins);
    {
        INFO("how many bins there are");
        REQUIRE(bins.size() == expected.size());
    }
    for (std::size_t i = 0; i < bins.size(); ++i) {
        INFO("bin number " << i << ": how many shapes it has, and the box around them");
        CHECK(bins[i].count == expected[i].count);
        if (expected[i].count == 0) {
            CHECK(or_say(is_empty(bins[i].box), "the bin has no shapes, but its box is not empty"));
            continue;
        }
        CHECK(near(bins[i].box.low, expected[i].box.low, 0));
        CHECK(near(bins[i].box.high, expected[i].box.high, 0));
    }
}

}  // namespace

TEST_CASE("shapes in four bins", "[13.9]") {
    // The middles are 0.5, 2.5, 3.5 and 8.5: the bins begin at 0.5, 2.5, 4.5 and 6.5.
    INFO("cubes of edge 1 at x = 0, 2, 3 and 8, whose middles reach from 0.5 to 8.5");
    check_bins(cubes_at({0, 2, 3, 8}), {0, 1, 2, 3}, 0,
               {{cube_at(0), 1}, {part_of_row(2, 4), 2}, {}, {cube_at(8), 1}});
}

TEST_CASE("a middle at the beginning of a bin is in it, and the greatest in the last", "[13.9]") {
    INFO("cubes of edge 1 at x = 0, 1, 2, 3 and 4, whose middles are 0.5 to 4.5");
    check_bins(cubes_at({0, 1, 2, 3, 4}), {0, 1, 2, 3, 4}, 0,
               {{cube_at(0), 1}, {cube_at(1), 1}, {cube_at(2), 1}, {part_of_row(3, 5), 2}});
}

TEST_CASE("bins are between the middles, and have boxes that reach farther", "[13.9]") {
    INFO("boxes along x from -10 to 10, 0 to 2, 3 to 5 and 3.5 to 4.5, whose middles are 0, 1, 4 and 4");
    check_bins({part_of_row(-10, 10), part_of_row(0, 2), part_of_row(3, 5), part_of_row(3.5, 4.5)},
               {0, 1, 2, 3}, 0, {{part_of_row(-10, 10), 2}, {part_of_row(3, 5), 2}});
}

TEST_CASE("bins along the other axes", "[13.9]") {
    for (const int axis : {0, 1, 2}) {
        const std::vector<Bounds> boxes = turned(cubes_at({0, 2, 3, 8}), axis);
        const std::vector<Bounds> pair = turned({part_of_row(2, 4)}, axis);
        INFO("cubes of edge 1 at 0, 2, 3 and 8 along axis " << axis);
        check_bins(boxes, {0, 1, 2, 3}, axis, {{boxes[0], 1}, {pair[0], 2}, {}, {boxes[3], 1}});
        Bounds all = merge(boxes[0], boxes[3]);
        INFO("along the next axis, where all their middles are equal");
        check_bins(boxes, {0, 1, 2, 3}, (axis + 1) % 3, {{all, 4}, {}, {}});
    }
}

TEST_CASE("bins have the items only", "[13.9]") {
    INFO("cubes of edge 1 at x = 100, 0, -50, 4 and 1, of which those at 0, 1 and 4 are items");
    check_bins(cubes_at({100, 0, -50, 4, 1}), {4, 1, 3}, 0, {{part_of_row(0, 2), 2}, {cube_at(4), 1}});
}

TEST_CASE("all in one bin", "[13.9]") {
    INFO("cubes of edge 1 at x = 0 and 4 in a single bin");
    check_bins(cubes_at({0, 4}), {0, 1}, 0, {{part_of_row(0, 5), 2}});
}

TEST_CASE("bins part a row in the middle", "[13.10]") {
    INFO("cubes of edge 1 at x = 6, 2, 4 and 0");
    check_parts(by_bins(), cubes_at({6, 2, 4, 0}), {1, 3});
    check_parts(by_bins(), cubes_at({6, 2, 4, 0}), {2, 0, 3, 1}, {1, 3});
}

TEST_CASE("bins part shapes where there is a gap", "[13.10]") {
    INFO("cubes of edge 1 at x = 40, 0, 1, 2, 3 and 41");
    check_parts(by_bins(), cubes_at({40, 0, 1, 2, 3, 41}), {1, 2, 3, 4});
}

TEST_CASE("bins are tried along all axes", "[13.10]") {
    for (const int axis : {0, 1, 2}) {
        INFO("cubes of edge 1 along axis " << axis << " at 6, 2, 4 and 0");
        check_parts(by_bins(), turned(cubes_at({6, 2, 4, 0}), axis), {1, 3});
    }
    const std::vector<Bounds> boxes{{{0, 0, 0}, {10, 1, 10}},
                                    {{1, 8, 0}, {11, 9, 10}},
                                    {{2, 0, 0}, {20, 1, 10}},
                                    {{3, 8, 0}, {21, 9, 10}}};
    INFO("two floors of long boxes, y = 0 to 1 and y = 8 to 9, which overlap along x");
    check_parts(by_bins(), boxes, {0, 2});
}

TEST_CASE("of cuts along two axes that cost the same, bins take the first axis", "[13.10]") {
    const std::vector<Bounds> boxes{
        {{2, 2, 0}, {3, 3, 1}}, {{0, 2, 0}, {1, 3, 1}}, {{2, 0, 0}, {3, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}};
    INFO("four cubes of edge 1 with corners at x and y of 0 and 2, numbers 1 and 3 at x = 0");
    check_parts(by_bins(), boxes, {1, 3});
}

TEST_CASE("shapes stay together where bins save nothing", "[13.10]") {
    {
        INFO("two equal boxes: there is no place between bins");
        check_parts(by_bins(), {cube_at(0), cube_at(0)}, {});
    }
    {
        INFO("eight cubes with one middle, numbers 0 to 3 of edge 1 and 4 to 7 of edge 16");
        check_parts(by_bins(), nested_cubes(), {});
    }
    const std::vector<Bounds> squares{{{0, 0, 0}, {1, 1, 0}}, {{1, 0, 0}, {2, 1, 0}}};
    {
        INFO("two squares: a leaf costs 2, a cut 1 + 1/2 + 1/2");
        check_parts(by_bins(), squares, {});
    }
    {
        INFO("the same where a node costs 0.5: a cut costs 0.5 + 1/2 + 1/2");
        check_parts(by_bins({0.5, 1}), squares, {0});
    }
    INFO("the same where a shape costs 3: a leaf costs 6, a cut 1 + 3/2 + 3/2");
    check_parts(by_bins({1, 3}), squares, {0});
}

TEST_CASE("there are cuts only between the sixteen bins", "[13.10]") {
    // Two clusters 8 apart and one shape far away: in bins of width 10 the clusters share a bin.
    const std::vector<Bounds> boxes{cube_around({0, 0, 0}, 1), cube_around({8, 0, 0}, 1),
                                    cube_around({160, 0, 0}, 1)};
    INFO("cubes of edge 1 around x = 0, 8 and 160, in bins of width 10");
    check_parts(by_bins(), boxes, {0, 1});
    // A large box of which a sweep would part the small ones beside it.
    std::vector<Bounds> crowd(20, cube_around({0, 0, 0}, 1));
    crowd.push_back(cube_around({8, 0, 0}, 60));
    crowd.push_back(cube_around({160, 0, 0}, 1));
    std::vector<std::uint32_t> small = numbers_up_to(20), together = numbers_up_to(21);
    {
        INFO(
            "twenty cubes of edge 1 around x = 0, number 20 of edge 60 around 8, number 21 of edge 1 around "
            "160, by a sweep");
        check_parts(by_sweep(), crowd, small);
    }
    {
        INFO("the same by bins, of which 0 and 8 are in one");
        check_parts(by_bins(), crowd, together);
    }
    crowd[20] = cube_around({12, 0, 0}, 60);
    INFO("the same with number 20 around 12, in the next bin");
    check_parts(by_bins(), crowd, small);
}

TEST_CASE("bins look at the items only", "[13.10]") {
    INFO("cubes of edge 1 at x = 100, 6, -50, 2, 4 and 0");
    check_parts(by_bins(), cubes_at({100, 6, -50, 2, 4, 0}), {4, 1, 5, 3}, {3, 5});
}
