// Step 11.1 at its ends: poles, seams, apexes, tiny balls far away, corners whose uvs lie on one line.
#include "chapters/11_textures/texture_coordinates.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <array>
#include <cmath>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

const Real turn = 2 * pi;

bool is_finite(const TexturePoint& texture) {
    return std::isfinite(texture.uv.x) && std::isfinite(texture.uv.y) && test::is_finite(texture.du) &&
           test::is_finite(texture.dv);
}

void check_wrapped(const std::string& what, const TexturePoint& texture) {
    INFO(what << ": uv " << texture.uv << ", du " << texture.du << ", dv " << texture.dv);
    CHECK(is_finite(texture));
    CHECK(texture.uv.x >= 0);
    CHECK(texture.uv.x < 1);
    CHECK(texture.uv.y >= 0);
    CHECK(texture.uv.y <= 1);
}

}  // namespace

TEST_CASE("seams and poles of balls of all sizes, near and far", "[11.1][stability]") {
    Random random(11111);
    for (int i = 0; i < cases(20000); ++i) {
        const Real radius = random.magnitude(-100, 100);
        const Vec3 center = radius * random.magnitude(-20, 20) * random.in_cube();
        // Near a pole, near the seam, or both.
        const Real beside = random.sign() * random.magnitude(-320, 0), low = random.magnitude(-320, 0);
        const Vec3 directions[] = {{low, random.sign(), beside}, {1, beside, random.sign() * low}, {0, 1, 0}};
        const Vec3 p = center + radius * unit(directions[i % 3]);
        const TexturePoint texture = texture_point(Sphere{center, radius}, p, 0);
        check_wrapped(test::show(Sphere{center, radius}) + ", p = " + test::show(p), texture);
        CHECK(length(texture.du / radius) <= turn * (1 + gamma(64)));
        CHECK(near(length(texture.dv / radius), pi, gamma(64) * pi));
    }
}

TEST_CASE("a ball so far away that its point is its centre", "[11.1][stability]") {
    const Sphere far{{1e10, 2e10, 3e10}, 1e-12};
    check_wrapped(test::show(far) + ", p its centre", texture_point(far, far.center, 0));
}

TEST_CASE("seams, ends and apexes of cones", "[11.1][stability]") {
    Random random(11112);
    for (int i = 0; i < cases(20000); ++i) {
        const Real size = random.magnitude(-50, 50);
        const Vec3 a = size * random.magnitude(-3, 3) * random.in_cube();
        const Vec3 axis = size * (i % 4 == 0 ? Vec3(0, random.sign(), 0) : random.direction());
        const Real wide = size * random.magnitude(-3, 3);
        const Cone cone{a, i % 2 == 0 ? wide : 0, a + axis, i % 3 == 0 ? wide : i % 2 == 0 ? 0 : wide / 2};
        const PlaneAxes axes = plane_axes(axis);
        const Real s = i % 5 == 0 ? 0 : i % 5 == 1 ? 1 : random.uniform(0, 1);
        const Real beside = random.sign() * random.magnitude(-320, 0);
        const Vec3 p = a + s * axis +
                       (cone.radius_a + s * (cone.radius_b - cone.radius_a)) *
                           unit(random.sign() * axes.u + beside * axes.v);
        for (std::uint32_t element = 0; element < 3; ++element) {
            const TexturePoint texture = texture_point(cone, p, element);
            const std::string what = test::show(cone) + ", p = " + test::show(p) + ", element ";
            if (element == 0)
                check_wrapped(what + "0", texture);
            else
                CHECK(is_finite(texture));
        }
    }
}

TEST_CASE("a point at the end of a long thin tube", "[11.1][stability]") {
    Random random(11113);
    for (int i = 0; i < cases(5000); ++i) {
        const Real length_of_tube = random.magnitude(0, 6);
        const Vec3 axis = length_of_tube * random.direction();
        const PlaneAxes axes = plane_axes(axis);
        const Vec2 uv(random.uniform(0.01, 0.99), random.uniform(0, 1));
        const Vec3 radial = std::cos(turn * uv.x) * axes.u - std::sin(turn * uv.x) * axes.v;
        const OpenCone tube{Cone{Vec3(0), 1, axis, 1}};
        const Vec3 p = uv.y * axis + radial;
        const TexturePoint texture = texture_point(tube, p, 0);
        INFO(tube << ", p = " << p << ", which is at uv = " << uv << "; du " << texture.du);
        // As the contract says: an angle of 16u(|p| + |b|) over the radius, 1; and of that a turn is 2π.
        const Real angle = gamma(16) * (length(p) + length_of_tube);
        CHECK(near(texture.uv, uv, angle / turn + gamma(16)));
        CHECK(near(texture.du, turn * cross(radial, normalize(axis)), turn * (angle + gamma(64))));
    }
}

TEST_CASE("seams and closed holes of tori, axes of any length", "[11.1][stability]") {
    Random random(11114);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 axis = random.magnitude(-300, 300) * random.direction(), n = unit(axis);
        const Real tube = i % 3 == 0 ? 1 : random.uniform(0.1, 2);
        const Torus torus{random.in_cube(), axis, 1, tube};
        const PlaneAxes axes = plane_axes(axis);
        const Real beside = random.sign() * random.magnitude(-320, 0);
        const Vec3 radial = unit(random.sign() * axes.u + beside * axes.v);
        const Vec2 out[] = {{tube, 0}, {-tube, beside}, {0, tube}};
        const Vec2 at = out[i % 3];
        const Vec3 p = 1 + at.x < 0 ? torus.center + std::sqrt((tube - 1) * (tube + 1)) * n
                                    : torus.center + (1 + at.x) * radial + at.y * n;
        const TexturePoint texture = texture_point(torus, p, 0);
        check_wrapped(test::show(torus) + ", p = " + test::show(p), texture);
        CHECK(texture.uv.y < 1);
    }
}

