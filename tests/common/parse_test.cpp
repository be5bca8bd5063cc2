// The scene language: every command, every error with its line and column, and files as people write them.
#include "common/scene/parse.hpp"

#include "common/image/whole_file.hpp"
#include "common/scene/elsewhere.hpp"
#include "common/scene/suggest.hpp"
#include "common/scene/text.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

using namespace rt;

namespace {

const std::string camera = "camera 0 0 5 0 0 0 0 1 0 45\n";

/// The scene of `text` with a camera behind it.
Scene parse(const std::string& text, const ParseOptions& options = {}) {
    return parse_scene_text(text + "\n" + camera, "s", {}, options);
}

/// The message about `text` with a camera behind it; empty if nothing is wrong.
std::string error_of(const std::string& text, const ParseOptions& options = {}) {
    return test::error_of([&] { parse(text, options); });
}

/// The message about exactly `text`.
std::string error_of_whole(const std::string& text) {
    return test::error_of([&] { parse_scene_text(text, "s"); });
}

template <class Shape>
const Shape& shape(const Scene& scene, std::size_t object = 0) {
    return std::get<Shape>(scene.objects.at(object).shape);
}

Material material_of(const std::string& text) {
    const Scene scene = parse(text + "\nsphere 0 0 0 1");
    return scene.materials.at(scene.objects.at(0).material);
}

/// A right line of a command, with what has to stand before it and after it.
struct Example {
    std::string line;
    std::string before;
    std::string after{};
};

/// As messages list them.
const std::string integrator_words = [] {
    std::string words;
    for (const std::string_view name : integrator_names())
        words.append(words.empty() ? "" : "|").append(name);
    return words;
}();

/// Its arguments are the first of each choice, and 1 wherever that will do.
Example example_of(const SceneCommand& command) {
    static const std::string three = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
    static const std::string three_normals =
        "vertexnormal 0 0 0 0 0 1\nvertexnormal 1 0 0 0 0 1\nvertexnormal 0 1 0 0 0 1\n";
    static const std::map<std::string_view, Example> others = {
        {"output", {"output a.png", ""}},
        {"camera", {"camera 1 2 3 4 5 6 0 1 0 30", ""}},
        {"tri", {"tri 0 1 2", three}},
        {"trinormal", {"trinormal 0 1 2", three_normals}},
        {"polygon", {"polygon 0 1 2", three}},
        {"mesh", {"mesh a.obj", ""}},
        {"texture", {"texture a.pfm", ""}},
        {"normalmap", {"normalmap a.pfm", ""}},
        {"textured", {"textured ambient", ""}},
        {"finish", {"finish matte 1", ""}},
        {"environment", {"environment a.pfm 1", ""}},
        {"popTransform", {"popTransform", "pushTransform\n"}},
        {"box", {"box 0 0 0 1 1 1", ""}},
        {"cylinder", {"cylinder 0 0 0 0 1 0 1", ""}},
        {"openCylinder", {"openCylinder 0 0 0 0 1 0 1", ""}},
        {"cone", {"cone 0 0 0 1 0 1 0 0", ""}},
        {"openCone", {"openCone 0 0 0 1 0 1 0 0", ""}},
        {"union", {"union", "", "\nsphere 0 0 0 1\nsphere 1 0 0 1\nend"}},
        {"intersection", {"intersection", "", "\nsphere 0 0 0 1\nsphere 1 0 0 1\nend"}},
        {"difference", {"difference", "", "\nsphere 0 0 0 1\nsphere 1 0 0 1\nend"}},
        {"end", {"end", "union\nsphere 0 0 0 1\nsphere 1 0 0 1\n"}},
        {"implicit", {"implicit 0 0 0 1 1 1 x-y", ""}},
        {"quadLight", {"quadLight 0 0 0 1 0 0 0 1 0 1 1 1", ""}},
        {"triangleLight", {"triangleLight 0 0 0 1 0 0 0 1 0 1 1 1", ""}},
        {"meshLight", {"meshLight a.obj 1 1 1", ""}},
        {"aperture", {"aperture 5 1", ""}},
        {"shutter", {"shutter .5 .5", ""}},
        {"quadric", {"quadric 1 1 1 0 0 0 0 0 0 -1 0 0 0 1 1 1", ""}},
    };
    if (const auto other = others.find(command.name); other != others.end()) return other->second;
    std::string line(command.name);
    std::istringstream arguments{std::string(command.arguments)};
    for (std::string word; arguments >> word;) {
        const std::size_t bar = word.find('|');
        line += " " + (bar == std::string::npos ? "1" : word.substr(0, bar));
    }
    return {line, ""};
}

}  // namespace

TEST_CASE("an empty scene with a camera has the documented defaults") {
    const Scene scene = parse("");
    CHECK(scene.file == "s");
    CHECK(scene.width == 640);
    CHECK(scene.height == 480);
    CHECK(scene.max_depth == 5);
    CHECK(scene.min_contribution == 0);
    CHECK(scene.shadows);
    CHECK(scene.output.empty());
    CHECK(scene.encoding == Encoding::Linear);
    CHECK(scene.integrator == Integrator::Raytrace);
    CHECK(scene.background == Vec3(0));
    CHECK(scene.camera.projection == Projection::Perspective);
    CHECK(scene.objects.empty());
    CHECK(scene.materials.empty());
    CHECK(scene.lights.empty());
    CHECK(material_of("") == Material{});
    CHECK(material_of("").ambient == Vec3(.2));
}

