// How large and small the numbers of a scene may be: in range the picture is right, whatever the scale; out
// of range the scene is refused at its line. The first case of most of these came from the field.
#include "common/scene/range.hpp"
#include "common/image/file.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

std::string error_in(const std::string& text) {
    return test::error_of([&] { world_of(text); });
}

const std::string camera = "size 20 20\ncamera .3 .2 5 0 0 0 0 1 0 20\nbackground 0 0 1\n";
const std::string lit = "ambient 0 0 0\ndiffuse 1 1 1\nshadows off\ndirectional 0 0 1 1 1 1\n";

int white_pixels(const Image& image) {
    return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), Vec3(1)));
}

}  // namespace

// Directions of any length --------------------------------------------------------------------------------

TEST_CASE("a plane's normal may have any length but 0", "[range]") {
    for (const char* z : {"1e200", "1e-200", "1.7e308", "5e-324", "-1e200"})
        for (const char* transform : {"", "scale 1e10 1e10 1e10\n", "scale 1 2 1e-10\n"}) {
            INFO("normal 0 0 " << z << ", " << transform);
            CHECK(white_pixels(picture_of(camera + lit + transform + "plane 0 0 0 0 0 " + z + "\n")) == 400);
        }
    // A power of two changes no bit.
    const Image one = picture_of(camera + lit + "plane 0 0 -1 .3 .4 1.7\n");
    for (const int k : {-900, -3, 2, 900}) {
        const std::string normal =
            fmt::format("{} {} {}", std::ldexp(.3, k), std::ldexp(.4, k), std::ldexp(1.7, k));
        CHECK(differing(picture_of(camera + lit + "plane 0 0 -1 " + normal + "\n"), one) == 0);
    }
}

