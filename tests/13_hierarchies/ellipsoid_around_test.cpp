// Ellipsoids around points: weights, the ellipsoid that follows from them, and where a ray is inside.
#include "chapters/13_hierarchies/ellipsoid_around.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/volume.hpp"
#include "tests/show.hpp"
#include "tests/stability/volumes.hpp"
#include "tests/support.hpp"

#include <numeric>

using namespace rt;
using rt::test::cases;
using rt::test::near;
using rt::test::or_say;
using rt::test::Random;
using rt::test::show;

namespace {

/// The six ends of the axes of an ellipsoid.
std::vector<Vec3> ends(const Vec3& center, const Vec3& reach) {
    std::vector<Vec3> points;
    for (int k = 0; k < 3; ++k)
        for (const Real side : {-1.0, 1.0}) {
            points.push_back(center);
            points.back()[k] += side * reach[k];
        }
    return points;
}

/// (p − c)ᵀ S⁻¹ (p − c), by Cramer's rule.
Real square_of(const WeightedSpread& spread, const Vec3& point) {
    const Mat3& s = spread.covariance;
    const Vec3 p = point - spread.mean;
    const Vec3 q(dot(p, cross(s[1], s[2])), dot(s[0], cross(p, s[2])), dot(s[0], cross(s[1], p)));
    return dot(p, q) / dot(s[0], cross(s[1], s[2]));
}

void check_weights(const std::vector<Vec3>& points, Real tolerance) {
    const std::vector<Real> weights = ellipsoid_weights(points, tolerance);
    INFO("the weights of " << points.size() << " points, with a tolerance of " << tolerance);
    {
        INFO("how many weights there are");
        REQUIRE(weights.size() == points.size());
    }
    Real sum = 0, least = infinity, most = 0;
    for (const Real weight : weights) sum += weight, least = std::min(least, weight);
    {
        INFO("their sum");
        CHECK(near(sum, 1, 1e-11));
    }
    {
        INFO("the least of them");
        CHECK(least >= 0);
    }
    const WeightedSpread spread = spread_of(points, weights);
    for (const Vec3& point : points) most = std::max(most, square_of(spread, point));
    INFO("the most that a point has, expected 3 (1 + tolerance) or less");
    CHECK(most <= 3 * (1 + tolerance) * (1 + 1e-6));
}

std::vector<Real> equal_weights(std::size_t count) {
    return std::vector<Real>(count, 1 / static_cast<Real>(count));
}

/// |to_unit · (p − center)|: 1 on the surface.
Real depth_of(const BoundingEllipsoid& ellipsoid, const Vec3& point) {
    return length(ellipsoid.to_unit * (point - ellipsoid.center));
}

/// The ellipsoid with these axes along x, y and z.
BoundingEllipsoid upright(const Vec3& center, const Vec3& reach) {
    return {center, Mat3(Vec3(1 / reach.x, 0, 0), Vec3(0, 1 / reach.y, 0), Vec3(0, 0, 1 / reach.z)),
            max_component(reach)};
}

void check_part(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range,
                const Interval& expected) {
    INFO("the part of the " << ray << " in " << range << " that is inside the " << ellipsoid);
    const std::optional<Interval> part = clip(ellipsoid, ray, range);
    REQUIRE(or_say(part.has_value(), "it misses the ellipsoid"));
    {
        INFO("where it begins");
        CHECK(near(part->min, expected.min, 1e-11));
    }
    INFO("where it ends");
    CHECK(near(part->max, expected.max, 1e-11));
}

void check_missed(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range = {}) {
    INFO("the part of the " << ray << " in " << range << " that is inside the " << ellipsoid
                            << ", expected nothing");
    const std::optional<Interval> part = clip(ellipsoid, ray, range);
    CHECK(or_say(!part.has_value(), "it is " + show(part.value_or(Interval{}))));
}

}  // namespace

