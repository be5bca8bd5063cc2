// Hierarchies that are built, and fitted to shapes that have moved.
#include "tests/13_hierarchies/trees.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

std::vector<Bounds> cubes_at(const std::vector<Real>& places) {
    std::vector<Bounds> boxes;
    for (const Real x : places) boxes.push_back(cube_at(x));
    return boxes;
}

HierarchyOptions halves(std::size_t most) { return {.method = SplitMethod::Halves, .most = most}; }

}  // namespace

TEST_CASE("four cubes in a row, by halves", "[13.4]") {
    const std::vector<Bounds> boxes = cubes_at({4, 0, 6, 2});
    INFO("cubes of edge 1 at x = 4, 0, 6 and 2, in halves until a leaf has one");
    const Hierarchy tree = build_hierarchy(boxes, halves(1));
    {
        INFO("the tree");
        CHECK(same_tree(tree, "(({1} {3}) ({0} {2}))"));
    }
    {
        INFO("how many nodes there are");
        REQUIRE(tree.nodes.size() == 7);
    }
    {
        INFO("the root's box, up to the margin");
        CHECK(near(tree.nodes[0].box.low, Vec3(0), 1e-6));
        CHECK(near(tree.nodes[0].box.high, Vec3(7, 1, 1), 1e-6));
    }
    INFO("what the contract says of nodes, boxes and shapes");
    CHECK(is_right(tree, boxes, 1));
}

TEST_CASE("leaves may have more than one shape", "[13.4]") {
    const std::vector<Bounds> boxes = cubes_at({4, 0, 6, 2});
    const auto check = [&](std::size_t most, const char* expected) {
        const Hierarchy tree = build_hierarchy(boxes, halves(most));
        INFO("cubes of edge 1 at x = 4, 0, 6 and 2, in halves until a leaf has " << most << ": the tree");
        CHECK(same_tree(tree, expected));
        INFO("what the contract says of nodes, boxes and shapes");
        CHECK(is_right(tree, boxes, most));
    };
    check(2, "({1, 3} {0, 2})");
    check(3, "({1, 3} {0, 2})");
    check(4, "{0, 1, 2, 3}");
}

TEST_CASE("one shape, and none", "[13.4]") {
    {
        INFO("one cube: the tree");
        CHECK(same_tree(build_hierarchy(cubes_at({5}), halves(1)), "{0}"));
    }
    INFO("no shapes: the tree");
    CHECK(same_tree(build_hierarchy(std::vector<Bounds>{}, halves(1)), "nothing"));
    INFO("two shapes without a point: the tree");
    CHECK(same_tree(build_hierarchy(std::vector<Bounds>(2), halves(1)), "nothing"));
}

TEST_CASE("shapes without a point are in no leaf", "[13.4]") {
    std::vector<Bounds> boxes = cubes_at({4, 0, 6, 2});
    boxes[0] = Bounds{};
    const Hierarchy tree = build_hierarchy(boxes, halves(1));
    INFO("number 0 is without a point; cubes of edge 1 at x = 0, 6 and 2: the tree");
    CHECK(same_tree(tree, "({1} ({3} {2}))"));
}

TEST_CASE("a box is larger than what is in it by the margin", "[13.4]") {
    const std::vector<Bounds> boxes = cubes_at({0, 1023});
    const Hierarchy tree = build_hierarchy(boxes, halves(1));
    REQUIRE(tree.nodes.size() == 3);
    const Real margin = 0x1p-20 + 0x1p-34;  // of an edge of 1024 and a greatest coordinate of 1024
    INFO("cubes of edge 1 at x = 0 and 1023: the margin, in units of the right one");
    CHECK(near(tree.margin / margin, 1, 1e-6));
    for (const HierarchyNode& node : tree.nodes) {
        INFO("how far the " << node.box << " reaches below 0 along y, in margins");
        CHECK(near(-node.box.low.y / margin, 1, 1e-3));
        INFO("how far it reaches above 1, in margins");
        CHECK(near((node.box.high.y - 1) / margin, 1, 1e-3));
    }
}

TEST_CASE("a distorted shape gets a greater margin", "[13.4]") {
    const std::vector<Bounds> boxes = cubes_at({0, 6});
    HierarchyOptions options = halves(1);
    const Real plain = build_hierarchy(boxes, options).margin;
    options.distortion = 8;
    INFO("a distortion of 8: the margin, in units of that without");
    CHECK(near(build_hierarchy(boxes, options).margin / plain, 8, 1e-9));
}

