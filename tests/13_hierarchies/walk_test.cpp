// The way of a ray through trees that are written by hand.
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "tests/13_hierarchies/trees.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <optional>
#include <sstream>

using namespace rt;
using namespace rt::test;

namespace {

/// Holds what children_met answers against the numbers of the children and the parts of the ray.
void check_children(const Hierarchy& tree, std::uint32_t node, const Ray& ray, Interval range,
                    const std::vector<NodeVisit>& expected) {
    const ChildVisits met = children_met(tree, node, ray, range);
    INFO(show(ray) << " in " << range << ", the children of node " << node);
    {
        INFO("how many of them it meets; found: " << met);
        REQUIRE(met.count == static_cast<int>(expected.size()));
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        INFO("child number " << i + 1 << " on the way of the ray; found: " << met);
        CHECK(met.visits[i].node == expected[i].node);
        INFO("from which t to which t the ray is in its box");
        CHECK(near(met.visits[i].t.min, expected[i].t.min, 1e-12));
        CHECK(near(met.visits[i].t.max, expected[i].t.max, 1e-12));
    }
}

/// What a search asks, and in how many calls, if `ask` answers end_of(shape) for the last shape of a leaf.
struct Asking {
    std::vector<std::uint32_t> shapes;
    std::vector<Interval> parts;  ///< a leaf each
    SearchCounts counts;
};
template <class End>
Asking asking(const Hierarchy& tree, const Ray& ray, Interval range, const End& end_of) {
    Asking asked;
    asked.counts = counted([&] {
        search(tree, ray, range, [&](std::span<const std::uint32_t> some, Interval part) {
            asked.shapes.insert(asked.shapes.end(), some.begin(), some.end());
            asked.parts.push_back(part);
            return end_of(some.back());
        });
    });
    return asked;
}

Real nothing_found(std::uint32_t) { return infinity; }

Told same_order(const std::vector<std::uint32_t>& actual, const std::vector<std::uint32_t>& expected) {
    return or_say(actual == expected, show(actual) + ", expected " + show(expected));
}

}  // namespace

TEST_CASE("two cubes in the way: the nearer comes first", "[13.1]") {
    const Hierarchy tree =
        tree_of({inner_node(part_of_row(0, 3), 1), leaf(cube_at(0), 0), leaf(cube_at(2), 1)});
    INFO("the root has two children, cubes of edge 1 at x = 0 (node 1) and x = 2 (node 2)");
    check_children(tree, 0, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, {{1, {1, 2}}, {2, {3, 4}}});
    check_children(tree, 0, {{5, 0.5, 0.5}, {-1, 0, 0}}, ahead, {{2, {2, 3}}, {1, {4, 5}}});
    check_children(tree, 0, {{-2, 0.5, 0.5}, {2, 0, 0}}, ahead, {{1, {1, 1.5}}, {2, {2, 2.5}}});
}

TEST_CASE("a child that the ray passes by is not met", "[13.1]") {
    const Hierarchy tree =
        tree_of({inner_node(part_of_row(0, 3), 1), leaf(cube_at(0), 0), leaf(cube_at(2), 1)});
    INFO("the root has two children, cubes of edge 1 at x = 0 (node 1) and x = 2 (node 2)");
    check_children(tree, 0, {{0.5, -1, 0.5}, {0, 1, 0}}, ahead, {{1, {1, 2}}});
    check_children(tree, 0, {{2.5, -1, 0.5}, {0, 1, 0}}, ahead, {{2, {1, 2}}});
    check_children(tree, 0, {{1.5, -1, 0.5}, {0, 1, 0}}, ahead, {});
    check_children(tree, 0, {{-1, 0.5, 0.5}, {-1, 0, 0}}, ahead, {});
}