TEST_CASE("by hand: weights that are right at once", "[13.22]") {
    // The covariance of the ends of the axes is 1/3 of the squares of the lengths: each end has 3.
    const std::vector<Real> weights = ellipsoid_weights(ends({1, 2, 3}, {4, 2, 1}), 0.01);
    REQUIRE(weights.size() == 6);
    INFO("the first weight of the six ends of axes 4, 2 and 1 long");
    CHECK(near(weights[0], 1.0 / 6, 1e-12));
    INFO("the last");
    CHECK(near(weights[5], 1.0 / 6, 1e-12));
}

TEST_CASE("a point in the middle loses its weight", "[13.22]") {
    // With equal weights the covariance is 6/7 as large, and each end has 3.5.
    std::vector<Vec3> points = ends(Vec3(0), {4, 2, 1});
    points.push_back(Vec3(0));
    check_weights(points, 0.01);
    const std::vector<Real> weights = ellipsoid_weights(points, 0.01);
    INFO("the weight of the middle of six points; equal weights would be 0.143");
    CHECK(weights.back() < 0.02);
    const std::vector<Real> rough = ellipsoid_weights(points, 0.2);
    INFO("where 3.6 is allowed, nothing changes: the weight of the middle");
    CHECK(near(rough.back(), 1.0 / 7, 1e-12));
}

TEST_CASE("many points at one end do not count more than one", "[13.22]") {
    std::vector<Vec3> points = ends(Vec3(0), {1, 1, 1});
    for (int k = 0; k < 30; ++k) points.push_back({1, 0, 0});
    check_weights(points, 0.01);
    const WeightedSpread spread = spread_of(points, ellipsoid_weights(points, 0.01));
    INFO("the mean, with the weights, of (1, 0, 0) 31 times and the other five ends of axes of length 1");
    CHECK(near(spread.mean, Vec3(0), 0.05));
}

TEST_CASE("weights of clouds", "[13.22]") {
    Random random(1322);
    for (int k = 0; k < cases(200); ++k) {
        std::vector<Vec3> points;
        const Vec3 reach(1, random.magnitude(-3, 0), random.magnitude(-3, 0));
        const Mat3 axes = stability::some_axes(random);
        const Vec3 center = 3.0 * random.in_cube();
        const std::size_t count = 4 + random.index(60);
        while (points.size() < count) points.push_back(center + axes * (reach * random.in_cube()));
        check_weights(points, k % 2 == 0 ? 0.1 : 0.02);
    }
}

TEST_CASE("by hand: the ellipsoid of the ends of its axes", "[13.23]") {
    const std::vector<Vec3> points = ends({1, 2, 3}, {4, 2, 1});
    const BoundingEllipsoid ellipsoid = ellipsoid_of(points, equal_weights(6));
    INFO("the " << ellipsoid << " of the six ends of axes 4, 2 and 1 long around (1, 2, 3)");
    {
        INFO("its centre");
        CHECK(near(ellipsoid.center, Vec3(1, 2, 3), 1e-13));
    }
    {
        INFO("half its greatest diameter");
        CHECK(near(ellipsoid.longest, 4, 1e-12));
    }
    {
        INFO("its volume, 4/3 pi times 4 times 2 times 1");
        CHECK(near(volume_of(ellipsoid), 32 * pi / 3, 1e-10));
    }
    for (const Vec3& point : points) {
        INFO("how far to_unit takes " << point << " from the centre: on the surface");
        CHECK(near(depth_of(ellipsoid, point), 1, 1e-12));
    }
    INFO("how far to_unit takes (3, 2, 3), which is halfway to an end");
    CHECK(near(depth_of(ellipsoid, {3, 2, 3}), 0.5, 1e-12));
}

