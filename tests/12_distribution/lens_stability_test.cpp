// Steps 12.6 and 12.7 on extreme cases: numbers at the ends, lenses and planes of all sizes, wide views.
#include "chapters/12_distribution/lens.hpp"

#include "common/math/enclosure.hpp"
#include "common/math/error.hpp"
#include "common/math/exact.hpp"
#include "tests/12_distribution/lens_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace rt;
using test::cases;
using test::near;
using test::Random;

namespace {

using Long = long double;
constexpr Long long_pi = std::numbers::pi_v<Long>;

/// A number of [0, 1]: at an end, in the middle or next to one of these, or anywhere.
Real some_number(Random& random) {
    const Real special[] = {0, 5e-324, 1e-300, 0x1p-53, 0.5 - 0x1p-54, 0.5, 0.5 + 0x1p-53, 1 - 0x1p-53, 1};
    switch (random.index(4)) {
        case 0:
            return special[random.index(std::size(special))];
        case 1:
            return 0.5 + random.sign() * random.magnitude(-16, -0.31);
        case 2:
            return random.magnitude(-300, 0);
        default:
            return random.uniform(0, 1);
    }
}

Vec2 some_pair(Random& random) {
    const Real x = some_number(random), y = some_number(random);
    return {x, y};
}

/// The circle's radius, and how far around it the point is, in eighths of a turn: that is how far it is
/// around the square, from the middle of the right side, in halves of a side.
struct OnCircle {
    Long radius, eighths;
};

OnCircle on_circle(const Vec2& random) {
    const Long a = 2 * Long(random.x) - 1, b = 2 * Long(random.y) - 1;
    const Long r = std::max(std::abs(a), std::abs(b));
    if (r == 0) return {0, 0};
    if (a == r) return {r, b >= 0 ? b / r : 8 + b / r};
    if (b == r) return {r, 2 - a / r};
    if (a == -r) return {r, 4 - b / r};
    return {r, 6 + a / r};
}

Vec2 exact_disc_point(const Vec2& random) {
    const auto [r, eighths] = on_circle(random);
    const Long phi = eighths * long_pi / 4;
    return Vec2(static_cast<Real>(r * std::cos(phi)), static_cast<Real>(r * std::sin(phi)));
}

Vec2 exact_polygon_point(int sides, Real turn, const Vec2& random) {
    const auto [r, eighths] = on_circle(random);
    const Long way = eighths / 8 * sides;
    const int first = static_cast<int>(way);
    const Long one = Long(turn) + 2 * long_pi * first / sides, other = one + 2 * long_pi / sides;
    const Long part = way - first;
    const Long x = std::cos(one) + part * (std::cos(other) - std::cos(one));
    const Long y = std::sin(one) + part * (std::sin(other) - std::sin(one));
    return Vec2(static_cast<Real>(r * x), static_cast<Real>(r * y));
}

/// How far x is from the nearest number that is enclosed.
Real outside(const Enclosure& a, Real x) { return std::max({a.low - x, x - a.high, Real(0)}); }

Enclosure exactly(Real x) { return {x, x}; }

/// The direction of a lens's ray, enclosed: a·u + b·v − w less the place on the lens in units of the
/// distance.
std::array<Enclosure, 3> enclosed_direction(const View& view, const Lens& lens, Real x, Real y,
                                            const Vec2& on_lens) {
    const Enclosure pixel = exactly(2 * view.half_height) / exactly(view.height);
    const bool perspective = view.projection == Projection::Perspective;
    const Enclosure none = exactly(0);
    const Enclosure a = perspective ? pixel * (exactly(x) - exactly(view.width / 2.0)) : none;
    const Enclosure b = perspective ? pixel * (exactly(view.height / 2.0) - exactly(y)) : none;
    const Enclosure ratio = lens.distance == infinity ? none : exactly(lens.radius) / exactly(lens.distance);
    const Enclosure right = a - ratio * exactly(on_lens.x), up = b - ratio * exactly(on_lens.y);
    std::array<Enclosure, 3> aim;
    Enclosure square = none;
    for (int k = 0; k < 3; ++k) {
        Enclosure& along = aim[static_cast<std::size_t>(k)];
        along = right * exactly(view.frame.u[k]) + up * exactly(view.frame.v[k]) - exactly(view.frame.w[k]);
        square = square + power(along, 2);
    }
    for (Enclosure& along : aim) along = along / sqrt(square);
    return aim;
}

}  // namespace

