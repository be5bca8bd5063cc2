// Steps 04.1 to 04.5 and 04.7: matrices, their stack and inverse, what they do to points, vectors, normals
// and rays, and the rotation in a matrix.
#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "tests/04_transforms/show.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <limits>

using namespace rt;
using test::cases;
using test::difference;
using test::Random;
using test::show;

namespace {

const Mat4 identity(1);

/// From rows, as on paper.
Mat4 rows(const Vec4& a, const Vec4& b, const Vec4& c) {
    Mat4 m(1);
    for (int i = 0; i < 4; ++i) m[i] = Vec4(a[i], b[i], c[i], i == 3 ? 1 : 0);
    return m;
}

void check_vector(const Vec3& actual, const Vec3& expected) { CHECK(test::near(actual, expected, 0)); }

void check_point(const Mat4& m, const Vec3& point, const Vec3& expected) {
    INFO("the matrix" << m << "\nwhere it takes the point " << point);
    check_vector(transform_point(m, point), expected);
}

void check_direction(const Mat4& m, const Vec3& direction, const Vec3& expected) {
    INFO("the matrix" << m << "\nwhere it takes the direction " << direction);
    check_vector(transform_vector(m, direction), expected);
}

void check_normal(const Mat4& back, const Vec3& normal, const Vec3& expected) {
    INFO("the inverse matrix" << back << "\nwhere a map with this inverse takes the normal " << normal);
    CHECK(test::near_direction(transform_normal(back, normal), expected, 0));
}

/// Where two matrices differ most.
std::string worst_element(const Mat4& actual, const Mat4& expected) {
    int row = 0, column = 0;
    const auto off = [&](int c, int r) {
        const Real d = std::abs(actual[c][r] - expected[c][r]);
        return std::isnan(d) ? infinity : d;
    };
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (off(c, r) > off(column, row)) row = r, column = c;
    return "row " + show(row + 1) + ", column " + show(column + 1) + " has " + show(actual[column][row]) +
           ", expected " + show(expected[column][row]);
}

void check_matrix(const Mat4& actual, const Mat4& expected, Real within = 0) {
    const bool right = difference(actual, expected) <= within;  // false for NaN
    INFO("expected" << expected);
    CHECK(test::or_say(right, worst_element(actual, expected) + "; in all" + show(actual)));
}

Mat4 some_affine(Random& random) {
    Mat4 m(1);
    for (int c = 0; c < 4; ++c) m[c] = Vec4(2.0 * random.in_cube(), c == 3 ? 1 : 0);
    return m;
}

// What cos and sin of this machine and the rounded degree leave of a right angle is far below this.
constexpr Real few_roundings = 8 * unit_roundoff;

}  // namespace

// ------------------------------------------------------------------------- 04.1 translation and scaling

TEST_CASE("a translation stands in the last column", "[04.1]") {
    INFO("the translation by (2, 3, 4), and by 0");
    check_matrix(translation({2, 3, 4}), rows({1, 0, 0, 2}, {0, 1, 0, 3}, {0, 0, 1, 4}));
    check_matrix(translation({0, 0, 0}), identity);
}

TEST_CASE("a scaling stands on the diagonal", "[04.1]") {
    INFO("the scaling by (2, 3, 4), and by 1");
    check_matrix(scaling({2, 3, 4}), rows({2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}));
    check_matrix(scaling({1, 1, 1}), identity);
}

TEST_CASE("a factor may be negative or tiny", "[04.1]") {
    INFO("the scaling by (-1, 1, 1), and by (1e-300, -1e300, 0.5)");
    check_matrix(scaling({-1, 1, 1}), rows({-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}));
    check_matrix(scaling({1e-300, -1e300, 0.5}), rows({1e-300, 0, 0, 0}, {0, -1e300, 0, 0}, {0, 0, 0.5, 0}));
}

