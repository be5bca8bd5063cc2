// Step 11.1: where a point of a shape lies on a texture, and how the surface runs there.
#include "chapters/11_textures/texture_coordinates.hpp"
#include "common/math/error.hpp"
#include "common/scene/formula.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <string>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

const std::array<Vec2, 3> corners{{{0, 0}, {0, 1}, {1, 0}}};
const Real turn = 2 * pi;

/// Twice the area of the triangle (a, b, c) of the screen.
Real doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void check_point(const std::string& what, const TexturePoint& texture, const TexturePoint& expected,
                 Real size) {
    INFO(what);
    {
        INFO("the place on the texture, (u, v)");
        CHECK(near(texture.uv, expected.uv, gamma(16)));
    }
    {
        INFO("du, how far the point moves with a whole unit of u");
        CHECK(near(texture.du, expected.du, gamma(64) * turn * size));
    }
    INFO("dv, how far the point moves with a whole unit of v");
    CHECK(near(texture.dv, expected.dv, gamma(64) * turn * size));
}

/// Asks the shape about points that are made from (u, v) by `place`, whatever way it goes back, and compares
/// the tangents with quotients of differences.
template <class Shape, class Place>
void check_against(const Shape& shape, std::uint32_t element, const Vec2& uv, Real size, Place place) {
    const Vec3 p = place(uv);
    const TexturePoint texture = texture_point(shape, p, element);
    INFO(shape << ", element " << element << ", p = " << p << ", which is at uv = " << uv);
    CHECK(near(texture.uv, uv, 1e-10));
    {
        INFO("uv without the tangents");
        CHECK(near(texture_uv(shape, p, element), texture.uv, 0));
    }
    // By steps of h and 2h. That is wrong by h⁴/30 times the fifth derivative, of which an ellipsoid with
    // axes of 4 to 1 has up to (8π)⁵ times the size: 3e-13 of it; and by 4u/h times the size: 1e-11.
    const Real h = 3e-5;
    const auto derivative = [&](const Vec2& step) {
        return (Real(8) * (place(uv + step) - place(uv - step)) -
                (place(uv + Real(2) * step) - place(uv - Real(2) * step))) /
               (12 * h);
    };
    const Vec3 du = derivative({h, 0}), dv = derivative({0, h});
    {
        INFO("du against a small step of u");
        CHECK(near(texture.du, du, 1e-9 * size));
    }
    INFO("dv against a small step of v");
    CHECK(near(texture.dv, dv, 1e-9 * size));
}

}  // namespace

TEST_CASE("halfway across the screen is a quarter of the way", "[11.1]") {
    // From the first corner, 1 away, to the second, 3 away: (½·1/3)/(½·1/1 + ½·1/3) = (1/6)/(2/3).
    INFO("uvs (0, 0), (0, 1), (1, 0) at depths 1, 3 and 1; on the screen at weights (0.5, 0.5, 0)");
    CHECK(near(perspective_uv(corners, {1, 3, 1}, {0.5, 0.5, 0}), Vec2(0, 0.25), gamma(16)));
}

TEST_CASE("the nearer corner counts for more", "[11.1]") {
    // Weights ½, ¼, ¼ over depths 1, 2, 2 are ½, ⅛, ⅛, which add up to ¾.
    INFO("uvs (0, 0), (0, 1), (1, 0) at depths 1, 2 and 2; on the screen at weights (0.5, 0.25, 0.25)");
    CHECK(near(perspective_uv(corners, {1, 2, 2}, {0.5, 0.25, 0.25}), Vec2(1.0 / 6), gamma(16)));
    CHECK(near(perspective_uv(corners, {4, 8, 8}, {0.5, 0.25, 0.25}), Vec2(1.0 / 6), gamma(16)));
}

TEST_CASE("where all corners are equally far away, the screen's weights are right", "[11.1]") {
    for (const Real depth : {0.25, 1.0, 1000.0}) {
        INFO("uvs (0, 0), (0, 1), (1, 0), all at depth " << depth
                                                         << "; on the screen at weights (0.25, 0.5, 0.25)");
        CHECK(near(perspective_uv(corners, Vec3(depth), {0.25, 0.5, 0.25}), Vec2(0.25, 0.5), gamma(16)));
    }
}