TEST_CASE("a child counts only within the range, and for the part in it", "[13.1]") {
    const Hierarchy tree =
        tree_of({inner_node(part_of_row(0, 3), 1), leaf(cube_at(0), 0), leaf(cube_at(2), 1)});
    const Ray along{{-1, 0.5, 0.5}, {1, 0, 0}};
    INFO("the root has two children, cubes of edge 1 at x = 0 (node 1) and x = 2 (node 2)");
    check_children(tree, 0, along, {0, 2.5}, {{1, {1, 2}}});
    check_children(tree, 0, along, {2.5, infinity}, {{2, {3, 4}}});
    check_children(tree, 0, along, {1.5, 3.5}, {{1, {1.5, 2}}, {2, {3, 3.5}}});
    // The box is closed: a shape in it may be hit where it begins.
    check_children(tree, 0, along, {0, 3}, {{1, {1, 2}}, {2, {3, 3}}});
}

TEST_CASE("it is the entry that counts, not where a box ends or how large it is", "[13.1]") {
    const Hierarchy tree =
        tree_of({inner_node(part_of_row(0, 9), 1), leaf(part_of_row(0, 9), 0), leaf(cube_at(4), 1)});
    INFO("node 1 reaches from x = 0 to 9, node 2 from x = 4 to 5, inside of it");
    check_children(tree, 0, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, {{1, {1, 10}}, {2, {5, 6}}});
    check_children(tree, 0, {{10, 0.5, 0.5}, {-1, 0, 0}}, ahead, {{1, {1, 10}}, {2, {5, 6}}});
}

TEST_CASE("of two children that the ray enters at once the first comes first", "[13.1]") {
    const Bounds tall{{0, 0, 0}, {1, 5, 1}};
    const Hierarchy tree = tree_of({inner_node(tall, 1), leaf(tall, 0), leaf(cube_at(0), 1)});
    INFO("node 1 is a tower of edges 1, 5, 1, node 2 the cube of edge 1 at its foot");
    check_children(tree, 0, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, {{1, {1, 2}}, {2, {1, 2}}});
    // From inside of both, the range begins in both.
    check_children(tree, 0, {{0.5, 0.5, 0.5}, {0, 1, 0}}, ahead, {{1, {0, 4.5}}, {2, {0, 0.5}}});
    const Hierarchy other = tree_of({inner_node(tall, 1), leaf(cube_at(0), 0), leaf(tall, 1)});
    INFO("the other way round: node 1 is the cube, node 2 the tower");
    check_children(other, 0, {{0.5, 0.5, 0.5}, {0, 1, 0}}, ahead, {{1, {0, 0.5}}, {2, {0, 4.5}}});
}

TEST_CASE("the children are those of the node that was asked about", "[13.1]") {
    const Hierarchy tree = row_of_four();
    INFO(four_in_words);
    const Ray along{{-1, 0.5, 0.5}, {1, 0, 0}};
    check_children(tree, 0, along, ahead, {{1, {1, 4}}, {2, {5, 8}}});
    check_children(tree, 1, along, ahead, {{3, {1, 2}}, {4, {3, 4}}});
    check_children(tree, 2, along, ahead, {{5, {5, 6}}, {6, {7, 8}}});
}