TEST_CASE("a translation moves points to the bit, and a scaling multiplies each coordinate", "[04.1]") {
    Random random(4101);
    for (int i = 0; i < cases(1000); ++i) {
        const Vec3 p = random.magnitude(-9, 9) * random.in_cube(),
                   by = random.magnitude(-9, 9) * random.in_cube();
        INFO("the point " << p << " moved by " << by << ", the direction " << p
                          << " moved, the point scaled");
        CHECK(Vec3(translation(by) * Vec4(p, 1)) == p + by);
        CHECK(Vec3(translation(by) * Vec4(p, 0)) == p);
        CHECK(Vec3(scaling(by) * Vec4(p, 1)) == p * by);
    }
}

// ----------------------------------------------------------------------------------------- 04.2 rotation

TEST_CASE("a quarter turn about z takes x to y and y to -x", "[04.2]") {
    INFO("the rotation by pi/2 about (0, 0, 1)");
    check_matrix(rotation({0, 0, 1}, pi / 2), rows({0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}), few_roundings);
}

TEST_CASE("quarter turns go x to y, y to z, z to x, counterclockwise about each axis", "[04.2]") {
    INFO("the rotations by pi/2 about (1, 0, 0), and about (0, 1, 0)");
    check_matrix(rotation({1, 0, 0}, pi / 2), rows({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}), few_roundings);
    check_matrix(rotation({0, 1, 0}, pi / 2), rows({0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}), few_roundings);
}

TEST_CASE("a third of a turn about the diagonal takes x to y, y to z and z to x", "[04.2]") {
    INFO("the rotation by 2/3 pi about (1, 1, 1), which is not a unit vector");
    check_matrix(rotation({1, 1, 1}, 2 * pi / 3), rows({0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}),
                 few_roundings);
}

TEST_CASE("half a turn about (1, 1, 0) exchanges x and y and turns z round", "[04.2]") {
    INFO("the rotation by pi about (1, 1, 0), which is not a unit vector");
    check_matrix(rotation({1, 1, 0}, pi), rows({0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}), few_roundings);
}

TEST_CASE("no angle is no rotation", "[04.2]") {
    INFO("the rotation by 0 about (1, 2, 3)");
    check_matrix(rotation({1, 2, 3}, 0), identity, few_roundings);
}

TEST_CASE("the axis may have any length", "[04.2]") {
    const Mat4 expected = rotation({1, 2, -2}, 1);
    for (const Real length : {0.1, 3.0, 1e-200, 1e200}) {
        INFO("the rotation by 1 about " << length << " * (1, 2, -2), expected that about (1, 2, -2)");
        check_matrix(rotation(length * Vec3(1, 2, -2), 1), expected, few_roundings);
    }
}

TEST_CASE("a rotation keeps its axis, lengths and angles, and has the determinant 1", "[04.2]") {
    Random random(4201);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 axis = random.magnitude(-3, 3) * random.direction();
        const Real angle = random.uniform(-7, 7);
        const Mat4 m = rotation(axis, angle);
        INFO("the rotation by " << angle << " about " << axis << m);
        // With the unit axis k right to 4u, 1 − c to 2u, (1 − c)·k[i]·k is off by 23u|k[i]|, sin·(k × e) by
        // 7u, cos·e by u, and the sums by 5u: a column by 36u in all. Products of two columns are off by
        // twice that, the determinant by three times.
        {
            INFO("its transpose times itself");
            check_matrix(glm::transpose(m) * m, identity, gamma(80));
        }
        {
            INFO("its determinant");
            CHECK(test::near(glm::determinant(Mat3(m)), 1, gamma(120)));
        }
        INFO("where it takes its axis");
        CHECK(test::near(Mat3(m) * axis, axis, gamma(48) * length(axis)));
    }
}

TEST_CASE("the angle between a vector and its image is the angle of the rotation", "[04.2]") {
    Random random(4202);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 k = random.direction();
        const Vec3 v = normalize(cross(k, random.direction()));
        const Real angle = random.uniform(-pi, pi);
        const Vec3 turned = Mat3(rotation(k, angle)) * v;
        INFO("the angle from " << v << " to its image under the rotation about " << k
                               << ", counterclockwise seen from the axis' tip");
        CHECK(test::near(std::atan2(dot(cross(v, turned), k), dot(v, turned)), angle, gamma(32)));
    }
}