TEST_CASE("many shapes in one place fill several leaves", "[13.4]") {
    const std::vector<Bounds> boxes(40, cube_at(2));
    INFO("forty times the same box, at most 16 in a leaf: what the contract says of nodes, boxes and shapes");
    const Hierarchy tree = build_hierarchy(boxes, halves(16));
    CHECK(is_right(tree, boxes, 16));
    INFO("how many nodes there are: 40 shapes become 20 and 20, then four times 10");
    CHECK(tree.nodes.size() == 7);
}

TEST_CASE("random boxes, by halves", "[13.4]") {
    Random random(1304);
    for (const std::size_t count : {2u, 3u, 17u, 300u}) {
        const std::vector<Bounds> boxes = random_boxes(random, count);
        for (const std::size_t most : {1u, 4u}) {
            const Hierarchy tree = build_hierarchy(boxes, halves(most));
            INFO(count << " random boxes, at most " << most
                       << " in a leaf: what the contract says of nodes, boxes and shapes");
            CHECK(is_right(tree, boxes, most));
        }
    }
}

// ------------------------------------------------------------------------------------------------ refit

TEST_CASE("the boxes follow the shapes", "[13.11]") {
    const Hierarchy tree = row_of_four();
    const std::vector<Bounds> moved = cubes_at({1, 3, 8, 6});
    const Hierarchy fitted = refit(tree, moved);
    INFO(four_in_words << "; the shapes move to x = 1, 3, 8 and 6");
    {
        INFO("the tree, which stays as it is");
        CHECK(same_tree(fitted, "(({0} {1}) ({2} {3}))"));
    }
    const Bounds expected[] = {part_of_row(1, 9), part_of_row(1, 4), part_of_row(6, 9), cube_at(1),
                               cube_at(3),        cube_at(8),        cube_at(6)};
    for (std::size_t node = 0; node < 7; ++node) {
        INFO("the box of node " << node << ", up to the margin");
        CHECK(near(fitted.nodes[node].box.low, expected[node].low, 1e-6));
        CHECK(near(fitted.nodes[node].box.high, expected[node].high, 1e-6));
    }
    INFO("what the contract says of nodes, boxes and shapes");
    CHECK(is_right(fitted, moved));
}

TEST_CASE("boxes shrink as well as grow", "[13.11]") {
    const std::vector<Bounds> moved = cubes_at({0, 0, 0, 0});
    const Hierarchy fitted = refit(row_of_four(), moved);
    INFO(four_in_words << "; all shapes move to x = 0: the root's box, up to the margin");
    CHECK(near(fitted.nodes[0].box.high, Vec3(1), 1e-6));
    CHECK(is_right(fitted, moved));
}

TEST_CASE("a leaf's box is around all its shapes, by their numbers", "[13.11]") {
    const Hierarchy tree = tree_of(
        {inner_node(part_of_row(0, 7), 1), leaf(part_of_row(0, 1), 0, 2), leaf(part_of_row(6, 7), 2, 2)},
        {3, 0, 1, 2});
    const std::vector<Bounds> moved = cubes_at({2, 10, 14, 5});
    const Hierarchy fitted = refit(tree, moved);
    INFO(
        "a leaf with shapes 3 and 0, which move to x = 5 and 2, and one with 1 and 2, which move to 10 and "
        "14: "
        "the boxes of the leaves, up to the margin");
    CHECK(near(fitted.nodes[1].box.low, Vec3(2, 0, 0), 1e-6));
    CHECK(near(fitted.nodes[1].box.high, Vec3(6, 1, 1), 1e-6));
    CHECK(near(fitted.nodes[2].box.low, Vec3(10, 0, 0), 1e-6));
    CHECK(near(fitted.nodes[2].box.high, Vec3(15, 1, 1), 1e-6));
    CHECK(is_right(fitted, moved));
}

TEST_CASE("the margin is that of the new boxes, and every box has it", "[13.11]") {
    const std::vector<Bounds> moved = cubes_at({0, 2, 4, 1023});
    const Hierarchy fitted = refit(row_of_four(), moved, 4);
    const Real margin = 4 * (0x1p-20 + 0x1p-34);  // of an edge of 1024 and a greatest coordinate of 1024
    for (const HierarchyNode& node : fitted.nodes) {
        INFO("shapes at x = 0, 2, 4 and 1023, a distortion of 4: how far the "
             << node.box << " reaches below 0 along y, in margins");
        CHECK(near(-node.box.low.y / margin, 1, 1e-3));
    }
}

