// The export for POV-Ray: statements that mean the same there, and plain words where there are none.
#include "common/povray/export.hpp"
#include "common/povray/exposure.hpp"
#include "common/render/integrators.hpp"
#include "common/render/snapshots.hpp"
#include "common/render/trace.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"
#include "tests/worlds.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

using namespace rt;

namespace {

constexpr auto head = "version 1\nsize 40 30\ncamera 0 0 5  0 0 0  0 1 0  90\n";

std::string exported(const std::string& commands) {
    const Scene scene = parse_scene_text(head + commands, "small.scene");
    return export_povray(scene, snapshots_of(scene));
}

std::string error_of(const std::string& commands) {
    return test::error_of([&] { exported(commands); });
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The numbers after a word, up to the end of its line.
std::vector<Real> numbers_after(const std::string& text, const std::string& word) {
    const std::size_t from = text.find(word) + word.size();
    const std::string line = text.substr(from, text.find('\n', from) - from);
    const std::regex number("[-+]?[0-9]*\\.?[0-9]+(e[-+]?[0-9]+)?");
    std::vector<Real> numbers;
    for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i)
        numbers.push_back(std::stod(i->str()));
    return numbers;
}

}  // namespace

TEST_CASE("a flat scene becomes a whole POV-Ray scene", "[export]") {
    const std::string text = exported(
        "integrator flat\nbackground .1 .2 .3\nambient .5 .25 0\nemission 0 .25 0\nsphere 1 2 -3 .5\n");
    INFO(text);
    CHECK(contains(text, "// small.scene, written by `course export`."));
    CHECK(contains(text, "#version 3.7;"));
    CHECK(contains(text, "assumed_gamma 1 max_trace_level 1 adc_bailout 0"));
    CHECK(contains(text, "background { rgb <0.1, 0.2, 0.3> }"));
    CHECK(contains(text, "pigment { rgb <0.5, 0.5, 0> } finish { ambient 0 diffuse 0 emission 1 }"));
    CHECK(contains(text, "sphere { <1, 2, -3>, 0.5 texture {"));
    CHECK_FALSE(contains(text, "light_source"));
}

TEST_CASE("the camera spans the picture by its basis", "[export]") {
    SECTION("in perspective by tan(fovy/2): twice 1 for 90 degrees") {
        const std::string text = exported("integrator flat\n");
        INFO(text);
        CHECK(contains(text, "perspective"));
        CHECK(contains(text, "location <0, 0, 5>"));
        CHECK(contains(text, "direction <0, 0, -1>"));
        const std::vector<Real> right = numbers_after(text, "right"), up = numbers_after(text, "up");
        REQUIRE(right.size() == 3);
        REQUIRE(up.size() == 3);
        CHECK(right[0] == Approx(2 * 4 / 3.));
        CHECK(up[1] == Approx(2));
    }
    SECTION("in an orthographic view by its height") {
        const std::string text = exported("integrator flat\northographic 3\n");
        INFO(text);
        CHECK(contains(text, "orthographic"));
        CHECK(contains(text, "up <0, 3, 0>"));
        CHECK(contains(text, "right <4, 0, 0>"));
    }
}

TEST_CASE("exported numbers read back as the same double", "[export]") {
    test::Random random(7);
    for (int i = 0; i < test::cases(200); ++i) {
        const Real radius = random.magnitude(-1.9, 3), x = random.magnitude(-12, 3.5);
        const std::vector<Real> read = numbers_after(
            exported(fmt::format("integrator normals\nsphere {:.17g} 0 0 {:.17g}\n", x, radius)), "sphere {");
        CAPTURE(x, radius);
        REQUIRE(read.size() == 4);
        CHECK(read[0] == x);
        CHECK(read[3] == radius);
    }
}

TEST_CASE("the picture of normals is painted by six lights", "[export]") {
    const std::string text = exported("integrator normals\nplane 0 -1 0  0 2 0\n");
    INFO(text);
    CHECK(contains(text, "light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }"));
    CHECK(contains(text, "light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }"));
    CHECK(contains(text, "pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 }"));
    CHECK(contains(text, "plane { <0, 1, 0>, -1 texture { Normal } }"));
    CHECK(exported("integrator rasterize\n") == exported("integrator normals\n"));
}

TEST_CASE("the picture of directions is the inside of a sphere around the eye", "[export]") {
    const std::string text = exported("integrator directions\nsphere 0 0 0 1\n");
    INFO(text);
    CHECK(contains(text, "light_source { <100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }"));
    CHECK(contains(text, "sphere { <0, 0, 5>, 1 texture {"));
    CHECK_FALSE(contains(text, "sphere { <0, 0, 0>"));
    CHECK(contains(exported("integrator directions\northographic 1\n"), "background { rgb <0.5, 0.5, 0> }"));
}

TEST_CASE("shapes are written as POV-Ray's own", "[export]") {
    const std::string vertices = "integrator flat\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex -1 0 0\n";
    CHECK(contains(exported(vertices + "tri 0 1 2\n"), "triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> texture"));
    CHECK(contains(exported(vertices + "polygon 1 2 3\n"),
                   "polygon { 4, <1, 0, 0>, <0, 1, 0>, <-1, 0, 0>, <1, 0, 0> texture"));
    CHECK(contains(
        exported("integrator flat\nvertexnormal 0 0 0 0 0 1\nvertexnormal 1 0 0 0 0 2\n"
                 "vertexnormal 0 1 0 0 1 1\ntrinormal 0 1 2\n"),
        "smooth_triangle { <0, 0, 0>, <0, 0, 1>, <1, 0, 0>, <0, 0, 2>, <0, 1, 0>, <0, 1, 1> texture"));
}