TEST_CASE("turning back undoes a rotation", "[04.2]") {
    Random random(4203);
    for (int i = 0; i < cases(1000); ++i) {
        const Vec3 axis = random.direction();
        const Real angle = random.uniform(-pi, pi);
        INFO("by " << angle << " about " << axis
                   << ": there and back; back, expected the transpose; and by minus the angle about minus "
                      "the axis");
        // Columns are off by 36u each, as above.
        check_matrix(rotation(axis, angle) * rotation(axis, -angle), identity, gamma(80));
        check_matrix(rotation(axis, -angle), glm::transpose(rotation(axis, angle)), gamma(80));
        check_matrix(rotation(-axis, -angle), rotation(axis, angle), gamma(80));
    }
}

// ------------------------------------------------------------------------------------------ 04.3 compose

namespace {

/// One matrix a node.
std::vector<Mat4> matrices(const std::vector<TransformNode>& nodes) {
    const std::vector<Mat4> m = compose(nodes);
    INFO("how many matrices there are");
    REQUIRE(m.size() == nodes.size());
    return m;
}

}  // namespace

TEST_CASE("by hand: translate 10 0 0, then scale 2 2 2: the last step that was written acts first",
          "[04.3]") {
    // translate 10 0 0, then scale 2 2 2: a point is scaled, then moved.
    const std::vector<TransformNode> nodes{{-1, Translate{{10, 0, 0}}, {}}, {0, Scale{{2, 2, 2}}, {}}};
    const std::vector<Mat4> m = matrices(nodes);
    INFO("translate 10 0 0, then scale 2 2 2: the matrix after the first, and after both");
    check_matrix(m[0], rows({1, 0, 0, 10}, {0, 1, 0, 0}, {0, 0, 1, 0}));
    check_matrix(m[1], rows({2, 0, 0, 10}, {0, 2, 0, 0}, {0, 0, 2, 0}));
}

TEST_CASE("by hand: scale 2 2 2, then translate 10 0 0: the other order gives another matrix", "[04.3]") {
    const std::vector<TransformNode> nodes{{-1, Scale{{2, 2, 2}}, {}}, {0, Translate{{10, 0, 0}}, {}}};
    const std::vector<Mat4> m = matrices(nodes);
    INFO("scale 2 2 2, then translate 10 0 0: the matrix after both");
    check_matrix(m[1], rows({2, 0, 0, 20}, {0, 2, 0, 0}, {0, 0, 2, 0}));
}

TEST_CASE("no nodes have no matrices", "[04.3]") {
    INFO("how many matrices there are of no nodes");
    CHECK(compose({}).size() == 0);
}

TEST_CASE("nodes with the same parent do not touch each other", "[04.3]") {
    // translate; push; scale; pop; scale: a pop goes back to the parent.
    const std::vector<TransformNode> nodes{{-1, Translate{{1, 2, 3}}, {}},
                                           {0, Scale{{2, 1, 1}}, {}},
                                           {0, Scale{{1, 3, 1}}, {}},
                                           {-1, Scale{{5, 5, 5}}, {}}};
    const std::vector<Mat4> m = matrices(nodes);
    INFO(
        "translate 1 2 3; push; scale 2 1 1; pop; scale 1 3 1: node 0 is the translation, the parent of both "
        "scalings\nthe matrices of nodes 1, 2 and 3");
    check_matrix(m[1], rows({2, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}));
    check_matrix(m[2], rows({1, 0, 0, 1}, {0, 3, 0, 2}, {0, 0, 1, 3}));
    check_matrix(m[3], scaling({5, 5, 5}));
}

TEST_CASE("every node is its parent's matrix times its own step", "[04.3]") {
    Random random(4301);
    std::vector<TransformNode> nodes;
    for (int i = 0; i < cases(2000); ++i) {
        const int parent = static_cast<int>(random.index(nodes.size() + 1)) - 1;
        TransformStep step = Translate{random.in_cube()};
        if (i % 3 == 1) step = Rotate{random.direction(), random.uniform(-4, 4)};
        if (i % 3 == 2) step = Scale{random.in_cube() + Vec3(2)};
        nodes.push_back({parent, step, {}});
    }
    const std::vector<Mat4> m = matrices(nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int parent = nodes[i].parent;
        INFO("the matrix of node " << i << ", whose parent is " << parent);
        check_matrix(m[i],
                     (parent < 0 ? identity : m[static_cast<std::size_t>(parent)]) * matrix(nodes[i].step));
    }
}

