// Trees of spheres, of oriented boxes and of ellipsoids: they contain what they should, and find what a
// search among all shapes finds.
#include "chapters/13_hierarchies/volumes.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/13_hierarchies/build.hpp"
#include "tests/13_hierarchies/trees.hpp"
#include "tests/catch.hpp"
#include "tests/stability/volumes.hpp"
#include "tests/support.hpp"

using namespace rt;
using rt::test::boxes_of;
using rt::test::cases;
using rt::test::near;
using rt::test::or_say;
using rt::test::Random;
using rt::test::show;

namespace {

template <class Shape>
ShapePoints points_of(const std::vector<Shape>& shapes) {
    ShapePoints points;
    for (const Shape& shape : shapes) add_points(points, shape, bounds_of(shape));
    return points;
}

bool is_inside(const BoundingSphere& sphere, const Vec3& p) {
    return length(p - sphere.center) <= sphere.radius;
}
bool is_inside(const OrientedBox& box, const Vec3& p) {
    return glm::all(glm::lessThanEqual(glm::abs((p - box.center) * box.axes), box.half));
}
bool is_inside(const BoundingEllipsoid& ellipsoid, const Vec3& p) {
    return length(ellipsoid.to_unit * (p - ellipsoid.center)) <= 1;
}

/// Triangles around a ring, long and thin, in all directions.
std::vector<Triangle> some_triangles(Random& random, int count) {
    std::vector<Triangle> triangles;
    for (int k = 0; k < count; ++k) {
        const Vec3 p = random.in_cube(), along = 0.4 * random.direction();
        triangles.push_back({p, p + along, p + along + 0.02 * random.direction()});
    }
    return triangles;
}

/// Trees of this kind over triangles: each shape's corners, and all a margin around them, are in all nodes
/// above it, and rays find what they find without a tree.
template <class MakeTree>
void check_tree(const MakeTree& make) {
    Random random(1325);
    const std::vector<Triangle> triangles = some_triangles(random, 200);
    const ShapePoints points = points_of(triangles);
    // No method of the chapter made it: only the volumes are in question here.
    const auto boxes = boxes_of(triangles);
    const Hierarchy hierarchy = test::plain_tree(boxes);
    const auto tree = make(hierarchy, points);
    {
        INFO("how many nodes the tree has, as many as the hierarchy of boxes");
        REQUIRE(tree.nodes.size() == hierarchy.nodes.size());
    }
    for (std::size_t number = 0; number < tree.nodes.size(); ++number) {
        const auto& node = tree.nodes[number];
        for (std::uint32_t k = 0; k < node.count; ++k) {
            const Triangle& t = triangles[tree.items[node.first + k]];
            for (const Vec3& corner : {t.a, t.b, t.c})
                for (const Real by : {-0.99, 0.99}) {
                    const Vec3 moved = corner + by * tree.margin;
                    INFO("node " << number << " has the " << node.volume << "; of one of its shapes, the "
                                 << t << ", it has to contain a corner, moved by nearly a margin, " << moved);
                    CHECK(or_say(is_inside(node.volume, moved), "which is outside"));
                }
        }
    }
    Mailbox mailbox;
    for (int k = 0; k < cases(2000); ++k) {
        const Vec3 from = 3.0 * random.direction();
        const Ray ray{from, random.in_cube() - from};
        const std::optional<Hit> expected = closest_hit(triangles, ray, {});
        const std::optional<Hit> actual = closest_hit(tree, triangles, ray, {}, mailbox);
        INFO("200 long thin triangles; what the " << ray << " hits, as without a tree");
        CHECK(test::same_hit(actual, expected));
        INFO("and whether anything is hit at all");
        CHECK(any_hit(tree, triangles, ray, {}, mailbox) == expected.has_value());
    }
}

/// A row of small spheres, of which a ray along it hits the first, and one across it one.
template <class MakeTree>
void check_row(const MakeTree& make) {
    std::vector<Sphere> spheres;
    for (int k = 0; k < 64; ++k) spheres.push_back({{k, 0, 0}, 0.3});
    const auto tree = make(test::plain_tree(boxes_of(spheres)), points_of(spheres));
    Mailbox mailbox;
    const auto check = [&](const Ray& ray, std::uint32_t number, std::uint64_t most) {
        std::optional<Hit> hit;
        const SearchCounts counts =
            test::counted([&] { hit = closest_hit(tree, spheres, ray, {}, mailbox); });
        INFO("a row of 64 spheres of radius 0.3 along x; the " << ray << " hits number " << number);
        REQUIRE(hit);
        CHECK(hit->primitive == number);
        INFO("how many shapes it asks: few");
        CHECK(counts.shapes <= most);
        CHECK(counts.shapes >= 1);
        INFO("how many nodes it looks into: the root, and few more");
        CHECK(counts.cells <= 30);
        CHECK(counts.cells >= 2);
    };
    check({{-5, 0, 0}, {1, 0, 0}}, 0, 4);
    check({{70, 0, 0}, {-1, 0, 0}}, 63, 4);
    check({{40, 0, -5}, {0, 0, 1}}, 40, 6);
}

/// Of equal distances the lowest number wins, in whichever order the tree is walked.
template <class MakeTree>
void check_ties(const MakeTree& make) {
    std::vector<Triangle> triangles;
    for (int k = 0; k < 12; ++k) triangles.push_back({{-1.0 - k, -1, 0}, {1.0 + k, -1, 0}, {0, 1.0 + k, 0}});
    const auto tree = make(test::plain_tree(boxes_of(triangles)), points_of(triangles));
    Mailbox mailbox;
    for (const Real z : {-3.0, 3.0}) {
        const Ray ray{{0, 0, z}, {0, 0, -z}};
        INFO("twelve triangles on one another in the plane z = 0; the first is hit by the " << ray);
        const std::optional<Hit> hit = closest_hit(tree, triangles, ray, {}, mailbox);
        REQUIRE(hit);
        CHECK(hit->primitive == 0);
        CHECK(near(hit->t, 1, 1e-12));
    }
}

const auto spheres = [](const Hierarchy& hierarchy, const ShapePoints& points) {
    return sphere_tree(hierarchy, points);
};
const auto boxes = [](const Hierarchy& hierarchy, const ShapePoints& points) {
    return oriented_box_tree(hierarchy, points);
};
const auto ellipsoids = [](const Hierarchy& hierarchy, const ShapePoints& points) {
    return ellipsoid_tree(hierarchy, points);
};

}  // namespace

TEST_CASE("a tree of spheres contains its shapes and finds what is there", "[13.16]") { check_tree(spheres); }
TEST_CASE("a tree of spheres asks few", "[13.16]") { check_row(spheres); }
TEST_CASE("a tree of spheres: the first of equal shapes", "[13.16]") { check_ties(spheres); }

TEST_CASE("a tree of oriented boxes contains its shapes and finds what is there", "[13.21]") {
    check_tree(boxes);
}
TEST_CASE("a tree of oriented boxes asks few", "[13.21]") { check_row(boxes); }
TEST_CASE("a tree of oriented boxes: the first of equal shapes", "[13.21]") { check_ties(boxes); }

TEST_CASE("a tree of ellipsoids contains its shapes and finds what is there", "[13.24]") {
    check_tree(ellipsoids);
}
TEST_CASE("a tree of ellipsoids asks few", "[13.24]") { check_row(ellipsoids); }
TEST_CASE("a tree of ellipsoids: the first of equal shapes", "[13.24]") { check_ties(ellipsoids); }
