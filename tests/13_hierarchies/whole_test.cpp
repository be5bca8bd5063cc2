// Whole hierarchies that the chapter's own code builds, and what is found by them: the same as by asking all,
// with few questions.
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "tests/13_hierarchies/trees.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using namespace rt::test;

namespace {

/// A ball of small triangles on a large floor.
std::vector<Triangle> ball_in_stadium() {
    const int n = 24;
    std::vector<Triangle> triangles;
    const auto at = [&](int i, int j) {
        const Real u = 2 * pi * i / (2 * n), v = pi * j / n;
        return Vec3(10 + std::sin(v) * std::cos(u), 1 + std::cos(v), 10 + std::sin(v) * std::sin(u));
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < 2 * n; ++i) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    triangles.push_back({{-1000, 0, -1000}, {-1000, 0, 1000}, {1000, 0, 1000}});
    triangles.push_back({{-1000, 0, -1000}, {1000, 0, 1000}, {1000, 0, -1000}});
    return triangles;
}

/// Camera rays that all pass near the ball.
std::vector<Ray> rays_at_ball(int count) {
    return many(static_cast<std::size_t>(count), 1330, [](Random& random) {
        const Vec3 from(13, 4, 20);
        return Ray{from, Vec3(10, 1, 10) + random.in_cube() - from};
    });
}

/// Shapes asked by the rays on their way to their nearest hits; and checks that these are right.
std::uint64_t asked_on_the_way(const Hierarchy& tree, const std::vector<Triangle>& triangles,
                               const std::vector<Ray>& rays) {
    INFO("before any ray is traced: what the contract says of nodes, boxes and shapes");
    REQUIRE(is_right(tree, boxes_of(triangles)));
    Mailbox mailbox;
    std::uint64_t asked = 0, wrong = 0;
    for (const Ray& ray : rays) {
        std::optional<Hit> hit;
        asked += counted([&] { hit = closest_hit(tree, triangles, ray, ahead, mailbox); }).shapes;
        if (!same_hit(hit, closest_hit(triangles, ray, ahead))) ++wrong;
    }
    INFO("for how many of " << rays.size() << " rays the nearest hit is another than that of asking all");
    CHECK(wrong == 0);
    return asked;
}

void check_row(const Hierarchy& tree, const std::vector<Sphere>& spheres) {
    {
        INFO("before any ray is traced: what the contract says of nodes, boxes and shapes");
        REQUIRE(is_right(tree, boxes_of(spheres)));
    }
    Mailbox mailbox;
    const auto check = [&](const Ray& ray, std::optional<Hit> expected) {
        INFO("spheres of radius 0.4 at 0, 1, ... 99 on the x axis; " << ray << ": what is hit");
        const std::optional<Hit> hit = closest_hit(tree, spheres, ray, ahead, mailbox);
        REQUIRE(or_say(hit.has_value() == expected.has_value(), hit ? "a hit" : "nothing"));
        if (!hit) return;
        CHECK(hit->primitive == expected->primitive);
        CHECK(near(hit->t, expected->t, 1e-9));
    };
    check({{-5, 0, 0}, {1, 0, 0}}, Hit{.t = 4.6, .primitive = 0});
    check({{105, 0, 0}, {-1, 0, 0}}, Hit{.t = 5.6, .primitive = 99});
    check({{41.5, 0, 0}, {1, 0, 0}}, Hit{.t = 0.1, .primitive = 42});
    check({{70, -3, 0}, {0, 1, 0}}, Hit{.t = 2.6, .primitive = 70});
    check({{70.5, -3, 0}, {0, 1, 0}}, std::nullopt);
    check({{-5, 0, 0}, {-1, 0, 0}}, std::nullopt);
}

std::vector<Sphere> row_of_spheres() {
    std::vector<Sphere> spheres;
    for (int k = 0; k < 100; ++k) spheres.push_back({{k, 0, 0}, 0.4});
    return spheres;
}

/// Names of methods, in the order of SplitMethod.
constexpr const char* method_names[] = {"halves", "sweep", "bins", "codes"};

}  // namespace

TEST_CASE("the nearest of a row of spheres, by halves", "[13.4]") {
    const std::vector<Sphere> spheres = row_of_spheres();
    check_row(build_hierarchy(spheres, {.method = SplitMethod::Halves, .most = 2}), spheres);
}

TEST_CASE("a ray across a row of spheres asks few of them", "[13.4]") {
    const std::vector<Sphere> spheres = row_of_spheres();
    const Hierarchy tree = build_hierarchy(spheres, {.method = SplitMethod::Halves, .most = 1});
    REQUIRE(is_right(tree, boxes_of(spheres), 1));
    Mailbox mailbox;
    const SearchCounts counts = counted([&] {
        closest_hit(tree, spheres, {{70, -3, 0}, {0, 1, 0}}, ahead, mailbox);
    });
    INFO("a ray that meets one of 100 spheres, each in a leaf of its own: how many it asks");
    CHECK(counts.shapes == 1);
    INFO("how many nodes it looks into: one on each of the 7 or 8 floors of the tree");
    CHECK(counts.cells <= 8);
}