TEST_CASE("after a chain of 1000 rotations a matrix is still one, but for as many roundings", "[04.3]") {
    Random random(4302);
    std::vector<TransformNode> nodes;
    for (int i = 0; i < 1000; ++i)
        nodes.push_back({i - 1, Rotate{random.direction(), random.uniform(-pi, pi)}, {}});
    const std::vector<Mat4> m = matrices(nodes);
    INFO("the last matrix's transpose times itself");
    // One product of two rotations adds 3 roundings of sums of at most √3 an element.
    check_matrix(glm::transpose(m.back()) * m.back(), identity, gamma(16 * 1000));
}

// ------------------------------------------------------------------------------------------ 04.4 inverse

namespace {

void check_inverse(const Mat4& m, const Mat4& expected) {
    INFO("the inverse of" << m);
    const std::optional<Mat4> result = inverse(m);
    REQUIRE(result);
    check_matrix(*result, expected);
}

Mat4 inverted(const Mat4& m) {
    INFO("the inverse of" << show(m));
    const std::optional<Mat4> result = inverse(m);
    REQUIRE(result);
    return *result;
}

}  // namespace

TEST_CASE("the inverse of the identity is the identity", "[04.4]") { check_inverse(identity, identity); }

TEST_CASE("the inverse of a scaling divides", "[04.4]") {
    check_inverse(scaling({2, -4, 0.5}), scaling({0.5, -0.25, 2}));
}

TEST_CASE("the inverse of a translation goes back", "[04.4]") {
    check_inverse(translation({1, 2, 3}), translation({-1, -2, -3}));
}

TEST_CASE("scaled, then moved: the inverse moves back, then divides", "[04.4]") {
    check_inverse(rows({2, 0, 0, 10}, {0, 4, 0, 20}, {0, 0, 8, 40}),
                  rows({0.5, 0, 0, -5}, {0, 0.25, 0, -5}, {0, 0, 0.125, -5}));
}

TEST_CASE("where the first element is zero, another row is the pivot", "[04.4]") {
    // x, y, z change places: no element of the diagonal is a pivot.
    check_inverse(rows({0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}),
                  rows({0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}));
    check_inverse(rows({0, 2, 0, 6}, {4, 0, 0, 8}, {0, 0, 1, 0}),
                  rows({0, 0.25, 0, -2}, {0.5, 0, 0, -3}, {0, 0, 1, 0}));
}

TEST_CASE("where elimination leaves a zero on the diagonal, rows change places then", "[04.4]") {
    const Mat4 m = rows({1, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 1, 0});
    check_inverse(m, rows({0, 1, -1, 0}, {1, -1, 1, 0}, {-1, 1, 0, 0}));
}

TEST_CASE("a shear is undone by the opposite shear", "[04.4]") {
    check_inverse(rows({1, 1e6, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}),
                  rows({1, -1e6, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}));
}

TEST_CASE("what is small in every direction is not singular", "[04.4]") {
    check_inverse(scaling(Vec3(0x1p-50)), scaling(Vec3(0x1p50)));
    check_inverse(scaling(Vec3(0x1p-300)), scaling(Vec3(0x1p300)));
    check_inverse(scaling({0x1p50, 0x1p-50, 1}), scaling({0x1p-50, 0x1p50, 1}));
}

TEST_CASE("a singular matrix has no inverse", "[04.4]") {
    const Vec4 zero(0);
    const auto is_singular = [](const Mat4& m) {
        INFO("the inverse of" << show(m));
        CHECK_FALSE(inverse(m));
    };
    is_singular(rows(zero, zero, zero));
    is_singular(scaling({1, 0, 1}));                                        // flattened
    is_singular(rows({1, 2, 3, 0}, {2, 4, 6, 0}, {0, 0, 1, 0}));            // two rows along a line
    is_singular(rows({1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 9, 0}));            // three rows in a plane
    is_singular(rows({.1, .2, .3, 0}, {.1, .2, .3, 0}, {1, 0, 0, 0}));      // rounded, but equal
    is_singular(rows({1e9, 2e9, 0, 5}, {1e-9, 2e-9, 0, 5}, {0, 0, 1, 5}));  // one line in two units
}

