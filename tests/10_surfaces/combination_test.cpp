// Step 10.15: solids made of solids, one line at a time.
#include "chapters/10_surfaces/combination.hpp"
#include "common/math/error.hpp"
#include "common/render/combinations.hpp"
#include "common/render/compile.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace rt;
using test::cases;
using test::Random;

namespace {

constexpr SetOperation all_operations[] = {SetOperation::Union, SetOperation::Intersection,
                                           SetOperation::Difference};

/// Crossings at these t. Those of the first solid are elements 10, 11, ..., of the second 20, 21, ...
std::vector<Hit> at(std::initializer_list<Real> places, std::uint32_t element) {
    std::vector<Hit> hits;
    for (const Real t : places) hits.push_back({.t = t, .element = element++});
    return hits;
}
std::vector<Hit> a_at(std::initializer_list<Real> places) { return at(places, 10); }
std::vector<Hit> b_at(std::initializer_list<Real> places) { return at(places, 20); }

struct Expected {
    Real t;
    std::uint32_t element;
};

std::string list(const std::vector<Hit>& hits) {
    std::string text;
    for (const Hit& hit : hits) text += " t = " + test::show(hit.t) + " (" + test::show(hit.element) + ")";
    return text.empty() ? " none" : text;
}

void check_combined(SetOperation operation, const std::vector<Hit>& a, const std::vector<Hit>& b,
                    const std::vector<Expected>& expected) {
    std::vector<Hit> wanted;
    for (const auto& [t, element] : expected) wanted.push_back({.t = t, .element = element});
    const std::vector<Hit> actual = combine(operation, a, b);
    INFO(test::show(operation) << " of the crossings, each t with its element in brackets");
    INFO("a       " << list(a) << "\nand b   " << list(b));
    INFO("expected" << list(wanted) << "\nactual  " << list(actual));
    REQUIRE(actual.size() == wanted.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
        CHECK(actual[i].t == wanted[i].t);
        CHECK(actual[i].element == wanted[i].element);
    }
}

/// Checks a point in both solids, in the first, in the second, and in neither.
void check_point(SetOperation operation, bool both, bool only_a, bool only_b, bool neither) {
    const bool expected[] = {both, only_a, only_b, neither};
    for (int i = 0; i < 4; ++i) {
        const bool in_a = i < 2, in_b = i % 2 == 0, actual = is_inside(operation, in_a, in_b);
        INFO(test::show(operation) << ": the point is " << (in_a ? "inside" : "outside") << " of a and "
                                   << (in_b ? "inside" : "outside") << " of b, and so it is "
                                   << (expected[i] ? "inside" : "outside") << " of both as one");
        CHECK(test::or_say(actual == expected[i], actual ? "inside" : "outside"));
    }
}

}  // namespace

// ------------------------------------------------------------------------------------------- one point

TEST_CASE("a point is inside a union if it is inside either solid", "[10.15]") {
    check_point(SetOperation::Union, true, true, true, false);
}

TEST_CASE("a point is inside an intersection if it is inside both solids", "[10.15]") {
    check_point(SetOperation::Intersection, true, false, false, false);
}

TEST_CASE("a point is inside a difference if it is inside the first solid but not the second", "[10.15]") {
    check_point(SetOperation::Difference, false, true, false, false);
}

// -------------------------------------------------------------------------------------------- one line

TEST_CASE("the worked example: two pieces that overlap, from 1 to 4 and from 2 to 6", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 4}), b_at({2, 6}), {{1, 10}, {6, 21}});
    check_combined(SetOperation::Intersection, a_at({1, 4}), b_at({2, 6}), {{2, 20}, {4, 11}});
    check_combined(SetOperation::Difference, a_at({1, 4}), b_at({2, 6}), {{1, 10}, {2, 20}});
    check_combined(SetOperation::Difference, a_at({2, 6}), b_at({1, 4}), {{4, 21}, {6, 11}});
}

