// Boxes with axes of their own: spread, axes, the box along them, and where a ray is inside.
#include "chapters/13_hierarchies/oriented_box.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"
#include "tests/stability/volumes.hpp"
#include "tests/support.hpp"

using namespace rt;
using rt::test::cases;
using rt::test::near;
using rt::test::near_direction;
using rt::test::or_say;
using rt::test::Random;
using rt::test::show;

namespace {

void check_matrix(const Mat3& actual, const Mat3& expected, Real bound) {
    for (int row = 0; row < 3; ++row) {
        INFO("row " << row << " of the matrix");
        CHECK(near(Vec3(actual[0][row], actual[1][row], actual[2][row]),
                   Vec3(expected[0][row], expected[1][row], expected[2][row]), bound));
    }
}

/// Rows as on paper.
Mat3 rows(const Vec3& a, const Vec3& b, const Vec3& c) { return glm::transpose(Mat3(a, b, c)); }

/// The greatest of what is beside the diagonal.
Real beside_diagonal(const Mat3& m) {
    Real greatest = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != j) greatest = std::max(greatest, std::abs(m[i][j]));
    return greatest;
}

Real greatest_element(const Mat3& m) { return std::max({size_of(m[0]), size_of(m[1]), size_of(m[2])}); }

void check_unit_axes(const Mat3& axes, Real bound) {
    INFO("the lengths of the axes squared, and the products of two of them, 1 and 0 if they are right, in"
         << axes);
    check_matrix(glm::transpose(axes) * axes, Mat3(1), bound);
}

void check_axes(const Mat3& m) {
    INFO("the principal axes of" << m);
    const Mat3 axes = principal_axes(m);
    check_unit_axes(axes, 1e-13);
    const Mat3 along = glm::transpose(axes) * m * axes;
    INFO("the matrix along these axes is" << along);
    INFO("the greatest element beside its diagonal");
    CHECK(near(beside_diagonal(along), 0, 1e-13 * greatest_element(m)));
}

/// The axes, turned about z.
Mat3 turned_by(Real degrees) {
    const Real c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return {Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1)};
}

/// The corners of a box.
std::vector<Vec3> corners(const Mat3& axes, const Vec3& center, const Vec3& half) {
    std::vector<Vec3> points;
    for (const Real x : {-half.x, half.x})
        for (const Real y : {-half.y, half.y})
            for (const Real z : {-half.z, half.z}) points.push_back(center + axes * Vec3(x, y, z));
    return points;
}

void check_part(const OrientedBox& box, const Ray& ray, Interval range, const Interval& expected) {
    INFO("the part of the " << ray << " in " << range << " that is inside the " << box);
    const std::optional<Interval> part = clip(box, ray, range);
    REQUIRE(or_say(part.has_value(), "it misses the box"));
    {
        INFO("where it begins");
        CHECK(near(part->min, expected.min, 1e-12));
    }
    INFO("where it ends");
    CHECK(near(part->max, expected.max, 1e-12));
}

void check_missed(const OrientedBox& box, const Ray& ray, Interval range = {}) {
    INFO("the part of the " << ray << " in " << range << " that is inside the " << box
                            << ", expected nothing");
    const std::optional<Interval> part = clip(box, ray, range);
    CHECK(or_say(!part.has_value(), "it is " + show(part.value_or(Interval{}))));
}

}  // namespace

TEST_CASE("by hand: the spread of a cross", "[13.17]") {
    // The mean is (1, 1, 1); from there the points are at ±2 along x and ±1 along y.
    const std::vector<Vec3> cross{{3, 1, 1}, {-1, 1, 1}, {1, 2, 1}, {1, 0, 1}};
    INFO("the covariance of (3, 1, 1), (-1, 1, 1), (1, 2, 1) and (1, 0, 1)");
    check_matrix(covariance(cross), rows({2, 0, 0}, {0, 0.5, 0}, {0, 0, 0}), 1e-14);
}