TEST_CASE("a matrix that is not finite has no inverse", "[04.4]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Real bad : {nan, infinity, -infinity})
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r) {
                Mat4 m = scaling({1, 2, 3});
                m[c][r] = bad;
                INFO("the inverse of" << m);
                CHECK_FALSE(inverse(m));
            }
    // The inverse would not fit into a number.
    CHECK_FALSE(inverse(rows({1e-200, 0, 0, 1e200}, {0, 1, 0, 0}, {0, 0, 1, 0})));
}

TEST_CASE("an inverse undoes its matrix from both sides", "[04.4]") {
    Random random(4401);
    for (int i = 0; i < cases(5000); ++i) {
        const Mat4 m = some_affine(random);
        const Mat4 x = inverted(m);
        // The exact judge comes in the tests of stability; here products are rounded as well.
        const Real size = 16 * (difference(m, Mat4(0)) * difference(x, Mat4(0)));
        INFO("the matrix" << m << "\ntimes its inverse, and the inverse times the matrix");
        check_matrix(m * x, identity, unit_roundoff * size);
        check_matrix(x * m, identity, unit_roundoff * size);
    }
}

TEST_CASE("in other units the inverse is the same to the bit", "[04.4]") {
    Random random(4402);
    for (int i = 0; i < cases(1000); ++i) {
        const Mat4 m = some_affine(random);
        const Real unit = std::ldexp(Real(1), static_cast<int>(random.index(81)) - 40);
        const Mat4 x = inverted(m);
        INFO("the matrix" << m << "\nand the same in units of " << unit);
        check_inverse(scaling(Vec3(unit)) * m, x * scaling(Vec3(1 / unit)));
        check_inverse(m * scaling(Vec3(unit)), scaling(Vec3(1 / unit)) * x);
    }
}

// ----------------------------------------------------------------- 04.5 points, vectors, normals and rays

TEST_CASE("points feel a translation and directions do not", "[04.5]") {
    const Mat4 m = rows({2, 0, 0, 10}, {0, 3, 0, 20}, {0, 0, 4, 30});
    check_point(m, {1, 1, 1}, {12, 23, 34});
    check_direction(m, {1, 1, 1}, {2, 3, 4});
}

TEST_CASE("the columns of a matrix are the images of the axes", "[04.5]") {
    const Mat4 m = rows({1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12});
    check_direction(m, {1, 0, 0}, {1, 5, 9});
    check_direction(m, {0, 1, 0}, {2, 6, 10});
    check_direction(m, {0, 0, 1}, {3, 7, 11});
    check_point(m, {0, 0, 0}, {4, 8, 12});
}

TEST_CASE("the normal of a slope that is stretched along x turns up", "[04.5]") {
    // The plane x + y = 0 contains (1, -1, 0). Stretched by 2 along x it contains (2, -1, 0): its normal is
    // along (1, 2, 0), which is (1/2, 1, 0), and not along (2, 1, 0).
    check_normal(scaling({0.5, 1, 1}), {1, 1, 0}, {0.5, 1, 0});
}

TEST_CASE("a translation does not change a normal", "[04.5]") {
    check_normal(translation({-5, 6, 7}), {0.25, 0.5, 1}, {0.25, 0.5, 1});
}

TEST_CASE("a shear turns the normals of the sides that it slants", "[04.5]") {
    // x grows by 3y: the sides that faced x lean over, top and bottom do not.
    const Mat4 back = rows({1, -3, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0});
    check_normal(back, {1, 0, 0}, {1, -3, 0});
    check_normal(back, {0, 1, 0}, {0, 1, 0});
}

TEST_CASE("under a reflection outward normals stay outward", "[04.5]") {
    const Mat4 m = scaling({-2, 1, 1});
    // The right side of a cube becomes its left side.
    check_normal(inverted(m), {1, 0, 0}, {-0.5, 0, 0});
}

