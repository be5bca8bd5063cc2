// Snapshots: the still pictures of which a blurred one is the mean.
#include "common/render/snapshots.hpp"

#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace rt;

namespace {

constexpr auto head = "size 8 6\ncamera 0 0 5  0 0 0  0 1 0  50\n";

Scene scene_of(const std::string& commands) { return parse_scene_text(head + commands, "small.scene"); }

std::vector<Snapshot> snapshots(const std::string& commands) { return snapshots_of(scene_of(commands)); }

template <class... Line>
std::string lines(const Line&... line) {
    return (std::string() + ... + std::string(line));
}

constexpr auto ball = "diffuse 1 1 1\nsphere 0 0 0 1\n";
constexpr auto lamp = "lightsampling area\nquadLight -1 3 -1  0 0 2  2 0 0  1 1 1\n";

}  // namespace

TEST_CASE("only what blurs has snapshots: its samples, or many", "[snapshots]") {
    const std::string regular = "spp 4\nsampler regular\n";
    CHECK(snapshots(lines(regular, ball)).empty());
    CHECK(snapshots(lines(regular, "lens 0 4\nmotion 0 0 0\n", ball)).empty());
    CHECK(snapshots(lines(regular, "motion 1 0 0\n")).empty());  // nothing that moves
    CHECK(snapshots(lines(regular, "pushTransform\nspin 1 0 0 9\npopTransform\n", ball)).empty());
    CHECK(snapshots(lines(regular, "integrator flat\n", lamp, ball)).empty());
    CHECK(snapshots(lines(regular, "integrator directions\nmotion 1 0 0\n", ball)).empty());
    for (const std::string text :
         {"lens .1 4\n", "cameramotion 1 0 0\n", "motion 1 0 0\n", "spin 0 1 0 9\n", lamp}) {
        INFO(text);
        CHECK(snapshots(lines(regular, text, ball)).size() == 4);
        CHECK(snapshots(lines("spp 16\nsampler trapezoid\n", text, ball)).size() == 16);
        CHECK(snapshots(lines("spp 10\nsampler centered\n", text, ball)).size() == 10);
        CHECK(snapshots(lines("sampler regular\n", text, ball)).size() == 1);
        CHECK(shares_samples(scene_of(lines(regular, text, ball))));
        CHECK(snapshots(lines(text, ball)).size() == 128);
        for (const char* sampler : {"random", "jittered", "poisson", "sobol"}) {
            const std::string other = fmt::format("spp 4\nsampler {}\n{}{}", sampler, text, ball);
            CHECK(snapshots(other).size() == 128);
            CHECK_FALSE(shares_samples(scene_of(other)));
        }
    }
    for (const char* own : {"lightsampling angle\n", "lightchoice one\n"}) {
        CHECK(snapshots(lines(regular, lamp, own, ball)).size() == 128);
        CHECK_FALSE(shares_samples(scene_of(lines(regular, lamp, own, ball))));
    }
}

TEST_CASE("of many lights there are fewer snapshots, each with all of them", "[snapshots]") {
    const auto count = [](int lights) {
        std::string text = ball;
        for (int i = 0; i < lights; ++i) text += fmt::format("sphereLight {} 5 0 .1 1 1 1\n", i);
        return snapshot_count(scene_of(text));
    };
    CHECK(count(16) == 128);
    CHECK(count(40) == 102);
    CHECK(count(1000) == 64);
    const auto all = snapshots(
        lines("lightchoice one\nlightsamples 4\n", lamp, "quadLight -1 4 -1  0 0 2  2 0 0  1 1 1\n", ball));
    REQUIRE(all.size() == 128);
    // One point of each, that is all of its light.
    Real x = 0;
    for (const Snapshot& one : all) {
        REQUIRE(one.lights.size() == 2);
        CHECK(one.lights[0].color.x == Approx(4 / pi));
        CHECK(one.lights[0].point.y == Approx(3));
        CHECK(one.lights[1].point.y == Approx(4));
        x += one.lights[0].point.x * one.lights[1].point.x;
    }
    CHECK(std::abs(x / 128) < 0.05);  // where one is says nothing of where the other is
}

