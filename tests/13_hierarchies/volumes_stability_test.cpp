// Bounding volumes on extreme clouds and rays, against exact arithmetic and bounds that nothing can beat; and
// trees of them against asking every shape, to the bit.
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "chapters/13_hierarchies/build.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/volume.hpp"
#include "tests/show.hpp"
#include "tests/stability/hierarchies.hpp"
#include "tests/stability/volumes.hpp"
#include "tests/support.hpp"

#include <numeric>

using namespace rt;
using namespace rt::stability;
using namespace rt::test;

namespace {

/// By how much rounding may move a point of the cloud.
Real slack_of(std::span<const Vec3> points) { return 16 * unit_roundoff * greatest_coordinate(points); }

/// The covariance with the 64 bits of a long double, seen from one of the points: where they are is nothing
/// to how they are spread.
Mat3 long_covariance(std::span<const Vec3> points) {
    const auto from_first = [&](const Vec3& point, int i) {
        return static_cast<long double>(point[i]) - static_cast<long double>(points[0][i]);
    };
    const auto count = static_cast<long double>(points.size());
    long double mean[3] = {};
    for (const Vec3& point : points)
        for (int i = 0; i < 3; ++i) mean[i] += from_first(point, i) / count;
    Mat3 result(0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            long double sum = 0;
            for (const Vec3& point : points)
                sum += (from_first(point, i) - mean[i]) * (from_first(point, j) - mean[j]);
            result[i][j] = static_cast<Real>(sum / count);
        }
    return result;
}

/// Calls check(points) for clouds of all families.
template <class Check>
void for_clouds(int count, const Check& check) {
    for (const CloudFamily& family : cloud_families()) {
        Random random(1330);
        for (int k = 0; k < count / static_cast<int>(cloud_families().size()) + 1; ++k) {
            const std::vector<Vec3> points = family.make(random);
            INFO(family.name << " (" << family.extremes << "), cloud number " << k << " of " << points.size()
                             << " points");
            check(points);
        }
    }
}

/// How far the farthest point is outside of the sphere.
Real outside_of(const BoundingSphere& sphere, std::span<const Vec3> points) {
    Real most = -infinity;
    for (const Vec3& point : points) most = std::max(most, length(point - sphere.center) - sphere.radius);
    return most;
}

/// Volumes with rays at them: nothing inside may be lost, and only a little more may be said to be inside.
struct Judged {
    int inside = 0, lost_by_naive = 0, all = 0;