TEST_CASE("coordinates that grow together", "[13.17]") {
    const std::vector<Vec3> line{{0, 0, 0}, {2, 4, -2}}, many{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {4, 0, 1}};
    {
        INFO("the covariance of (0, 0, 0) and (2, 4, -2)");
        check_matrix(covariance(line), rows({1, 2, -1}, {2, 4, -2}, {-1, -2, 1}), 1e-14);
    }
    {
        INFO("the covariance of (0, 0, 1) three times and (4, 0, 1)");
        check_matrix(covariance(many), rows({3, 0, 0}, {0, 0, 0}, {0, 0, 0}), 1e-14);
    }
    INFO("the covariance of no points, and of one");
    check_matrix(covariance({}), Mat3(0), 0);
    check_matrix(covariance(std::vector<Vec3>{{1, 2, 3}}), Mat3(0), 0);
}

TEST_CASE("far from the origin points are spread as they are near it", "[13.17]") {
    const Vec3 far(1e9, -1e9, 3e9);
    std::vector<Vec3> cross{{3, 1, 1}, {-1, 1, 1}, {1, 2, 1}, {1, 0, 1}};
    for (Vec3& point : cross) point += far;
    INFO("the covariance of (3, 1, 1), (-1, 1, 1), (1, 2, 1) and (1, 0, 1), each moved by " << far);
    check_matrix(covariance(cross), rows({2, 0, 0}, {0, 0.5, 0}, {0, 0, 0}), 1e-12);
}

TEST_CASE("by hand: the axes of a matrix that stretches slantwise", "[13.18]") {
    // (1, 1, 0) is stretched 3 times, (1, −1, 0) once, and z 5 times.
    const Mat3 axes = principal_axes(rows({2, 1, 0}, {1, 2, 0}, {0, 0, 5}));
    for (const Vec3& expected : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(0, 0, 1)}) {
        Real most = 0;
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(dot(axes[k], normalize(expected))));
        INFO("the axes of |2 1 0|, |1 2 0|, |0 0 5| are" << axes);
        INFO("the cosine between " << expected << " and the axis that is nearest to it");
        CHECK(near(most, 1, 1e-14));
    }
}

TEST_CASE("axes of some matrices", "[13.18]") {
    check_axes(Mat3(0));
    check_axes(Mat3(1));
    check_axes(rows({1, 2, 0}, {2, 1, 0}, {0, 0, 1}));
    check_axes(rows({1, 1, 1}, {1, 1, 1}, {1, 1, 1}));
    check_axes(rows({4, 1, 2}, {1, 3, -1}, {2, -1, 2}));
    check_axes(rows({1, 5, -7}, {5, 2, 3}, {-7, 3, -4}));
    check_axes(rows({1, 1e-9, 0}, {1e-9, 1, 0}, {0, 0, 1e-9}));
    check_axes(rows({0, 0, 3}, {0, 0, 0}, {3, 0, 0}));
}

TEST_CASE("axes of random matrices, of which some elements are tiny", "[13.18]") {
    Random random(1318);
    for (int k = 0; k < cases(1000); ++k) {
        Mat3 m(0);
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                m[i][j] = m[j][i] =
                    random.uniform(-1, 1) * (random.index(3) == 0 ? random.magnitude(-12, 0) : 1);
        check_axes(random.magnitude(-9, 9) * m);
    }
}

TEST_CASE("by hand: a box along slanted axes", "[13.19]") {
    // Along (3, 4, 0)/5 the points are at 0, 5, 0 and 2.5, across it, along (−4, 3, 0)/5, at 0, 0, 5 and 0.
    const Mat3 axes{Vec3(0.6, 0.8, 0), Vec3(-0.8, 0.6, 0), Vec3(0, 0, 1)};
    const std::vector<Vec3> points{{1, 1, 1}, {4, 5, 1}, {-3, 4, 1}, {2.5, 3, 3}};
    const OrientedBox box = box_along(axes, points);
    INFO("the box along (3, 4, 0), (-4, 3, 0) and z around (1, 1, 1), (4, 5, 1), (-3, 4, 1) and (2.5, 3, 3)");
    {
        INFO("half its extent along each axis");
        CHECK(near(box.half, Vec3(2.5, 2.5, 1), 1e-13));
    }
    INFO("its centre");
    CHECK(near(box.center, Vec3(1, 1, 1) + Vec3(1.5, 2, 0) + Vec3(-2, 1.5, 0) + Vec3(0, 0, 1), 1e-13));
}