TEST_CASE("the ellipsoid just contains all points, whatever the weights", "[13.23]") {
    // The corners of a cube are √3 from the middle, and (3, 0, 0) is 3.
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k) points.push_back({k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1});
    points.push_back({3, 0, 0});
    std::vector<Real> weights(8, 0.125);
    weights.push_back(0);
    const BoundingEllipsoid ellipsoid = ellipsoid_of(points, weights);
    INFO("the " << ellipsoid
                << " of the corners of a cube, which have equal weights, and (3, 0, 0), which has none");
    {
        INFO("how far to_unit takes (3, 0, 0): on the surface");
        CHECK(near(depth_of(ellipsoid, {3, 0, 0}), 1, 1e-12));
    }
    INFO("how far to_unit takes (1, 1, 1): inside");
    CHECK(near(depth_of(ellipsoid, {1, 1, 1}), std::sqrt(Real(3)) / 3, 1e-12));
}

TEST_CASE("the ellipsoid has its centre and shape from the weights", "[13.23]") {
    // Half of the weight is at (1, 0, 0), which draws the centre there.
    const std::vector<Vec3> points = ends(Vec3(0), Vec3(1));
    const std::vector<Real> weights{0.1, 0.5, 0.1, 0.1, 0.1, 0.1};
    const BoundingEllipsoid ellipsoid = ellipsoid_of(points, weights);
    INFO("the centre: the mean with weights of 0.5 at (1, 0, 0) and of 0.1 at the other five ends");
    CHECK(near(ellipsoid.center, Vec3(0.4, 0, 0), 1e-13));
    // Along x the covariance is 0.6 − 0.16 = 0.44, along y 0.2.
    const Real along_x = depth_of(ellipsoid, {1.4, 0, 0}), along_y = depth_of(ellipsoid, {0.4, 1, 0});
    INFO("how many times farther to_unit takes a step along y than one along x");
    CHECK(near(along_y / along_x, std::sqrt(0.44 / 0.2), 1e-12));
}

TEST_CASE("ellipsoids of turned clouds contain them, and are as small as the weights say", "[13.23]") {
    Random random(1323);
    for (int k = 0; k < cases(200); ++k) {
        std::vector<Vec3> points;
        const Vec3 reach(1, random.magnitude(-3, 0), random.magnitude(-3, 0));
        const Mat3 axes = stability::some_axes(random);
        const std::size_t count = 4 + random.index(60);
        while (points.size() < count) points.push_back(axes * (reach * random.in_cube()));
        const std::vector<Real> weights = ellipsoid_weights(points, 0.05);
        const BoundingEllipsoid ellipsoid = ellipsoid_of(points, weights);
        Real deepest = 0;
        for (const Vec3& point : points) deepest = std::max(deepest, depth_of(ellipsoid, point));
        INFO(points.size() << " points in a box of halves " << reach);
        {
            INFO("how far to_unit takes the point that it takes farthest");
            CHECK(near(deepest, 1, 1e-8));
        }
        {
            // No ellipsoid around the points is smaller than this, whatever the weights.
            const Real least =
                4 * pi / 3 * std::sqrt(27 * glm::determinant(spread_of(points, weights).covariance));
            INFO("its volume: at least " << least << ", and at most 1.05^1.5 times as much");
            CHECK(volume_of(ellipsoid) >= least * (1 - 1e-6));
            CHECK(volume_of(ellipsoid) <= least * std::pow(1.05, 1.5) * (1 + 1e-6));
        }
        Real longest = 0;
        for (int i = 0; i < 50; ++i)
            longest = std::max(longest, 1 / length(ellipsoid.to_unit * random.direction()));
        INFO("half its greatest diameter, at least what 50 directions show");
        CHECK(ellipsoid.longest >= longest * (1 - 1e-9));
    }
}

TEST_CASE("by hand: a ray through an ellipsoid", "[13.24]") {
    // Along x it reaches from −1 to 3; the line y = 1.6 is at 0.8 of the half axis 2, and goes through 0.6
    // of 5.
    check_part(upright({1, 0, 0}, {2, 1, 3}), {{-5, 0, 0}, {2, 0, 0}}, {}, {2, 4});
    check_part(upright({10, 0, 0}, {5, 2, 1}), {{0, 1.6, 0}, {1, 0, 0}}, {}, {7, 13});
}