TEST_CASE("axes of planes are unit vectors, perpendicular, whatever the normal", "[11.1][stability]") {
    Random random(11115);
    const Real up = 0.7861513777574233, back = -0.6180339887498949;
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 aside = random.magnitude(-18, -1) * random.in_cube();
        const Vec3 n = i % 3 == 0 ? random.direction() : unit(Vec3(0, random.sign() * up, back) + aside);
        const Vec3 normal = random.magnitude(-300, 300) * n;
        const auto [u, v] = plane_axes(normal);
        INFO("normal " << normal << ": u " << u << ", v " << v);
        CHECK(near(length(u), 1, gamma(16)));
        CHECK(near(length(v), 1, gamma(16)));
        CHECK(near(dot(u, v), 0, gamma(16)));
        CHECK(near(cross(u, v), n, gamma(32)));
    }
}

TEST_CASE("a normal that is wrong by a rounding turns a floor or a wall by no more", "[11.1][stability]") {
    Random random(11116);
    for (const Vec3& normal :
         {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        for (int i = 0; i < 100; ++i) {
            const Real aside = random.magnitude(-20, -2);
            const PlaneAxes straight = plane_axes(normal);
            const PlaneAxes tilted = plane_axes(normal + aside * random.in_cube());
            INFO("normal " << normal << " and one that is wrong by " << aside);
            CHECK(near(tilted.u, straight.u, 8 * aside + gamma(16)));
            CHECK(near(tilted.v, straight.v, 8 * aside + gamma(16)));
        }
}

TEST_CASE("corners whose uvs lie on one line, or nearly", "[11.1][stability]") {
    Random random(11117);
    for (int i = 0; i < cases(20000); ++i) {
        const Real size = random.magnitude(-100, 100);
        const Triangle t{size * random.in_cube(), size * random.in_cube(), size * random.in_cube()};
        const Vec2 a(random.uniform(-1, 1), random.uniform(-1, 1)), along(random.uniform(-1, 1), 1);
        const Vec2 beside(random.magnitude(-320, -10), 0);
        const TriangleUvs uvs{a, a + random.uniform(-1, 1) * along,
                              a + along + (i % 2 == 0 ? beside : Vec2(0))};
        const TexturePoint texture = texture_point(t, uvs, {0.5, 0.25});
        INFO(t << " with uvs " << uvs.a << ", " << uvs.b << ", " << uvs.c);
        CHECK(is_finite(texture));
    }
    const TexturePoint none =
        texture_point(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, TriangleUvs{}, {0.5, 0.5});
    CHECK(none.du == Vec3(0));
    CHECK(none.dv == Vec3(0));
}

TEST_CASE("corners of very different depths", "[11.1][stability]") {
    Random random(11118);
    const std::array<Vec2, 3> uvs{{{0, 0}, {1, 0}, {0, 1}}};
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 depths(random.magnitude(-100, 100), random.magnitude(-100, 100),
                          random.magnitude(-100, 100));
        const Real s = random.uniform(0, 1), t = random.uniform(0, 1) * (1 - s);
        const Vec3 weights(1 - s - t, s, t);
        const Vec2 uv = perspective_uv(uvs, depths, weights);
        INFO("depths " << depths << ", weights on the screen " << weights);
        // The same with depths as products: each corner weighs its weight times the other two depths.
        const Vec3 d = depths / max_component(depths);
        const Vec3 shares(weights.x * d.y * d.z, weights.y * d.z * d.x, weights.z * d.x * d.y);
        const Real sum = shares.x + shares.y + shares.z;
        if (!(sum > 1e-290)) continue;
        CHECK(near(uv, Vec2(shares.y, shares.z) / sum, gamma(16)));
    }
}

TEST_CASE("quadrics through the origin, at poles and without a normal", "[11.1][stability]") {
    Random random(11121);
    for (int i = 0; i < cases(20000); ++i) {
        Quadric q{random.in_cube(), random.in_cube(), random.in_cube(), 0, {Vec3(-1), Vec3(1)}};
        if (i % 3 == 0) q.linear = Vec3(0);
        Vec3 p = random.magnitude(-30, 30) * random.in_cube();
        if (i % 5 == 0) p = Vec3(0);
        if (i % 7 == 0) p.x = p.z = 0;
        if (i % 11 == 0) p *= 1e-300;
        const TexturePoint texture = texture_point(q, p, 6);
        INFO(q << ", p = " << p);
        CHECK(is_finite(texture));
        CHECK(texture.uv.x >= 0);
        CHECK(texture.uv.x < 1);
        CHECK(near(texture_uv(q, p, 6), texture.uv, 0));
    }
    const Quadric cone{{1, -1, 1}, Vec3(0), Vec3(0), 0, {Vec3(-1), Vec3(1)}};
    INFO("the cone x² + z² = y², whose sides run along the radius, at (3, 5, 4)/5");
    CHECK(texture_point(cone, {0.6, 1, 0.8}, 6).du == Vec3(0));
}

TEST_CASE("polygons whose first corner is straight, or nearly", "[11.1][stability]") {
    Random random(11122);
    for (int i = 0; i < cases(20000); ++i) {
        const Real size = random.magnitude(-30, 30);
        const Vec3 a = size * random.in_cube(), along = size * random.in_cube();
        const Vec3 beside = i % 2 == 0 ? random.magnitude(-40, -3) * size * random.in_cube() : Vec3(0);
        const Polygon polygon{{a, a + along, a + size * random.in_cube(), a - along + beside}};
        const TexturePoint texture = texture_point(polygon, a + size * random.in_cube(), 0);
        INFO(polygon);
        CHECK(is_finite(texture));
    }
}