TEST_CASE("a piece inside another: a tunnel is two pieces", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 8}), b_at({3, 5}), {{1, 10}, {8, 11}});
    check_combined(SetOperation::Intersection, a_at({1, 8}), b_at({3, 5}), {{3, 20}, {5, 21}});
    check_combined(SetOperation::Difference, a_at({1, 8}), b_at({3, 5}),
                   {{1, 10}, {3, 20}, {5, 21}, {8, 11}});
    check_combined(SetOperation::Difference, a_at({3, 5}), b_at({1, 8}), {});
}

TEST_CASE("pieces that are apart", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 2}), b_at({4, 5}), {{1, 10}, {2, 11}, {4, 20}, {5, 21}});
    check_combined(SetOperation::Union, a_at({4, 5}), b_at({1, 2}), {{1, 20}, {2, 21}, {4, 10}, {5, 11}});
    check_combined(SetOperation::Intersection, a_at({1, 2}), b_at({4, 5}), {});
    check_combined(SetOperation::Difference, a_at({1, 2}), b_at({4, 5}), {{1, 10}, {2, 11}});
}

TEST_CASE("with nothing a solid is itself, or nothing", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 2}), {}, {{1, 10}, {2, 11}});
    check_combined(SetOperation::Union, {}, b_at({1, 2}), {{1, 20}, {2, 21}});
    check_combined(SetOperation::Intersection, a_at({1, 2}), {}, {});
    check_combined(SetOperation::Intersection, {}, b_at({1, 2}), {});
    check_combined(SetOperation::Difference, a_at({1, 2}), {}, {{1, 10}, {2, 11}});
    check_combined(SetOperation::Difference, {}, b_at({1, 2}), {});
}

TEST_CASE("solids of several pieces", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 3, 5, 7}), b_at({2, 6}), {{1, 10}, {7, 13}});
    check_combined(SetOperation::Intersection, a_at({1, 3, 5, 7}), b_at({2, 6}),
                   {{2, 20}, {3, 11}, {5, 12}, {6, 21}});
    check_combined(SetOperation::Difference, a_at({1, 9}), b_at({2, 3, 5, 6}),
                   {{1, 10}, {2, 20}, {3, 21}, {5, 22}, {6, 23}, {9, 11}});
}

TEST_CASE("half of the line, as behind a plane", "[10.15]") {
    check_combined(SetOperation::Intersection, a_at({-infinity, 3}), b_at({1, 5}), {{1, 20}, {3, 11}});
    check_combined(SetOperation::Difference, a_at({1, 5}), b_at({3, infinity}), {{1, 10}, {3, 20}});
    check_combined(SetOperation::Union, a_at({-infinity, 3}), b_at({2, infinity}),
                   {{-infinity, 10}, {infinity, 21}});
}

// --------------------------------------------------------------------------------- faces in one place

TEST_CASE("solids that share a face are one, without a wall between", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 3}), b_at({3, 5}), {{1, 10}, {5, 21}});
    check_combined(SetOperation::Union, a_at({3, 5}), b_at({1, 3}), {{1, 20}, {5, 11}});
}

TEST_CASE("solids that only touch have nothing in common", "[10.15]") {
    check_combined(SetOperation::Intersection, a_at({1, 3}), b_at({3, 5}), {});
    check_combined(SetOperation::Intersection, a_at({3, 5}), b_at({1, 3}), {});
    check_combined(SetOperation::Difference, a_at({1, 3}), b_at({3, 5}), {{1, 10}, {3, 11}});
}

TEST_CASE("of two faces in one place the first solid's is met", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 3}), b_at({1, 5}), {{1, 10}, {5, 21}});
    check_combined(SetOperation::Intersection, a_at({1, 3}), b_at({1, 5}), {{1, 10}, {3, 11}});
    check_combined(SetOperation::Intersection, a_at({1, 5}), b_at({2, 5}), {{2, 20}, {5, 11}});
}

