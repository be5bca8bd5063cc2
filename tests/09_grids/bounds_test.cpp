// Boxes around shapes, and the part of a ray inside a box.
#include "chapters/09_grids/bounds.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "tests/09_grids/show.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using rt::test::cases;
using rt::test::demanded;
using rt::test::Random;
using rt::test::show;

namespace {

const Bounds unit_box{Vec3(0), Vec3(1)};

bool contains_point(const Bounds& box, const Vec3& p) {
    return glm::all(glm::lessThanEqual(box.low, p)) && glm::all(glm::lessThanEqual(p, box.high));
}

/// The box moved out by a few roundings of numbers as large as those in it.
Bounds grown_by_rounding(const Bounds& box) {
    const Vec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
    return grown(box, gamma(8) * max_component(size));
}

template <class Shape>
void check_bounds(const std::string& words, const Shape& shape, const Bounds& expected) {
    INFO("the box around a " << words);
    const Bounds box = bounds_of(shape);
    CHECK(test::or_say(box == expected, show(box) + ", expected " + show(expected)));
}

/// Whether the point is in the box; `which` names it.
test::Told in_box(const Bounds& box, const Vec3& p, const char* which) {
    return test::or_say(contains_point(box, p),
                        std::string(which) + " " + show(p) + " is outside of the " + show(box));
}

/// A part of a ray, which may be a point.
std::string part_in_words(const std::optional<Interval>& part) {
    return part && part->min == part->max ? "the point at t = " + show(part->min) : show(part);
}

constexpr const char* closed = ": a box is closed, its surface belongs to it";

/// The part of a ray that is in a box; `because` says what to think of where it is taken for nothing.
void check_part(const Bounds& box, const Ray& ray, const std::optional<Interval>& expected,
                Interval range = {}, const std::string& because = "") {
    INFO("the part of the " << ray << " in " << range << " that is in the " << box);
    const std::optional<Interval> actual = clip(box, ray, range);
    const std::string wrong = part_in_words(actual) + ", expected " + part_in_words(expected);
    if (!expected) {
        CHECK(test::or_say(!actual, wrong));
        return;
    }
    REQUIRE(test::or_say(actual.has_value(), wrong + because));
    {
        INFO("where it begins");
        CHECK(test::near(actual->min, expected->min, gamma(4) * std::abs(expected->min)));
    }
    INFO("where it ends");
    CHECK(test::near(actual->max, expected->max, gamma(4) * std::abs(expected->max)));
}

/// Some part of the ray is in the box, however short.
void check_met(const Bounds& box, const Ray& ray) {
    INFO("the part of the " << ray << " that is in the " << box);
    CHECK(test::or_say(clip(box, ray, {}).has_value(),
                       std::string("nothing, expected a part, if only a point") + closed));
}

Ellipsoid ellipsoid_under(const Mat4& m) {
    const std::optional<Mat4> back = inverse(m);
    REQUIRE(back);
    return {{m, *back}};
}

Mat4 some_map(Random& random) {
    return translation(random.in_cube()) * rotation(random.direction(), random.uniform(0, 6)) *
           scaling(Vec3(random.magnitude(-2, 1), random.magnitude(-2, 1), random.magnitude(-2, 1))) *
           rotation(random.direction(), random.uniform(0, 6));
}

}  // namespace

TEST_CASE("the box around an instance reaches as far as the ball around its mesh, stretched with it",
          "[09.1]") {
    SharedMesh mesh;
    mesh.bound = {{1, 0, 0}, 2};
    Mat4 there(1);
    there[0][0] = 3, there[3][1] = 5;
    const std::optional<Mat4> back = inverse(there);
    REQUIRE(back);
    check_bounds("mesh in a ball of radius 2 around (1, 0, 0), three times as wide along x and moved up by 5",
                 Instance{{there, *back}, {std::make_shared<const SharedMesh>(mesh)}},
                 {{-3, 3, -2}, {9, 7, 2}});
}

TEST_CASE("the box of a sphere touches it at the ends of the axes", "[09.1]") {
    check_bounds(show(Sphere{{1, 2, 3}, 2}), Sphere{{1, 2, 3}, 2}, {{-1, 0, 1}, {3, 4, 5}});
    check_bounds(show(Sphere{{0, 0, 0}, 0.5}), Sphere{{0, 0, 0}, 0.5}, {Vec3(-0.5), Vec3(0.5)});
}

