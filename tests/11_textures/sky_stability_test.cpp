// Steps 11.4 and 11.5 in extreme cases: directions close to poles, middles and rims, and huge and tiny ones,
// against long double.
#include "chapters/11_textures/sky.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace rt;
using test::cases;
using test::Random;

namespace {

using Long = long double;
const Long long_pi = std::acos(Long(-1));

std::string name(SkyMap map) {
    const char* names[] = {"latitude-longitude", "mirror ball", "angular"};
    return names[static_cast<int>(map)];
}

/// A direction as angles: `polar` from an axis, or with `beyond` its rest to half a turn, and around it.
struct Angles {
    Long polar = 0;
    bool beyond = false;
    Long around = 0;
};

/// Any angle, or a tiny one from one of the ends.
Angles any_angles(Random& random) {
    const Real polar = random.index(2) == 0 ? random.uniform(0, pi / 2) : random.magnitude(-20, 0);
    return {polar, random.index(2) == 0, random.uniform(0, 2 * pi)};
}

/// Each coordinate is rounded once, in proportion, so both angles are off by no more than u.
Vec3 direction_at(SkyMap map, const Angles& at, Real size) {
    const Long away = std::sin(at.polar), along = at.beyond ? -std::cos(at.polar) : std::cos(at.polar);
    const Long a = away * std::cos(at.around), b = away * std::sin(at.around);
    if (map == SkyMap::LatitudeLongitude)
        return size * Vec3(static_cast<Real>(a), static_cast<Real>(along), static_cast<Real>(b));
    return size * Vec3(static_cast<Real>(a), static_cast<Real>(b),
                       static_cast<Real>(map == SkyMap::Angular ? -along : along));
}

Vec2 place_at(SkyMap map, const Angles& at) {
    if (SkyMap::LatitudeLongitude == map) {
        const Long share = at.polar / long_pi;
        return {static_cast<Real>(at.around / (2 * long_pi)),
                static_cast<Real>(at.beyond ? share : 1 - share)};
    }
    const Long polar = at.beyond ? long_pi - at.polar : at.polar;
    const Long r = map == SkyMap::Angular ? polar / long_pi : std::sin(polar / 2);
    return {static_cast<Real>((1 + r * std::cos(at.around)) / 2),
            static_cast<Real>((1 + r * std::sin(at.around)) / 2)};
}

const std::array maps{SkyMap::LatitudeLongitude, SkyMap::MirrorBall, SkyMap::Angular};

}  // namespace

TEST_CASE("the place of any direction, however close to a pole, the middle or the rim, and of any length",
          "[11.4][stability]") {
    Random random(1182);
    for (int i = 0; i < cases(30000); ++i) {
        const SkyMap map = maps[random.index(3)];
        const Angles at = any_angles(random);
        const Real size = random.index(2) == 0 ? 1 : random.magnitude(-280, 300);
        const Vec3 direction = direction_at(map, at, size);
        const Vec2 expected = place_at(map, at);
        const Vec2 uv = sky_uv(map, direction);
        INFO(name(map) << ", direction " << direction);
        // 16u, and the directions' own rounding and the places'.
        const Real bound = 18 * unit_roundoff;
        Real u = uv.x;
        const bool world = map == SkyMap::LatitudeLongitude;
        if (world) {
            CHECK((u >= 0 && u <= 1));
            if (std::abs(u - expected.x) > 0.5) u += expected.x > 0.5 ? 1 : -1;
        }
        CHECK(test::near(Vec2(u, uv.y), expected, bound));
    }
}