TEST_CASE("the box of few points, and the axes that it has", "[13.19]") {
    {
        INFO("half the extent of the box of no points: expected less than 0");
        CHECK(max_component(box_along(Mat3(1), {}).half) < 0);
    }
    const std::vector<Vec3> one{{1, 2, 3}};
    const Mat3 axes = turned_by(30);
    const OrientedBox box = box_along(axes, one);
    INFO("the box of the point (1, 2, 3) along axes turned by 30 degrees: its centre, halves and axes");
    CHECK(near(box.center, Vec3(1, 2, 3), 1e-14));
    CHECK(near(box.half, Vec3(0), 1e-14));
    check_matrix(box.axes, axes, 0);
}

TEST_CASE("the box along its own axes is found from its corners", "[13.19]") {
    Random random(1319);
    for (int k = 0; k < cases(500); ++k) {
        const Mat3 axes = stability::some_axes(random);
        const Vec3 center = random.magnitude(0, 3) * random.in_cube();
        const Vec3 half(random.magnitude(-2, 1), random.magnitude(-2, 1), random.magnitude(-2, 1));
        const OrientedBox box = box_along(axes, corners(axes, center, half));
        INFO("a box around " << center << " of halves " << half
                             << ", from its corners: its halves, and its centre");
        CHECK(near(box.half, half, 1e-11));
        CHECK(near(box.center, center, 1e-11));
    }
}

TEST_CASE("turns find a box that stands aslant", "[13.20]") {
    // 4 × 2 × 1: half the area of its surface is 8 + 2 + 4 = 14, and much more along the axes of the world.
    for (const Real degrees : {20.0, 30.0, 40.0, -25.0}) {
        const std::vector<Vec3> points = corners(turned_by(degrees), {5, 0, 0}, {2, 1, 0.5});
        const Real before = half_area(box_along(Mat3(1), points));
        const Mat3 axes = refined_axes(Mat3(1), points);
        INFO("a box of 4 x 2 x 1, turned by " << degrees << " degrees about z: half its area is 14, and "
                                              << before
                                              << " along the axes of the world; along those that were found");
        CHECK(near(half_area(box_along(axes, points)), 14, 0.7));
    }
}

TEST_CASE("turns about each of the three axes are tried", "[13.20]") {
    for (const int number : {0, 1, 2}) {
        Mat3 turn(1);
        const int i = (number + 1) % 3, j = (number + 2) % 3;
        turn[i][i] = turn[j][j] = std::cos(0.5);
        turn[i][j] = std::sin(0.5), turn[j][i] = -std::sin(0.5);
        for (const Mat3& axes : {turn, glm::transpose(turn)}) {
            const std::vector<Vec3> points = corners(axes, Vec3(0), {2, 1, 0.5});
            INFO("a box of 4 x 2 x 1, turned by half a radian about axis number "
                 << number << ": half the area along the axes found, 14 at best");
            CHECK(near(half_area(box_along(refined_axes(Mat3(1), points), points)), 14, 0.7));
        }
    }
}

TEST_CASE("axes that are right already stay", "[13.20]") {
    const std::vector<Vec3> points = corners(Mat3(1), {1, 2, 3}, {2, 1, 0.5});
    INFO("half the area of the box of 4 x 2 x 1, that no turn lessens");
    CHECK(near(half_area(box_along(refined_axes(Mat3(1), points), points)), 14, 1e-12));
    INFO("the axes for a single point");
    check_unit_axes(refined_axes(Mat3(1), std::vector<Vec3>{{1, 2, 3}}), 1e-12);
}