TEST_CASE("a ball in a stadium, by halves", "[13.4]") {
    const std::vector<Triangle> triangles = ball_in_stadium();
    const std::vector<Ray> rays = rays_at_ball(cases(300));
    const Hierarchy tree = build_hierarchy(triangles, {.method = SplitMethod::Halves, .most = 4});
    INFO("2306 triangles and " << rays.size() << " rays: how many triangles a ray asks on average");
    const std::uint64_t asked = asked_on_the_way(tree, triangles, rays);
    CHECK(static_cast<Real>(asked) / static_cast<Real>(rays.size()) < 60);
}

TEST_CASE("a tree by bins parts the teapot from the stadium", "[13.10]") {
    // Sixteen small cubes in a corner and two walls far away.
    std::vector<Bounds> boxes{{{-100, 0, 0}, {-99, 50, 50}}, {{99, 0, 0}, {100, 50, 50}}};
    for (int k = 0; k < 16; ++k)
        boxes.push_back({{k % 4 * 2, k / 4 * 2, 0}, {k % 4 * 2 + 1, k / 4 * 2 + 1, 1}});
    const Hierarchy tree = build_hierarchy(boxes);
    INFO("walls at x = -100 and 100, and between them 16 cubes: what the contract says of the tree");
    CHECK(is_right(tree, boxes));
    INFO("how deep the tree is, by bins: each wall is parted from the cubes, and these are parted further");
    CHECK(depth_of(tree) >= 3);
    const Real by_halves = predicted_cost(build_hierarchy(boxes, {.method = SplitMethod::Halves, .most = 1}));
    INFO("the predicted cost by bins, which is less than by halves, " << by_halves);
    CHECK(predicted_cost(tree) < by_halves);
}

TEST_CASE("every method makes a right tree of random boxes", "[13.10]") {
    Random random(1310);
    for (const SplitMethod method : {SplitMethod::Halves, SplitMethod::Sweep, SplitMethod::Bins})
        for (const std::size_t most : {1u, 8u}) {
            const std::vector<Bounds> boxes = random_boxes(random, 200);
            const Hierarchy tree = build_hierarchy(boxes, {.method = method, .most = most});
            INFO("200 random boxes by " << method_names[static_cast<std::size_t>(method)] << ", at most "
                                        << most
                                        << " in a leaf: what the contract says of nodes, boxes and shapes");
            CHECK(is_right(tree, boxes, most));
        }
}

TEST_CASE("where 64 splits have led to a node its shapes are parted in halves", "[13.10]") {
    // Each cube is half as large as the one before it, and nearer to 0: a sweep parts a few large ones at a
    // time.
    for (const Real side : {1, -1}) {
        std::vector<Bounds> boxes;
        for (int k = 0; k < 500; ++k) {
            const Real size = std::ldexp(Real(1), -k);
            boxes.push_back({Vec3(side * 3 * size, 0, 0) - size, Vec3(side * 3 * size, 0, 0) + size});
        }
        const Hierarchy tree =
            build_hierarchy(boxes, {.method = SplitMethod::Sweep, .most = 1, .costs = {0.01, 1}});
        INFO("500 cubes around x = " << side * 3 << ", " << side * 1.5
                                     << " and so on, each half as large as the one "
                                     << "before it, by a sweep: what the contract says of the tree");
        REQUIRE(is_right(tree, boxes, 1));
        INFO("how deep the deepest leaf is: deeper than 64, where halves begin, and no deeper than 96");
        CHECK(depth_of(tree) > 64);
        CHECK(depth_of(tree) <= 96);
    }
}

TEST_CASE("the nearest of a row of spheres, by bins", "[13.10]") {
    const std::vector<Sphere> spheres = row_of_spheres();
    check_row(build_hierarchy(spheres), spheres);
}

TEST_CASE("a ball in a stadium, by bins: no more questions than by halves", "[13.10]") {
    const std::vector<Triangle> triangles = ball_in_stadium();
    const std::vector<Ray> rays = rays_at_ball(cases(300));
    const Hierarchy by_halves = build_hierarchy(triangles, {.method = SplitMethod::Halves, .most = 4});
    const Hierarchy by_bins = build_hierarchy(triangles, {.most = 4});
    const auto work = [&](const Hierarchy& tree) {
        std::uint64_t asked = 0;
        const SearchCounts counts = counted([&] { asked = asked_on_the_way(tree, triangles, rays); });
        return static_cast<Real>(asked + counts.cells) / static_cast<Real>(rays.size());
    };
    const Real halves = work(by_halves);
    INFO("2306 triangles and " << rays.size() << " rays: nodes and triangles a ray by bins, by halves "
                               << halves);
    CHECK(work(by_bins) < halves);
}

TEST_CASE("what a tree that was fitted to moved shapes finds", "[13.11]") {
    std::vector<Sphere> spheres = row_of_spheres();
    Hierarchy tree = plain_tree(boxes_of(spheres));
    Random random(1331);
    Mailbox mailbox;
    for (int frame = 0; frame < 3; ++frame) {
        for (Sphere& sphere : spheres) sphere.center += Real(5) * random.in_cube();
        tree = refit(tree, boxes_of(spheres));
        for (int k = 0; k < cases(100); ++k) {
            const Ray ray = towards(random, spheres[random.index(100)].center + random.in_cube(), 30);
            INFO("100 spheres that have moved "
                 << frame + 1 << " times, " << ray
                 << ": the nearest hit, expected what asking all of them finds");
            CHECK(
                same_hit(closest_hit(tree, spheres, ray, ahead, mailbox), closest_hit(spheres, ray, ahead)));
        }
    }
}
