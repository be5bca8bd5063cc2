// Scenes as the successor of the base format's course has them: area lights, and the integrators
// `analyticdirect` and `direct`. What a pixel shows is compared with the integral that it stands for, worked
// out here by other formulas, on a fine grid over each light.
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;

namespace {

constexpr int width = 4, height = 3;

/// A floor seen from straight above, from the height 4, in the course's own words and order.
const std::string top =
    "# seen from above\nsize 4 3\noutput above.png\nmaxdepth 5\ncamera 0 4 0  0 0 0  0 0 -1  50\n";
const std::string floor_triangles =
    "maxverts 4\nvertex -9 0 9\nvertex 9 0 9\nvertex 9 0 -9\nvertex -9 0 -9\ntri 0 1 2\ntri 0 2 3\n";

/// Where on the floor the middle of the pixel is.
Vec3 floor_at(int x, int y) {
    const Real half = 4 * std::tan(pi * 25 / 180);
    return {half * width / height * ((x + 0.5) * 2 / width - 1), 0, half * ((y + 0.5) * 2 / height - 1)};
}

/// A lamp as the scene says it.
struct Lamp {
    Vec3 a, ab, ac, light;
};

std::string line_of(const Lamp& lamp) {
    const auto three = [](const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    return fmt::format("quadLight {}  {}  {}  {}\n", three(lamp.a), three(lamp.ab), three(lamp.ac),
                       three(lamp.light));
}

/// Both hang below the eye's height beside what it sees, and shine down.
const Lamp square{{1.2, 2, -0.6}, {0, 0, 1.2}, {1, 0, 0}, {9, 7, 5}};
const Lamp slanted{{-3.2, 1.5, -0.7}, {-0.4, 0.6, 1}, {1.1, -0.2, 0.3}, {2, 4, 6}};

/// Whether a cosine below 0 counts negatively, as in Lambert's formula, or nothing.
enum class Behind { Negative, Nothing };

/// The integral over the lamp of `reflected(direction)` times both cosines over the distance squared.
/// `is_seen` is asked for each point of a grid.
template <class Reflected, class IsSeen>
Vec3 integral(const Lamp& lamp, const Vec3& p, Behind behind, const Reflected& reflected,
              const IsSeen& is_seen) {
    constexpr int n = 300;
    const Vec3 across = glm::cross(lamp.ab, lamp.ac);
    Vec3 sum(0);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const Vec3 x = lamp.a + (i + 0.5) / n * lamp.ab + (k + 0.5) / n * lamp.ac;
            const Real distance = glm::distance(x, p);
            const Vec3 l = (x - p) / distance;
            const Real lamp_side = glm::dot(across, l);
            if (behind == Behind::Nothing && !(lamp_side > 0 && l.y > 0)) continue;
            if (is_seen(x)) sum += reflected(l) * (l.y * lamp_side / (distance * distance * n * n));
        }
    return sum * lamp.light;
}

constexpr auto everywhere = [](const Vec3&) { return true; };

/// Phong's lobe in the course's form, by the angle to the mirror's direction.
Vec3 phong(const Vec3& kd, const Vec3& ks, Real s, const Vec3& l, const Vec3& v) {
    const Vec3 mirror(-v.x, v.y, -v.z);
    const Real angle = std::acos(std::min<Real>(1, glm::dot(mirror, l)));
    return kd / pi + (angle < pi / 2 ? ks * ((s + 2) / (2 * pi) * std::pow(std::cos(angle), s)) : Vec3(0));
}

/// GGX in the course's form, by tangents.
Vec3 ggx(const Vec3& kd, const Vec3& ks, Real alpha, const Vec3& l, const Vec3& v) {
    const Vec3 h = (l + v) / glm::length(l + v);
    const auto tangent2 = [](const Vec3& w) { return 1 / (w.y * w.y) - 1; };
    const auto g = [&](const Vec3& w) { return 2 / (1 + std::sqrt(1 + alpha * alpha * tangent2(w))); };
    const Real d = std::pow(alpha / (h.y * h.y * (alpha * alpha + tangent2(h))), Real(2)) / pi;
    const Vec3 f = ks + (Vec3(1) - ks) * std::pow(1 - glm::dot(l, h), Real(5));
    return kd / pi + f * (d * g(l) * g(v) / (4 * l.y * v.y));
}

/// Of one scene, with other random numbers each.
using Pictures = std::vector<Image>;

Pictures pictures(const std::string& text, int count) {
    Scene scene = parse_scene_text(text, "above.test");
    Pictures all;
    for (int i = 0; i < count; ++i) {
        scene.sampling.seed = static_cast<std::uint64_t>(i);
        all.push_back(render(compile(scene)).image);
    }
    return all;
}

/// By how many of its standard errors the mean of a pixel is off, the worst channel.
Real errors_off(const Pictures& all, int x, int y, const Vec3& truth) {
    const Real n = static_cast<Real>(all.size());
    Vec3 mean(0), squares(0);
    for (const Image& image : all) mean += pixel(image, x, y) / n;
    for (const Image& image : all) {
        const Vec3 off = pixel(image, x, y) - mean;
        squares += off * off / (n * (n - 1));
    }
    return max_component(glm::abs(mean - truth) / glm::sqrt(squares));
}

/// Student's t of 399 degrees of freedom is beyond this once in 4e9, and of the 324 numbers below one is so
/// once in 1e7.
constexpr Real most_errors = 6.5;
constexpr int enough_pictures = 400;

template <class Truth>
void compare(const std::string& text, const Truth& truth) {
    INFO(text);
    const Pictures all = pictures(text, enough_pictures);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3 right = truth(floor_at(x, y));
            INFO("pixel (" << x << ", " << y << "), which is " << right.x << ", " << right.y << ", "
                           << right.z);
            CHECK(errors_off(all, x, y, right) < most_errors);
        }
}

}  // namespace