TEST_CASE("turns never make the area greater, and in the end no small one makes it less", "[13.20]") {
    Random random(1320);
    for (int k = 0; k < cases(100); ++k) {
        const std::vector<Vec3> points = stability::cloud_families()[0].make(random);
        const Mat3 start = stability::some_axes(random);
        const Real before = half_area(box_along(start, points));
        const Mat3 axes = refined_axes(start, points);
        const Real after = half_area(box_along(axes, points));
        INFO(points.size() << " points in a cube of edge 2");
        check_unit_axes(axes, 1e-11);
        {
            INFO("half the area before: " << before << ", and now");
            CHECK(after <= before * (1 + 1e-12));
        }
        const Real c = std::cos(pi / 128), s = std::sin(pi / 128);
        for (int number = 0; number < 3; ++number)
            for (const Real sine : {s, -s}) {
                const int i = (number + 1) % 3, j = (number + 2) % 3;
                Mat3 other = axes;
                other[i] = c * axes[i] + sine * axes[j];
                other[j] = c * axes[j] - sine * axes[i];
                INFO("half the area is " << after << "; turned by 1/128 of half a circle about axis "
                                         << number << " of those found it is, expected no less");
                CHECK(half_area(box_along(other, points)) >= after * (1 - 1e-12));
            }
    }
}

TEST_CASE("by hand: a ray through a box that stands aslant", "[13.21]") {
    // Seen along the axes the ray starts at (−5, 0, 0.5) and goes along (1, 0, 0), twice as fast.
    const OrientedBox box{Mat3{Vec3(0.6, 0.8, 0), Vec3(-0.8, 0.6, 0), Vec3(0, 0, 1)}, {1, 1, 1}, {3, 2, 1}};
    check_part(box, {{-2, -3, 1.5}, {1.2, 1.6, 0}}, {}, {1, 4});
    // And along the second axis, with the box from −2 to 2.
    check_part(box, {{5, -2, 1}, {-0.8, 0.6, 0}}, {}, {3, 7});
}

TEST_CASE("the part of a ray in a box is cut to the range", "[13.21]") {
    const OrientedBox box{Mat3{Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1)}, {10, 0, 0}, {1, 2, 3}};
    const Ray ray{{0, 0, 0}, {2, 0, 0}};
    check_part(box, ray, {}, {4, 6});
    check_part(box, ray, {4.5, infinity}, {4.5, 6});
    check_part(box, ray, {0, 5}, {4, 5});
    check_part(box, {{10, 0.5, 0}, {0, 1, 0}}, {-infinity, infinity}, {-1.5, 0.5});
    check_missed(box, ray, {0, 3.9});
    check_missed(box, ray, {6.1, infinity});
    check_missed(box, {{20, 0, 0}, {2, 0, 0}});
}

TEST_CASE("rays beside a box, and an empty box, are missed", "[13.21]") {
    const OrientedBox box{Mat3{Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1)}, {10, 0, 0}, {1, 2, 3}};
    check_missed(box, {{0, 1.5, 0}, {1, 0, 0}});
    check_missed(box, {{0, 0, 3.5}, {1, 0, 0}});
    check_missed(box, {{12.5, 5, 0}, {0, -1, 0}});
    check_missed({}, {{0, 0, 5}, {0, 0, -1}});
    // Past a corner that the box along the world's axes around it would still meet.
    const OrientedBox diamond{turned_by(45), Vec3(0), Vec3(1)};
    check_missed(diamond, {{1.3, -5, 0}, {0.03, 1, 0}});
}

TEST_CASE("a ray along a face of a box is not lost by rounding", "[13.21]") {
    // A flat box: every ray in its plane is inside of nothing but a face.
    for (int k = 1; k <= 40; ++k) {
        const Vec3 u = normalize(Vec3(3, 4, k)), v = normalize(Vec3(-4, 3, 0)), w = cross(u, v);
        const OrientedBox flat{Mat3(u, v, w), {k, 7, 0.1 * k}, {2, 2, 0}};
        for (const Real t : {3, 7, 11}) {
            const Ray ray{flat.center - t * (u + 0.3 * v), u + 0.3 * v};
            INFO("the " << ray << " runs in a flat " << flat << " up to rounding of its numbers");
            const std::optional<Interval> part = clip(flat, ray, {});
            CHECK(or_say(part.has_value(), "it is missed: rounding must be allowed for"));
        }
    }
}