TEST_CASE("every command is read, and counts its arguments") {
    const std::string directory = rt::test::scratch_directory() + "/every_command";
    std::filesystem::create_directories(directory);
    write_file(directory + "/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_image(directory + "/a.pfm", make_image(1, 1));
    const auto message = [&](const std::string& text) {
        return test::error_of([&] { parse_scene_text(text + "\n" + camera, "s", directory); });
    };

    for (const SceneCommand& command : scene_commands()) {
        INFO("command " << command.name);
        const auto [line, before, after] = example_of(command);
        CHECK(message(before + line + after) == "");

        const std::string next =
            "s:" + std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ":";
        const std::string expected = "; expected: " + std::string(command.name) +
                                     (command.arguments.empty() ? "" : " " + std::string(command.arguments));
        const bool any_more = command.arguments.find("...") != std::string_view::npos,
                   one_more = command.arguments.find('[') != std::string_view::npos;
        if (!command.arguments.empty()) {
            std::string shorter = line.substr(0, line.rfind(' '));
            if (one_more) {
                CHECK(message(before + shorter + after) == "");
                shorter = shorter.substr(0, shorter.rfind(' '));
            }
            const std::string error = message(before + shorter);
            CHECK(error.find(next + std::to_string(shorter.size() + 1) + ": '") == 0);
            CHECK(error.find(expected) != std::string::npos);
        }
        if (!any_more) {
            const std::string error = message(before + line + " 7");
            CHECK(error.find(next + std::to_string(line.size() + 2) + ": '") == 0);
            CHECK(error.find(expected) != std::string::npos);
        }
    }
}

TEST_CASE("the commands of the whole picture are stored, and the last of several wins") {
    const Scene scene = parse(
        "version 1\nsize 1 1\nsize 320 240\nmaxdepth 7\noutput a.png\nencoding srgb\nintegrator uv\n"
        "background .1 .2 .3\nshadows off\nmincontribution .01\northographic 3\n");
    CHECK(scene.version == 1);
    CHECK(scene.width == 320);
    CHECK(scene.height == 240);
    CHECK(scene.max_depth == 7);
    CHECK(scene.output == "a.png");
    CHECK(scene.encoding == Encoding::Srgb);
    CHECK(scene.integrator == Integrator::Uv);
    CHECK(scene.background == Vec3(.1, .2, .3));
    CHECK_FALSE(scene.shadows);
    CHECK(scene.min_contribution == .01);
    CHECK(scene.camera.projection == Projection::Orthographic);
    CHECK(scene.camera.view_height == 3);
}

TEST_CASE("the camera's angle becomes radians, and the last camera wins") {
    const Scene scene = parse_scene_text("camera 9 9 9 0 0 0 0 1 0 10\ncamera 1 2 3 4 5 6 0 2 0 90", "s");
    CHECK(scene.camera.eye == Vec3(1, 2, 3));
    CHECK(scene.camera.look_at == Vec3(4, 5, 6));
    CHECK(scene.camera.up == Vec3(0, 2, 0));
    CHECK(scene.camera.fovy == pi / 2);
}

TEST_CASE("every word of a choice means its own value") {
    CHECK(parse("integrator directions").integrator == Integrator::Directions);  // all: integrators_test.cpp
    CHECK(parse("visibility rays").visibility == Visibility::Rays);
    CHECK(parse("visibility rasterize").visibility == Visibility::Rasterize);
    CHECK(parse("encoding linear").encoding == Encoding::Linear);
    CHECK(parse("encoding srgb").encoding == Encoding::Srgb);
    CHECK(parse("shadows off\nshadows on").shadows);
    CHECK(material_of("fresnel none").fresnel == Fresnel::None);
    CHECK(material_of("fresnel exact").fresnel == Fresnel::Exact);
    CHECK(material_of("fresnel schlick").fresnel == Fresnel::Schlick);
    CHECK(material_of("highlight phong").highlight == Highlight::Phong);
    CHECK(material_of("highlight phong\nhighlight blinn").highlight == Highlight::Blinn);
}

TEST_CASE("the choices that the reference lists are the ones that are known") {
    for (const SceneCommand& command : scene_commands()) {
        if (command.arguments.find('|') == std::string_view::npos) continue;
        std::istringstream words{std::string(command.arguments)};
        for (std::string word; std::getline(words, word, '|');) {
            word = word.substr(0, word.find(' '));  // without a last ` ...`
            INFO(command.name << ' ' << word);
            CHECK(error_of(std::string(command.name) + " " + word) == "");
        }
    }
}

TEST_CASE("every material command sets its own field") {
    const Material material = material_of(
        "ambient .1 .2 .3\ndiffuse .4 .5 .6\nspecular .7 .8 .9\nemission 1 2 3\nshininess 20\nior 1.5\n"
        "transmission .5 .6 .7\nabsorption .01 .02 .03\nchecker 1 .9 .8 .3 .2 .1 .25");
    CHECK(material.ambient == Vec3(.1, .2, .3));
    CHECK(material.diffuse == Vec3(.4, .5, .6));
    CHECK(material.specular == Vec3(.7, .8, .9));
    CHECK(material.emission == Vec3(1, 2, 3));
    CHECK(material.shininess == 20);
    CHECK(material.ior == 1.5);
    CHECK(material.transmission == Vec3(.5, .6, .7));
    CHECK(material.absorption == Vec3(.01, .02, .03));
    CHECK(material.checker.even == Vec3(1, .9, .8));
    CHECK(material.checker.odd == Vec3(.3, .2, .1));
    CHECK(material.checker.size == .25);
}

TEST_CASE("a material is stored when an object uses it and it changed") {
    const Scene scene = parse(
        "diffuse 1 0 0\nsphere 0 0 0 1\nsphere 1 0 0 1\ndiffuse 1 0 0\nsphere 2 0 0 1\n"
        "diffuse 0 1 0\ndiffuse 0 0 1\nsphere 3 0 0 1\ndiffuse 0 1 1");
    REQUIRE(scene.materials.size() == 2);
    CHECK(scene.materials[0].diffuse == Vec3(1, 0, 0));
    CHECK(scene.materials[1].diffuse == Vec3(0, 0, 1));
    CHECK(scene.objects[0].material == 0);
    CHECK(scene.objects[2].material == 0);
    CHECK(scene.objects[3].material == 1);
}

TEST_CASE("shapes keep their numbers and their place in the file") {
    const Scene scene = parse(
        "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
        "vertexnormal 0 0 0 0 0 1\nvertexnormal 1 0 0 0 1 0\nvertexnormal 0 1 0 2 0 0\n"
        "sphere 1 2 3 4\n  plane 0 -1 0 0 2 0\ntri 0 1 3\ntrinormal 2 1 0\npolygon 3 2 1 0");
    REQUIRE(scene.objects.size() == 5);
    CHECK(shape<Sphere>(scene, 0).center == Vec3(1, 2, 3));
    CHECK(shape<Sphere>(scene, 0).radius == 4);
    CHECK(shape<Plane>(scene, 1).point == Vec3(0, -1, 0));
    CHECK(shape<Plane>(scene, 1).normal == Vec3(0, 2, 0));
    CHECK(shape<TriangleObject>(scene, 2).vertex == std::array<std::uint32_t, 3>{0, 1, 3});
    CHECK_FALSE(shape<TriangleObject>(scene, 2).smooth);
    CHECK(shape<TriangleObject>(scene, 3).vertex == std::array<std::uint32_t, 3>{2, 1, 0});
    CHECK(shape<TriangleObject>(scene, 3).smooth);
    CHECK(shape<PolygonObject>(scene, 4).vertex == std::vector<std::uint32_t>{3, 2, 1, 0});
    CHECK(scene.vertices.at(2) == Vec3(1, 1, 0));
    CHECK(scene.smooth_vertices.at(2).position == Vec3(0, 1, 0));
    CHECK(scene.smooth_vertices.at(2).normal == Vec3(2, 0, 0));
    CHECK(scene.objects[1].place.line == 9);
    CHECK(scene.objects[1].place.column == 3);
}

TEST_CASE("an implicit surface is the rest of its line, up to a comment") {
    const Scene scene =
        parse("implicit 2 -1 0 0 1 1 x^2 + y - 1/2 # a parabola\nquadric 1 2 3 4 5 6 7 8 9 10 2 0 0 0 1 1");
    const Implicit& surface = shape<Implicit>(scene);
    CHECK(surface.box.low == Vec3(0, -1, 0));
    CHECK(surface.box.high == Vec3(2, 1, 1));
    CHECK(surface.f->text == "x^2 + y - 1/2");
    const Quadric& quadric = shape<Quadric>(scene, 1);
    CHECK(quadric.squares == Vec3(1, 2, 3));
    CHECK(quadric.mixed == Vec3(4, 5, 6));
    CHECK(quadric.linear == Vec3(7, 8, 9));
    CHECK(quadric.constant == 10);
    CHECK(quadric.box.low == Vec3(0));
    CHECK(quadric.box.high == Vec3(2, 1, 1));
}

TEST_CASE("what is wrong with an implicit surface or a quadric has its place") {
    const std::string box = "implicit -1 -1 -1 1 1 1 ";
    CHECK(error_of(box + "x+*y") == "s:1:27: a number, x, y, z, a function or '(' should be here, not '*'");
    CHECK(error_of(box + "x + wibble(y)") == "s:1:29: unknown name 'wibble'");
    CHECK(error_of("implicit 0 0 0 1 0 1 x") ==
          "s:1:18: the box has no thickness along y: both corners are at 0");
    CHECK(error_of("quadric 0 0 0 0 0 0 0 0 0 1 0 0 0 1 1 1") ==
          "s:1:9: A to I are all 0, so it has no surface");
    CHECK(error_of("quadric 1 1 1 0 0 0 0 2e30 0 1 0 0 0 1 1 1") ==
          "s:1:23: coefficients beyond 1e+30 are not possible, and this is 2e+30");
}

TEST_CASE("the coefficients of a quadric are what they are to each other") {
    const Scene scene = parse("quadric 1e-200 2e-200 0 0 0 0 0 0 0 -4e-200 0 0 0 1 1 1");
    const Quadric& tiny = shape<Quadric>(scene);
    CHECK(tiny.squares.y == 2 * tiny.squares.x);
    CHECK(tiny.constant == -4 * tiny.squares.x);
    CHECK(tiny.constant <= -1);  // so that its square is not 0
    CHECK(tiny.constant > -2);
}

TEST_CASE("what is wrong with a box, a disc, a cone or a torus has its place") {
    const std::pair<const char*, const char*> wrong[] = {
        {"box 0 0 0 1 0 1", "13: the box has no thickness along y: both corners are at 0"},
        {"box 0 0 0 1 1", "14: 'box' needs 6 arguments, here are 5; expected: box x0 y0 z0 x1 y1 z1"},
        {"box 0 0 2e30 1 1 1", "9: coordinates beyond 1e+30 are not possible, and this is 2e+30"},
        {"disc 0 0 0 0 0 0 1", "12: the normal must not be 0 0 0"},
        {"disc 0 0 0 0 1 0 0", "18: the radius must be greater than 0, not 0"},
        {"disc 0 0 0 0 1 0 1e-31", "18: the radius must be from 1e-30 to 1e+30, not 1e-31"},
        {"cylinder 0 0 0 0 0 0 1", "16: both ends are the same point"},
        {"cylinder 0 0 0 0 1 0 -1", "22: the radius must be greater than 0, not -1"},
        {"openCylinder 0 0 0 0 1e-31 0 1", "20: the ends are 1e-31 apart, less than 1e-30"},
        {"cone 0 0 0 0 0 1 0 0", "20: only one radius of a cone may be 0"},
        {"cone 0 0 0 -1 0 1 0 0", "12: the radius must not be negative, but is -1"},
        {"cone 0 0 0 1e31 0 1 0 1", "12: the radius must be from 1e-30 to 1e+30, not 1e+31"},
        {"openCone 0 0 0 1 0 0 0 2", "18: both ends are the same point"},
        {"torus 0 0 0 0 0 0 2 1", "13: the axis must not be 0 0 0"},
        {"torus 0 0 0 0 1 0 0 1", "19: the radius of the ring must be greater than 0, not 0"},
        {"torus 0 0 0 0 1 0 2 -1", "21: the radius of the tube must be greater than 0, not -1"},
        {"implicit 0 0 0 1 1 1",
         "21: 'implicit' needs at least 7 arguments, here are 6; expected: implicit x0 y0 z0 x1 y1 z1 "
         "expression ..."},
        {"implicit 0 0 0 1 1 1 x − 1", "24: an operator should be here, not '−'"},
    };
    for (const auto& [text, message] : wrong) {
        INFO(text);
        CHECK(error_of(text) == std::string("s:1:") + message);
    }
}

TEST_CASE("a combination keeps its parts in order, each with its transform, and those of its parts") {
    const Scene scene = parse(
        "union\nsphere 0 0 0 1\ntranslate 1 0 0\n"
        "difference\nbox 0 0 0 1 1 1\nsphere 0 0 0 1\nend\nend\nsphere 9 0 0 1");
    REQUIRE(scene.objects.size() == 2);
    REQUIRE(scene.parts.size() == 4);
    const CombinationObject& whole = shape<CombinationObject>(scene);
    CHECK(whole.operation == SetOperation::Union);
    CHECK(whole.parts == std::vector<std::uint32_t>{0, 3});
    CHECK(scene.objects[0].transform == -1);
    CHECK(scene.objects[0].place.line == 1);
    CHECK(scene.objects[1].transform == 0);
    const CombinationObject& inner = std::get<CombinationObject>(scene.parts[3].shape);
    CHECK(inner.operation == SetOperation::Difference);
    CHECK(inner.parts == std::vector<std::uint32_t>{1, 2});
    CHECK(scene.parts[0].transform == -1);
    CHECK(scene.parts[1].transform == 0);
    CHECK(scene.parts[2].transform == 0);
    CHECK(scene.parts[3].transform == -1);
    CHECK(scene.parts[3].place.line == 4);
}

TEST_CASE("what is wrong with a combination has its place") {
    const std::string ball = "sphere 0 0 0 1\n", other_color = "diffuse 1 0 0\n";
    const std::string one_material =
        "a solid is of one material, the one in force at its 'union' in line 1: this part has another";
    const std::pair<std::string, std::string> wrong[] = {
        {"end", "s:1:1: 'end' without a 'union', 'intersection' or 'difference' before it"},
        {"union\n" + ball + ball + "end\n end",
         "s:5:2: 'end' without a 'union', 'intersection' or 'difference' before it"},
        {"union\n" + ball + "end", "s:3:1: 'union' needs at least 2 solids, but has 1"},
        {"difference\nend", "s:2:1: 'difference' needs at least 2 solids, but has 0"},
        {"\n  union\n" + ball + ball, "s:2:3: 'union' has no 'end'"},
        {"union\nintersection\n" + ball + ball + "end", "s:1:1: 'union' has no 'end'"},
        {"union\n" + ball + " disc 0 0 0 0 1 0 1\nend",
         "s:3:2: 'union' takes solids only, and this disc has no inside"},
        {"intersection\nopenCone 0 0 0 1 0 1 0 0",
         "s:2:1: 'intersection' takes solids only, and this open cone or cylinder has no inside"},
        {"vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nunion\ntri 0 1 2",
         "s:5:1: 'union' takes solids only, and this triangle has no inside"},
        {"union\n" + ball + other_color + ball + "end", "s:4:1: " + one_material},
        {"union\n" + ball + other_color + " difference\n" + ball + ball + "end\nend",
         "s:4:2: " + one_material},
        {"union 1", "s:1:7: 'union' needs 0 arguments, here is 1; expected: union"},
    };
    for (const auto& [text, message] : wrong) {
        INFO(text);
        CHECK(error_of(text) == message);
    }
    CHECK(error_of("union\n" + ball + other_color + "diffuse 0 0 0\n" + ball + "end") == "");
    std::string deep;
    for (int i = 0; i < 1001; ++i) deep += "union\n";
    CHECK(error_of(deep) == "s:1001:1: more than 1000 solids inside each other");
}

TEST_CASE("a point light takes the attenuation in force, a directional light has none") {
    const Scene scene = parse(
        "point 1 2 3 .1 .2 .3\nattenuation 0 1 2\ndirectional 0 2 0 1 1 1\npoint 4 5 6 1 1 1\n"
        "attenuation 1 0 0\npoint 7 8 9 1 1 1");
    REQUIRE(scene.lights.size() == 4);
    CHECK(std::get<PointLight>(scene.lights[0]).position == Vec3(1, 2, 3));
    CHECK(std::get<PointLight>(scene.lights[0]).color == Vec3(.1, .2, .3));
    CHECK(std::get<PointLight>(scene.lights[0]).attenuation == Vec3(1, 0, 0));
    CHECK(std::get<DirectionalLight>(scene.lights[1]).direction == Vec3(0, 2, 0));
    CHECK(std::get<PointLight>(scene.lights[2]).attenuation == Vec3(0, 1, 2));
    CHECK(std::get<PointLight>(scene.lights[3]).attenuation == Vec3(1, 0, 0));
}

TEST_CASE("transforms form a tree, and popTransform returns to the node of its pushTransform") {
    const Scene scene = parse(
        "sphere 0 0 0 1\ntranslate 1 2 3\npushTransform\nrotate 0 0 1 90\nscale 1 2 3\nsphere 0 0 0 1\n"
        "popTransform\nsphere 0 0 0 1\nscale 2 2 2\nsphere 0 0 0 1");
    REQUIRE(scene.transforms.size() == 4);
    CHECK(std::get<Translate>(scene.transforms[0].step).by == Vec3(1, 2, 3));
    CHECK(std::get<Rotate>(scene.transforms[1].step).axis == Vec3(0, 0, 1));
    CHECK(std::get<Rotate>(scene.transforms[1].step).angle == pi / 2);
    CHECK(std::get<Scale>(scene.transforms[2].step).by == Vec3(1, 2, 3));
    CHECK(scene.transforms[0].parent == -1);
    CHECK(scene.transforms[1].parent == 0);
    CHECK(scene.transforms[2].parent == 1);
    CHECK(scene.transforms[3].parent == 0);
    CHECK(scene.transforms[2].place.line == 5);
    CHECK(scene.objects[0].transform == -1);
    CHECK(scene.objects[1].transform == 2);
    CHECK(scene.objects[2].transform == 0);
    CHECK(scene.objects[3].transform == 3);
}

TEST_CASE("transforms can be remembered a hundred thousand deep, and need not be returned from") {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "pushTransform\ntranslate 0 0 1\n";
    CHECK(parse(text + "sphere 0 0 0 1").objects.at(0).transform == 99999);
    std::string pops;
    for (int i = 0; i < 100000; ++i) pops += "popTransform\n";
    CHECK(parse(text + pops + "sphere 0 0 0 1").objects.at(0).transform == -1);
    CHECK(error_of(text + pops + "popTransform").substr(0, 12) == "s:300001:1: ");
}

TEST_CASE("blanks, line ends and comments may be as they like") {
    const Scene plain = parse_scene_text("size 32 24\nsphere 1 2 3 4\n" + camera, "s");
    for (const std::string& text : std::vector<std::string>{
             "size\t32 \t 24\t\r\n\r\n  sphere +1 2. 3.0 .4e1 # a ball\r\n" + camera,
             "\n\n\n#size 1 1\nsize 32 24#no blank\nsphere 1 2 3 4\n# end\ncamera 0 0 5 0 0 0 0 1 0 45",
             "\xEF\xBB\xBFsize 32 24\nsphere 1 2 3 4\n" + camera,
             "size 32 24\rsphere 1 2 3 4\rcamera 0 0 5 0 0 0 0 1 0 45\r",
             "\fsize 32.0 24e0\n\f\nsphere 1 2 3 4 \f\n" + camera}) {
        INFO(text);
        const Scene scene = parse_scene_text(text, "s");
        CHECK(scene.width == plain.width);
        CHECK(scene.height == plain.height);
        REQUIRE(scene.objects.size() == 1);
        CHECK(shape<Sphere>(scene).center == Vec3(1, 2, 3));
        CHECK(shape<Sphere>(scene).radius == 4);
    }
}

TEST_CASE("numbers are decimal, whole words, and correctly rounded") {
    const std::pair<const char*, Real> good[] = {
        {"1", 1},
        {"+1", 1},
        {"-1", -1},
        {".5", .5},
        {"-.5", -.5},
        {"+.5", .5},
        {"5.", 5},
        {"1e-3", 1e-3},
        {"1E3", 1000},
        {"+1.5e+2", 150},
        {"0", 0},
        {"007", 7},
        {"5e-324", 5e-324},
        {"0.1", 0.1},
        {"1.7976931348623157e308", 1.7976931348623157e308},
        {"123456789012345678901234567890", 123456789012345678901234567890.0}};
    for (const auto& [word, value] : good) {
        INFO(word);
        CHECK(parse_number(word).problem.empty());
        CHECK(parse_number(word).value == value);
    }
    for (const char* word : {"",      "+",    "-",        ".",     "e5",     "1e",     "1e+",   "1,5",
                             "1.2.3", "1f",   "0x10",     "++1",   "+-1",    "1-",     "one",   "nan",
                             "inf",   "-inf", "infinity", "1e309", "-1e309", "1e-400", "1_000", "1'000"}) {
        INFO(word);
        CHECK_FALSE(parse_number(word).problem.empty());
    }
}

TEST_CASE("what is wrong is said with its line and column") {
    const std::pair<const char*, std::string> wrong[] = {
        // Words
        {"\n\n  spere 0 0 0 1", "s:3:3: unknown command 'spere'; did you mean 'sphere'?"},
        {"poptransform", "s:1:1: unknown command 'poptransform'; did you mean 'popTransform'?"},
        {"push", "s:1:1: unknown command 'push'; did you mean 'pushTransform'?"},
        {"frobnicate 1", "s:1:1: unknown command 'frobnicate'"},
        {"si\x1bze 1 1", "s:1:1: unknown command 'si?ze'; did you mean 'size'?"},
        {"sphere 1 2 3", "s:1:13: 'sphere' needs 4 arguments, here are 3; expected: sphere x y z r"},
        {"sphere 1 2 3 \t # 4", "s:1:13: 'sphere' needs 4 arguments, here are 3; expected: sphere x y z r"},
        {"sphere 1 2 3 4 5", "s:1:16: 'sphere' needs 4 arguments, here are 5; expected: sphere x y z r"},
        {"shininess", "s:1:10: 'shininess' needs 1 argument, here are 0; expected: shininess s"},
        {"pushTransform 1", "s:1:15: 'pushTransform' needs 0 arguments, here is 1; expected: pushTransform"},
        {"polygon 0 1",
         "s:1:12: 'polygon' needs at least 3 arguments, here are 2; expected: polygon i j k ..."},
        // Numbers
        {"sphere 1 two 3 4", "s:1:10: 'two' is not a number; expected: sphere x y z r"},
        {"\t\tvertex 1 2 3x", "s:1:14: '3x' is not a number; expected: vertex x y z"},
        {"vertex 1,5 2 3",
         "s:1:8: '1,5' is not a number: decimals are written with a point; expected: vertex x y z"},
        {"vertex nan 2 3", "s:1:8: 'nan' is not a finite number; expected: vertex x y z"},
        {"vertex 1 -inf 3", "s:1:10: '-inf' is not a finite number; expected: vertex x y z"},
        {"vertex 1 2 1e999",
         "s:1:12: '1e999' is beyond the numbers that a double can hold; expected: vertex x y z"},
        {"size 320.5 240", "s:1:6: '320.5' is not a whole number; expected: size w h"},
        // Ranges
        {"size 0 240", "s:1:6: width must be from 1 to 65536, not 0"},
        {"size 320 -1", "s:1:10: height must be from 1 to 65536, not -1"},
        {"size 65537 1", "s:1:6: width must be from 1 to 65536, not 65537"},
        {"size 65536 65536", "s:1:6: 65536 by 65536 is 4294967296 pixels; at most 67108864 are possible"},
        {"maxdepth -1", "s:1:10: the number of bounces must be from 0 to 2147483647, not -1"},
        {"maxverts -1", "s:1:10: the number of vertices must be from 0 to 9007199254740992, not -1"},
        {"maxvertnorms 1.5", "s:1:14: '1.5' is not a whole number; expected: maxvertnorms n"},
        {"sphere 0 0 0 0", "s:1:14: the radius must be greater than 0, not 0"},
        {"sphere 0 0 0 -2", "s:1:14: the radius must be greater than 0, not -2"},
        {"orthographic 0", "s:1:14: the height of the view must be greater than 0, not 0"},
        {"checker 1 1 1 0 0 0 0", "s:1:21: the size of the checker's cubes must be greater than 0, not 0"},
        {"ior 0", "s:1:5: the index of refraction must be greater than 0, not 0"},
        {"shininess -1", "s:1:11: the shininess must not be negative, but is -1"},
        {"mincontribution -1", "s:1:17: the least contribution must not be negative, but is -1"},
        {"transmission 0 -1 0", "s:1:16: transmission must not be negative, but is -1"},
        {"absorption 0 0 -1", "s:1:16: absorption must not be negative, but is -1"},
        {"attenuation 1 0 -1", "s:1:17: attenuation must not be negative, but is -1"},
        {"attenuation 0 0 0", "s:1:13: attenuation 0 0 0 would divide light by zero"},
        {"version 2", "s:1:9: the version of the language must be from 1 to 1, not 2"},
        {"size 1 1\nversion 1", "s:2:1: 'version' must be the first command"},
        // Directions
        {"plane 0 0 0 0 0 0", "s:1:13: the normal must not be 0 0 0"},
        {"vertexnormal 1 2 3 0 0 0", "s:1:20: the normal must not be 0 0 0"},
        {"directional 0 0 0 1 1 1", "s:1:13: the direction to the light must not be 0 0 0"},
        {"rotate 0 0 0 90", "s:1:8: the axis of a rotation must not be 0 0 0"},
        {"scale 1 0 1", "s:1:9: a scale factor of 0 makes things flat; it must not be 0"},
        {"scale 1 1 -0", "s:1:11: a scale factor of 0 makes things flat; it must not be 0"},
        // Camera
        {"camera 1 2 3 1 2 3 0 1 0 45", "s:1:14: the camera looks at the point where it stands"},
        {"camera 0 0 5 0 0 0 0 0 0 45", "s:1:20: the up direction must not be 0 0 0"},
        {"camera 0 0 5 0 0 0 0 0 1 45", "s:1:20: the up direction is parallel to the direction of view"},
        {"camera .1 .2 .3 .4 .8 1.2 -1 -2 -3 45",
         "s:1:27: the up direction is parallel to the direction of view"},
        {"camera 0 0 5 0 0 0 0 1 0 0",
         "s:1:26: the field of view must be between 0 and 180 degrees, both excluded, not 0"},
        {"camera 0 0 5 0 0 0 0 1 0 180",
         "s:1:26: the field of view must be between 0 and 180 degrees, both excluded, not 180"},
        // Indices
        {"tri 0 1 2", "s:1:5: index 0: no vertex stands before this line"},
        {"vertex 0 0 0\ntrinormal 0 0 0", "s:2:11: index 0: no vertexnormal stands before this line"},
        {"vertex 0 0 0\nvertex 0 0 1\ntri 0 1 2",
         "s:3:9: index 2 is out of range: 0 to 1 stand before this line"},
        {"vertex 0 0 0\ntri 0 -1 0", "s:2:7: index -1 is out of range: 0 to 0 stand before this line"},
        {"vertex 0 0 0\ntri 0 .5 0", "s:2:7: '.5' is not a whole number; expected: tri a b c"},
        {"vertex 0 0 0\npolygon 0 0 0 4", "s:2:15: index 4 is out of range: 0 to 0 stand before this line"},
        // Choices
        {"integrator normal",
         "s:1:12: 'normal' is not a known integrator; did you mean 'normals'?; expected: integrator " +
             integrator_words},
        {"encoding SRGB",
         "s:1:10: 'SRGB' is not a known encoding; did you mean 'srgb'?; expected: encoding linear|srgb"},
        {"shadows maybe", "s:1:9: 'maybe' is not a known shadows; expected: shadows on|off"},
        // Order
        {"popTransform", "s:1:1: 'popTransform' without a 'pushTransform' before it"},
        {"pushTransform\npopTransform\n popTransform",
         "s:3:2: 'popTransform' without a 'pushTransform' before it"},
    };
    for (const auto& [text, message] : wrong) {
        INFO(text);
        CHECK(error_of(text) == message);
    }
}

TEST_CASE("a scene without a camera is wrong at its last line") {
    const std::string message =
        "1: no camera in the whole file; expected somewhere: camera fx fy fz ax ay az ux uy uz fovy";
    CHECK(error_of_whole("") == "s:1:" + message);
    CHECK(error_of_whole("size 1 1\n\nsphere 0 0 0 1\n") == "s:3:" + message);
    CHECK(error_of_whole("size 1 1\nsphere 0 0 0 1") == "s:2:" + message);
}

TEST_CASE("an upright camera is accepted however large or small its numbers") {
    CHECK(error_of("camera 1e30 0 0 -1e30 0 0 0 1e308 0 45") == "");
    CHECK(error_of("camera 1e-320 0 0 0 0 0 0 1e-320 0 45") == "");
    CHECK(error_of("camera 0 0 5 0 0 0 0 1e-9 1 45") == "");
    CHECK(error_of("camera 0 0 5e-324 0 0 0 0 0 1 45") != "");
    CHECK(error_of("camera 1e30 0 0 -1e30 0 0 1 0 0 45") != "");
}

TEST_CASE("what is no text is refused with its place") {
    const std::string nul(1, '\0');
    CHECK(error_of("size 1 1\nsph" + nul + "ere 0 0 0 1") == "s:2:4: a zero byte: this is not a text file");
    CHECK(error_of_whole("\x89PNG\r\n\x1a\n" + nul) == "s:3:1: a zero byte: this is not a text file");
    CHECK(error_of_whole("\xFF\xFEs") == "s:1:1: the file is in UTF-16; save it as UTF-8");
    CHECK(error_of("#" + std::string(1000000, 'x')) == "");
    CHECK(error_of("\n" + std::string(1100000, 'x')) ==
          "s:2:1: the line is longer than a megabyte: this does not look like a scene file");
    CHECK(error_of(std::string(100, 'x')) == "s:1:1: unknown command '" + std::string(40, 'x') + "…'");
}

TEST_CASE("lenient reading skips what other programs may know, says so, and forgives nothing else") {
    std::vector<std::string> warnings;
    const ParseOptions lenient{.lenient = true, .warnings = &warnings};
    CHECK(parse("spere 0 0 0 1\nsphere 0 0 0 1\nmotionblur", lenient).objects.size() == 1);
    CHECK(warnings == std::vector<std::string>{
                          "s:1:1: unknown command 'spere'; did you mean 'sphere'? (line skipped)",
                          "s:3:1: unknown command 'motionblur'; did you mean 'motion'? (line skipped)"});
    warnings.clear();
    const Scene scene = parse(
        "integrator pathtracer\nmaxdepth -1\nspp 0\nsphere 0 0 0 1 red\nshadows maybe\nseed 1.5\n", lenient);
    CHECK(scene.integrator == Integrator::Raytrace);
    CHECK(scene.max_depth == 5);
    CHECK(scene.sampling.count == 1);
    CHECK(shape<Sphere>(scene).radius == 1);
    CHECK(scene.shadows);
    REQUIRE(warnings.size() == 6);
    CHECK(warnings[0] ==
          "s:1:12: 'pathtracer' is not a known integrator; it comes with chapter 14; expected: integrator " +
              integrator_words + " (line skipped)");
    CHECK(warnings[1] == "s:2:10: the number of bounces must be from 0 to 2147483647, not -1 (line skipped)");
    CHECK(warnings[3] ==
          "s:4:16: 'sphere' needs 4 arguments, here are 5; expected: sphere x y z r (the rest of the line is "
          "skipped)");
    for (const char* wrong : {"sphere 0 0 0", "sphere 0 0 0 -1", "maxdepth many", "spp nan", "size 0 0",
                              "tri 0 1 2", "popTransform", "diffuse 1 x 1"}) {
        INFO(wrong);
        CHECK(error_of(wrong, lenient) == error_of(wrong));
        CHECK(error_of(wrong, lenient) != "");
    }
    CHECK(parse("spere", {.lenient = true}).objects.empty());
}

TEST_CASE("what blurs is stored, and refused where it means nothing") {
    const Scene scene = parse(
        "lens .25 7\naperture 5 90\nshutter .125 .25\ncameramotion 1 2 3\nlightsamples 9\nlightstratify on\n"
        "lightsampling area\nlightchoice one\ngamma 2.2\nquadLight 0 3 0  1 0 0  0 0 1  4 5 6\n"
        "motion 0 1 0\ngloss 50\nsphere 0 0 0 1\nmotion 0 0 0\ntranslucency 60\nbrdf ggx\nroughness .5\n"
        "sphere 0 0 0 1\n");
    CHECK(scene.lens.radius == 0.25);
    CHECK(scene.lens.distance == 7);
    CHECK(scene.lens.sides == 5);
    CHECK(scene.lens.turn == Approx(pi / 2));
    CHECK(scene.shutter.opening == 0.125);
    CHECK(scene.shutter.closing == 0.25);
    CHECK(scene.camera_motion == Vec3(1, 2, 3));
    CHECK(scene.light_samples.count == 9);
    CHECK(scene.light_samples.stratified);
    CHECK(scene.light_samples.how == LightSampling::Area);
    CHECK_FALSE(scene.light_samples.all);
    CHECK(scene.gamma == 2.2);
    REQUIRE(scene.area_lights.size() == 1);
    CHECK(scene.area_lights[0].light.radiance == Vec3(4, 5, 6));
    CHECK(std::get<QuadLight>(scene.area_lights[0].light.shape).ac == Vec3(0, 0, 1));
    REQUIRE(scene.objects.size() == 2);
    CHECK(scene.objects[0].motion == Vec3(0, 1, 0));
    CHECK(scene.objects[1].motion == Vec3(0));
    CHECK(scene.transforms.empty());
    const Scene turning = parse("spin 0 0 2 720\nspin 0 1 0 0\nsphere 0 0 0 1\nrotate 0 0 1 90\n");
    REQUIRE(turning.transforms.size() == 2);  // what never turns is no step
    CHECK(turning.objects[0].transform == 0);
    CHECK(std::get<Rotate>(turning.transforms[0].step).angle == 0);
    CHECK(std::get<Rotate>(turning.transforms[0].step).axis == Vec3(0, 0, 2));
    CHECK(turning.transforms[0].spin == Approx(4 * pi));
    CHECK(turning.transforms[1].spin == 0);
    const auto finish = [&](std::size_t i) {
        return scene.finishes[static_cast<std::size_t>(scene.materials[scene.objects[i].material].finish)];
    };
    CHECK(finish(0).gloss == 50);
    CHECK(finish(0).translucency == 0);
    CHECK(finish(1).translucency == 60);
    CHECK(finish(1).brdf == Brdf::Ggx);
    CHECK(finish(1).roughness == 0.5);

    CHECK(error_of("quadLight 0 0 0  1 0 0  2 0 0  1 1 1") ==
          "s:1:1: this light has no area: its edges have no length, or one direction");
    CHECK(error_of("sphereLight 0 0 0  1  1 -1 1") != "");
    CHECK(error_of("lens -1 5") != "");
    CHECK(error_of("lens 1 0") != "");
    CHECK(error_of("aperture 2") == "s:1:10: an aperture has 3 sides or more, or 0 if it is round");
    CHECK(error_of("shutter .6 .5") ==
          "s:1:12: opening and closing are parts of the whole time: together 1 at most");
    CHECK(error_of("gloss 1e9") != "");
    CHECK(error_of("roughness 2") == "s:1:11: the roughness must be from 0 to 1, not 2");
    CHECK(error_of("lightsamples 0") != "");
}

TEST_CASE("words that other programs use are known by what they are called here") {
    const auto hint = [](const std::string& line) {
        const std::string message = error_of(line);
        const std::size_t begin = message.find("; ");
        return begin == std::string::npos ? "" : message.substr(begin, message.find("; expected") - begin);
    };
    CHECK(hint("triangle 0 1 2") == "; did you mean 'tri'?");
    CHECK(hint("Refraction 1 1 1") == "; did you mean 'transmission' or 'ior'?");
    CHECK(hint("antialias 4") == "; did you mean 'spp'?");
    CHECK(hint("samples 4") == "; did you mean 'spp'?");
    CHECK(hint("light 0 0 0 1 1 1") == "; did you mean 'point' or 'directional'?");
    CHECK(hint("areaLight -1 2 -1 2 0 0 0 0 2 5 5 5") == "; did you mean 'quadLight'?");
    CHECK(hint("dof .1 5") == "; did you mean 'lens'?");
    CHECK(hint("integrator whitted") == "; did you mean 'raytrace'?");
    CHECK(hint("integrator pathtracer") == "; it comes with chapter 14");
    CHECK(hint("shadows true") == "; did you mean 'on'?");
    // What is a word of this language has no other meaning.
    for (const SceneCommand& command : scene_commands()) {
        INFO(command.name);
        CHECK(meaning_elsewhere(command.name) == "");
        std::istringstream words{std::string(command.arguments)};
        for (std::string word; std::getline(words, word, '|');)
            CHECK(meaning_elsewhere(command.name, word) == "");
    }
    // And every meaning is one.
    for (const char* word : {"resolution", "lookat", "eye", "aa", "ball", "obj", "kd", "mirror", "glass",
                             "sun", "falloff", "pushMatrix", "pointLight", "bgcolor"}) {
        std::string meaning = meaning_elsewhere(word);
        INFO(word << meaning);
        const std::size_t begin = meaning.find('\'') + 1;
        const std::string name = meaning.substr(begin, meaning.find('\'', begin) - begin);
        CHECK(std::any_of(scene_commands().begin(), scene_commands().end(),
                          [&](const SceneCommand& command) { return command.name == name; }));
    }
}

TEST_CASE("a lone carriage return ends a line, whatever ends the others") {
    CHECK(parse("# the ball\rsphere 0 0 0 1").objects.size() == 1);
    CHECK(parse("# old Mac\rsize 3 2\rsphere 0 0 0 1\r\nsphere 1 0 0 1\rsphere 2 0 0 1").objects.size() == 3);
    CHECK(error_of("size 3 2\rsize 3 2\r\nsize 3 2\n\rsphere 0 0 0 x").starts_with("s:5:14: 'x'"));
    CHECK(error_of("size 3 2\r\rsph" + std::string(1, '\0')) ==
          "s:3:4: a zero byte: this is not a text file");
}

TEST_CASE("a comment inside a word is warned of, and NaN of any compiler is an error") {
    std::vector<std::string> warnings;
    CHECK(shape<Sphere>(parse("sphere 0 0 0 2#5", {.warnings = &warnings})).radius == 2);
    CHECK(warnings ==
          std::vector<std::string>{"s:1:15: a comment begins inside a word; put a blank before the '#'"});
    warnings.clear();
    parse("sphere 0 0 0 2 #5\n# a#b\n", {.warnings = &warnings});
    CHECK(warnings.empty());
    for (const char* word : {"-1.#IND", "1.#QNAN", "1.#INF", "1.#INF000", "nan", "-nan(ind)", "inf"}) {
        INFO(word);
        CHECK(error_of("sphere 0 0 " + std::string(word) + " 1") ==
              "s:1:12: '" + std::string(word) + "' is not a finite number; expected: sphere x y z r");
    }
    CHECK(shape<Sphere>(parse("sphere 0 0 0 1.#ball")).radius == 1);
}

TEST_CASE("files that cannot be read are named with the reason") {
    const auto message = [](const std::string& path) { return test::error_of([&] { parse_scene(path); }); };
    const std::string directory = rt::test::scratch_directory() + "/unreadable";
    std::filesystem::create_directories(directory);
    write_file(directory + "/spheres.test", camera);
    CHECK(message(directory) == directory + ": is a directory, not a file");
    CHECK(message(directory + "/sphere.test") ==
          directory + "/sphere.test: there is no such file; did you mean 'spheres.test'?");
    CHECK(message(directory + "/other") == directory + "/other: there is no such file");
    CHECK(message("") == ": there is no such file");
    write_file(directory + "/bad.test", "size 1\n");
    CHECK(message(directory + "/bad.test") ==
          directory + "/bad.test:1:7: 'size' needs 2 arguments, here is 1; expected: size w h");
    CHECK(message(directory + "/spheres.test") == "");
}

TEST_CASE("objects that name the same mesh file share it") {
    const std::string directory = rt::test::scratch_directory() + "/shared_mesh";
    std::filesystem::create_directories(directory + "/models");
    write_file(directory + "/models/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_file(directory + "/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3 4\n");
    write_file(directory + "/m.test",
               "mesh models/a.obj\ntranslate 1 0 0\nmesh models/../models/a.obj\nmesh b.obj\n" + camera);
    const Scene scene = parse_scene(directory + "/m.test");
    REQUIRE(scene.meshes.size() == 2);
    CHECK(scene.meshes[0].file == "models/a.obj");
    CHECK(scene.meshes[0].triangles.size() == 1);
    CHECK(scene.meshes[1].triangles.size() == 2);
    CHECK(shape<MeshObject>(scene, 0).mesh == 0);
    CHECK(shape<MeshObject>(scene, 1).mesh == 0);
    CHECK(shape<MeshObject>(scene, 2).mesh == 1);
    CHECK(scene.objects[1].transform == 0);
}

TEST_CASE("what is wrong with a mesh is said with the lines of both files") {
    const std::string directory = rt::test::scratch_directory() + "/wrong_mesh";
    std::filesystem::create_directories(directory);
    write_file(directory + "/a.obj", "v 0 0 0\nv 1 0 zero\n");
    const auto message = [&](const std::string& line) {
        return test::error_of([&] { parse_scene_text("\n" + line, "s", directory); });
    };
    CHECK(message("  mesh a.obj") == "s:2:8: mesh " + directory + "/a.obj:2:7: 'zero' is not a number");
    CHECK(message("mesh b.obj") ==
          "s:2:6: mesh " + directory + "/b.obj: there is no such file; did you mean 'a.obj'?");
    CHECK(error_of("mesh a.obj", {.files = false}) ==
          "s:1:1: 'mesh' reads a file, which is not allowed here");
}

TEST_CASE("a scene of a hundred thousand lines is read whole") {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "sphere " + std::to_string(i) + " 0.125 -3.5e2 0.1\n";
    const Scene scene = parse(text);
    REQUIRE(scene.objects.size() == 100000);
    CHECK(shape<Sphere>(scene, 99999).center == Vec3(99999, .125, -350));
    CHECK(scene.objects[99999].place.line == 100000);
    CHECK(scene.materials.size() == 1);
}

TEST_CASE("the reference lists exactly the commands") {
    const std::string readme = read_file(rt::test::repository() + "/common/scene/README.md");
    const std::string begin = "<!-- commands -->\n", end = "<!-- /commands -->";
    const std::size_t from = readme.find(begin), to = readme.find(end);
    REQUIRE(from != std::string::npos);
    REQUIRE(to != std::string::npos);
    const std::string listed = readme.substr(from + begin.size(), to - from - begin.size());
    INFO("./course exercises --make writes the table");
    CHECK((listed == scene_command_table()));
}

TEST_CASE("scenes as the base format's users write them are read whole") {
    struct Counts {
        std::size_t objects, lights, vertices, smooth_vertices, materials;
    };
    const std::map<std::string, Counts> counts = {
        {"beads.test", {1000, 2, 0, 0, 1000}},   {"fan.test", {22, 2, 0, 0, 21}},
        {"glow.test", {39, 0, 0, 0, 38}},        {"goblet.test", {882, 2, 4, 460, 2}},
        {"lamps.test", {12, 6, 4, 0, 2}},        {"mirrors.test", {134, 2, 81, 0, 8}},
        {"penguins.test", {25, 2, 0, 0, 9}},     {"room.test", {34, 1, 16, 0, 5}},
        {"serpent.test", {2002, 2, 1014, 0, 2}}, {"star.test", {32, 2, 6, 0, 3}},
        {"steps.test", {300, 2, 8, 0, 25}},      {"table.test", {79, 2, 8, 0, 9}},
    };
    std::size_t found = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(rt::test::repository() + "/tests/common/base_scenes")) {
        const std::string name = entry.path().filename().string();
        INFO(name);
        const Scene scene = parse_scene(entry.path());
        REQUIRE(counts.count(name) == 1);
        const Counts& expected = counts.at(name);
        CHECK(scene.objects.size() == expected.objects);
        CHECK(scene.lights.size() == expected.lights);
        CHECK(scene.vertices.size() == expected.vertices);
        CHECK(scene.smooth_vertices.size() == expected.smooth_vertices);
        CHECK(scene.materials.size() == expected.materials);
        CHECK(scene.width >= 160);
        CHECK(scene.width <= 320);
        ++found;
    }
    CHECK(found == counts.size());
    CHECK(found >= 10);
}

TEST_CASE("the nearest name is suggested, and none where none is near") {
    const std::vector<std::string_view> names = {"sphere", "specular",      "shadows",     "scale",
                                                 "size",   "pushTransform", "popTransform"};
    CHECK(suggest("spere", names) == "sphere");
    CHECK(suggest("shpere", names) == "sphere");
    CHECK(suggest("Sphere", names) == "sphere");
    CHECK(suggest("sizes", names) == "size");
    CHECK(suggest("poptransfrom", names) == "popTransform");
    CHECK(suggest("push", names) == "pushTransform");
    CHECK_FALSE(suggest("light", names));
    CHECK_FALSE(suggest("", names));
    CHECK_FALSE(suggest("x", names));
    CHECK_FALSE(suggest("sphere", {}));
    const std::vector<std::string_view> two = {"vertexnormal", "vertexcolour"};
    CHECK_FALSE(suggest("vertex", two));
    CHECK(suggest("vertexn", two) == "vertexnormal");
    CHECK(did_you_mean("spere", names) == "; did you mean 'sphere'?");
    CHECK(did_you_mean("light", names).empty());
}

TEST_CASE("the edit distance counts inserted, deleted, replaced and swapped letters") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("", "ab") == 2);
    CHECK(edit_distance("abc", "abc") == 0);
    CHECK(edit_distance("abc", "ABC") == 0);
    CHECK(edit_distance("abc", "abxc") == 1);
    CHECK(edit_distance("abc", "ac") == 1);
    CHECK(edit_distance("abc", "axc") == 1);
    CHECK(edit_distance("abc", "acb") == 1);
    CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("the commands of chapters 8, 9 and 13", "[parse]") {
    const Scene plain = parse("");
    CHECK(plain.sampling.count == 1);
    CHECK(plain.sampling.filter.kind == FilterKind::Box);
    CHECK(plain.sampling.filter.radius == 0.5);
    CHECK(plain.accelerator == AcceleratorChoice::Auto);

    const Scene scene =
        parse("spp 16\nsampler random\nadaptive on\nfilter mitchell\nseed 12\naccelerator nested");
    CHECK(scene.sampling.count == 16);
    CHECK(scene.sampling.sampler == Sampler::Random);
    CHECK(scene.sampling.adaptive);
    CHECK(scene.sampling.filter.kind == FilterKind::Mitchell);
    CHECK(scene.sampling.filter.radius == 2);
    CHECK(scene.sampling.seed == 12);
    CHECK(scene.accelerator == AcceleratorChoice::Nested);
    CHECK(parse("sampler trapezoid").sampling.sampler == Sampler::Trapezoid);
    CHECK(parse("sampler centered").sampling.sampler == Sampler::Centered);
    CHECK(parse("filter gaussian").sampling.filter.radius == 1.5);
    CHECK(parse("accelerator grid").accelerator == AcceleratorChoice::Grid);
    CHECK(parse("accelerator bvh").accelerator == AcceleratorChoice::Bvh);
    CHECK(parse("accelerator spheres").accelerator == AcceleratorChoice::Spheres);
    CHECK(parse("accelerator obb").accelerator == AcceleratorChoice::OrientedBoxes);
    CHECK(parse("accelerator ellipsoids").accelerator == AcceleratorChoice::Ellipsoids);

    CHECK(error_of("spp 0") == "s:1:5: the number of samples must be from 1 to 65536, not 0");
    CHECK(error_of("spp 2.5").starts_with("s:1:5: '2.5' is not a whole number"));
    CHECK(error_of("seed -1").starts_with("s:1:6: the seed must be from 0 to"));
    CHECK(error_of("sampler jitered").find("did you mean 'jittered'?") != std::string::npos);
    CHECK(error_of("accelerator tree").starts_with("s:1:13: 'tree' is not a known accelerator"));
    // Some patterns have a given number of samples; the command's own place is told, wherever the other
    // stands.
    CHECK(error_of("\nadaptive on\nsampler poisson").starts_with("s:2:1: 'adaptive on' needs"));
    CHECK(error_of("sampler regular\nadaptive on\nadaptive off").empty());
}