TEST_CASE("a surface that ends at a box is open there, and closed where it is part of a solid", "[export]") {
    const std::string quadric = "quadric 1 1 1 0 0 0 0 0 0 -1  -1 -1 0 1 1 1\n";
    const std::string implicit = "implicit -1 -1 -1 1 1 1 x^2+y-z\n";
    CHECK(contains(exported("integrator flat\n" + quadric), " clipped_by { box {"));
    CHECK(contains(exported("integrator flat\n" + implicit), " open texture"));
    const std::string text = exported("integrator flat\nunion\n" + quadric + implicit + "end\n");
    INFO(text);
    CHECK(contains(text, "merge { intersection { quadric {"));
    CHECK(contains(text, "} box {"));
    CHECK(contains(text, "isosurface {"));
    CHECK_FALSE(contains(text, "clipped_by"));
    CHECK_FALSE(contains(text, " open"));
}

TEST_CASE("a polynomial that is flat near 0 and steep elsewhere is multiplied out", "[export]") {
    const auto implicit = [](const std::string& f) {
        return exported("integrator flat\nimplicit -2 -2 -2 2 2 2 " + f + "\n");
    };
    const std::string heart = implicit("(x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3");
    INFO(heart);
    CHECK(contains(heart, "polynomial { 6, xyz(0, 0, 0): -1, xyz(0, 0, 2): 3, "));
    CHECK(contains(heart, "xyz(0, 2, 3): -0.1125, "));
    CHECK(contains(heart, "xyz(2, 0, 3): -1, "));
    CHECK(contains(heart, "xyz(2, 4, 0): 15.1875, "));  // 3·(9/4)²
    CHECK(contains(heart, " sturm clipped_by { box {"));
    CHECK(contains(implicit("-(x/2-y)*(x/2-y)*(x/2-y)*(1-x^2)"), "polynomial { 5, "));
    // Neither flat, or no polynomial.
    CHECK(contains(implicit("x^2+y^2+z^2-1"), "isosurface {"));
    CHECK(contains(implicit("(x^2+y^2+z^2-1)^3+exp(-9*x^2)/1000000"), "isosurface {"));
    CHECK(contains(implicit("(x^2+y^2+z^2-1)^7/(x^2+1)"), "isosurface {"));
}

TEST_CASE("a transform is written column by column, before the texture", "[export]") {
    const std::string text = exported("integrator flat\ntranslate 1 2 3\nscale 2 4 8\nsphere 0 0 0 1\n");
    INFO(text);
    CHECK(contains(text, "sphere { <0, 0, 0>, 1 matrix <2, 0, 0, 0, 4, 0, 0, 0, 8, 1, 2, 3> texture {"));
}

TEST_CASE("a rotation of 90 degrees about z takes x to y", "[export]") {
    const std::vector<Real> m =
        numbers_after(exported("integrator flat\nrotate 0 0 2 90\nsphere 0 0 0 1\n"), "1 matrix");
    REQUIRE(m.size() >= 12);
    CHECK(m[0] == Approx(0).margin(1e-15));  // the sine and cosine of π/2 as doubles are 1 and 6e-17
    CHECK(m[1] == Approx(1));
    CHECK(m[3] == Approx(-1));
    CHECK(m[8] == Approx(1));
}

TEST_CASE("a checker is solid in world space", "[export]") {
    CHECK(contains(exported("integrator flat\nambient 1 .5 0\nchecker .5 .5 .5 0 1 0 .25\nsphere 0 0 0 1\n"),
                   "pigment { checker rgb <0.5, 0.25, 0> rgb <0, 0.5, 0> scale 0.25 }"));
}

TEST_CASE("attenuation is written as POV-Ray fades light", "[export]") {
    const auto light = [](const std::string& attenuation) {
        return exported("attenuation " + attenuation + "\npoint 0 5 0 1 .5 0\n");
    };
    CHECK(contains(light("4 0 0"), "light_source { <0, 5, 0> rgb <0.25, 0.125, 0> }"));
    CHECK(contains(light("2 .5 0"), "rgb <0.25, 0.125, 0> fade_distance 4 fade_power 1 }"));
    CHECK(contains(light("4 0 .25"), "rgb <0.125, 0.0625, 0> fade_distance 4 fade_power 2 }"));
    // (d + 1)(d + 2): 1/(d + 1) - 1/(d + 2).
    const std::string both = light("2 3 1");
    CHECK(contains(both, "rgb <0.5, 0.25, 0> fade_distance 1 fade_power 1 }"));
    CHECK(contains(both, "rgb <-0.25, -0.125, 0> fade_distance 2 fade_power 1 }"));
    CHECK(contains(exported("directional 0 0 7 1 1 1\n"),
                   "light_source { <0, 0, 100000> rgb 1 parallel point_at 0 }"));
}

TEST_CASE("the fading that stands for an attenuation has its value at any distance", "[export]") {
    for (const Vec3 a : {Vec3(1, 0, 0), Vec3(2, .5, 0), Vec3(4, 0, .25), Vec3(2, 3, 1), Vec3(0, 2, 0),
                         Vec3(0, 0, .5), Vec3(0, .5, .25)}) {
        const std::string text =
            exported(fmt::format("attenuation {} {} {}\npoint 0 0 0 1 1 1\n", a.x, a.y, a.z));
        for (const Real d : {.5, 1., 3., 100.}) {
            Real sum = 0;
            std::istringstream lines(text);
            for (std::string line; std::getline(lines, line);) {
                if (!contains(line, "light_source")) continue;
                const Real color = numbers_after(line, "rgb").front();
                if (!contains(line, "fade_distance")) {
                    sum += color;
                    continue;
                }
                const std::vector<Real> fade = numbers_after(line, "fade_distance");
                sum += color * 2 / (1 + std::pow(d / fade[0], fade[1]));
            }
            CAPTURE(a.x, a.y, a.z, d, text);
            // Two of a 16-bit step: what stands for a missing constant term is 1e-6 world units.
            CHECK(sum * (a.x + a.y * d + a.z * d * d) == Approx(1).epsilon(3e-6));
        }
    }
}