TEST_CASE("the box of a triangle ends at its corners", "[09.1]") {
    // Each corner is the first, the second and the third once.
    const auto check = [](const Vec3& p, const Vec3& q, const Vec3& r, const Bounds& box) {
        for (const Triangle& t : {Triangle{p, q, r}, Triangle{q, r, p}, Triangle{r, p, q}})
            check_bounds(show(t), t, box);
    };
    check({1, 5, -2}, {0, 7, 3}, {4, 6, 0}, {{0, 5, -2}, {4, 7, 3}});
    check({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, {{0, 1, 0}, {1, 1, 1}});
}

TEST_CASE("the box of an ellipsoid reaches along each axis as far as the matrix's row is long", "[09.1]") {
    Mat4 m(1);
    // The rows are (3, 4, 12), (0, 5, 0) and (0, 0, 2), of lengths 13, 5 and 2. A column at a time:
    m[0] = Vec4(3, 0, 0, 0);
    m[1] = Vec4(4, 5, 0, 0);
    m[2] = Vec4(12, 0, 2, 0);
    m[3] = Vec4(100, 200, 300, 1);
    check_bounds("unit sphere under the matrix" + show(m), ellipsoid_under(m),
                 {{87, 195, 298}, {113, 205, 302}});
}

TEST_CASE("every point of a shape is in its box, and each face of the box is touched", "[09.1]") {
    Random random(91);
    for (int k = 0; k < cases(5000); ++k) {
        const Sphere sphere{10.0 * random.in_cube(), random.magnitude(-2, 2)};
        const Triangle t{random.in_cube(), random.in_cube(), random.in_cube()};
        const Ellipsoid ellipsoid = ellipsoid_under(some_map(random));
        const Mat4& m = ellipsoid.transform.to_world;

        const Vec3 n = random.direction();
        const Real b = random.uniform(0, 1), c = random.uniform(0, 1 - b);
        const Vec3 on_triangle = (1 - b - c) * t.a + b * t.b + c * t.c;
        const Bounds box = bounds_of(ellipsoid);
        {
            INFO("the boxes around a " << sphere << ", around a " << t
                                       << ", and around the unit sphere under the matrix" << m);
            CHECK(in_box(grown_by_rounding(bounds_of(sphere)), sphere.center + sphere.radius * n,
                         "the sphere's point"));
            CHECK(in_box(grown_by_rounding(bounds_of(t)), on_triangle, "the triangle's point"));
            CHECK(in_box(grown_by_rounding(box), transform_point(m, n), "the ellipsoid's point"));
        }
        for (int a = 0; a < 3; ++a) {
            // The unit vector along row a goes to the farthest point along axis a.
            const Vec3 row(m[0][a], m[1][a], m[2][a]);
            const Real farthest = transform_point(m, normalize(row))[a];
            INFO("the " << box << " of an ellipsoid: how far it reaches along axis " << a
                        << ", then twice its middle there, which is the ellipsoid's");
            CHECK(test::near(box.high[a], farthest, gamma(20) * (length(row) + std::abs(m[3][a]))));
            CHECK(test::near(box.high[a] + box.low[a], 2 * m[3][a],
                             gamma(8) * (length(row) + std::abs(m[3][a]))));
        }
    }
}

TEST_CASE("a polygon's box holds the places where rays hit it, flat or not", "[given]") {
    Random random(92);
    int hits = 0;
    for (int k = 0; k < cases(5000); ++k) {
        Polygon polygon{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
        // Not flat: the last corner is above the plane of the others.
        polygon.vertices[3].z = random.index(2) == 0 ? 0 : random.uniform(0, 0.2);
        const Ray ray{Vec3(0.5, 0.5, 1) + 0.4 * random.in_cube(), -random.direction()};
        const std::optional<Hit> hit = intersect(polygon, ray, {});
        if (!hit) continue;
        ++hits;
        INFO("a square whose last corner is at z = " << polygon.vertices[3].z);
        CHECK(in_box(grown(bounds_of(polygon), 1e-12), point_at(ray, hit->t), "the hit at"));
    }
    CHECK(hits > demanded(cases(5000) / 20, cases(5000) / 50));
}

TEST_CASE("an instance's box holds its triangles", "[09.1]") {
    Random random(93);
    for (int k = 0; k < cases(1000); ++k) {
        SharedMesh mesh;
        mesh.bound = {random.in_cube(), random.uniform(0.1, 1)};
        const Ellipsoid map = ellipsoid_under(some_map(random));
        const Bounds box = bounds_of(Instance{map.transform, {std::make_shared<const SharedMesh>(mesh)}});
        const Vec3 corner = mesh.bound.center + mesh.bound.radius * random.direction();
        CHECK(in_box(grown_by_rounding(box), transform_point(map.transform.to_world, corner),
                     "a point of the mesh"));
    }
}

TEST_CASE("by hand: a ray through two slabs is in both from 2 to 4.8", "[09.2]") {
    check_part({{2.4, 1.2, -1}, {5.2, 2.9, 1}}, {{0.4, 0.45, 0}, {1, 0.5, 0}}, Interval{2, 4.8});
}

TEST_CASE("the part of a ray in a box, by hand", "[09.2]") {
    check_part(unit_box, {{-1, 0.5, 0.5}, {1, 0, 0}}, Interval{1, 2});
    check_part(unit_box, {{2, 0.5, 0.5}, {-1, 0, 0}}, Interval{1, 2});
    check_part(unit_box, {{-1, 0.5, 0.5}, {0.5, 0, 0}}, Interval{2, 4});
    check_part(unit_box, {{0.5, 0.5, 0.5}, {0, 1, 0}}, Interval{0, 0.5});
    check_part(unit_box, {{-1, -1, -1}, {1, 1, 1}}, Interval{1, 2});
    check_part(unit_box, {{-1, 0.5, 0.5}, {1, 0, 0}}, Interval{1.25, 1.5}, {1.25, 1.5});
    check_part(unit_box, {{-1, 0.5, 0.5}, {1, 0, 0}}, Interval{1, 2}, {-infinity, infinity});
    // Beside, behind, and before the box.
    check_part(unit_box, {{-1, 1.5, 0.5}, {1, 0, 0}}, std::nullopt);
    check_part(unit_box, {{2, 0.5, 0.5}, {1, 0, 0}}, std::nullopt);
    check_part(unit_box, {{-1, 0.5, 0.5}, {1, 0, 0}}, std::nullopt, {0, 0.5});
    check_part(unit_box, {{-1, 0.5, 0.5}, {1, 1, 0}}, std::nullopt);
}

TEST_CASE("a ray in a face, along an edge, or through a corner is in the box there", "[09.2]") {
    for (const Real zero : {0.0, -0.0}) {
        for (const Real y : {0.0, 1.0}) {
            // In a face, and along an edge.
            check_part(unit_box, {{-1, y, 0.5}, {1, zero, zero}}, Interval{1, 2}, {}, closed);
            check_part(unit_box, {{2, y, 1}, {-1, zero, zero}}, Interval{1, 2}, {}, closed);
        }
        check_met(unit_box, {{0.5, 0.5, 0.5}, {zero, zero, -1}});
    }
    // Through the corner (1, 1, 0) and through nothing else.
    check_part(unit_box, {{0, 2, 0}, {1, -1, 0}}, Interval{1, 1}, {}, closed);
}

TEST_CASE("rounding makes no ray miss an edge that it passes through", "[09.2]") {
    // At t = 0.4 the ray is at the edge x = 0.3, y = 0.2. There it leaves the slab of x and enters that of y,
    // and (0.3 + 0.9)/3 is rounded to less than (0.2 + 0.6)/2.
    const Bounds box{{-0.3, 0.2, 0}, {0.3, 1, 1}};
    const Ray ray{{-0.9, -0.6, 0.5}, {3, 2, 0}};
    INFO(box << ", " << ray << " through its edge x = 0.3, y = 0.2");
    const std::optional<Interval> part = clip(box, ray, {});
    REQUIRE(
        test::or_say(part.has_value(), "a miss, expected a hit at t = 0.4: rounding must be allowed for"));
    INFO("where it enters and leaves, both at t = 0.4");
    CHECK(test::near(part->min, 0.4, 16 * unit_roundoff));
    CHECK(test::near(part->max, 0.4, 16 * unit_roundoff));
}

TEST_CASE("a box without thickness is met, an empty box is not", "[09.2]") {
    const Bounds sheet{{0, 0, 0}, {1, 0, 1}};
    check_met(sheet, {{0.5, 1, 0.5}, {0, -1, 0}});
    check_met(sheet, {{0.5, 1, 0.5}, {0.1, -1, 0.2}});
    check_met(sheet, {{-1, 0, 0.5}, {1, 0, 0}});
    check_met(sheet, {{-1, 0, 0.5}, {1, -0.0, 0}});
    check_part(sheet, {{-1, 0.1, 0.5}, {1, 0, 0}}, std::nullopt);

    const Bounds point{Vec3(0.1), Vec3(0.1)};
    check_met(point, {Vec3(0), Vec3(1)});
    check_met(point, {Vec3(0.1), {0, 0, 1}});

    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 2, 3), Vec3(-0.0, 0, 1)}) {
        check_part(Bounds{}, {Vec3(0), d}, std::nullopt);
        check_part({{0, 1, 0}, {1, 0, 1}}, {Vec3(0.5) - d, d}, std::nullopt, {-infinity, infinity});
    }
}

TEST_CASE("a box and a ray twice as large have the same parts, to the bit", "[09.2]") {
    Random random(95);
    for (int k = 0; k < cases(2000); ++k) {
        const Vec3 p = random.in_cube(), q = random.in_cube();
        const Bounds box{glm::min(p, q), glm::max(p, q)};
        const Ray ray{3.0 * random.in_cube(), random.in_cube()};
        const Real scale = std::ldexp(1.0, static_cast<int>(random.index(400)) - 200);
        const std::optional<Interval> one = clip(box, ray, {});
        const std::optional<Interval> other =
            clip({scale * box.low, scale * box.high}, {scale * ray.origin, scale * ray.direction}, {});
        INFO("the part of the " << ray << " in the " << box << ", and with all lengths times " << scale);
        const bool same = one.has_value() == other.has_value() &&
                          (!one || (one->min == other->min && one->max == other->max));
        CHECK(test::or_say(same, show(other) + ", expected " + show(one)));
    }
}
