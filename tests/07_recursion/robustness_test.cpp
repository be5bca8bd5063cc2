// Step 07.6: whatever a scene says, what leaves the shading is finite.
#include "chapters/07_recursion/radiance.hpp"

#include "common/math/error.hpp"
#include "common/math/input_error.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <string>

using namespace rt;
using namespace rt::test;

namespace {

const std::string frame = "size 16 12\nmaxdepth 4\ncamera 0 1 5 0 0 0 0 1 0 60\n";

Scene scene_of(const std::string& text) { return parse_scene_text(frame + text, "test.scene"); }

/// How many pixels are not finite, and whether anything is to be seen at all.
struct Look {
    int bad = 0;
    bool bright = false;
};
Look look_at(const Scene& scene) {
    Look look;
    for (const Vec3& color : render(compile(scene), {1, {}}).image.pixels) {
        look.bad += !is_finite(color);
        look.bright = look.bright || color.x > 0;
    }
    return look;
}
void check_finite(const Scene& scene) {
    const Look look = look_at(scene);
    INFO("how many pixels are not finite");
    CHECK(look.bad == 0);
    CHECK(or_say(look.bright, "all pixels are black"));
}

const std::string shiny = "diffuse .5 .5 .5\nspecular .5 .5 .5\n";

}  // namespace

TEST_CASE("normals of length zero at a smooth triangle's corners", "[07.6]") {
    // The parser refuses them, so they are put into the scene behind its back.
    Scene scene = scene_of(shiny +
                           "point 0 2 3 1 1 1\nshininess 10\n"
                           "vertexnormal -2 -2 0 0 0 1\nvertexnormal 2 -2 0 0 0 1\nvertexnormal 0 2 0 0 0 1\n"
                           "trinormal 0 1 2\n");
    SECTION("all") {
        for (SmoothVertex& v : scene.smooth_vertices) v.normal = Vec3(0);
    }
    SECTION("one") { scene.smooth_vertices[1].normal = Vec3(0); }
    SECTION("three that cancel") {
        scene.smooth_vertices[0].normal = {1, 0, 0};
        scene.smooth_vertices[1].normal = {-1, 0, 0};
        scene.smooth_vertices[2].normal = Vec3(0);
    }
    SECTION("tiny and huge") {
        scene.smooth_vertices[0].normal = {0, 0, 1e-300};
        scene.smooth_vertices[1].normal = {0, 0, 1e300};
    }
    check_finite(scene);
}

TEST_CASE("a light without a direction is an error, not a NaN", "[07.6]") {
    CHECK_THROWS_AS(scene_of("directional 0 0 0 1 1 1\n"), InputError);
}

TEST_CASE("lights whose directions are tiny or huge", "[07.6]") {
    for (const char* size : {"1e-300", "1e-20", "1e20", "1e300"}) {
        const std::string s = size;
        check_finite(scene_of("directional 0 " + s + " " + s + " 1 1 1\n" + shiny + "sphere 0 0 0 1\n"));
    }
}

TEST_CASE("lights on surfaces, in them and on the eye", "[07.6]") {
    check_finite(
        scene_of("attenuation 0 0 1\npoint 0 0 1 1 1 1\npoint 0 0 0 1 1 1\npoint 0 1 5 1 1 1\n"
                 "point 0 -1 0 1 1 1\nambient .1 .1 .1\n" +
                 shiny + "sphere 0 0 0 1\nplane 0 -1 0 0 1 0\n"));
    // Exactly where the middle ray meets the wall.
    const World world =
        compile(parse_scene_text("size 1 1\ncamera 0 0 5 0 0 0 0 1 0 60\nattenuation 0 0 1\n"
                                 "point 0 0 0 1 1 1\nambient .25 .25 .25\n" +
                                     shiny + "plane 0 0 0 0 0 1\n",
                                 "test.scene"));
    const Vec3 color = radiance(world, {{0, 0, 5}, {0, 0, -1}});
    INFO("the colour of a pixel where a lamp is exactly in the wall: " << color);
    CHECK(or_say(is_finite(color), "it is not finite"));
}

TEST_CASE("highlights with exponent 0 and a million", "[07.6]") {
    for (const char* form : {"blinn", "phong"})
        for (const char* shininess : {"0", "1e6"})
            check_finite(scene_of(std::string("point 0 1 5 1 1 1\npoint 0 3 -9 1 1 1\nhighlight ") + form +
                                  "\nshininess " + shininess + "\n" + shiny +
                                  "sphere 0 0 0 1\nplane 0 -1 0 0 1 0\n"));
}

TEST_CASE("a million lights add up to one of their sum", "[07.6]") {
    const int count = cases(1'000'000);
    Scene many = scene_of("ambient 0 0 0\n" + shiny + "sphere 0 0 0 1\nsphere 0 9 9 1\n");
    Scene one = many;
    one.lights.push_back(PointLight{{0, 3, 5}, Vec3(1)});
    for (int i = 0; i < count; ++i) many.lights.push_back(PointLight{{0, 3, 5}, Vec3(1.0 / count)});
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    const Vec3 expected = radiance(compile(one), ray), actual = radiance(compile(many), ray);
    INFO("the red channel with " << count << " lights, expected that with one of their sum");
    CHECK(expected.x > 0);
    // Sums of n equal terms are off by nu at most.
    CHECK(near(actual.x, expected.x, count * unit_roundoff * 2 * expected.x));
}

TEST_CASE("a thousand bounces in a room of mirrors and glass", "[07.6]") {
    check_finite(
        scene_of("maxdepth 1000\nmincontribution .01\npoint 0 2 3 1 1 1\nshininess 20\n"
                 "diffuse .1 .1 .1\nspecular .99 .99 .99\nplane 0 0 -4 0 0 1\nplane 0 0 6 0 0 -1\n"
                 "specular .3 .3 .3\ntransmission .6 .6 .6\nior 1.5\nsphere 0 0 0 1\n"));
}

TEST_CASE("glass of every kind", "[07.6]") {
    for (const char* ior : {"1e-6", "0.5", "1", "1.0000000000000002", "1.5", "1e6"})
        for (const char* law : {"none", "exact", "schlick"}) {
            INFO("ior " << ior << ", fresnel " << law);
            check_finite(scene_of(
                std::string("background .5 .5 .5\ntransmission 1 1 1\nabsorption 0 1e-300 1e300\nior ") +
                ior + "\nfresnel " + law + "\nsphere 0 0 0 1\nsphere .5 0 0 1\n"));
        }
}

TEST_CASE("triangles without area, needles and huge spheres, in mirrors and in glass", "[07.6]") {
    check_finite(scene_of("point 0 4 4 1 1 1\n" + shiny +
                          "vertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\nvertex 0 1e-12 0\nvertex -3 -3 -3\n"
                          "vertex 3 -3 -3\nvertex 0 3 -3\ntri 0 1 2\ntri 0 0 0\ntri 0 1 3\ntri 4 5 6\n"
                          "sphere 0 -1e9 0 999999999\nsphere 0 0 0 1e-12\n"
                          "transmission .5 .5 .5\nior 1.5\nsphere 1 0 0 1\n"));
}