TEST_CASE("'analyticdirect' shows the integral over each light, and nothing else", "[cse168]") {
    const Vec3 kd(0.6, 0.5, 0.4), ke(0.01, 0.02, 0.03);
    // Highlights, ambient light, other lamps and shadows are not looked at.
    const Image image = render(compile(parse_scene_text(
                                   top + "integrator analyticdirect\nambient .2 .2 .2\npoint 0 3 0 1 1 1\n" +
                                       line_of(square) + line_of(slanted) +
                                       "diffuse .6 .5 .4\nspecular .3 .3 .3\nshininess 20\n"
                                       "emission .01 .02 .03\n" +
                                       floor_triangles + "sphere 1.6 .8 0 .1\n",
                                   "above.test")))
                            .image;
    const auto even = [&](const Vec3&) { return kd / pi; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (x == 3 && y == 1) continue;  // where the ball may be seen
            const Vec3 p = floor_at(x, y);
            const Vec3 right = ke + integral(square, p, Behind::Negative, even, everywhere) +
                               integral(slanted, p, Behind::Negative, even, everywhere);
            INFO("pixel (" << x << ", " << y << ")");
            // The grid's own error is its cells' size squared, over that of the way to the lamp.
            CHECK(length(pixel(image, x, y) - right) < 1e-5 * length(right));
        }
}

TEST_CASE("'analyticdirect' counts what is behind a surface negatively, as its users have it", "[cse168]") {
    // A lamp that stands through the floor.
    const Lamp upright{{2.2, -1, -0.7}, {0, 2.5, 0}, {0, 0, 1.4}, {3, 3, 3}};
    const Image image =
        render(compile(parse_scene_text(top + "integrator analyticdirect\n" + line_of(upright) +
                                            "diffuse .6 .5 .4\n" + floor_triangles,
                                        "above.test")))
            .image;
    const auto even = [](const Vec3&) { return Vec3(0.6, 0.5, 0.4) / pi; };
    for (int x = 0; x < 3; ++x) {
        const Vec3 right = integral(upright, floor_at(x, 1), Behind::Negative, even, everywhere);
        INFO("pixel (" << x << ", 1)");
        CHECK(length(pixel(image, x, 1) - right) < 1e-4 * length(right));
        CHECK(length(integral(upright, floor_at(x, 1), Behind::Nothing, even, everywhere) - right) >
              0.01 * length(right));
    }
}

