// Step 10.2: the box, its faces and its surface.
#include "chapters/10_surfaces/box.hpp"
#include "tests/10_surfaces/check_span.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using test::ahead;
using test::cases;
using test::describe;
using test::Random;

namespace {

const Box cube{Vec3(-1), Vec3(1)};

void check_inside(const Box& box, const Ray& ray, const Span& expected) {
    INFO(describe(box, ray));
    test::check_span(inside(box, ray), expected);
}

void check_outside(const Box& box, const Ray& ray) {
    INFO(describe(box, ray));
    test::check_no_span(inside(box, ray));
}

void check_surface(const Box& box, const Ray& ray, const Vec3& point, const Vec3& normal) {
    const std::optional<Hit> hit = intersect(box, ray, ahead);
    INFO(describe(box, ray) << "\n" << hit);
    REQUIRE(hit.has_value());
    const Surface surface = surface_at(box, ray, *hit);
    INFO("expected point " << point << ", normal " << normal);
    INFO("actual   point " << surface.point << ", normal " << surface.normal);
    CHECK(test::near(surface.point, point, gamma(8) * 10));
    CHECK(surface.normal == normal);
    CHECK(surface.shading_normal == normal);
}

/// The point of one of the box's corners, edges or faces: each coordinate low, high or between.
Vec3 on_the_box(Random& random, const Box& box) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        const Real s = random.index(2) == 0 ? random.uniform(0, 1) : static_cast<Real>(random.index(2));
        p[axis] = s == 0   ? box.low[axis]
                  : s == 1 ? box.high[axis]
                           : glm::mix(box.low[axis], box.high[axis], s);
    }
    return p;
}

}  // namespace

TEST_CASE("a ray straight through a cube enters by its front and leaves by its back", "[10.2]") {
    check_inside(cube, {{0, 0, 5}, {0, 0, -1}}, {4, 6, 5, 4});
    check_inside(cube, {{5, 0, 0}, {-2, 0, 0}}, {2, 3, 1, 0});
    check_inside(cube, {{0, -3, 0}, {0, 1, 0}}, {2, 4, 2, 3});
}

TEST_CASE("the worked example: in by the left face at 1, out by the top at 1.5", "[10.2]") {
    check_inside({{1, -0.5, -1}, {3, 0.5, 1}}, {{-1, -1, 0}, {2, 1, 0}}, {1, 1.5, 0, 3});
}

TEST_CASE("a ray that passes a corner misses", "[10.2]") {
    check_outside(cube, {{-3, 0, 0}, {1, 1, 0}});
    check_outside(cube, {{-3, 0, 0}, {1, 0, -0.75}});
    check_outside(cube, {{0, 3, 0}, {1, 0, 0}});
}

TEST_CASE("a ray along a face meets the box, one beside it does not", "[10.2]") {
    for (const Real zero : {0.0, -0.0}) {
        check_inside(cube, {{1, 0, 5}, {zero, zero, -1}}, {4, 6, 5, 4});
        check_inside(cube, {{-1, 1, 5}, {zero, zero, -1}}, {4, 6, 5, 4});
        check_outside(cube, {{std::nextafter(1.0, 2.0), 0, 5}, {zero, zero, -1}});
    }
}

TEST_CASE("from inside the face ahead is hit", "[10.2]") {
    check_surface(cube, {{0.5, 0.25, 0}, {0, 0, -1}}, {0.5, 0.25, -1}, {0, 0, -1});
    check_surface(cube, {{0.5, 0.25, 0}, {0, 1, 0}}, {0.5, 1, 0}, {0, 1, 0});
}

TEST_CASE("each face has its own outward normal", "[10.2]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const Real side : {-1.0, 1.0}) {
            Vec3 normal(0);
            normal[axis] = side;
            const Vec3 from = 4.0 * normal + Vec3(0.25);
            check_surface(cube, {from, -normal}, from - (4 * side + 0.25 - side) * normal * side, normal);
        }
    // Of a box whose two faces across x lie to the same side of the origin.
    check_surface({{1, 1, 1}, {2, 2, 2}}, {{0, 1.5, 1.25}, {1, 0, 0}}, {1, 1.5, 1.25}, {-1, 0, 0});
}