TEST_CASE("axis directions whose zeros have either sign", "[11.4][stability]") {
    for (const Real a : {0.0, -0.0})
        for (const Real b : {0.0, -0.0})
            for (const Real sign : {1.0, -1.0}) {
                const Vec2 pole = sky_uv(SkyMap::LatitudeLongitude, {a, sign, b});
                INFO("zeros " << a << " and " << b << ", sign " << sign);
                CHECK((pole.x >= 0 && pole.x <= 1));
                CHECK(test::near(pole.y, sign > 0 ? 1.0 : 0.0, unit_roundoff));
                const Vec2 ball = sky_uv(SkyMap::MirrorBall, {a, b, sign});
                CHECK(test::near(ball, Vec2(sign > 0 ? 0.5 : 1, 0.5), unit_roundoff));
                const Vec2 probe = sky_uv(SkyMap::Angular, {a, b, sign});
                CHECK(test::near(probe, Vec2(sign < 0 ? 0.5 : 1, 0.5), unit_roundoff));
            }
}

TEST_CASE("the direction at any place, up to the edges and the rim", "[11.5][stability]") {
    Random random(1183);
    const Real u = unit_roundoff;
    for (int i = 0; i < cases(30000); ++i) {
        const SkyMap map = maps[random.index(3)];
        const bool world = map == SkyMap::LatitudeLongitude;
        const auto coordinate = [&] {
            const Real tiny = random.magnitude(-17, -1);
            const std::array<Real, 4> any{random.uniform(0, 1), tiny, 1 - tiny, 0.5 + (world ? 0 : tiny)};
            return any[random.index(4)];
        };
        const Vec2 uv{coordinate(), coordinate()};
        const Long a = 2 * Long(uv.x) - 1, b = 2 * Long(uv.y) - 1, r2 = a * a + b * b, r = std::sqrt(r2);
        const std::optional<Vec3> direction = sky_direction(map, uv);
        INFO(name(map) << " picture at " << uv << ", direction " << direction);
        if (!world && r > 1 + 8 * u) {
            CHECK_FALSE(direction.has_value());
            continue;
        }
        if (!world && r > 1 - 8 * u) continue;
        REQUIRE(direction.has_value());
        CHECK(test::near(length(*direction), 1, 8 * u));
        // What a place 16u away shows: the slope is 2π, but 4/√(1 − r²) on the ball.
        Vec3 expected{0};
        Real slope = 2 * pi;
        if (world) {
            const Long height = std::sin(long_pi / 2 * b), level = std::cos(long_pi / 2 * b);
            expected = {static_cast<Real>(-level * std::cos(long_pi * a)), static_cast<Real>(height),
                        static_cast<Real>(-level * std::sin(long_pi * a))};
        } else if (map == SkyMap::Angular) {
            const Long away = r > 0 ? std::sin(long_pi * r) / r : long_pi;
            expected = {static_cast<Real>(away * a), static_cast<Real>(away * b),
                        static_cast<Real>(-std::cos(long_pi * r))};
        } else {
            const Long n = std::sqrt(1 - r2);
            expected = {static_cast<Real>(2 * n * a), static_cast<Real>(2 * n * b),
                        static_cast<Real>(n * n - r2)};
            slope = 4 / static_cast<Real>(n);
        }
        CHECK(test::near(*direction, expected, 16 * u * slope + 8 * u));
    }
}

TEST_CASE("a gradient's colour for directions of any length", "[11.4][stability]") {
    Random random(1184);
    for (int i = 0; i < cases(3000); ++i) {
        const GradientSky sky{random.in_cube(), random.in_cube(), random.in_cube()};
        const Vec3 d = random.direction();
        const Vec3 direction = d * random.magnitude(-290, 300);
        const Vec3 end = d.y > 0 ? sky.zenith : sky.nadir;
        const Real share = std::abs(d.y) / length(d);
        INFO("direction " << direction);
        const Real most = std::max({size_of(sky.zenith), size_of(sky.horizon), size_of(sky.nadir)});
        // 8u of the promise, and as much for what is expected.
        CHECK(test::near(gradient_color(sky, direction), sky.horizon * (1 - share) + end * share,
                         16 * unit_roundoff * most));
    }
}