TEST_CASE("a slanted ellipsoid", "[13.24]") {
    // 5 along (3, 4, 0)/5, and 1 across.
    const BoundingEllipsoid slanted{
        {1, 1, 0}, glm::transpose(Mat3(Vec3(0.12, 0.16, 0), Vec3(-0.8, 0.6, 0), Vec3(0, 0, 1))), 5};
    check_part(slanted, {{-5, -7, 0}, {0.6, 0.8, 0}}, {}, {5, 15});
    check_part(slanted, {{5, -2, 0}, {-0.8, 0.6, 0}}, {}, {4, 6});
    check_missed(slanted, {{8.06, 2.08, 0}, {-0.8, 0.6, 0}});
}

TEST_CASE("the part of a ray in an ellipsoid is cut to the range", "[13.24]") {
    const BoundingEllipsoid ellipsoid = upright({1, 0, 0}, {2, 1, 3});
    const Ray ray{{-5, 0, 0}, {2, 0, 0}};
    check_part(ellipsoid, ray, {2.5, infinity}, {2.5, 4});
    check_part(ellipsoid, ray, {0, 3}, {2, 3});
    check_part(ellipsoid, {{1, 0, 0}, {0, 0, 1}}, {-infinity, infinity}, {-3, 3});
    check_missed(ellipsoid, ray, {0, 1.9});
    check_missed(ellipsoid, ray, {4.1, infinity});
    check_missed(ellipsoid, {{-5, 1.01, 0}, {1, 0, 0}});
    check_missed(ellipsoid, {{-5, 0.9, 2.9}, {1, 0, 0}});
}

TEST_CASE("a ray that touches an ellipsoid is not lost by rounding", "[13.24]") {
    // Under to_unit, (3, 4, 0)/5 is on the unit sphere, and whatever is across it goes along the sphere
    // there.
    const BoundingEllipsoid ellipsoid = upright({0, 0, 0}, {5, 10, 20});
    for (int m = 1; m <= 12; ++m)
        for (int n = -12; n <= 12; ++n)
            for (const Real times : {3, 7, 11}) {
                const Vec3 across(4 * m, -6 * m, 4 * n);
                const Ray ray{Vec3(3, 8, 0) - across, times * across};
                INFO("the " << ray << " touches the ellipsoid of axes 5, 10 and 20 at (3, 8, 0), where t = 1/"
                            << times);
                const std::optional<Interval> part = clip(ellipsoid, ray, {});
                CHECK(or_say(part.has_value(), "it is missed: rounding must be allowed for"));
            }
}

TEST_CASE("rays through flat ellipsoids that stand aslant lose nothing, by exact arithmetic", "[13.24]") {
    // Under to_unit, what rounds a step along the ellipsoid is 1e4 times as large across it.
    Random random(1336);
    for (int k = 0; k < 500; ++k) {
        const Mat3 axes = stability::some_axes(random);
        const Vec3 reach(1, 1, 1e-4), center = random.in_cube();
        Mat3 to_unit = glm::transpose(axes);
        for (int a = 0; a < 3; ++a) to_unit[a] /= reach;
        const BoundingEllipsoid flat{center, to_unit, 1.000001};
        const Vec3 origin = center + 5.0 * random.direction();
        const Ray ray{origin, center + axes * (reach * (0.5 * random.in_cube())) - origin};
        const std::optional<Interval> part = clip(flat, ray, {});
        const oracle::PartTruth truth = oracle::judge_part(flat, flat, ray, {}, part);
        INFO("the " << ray << " through the flat " << flat << "; what is said to be inside: " << part);
        CHECK(or_say(!truth.lost, "a part that is inside is lost: rounding must be allowed for"));
    }
}