TEST_CASE("a corner's uv is seen where the corner is", "[11.1]") {
    const auto check_corner = [](const Vec3& weights, const Vec2& expected) {
        INFO("uvs (0, 0), (0, 1), (1, 0) at depths 5, 3 and 2; on the screen at weights " << weights);
        CHECK(near(perspective_uv(corners, {5, 3, 2}, weights), expected, gamma(16)));
    };
    check_corner({1, 0, 0}, {0, 0});
    check_corner({0, 1, 0}, {0, 1});
    check_corner({0, 0, 1}, {1, 0});
}

TEST_CASE("a ball's equator: a turn of u is 2 pi long, half a turn of v is pi", "[11.1]") {
    const Sphere ball{{0, 0, 0}, 1};
    check_point("unit ball, p = (1, 0, 0)", texture_point(ball, {1, 0, 0}, 0),
                {{0, 0.5}, {0, 0, turn}, {0, pi, 0}}, 1);
    check_point("unit ball, p = (0, 0, 1)", texture_point(ball, {0, 0, 1}, 0),
                {{0.25, 0.5}, {-turn, 0, 0}, {0, pi, 0}}, 1);
    check_point("unit ball, p = (-1, 0, 0)", texture_point(ball, {-1, 0, 0}, 0),
                {{0.5, 0.5}, {0, 0, -turn}, {0, pi, 0}}, 1);
}

TEST_CASE("the tangents grow with the ball, and its place does not matter", "[11.1]") {
    check_point("ball around (1, 2, 3) of radius 2, p = (3, 2, 3)",
                texture_point(Sphere{{1, 2, 3}, 2}, {3, 2, 3}, 0),
                {{0, 0.5}, {0, 0, 2 * turn}, {0, 2 * pi, 0}}, 6);
}

TEST_CASE("away from the equator a turn of u is shorter, and v climbs towards the axis", "[11.1]") {
    // Radius 5 at (3, 4, 0): the parallel has radius 3. v is ½ + asin(4/5)/π.
    const Vec2 uv(0, 0.5 + std::atan(4.0 / 3) / pi);
    check_point("ball around (0, 0, 0) of radius 5, p = (3, 4, 0)",
                texture_point(Sphere{{0, 0, 0}, 5}, {3, 4, 0}, 0),
                {uv, {0, 0, 3 * turn}, {-4 * pi, 3 * pi, 0}}, 5);
}

TEST_CASE("at a pole du is 0 and dv is not", "[11.1]") {
    for (const Real y : {2.0, -2.0})
        for (const Real zero : {0.0, -0.0}) {
            const Vec3 p(zero, y, zero);
            const TexturePoint texture = texture_point(Sphere{{0, 0, 0}, 2}, p, 0);
            INFO("ball around the origin of radius 2, p = " << p << ": uv " << texture.uv << ", du "
                                                            << texture.du << ", dv " << texture.dv);
            CHECK(near(texture.uv.y, y > 0 ? 1 : 0, gamma(16)));
            CHECK(texture.uv.x >= 0);
            CHECK(texture.uv.x < 1);
            CHECK(near(length(texture.du), 0, gamma(64) * 2 * turn));
            CHECK(near(length(texture.dv), 2 * pi, gamma(64) * turn));
            INFO("dv along the meridian of u");
            const Real angle = turn * texture.uv.x;
            const Vec3 outwards(std::cos(angle), 0, std::sin(angle));
            CHECK(near(dot(texture.dv, outwards), -y * pi, gamma(64) * turn));
        }
}