TEST_CASE("a material is layered only where it must be", "[export]") {
    const std::string light = "directional 0 1 0 1 1 1\n";
    const auto layers = [](const std::string& text) {
        std::size_t count = 0;
        for (std::size_t at = text.find("texture { pigment"); at != std::string::npos;
             at = text.find("texture { pigment", at + 1))
            ++count;
        return count;
    };
    const std::string matte = exported(light + "ambient 0 0 0\ndiffuse .5 .4 .3\nsphere 0 0 0 1\n");
    CHECK(layers(matte) == 1);
    CHECK(contains(matte, "pigment { rgb <0.5, 0.4, 0.3> } finish { ambient 0 diffuse 1 }"));

    const std::string grey = exported(
        light + "ambient 0 0 0\ndiffuse .5 .4 .3\nspecular .25 .25 .25\nshininess 20\nsphere 0 0 0 1\n");
    CHECK(layers(grey) == 1);
    CHECK(contains(grey, "reflection { rgb 0.25 } specular 0.25 roughness 0.05"));

    const std::string all = exported(
        light + "ambient .1 .2 .3\ndiffuse .5 .4 .3\nspecular .5 .25 0\nshininess 20\nsphere 0 0 0 1\n");
    INFO(all);
    CHECK(layers(all) == 4);
    CHECK(contains(all, "pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 2 roughness 0.05 }"));
    CHECK(contains(all, "pigment { rgb <1, 0.5, 0> filter 1 } finish { ambient 0 diffuse 0 }"));
    CHECK(contains(all,
                   "pigment { rgb <0.1, 0.2, 0.3> transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 }"));
    CHECK(contains(all,
                   "pigment { rgb <0.5, 0.4, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection"));

    CHECK(contains(exported(light + "highlight phong\nspecular 1 1 1\nshininess 9\nsphere 0 0 0 1\n"),
                   "phong 1 phong_size 9"));
}

TEST_CASE("glass has an interior", "[export]") {
    const std::string glass = "ambient 0 0 0\ntransmission .9 .8 .7\nior 1.5\n";
    const std::string clear = exported("maxdepth 7\n" + glass + "sphere 0 0 0 1\n");
    INFO(clear);
    CHECK(contains(clear, "max_trace_level 8"));
    CHECK(contains(clear, "pigment { rgb <0.9, 0.8, 0.7> filter 1 } finish { ambient 0 diffuse 0 }"));
    CHECK(contains(clear, "interior { ior 1.5 } }"));
    CHECK(contains(exported(glass + "fresnel exact\nsphere 0 0 0 1\n"),
                   "reflection { rgb 0, rgb 1 fresnel } conserve_energy"));
    CHECK(contains(exported(glass + "absorption .1 .2 0\nsphere 0 0 0 1\n"),
                   "interior { ior 1.5 media { absorption rgb <0.1, 0.2, 0> } } hollow }"));
    CHECK(contains(exported("shadows off\n" + glass + "sphere 0 0 0 1\n"), "no_shadow }"));
}

