// Families of extreme clouds of points for chapter 13, and judges of what is fitted around them.
#include "tests/stability/volumes.hpp"

#include "chapters/09_grids/bounds.hpp"
#include "common/math/axes.hpp"
#include "tests/stability/grids.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::Random;

template <class Make>
std::vector<Vec3> cloud(Random& random, const Make& make) {
    std::vector<Vec3> points;
    const std::size_t count = 1 + random.index(random.index(4) == 0 ? 5 : 60);
    for (std::size_t i = 0; i < count; ++i) points.push_back(make());
    return points;
}

constexpr std::array<CloudFamily, 12> families{{
    {"soups", "1 to 60 points",
     [](Random& random) { return cloud(random, [&] { return random.in_cube(); }); }},
    {"scales", "the same, 1e-12 to 1e12 times as large",
     [](Random& random) {
         const Real scale = random.magnitude(-12, 12);
         return cloud(random, [&] { return scale * random.in_cube(); });
     }},
    {"offsets", "the same, up to 1e8 from the origin",
     [](Random& random) {
         const Vec3 offset = random.magnitude(3, 8) * random.direction();
         return cloud(random, [&] { return offset + random.in_cube(); });
     }},
    {"lattices", "whole numbers: equal distances, and points in the same place",
     [](Random& random) {
         const auto whole = [&] { return static_cast<Real>(random.index(3)); };
         return cloud(random, [&] {
             const Real x = whole(), y = whole(), z = whole();
             return Vec3(x, y, z);
         });
     }},
    {"on a sphere", "all points equally far from one place",
     [](Random& random) { return cloud(random, [&] { return random.direction(); }); }},
    {"nearly on a sphere", "the same, but for 1e-16 to 1e-8",
     [](Random& random) {
         const Real noise = random.magnitude(-16, -8);
         return cloud(random, [&] { return random.direction() + noise * random.in_cube(); });
     }},
    {"on a circle", "all points equally far from one place, and in a plane, but for 1e-16 to 1e-8",
     [](Random& random) {
         const Vec3 u = random.direction(), v = random.perpendicular_to(u);
         const Real noise = random.magnitude(-16, -8);
         return cloud(random, [&] {
             const Real angle = random.uniform(0, 2 * pi);
             return std::cos(angle) * u + std::sin(angle) * v + noise * random.in_cube();
         });
     }},
    {"flat", "in a plane along the axes, or in a slanted one up to rounding",
     [](Random& random) {
         const Vec3 u = random.direction(), v = random.perpendicular_to(u);
         const bool slanted = random.index(2) == 0;
         return cloud(random, [&] {
             const Vec3 p = random.in_cube();
             return slanted ? p.x * u + p.y * v : Vec3(p.x, p.y, 0);
         });
     }},
    {"needles", "along a line, 1e-12 to 1e-2 as thick as long",
     [](Random& random) {
         const Vec3 u = random.direction();
         const Real thickness = random.magnitude(-12, -2);
         return cloud(random, [&] { return random.uniform(-1, 1) * u + thickness * random.in_cube(); });
     }},
    {"in one place", "the same point many times, and sometimes another",
     [](Random& random) {
         const Vec3 p = random.in_cube(), q = random.in_cube();
         return cloud(random, [&] { return random.index(8) == 0 ? q : p; });
     }},
    {"one far away", "all points but one near one another, 1e-9 to 1e-3 of its distance",
     [](Random& random) {
         const Real size = random.magnitude(-9, -3);
         std::vector<Vec3> points = cloud(random, [&] { return size * random.in_cube(); });
         points[random.index(points.size())] = random.direction();
         return points;
     }},
    {"in order", "along a spiral, each point farther out than the one before it",
     [](Random& random) {
         Real angle = 0;
         const Real step = random.uniform(0.1, 3);
         return cloud(random, [&] {
             angle += step;
             return angle * Vec3(std::cos(angle), std::sin(angle), 0.1 * angle);
         });
     }},
}};

/// The weights on the points that raise the bound of least_radius.
struct Weighted {
    std::span<const Vec3> points;
    std::vector<Real> weights;
    Vec3 mean{0};

    /// The bound's square.
    Real bound() const {
        Real sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            sum += weights[i] * dot(points[i] - mean, points[i] - mean);
        return sum;
    }
    /// Moves weight from all points to number i, or for s < 0 from it to all.
    void move(std::size_t i, Real s) {
        for (Real& weight : weights) weight *= 1 - s;
        weights[i] += s;
        mean += s * (points[i] - mean);
    }
};

}  // namespace

std::span<const CloudFamily> cloud_families() { return families; }

Real greatest_coordinate(std::span<const Vec3> points) {
    Real greatest = 0;
    for (const Vec3& point : points) greatest = std::max(greatest, size_of(point));
    return greatest;
}

Mat3 some_axes(Random& random) {
    const Mat3 axes = axes_around(random.direction());
    const Real angle = random.uniform(0, 2 * pi), c = std::cos(angle), s = std::sin(angle);
    return {c * axes[0] + s * axes[1], c * axes[1] - s * axes[0], axes[2]};
}