TEST_CASE("a vector is brought near 1 without a rounding, whatever its length", "[range]") {
    const Vec3 v(-1.9, 0x1.23456789abcdep-20, 0.3);
    for (int exponent = -1080; exponent <= 1023; ++exponent) {
        const Vec3 there(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
        const Vec3 near = near_one(there);
        INFO("times 2^" << exponent << ": " << there << " becomes " << near);
        if (there == Vec3(0)) {
            CHECK(near == there);
            continue;
        }
        CHECK((size_of(near) >= 1 && size_of(near) < 2));
        // Tiny numbers have lost digits before.
        const int back = std::ilogb(near.x) - std::ilogb(there.x);
        CHECK(near == Vec3(std::ldexp(there.x, back), std::ldexp(there.y, back), std::ldexp(there.z, back)));
        if (exponent > -1000) CHECK(near == v);
    }
}

TEST_CASE("a camera may look at a near point or a far one, with an up direction of any length", "[range]") {
    const std::string ball = "integrator normals\nsphere .2 .1 -5 1\n", rest = " 40\nsize 20 20\n";
    const auto look = [&](int at, int up) {
        return picture_of(fmt::format("camera 0 0 0 {} {} {} 0 {} 0", std::ldexp(.25, at), std::ldexp(.5, at),
                                      -std::ldexp(1., at), std::ldexp(1., up)) +
                          rest + ball);
    };
    const Image expected = look(0, 0);
    for (const int at : {-1060, -600, -20, 90})
        for (const int up : {-1060, 0, 1000}) {
            INFO("look at 2^" << at << ", up 2^" << up);
            CHECK(differing(look(at, up), expected) == 0);
        }
}

// Scales --------------------------------------------------------------------------------------------------

namespace {

/// A scene with one of everything, all its lengths times `s`.
std::string everything(Real s, const std::string& more) {
    const auto l = [s](std::initializer_list<Real> lengths) {
        std::string text;
        for (const Real x : lengths) text += fmt::format(" {}", s * x);
        return text;
    };
    const std::string corners = "vertex" + l({-1, 0, 0}) + "\nvertex" + l({1, 0, 0}) + "\nvertex" +
                                l({1, 1.5, 0}) + "\nvertex" + l({-1, 1, 0}) + "\n";
    return "size 40 30\ncamera" + l({1, 2, 7, 0, 0.5, 0}) + " 0 1 0 45\nbackground .2 .3 .4\nmaxdepth 6\n" +
           "point" + l({3, 5, 4}) + " .7 .7 .7\ndirectional -1 2 1 .3 .3 .3\n" + more + corners +
           "diffuse .5 .4 .3\nchecker 1 1 1 .2 .2 .2" + l({0.75}) + "\nplane" + l({0, -1, 0}) + " 0 1 0\n" +
           "checker 1 1 1 1 1 1 1\nspecular .3 .3 .3\nshininess 20\n"
           "pushTransform\ntranslate" +
           l({-2, 0, -2}) +
           "\nrotate 1 2 3 40\npolygon 0 1 2 3\npopTransform\n"
           "pushTransform\ntranslate" +
           l({2, 0, -2}) +
           "\nrotate 1 -2 3 40\ntri 0 1 2\npopTransform\n"
           "pushTransform\ntranslate" +
           l({0, 0.5, -2}) + "\nrotate 1 1 0 30\nscale 1.5 1 .25\nsphere 0 0 0" + l({1}) +
           "\npopTransform\n"
           "pushTransform\ntranslate" +
           l({-1.5, 0, 1}) + "\nscale" + l({0.5, 0.75, 0.5}) +
           "\nmesh range_pyramid.obj\npopTransform\n"
           "pushTransform\ntranslate" +
           l({1.5, 0, 1}) + "\nrotate 0 1 0 30\nscale" + l({0.75, 0.5, 0.5}) +
           "\nmesh range_pyramid.obj\npopTransform\n"
           "sphere" +
           l({2.5, -0.5, 1, 0.5}) +
           "\ntransmission .8 .9 .8\nior 1.5\nfresnel exact\n"
           "sphere" +
           l({0, 0, 1.5, 0.75}) + "\n";
}

void write_pyramid() {
    write_file(std::filesystem::path(scratch_directory()) / "range_pyramid.obj",
               "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 2 0\nvn 0 -1 0\nvn 1 1 0\nvn -1 1 0\n"
               "f 4//1 3//1 2//1\nf 4//1 2//1 1//1\nf 1//3 2//2 5//2\nf 2//2 3//2 5//3\nf 3//2 4//3 5//3\n"
               "f 4//3 1//3 5//2\n");
}

}  // namespace

TEST_CASE("a scene has the same picture at every scale that is possible, with every accelerator", "[range]") {
    write_pyramid();
    const Image expected = picture_of(everything(1, "accelerator none\n"));
    CHECK(std::count(expected.pixels.begin(), expected.pixels.end(), Vec3(0.2, 0.3, 0.4)) < 600);
    // The longest length is 7 and the shortest half-axis 0.25: 7·2^96 < 1e30 and 0.25·2^-96 > 1e-30.
    for (const int k : {-96, -70, -31, 31, 70, 96})
        for (const char* accelerator : {"accelerator none\n", "accelerator grid\n", "accelerator nested\n"}) {
            const Image image = picture_of(everything(std::ldexp(Real(1), k), accelerator));
            INFO("lengths times 2^" << k << ", " << accelerator);
            CHECK(differing(image, expected) == 0);
        }
}

TEST_CASE("so do the other integrators and a parallel projection", "[range]") {
    write_pyramid();
    const auto text = [](const std::string& integrator, Real s) {
        return "size 24 24\nintegrator " + integrator +
               fmt::format("\ncamera {} {} {} 0 0 0 0 1 0 45\n", s, s, 4 * s) +
               (integrator == "uv" ? fmt::format("orthographic {}\n", 4 * s) : "") +
               fmt::format(
                   "scale {} {} {}\nmesh range_pyramid.obj\ntranslate 0 0 -2\nmesh range_pyramid.obj\n", s,
                   s / 2, s);
    };
    for (const char* integrator : {"normals", "rasterize", "uv", "flat"}) {
        const Image expected = picture_of(text(integrator, 1));
        for (const int k : {-96, 96}) {
            INFO(integrator << " at 2^" << k);
            CHECK(differing(picture_of(text(integrator, std::ldexp(Real(1), k))), expected) == 0);
        }
    }
}

TEST_CASE("triangles and balls far out and very small", "[range]") {
    // The field's: right at any scale, as with the powers of ten removed, or refused.
    const std::string look = "background 0 0 1\nintegrator flat\nambient 1 1 1\n";
    for (const char* power : {"", "e28", "e-28", "e20", "e-20"}) {
        const auto l = [power](const std::string& digits) { return " " + digits + power; };
        const std::string triangle = "size 3 3\ncamera 0" + l("1") + l("5") + " 0 0 0 0 1 0 60\n" + look +
                                     "vertex" + l("-9") + l("-1") + l("-9") + "\nvertex" + l("9") + l("-1") +
                                     l("-9") + "\nvertex 0" + l("-1") + l("9") + "\ntri 0 2 1\n";
        const std::string ball =
            "size 1 1\ncamera 0 0" + l("5") + " 0 0 0 0 1 0 20\n" + look + "sphere 0 0 0" + l("1") + "\n";
        INFO("times 1" << power);
        CHECK(white_pixels(picture_of(triangle)) == 6);
        CHECK(white_pixels(picture_of(ball)) == 1);
    }
    CHECK(error_in("size 3 3\ncamera 0 1e120 5e120 0 0 0 0 1 0 60\n") ==
          "test.scene:2:10: coordinates beyond 1e+30 are not possible, and this is 1e+120");
}

// What is refused -----------------------------------------------------------------------------------------

TEST_CASE("what is out of range is an error at its line", "[range]") {
    struct Case {
        std::string commands;  ///< from the second line on
        std::string expected;  ///< how the message goes on after the file's name
    };
    const std::string corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
    const std::vector<Case> cases{
        {"sphere 0 0 0 1e31\n", ":2:1: radii from 1e-30 to 1e+30 can be drawn, but this is 1e+31"},
        {"sphere 0 0 0 1e-160\n", ":2:1: radii from 1e-30 to 1e+30 can be drawn, but this is 1e-160"},
        {"sphere 0 1e160 0 1\n", ":2:1: coordinates beyond 1e+30: a point of this object is at 0 1e+160 0"},
        {"plane 0 -1e200 0 0 1 0\n", ":2:1: coordinates beyond 1e+30"},
        {corners + "vertex 2e40 0 0\ntri 0 1 3\n", ":6:1: coordinates beyond 1e+30"},
        {corners + "vertex 2e40 0 0\npolygon 0 3 2\n", ":6:1: coordinates beyond 1e+30"},
        {"vertex 0 0 0\nvertex 1e-50 0 0\nvertex 0 1e-50 0\ntri 0 1 2\n", ":5:1: faces from 1e-30 to 1e+30"},
        {corners + "scale 1e20 1 1\nscale 1e20 1 1\ntri 0 1 2\n",
         ":6:1: the transform in force after this step has numbers beyond 1e+30"},
        {"scale 1e-20 1 1\nscale 1e-20 1 1\nscale 1e20 1 1\nscale 1e20 1 1\nsphere 0 0 0 1\n",
         ":3:1: the transform in force after this step makes lengths shorter by more than 1e+30"},
        {"scale 1e-200 1e-200 1e-200\nscale 1e200 1e200 1e200\nsphere 0 0 0 1\n",
         ":2:1: the transform in force after this step makes lengths shorter"},
        {"translate 1e31 0 0\ntranslate -1e31 0 0\nsphere 0 0 0 1\n", ":2:1: the transform in force"},
        {"scale 10 10 1e-18\nsphere 0 0 0 1\n", ":3:1: a ball that is flattened too much: by at most 7e+10"},
        {"orthographic 1e-31\n", ":2:14: the height of the view must be from 1e-30 to 1e+30"},
        {"orthographic 3\nsphere 0 0 -1e15 1\n", ":3:1: a ball whose shortest half-axis, 1, is less than"},
        {"point 1e31 0 0 1 1 1\n", ":2:7: coordinates beyond 1e+30"},
        {"point 0 0 0 1 1e200 1\n", ":2:15: colours beyond 1e+30"},
        {"directional 0 0 1 1 1e200 1\n", ":2:21: colours beyond 1e+30"},
        {"diffuse 1 1e154 0\n", ":2:11: colours beyond 1e+30"},
        {"emission 0 0 -1e154\n", ":2:14: colours beyond 1e+30"},
        {"background 1e154 0 0\n", ":2:12: colours beyond 1e+30"},
        {"transmission 1e154 0 0\n", ":2:14: colours beyond 1e+30"},
        {"attenuation 1e-200 0 0\n", ":2:13: an attenuation that is not 0 must be from 1e-30 to 1e+30"},
        {"checker 1 1 1 0 0 0 1e-40\n", ":2:21: the size of the checker's cubes must be from 1e-30 to 1e+30"},
        {"ior 1e-40\n", ":2:5: the index of refraction must be from 1e-30 to 1e+30"},
        {"maxdepth 200\nspecular 2 2 2\nsphere 0 0 0 1\n", ":4:1: the material sends on 2 times the light"},
        {"shadows on\npoint 0 9 0 1 1 1\ndiffuse 1 1 1\ntransmission 1e20 0 0\nmaxdepth 0\nsphere 0 0 0 1\n",
         ":7:1: the material sends on 1e+20 times the light"},
        {"camera 0 0 5 0 0 0 0 1 0 1e-9\n", ":2:26: the field of view must be at least 1e-6 degrees"},
    };
    for (const Case& one : cases) {
        const std::string actual = error_in("camera 0 0 5 0 0 0 0 1 0 40\n" + one.commands);
        INFO(one.commands << "expected: test.scene" << one.expected << "\nactual:   " << actual);
        CHECK(actual.starts_with("test.scene" + one.expected));
    }
}

TEST_CASE("a mesh out of range is refused where it is shown", "[range]") {
    write_file(std::filesystem::path(scratch_directory()) / "range_far.obj",
               "v 0 0 0\nv 1e50 0 0\nv 0 1e50 0\nf 1 2 3\n");
    const std::string head = "camera 0 0 5 0 0 0 0 1 0 40\n";
    CHECK(error_in(head + "mesh range_far.obj\n").starts_with("test.scene:2:1: coordinates beyond 1e+30"));
    CHECK(error_in(head + "mesh range_far.obj\nmesh range_far.obj\n")
              .starts_with("test.scene:2:1: coordinates beyond 1e+30"));
    // Shown once it takes the transform into its corners, and these are in range.
    CHECK(error_in(head + "scale 1e-25 1e-25 1e-25\nmesh range_far.obj\n").empty());
}

TEST_CASE("what is in range, but only just, is drawn", "[range]") {
    const std::string head = "camera 0 0 5 0 0 0 0 1 0 40\n";
    for (const char* commands :
         {"sphere 0 0 0 1e30\n", "vertex -1e30 0 0\nvertex 1e30 0 0\nvertex 0 1e30 0\ntri 0 1 2\n",
          "sphere 0 0 0 1e-30\n", "sphere 1e30 0 0 1\n", "scale 1 1 1e-10\nsphere 0 0 0 1\n",
          "scale 1e10 1e10 1\nsphere 0 0 0 1\n", "vertex 1e-300 0 0\nvertex 1 0 0\nvertex 0 1 0\ntri 0 1 2\n",
          "vertex 1 1 1\ntri 0 0 0\n", "orthographic 3\nsphere 0 0 -1e15 1e-5\n",
          "maxdepth 40\nspecular 2 2 2\nsphere 0 0 0 1\n", "plane 0 0 0 0 1 1e-300\n"}) {
        INFO(commands);
        CHECK(error_in(head + commands).empty());
    }
}

// Flat balls ----------------------------------------------------------------------------------------------

TEST_CASE("a ball flattened to a disc is one, or is refused", "[range]") {
    for (const char* thin : {"1e-4", "1e-6", "1e-8", "1e-9"}) {
        const Image image = picture_of(camera + lit + "scale 10 10 " + thin + "\nsphere 0 0 0 1\n");
        // Its normals lean by 1e-6 at most where the picture shows it, and their cosines differ by the
        // square.
        const auto right = [](const Vec3& color) {
            return std::abs(color.x - 1) <= 1e-12 && color.x == color.y;
        };
        INFO("flattened to " << thin);
        CHECK(std::count_if(image.pixels.begin(), image.pixels.end(), right) == 400);
    }
    CHECK(error_in(camera + lit + "scale 10 10 1e-18\nsphere 0 0 0 1\n")
              .starts_with("test.scene:9:1: a ball that is flattened too much"));
}

TEST_CASE("the rim of a flat disc lies where that of a round plate does", "[range]") {
    // Seen from in front, a ball flattened along the view has the same outline whatever its thickness.
    const std::string look = "size 200 200\nintegrator flat\nambient 1 1 1\ncamera 0 0 5 0 0 0 0 1 0 30\n";
    const Image plate = picture_of(look + "scale 1 1 1e-5\nsphere 0 0 0 1\n");
    for (const char* thin : {"1e-8", "1e-9", "2e-10"}) {
        const Image disc = picture_of(look + "scale 1 1 " + thin + "\nsphere 0 0 0 1\n");
        INFO("flattened to " << thin);
        CHECK(differing(disc, plate) == 0);
    }
}

// Sizes beside each other ---------------------------------------------------------------------------------

TEST_CASE("a ball that is nothing beside its distance shows its front", "[range]") {
    // The only ray runs through its centre, exactly.
    for (const char* radius : {"1e-3", "1", "1e2"}) {
        const Image image = picture_of(std::string("size 1 1\nintegrator normals\nbackground 0 0 0\n"
                                                   "camera 0 0 1e19 0 0 0 0 1 0 40\nsphere 0 0 0 ") +
                                       radius + "\n");
        INFO("radius " << radius << " at 1e19");
        CHECK(image.pixels[0] == Vec3(0.5, 0.5, 1));
    }
}

TEST_CASE("the smallest things beside the largest, and the strongest light, give finite pictures",
          "[range]") {
    const std::string things =
        "size 16 16\ncamera 0 1 5 0 0 0 0 1 0 60\nmaxdepth 6\nattenuation 0 0 1e-30\npoint 0 3 3 1e30 1e30 "
        "1e30\n"
        "attenuation 1 0 0\ndirectional 0 1 1 1e30 0 1e30\ndiffuse 1e30 1e30 0\nshininess 5\n"
        "checker 1e30 1e30 1e30 1 1 1 1e-30\nplane 0 -1 0 0 1 0\nspecular 1e5 0 1\nsphere 0 0 0 1\n"
        "sphere 2 0 0 1e-30\nsphere 0 0 -2e29 1e29\nscale 1e10 1 1\nsphere 0 0 -9 1\n"
        "transmission 1e2 1 0\nior 1e30\nabsorption 1e300 1e-300 0\nfresnel exact\nsphere 0 1 1 .5\n";
    for (const char* more : {"", "spp 4\n", "accelerator grid\n"}) {
        int bad = 0;
        bool bright = false;
        for (const Vec3& color : picture_of(more + things).pixels) {
            bad += !is_finite(color);
            bright = bright || color.x > 1e30;
        }
        INFO(more);
        CHECK(bad == 0);
        CHECK(bright);
    }
}
