// Step 11.14 on extreme cases: tangents and footprints of all sizes.
#include "chapters/11_textures/footprint.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::cases;
using test::Random;

namespace {

bool is_finite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

}  // namespace

TEST_CASE("tangents of all lengths and angles have finite footprints", "[11.14][stability]") {
    Random random(111211);
    for (int i = 0; i < cases(20000); ++i) {
        const Vec3 along = random.direction();
        const Real sine = i % 4 == 0 ? 0 : random.magnitude(-18, 0);
        const Vec3 du = random.magnitude(-70, 30) * along;
        const Vec3 dv = random.magnitude(-70, 30) *
                        (std::sqrt(1 - sine * sine) * along + sine * random.perpendicular_to(along));
        const Vec3 right = random.magnitude(-30, 30) * random.direction();
        const Vec3 down = random.magnitude(-30, 30) * random.direction();
        const Footprint answer = footprint(du, dv, right, down);
        INFO("du = " << du << ", dv = " << dv << "; dp = " << right << " and " << down);
        CHECK(is_finite(answer.dx));
        CHECK(is_finite(answer.dy));
        if (sine < 1e-9) {
            CHECK(test::near(answer.dx, Vec2(0), 0));
            CHECK(test::near(answer.dy, Vec2(0), 0));
        }
    }
}

TEST_CASE("small and large tangents measure alike", "[11.14][stability]") {
    Random random(111212);
    for (int i = 0; i < cases(20000); ++i) {
        const Real u = random.magnitude(-70, 30), v = random.magnitude(-70, 30);
        const Vec3 along = random.direction(), across = random.perpendicular_to(along);
        const Vec3 right = random.magnitude(-30, 30) * along, down = random.magnitude(-30, 30) * across;
        const Footprint answer = footprint(u * along, v * across, right, down);
        INFO("du = " << u << " times " << along << ", dv = " << v << " times " << across << "; dp = " << right
                     << " and " << down);
        // A handful of roundings of the unit vectors count like as many of the function's.
        const Real of_right = gamma(64) * length(right), of_down = gamma(64) * length(down);
        CHECK(test::near(answer.dx.x, length(right) / u, of_right / u));
        CHECK(test::near(answer.dx.y, 0, of_right / v));
        CHECK(test::near(answer.dy.x, 0, of_down / u));
        CHECK(test::near(answer.dy.y, length(down) / v, of_down / v));
    }
}

TEST_CASE("footprints of all sizes have a colour within the texture's", "[11.14][stability]") {
    Random random(111213);
    Image image = make_image(16, 4);
    for (Vec3& texel : image.pixels) texel = Vec3(random.uniform(0, 1), random.uniform(0, 1), 1);
    const MipMap map = mip_map(image);
    for (int i = 0; i < cases(20000); ++i) {
        const Footprint seen{random.magnitude(-120, 120) * Vec2(random.in_cube()),
                             random.magnitude(-120, 120) * Vec2(random.in_cube())};
        const Vec2 uv(random.magnitude(-3, 3) * random.in_cube());
        const int most_probes = 1 + static_cast<int>(random.index(64));
        const Vec3 answer = anisotropic(map, uv, seen, Wrap::Repeat, most_probes);
        INFO("uv " << uv << ", footprint " << seen.dx << " and " << seen.dy << ", at most " << most_probes
                   << " probes: " << answer);
        // What the contract promises, and as much again for `trilinear`.
        const Real rounding = gamma(64) * (64 + (1 + std::abs(uv.x) + std::abs(uv.y)) * 16);
        CHECK(test::near(answer, Vec3(0.5, 0.5, 1), 0.5 + rounding));
        CHECK(test::near(answer.z, 1, rounding));
    }
}