TEST_CASE("all leaves on the way are asked, the nearest first", "[13.2]") {
    const Hierarchy tree = row_of_four();
    INFO(four_in_words << "; shapes 0, 1, 2, 3 are in the leaves in this order");
    const auto check = [&](const Ray& ray, Interval range, const std::vector<std::uint32_t>& expected,
                           std::uint64_t nodes) {
        const Asking asked = asking(tree, ray, range, nothing_found);
        INFO(show(ray) << " in " << range << ", which finds nothing");
        {
            INFO("the shapes that are asked, in order");
            CHECK(same_order(asked.shapes, expected));
        }
        INFO("how many nodes are looked into");
        CHECK(asked.counts.cells == nodes);
    };
    check({{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, {0, 1, 2, 3}, 7);
    check({{8, 0.5, 0.5}, {-1, 0, 0}}, ahead, {3, 2, 1, 0}, 7);
    check({{4.5, 0.5, -1}, {0, 0, 1}}, ahead, {2}, 3);
    check({{3.5, 0.5, -1}, {0, 0, 1}}, ahead, {}, 1);
    check({{3.5, 5, -1}, {0, 0, 1}}, ahead, {}, 0);
    check({{-1, 0.5, 0.5}, {1, 0, 0}}, {0, 4.5}, {0, 1}, 4);
    check({{-1, 0.5, 0.5}, {1, 0, 0}}, {0, 6.5}, {0, 1, 2}, 6);
    check({{-1, 0.5, 0.5}, {1, 0, 0}}, {4.5, infinity}, {2, 3}, 4);
}

TEST_CASE("what begins beyond the nearest hit so far is passed over", "[13.2]") {
    const Hierarchy tree = row_of_four();
    const auto check = [&](Real end, const std::vector<std::uint32_t>& expected, std::uint64_t nodes) {
        const Asking asked =
            asking(tree, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, [&](std::uint32_t) { return end; });
        INFO(four_in_words << "; the ray comes into the boxes of shapes 0, 1, 2, 3 at t = 1, 3, 5, 7, and "
                              "each shape says that something was found at t = "
                           << end);
        {
            INFO("the shapes that are asked, in order");
            CHECK(same_order(asked.shapes, expected));
        }
        INFO("how many nodes are looked into");
        CHECK(asked.counts.cells == nodes);
    };
    check(1.5, {0}, 3);
    check(3.5, {0, 1}, 4);
    check(5.5, {0, 1, 2}, 6);
    check(7.5, {0, 1, 2, 3}, 7);
    // −∞ says that nothing more is wanted.
    check(-infinity, {0}, 3);
}

TEST_CASE("what begins just at the nearest hit is asked: it may be as near, and have a lower number",
          "[13.2]") {
    const Hierarchy tree = row_of_four();
    const Ray ray{{-1, 0.5, 0.5}, {1, 0, 0}};
    INFO(four_in_words << "; a hit is found exactly where the ray comes into a box, to the last digit");
    {
        const Real end = children_met(tree, 1, ray, ahead).visits[1].t.min;
        INFO("where it comes into the second leaf: which shapes are asked");
        CHECK(same_order(asking(tree, ray, ahead, [=](std::uint32_t) { return end; }).shapes, {0, 1}));
    }
    const Real end = children_met(tree, 0, ray, ahead).visits[1].t.min;
    INFO("where it comes into the second pair, and so into the third leaf: which shapes are asked");
    CHECK(same_order(asking(tree, ray, ahead, [=](std::uint32_t) { return end; }).shapes, {0, 1, 2}));
}

TEST_CASE("a hit behind the beginning of another box does not hide what is in that", "[13.2]") {
    const Hierarchy tree =
        tree_of({inner_node(part_of_row(0, 9), 1), leaf(part_of_row(0, 9), 0), leaf(cube_at(4), 1)});
    const Ray ray{{0, 0.5, 0.5}, {1, 0, 0}};
    INFO("shape 0 in a box from x = 0 to 9, shape 1 in one from x = 4 to 5");
    {
        INFO("shape 0 is hit at t = 8: which are asked");
        CHECK(same_order(asking(tree, ray, ahead, [](std::uint32_t) { return 8.0; }).shapes, {0, 1}));
    }
    INFO("shape 0 is hit at t = 3: which are asked");
    CHECK(same_order(asking(tree, ray, ahead, [](std::uint32_t) { return 3.0; }).shapes, {0}));
}

TEST_CASE("the search goes all the way down before it turns to the other child", "[13.2]") {
    // The first child has a near and a far leaf, the second lies between them.
    const Hierarchy tree = tree_of({inner_node(part_of_row(0, 9), 1), inner_node(part_of_row(0, 9), 3),
                                    leaf(cube_at(4), 2), leaf(cube_at(0), 0), leaf(cube_at(8), 1)});
    const Asking asked = asking(tree, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, nothing_found);
    INFO(
        "a node with leaves at x = 0 (shape 0) and x = 8 (shape 1), and beside it a leaf at x = 4 (shape 2): "
        "the shapes that are asked, in order");
    CHECK(same_order(asked.shapes, {0, 1, 2}));
}

TEST_CASE("a leaf's shapes are asked all at once, with the part of the ray in its box", "[13.2]") {
    const Hierarchy tree = tree_of(
        {inner_node(part_of_row(0, 4), 1), leaf(cube_at(0), 0, 3), leaf(cube_at(3), 3, 2)}, {7, 2, 5, 9, 4});
    const Asking asked = asking(tree, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, nothing_found);
    INFO("a leaf with shapes 7, 2, 5 in a cube of edge 1 at x = 0, and one with 9 and 4 at x = 3");
    {
        INFO("the shapes that are asked");
        CHECK(same_numbers(asked.shapes, {2, 4, 5, 7, 9}));
    }
    {
        INFO("in how many calls of `ask`");
        REQUIRE(asked.parts.size() == 2);
    }
    INFO("at which t the part of the ray in the leaf begins");
    CHECK(near(asked.parts[0].min, 1, 1e-12));
    CHECK(near(asked.parts[1].min, 4, 1e-12));
}

TEST_CASE("a hierarchy of one leaf", "[13.2]") {
    const Hierarchy tree = tree_of({leaf(cube_at(0), 0, 2)});
    INFO("the root is a leaf with shapes 0 and 1 in a cube of edge 1 at x = 0");
    {
        const Asking met = asking(tree, {{-1, 0.5, 0.5}, {1, 0, 0}}, ahead, nothing_found);
        INFO("a ray through it: which shapes are asked, and how many nodes are looked into");
        CHECK(same_order(met.shapes, {0, 1}));
        CHECK(met.counts.cells == 1);
    }
    const Asking missed = asking(tree, {{-1, 2.5, 0.5}, {1, 0, 0}}, ahead, nothing_found);
    INFO("a ray beside it: which shapes are asked");
    CHECK(same_order(missed.shapes, {}));
}

TEST_CASE("the nearest of many triangles is, to the bit, that of asking them all", "[13.2]") {
    Random random(1301);
    std::vector<Triangle> triangles;
    for (int k = 0; k < 200; ++k) {
        const Vec3 at = random.in_cube();
        const auto corner = [&] { return at + Real(0.3) * random.in_cube(); };
        triangles.push_back({corner(), corner(), corner()});
    }
    // Some stand in the same place.
    for (int k = 0; k < 20; ++k) triangles[random.index(200)] = triangles[random.index(200)];
    std::vector<Bounds> boxes;
    for (const Triangle& triangle : triangles) boxes.push_back(bounds_of(triangle));
    const Hierarchy tree = plain_tree(boxes);
    Mailbox mailbox;
    for (int k = 0; k < cases(500); ++k) {
        const Ray ray = towards(random, random.in_cube(), 3);
        const std::optional<Hit> all = closest_hit(triangles, ray, ahead);
        INFO("200 triangles, " << show(ray) << ": the nearest hit, expected what asking all of them finds");
        CHECK(same_hit(closest_hit(tree, triangles, ray, ahead, mailbox), all));
        const bool any = any_hit(tree, triangles, ray, ahead, mailbox);
        CHECK(or_say(any == all.has_value(),
                     any ? "any_hit finds what is not there" : "any_hit finds nothing"));
    }
}

TEST_CASE("of equal distances the lowest number wins, in whichever leaf it is", "[13.2]") {
    const Triangle wall{{2, -9, -9}, {2, 9, 0}, {2, -9, 9}};
    // Shape 0 lies in the leaf that the ray enters last.
    const std::vector<Triangle> walls(3, wall);
    const Bounds box{{2, -9, -9}, {2, 9, 9}}, longer{{1, -9, -9}, {2, 9, 9}};
    const Hierarchy tree = tree_of({inner_node(longer, 1), leaf(longer, 0, 2), leaf(box, 2)}, {2, 1, 0});
    Mailbox mailbox;
    const std::optional<Hit> hit = closest_hit(tree, walls, {{0, 0, 0}, {1, 0, 0}}, ahead, mailbox);
    INFO(
        "three times the same triangle: 2 and 1 in a leaf that the ray enters at t = 1, 0 in one that it "
        "enters at t = 2, where all are hit; which of them is");
    CHECK(same_hit(hit, Hit{.t = 2, .primitive = 0}));
}