TEST_CASE("normals stay at right angles to tangents", "[04.5]") {
    Random random(4501);
    for (int i = 0; i < cases(5000); ++i) {
        const Mat4 m = some_affine(random);
        const std::optional<Mat4> back = inverse(m);
        REQUIRE(back);
        const Vec3 n = random.direction(), tangent = cross(n, random.direction());
        const Vec3 moved = transform_normal(*back, n), along = transform_vector(m, tangent);
        INFO("the matrix" << m << "\nnormal " << n << ", tangent " << tangent << "; they become " << moved
                          << " and " << along << "\ntheir product, 0 where they are at right angles");
        // Each of the two products of a matrix and a vector is off by 3 roundings of what it adds up.
        const Real size = difference(m, Mat4(0)) * difference(*back, Mat4(0));
        CHECK(test::near(dot(moved, along), 0, gamma(12) * 9 * size));
        CHECK(test::or_say(length(moved) > 0, "the normal has become 0"));
    }
}

TEST_CASE("a ray in local space: origin as a point, direction as a vector, the same time", "[04.5]") {
    const Mat4 m = rows({2, 0, 0, 10}, {0, 4, 0, 0}, {0, 0, 1, 0});
    const Transform transform{m, inverted(m)};
    const Ray local = to_local(transform, {{14, 8, 3}, {1, 1, -1}, 0.25});
    INFO("the map" << m << "\nthe world's ray from (14, 8, 3) along (1, 1, -1) at time 0.25, in local space");
    {
        INFO("its origin");
        check_vector(local.origin, {2, 2, 3});
    }
    {
        INFO("its direction, which keeps the length that the map gives it");
        CHECK(test::near_direction(local.direction, {0.5, 0.25, -1}, 0));
    }
    INFO("its time");
    CHECK(local.time == 0.25);
}

TEST_CASE("t means the same point in both spaces", "[04.5]") {
    Random random(4502);
    for (int i = 0; i < cases(5000); ++i) {
        const Mat4 m = some_affine(random);
        const std::optional<Mat4> back = inverse(m);
        REQUIRE(back);
        const Ray world{random.in_cube(), random.magnitude(-2, 2) * random.direction()};
        const Ray local = to_local({m, *back}, world);
        const Real t = random.uniform(0, 10);
        const Vec3 there = point_at(world, t), again = transform_point(m, point_at(local, t));
        INFO("the matrix" << m << "\nthe local ray's point at t = " << t
                          << ", taken to the world; expected the world ray's at that t");
        const Real size = 9 * difference(m, Mat4(0)) * difference(*back, Mat4(0)) *
                          (2 + length(world.origin) + t * length(world.direction));
        CHECK(test::near(again, there, gamma(16) * size));
    }
}

TEST_CASE("a surface in the world: a point by the map, unit normals by its inverse", "[04.5]") {
    const Mat4 m = rows({2, 0, 0, 10}, {0, 1, 0, 20}, {0, 0, 1, 30});
    Surface local;
    local.point = {1, 2, 3};
    local.normal = normalize(Vec3(1, 1, 0));
    local.shading_normal = {0, 1, 0};
    local.uv = {0.25, 0.75};
    const Surface world = to_world({m, inverted(m)}, local);
    INFO("the map" << m << "\na surface at (1, 2, 3), normal along (1, 1, 0), shading normal (0, 1, 0)");
    {
        INFO("its point in the world");
        check_vector(world.point, {12, 22, 33});
    }
    {
        INFO("its normal in the world");
        CHECK(test::near_direction(world.normal, Vec3(1, 2, 0) / std::sqrt(5.0), gamma(8)));
    }
    {
        INFO("its shading normal in the world");
        CHECK(test::near_direction(world.shading_normal, {0, 1, 0}, 0));
    }
    INFO("uv, which stays as it is");
    CHECK(world.uv == Vec2(0.25, 0.75));
}

TEST_CASE("normals have length 1 however large or small the map is", "[04.5]") {
    for (const Real unit : {1e-250, 1e-15, 1.0, 1e15, 1e250}) {
        const Mat4 m = scaling(unit * Vec3(1, 2, 4));
        Surface local;
        local.normal = local.shading_normal = normalize(Vec3(1, 2, 3));
        const Surface world = to_world({m, inverted(m)}, local);
        INFO("a map that scales by about " << unit << ": the lengths of the normal and the shading normal");
        CHECK(test::near(length(world.normal), 1, gamma(4)));
        CHECK(test::near(length(world.shading_normal), 1, gamma(4)));
    }
}