    template <class Volume>
    void judge(const Volume& volume, const Volume& larger, const Ray& ray, Interval range) {
        const std::optional<Interval> part = clip(volume, ray, range);
        const oracle::PartTruth truth = oracle::judge_part(volume, larger, ray, range, part);
        INFO("case " << all << ": the part of the " << ray << " in " << range << " that is inside the "
                     << volume << " is " << part);
        CHECK(or_say(!truth.lost,
                     "a part of the ray that is inside is lost, if only in the last digit: rounding must be "
                     "allowed for"));
        CHECK(or_say(!truth.too_much, "it ends farther outside than the contract allows"));
        ++all;
        inside += truth.inside ? 1 : 0;
        const std::optional<Interval> naive = naive::clip(volume, ray, range);
        if (oracle::judge_part(volume, larger, ray, range, naive).lost) ++lost_by_naive;
    }
    void check_counts() const {
        {
            INFO("how many of " << all << " rays go through");
            CHECK(inside > all / 10);
        }
        INFO("the naive method has to lose something, else the cases show nothing; it lost "
             << lost_by_naive);
        CHECK(lost_by_naive > all / 100);
    }
};

Interval some_range(Random& random) {
    Interval range;
    if (random.index(4) == 0) range = {-infinity, infinity};
    if (random.index(8) == 0) range.max = random.magnitude(-2, 2);
    return range;
}

Vec3 some_center(Random& random) {
    return random.index(3) == 0 ? Vec3(0) : random.magnitude(-6, 6) * random.in_cube();
}

/// Trees over the scenes of chapter 9's families, with shapes of all kinds.
template <class MakeTree>
void check_trees(int rays, const MakeTree& make) {
    constexpr std::size_t rays_a_scene = 100;
    Mailbox mailbox;
    for (const GridFamily& family : grid_families()) {
        const auto scenes = static_cast<std::size_t>(rays) / rays_a_scene / grid_families().size() + 1;
        std::size_t wrong = 0, asked = 0;
        std::string first;
        for (std::uint64_t k = 0; k < scenes; ++k) {
            const GridScene scene = make_scene_of_trees(family, 1340 + k);
            Random random(1340 + k);
            std::visit(
                [&](const auto& shapes) {
                    ShapePoints points;
                    for (const auto& shape : shapes) add_points(points, shape, bounds_of(shape));
                    const auto tree = make(hierarchy_over(scene.shapes, some_options(random)), points);
                    for (const GridQuestion& question : make_questions(scene, rays_a_scene, 1340 + k)) {
                        const std::optional<Hit> right = nearest_of_all(scene, question);
                        const std::optional<Hit> found =
                            closest_hit(tree, shapes, question.ray, question.range, mailbox);
                        const bool any = any_hit(tree, shapes, question.ray, question.range, mailbox);
                        ++asked;
                        const bool same = right.has_value() == found.has_value() &&
                                          any == right.has_value() &&
                                          (!right || (right->t == found->t && right->uv == found->uv &&
                                                      right->primitive == found->primitive &&
                                                      right->element == found->element));
                        if (same) continue;
                        if (++wrong == 1)
                            first = "seed " + show(1340 + k) + ", " + show(question.ray) + ": " +
                                    show(found) + ", expected " + show(right);
                    }
                },
                scene.shapes);
        }
        INFO(family.name << " (" << family.extremes << "): of " << asked
                         << " rays, how many find something else than among all shapes; the first, "
                         << first);
        CHECK(wrong == 0);
    }
}

/// Rays from inside of a closed mesh to its corners and edges: none gets out.
template <class MakeTree>
void check_leaks(const MakeTree& make) {
    Random random(1350);
    Mailbox mailbox;
    for (int k = 0; k < 4; ++k) {
        const std::vector<Triangle> mesh = closed_mesh(random, 6 + 4 * k);
        ShapePoints points;
        for (const Triangle& t : mesh) add_points(points, t, bounds_of(t));
        const auto tree = make(build_hierarchy(mesh), points);
        int leaks = 0;
        const int rays = cases(5000);
        for (int i = 0; i < rays; ++i)
            if (!closest_hit(tree, mesh, ray_at_edge(mesh, random), {}, mailbox)) ++leaks;
        INFO("of " << rays << " rays from inside of a closed mesh of " << mesh.size()
                   << " triangles to its edges and corners, how many get out");
        CHECK(leaks == 0);
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

TEST_CASE("Ritter's spheres contain extreme clouds", "[13.13][stability]") {
    for_clouds(3000, [](const std::vector<Vec3>& points) {
        const BoundingSphere sphere = sphere_by_ritter(points);
        INFO("how far the farthest point is outside of the " << sphere);
        CHECK(outside_of(sphere, points) <= slack_of(points));
    });
}

TEST_CASE("the smallest spheres of extreme clouds contain them, and none is smaller", "[13.15][stability]") {
    for_clouds(1500, [](const std::vector<Vec3>& points) {
        const SmallestSphere smallest = smallest_sphere(points);
        {
            INFO("how far the farthest point is outside of the " << smallest.sphere);
            CHECK(outside_of(smallest.sphere, points) <= slack_of(points));
        }
        const Real least = std::max(least_radius(points), least_radius(smallest.support));
        {
            INFO("its radius; no sphere around the points has one less than " << least);
            CHECK(smallest.sphere.radius <= least * (1 + 0x1p-24) + 2 * slack_of(points));
        }
        INFO("how many points hold it");
        CHECK(smallest.support.size() <= 4);
        for (const Vec3& point : smallest.support) {
            INFO("how far the point " << point << " of the support is from the centre, expected the radius");
            CHECK(near(length(point - smallest.sphere.center), smallest.sphere.radius,
                       0x1p-24 * smallest.sphere.radius + 2 * slack_of(points)));
        }
    });
}

TEST_CASE("no part of a ray in a sphere is lost, and little is added, against exact arithmetic",
          "[13.16][stability]") {
    Random random(1331);
    Judged judged;
    for (int k = 0; k < cases(10'000); ++k) {
        const BoundingSphere sphere{some_center(random), random.index(10) == 0 ? 0 : random.magnitude(-6, 6)};
        const Ray ray =
            some_ray_at(random, sphere.center, sphere.radius > 0 ? sphere.radius : random.magnitude(-3, 3));
        BoundingSphere larger = sphere;
        larger.radius += 0x1p-45 * (sphere.radius + length(ray.origin - sphere.center));
        judged.judge(sphere, larger, ray, some_range(random));
    }
    judged.check_counts();
}

TEST_CASE("covariance of extreme clouds", "[13.17][stability]") {
    Real worst_naive = 0;
    for_clouds(3000, [&](const std::vector<Vec3>& points) {
        const Mat3 expected = long_covariance(points), actual = covariance(points);
        const Mat3 naive = naive::covariance(points);
        const Real mean_off = slack_of(points) * static_cast<Real>(points.size());
        for (int i = 0; i < 3; ++i) {
            const Real bound =
                0x1p-40 * std::max({size_of(expected[0]), size_of(expected[1]), size_of(expected[2])}) +
                mean_off * mean_off;
            INFO("column " << i << ", expected as computed with 64 bits");
            CHECK(near(actual[i], expected[i], bound));
            if (bound > 0) worst_naive = std::max(worst_naive, size_of(naive[i] - expected[i]) / bound);
        }
    });
    INFO(
        "the mean of products less the product of means has to fail here; by how many times the bound it is "
        "off");
    CHECK(worst_naive > 100);
}

TEST_CASE("boxes along any axes contain extreme clouds and touch them", "[13.19][stability]") {
    Random random(1332);
    for_clouds(3000, [&](const std::vector<Vec3>& points) {
        const Mat3 axes = some_axes(random);
        const OrientedBox box = box_along(axes, points);
        Vec3 low(infinity), high(-infinity);
        for (const Vec3& point : points) {
            const Vec3 place = (point - box.center) * axes;
            low = glm::min(low, place), high = glm::max(high, place);
        }
        INFO("how far the points reach from the centre along the axes, down and up");
        CHECK(near(-low, box.half, 2 * slack_of(points)));
        CHECK(near(high, box.half, 2 * slack_of(points)));
    });
}

TEST_CASE("no part of a ray in an oriented box is lost, and little is added, against exact arithmetic",
          "[13.21][stability]") {
    Random random(1333);
    Judged judged;
    for (int k = 0; k < cases(5'000); ++k) {
        OrientedBox box{some_axes(random), some_center(random), Vec3(0)};
        for (int a = 0; a < 3; ++a) box.half[a] = random.index(5) == 0 ? 0 : random.magnitude(-3, 3);
        // Often along a face or an edge.
        Ray ray = some_ray_at(random, box.center, max_component(box.half));
        if (random.index(2) == 0) {
            const int a = static_cast<int>(random.index(3)), b = (a + 1) % 3;
            ray.direction =
                random.magnitude(-3, 3) * (random.sign() * box.axes[a] + random.uniform(-1, 1) * box.axes[b]);
            ray.origin = box.center +
                         box.axes * (box.half * Vec3(random.sign(), random.sign(), random.sign())) -
                         random.uniform(0, 3) * ray.direction;
        }
        OrientedBox larger = box;
        larger.half += 0x1p-45 * (length(box.half) + length(ray.origin - box.center));
        judged.judge(box, larger, ray, some_range(random));
    }
    judged.check_counts();
}

TEST_CASE("ellipsoids of thin clouds: weights, and what follows from them", "[13.22][stability]") {
    Random random(1334);
    for (int k = 0; k < cases(1000); ++k) {
        // Down to 1e-5 of the length; flatter clouds are thickened before they come here.
        const Vec3 reach(1, random.magnitude(-5, 0), random.magnitude(-5, 0));
        const Mat3 axes = some_axes(random);
        const Vec3 center = random.index(2) == 0 ? Vec3(0) : 100.0 * random.in_cube();
        const Real scale = random.magnitude(-12, 12);
        std::vector<Vec3> points;
        const std::size_t count = 5 + random.index(40);
        while (points.size() < count)
            points.push_back(scale * (center + axes * (reach * random.direction())));
        const std::vector<Real> weights = ellipsoid_weights(points, 0.125);
        const BoundingEllipsoid ellipsoid = ellipsoid_of(points, weights);
        Real deepest = 0;
        for (const Vec3& point : points)
            deepest = std::max(deepest, length(ellipsoid.to_unit * (point - ellipsoid.center)));
        INFO(points.size() << " points on an ellipsoid of axes " << reach << ", " << show_size(scale)
                           << " times as large");
        {
            INFO("the sum of the weights");
            CHECK(near(std::accumulate(weights.begin(), weights.end(), Real(0)), 1, 1e-11));
        }
        {
            INFO("how far to_unit takes the point that it takes farthest");
            CHECK(near(deepest, 1, 1e-5));
        }
        // Seen in units of the axes, so that the determinant has all its digits.
        std::vector<Vec3> round;
        for (const Vec3& point : points) round.push_back((point / scale - center) * axes / reach);
        const Real least = 4 * pi / 3 *
                           std::sqrt(27 * glm::determinant(spread_of(round, weights).covariance)) *
                           (scale * scale * scale) * (reach.x * reach.y * reach.z);
        INFO("its volume, at most 1.125^1.5 times " << least << ", below which none is");
        CHECK(volume_of(ellipsoid) <= least * std::pow(1.125, 1.5) * (1 + 1e-4));
    }
}

TEST_CASE("no part of a ray in an ellipsoid is lost, and little is added, against exact arithmetic",
          "[13.24][stability]") {
    Random random(1335);
    Judged judged;
    for (int k = 0; k < cases(5'000); ++k) {
        const Vec3 reach =
            random.magnitude(-3, 3) * Vec3(1, random.magnitude(-5, 0), random.magnitude(-5, 0));
        const Mat3 axes = some_axes(random);
        Mat3 to_unit = glm::transpose(axes);
        for (int a = 0; a < 3; ++a) to_unit[a] /= reach;
        // Rounding may make an axis longer than it was.
        const BoundingEllipsoid ellipsoid{some_center(random), to_unit, reach.x * (1 + 0x1p-20)};
        // A ray at the unit sphere, taken where the ellipsoid is.
        const Ray at_unit = some_ray_at(random, Vec3(0), 1);
        const Ray ray{ellipsoid.center + axes * (reach * at_unit.origin), axes * (reach * at_unit.direction)};
        const Mat3& m = to_unit;
        const Real size = std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
        BoundingEllipsoid larger = ellipsoid;
        larger.to_unit /= 1 + 0x1p-44 * size * (ellipsoid.longest + length(ray.origin - ellipsoid.center));
        judged.judge(ellipsoid, larger, ray, some_range(random));
    }
    judged.check_counts();
}

TEST_CASE("what trees of spheres find is, to the bit, what asking all finds", "[13.16][stability]") {
    check_trees(cases(20'000), spheres);
}
TEST_CASE("nothing leaks through trees of spheres", "[13.16][stability]") { check_leaks(spheres); }

TEST_CASE("what trees of oriented boxes find is, to the bit, what asking all finds", "[13.21][stability]") {
    check_trees(cases(20'000), boxes);
}
TEST_CASE("nothing leaks through trees of oriented boxes", "[13.21][stability]") { check_leaks(boxes); }

TEST_CASE("what trees of ellipsoids find is, to the bit, what asking all finds", "[13.24][stability]") {
    check_trees(cases(20'000), ellipsoids);
}
TEST_CASE("nothing leaks through trees of ellipsoids", "[13.24][stability]") { check_leaks(ellipsoids); }