TEST_CASE("what POV-Ray cannot express is refused, with its place and the reason", "[export]") {
    const std::string glass = "ambient 0 0 0\ntransmission 1 1 1\nior 1.5\n";
    const std::string schlick = error_of(glass + "fresnel schlick\n  sphere 0 0 0 1\n");
    INFO(schlick);
    CHECK(schlick.starts_with("small.scene:8:3: POV-Ray cannot express this object: Schlick"));

    const std::string face = error_of(glass + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\ntri 0 1 2\n");
    INFO(face);
    CHECK(face.starts_with(
        "small.scene:10:1: POV-Ray cannot express this object: a transparent object without"));

    const std::string light = error_of("directional 0 1 0 1 1 1\nattenuation 1 1 1\npoint 0 1 0 1 1 1\n");
    INFO(light);
    CHECK(contains(light, "small.scene: POV-Ray cannot express this scene: light 2 has attenuation 1 1 1"));

    const std::string depth = error_of("maxdepth 300\nspecular 1 1 1\nsphere 0 0 0 1\n");
    INFO(depth);
    CHECK(contains(depth, "maxdepth 300 is over its limit of 255"));
    CHECK(error_of("maxdepth 300\nsphere 0 0 0 1\n").empty());

    CHECK(contains(
        error_of("directional 0 1 0 1 1 1\nspecular 1 0 1\n" + glass + "sphere 0 0 0 1\n"),
        "small.scene:9:1: POV-Ray cannot express this object: a transparent material whose highlight"));
}

TEST_CASE("what is too small or too far for POV-Ray's tolerances is exported larger or smaller", "[export]") {
    // The same picture in several units. POV-Ray's own are for things between 0.01 and 1e4.
    const auto in_units = [](const std::string& e) {
        return exported("camera 0 1" + e + " 4" + e +
                        " 0 0 0 0 1 0 35\nambient .1 .1 .1\nchecker 1 1 1 0 0 0 2" + e +
                        "\nattenuation 1 0 0\npoint 2" + e + " 3" + e + " 2" + e + " 1 1 1\nsphere 0 0 0 6" +
                        e + "\ntranslate 7" + e + " 6" + e + " 0\nsphere 0 0 0 3" + e + "\n");
    };
    const auto radius = [](const std::string& text) { return numbers_after(text, "sphere {").at(3); };
    CHECK(radius(in_units("e0")) == 6);
    CHECK_FALSE(contains(in_units("e0"), "All lengths are"));
    for (const char* unit : {"e-5", "e-20", "e6", "e20"}) {
        const std::string text = in_units(unit);
        INFO(text);
        const Real factor = numbers_after(text, "All lengths are").at(0);
        CHECK(std::exp2(std::round(std::log2(factor))) == factor);
        CHECK(radius(text) >= 0.01);
        CHECK(radius(text) <= 1e4);
        const Real one = std::stod("1" + std::string(unit)) * factor;
        CHECK(radius(text) == Approx(6 * one));
        CHECK(numbers_after(text, "location").at(1) == Approx(one));
        CHECK(numbers_after(text, "light_source").at(1) == Approx(3 * one));
        CHECK(numbers_after(text, "rgb 0 scale").at(0) == Approx(2 * one));
        CHECK(numbers_after(text, "matrix").at(9) == Approx(7 * one));
    }
    // Attenuation is by distance, and so is absorption.
    CHECK(contains(exported("camera 0 0 4e-6 0 0 0 0 1 0 35\nsphere 0 0 0 1e-6\nattenuation 4 0 1e12\npoint "
                            "0 1e-6 0 1 1 1\n"),
                   "fade_power 2"));
    const std::string dim = exported(
        "camera 0 0 4e8 0 0 0 0 1 0 35\nambient 0 0 0\ntransmission 1 1 1\n"
        "absorption 1e-8 0 0\nsphere 0 0 0 1e8\n");
    INFO(dim);
    CHECK(numbers_after(dim, "absorption").at(0) * numbers_after(dim, "sphere {").at(3) == Approx(1));

    const std::string both = error_of("sphere 0 0 0 1e-3\nsphere 0 0 -1e5 1e4\n");
    INFO(both);
    CHECK(contains(both, "POV-Ray cannot express this scene: its lengths are from 0.001 to 1.11e+05"));
}

TEST_CASE("a shape has a size near 1 before its transform, too", "[export]") {
    for (const char* shape :
         {"sphere 0 0 0 1e-9\n", "vertex -1e-9 0 0\nvertex 1e-9 0 0\nvertex 0 1e-9 0\ntri 0 1 2\n",
          "vertexnormal -1e-9 0 0 0 0 1\nvertexnormal 1e-9 0 0 0 0 1\nvertexnormal 0 1e-9 0 0 0 1\ntrinormal "
          "0 1 2\n"}) {
        std::string text = shape;
        const std::size_t at = text.find_last_of('\n', text.size() - 2);  // before the object's line
        text.insert(at == std::string::npos ? 0 : at + 1, "translate 0 0 -1\nscale 1e9 1e9 1e9\n");
        const std::string pov = exported("integrator normals\n" + text);
        INFO(pov);
        const Real stretch = numbers_after(pov, "matrix").at(0);
        CHECK(stretch > 1e-2);
        CHECK(stretch < 1e2);
        CHECK(numbers_after(pov, "matrix").at(11) == -1);
    }
}

TEST_CASE("absorption is exported where POV-Ray's media reach", "[export]") {
    const std::string water = "background .3 .5 .9\nambient 0 0 0\ntransmission 1 1 1\nabsorption .5 .2 0\n";
    SECTION("towards the background by a sky that is far away") {
        CHECK(contains(exported(water + "plane 0 0 0 0 1 0\n"), "no_shadow hollow }"));
        CHECK_FALSE(contains(exported(water + "sphere 0 0 0 1\n"), "no_shadow"));
        const std::string weak =
            error_of("ambient 0 0 0\ntransmission 1 1 1\nabsorption 1e-7 0 0\nplane 0 0 0 0 1 0\n");
        CHECK(contains(weak, "small.scene:7:1: POV-Ray cannot express this object: absorption so weak"));
    }
    SECTION("around the camera, and inside of other glass") {
        const std::string room = "sphere 0 0 0 20\n", text = exported(room + water + "sphere 0 0 0 1\n");
        INFO(text);
        CHECK(contains(text, "20 texture { Material0 } hollow inverse }"));
        CHECK(contains(
            exported("ambient 0 0 0\ntransmission 1 1 1\nsphere 0 0 0 2\n" + water + "sphere 0 0 0 1\n"),
            "interior { ior 1.000001 } hollow }"));
    }
    SECTION("not where there are lights: POV-Ray absorbs theirs") {
        const std::string why =
            error_of("directional 0 1 0 1 1 1\ndiffuse 1 1 1\nplane 0 -1 0 0 1 0\ndiffuse 0 0 0\n" + water +
                     "sphere 0 0 0 1\n");
        INFO(why);
        CHECK(contains(
            why, "small.scene:12:1: POV-Ray cannot express this object: absorption in a scene with lights"));
        // Light that nothing reflects, and glass that no ray enters.
        CHECK(error_of("directional 0 1 0 1 1 1\n" + water + "sphere 0 0 0 1\n").empty());
        CHECK(error_of("maxdepth 0\ndirectional 0 1 0 1 1 1\ndiffuse 1 1 1\n" + water + "sphere 0 0 0 1\n")
                  .empty());
    }
}

TEST_CASE("absorption is refused where POV-Ray adds it up", "[export]") {
    const std::string start = "background .8 .9 1\nambient 0 0 0\ntransmission 1 1 1\n",
                      clear = "absorption 0 0 0\n", water = "absorption .3 .5 .1\n",
                      glass = "absorption .1 .2 .6\n";
    const std::string why = "absorption where it may be in one place with the transparent object of line ";
    const auto is_refused = [&](const std::string& text) { return contains(error_of(start + text), why); };
    // A ball of glass in a ball of water displaces it: straight through there are 1 of each.
    const std::string nested = water + "sphere 0 0 0 1\n" + glass + "ior 1.4\nsphere 0 0 0 .5\n";
    CHECK(is_refused(nested));
    const World world = test::world_of("camera 0 0 5 0 0 0 0 1 0 40\nsize 1 1\n" + start + nested);
    const Vec3 seen = color_along(world, {Vec3(0, 0, 5), Vec3(0, 0, -1)});
    const Vec3 coefficients = Vec3(0.3, 0.5, 0.1) + Vec3(0.1, 0.2, 0.6);
    CHECK(test::near(seen, Vec3(0.8, 0.9, 1) * glm::exp(-coefficients), 1e-12));
    CHECK(is_refused(water + "sphere 0 0 0 1\n" + clear + "sphere 0 0 0 .5\n"));
    CHECK_FALSE(is_refused(clear + "sphere 0 0 0 1\n" + water + "sphere 0 0 0 .5\n"));
    // They overlap, as do half-spaces that are not parallel.
    CHECK(is_refused(water + "sphere -.4 0 0 .9\n" + glass + "sphere .4 0 0 .9\n"));
    CHECK(is_refused(clear + "sphere -.4 0 0 .9\n" + glass + "sphere .4 0 0 .9\n"));
    CHECK_FALSE(is_refused(water + "sphere -1.4 0 0 .9\n" + glass + "sphere 1.4 0 0 .9\n"));
    CHECK(is_refused(water + "plane 0 0 -2  .3 .1 -1\n" + glass + "plane 0 0 -9  .2 -.3 -1\n"));
    CHECK_FALSE(is_refused("maxdepth 0\n" + nested));
}

TEST_CASE("several bodies of different glass around the eye are refused, whose order POV-Ray does not know",
          "[export]") {
    const std::string room = "ambient 0 0 0\ntransmission 1 1 1\nior 1.5\nbox -1 -1 4 1 1 6\nior 1.2\n",
                      outer = "box -2 -2 3 2 2 7\n";
    CHECK(error_of(room + outer) ==
          "small.scene:9:1: POV-Ray cannot express this object: transparent and around the eye, as is the "
          "one of "
          "line 7 with another index of refraction: POV-Ray does not know which is the inner one");
    CHECK(error_of(room + "ior 1.5\n" + outer).empty());
    CHECK(error_of(room + "box -2 -2 1 2 2 3\n").empty());
    // Ours are right: through parallel faces a ray leans 1.5 times as much as in the inner glass (Snell).
    const World world = test::world_of("camera 0 0 5 0 0 0 0 1 0 40\nsize 1 1\n" + room + outer);
    const Vec3 inside = glm::normalize(Vec3(0.1, 0.05, -1));
    const Vec3 outside = trace_tree(world, {Vec3(0, 0, 5), inside}).back().branch.ray.direction;
    CHECK(test::near(Vec2(outside), 1.5 * Vec2(inside), 1e-12));
}

TEST_CASE("bodies with fresnel that may be nested are refused", "[export]") {
    const std::string glass = "ambient 0 0 0\ntransmission 1 1 1\nior 1.5\n",
                      fresnel = glass + "fresnel exact\n";
    const auto is_nested = [](const std::string& why) {
        return contains(why, "on the way out POV-Ray forgets");
    };
    const std::string why = error_of(fresnel + "sphere 0 0 0 1\nior 1.2\nsphere 0 0 0 .9\n");
    INFO(why);
    CHECK(is_nested(why));
    CHECK(why.starts_with("small.scene:8:1: "));
    CHECK(contains(why, "of line 10"));
    CHECK(is_nested(error_of(glass + "sphere 0 0 0 1\nfresnel exact\nsphere 0 0 0 .9\n")));
    CHECK(is_nested(error_of(fresnel + "plane 0 0 0 0 1 0\nsphere 0 .5 0 .7\n")));
    CHECK(is_nested(error_of(fresnel + "sphere 0 0 0 1\ntranslate 1.5 0 0\nscale 2 1 1\nsphere 0 0 0 .5\n")));
    // Side by side, above the water, without fresnel, or with no bounce at all.
    CHECK(error_of(fresnel + "sphere 0 0 0 1\nsphere 1.9 1.9 0 1\n").empty());
    CHECK(error_of(fresnel + "plane 0 0 0 0 1 0\nsphere 0 .8 0 .7\n").empty());
    CHECK(error_of(glass + "sphere 0 0 0 1\nsphere 0 0 0 .9\n").empty());
    CHECK(error_of("maxdepth 0\n" + fresnel + "sphere 0 0 0 1\nsphere 0 0 0 .9\n").empty());
    // Opaque things are no media, also around the camera: there POV-Ray has to be told.
    CHECK(contains(exported("sphere 0 0 0 20\n" + fresnel + "sphere 0 0 0 1\n"), "{ Material0 } inverse }"));
    CHECK_FALSE(contains(exported("sphere 0 0 0 20\nsphere 0 0 0 1\n"), "inverse"));
}

TEST_CASE("POV-Ray counts a bounce only where rays are bent, so no two bodies bend alike", "[export]") {
    const std::string text = exported(
        "ambient 0 0 0\ntransmission 1 1 1\nsphere 0 0 0 1\nsphere 0 0 0 .8\nior 1.5\n"
        "sphere 0 0 0 .6\nsphere 0 0 0 .4\n");
    INFO(text);
    for (const char* ior : {"ior 1.000001 ", "ior 1.000002 ", "ior 1.5 ", "ior 1.5000015 "})
        CHECK(contains(text, ior));
}

TEST_CASE("lights from infinitely far away stand by the eye, wherever that is", "[export]") {
    const std::string text =
        exported("camera 0 0 1e7 0 0 0 0 1 0 35\ndirectional 1 0 0 1 1 1\nsphere 0 0 9.995e6 1e3\n");
    INFO(text);
    CHECK(contains(text, "light_source { <100000, 0, 10000000> rgb 1 parallel point_at <0, 0, 10000000> }"));
}

TEST_CASE("every reference scene is exported, to the same text each time", "[export]") {
    namespace fs = std::filesystem;
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(test::repository()) / "references")) {
        if (entry.path().extension() != ".scene" ||
            fs::exists(fs::path(entry.path()).replace_extension(".why")))
            continue;
        CAPTURE(entry.path().string());
        // A large mesh may be made by a generator of the chapter instead of being kept.
        std::ifstream file(entry.path());
        bool is_complete = true;
        for (std::string word; file >> word;)
            if (word == "mesh" && file >> word && !word.starts_with('.') && word.ends_with(".obj"))
                is_complete = is_complete && fs::exists(entry.path().parent_path() / word);
        if (!is_complete) continue;
        ++count;
        std::string text;
        const auto again = [&] {
            const Scene scene = parse_scene(entry.path());
            return export_povray(scene, snapshots_of(scene));
        };
        REQUIRE_NOTHROW(text = again());
        CHECK(contains(text, "camera {"));
        CHECK(text == again());
        CHECK_FALSE(contains(text, "nan"));
        CHECK_FALSE(contains(text, "inf"));
    }
    CHECK(count >= 9);  // three chapters with three scenes each
}

