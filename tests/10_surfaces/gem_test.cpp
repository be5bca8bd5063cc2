// Step 10.16: solids with flat faces.
#include "chapters/10_surfaces/gem.hpp"

#include "chapters/10_surfaces/box.hpp"
#include "common/math/error.hpp"
#include "tests/10_surfaces/check_span.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

std::string in_words(const std::vector<Plane>& planes) {
    std::string list = "planes:";
    for (const Plane& plane : planes)
        list += "\n  through " + test::show(plane.point) + ", normal " + test::show(plane.normal);
    return list;
}

void check_gem(const std::vector<Plane>& planes, const Ray& ray, const Span& expected) {
    const std::optional<Span> actual = inside_gem(planes, ray);
    INFO(in_words(planes) << "\n" << ray);
    test::check_span(actual, expected, gamma(16) * 10, gamma(16) * 10);
}

void check_no_gem(const std::vector<Plane>& planes, const Ray& ray) {
    const std::optional<Span> actual = inside_gem(planes, ray);
    INFO(in_words(planes) << "\n" << ray);
    test::check_no_span(actual);
}

/// Behind x = 4, behind y = 3, and above the plane in which x + y = 1.
const std::vector<Plane> wedge{{{4, 0, 0}, {1, 0, 0}}, {{0, 3, 0}, {0, 1, 0}}, {{1, 0, 0}, {-1, -1, 0}}};

/// |x| + |y| + |z| ≤ 1.
std::vector<Plane> octahedron() {
    std::vector<Plane> planes;
    for (const Real x : {-1.0, 1.0})
        for (const Real y : {-1.0, 1.0})
            for (const Real z : {-1.0, 1.0}) planes.push_back({{x, 0, 0}, {x, y, z}});
    return planes;
}

}  // namespace

TEST_CASE("a wedge of three planes, by hand", "[10.16]") {
    // Along y = 1 it reaches from x = 0, on the slanting plane, to x = 4; along y = 2 from −1.
    check_gem(wedge, {{-10, 1, 0}, {1, 0, 0}}, {10, 14, 2, 0});
    check_gem(wedge, {{-10, 2, 0}, {2, 0, 0}}, {4.5, 7, 2, 0});
    check_gem(wedge, {{2, 10, 0}, {0, -1, 0}}, {7, 11, 1, 2});
}

TEST_CASE("lines beside the wedge are nowhere inside", "[10.16]") {
    check_no_gem(wedge, {{-10, 4, 0}, {1, 0, 0}});
    check_no_gem(wedge, {{5, -10, 0}, {0, 1, 0}});
    check_no_gem(wedge, {{0, 0, 0}, {1, -1, 0}});
}

TEST_CASE("a solid need not be finite", "[10.16]") {
    check_gem(wedge, {{2, 0, 0}, {0, 0, 1}}, {-infinity, infinity, 0, 0});
    check_gem({wedge[0]}, {{0, 0, 0}, {2, 0, 0}}, {-infinity, 2, 0, 0});
    check_gem({wedge[1], wedge[0]}, {{10, 0, 0}, {-1, 0, 0}}, {6, infinity, 1, 0});
    check_gem({}, {{1, 2, 3}, {1, 0, 0}}, {-infinity, infinity, 0, 0});
}

TEST_CASE("a line that runs in a plane is behind it", "[10.16]") {
    check_gem(wedge, {{-10, 3, 0}, {1, 0, 0}}, {8, 14, 2, 0});
    check_gem(wedge, {{4, 10, 0}, {0, -1, 0}}, {7, 13, 1, 2});
}

TEST_CASE("an octahedron of eight planes, from face to face", "[10.16]") {
    // At y = 1/4 and z = 1/8 it reaches from x = −5/8 to 5/8: in by the face (−, +, +), out by (+, +, +).
    check_gem(octahedron(), {{-2, 0.25, 0.125}, {1, 0, 0}}, {1.375, 2.625, 3, 7});
    check_gem(octahedron(), {{0.25, 2, -0.125}, {0, -1, 0}}, {1.375, 2.625, 6, 4});
    check_no_gem(octahedron(), {{-2, 0.75, 0.5}, {1, 0, 0}});
}

TEST_CASE("six planes are a box", "[10.16]") {
    const Box box{{-1, -2, -3}, {3, 2, 1}};
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal(0);
        normal[axis] = -1;
        planes.push_back({box.low, normal});
        planes.push_back({box.high, -normal});
    }
    Random random(11600);
    int met = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 origin = 8.0 * random.direction();
        const Ray ray{origin, 2.0 * random.in_cube() - origin};
        const std::optional<Span> expected = inside(box, ray), actual = inside_gem(planes, ray);
        INFO("box from " << box.low << " to " << box.high << "\n" << ray);
        INFO("expected " << expected << "\nactual   " << actual);
        // Not those that only just pass an edge.
        const Box larger{box.low - Vec3(1e-9), box.high + Vec3(1e-9)};
        if (!inside(larger, ray)) CHECK(!actual);
        if (!expected || expected->leave - expected->enter < 1e-9) continue;
        REQUIRE(actual.has_value());
        CHECK(test::near(actual->enter, expected->enter, 1e-12));
        CHECK(test::near(actual->leave, expected->leave, 1e-12));
        CHECK(actual->enter_face == expected->enter_face);
        CHECK(actual->leave_face == expected->leave_face);
        ++met;
    }
    CHECK(met > cases(2000) / 4);
}