TEST_CASE("an upright cylinder: u around it, v up its side", "[11.1]") {
    const OpenCone can{Cone{{0, 0, 0}, 1, {0, 2, 0}, 1}};
    check_point("tube from (0, 0, 0) to (0, 2, 0) of radius 1, p = (1, 1, 0)",
                texture_point(can, {1, 1, 0}, 0), {{0, 0.5}, {0, 0, turn}, {0, 2, 0}}, 3);
    check_point("tube from (0, 0, 0) to (0, 2, 0) of radius 1, p = (0, 0.5, 1)",
                texture_point(can, {0, 0.5, 1}, 0), {{0.25, 0.25}, {-turn, 0, 0}, {0, 2, 0}}, 3);
    check_point("tube from (0, 0, 0) to (0, 2, 0) of radius 1, p = (0, 2, -1)",
                texture_point(can, {0, 2, -1}, 0), {{0.75, 1}, {turn, 0, 0}, {0, 2, 0}}, 3);
}

TEST_CASE("a cone narrows: du is shorter, and dv leans inwards", "[11.1]") {
    const OpenCone hat{Cone{{0, 0, 0}, 1, {0, 2, 0}, 0}};
    check_point("cone from (0, 0, 0), radius 1, to the apex (0, 2, 0), p = (0.5, 1, 0)",
                texture_point(hat, {0.5, 1, 0}, 0), {{0, 0.5}, {0, 0, pi}, {-1, 2, 0}}, 3);
    check_point("cone from (0, 0, 0), radius 1, to the apex (0, 2, 0), p = (0, 1.5, -0.25)",
                texture_point(hat, {0, 1.5, -0.25}, 0), {{0.75, 0.75}, {pi / 2, 0, 0}, {0, 2, 1}}, 3);
}

TEST_CASE("a cylinder is seen from its end a, wherever it lies", "[11.1]") {
    // Along +z: u counts from +x towards −y.
    const OpenCone pipe{Cone{{1, 1, 1}, 3, {1, 1, 5}, 3}};
    check_point("tube from (1, 1, 1) to (1, 1, 5) of radius 3, p = (1, -2, 4)",
                texture_point(pipe, {1, -2, 4}, 0), {{0.25, 0.75}, {-3 * turn, 0, 0}, {0, 0, 4}}, 12);
}

TEST_CASE("at the apex of a cone du is 0, and v does not go beyond the ends", "[11.1]") {
    const OpenCone hat{Cone{{0, 0, 0}, 1, {0, 2, 0}, 0}};
    for (const Vec3& p : {Vec3(0, 2, 0), Vec3(0, 2 + 0x1p-51, 0)}) {
        const TexturePoint texture = texture_point(hat, p, 0);
        INFO("cone from (0, 0, 0), radius 1, to the apex (0, 2, 0), p = "
             << p << ": uv " << texture.uv << ", du " << texture.du << ", dv " << texture.dv);
        CHECK(near(texture.uv.y, 1, gamma(16)));
        CHECK(texture.uv.y <= 1);
        CHECK(texture.uv.x >= 0);
        CHECK(texture.uv.x < 1);
        CHECK(near(length(texture.du), 0, gamma(64) * turn));
        CHECK(near(length(texture.dv), std::sqrt(5.0), gamma(64) * 3));
    }
    const TexturePoint below = texture_point(hat, {1, -0x1p-53, 0}, 0);
    INFO("p a rounding below the end a, v = " << below.uv.y);
    CHECK(below.uv.y >= 0);
}