TEST_CASE("how POV-Ray makes a picture of several samples a pixel", "[export]") {
    const auto run = [](const std::string& text) {
        return povray_run(parse_scene_text("camera 0 0 5 0 0 0 0 1 0 45\n" + text, "s"));
    };
    CHECK(run("").scale == 1);
    CHECK(run("").options.empty());
    CHECK(run("sampler random").exact);
    // One sample a pixel, but a filter that reaches to the neighbours'.
    CHECK_FALSE(run("spp 1").filter);
    CHECK(run("spp 1\nfilter gaussian").filter);
    CHECK(run("spp 1\nfilter gaussian").scale == 1);
    CHECK(run("spp 9\nsampler regular").filter);
    CHECK_FALSE(run("spp 10\nsampler centered").filter);
    CHECK(contains(exported("integrator flat\nfilter mitchell\n"),
                   "// then its pixels are weighed by our filter"));
    // Scan conversion takes one sample whatever the scene says.
    CHECK(run("spp 9\nsampler regular\nintegrator rasterize").scale == 1);
    CHECK_FALSE(run("spp 9\nsampler regular\nintegrator rasterize").filter);
    CHECK(run("spp 9\nsampler regular\nfilter tent").scale == 3);
    CHECK(run("spp 9\nsampler regular").exact);
    CHECK(
        (run("spp 25\nsampler trapezoid").options == std::vector<std::string>{"+AM2", "+A0.0", "+R3", "-J"}));
    CHECK(
        (run("spp 10\nsampler centered").options == std::vector<std::string>{"+AM1", "+A0.0", "+R3", "-J"}));
    // Of what is blurred, each sample is a picture.
    for (const char* text : {"lens .1 4\n", "cameramotion 1 0 0\n", "motion 1 0 0\nsphere 0 0 0 1\n",
                             "lightsampling area\nsphereLight 0 3 0 .5 1 1 1\n"}) {
        INFO(text);
        CHECK(run(std::string(text) + "spp 8\nsampler regular").frames == 8);
        CHECK(run(std::string(text) + "spp 9\nsampler trapezoid\nfilter tent").frames == 9);
        CHECK(run(std::string(text) + "spp 8\nsampler regular").options.empty());
        CHECK(run(std::string(text) + "spp 8\nsampler regular").exact);
        CHECK(run(std::string(text) + "spp 8\nsampler regular").filter);
        CHECK(run(std::string(text) + "sampler regular").frames == 1);
        CHECK(run(std::string(text) + "sampler regular").exact);
        // Of samples that differ from pixel to pixel many pictures tell the mean.
        CHECK(run(std::string(text) + "spp 8").frames == 128);
        CHECK_FALSE(run(std::string(text) + "spp 8").exact);
    }
    CHECK(run("spp 8\nsampler regular\nmotion 0 0 0\nsphere 0 0 0 1\nlens 0 4").frames == 1);
    // What POV-Ray cannot repeat: its mean is known from other samples.
    for (const char* text : {"spp 8\nsampler regular", "spp 16\nsampler trapezoid", "spp 9\nsampler centered",
                             "spp 16", "spp 9\nsampler trapezoid\nfilter tent", "spp 4\nsampler poisson"}) {
        INFO(text);
        CHECK_FALSE(run(text).exact);
        CHECK(run(text).scale == 8);
    }
}