TEST_CASE("points of the disc from extreme and middle random numbers", "[12.6][stability]") {
    Random random(126001);
    for (int i = 0; i < cases(20'000); ++i) {
        const Vec2 numbers = some_pair(random);
        const Vec2 p = disc_point(numbers);
        INFO("the disc's point for the random numbers " << numbers);
        CHECK(near(p, exact_disc_point(numbers), gamma(16)));
        CHECK(length(p) <= 1 + gamma(32));
    }
}

TEST_CASE("points of polygons of few sides and of a million, turned by all angles", "[12.6][stability]") {
    Random random(126002);
    for (int i = 0; i < cases(20'000); ++i) {
        const Vec2 numbers = some_pair(random);
        const int sides =
            i % 2 == 0 ? 3 + static_cast<int>(random.index(9)) : static_cast<int>(random.magnitude(0.5, 6));
        const Real turn = random.sign() * random.magnitude(-3, 3);
        const Vec2 p = polygon_point(sides, turn, numbers);
        INFO("the point of a polygon of " << sides << " sides, turned by " << turn
                                          << ", for the random numbers " << numbers);
        CHECK(near(p, exact_polygon_point(sides, turn, numbers), gamma(64) * (1 + std::abs(turn))));
    }
}

TEST_CASE("directions for lenses of all sizes, focus at all distances, views of up to 170 degrees",
          "[12.7][stability]") {
    Random random(127001);
    for (int i = 0; i < cases(10'000); ++i) {
        const Projection projection = i % 4 == 0 ? Projection::Orthographic : Projection::Perspective;
        View view = test::some_view(random, projection);
        Lens lens;
        lens.distance = i % 10 == 0 ? infinity : random.magnitude(-100, 100);
        lens.radius = (i % 10 == 0 ? 1 : lens.distance) * random.magnitude(-8, 8);
        // The eye from the world's origin to 1e12 distances away.
        view.eye = (i % 10 == 0 ? 1 : lens.distance) * random.magnitude(-6, 12) * random.in_cube();
        const Real x = random.uniform(0, view.width), y = random.uniform(0, view.height);
        const Vec2 on_lens = disc_point(some_pair(random));
        const Ray ray = lens_ray(view, lens, x, y, on_lens);
        INFO(view.width << " x " << view.height << " pixels, half height " << view.half_height << ", eye "
                        << view.eye << "\n"
                        << view.frame << "\nlens of radius " << lens.radius << ", in focus at "
                        << lens.distance << ", the point (" << x << ", " << y << ") of the picture, "
                        << on_lens << " of the lens: " << ray);
        const auto expected = enclosed_direction(view, lens, x, y, on_lens);
        for (int k = 0; k < 3; ++k) {
            const Enclosure along = expected[static_cast<std::size_t>(k)];
            INFO("coordinate " << k << " of the direction, expected in " << along);
            // The enclosure is a few roundings wide itself, and far from it nothing is a number.
            REQUIRE(width_of(along) <= gamma(64) * test::direction_bound(view) / gamma(16));
            CHECK(outside(along, ray.direction[k]) <= test::direction_bound(view));
        }
        CHECK(near(length(ray.direction), 1, gamma(8)));
        const Ray middle = pixel_ray(view, x, y);
        const Vec3 beside = lens.radius * (on_lens.x * view.frame.u + on_lens.y * view.frame.v);
        const Real picture = projection == Projection::Orthographic
                                 ? 2 * view.half_height * (1 + Real(view.width) / view.height)
                                 : 0;
        const Real error = gamma(16) * (length(view.eye) + picture + lens.radius);
        CHECK(near(ray.origin, middle.origin + beside, error));
    }
}

TEST_CASE("the blur at all depths, by exact sums", "[12.7][stability]") {
    Random random(127002);
    for (int i = 0; i < cases(20'000); ++i) {
        Lens lens;
        lens.radius = random.magnitude(-100, 100);
        lens.distance = random.magnitude(-90, 90);
        const Real depth = i % 3 == 0   ? lens.distance * random.nudge()
                           : i % 3 == 1 ? lens.distance * random.magnitude(-8, 8)
                                        : lens.distance * (1 + random.sign() * random.magnitude(-16, -1));
        const Real blur = blur_radius(lens, depth);
        INFO("lens of radius " << lens.radius << ", in focus at " << lens.distance << ", depth " << depth
                               << ": blur " << blur);
        REQUIRE(std::isfinite(blur));
        REQUIRE(blur >= 0);
        // blur·depth against radius·|depth − distance|, a little more and a little less.
        const auto beyond = [&](Real factor) {
            const Real sign = depth < lens.distance ? -1 : 1;
            ExactSum sum;
            sum.add(blur, depth);
            sum.subtract(factor * sign, lens.radius, depth);
            sum.add(factor * sign, lens.radius, lens.distance);
            return sum.sign();
        };
        CHECK(beyond(1 - gamma(6)) >= 0);
        CHECK(beyond(1 + gamma(6)) <= 0);
    }
}