TEST_CASE("snapshots spread over the pixel, the lens, the time and the lights", "[snapshots]") {
    const auto all =
        snapshots(lines("spp 64\nsampler regular\nlens .5 4\nmotion 1 0 0\nlightsamples 2\n", lamp, ball));
    REQUIRE(all.size() == 64);
    Real weight = 0, time = 0, farthest = 0;
    Vec2 at(0), lens(0);
    for (const Snapshot& one : all) {
        weight += one.weight, time += one.weight * one.time;
        at += one.weight * one.at, lens += one.weight * one.lens;
        farthest = std::max(farthest, length(one.lens));
        CHECK(length(one.lens) <= 0.5 * (1 + 1e-12));
        CHECK(one.time >= 0);
        CHECK(one.time <= 1);
        REQUIRE(one.lights.size() == 2);
        for (const FacingLight& light : one.lights) {
            CHECK(light.point.y == Approx(3));
            CHECK(std::abs(light.point.x) <= 1);
            CHECK(std::abs(light.point.z) <= 1);
            CHECK(light.normal.y == Approx(-1));
            CHECK(light.color.x == Approx(4 / pi / 2));  // its area is 4
        }
    }
    CHECK(weight == Approx(1));
    CHECK(time == Approx(0.5));
    CHECK(at.x == Approx(0.5));
    CHECK(at.y == Approx(0.5));
    CHECK(length(lens) < 1e-12);
    CHECK(farthest > 0.4);
}

TEST_CASE("a scene at a time is still, and is what the renderer sees then", "[snapshots]") {
    const std::string commands =
        "directional 1 2 3 .5 .5 .5\nspp 4\nsampler regular\nshutter .25 .25\ncameramotion .2 -.1 .3\n"
        "background .1 .2 .3\n"
        "diffuse .5 .6 .7\nmotion .5 .25 0\nsphere 0 0 0 1\ntranslate 1 0 0\nrotate 0 0 1 30\nbox -1 -1 -2  "
        "0 0 -1\n"
        "motion 0 -.5 0\nunion\nsphere -1 0 0 .5\nbox 0 0 0  .5 .5 2\nend\nmotion 0 0 0\n"
        "pushTransform\nspin 1 2 3 50\nbox .2 .2 .2  1 .7 2\ntranslate 0 1 0\nspin 0 0 1 400\n"
        "union\nsphere 0 0 0 .3\nbox 0 0 0  1 .1 .1\nend\npopTransform\n"
        "plane 0 -1 0  0 1 0\n";
    const Scene scene = scene_of(commands);
    const Image blurred = render(compile(scene)).image;
    Image mean = make_image(8, 6);
    for (const Snapshot& snapshot : snapshots_of(scene)) {
        Scene still = scene_at(scene, snapshot.time);
        CHECK_FALSE(is_blurred(still));
        still.sampling = {};
        // Its four samples are the pixels of a larger picture.
        still.width *= 2, still.height *= 2;
        const Image image = render(compile(still)).image;
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 8; ++x)
                pixel(mean, x, y) += snapshot.weight * pixel(image, 2 * x + (snapshot.at.x > 0.5),
                                                             2 * y + (snapshot.at.y > 0.5));
    }
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) CHECK(blurred.pixels[i][c] == Approx(mean.pixels[i][c]).epsilon(1e-9));
}

TEST_CASE("a picture of lens, time and area light is the mean of its snapshots, by hand", "[snapshots]") {
    // Straight down on the floor, which a lamp beside the view lights; the camera rises meanwhile.
    const Scene scene = parse_scene_text(
        "size 8 6\ncamera 0 5 0  0 0 0  0 0 -1  40\nspp 16\nsampler regular\nlens .3 4\ncameramotion 0 .5 0\n"
        "lightsamples 3\nlightstratify on\nlightsampling area\nquadLight 3 1.5 -1  0 0 2  1 0 0  4 5 6\n"
        "ambient 0 0 0\ndiffuse .5 .5 .5\nplane 0 0 0  0 1 0\n",
        "small.scene");
    const std::vector<Snapshot> all = snapshots_of(scene);
    REQUIRE(all.size() == 16);
    const Image image = render(compile(scene)).image;
    const Real high = std::tan(radians(20));
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) {
            Vec3 sum(0);
            for (const Snapshot& one : all) {
                const Vec3 eye(0, 5 + 0.5 * one.time, 0), u(1, 0, 0), v(0, 0, -1);
                const Real right = (2 * (x + one.at.x) / 8 - 1) * high * 8 / 6,
                           up = (1 - 2 * (y + one.at.y) / 6) * high;
                const Vec3 focus = eye + Real(4) * (Vec3(0, -1, 0) + right * u + up * v);
                const Vec3 from = eye + one.lens.x * u + one.lens.y * v;
                const Vec3 floor = from + from.y / (from.y - focus.y) * (focus - from);
                for (const FacingLight& light : one.lights) {
                    const Vec3 way = light.point - floor;
                    const Real d2 = dot(way, way);
                    const Real cosines = way.y * std::max(-dot(way, light.normal), Real(0)) / d2;
                    sum += one.weight * 0.5 * light.color * cosines / d2;
                }
            }
            for (int c = 0; c < 3; ++c) CHECK(pixel(image, x, y)[c] == Approx(sum[c]).epsilon(1e-9));
        }
}