Real least_radius(std::span<const Vec3> all) {
    if (all.empty()) return 0;
    std::vector<Vec3> points;
    for (const Vec3& point : all) points.push_back(point - all[0]);
    Weighted w{points, std::vector<Real>(points.size(), 1 / static_cast<Real>(points.size()))};
    for (std::size_t i = 0; i < points.size(); ++i) w.mean += w.weights[i] * points[i];
    for (int step = 0; step < 20000; ++step) {
        const Real bound = w.bound();
        std::size_t far = 0, near = 0;
        Real farthest = -1, nearest = infinity;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Real square = dot(points[i] - w.mean, points[i] - w.mean);
            if (square > farthest) farthest = square, far = i;
            if (w.weights[i] > 0 && square < nearest) nearest = square, near = i;
        }
        if (!(farthest > bound * (1 + 0x1p-34))) break;
        if (farthest - bound >= bound - nearest) {
            w.move(far, (farthest - bound) / (2 * farthest));
        } else {
            // As far as the bound is raised, but no weight may become negative.
            const Real most = w.weights[near] / (1 - w.weights[near]);
            const Real best = nearest > 0 ? (bound - nearest) / (2 * nearest) : infinity;
            w.move(near, -std::min(best, most));
            if (best >= most) w.weights[near] = 0;
        }
    }
    return std::sqrt(w.bound());
}

Real distance_from_hull(const Vec3& place, std::span<const Vec3> points) {
    Real least = infinity;
    for (std::size_t some = 1; some < std::size_t{1} << points.size(); ++some) {
        // The nearest place of the point, line, plane or space through some of them; if it is between them.
        std::vector<Vec3> corners;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (some >> i & 1) corners.push_back(points[i] - place);
        Mat3 edges(0);
        for (std::size_t k = 1; k < corners.size(); ++k)
            edges[static_cast<int>(k) - 1] = corners[k] - corners[0];
        const int count = static_cast<int>(corners.size()) - 1;
        // Normal equations with ones where there is no edge.
        Mat3 m = glm::transpose(edges) * edges;
        Vec3 right = -(corners[0] * edges);
        for (int k = count; k < 3; ++k) m[k][k] = 1, right[k] = 0;
        const Vec3 weights = glm::inverse(m) * right;
        Real first = 1;
        bool between = true;
        for (int k = 0; k < count; ++k) {
            first -= weights[k];
            between = between && weights[k] >= 0;
        }
        if (!between || !(first >= 0)) continue;
        least = std::min(least, length(corners[0] + edges * weights));
    }
    return least;
}

Ray some_ray_at(Random& random, const Vec3& center, Real size) {
    const Vec3 out = random.direction();
    Vec3 direction = random.direction();
    if (random.index(4) == 0) {
        direction = Vec3(0);
        direction[static_cast<int>(random.index(3))] = random.sign();
    }
    // Near the surface of a ball of this size rays that touch it are frequent.
    if (random.index(2) == 0) direction = random.perpendicular_to(out);
    const Real how_far = random.index(3) == 0 ? random.nudge() : random.uniform(0, 1.2);
    const Vec3 at = center + how_far * size * out;
    const Real back = random.index(4) == 0 ? 0 : size * random.magnitude(-2, 5);
    return {at - back * direction, direction * random.magnitude(-20, 20)};
}

}  // namespace rt::stability

namespace rt::naive {

std::optional<Interval> clip(const BoundingSphere& sphere, const Ray& ray, Interval range) {
    const Vec3 from = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction), b = dot(from, ray.direction);
    const Real c = dot(from, from) - sphere.radius * sphere.radius;
    if (b * b - a * c < 0) return std::nullopt;
    const Real root = std::sqrt(b * b - a * c);
    range.min = std::max(range.min, (-b - root) / a);
    range.max = std::min(range.max, (-b + root) / a);
    return range.min > range.max ? std::nullopt : std::optional(range);
}

std::optional<Interval> clip(const OrientedBox& box, const Ray& ray, Interval range) {
    return naive::clip(Bounds{-box.half, box.half},
                       {(ray.origin - box.center) * box.axes, ray.direction * box.axes}, range);
}

std::optional<Interval> clip(const BoundingEllipsoid& ellipsoid, const Ray& ray, Interval range) {
    return naive::clip(
        BoundingSphere{Vec3(0), 1},
        {ellipsoid.to_unit * (ray.origin - ellipsoid.center), ellipsoid.to_unit * ray.direction}, range);
}

Mat3 covariance(std::span<const Vec3> points) {
    Mat3 products(0);
    Vec3 mean(0);
    for (const Vec3& point : points) products += glm::outerProduct(point, point), mean += point;
    const auto count = static_cast<Real>(points.size());
    return products / count - glm::outerProduct(mean / count, mean / count);
}

}  // namespace rt::naive