TEST_CASE("what a cut leaves begins and ends where the cut does, without a skin", "[10.15]") {
    check_combined(SetOperation::Difference, a_at({1, 5}), b_at({1, 3}), {{3, 21}, {5, 11}});
    check_combined(SetOperation::Difference, a_at({1, 5}), b_at({3, 5}), {{1, 10}, {3, 20}});
    check_combined(SetOperation::Difference, a_at({1, 5}), b_at({1, 5}), {});
}

TEST_CASE("a solid that the line only touches adds nothing and takes nothing away", "[10.15]") {
    check_combined(SetOperation::Union, a_at({1, 5}), b_at({7, 7}), {{1, 10}, {5, 11}});
    check_combined(SetOperation::Intersection, a_at({1, 5}), b_at({3, 3}), {});
    check_combined(SetOperation::Difference, a_at({1, 5}), b_at({3, 3}), {{1, 10}, {5, 11}});
    check_combined(SetOperation::Difference, a_at({1, 5}), b_at({1, 1}), {{1, 10}, {5, 11}});
}

TEST_CASE("the face is that of the solid which is entered, not of one that is touched there", "[10.15]") {
    check_combined(SetOperation::Union, a_at({2, 2}), b_at({2, 5}), {{2, 20}, {5, 21}});
}

// ---------------------------------------------------------------------------------- against its meaning

TEST_CASE("in the middle of every piece the line is inside, and between them outside", "[10.15]") {
    Random random(1011);
    for (int i = 0; i < cases(2000); ++i) {
        // Whole numbers, so that many are equal.
        const auto some = [&](std::uint32_t element) {
            std::vector<Real> places(2 * random.index(4));
            for (Real& t : places) t = static_cast<Real>(random.index(9));
            std::sort(places.begin(), places.end());
            std::vector<Hit> hits;
            for (const Real t : places) hits.push_back({.t = t, .element = element++});
            return hits;
        };
        const std::vector<Hit> a = some(10), b = some(20);
        const auto in = [](const std::vector<Hit>& hits, Real t) {
            return std::count_if(hits.begin(), hits.end(), [&](const Hit& hit) { return hit.t < t; }) % 2 ==
                   1;
        };
        for (const SetOperation operation : all_operations) {
            const std::vector<Hit> actual = combine(operation, a, b);
            INFO(test::show(operation)
                 << " of" << list(a) << " and" << list(b) << "\nactual" << list(actual));
            for (Real t = -0.5; t < 10; t += 1) {
                const bool in_a = in(a, t), in_b = in(b, t);
                const bool expected = operation == SetOperation::Union          ? in_a || in_b
                                      : operation == SetOperation::Intersection ? in_a && in_b
                                                                                : in_a && !in_b;
                INFO("at t = " << t);
                CHECK(in(actual, t) == expected);
            }
            for (std::size_t k = 0; k + 1 < actual.size(); ++k) {
                INFO("hits " << k << " and " << k + 1);
                CHECK(actual[k].t < actual[k + 1].t);
            }
        }
    }
}

// ------------------------------------------------------------------------------- solids, as in a scene