TEST_CASE("the point of the surface is in its face to the bit, and not beyond the face's edges", "[10.2]") {
    Random random(10201);
    int hits = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 corner = random.magnitude(-3, 3) * random.in_cube();
        const Box box{corner, corner + random.magnitude(-3, 3) * (random.in_cube() + 1.1)};
        const Vec3 target = on_the_box(random, box);
        const Vec3 eye = target + length(box.high - box.low) * random.magnitude(-1, 3) * random.direction();
        const Ray ray{eye, random.magnitude(-2, 2) * (target - eye)};
        const std::optional<Hit> hit = intersect(box, ray, ahead);
        if (!hit) continue;
        ++hits;
        const Surface surface = surface_at(box, ray, *hit);
        INFO(describe(box, ray) << "\n" << hit << "\n" << surface);
        int faces = 0;
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(box.low[axis] <= surface.point[axis]);
            CHECK(surface.point[axis] <= box.high[axis]);
            if (surface.normal[axis] == 0) continue;
            ++faces;
            CHECK(surface.point[axis] == (surface.normal[axis] > 0 ? box.high[axis] : box.low[axis]));
        }
        CHECK(faces == 1);
        CHECK(length(surface.normal) == 1);
    }
    CHECK(hits > test::demanded(cases(20000) / 4, cases(20000) / 8));
}

TEST_CASE("boxes side by side leave no gap: together they are hit where the box around them is", "[10.2]") {
    Random random(10202);
    int hits = 0;
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 low = random.in_cube() - 2.5, middle = random.in_cube(), high = random.in_cube() + 2.5;
        const Box all{low, high}, part{middle, high};
        // At the corner that all eight have in common, or along its edges.
        const Vec3 target = on_the_box(random, part);
        const Vec3 eye = target + random.magnitude(-1, 3) * random.direction();
        const Ray ray{eye, target - eye};
        const std::optional<Span> whole = inside(all, ray);
        Real enter = infinity, leave = -infinity;
        for (int k = 0; k < 8; ++k) {
            Box one{low, middle};
            for (int axis = 0; axis < 3; ++axis)
                if (k >> axis & 1) one.low[axis] = middle[axis], one.high[axis] = high[axis];
            if (const std::optional<Span> span = inside(one, ray)) {
                enter = std::min(enter, span->enter);
                leave = std::max(leave, span->leave);
            }
        }
        INFO(describe(all, ray) << "\ncut in eight at " << middle << "; " << whole << "\nthe eight: from "
                                << enter << " to " << leave);
        REQUIRE(whole.has_value() == (enter <= leave));
        if (!whole) continue;
        ++hits;
        CHECK(enter == whole->enter);
        CHECK(leave == whole->leave);
    }
    CHECK(hits > test::demanded(cases(5000) / 4, cases(5000) / 8));
}

TEST_CASE("a scene in other units gives the same picture: t of a box does not change", "[10.2]") {
    Random random(10203);
    int hits = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const Box box{random.in_cube() - 1.0, random.in_cube() + 1.0};
        const Vec3 eye = 5.0 * random.direction();
        const Ray ray{eye, on_the_box(random, box) - eye};
        const Real s = std::ldexp(1, static_cast<int>(random.index(81)) - 40);
        const auto one = inside(box, ray);
        const auto scaled = inside(Box{s * box.low, s * box.high}, Ray{s * ray.origin, s * ray.direction});
        INFO(describe(box, ray) << "\nunit " << s << "\n" << one << "\n" << scaled);
        REQUIRE(one.has_value() == scaled.has_value());
        if (!one) continue;
        ++hits;
        CHECK(scaled->enter == one->enter);
        CHECK(scaled->leave == one->leave);
    }
    CHECK(hits > cases(2000) / 2);
}