// ---------------------------------------------------------------------------------- 04.7 nearest rotation

namespace {

void check_nearest(const Mat4& m, const Mat4& expected) {
    INFO("the rotation nearest to" << m);
    const std::optional<Mat4> result = nearest_rotation(m);
    REQUIRE(result);
    check_matrix(*result, expected, 2 * few_roundings);
}

}  // namespace

TEST_CASE("in the shear from (x, y) to (x + y, y) is a turn by the angle whose tangent is -1/2", "[04.7]") {
    const Real s = 1 / std::sqrt(Real(5));
    check_nearest(rows({1, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}),
                  rows({2 * s, s, 0, 0}, {-s, 2 * s, 0, 0}, {0, 0, 1, 0}));
}

TEST_CASE("a rotation is its own nearest one", "[04.7]") {
    check_nearest(identity, identity);
    const Mat4 turn = rotation({1, 2, -2}, 0.75);
    check_nearest(turn, turn);
}

TEST_CASE("a stretch along the axes has no rotation in it", "[04.7]") {
    check_nearest(scaling({2, 3, 4}), identity);
    check_nearest(scaling({0x1p20, 1, 1}), identity);
    check_nearest(scaling(Vec3(0x1p-20)), identity);
}

TEST_CASE("stretched, then turned: the turn is left", "[04.7]") {
    const Mat4 turn = rotation({1, -1, 3}, 2);
    check_nearest(turn * scaling({2, 3, 4}), turn);
    check_nearest(turn * scaling({0.5, 8, 1}), turn);
}

TEST_CASE("the translation stays", "[04.7]") {
    check_nearest(rows({2, 0, 0, 10}, {0, 2, 0, 20}, {0, 0, 2, 30}),
                  rows({1, 0, 0, 10}, {0, 1, 0, 20}, {0, 0, 1, 30}));
}

TEST_CASE("a reflection stays a reflection", "[04.7]") {
    check_nearest(scaling({-2, 3, 1}), scaling({-1, 1, 1}));
}

TEST_CASE("a flattened matrix has no nearest rotation", "[04.7]") {
    INFO("the rotation nearest to a scaling by (1, 0, 1)");
    CHECK_FALSE(nearest_rotation(scaling({1, 0, 1})));
}

TEST_CASE("what is left beside the nearest rotation is a symmetric stretch", "[04.7]") {
    Random random(4701);
    for (int i = 0; i < cases(1000); ++i) {
        const Mat4 m = rotation(random.direction(), random.uniform(-4, 4)) *
                       scaling({random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2)}) *
                       rotation(random.direction(), random.uniform(-4, 4));
        INFO("the matrix" << m);
        const std::optional<Mat4> turn = nearest_rotation(m);
        REQUIRE(turn);
        const Mat4 stretch = glm::transpose(*turn) * m;
        {
            INFO("the transpose of its nearest rotation, times that rotation");
            check_matrix(glm::transpose(*turn) * *turn, identity, gamma(64));
        }
        INFO("the transpose of its nearest rotation, times the matrix; expected its own transpose");
        check_matrix(stretch, glm::transpose(stretch), gamma(128));
    }
}

TEST_CASE("a chain of rotations that has drifted is mended, and hardly moved", "[04.7]") {
    Random random(4702);
    Mat4 m(1);
    for (int i = 0; i < 10'000; ++i) m = m * rotation(random.direction(), random.uniform(-4, 4));
    const std::optional<Mat4> mended = nearest_rotation(m);
    INFO("10,000 rotations one after the other" << m);
    REQUIRE(mended);
    {
        INFO("how far the nearest rotation is from them");
        CHECK(difference(*mended, m) <= gamma(16 * 10'000));
    }
    INFO("the transpose of the nearest rotation, times that rotation");
    check_matrix(glm::transpose(*mended) * *mended, identity, gamma(64));
}