namespace {

World world_of(const std::string& solids, const std::filesystem::path& directory = ".") {
    return compile(parse_scene_text("camera 0 0 9 0 0 0 0 1 0 40\n" + solids, "test.scene", directory, {}));
}

/// Checks where the ray crosses the world's only object.
void check_crossings(const World& world, const std::string& solids, const Ray& ray,
                     const std::vector<Real>& expected) {
    std::vector<Real> actual;
    Interval range{-1e30, infinity};
    while (const std::optional<Hit> hit = closest_hit(world, ray, range)) {
        actual.push_back(hit->t);
        range.min = hit->t;
    }
    INFO(solids << test::show(ray));
    INFO("expected t " << test::show(expected) << "\nactual   t " << test::show(actual));
    REQUIRE(actual.size() == expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
        CHECK(test::near(actual[i], expected[i], gamma(16) * std::max(Real(1), std::abs(expected[i]))));
}
void check_crossings(const std::string& solids, const Ray& ray, const std::vector<Real>& expected) {
    check_crossings(world_of(solids), solids, ray, expected);
}

/// The surface at the first of them, which is at t.
Surface first_surface(const std::string& solids, const Ray& ray, Real t) {
    const World world = world_of(solids);
    const std::optional<Hit> hit = closest_hit(world, ray, {});
    INFO(solids << test::show(ray) << "\nexpected a hit at t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, gamma(16) * std::max(Real(1), std::abs(t))));
    return surface_at(world, ray, *hit);
}

std::string error_of(const std::string& solids) {
    return test::error_of([&] { world_of(solids); });
}

}  // namespace

TEST_CASE("a ball with a hole along x is crossed beside the hole, and not in it", "[10.15]") {
    const std::string bead = "difference\nsphere 0 0 0 2\ncylinder -3 0 0 3 0 0 1\nend\n";
    check_crossings(bead, {{-10, 0.5, 0}, {1, 0, 0}}, {});
    check_crossings(bead, {{0, 10, 0}, {0, -1, 0}}, {8, 9, 11, 12});
}

TEST_CASE("the wall of a hole looks into the hole", "[10.15]") {
    const Surface surface = first_surface("difference\nsphere 0 0 0 2\ncylinder -3 0 0 3 0 0 1\nend\n",
                                          {{0, 0, 0}, {0, -1, 0}}, 1);
    INFO("expected normal (0, 1, 0), actual " << surface.normal);
    CHECK(test::near(surface.normal, Vec3(0, 1, 0), gamma(16)));
    CHECK(test::near(surface.shading_normal, Vec3(0, 1, 0), gamma(16)));
}

TEST_CASE("what is taken from what is taken away stays, and looks outwards", "[10.15]") {
    // A cube with a hole in which a ball is left.
    const std::string nest =
        "difference\nbox -3 -3 -3 3 3 3\ndifference\ncylinder -4 0 0 4 0 0 2\nsphere 0 0 0 1\nend\nend\n";
    check_crossings(nest, {{0, 10, 0}, {0, -1, 0}}, {7, 8, 9, 11, 12, 13});
    const Surface ball = first_surface(nest, {{-10, 0, 0}, {1, 0, 0}}, 9);
    INFO("expected normal (-1, 0, 0), actual " << ball.normal);
    CHECK(test::near(ball.normal, Vec3(-1, 0, 0), gamma(16)));
}

TEST_CASE("a lens is what two balls have in common", "[10.15]") {
    check_crossings("intersection\nsphere -1 0 0 2\nsphere 1 0 0 2\nend\n", {{-10, 0, 0}, {1, 0, 0}},
                    {9, 11});
}

TEST_CASE("half a ball ends at the plane", "[10.15]") {
    check_crossings("intersection\nsphere 0 0 0 2\nplane 0 0 0 1 0 0\nend\n", {{-10, 0, 0}, {1, 0, 0}},
                    {8, 10});
    check_crossings("intersection\nsphere 0 0 0 2\nplane 0 0 0 1 0 0\nend\n", {{1, -10, 0}, {0, 1, 0}}, {});
    check_crossings("intersection\nsphere 0 0 0 2\nplane 0 0 0 1 0 0\nend\n", {{-1, 0, 10}, {0, 0, -1}},
                    {10 - std::sqrt(3.0), 10 + std::sqrt(3.0)});
}

TEST_CASE("boxes side by side are one, from whichever side they are looked at", "[10.15]") {
    const std::string row = "union\nbox 0 0 0 0.1 1 1\nbox 0.1 0 0 0.7 1 1\nbox 0.7 0 0 1 1 1\nend\n";
    Random random(101102);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 from(-random.uniform(1, 20), random.uniform(0.2, 0.8), random.uniform(0.2, 0.8));
        const Vec3 to(1 + random.uniform(1, 20), random.uniform(0.2, 0.8), random.uniform(0.2, 0.8));
        const Ray ray{from, to - from};
        check_crossings(row, ray, {-from.x / ray.direction.x, (1 - from.x) / ray.direction.x});
    }
}

TEST_CASE("a hole whose end is in a face leaves no skin, whatever has been moved to be there", "[10.15]") {
    // Numbers that are sums of powers of two, so that the faces are in one plane to the bit.
    const std::string pots[] = {
        "difference\nbox -2 0 -2 2 0.5 2\ncylinder 0 0.125 0 0 0.5 0 1\nend\n",
        "difference\ntranslate 0 -0.75 0\nbox -2 0.75 -2 2 1.25 2\ntranslate 0 0.75 0\n"
        "cylinder 0 0.125 0 0 0.5 0 1\nend\n",
        "difference\nbox -2 0 -2 2 0.5 2\nscale 2 0.25 2\ncylinder 0 0.5 0 0 2 0 0.5\nend\n",
        "difference\nbox -2 0 -2 2 0.5 2\nrotate 1 0 0 0\ncylinder 0 0.5 0 0 0.125 0 1\nend\n",
    };
    Random random(101103);
    for (const std::string& pot : pots)
        for (int i = 0; i < cases(500); ++i) {
            // From above, through the hole's open end to its bottom at 0.125, and out at 0.
            const Vec3 from(random.uniform(-0.1, 0.1), random.uniform(1, 20), random.uniform(-0.1, 0.1));
            const Vec3 to(random.uniform(-0.1, 0.1), -random.uniform(1, 20), random.uniform(-0.1, 0.1));
            const Ray ray{from, to - from};
            check_crossings(pot, ray, {(0.125 - from.y) / ray.direction.y, -from.y / ray.direction.y});
        }
}

TEST_CASE("faces are in one plane also where rounding has put them side by side", "[10.15]") {
    // 0.1 + 0.2 is not 0.3.
    const std::string pot =
        "difference\nbox -2 0 -2 2 0.3 2\ntranslate 0 0.1 0\ncylinder 0 0.025 0 0 0.2 0 1\nend\n";
    const std::string slab =
        "difference\nbox -1 -0.9 -1 1 1.1 1\ntranslate 0 0.1 0\n"
        "quadric 1 0 1 0 0 0 0 0 0 -0.25 -1 -1 -1 1 1 1\nend\n";  // the hole is a tube of radius 1/2
    Random random(101104);
    for (int i = 0; i < cases(500); ++i) {
        const Vec3 from(random.uniform(-0.1, 0.1), random.uniform(2, 20), random.uniform(-0.1, 0.1));
        const Vec3 to(random.uniform(-0.1, 0.1), -random.uniform(2, 20), random.uniform(-0.1, 0.1));
        const Ray ray{from, to - from};
        check_crossings(pot, ray, {(0.125 - from.y) / ray.direction.y, -from.y / ray.direction.y});
        check_crossings(slab, ray, {});
    }
}

TEST_CASE("a plane in the plane of a face", "[10.15]") {
    const std::string cut = "intersection\nbox -1 -1 -1 1 1 1\nplane 1 0 0 1 0 0\nend\n";
    check_crossings(cut, {{-10, 0.5, 0.25}, {1, 0, 0}}, {9, 11});
    check_crossings(cut, {{10, 0.5, 0.25}, {-1, 0, 0}}, {9, 11});
    check_crossings(cut, {{0.5, -10, 0.25}, {0, 1, 0}}, {9, 11});
    check_crossings(cut, {{-10, -9.5, 0.25}, {1, 1, 0}}, {9, 10.5});
    // What is behind the plane, without the box that ends in it, is beside the box only.
    const std::string rest =
        "difference\nintersection\nbox -2 -2 -2 2 2 2\nplane 1 0 0 1 0 0\nend\nbox -1 -1 -1 1 1 1\nend\n";
    check_crossings(rest, {{-10, 0.5, 0.25}, {1, 0, 0}}, {8, 9});
    check_crossings(rest, {{0.5, -10, 0.25}, {0, 1, 0}}, {8, 9, 11, 12});
}

TEST_CASE("a line that touches an edge of a mesh from inside goes on inside", "[10.15]") {
    // A beam of the section of an L; the two faces at its inner edge come first.
    const std::filesystem::path directory = test::scratch_directory();
    std::ofstream(directory / "beam.obj")
        << "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
           "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
           "f 3 4 10\nf 3 10 9\nf 4 5 11\nf 4 11 10\nf 1 2 8\nf 1 8 7\nf 2 3 9\nf 2 9 8\n"
           "f 5 6 12\nf 5 12 11\nf 6 1 7\nf 6 7 12\n"
           "f 7 8 9\nf 7 9 10\nf 7 10 11\nf 7 11 12\nf 1 3 2\nf 1 4 3\nf 1 5 4\nf 1 6 5\n";
    const std::string solids = "difference\nmesh beam.obj\nsphere 9 9 9 1\nend\n";
    const World world = world_of(solids, directory);
    check_crossings(world, solids, {{-1, 2, 0.25}, {2, -1, 0}}, {0.5, 1.5});  // touches (1, 1) at t = 1
    check_crossings(world, solids, {{3, 0, 0.25}, {-2, 1, 0}}, {0.5, 1.5});   // the other way
    check_crossings(world, solids, {{-1, 3, 0.25}, {1, -1, 0}}, {1, 3});      // from corner to corner
    check_crossings(world, solids, {{-1, 1.5, 0.25}, {1, 0, 0}}, {1, 2});     // not near the edge
}

TEST_CASE("what is no solid, or endless, is refused", "[10.15]") {
    CHECK(error_of("intersection\nsphere 0 0 0 1\nsphere 9 0 0 1\nend\n") ==
          "test.scene:2:1: nothing is left of this solid: what is intersected here has nothing in common");
    CHECK(error_of("union\nsphere 0 0 0 1\nplane 0 0 0 0 1 0\nend\n") ==
          "test.scene:2:1: a solid without an end: what is made of planes must be intersected with something "
          "else");
}

TEST_CASE("a mesh is a solid like others, also for lines through its edges and corners", "[10.15]") {
    // An octahedron, of which a ball leaves the outer parts.
    const std::filesystem::path directory = test::scratch_directory();
    std::ofstream(directory / "gem.obj")
        << "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
           "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    const std::string solids = "difference\nmesh gem.obj\nsphere 0 0 0 0.5\nend\n";
    const World world = world_of(solids, directory);
    check_crossings(world, solids, {{-5, 0, 0}, {1, 0, 0}}, {4, 4.5, 5.5, 6});  // corner to corner
    check_crossings(world, solids, {{-5, 0, 0.875}, {1, 0, 0}},
                    {4.875, 5.125});  // edge to edge, past the ball
    check_crossings(world, solids, {{-5, -5, 0}, {1, 1, 0}},
                    {4.5, 5 - std::sqrt(0.125), 5 + std::sqrt(0.125), 5.5});
    check_crossings(world, solids, {{-5, 1, 0}, {1, 0, 0}}, {});  // touches a corner
}

TEST_CASE("solids nested deeply", "[10.15]") {
    std::string shells = "sphere 0 0 0 1\n";
    for (int i = 2; i <= 40; ++i)
        shells = "difference\nsphere 0 0 0 " + std::to_string(i) + "\n" + shells + "end\n";
    // Every second shell is there: from 40 to 39, from 38 to 37, ..., from 2 to 1.
    std::vector<Real> expected;
    for (int i = 40; i >= 1; --i) expected.push_back(100 - i);
    for (int i = 1; i <= 40; ++i) expected.push_back(100 + i);
    check_crossings(shells, {{-100, 0, 0}, {1, 0, 0}}, expected);
}