// What blurs, one snapshot at a time ------------------------------------------------------------------------

namespace {

// All pixels share their one sample.
const std::string shared = "sampler regular\n";

std::string still(const std::string& commands, const Snapshot& snapshot) {
    return export_povray(parse_scene_text(head + shared + commands, "small.scene"), {&snapshot, 1});
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE("a place on the lens moves POV-Ray's camera, and leans it back to the plane in focus", "[export]") {
    const std::string commands = "integrator flat\nlens 1 4\n";
    const std::string right = still(commands, {.lens = Vec2(1, 0)});
    INFO(right);
    CHECK(contains(right, "location <1, 0, 5>"));
    CHECK(contains(right, "direction <-0.25, 0, -1>"));
    const std::string up = still(commands, {.lens = Vec2(0, 0.5)});
    INFO(up);
    CHECK(contains(up, "location <0, 0.5, 5>"));
    CHECK(contains(up, "direction <0, -0.125, -1>"));
    const std::string flat = still(commands + "orthographic 3\n", {.lens = Vec2(1, 0)});
    INFO(flat);
    CHECK(contains(flat, "location <1, 0, 5>"));
    CHECK(contains(flat, "direction <-0.25, 0, -1>"));
    CHECK(still(commands, {}) == exported("integrator flat\n"));
}

TEST_CASE("a lens becomes larger as the scene does", "[export]") {
    const std::string text = export_povray(
        parse_scene_text("size 40 30\ncamera 0 0 5e-5  0 0 0  0 1 0  90\nintegrator flat\n"
                         "sampler regular\nlens 1e-5 4e-5\nmotion 2e-5 0 0\nsphere 0 0 0 1e-5\n",
                         "small.scene"),
        std::vector<Snapshot>{{.lens = Vec2(1e-5, 0), .time = 0.5}});
    INFO(text);
    const Real factor = numbers_after(text, "All lengths are").at(0);
    CHECK(numbers_after(text, "location").at(0) == Approx(1e-5 * factor));
    CHECK(numbers_after(text, "direction").at(0) == Approx(-0.25));
    CHECK(numbers_after(text, "matrix").at(9) == Approx(1e-5 * factor));
}

TEST_CASE("a place in the pixel moves POV-Ray's picture by a part of a pixel", "[export]") {
    const Snapshot aside{.at = Vec2(0.75, 1)};
    const auto test = [&](const std::string& commands, const char* word) {
        const std::string text = still(commands, aside);
        INFO(text);
        const std::vector<Real> middle = numbers_after(exported(commands), word),
                                moved = numbers_after(text, word);
        const Real right = numbers_after(text, "right").at(0), up = numbers_after(text, "up").at(1);
        CHECK(moved.at(0) - middle.at(0) == Approx(right / 40 / 4));
        CHECK(moved.at(1) - middle.at(1) == Approx(-up / 30 / 2));
        CHECK(moved.at(2) == middle.at(2));
    };
    test("integrator flat\n", "direction");
    test("integrator flat\northographic 3\n", "location");
}

TEST_CASE("what moves is exported where it is at a time", "[export]") {
    const std::string commands =
        "cameramotion 0 1 0\nmotion 1 2 3\nsphere 0 0 0 1\nscale 2 2 2\nsphere 0 0 0 1\nmotion 0 0 0\n"
        "sphere 0 0 0 4\n";
    const std::string text = still(commands, {.time = 0.5});
    INFO(text);
    CHECK(contains(text, "location <0, 0.5, 5>"));
    CHECK(contains(text, "direction <0, 0, -1>"));
    CHECK(contains(text, "sphere { <0, 0, 0>, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 1, 1.5> texture"));
    CHECK(contains(text, "sphere { <0, 0, 0>, 1 matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, 0.5, 1, 1.5> texture"));
    CHECK(contains(text, "sphere { <0, 0, 0>, 4 matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0> texture"));
    CHECK(contains(still("motion 0 0 1\nintersection\nsphere 0 0 0 1\nsphere 1 0 0 1\nend\n", {.time = 0.25}),
                   "sphere { <1, 0, 0>, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.25>"));
    // A quarter of a whole turn, about (3, 0, 0), and then a quarter of the way.
    const std::string turned =
        still("motion 0 0 4\ntranslate 3 0 0\nspin 0 0 1 360\nsphere 1 0 0 1\n", {.time = 0.25});
    INFO(turned);
    const std::vector<Real> m = numbers_after(turned, "matrix");
    const std::vector<Real> expected{0, 1, 0, -1, 0, 0, 0, 0, 1, 3, 0, 1};
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(m.at(i) == Approx(expected[i]).margin(1e-12));
}

TEST_CASE("a point of an area light is a spotlight whose power of the cosine is 1", "[export]") {
    const std::string commands = "lightsampling area\nmaxdepth 0\ndiscLight 0 2 0  0 -1 0  .5  1 1 1\n";
    const std::string text =
        still(commands, {.lights = {{{0, 2, 0}, {0, -1, 0}, Vec3(3)}, {{1, 2, 0}, {0, -1, 0}, Vec3(0)}}});
    INFO(text);
    CHECK(count_of(text, "light_source") == 1);
    CHECK(contains(text, "light_source { <0, 2, 0> rgb "));
    CHECK(numbers_after(text, "light_source { <0, 2, 0> rgb ").at(0) == Approx(1.5e12));
    CHECK(contains(text,
                   " spotlight point_at <0, 1, 0> radius 90 falloff 90 tightness 1 fade_distance 1e-06 "
                   "fade_power 2 }"));
}

TEST_CASE("area lights are seen on their bright side, by integrators that look at lights", "[export]") {
    const std::string lights =
        shared +
        "lightsampling area\nquadLight -1 2 -1  0 0 2  2 0 0  .5 .25 0\ndiscLight 0 2 0  0 -2 0  .5  1 1 1\n"
        "sphereLight 1 2 3  .5  1 1 1\ntriangleLight 0 0 0  1 0 0  0 1 0  1 1 1\n";
    const std::string glow = " texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }";
    const std::string dark = " interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }";
    const std::string text = exported(lights);
    INFO(text);
    // Shines downwards: −(ab × ac). Its corners run clockwise as seen from there.
    CHECK(contains(text,
                   "polygon { 5, <-1, 2, -1>, <1, 2, -1>, <1, 2, 1>, <-1, 2, 1>, <-1, 2, -1> texture { "
                   "pigment { rgb <0.5, 0.25, 0> }"));
    CHECK(contains(text, "disc { <0, 2, 0>, <0, -1, 0>, 0.5" + glow + dark + " }"));
    CHECK(contains(text, "sphere { <1, 2, 3>, 0.5" + glow + dark + " }"));
    CHECK(contains(text, "triangle { <0, 0, 0>, <0, 1, 0>, <1, 0, 0>" + glow + dark + " }"));
    CHECK(contains(exported("shadows off\n" + lights), dark + " no_shadow }"));
    const std::string flat = exported("integrator flat\n" + lights);
    CHECK(contains(flat, "disc { <0, 2, 0>, <0, -1, 0>, 0.5" + glow + " }"));
    CHECK_FALSE(contains(flat, "light_source"));
    CHECK(contains(exported("integrator normals\n" + lights),
                   "disc { <0, 2, 0>, <0, -1, 0>, 0.5 texture { Normal } }"));
    CHECK_FALSE(contains(exported("integrator directions\n" + lights), "disc"));
    CHECK(error_of("integrator uv\n" + lights)
              .starts_with("small.scene:7:1: POV-Ray cannot express this light: "));
}

TEST_CASE("a blurred picture is an animation, a frame a sample", "[export]") {
    const std::string text = exported("spp 12\nsampler regular\nlens .1 4\nsphere 0 0 0 1\n");
    INFO(text.substr(0, 1000));
    CHECK(contains(text,
                   "-D -A File_Gamma=1.0 +KFI0 +KFF11\n// then a pixel's samples are those of 12 pictures"));
    CHECK(contains(text, "\n#version 3.7;\n#switch (frame_number)\n#case (0)\n#version 3.7;"));
    CHECK(contains(text, "#break\n#case (11)\n"));
    CHECK(text.ends_with("#break\n#end\n"));
    CHECK(count_of(text, "camera {") == 12);
    CHECK(count_of(text, "written by") == 1);
    CHECK(count_of(exported(shared + "lens .1 4\nsphere 0 0 0 1\n"), "camera {") == 1);
}

TEST_CASE("what pixels do not share is exported as many stills that tell its mean", "[export]") {
    const std::string lamp = "lightchoice one\ndiscLight 0 2 0  0 -1 0  .5  10 5 1\n";
    const std::string text = exported("ambient .5 .5 .5\nbackground .25 0 0\n" + lamp + "sphere 0 0 0 1\n");
    INFO(text.substr(0, 2000));
    // So dark that the lamp is 1/4 at most: 10/64. Its points are brighter than it is.
    CHECK(contains(text,
                   "+KFF127\n// then a pixel's samples are those of 128 pictures, weighed by our filter, "
                   "times 64\n"));
    CHECK(count_of(text, "camera {") == 128);
    CHECK(count_of(text, "light_source") == 128);
    CHECK(numbers_after(text, "background { rgb ").at(0) == Approx(0.25 / 64));
    CHECK(numbers_after(text, "disc { <0, 2, 0>, <0, -1, 0>, 0.5 texture { pigment { rgb ").at(0) ==
          Approx(10. / 64));
    // Radiance times area over pi, as a spotlight of reach 1e-6 has it.
    CHECK(numbers_after(text.substr(text.find("light_source")), " rgb ").at(0) ==
          Approx(10. / 64 * 0.25 / 2 * 1e12));
}

TEST_CASE("what shows no light is not made darker, nor are exact stills", "[export]") {
    const auto exposure = [](const std::string& text) {
        return exposure_of(
            parse_scene_text(head + text + "lens .1 4\nbackground 9 0 0\nsphere 0 0 0 1\n", "s"));
    };
    CHECK(exposure("spp 4\n") == 1. / 64);
    CHECK(exposure("spp 4\nsampler regular\n") == 1);
    CHECK(exposure("integrator directions\nspp 4\n") == 1);
    CHECK(exposure_of(parse_scene_text(std::string(head) + "background 9 0 0\n", "s")) == 1);
}

TEST_CASE("what no still shows is refused, with the word that helps", "[export]") {
    const std::string no_scene = "small.scene: POV-Ray cannot express this scene: ";
    const std::string light = shared + "discLight 0 2 0  0 -1 0  .5  1 1 1\n",
                      ball = "diffuse 1 1 1\nsphere 0 0 0 1\n";
    const auto refused = [&](const std::string& commands, const std::string& where, const std::string& what) {
        const std::string error = error_of(commands);
        INFO(error);
        CHECK(error.starts_with(where));
        CHECK(contains(error, what));
    };
    refused("integrator direct\n" + light, no_scene, "physical");
    refused("lightsampling area\nspecular 1 1 1\n" + ball + light,
            "small.scene:9:1: POV-Ray cannot express this light: ", "'maxdepth 0'");
    CHECK(error_of("lightsampling area\nmaxdepth 0\nspecular 1 1 1\n" + ball + light).empty());
    CHECK(error_of("specular 1 1 1\n" + ball + light).empty());  // a mean of many
    CHECK(error_of("lightsampling area\n" + ball + light).empty());
    CHECK(error_of(shared + "lens .1 4\nspecular 1 1 1\n" + ball).empty());
    refused("gloss 50\nspecular 1 1 1\n" + ball,
            "small.scene:7:1: POV-Ray cannot express this object: ", "spread");
    CHECK(error_of("gloss 50\nmaxdepth 0\nspecular 1 1 1\n" + ball).empty());
    CHECK(error_of("brdf ggx\nroughness .5\n" + ball).empty());
    // The ball begins 4 in front of the eye, which comes nearer.
    const std::string glass = "ambient 0 0 0\ntransmission 1 1 1\nior 1.5\nsphere 0 0 0 1\n";
    CHECK(error_of("spp 4\nsampler regular\ncameramotion 0 0 -3\n" + glass).empty());
    refused("spp 4\nsampler regular\ncameramotion 0 0 -5\n" + glass,
            "small.scene:10:1: POV-Ray cannot express this object: ", "the eye at some time");
    refused("spp 16\nsampler regular\nlens 3 4\n" + glass + "translate 3 0 5\nsphere 0 0 0 2\n",
            "small.scene:12:1: POV-Ray cannot express this object: ", "a part of the lens");
}