TEST_CASE("a tree that is fitted to its own shapes is what it was", "[13.11]") {
    Random random(1311);
    const std::vector<Bounds> boxes = random_boxes(random, 100);
    const Hierarchy tree = build_hierarchy(boxes, halves(2)), fitted = refit(tree, boxes);
    REQUIRE(fitted.nodes.size() == tree.nodes.size());
    for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
        INFO("100 random boxes that have not moved: the box of node " << node);
        CHECK(near(fitted.nodes[node].box.low, tree.nodes[node].box.low, tree.margin / 64));
        CHECK(near(fitted.nodes[node].box.high, tree.nodes[node].box.high, tree.margin / 64));
    }
}

TEST_CASE("shapes may go through each other", "[13.11]") {
    Random random(1312);
    const std::vector<Bounds> boxes = random_boxes(random, 100);
    std::vector<Bounds> moved = random_boxes(random, 100);
    const Hierarchy fitted = refit(build_hierarchy(boxes, halves(2)), moved);
    INFO(
        "100 random boxes that move to other random places: what the contract says of nodes, boxes and "
        "shapes");
    CHECK(is_right(fitted, moved, 2));
}

// ---------------------------------------------------------------------------------------- extra credit

TEST_CASE("the codes of corners", "[13.12]") {
    const Bounds box{{0, 0, 0}, {8, 8, 8}};
    const auto check = [&](const char* what, const Vec3& point, std::uint64_t expected) {
        INFO("the code of " << what << ", " << point << " in a " << box);
        CHECK(morton_code(box, point) == expected);
    };
    check("the lowest corner", {0, 0, 0}, 0);
    check("the highest corner", {8, 8, 8}, (std::uint64_t{1} << 63) - 1);
    const std::uint64_t half = std::uint64_t{1} << 60;
    check("halfway along x", {4, 0, 0}, half);
    check("halfway along y", {0, 4, 0}, 2 * half);
    check("halfway along z", {0, 0, 4}, 4 * half);
    check("the middle", {4, 4, 4}, 7 * half);
    check("a quarter along x and z", {2, 0, 2}, half / 8 * 5);
    const Real one = 8 * 0x1p-21;
    check("one part along x", {one, 0, 0}, 1);
    check("one part along y", {0, one, 0}, 2);
    check("one part along z", {0, 0, one}, 4);
    check("nearly two parts along x", {1.9 * one, 0, 0}, 1);
    check("three parts along x", {3 * one, 0, 0}, 9);
}

TEST_CASE("codes of points outside, and in flat boxes", "[13.12]") {
    const Bounds box{{-4, -4, -4}, {4, 4, 4}}, flat{{-4, 2, -4}, {4, 2, 4}};
    {
        INFO("a point beyond the low corner has the code of that");
        CHECK(morton_code(box, Vec3(-5)) == 0);
    }
    {
        INFO("a point beyond the high corner has the code of that");
        CHECK(morton_code(box, Vec3(5)) == (std::uint64_t{1} << 63) - 1);
    }
    {
        INFO("the middle of a box that is flat along y, and a point above it");
        CHECK(morton_code(flat, {0, 2, 0}) == (std::uint64_t{5} << 60));
        CHECK(morton_code(flat, {0, 3, 0}) == (std::uint64_t{5} << 60));
    }
    INFO("the middle of a small box, from 0 to 0.25");
    CHECK(morton_code({Vec3(0), Vec3(0.25)}, Vec3(0.125)) == (std::uint64_t{7} << 60));
}

TEST_CASE("a tree by codes", "[13.12]") {
    const std::vector<Bounds> row = cubes_at({4, 0, 6, 2});
    {
        INFO("cubes of edge 1 at x = 4, 0, 6 and 2, by codes: the tree");
        CHECK(same_tree(build_hierarchy(row, {.method = SplitMethod::Codes, .most = 1}),
                        "(({1} {3}) ({0} {2}))"));
    }
    Random random(1312);
    const std::vector<Bounds> boxes = random_boxes(random, 200);
    const Hierarchy tree = build_hierarchy(boxes, {.method = SplitMethod::Codes, .most = 4});
    INFO("200 random boxes by codes, at most 4 in a leaf: what the contract says of nodes, boxes and shapes");
    CHECK(is_right(tree, boxes, 4));
}