TEST_CASE("the axes of a floor, a wall and a ceiling", "[11.1]") {
    const struct {
        const char* what;
        Vec3 normal, u, v;
    } planes[] = {
        {"floor", {0, 7, 0}, {1, 0, 0}, {0, 0, -1}},      {"ceiling", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {"wall to +z", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {"wall to -z", {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
        {"wall to +x", {1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {"wall to -x", {-3, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    };
    for (const auto& [what, normal, u, v] : planes) {
        INFO(what);
        const PlaneAxes axes = plane_axes(normal);
        CHECK(near(axes.u, u, gamma(8)));
        CHECK(near(axes.v, v, gamma(8)));
    }
}

TEST_CASE("planes in units of length, discs in their square", "[11.1]") {
    check_point("floor through (1, 0, 1), p = (3, 0, -4)",
                texture_point(Plane{{1, 0, 1}, {0, 1, 0}}, {3, 0, -4}, 0), {{2, 5}, {1, 0, 0}, {0, 0, -1}},
                5);
    check_point("disc around (0, 0, 0) facing +z of radius 2, p = (1, -1, 0)",
                texture_point(Disc{{0, 0, 0}, {0, 0, 1}, 2}, {1, -1, 0}, 0),
                {{0.75, 0.25}, {4, 0, 0}, {0, 4, 0}}, 4);
}

TEST_CASE("each face of a box shows the whole image, upright and not mirrored from outside", "[11.1]") {
    const Box box{{0, 0, 0}, {2, 4, 8}};
    const Vec3 faces[][3] = {{{0, 1, 2}, {0, 0, 8}, {0, 4, 0}},    {{2, 1, 2}, {0, 0, -8}, {0, 4, 0}},
                             {{0.5, 0, 2}, {2, 0, 0}, {0, 0, 8}},  {{0.5, 4, 6}, {2, 0, 0}, {0, 0, -8}},
                             {{1.5, 1, 0}, {-2, 0, 0}, {0, 4, 0}}, {{0.5, 1, 8}, {2, 0, 0}, {0, 4, 0}}};
    const Vec2 uvs[] = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.25}, {0.25, 0.25}, {0.25, 0.25}, {0.25, 0.25}};
    for (std::uint32_t face = 0; face < 6; ++face) {
        const auto& [p, du, dv] = faces[face];
        const TexturePoint texture = texture_point(box, p, face);
        check_point("box from (0, 0, 0) to (2, 4, 8), face " + std::to_string(face), texture,
                    {uvs[face], du, dv}, 8);
        Vec3 outward(0);
        outward[static_cast<int>(face / 2)] = face % 2 == 0 ? -1 : 1;
        INFO("face " << face << ": du × dv = " << cross(texture.du, texture.dv)
                     << " should look outwards, like " << outward << "; the product of the two is");
        CHECK(dot(cross(texture.du, texture.dv), outward) > 0);
    }
}

TEST_CASE("the caps of a cone are discs that face outwards", "[11.1]") {
    const Cone can{{0, 0, 0}, 1, {0, 2, 0}, 0};
    check_point("cap at a", texture_point(can, {0.5, 0, 0.25}, 1), {{0.75, 0.625}, {2, 0, 0}, {0, 0, 2}}, 2);
    check_point("the apex as a cap", texture_point(can, {0, 2, 0}, 2), {{0.5, 0.5}, Vec3(0), Vec3(0)}, 2);
    const Cone mug{{0, 0, 0}, 1, {0, 2, 0}, 2};
    check_point("cap at b", texture_point(mug, {1, 2, 1}, 2), {{0.75, 0.25}, {4, 0, 0}, {0, 0, -4}}, 4);
}

TEST_CASE("a torus: u around the axis, v around the tube", "[11.1]") {
    const Torus ring{{0, 0, 0}, {0, 3, 0}, 2, 1};
    check_point("torus, ring 2, tube 1, p = (3, 0, 0)", texture_point(ring, {3, 0, 0}, 0),
                {{0.5, 0.5}, {0, 0, -3 * turn}, {0, turn, 0}}, 3);
    check_point("torus, ring 2, tube 1, p = (0, 1, 2)", texture_point(ring, {0, 1, 2}, 0),
                {{0.25, 0.75}, {2 * turn, 0, 0}, {0, 0, -turn}}, 3);
}

TEST_CASE("a triangle's tangents by hand", "[11.1]") {
    // The image is laid on with u along −y·2 and v along +x·4.
    const Triangle triangle{{0, 0, 5}, {4, 0, 5}, {0, 2, 5}};
    check_point("triangle (0, 0, 5), (4, 0, 5), (0, 2, 5) with uvs (1, 0), (1, 1), (0, 0)",
                texture_point(triangle, TriangleUvs{{1, 0}, {1, 1}, {0, 0}}, {0.25, 0.5}),
                {{0.5, 0.25}, {0, -2, 0}, {4, 0, 0}}, 7);
    const TexturePoint none = texture_point(triangle, TriangleUvs{{0, 0}, {1, 1}, {3, 3}}, {0.25, 0.5});
    check_point("the same with uvs (0, 0), (1, 1), (3, 3)", none, {{1.75, 1.75}, Vec3(0), Vec3(0)}, 7);
}

TEST_CASE("a parallelogram shows the whole picture, from its first vertex on", "[11.1]") {
    const Polygon wall{{{0, 0, 3}, {4, 0, 3}, {5, 2, 3}, {1, 2, 3}}};
    const Vec3 du(4, 0, 0), dv(1, 2, 0);
    check_point("first vertex", texture_point(wall, {0, 0, 3}, 0), {{0, 0}, du, dv}, 5);
    check_point("opposite vertex", texture_point(wall, {5, 2, 3}, 0), {{1, 1}, du, dv}, 5);
    check_point("p = (1.5, 1, 3)", texture_point(wall, {1.5, 1, 3}, 0), {{0.25, 0.5}, du, dv}, 5);
    const Polygon triangle{{{0, 0, 0}, {2, 0, 0}, {0, 0, 3}}};
    check_point("a triangle, as its weights of the second and the third corner",
                texture_point(triangle, {0.5, 0, 1.5}, 0), {{0.25, 0.5}, {2, 0, 0}, {0, 0, 3}}, 3);
}

TEST_CASE("a polygon whose first corner is straight has no place for a picture", "[11.1]") {
    const Polygon straight{{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 0}}};
    check_point("a square that begins in the middle of a side", texture_point(straight, {1, 0.5, 0}, 0), {},
                2);
}

TEST_CASE("a polygon's picture is stretched and turned with it", "[11.1]") {
    Random random(11119);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 first = random.in_cube(), across = random.in_cube(), up = random.in_cube();
        const Real size = length(across) * length(up), sine = length(cross(across, up)) / size;
        if (sine < 0.1) continue;
        const Vec2 uv(random.uniform(-1, 2), random.uniform(-1, 2));
        const Polygon polygon{{first, first + across, first + 2.0 * across + 3.0 * up, first + up}};
        const Vec3 p = first + uv.x * across + uv.y * up;
        INFO(polygon << ", p = " << p);
        const Real least = std::min(length(across), length(up));
        CHECK(near(texture_point(polygon, p, 0).uv, uv, gamma(64) * 8 / (sine * least)));
    }
}

namespace {

/// The surface x²/a² + y²/b² + z²/c² = 1 as both kinds of shapes.
Quadric ellipsoid(const Vec3& axes) {
    return {Real(1) / (axes * axes), Vec3(0), Vec3(0), -1, {Vec3(-9), Vec3(9)}};
}
Implicit sphere_of_formula() {
    return {{Vec3(-9), Vec3(9)}, std::make_shared<const Formula>(parse_formula("x^2+y^2+z^2-1"))};
}

}  // namespace

TEST_CASE("a quadric or formula that is a ball has a ball's coordinates", "[11.1]") {
    const Sphere ball{Vec3(0), 1};
    for (const Vec3& p : {Vec3(1, 0, 0), Vec3(0.6, 0, 0.8), Vec3(0, -0.6, -0.8), Vec3(0, 1, 0)}) {
        const TexturePoint expected = texture_point(ball, p, 0);
        const std::string where = "p = " + test::show(p);
        check_point("quadric, " + where, texture_point(ellipsoid(Vec3(1)), p, 6), expected, 1);
        check_point("formula, " + where, texture_point(sphere_of_formula(), p, 6), expected, 1);
        INFO("texture_uv of the quadric and the formula at " << where);
        CHECK(near(texture_uv(ellipsoid(Vec3(1)), p, 6), expected.uv, 0));
        CHECK(near(texture_uv(sphere_of_formula(), p, 6), expected.uv, 0));
    }
}

TEST_CASE("a wall beside the origin: a step of u goes along it, not around the origin", "[11.1]") {
    // The plane x = 2 as a quadric; p = (2, 0, 2) is 45 degrees from x. z = 2 tan θ, dz/dθ = 2/cos² = 4.
    const Quadric wall{Vec3(0), Vec3(0), {1, 0, 0}, -2, {Vec3(-9), Vec3(9)}};
    const TexturePoint texture = texture_point(wall, {2, 0, 2}, 6);
    check_point("the plane x = 2, p = (2, 0, 2)", texture,
                {{0.125, 0.5}, {0, 0, 4 * turn}, {0, 2 * std::sqrt(2.0) * pi, 0}}, 16);
}

TEST_CASE("points of ellipsoids, and steps along their tangents", "[11.1]") {
    Random random(11120);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 axes(random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2));
        const Vec2 uv(random.uniform(0.001, 0.999), random.uniform(0.05, 0.95));
        check_against(ellipsoid(axes), 6, uv, 64, [&](const Vec2& at) {
            const Real along = turn * at.x, up = pi * at.y;
            const Vec3 d(std::sin(up) * std::cos(along), -std::cos(up), std::sin(up) * std::sin(along));
            return d / length(d / axes);
        });
    }
}

TEST_CASE("where the box closes a quadric, steps go along its face", "[11.1]") {
    const Vec3 p(0.5, 0.75, -0.25);
    for (std::uint32_t face = 0; face < 6; ++face) {
        const TexturePoint texture = texture_point(ellipsoid(Vec3(2)), p, face);
        INFO("face " << face << ", p = " << p << ": du " << texture.du << ", dv " << texture.dv);
        const int axis = static_cast<int>(face / 2);
        CHECK(near(texture.du[axis], 0, gamma(64) * 16 * turn));
        CHECK(near(texture.dv[axis], 0, gamma(64) * 16 * turn));
        CHECK(length(texture.dv) > 0);
    }
}

TEST_CASE("points of balls, and steps along their tangents", "[11.1]") {
    Random random(11101);
    for (int i = 0; i < cases(5000); ++i) {
        const Sphere ball{random.in_cube(), random.magnitude(-0.5, 0.5)};
        const Vec2 uv(random.uniform(0.001, 0.999), random.uniform(0.01, 0.99));
        check_against(ball, 0, uv, ball.radius, [&](const Vec2& at) {
            const Real along = turn * at.x, up = pi * at.y;
            return ball.center + ball.radius * Vec3(std::sin(up) * std::cos(along), -std::cos(up),
                                                    std::sin(up) * std::sin(along));
        });
    }
}

TEST_CASE("points of the sides of cones and cylinders, and steps along their tangents", "[11.1]") {
    Random random(11102);
    for (int i = 0; i < cases(5000); ++i) {
        const Vec3 a = random.in_cube(), axis = random.magnitude(-0.5, 0.5) * random.direction();
        const Real wide = random.magnitude(-0.5, 0.5);
        const Real ends[] = {wide, i % 3 == 0 ? wide : random.uniform(0, 2)};
        const OpenCone side{Cone{a, ends[i % 2], a + axis, ends[1 - i % 2]}};
        const Vec2 uv(random.uniform(0.001, 0.999), random.uniform(0.05, 0.95));
        const PlaneAxes axes = plane_axes(axis);
        check_against(side, 0, uv, 2 * (length(axis) + ends[0] + ends[1]), [&](const Vec2& at) {
            const Real radius = side.cone.radius_a * (1 - at.y) + side.cone.radius_b * at.y;
            return (1 - at.y) * side.cone.a + at.y * side.cone.b +
                   radius * (std::cos(turn * at.x) * axes.u - std::sin(turn * at.x) * axes.v);
        });
    }
}

TEST_CASE("a solid cone's uv without its tangents, on the side and on the ends", "[11.1]") {
    const Cone cone{{0, 0, 0}, 1, {0, 2, 0}, 0.5};
    const Vec3 points[] = {{0, 1, 0.75}, {0.5, 0, -0.25}, {-0.125, 2, 0.25}};
    for (std::uint32_t element = 0; element < 3; ++element) {
        INFO("cone from (0, 0, 0) to (0, 2, 0) with radii 1 and 0.5, element "
             << element << ", p = " << points[element]);
        const Vec2 uv = texture_point(cone, points[element], element).uv;
        CHECK(near(texture_uv(cone, points[element], element), uv, 0));
    }
}

TEST_CASE("points of tori, and steps along their tangents", "[11.1]") {
    Random random(11103);
    for (int i = 0; i < cases(2000); ++i) {
        const Torus torus{random.in_cube(), random.magnitude(-2, 2) * random.direction(),
                          random.uniform(1, 2), random.uniform(0.1, 0.9)};
        const Vec2 uv(random.uniform(0.001, 0.999), random.uniform(0.001, 0.999));
        const PlaneAxes axes = plane_axes(torus.axis);
        const Vec3 n = normalize(torus.axis);
        check_against(torus, 0, uv, 2 * (torus.ring + torus.tube), [&](const Vec2& at) {
            const Real around = turn * (0.5 - at.x), up = turn * (at.y - 0.5);
            const Vec3 radial = std::cos(around) * axes.u - std::sin(around) * axes.v;
            return torus.center + torus.ring * radial +
                   torus.tube * (std::cos(up) * radial + std::sin(up) * n);
        });
    }
}

TEST_CASE("triangles: the edges are what their uvs say", "[11.1]") {
    Random random(11104);
    for (int i = 0; i < cases(2000); ++i) {
        const auto point = [&] { return Vec2(random.uniform(-1, 1), random.uniform(-1, 1)); };
        const Triangle t{random.in_cube(), random.in_cube(), random.in_cube()};
        const TriangleUvs uvs{point(), point(), point()};
        const Real area = std::abs(doubled_area(uvs.a, uvs.b, uvs.c));
        if (area < 0.01) continue;
        const TexturePoint texture = texture_point(t, uvs, {0.25, 0.25});
        INFO(t << " with uvs " << uvs.a << ", " << uvs.b << ", " << uvs.c << ": du " << texture.du << ", dv "
               << texture.dv);
        // du and dv are quotients by `area` of sums of products of edges of up to 4 in size.
        const Real bound = gamma(16) * 64 / area;
        CHECK(near((uvs.b - uvs.a).x * texture.du + (uvs.b - uvs.a).y * texture.dv, t.b - t.a, bound));
        CHECK(near((uvs.c - uvs.a).x * texture.du + (uvs.c - uvs.a).y * texture.dv, t.c - t.a, bound));
        CHECK(near(texture.uv, 0.5 * uvs.a + 0.25 * uvs.b + 0.25 * uvs.c, gamma(8) * 2));
    }
}

TEST_CASE("points of a triangle in space are found again from where they are on the screen", "[11.1]") {
    Random random(11105);
    int asked = 0;
    for (int i = 0; i < cases(20000); ++i) {
        // The eye is at the origin, the screen at distance 1; points are between 1 and 8 away.
        const auto corner = [&] {
            const Real depth = random.uniform(1, 8);
            return depth * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1);
        };
        const Vec3 a = corner(), b = corner(), c = corner();
        const Real first = random.uniform(0, 1), second = random.uniform(0, 1) * (1 - first);
        const Vec3 weights(first, second, 1 - first - second);
        const Vec3 p = weights.x * a + weights.y * b + weights.z * c;
        const auto image = [](const Vec3& q) { return Vec2(q.x / q.z, q.y / q.z); };
        const Real area = doubled_area(image(a), image(b), image(c));
        if (std::abs(area) < 0.2) continue;
        ++asked;
        const Vec3 on_screen =
            Vec3(doubled_area(image(p), image(b), image(c)), doubled_area(image(a), image(p), image(c)),
                 doubled_area(image(a), image(b), image(p))) /
            area;
        const Vec2 uv = perspective_uv(corners, {a.z, b.z, c.z}, on_screen);
        INFO("corners " << a << ", " << b << ", " << c << " with uvs (0, 0), (0, 1), (1, 0), the point " << p
                        << ", on the screen at weights " << on_screen);
        // Areas of up to 8 with 16 roundings, over one of 0.2: 640u. Perspective multiplies differences by no
        // more than the ratio of the depths, 8.
        CHECK(near(uv, Vec2(weights.z, weights.y), gamma(2 * 640 * 8)));
    }
    CHECK(asked >= test::demanded(cases(20000) / 4, 0));
}