TEST_CASE("'direct' shows the integral of Phong's lobe and the matte ground, however it is sampled",
          "[cse168]") {
    const Vec3 kd(0.6, 0.5, 0.4), ks(0.3, 0.2, 0.4);
    const auto truth = [&](const Vec3& p) {
        const Vec3 v = glm::normalize(Vec3(0, 4, 0) - p);
        const auto lobe = [&](const Vec3& l) { return phong(kd, ks, 12, l, v); };
        return integral(square, p, Behind::Nothing, lobe, everywhere) +
               integral(slanted, p, Behind::Nothing, lobe, everywhere);
    };
    for (const char* sampled : {"", "lightsamples 9\n", "lightsamples 9\nlightstratify on\n",
                                "lightsamples 7\nlightstratify on\n", "lightchoice one\n"})
        compare(top + "integrator direct\n" + sampled + line_of(square) + line_of(slanted) +
                    "diffuse .6 .5 .4\nspecular .3 .2 .4\nshininess 12\n" + floor_triangles,
                truth);
}

TEST_CASE("'direct' shows the integral of GGX over the matte ground", "[cse168]") {
    const Vec3 kd(0.3, 0.2, 0.1), ks(0.5, 0.6, 0.7);
    for (const Real alpha : {0.25, 1.0}) {
        const auto truth = [&](const Vec3& p) {
            const Vec3 v = glm::normalize(Vec3(0, 4, 0) - p);
            const auto lobe = [&](const Vec3& l) { return ggx(kd, ks, alpha, l, v); };
            return integral(square, p, Behind::Nothing, lobe, everywhere) +
                   integral(slanted, p, Behind::Nothing, lobe, everywhere);
        };
        compare(top + "integrator direct\nlightsamples 9\nlightstratify on\n" + line_of(square) +
                    line_of(slanted) + "brdf ggx\ndiffuse .3 .2 .1\nspecular .5 .6 .7\n" +
                    // α itself, and 1 where the scene says none.
                    (alpha == 1 ? "" : "roughness .25\n") + floor_triangles,
                truth);
    }
}

TEST_CASE("in 'direct' one light stands in the other's way", "[cse168]") {
    // A level lamp halfway below the square one, between the pixels that look past it.
    const Lamp low{{1, 1.1, 0.15}, {0, 0, 0.6}, {0.6, 0, 0}, {1, 2, 3}};
    const auto even = [](const Vec3&) { return Vec3(0.6) / pi; };
    const auto truth = [&](const Vec3& p) {
        const auto is_seen = [&](const Vec3& x) {
            const Vec3 between = p + 1.1 / x.y * (x - p);
            return !(between.x > 1 && between.x < 1.6 && between.z > 0.15 && between.z < 0.75);
        };
        return integral(square, p, Behind::Nothing, even, is_seen) +
               integral(low, p, Behind::Nothing, even, everywhere);
    };
    compare(top + "integrator direct\nlightsamples 9\nlightstratify on\n" + line_of(square) + line_of(low) +
                "diffuse .6 .6 .6\n" + floor_triangles,
            truth);
}

TEST_CASE("'spp' takes the mean over the pixel, and 'gamma' is for the mean", "[cse168]") {
    const std::string scene = top + "integrator direct\nlightsamples 4\n" + line_of(square) +
                              "diffuse .6 .6 .6\n" + floor_triangles;
    const Scene plain = parse_scene_text("spp 16\n" + scene, "above.test");
    const Scene with_gamma = parse_scene_text("spp 16\ngamma 2.2\n" + scene, "above.test");
    CHECK(plain.sampling.count == 16);
    CHECK(plain.gamma == 1);
    CHECK(with_gamma.gamma == 2.2);
    // What is rendered is light, and the file's numbers are powers of it.
    CHECK(render(compile(plain)).image.pixels == render(compile(with_gamma)).image.pixels);
}
