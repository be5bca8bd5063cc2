// Pictures, patterns and skies in whole scenes: what is read, what a world keeps, what is seen.
#include "common/image/file.hpp"
#include "common/povray/export.hpp"
#include "common/render/snapshots.hpp"
#include "common/scene/language/commands.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"
#include "tests/worlds.hpp"

#include <cmath>
#include <filesystem>
#include <functional>

using namespace rt;
using test::picture_of;
using test::world_of;

namespace {

namespace fs = std::filesystem;

const std::string camera = "camera 0 0 4 0 0 0 0 1 0 30\nsize 8 8\n";

/// Four colours: red and green above, blue and grey below.
Image four_colors() {
    Image image = make_image(2, 2);
    image.pixels = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.5)};
    return image;
}

/// A directory that has the picture as `four.pfm`.
fs::path with_picture() {
    const fs::path directory = fs::path(test::scratch_directory()) / "textures";
    fs::create_directories(directory);
    write_image(directory / "four.pfm", four_colors());
    return directory;
}

Scene scene_of(const std::string& text) { return parse_scene_text(text, "test.scene", with_picture()); }

std::string error_of(const std::string& text) {
    return test::error_of([&] { compile(scene_of(camera + text)); });
}

Image picture_with(const std::string& text) { return render(compile(scene_of(camera + text))).image; }

/// A wall of one unit, across z, whose picture fills the view.
const std::string wall = "orthographic 1\nambient 1 1 1\ntranslate -.5 -.5 0\nplane 0 0 0 0 0 1\n";

}  // namespace

TEST_CASE("a picture is read once, whatever it is called") {
    const Scene scene = scene_of(camera +
                                 "texture four.pfm\nsphere 0 0 0 1\ntexture ../textures/four.pfm\n"
                                 "sphere 1 0 0 1\ntexture off\nsphere 2 0 0 1\n");
    CHECK(scene.pictures.size() == 1);
    REQUIRE(scene.materials.size() == 2);
    CHECK(scene.materials[0].texturing == 0);
    CHECK(scene.materials[1].texturing == -1);
    CHECK(files_of("scenes/a.scene", scene).back() == fs::path("scenes/four.pfm"));
}

TEST_CASE("a picture that cannot be read is an error at its place") {
    CHECK(error_of("texture none.png\n") == "test.scene:3:9: picture " +
                                                (with_picture() / "none.png").string() +
                                                ": cannot be read: No such file or directory");
    CHECK(error_of("texture four.bmp\n").find("test.scene:3:9: picture ") == 0);
    CHECK(test::error_of([] { parse_scene_text("texture a.png\n", "s", {}, {.files = false}); }) ==
          "s:1:1: 'texture' reads a file, which is not allowed here");
}

TEST_CASE("a plane shows its picture upright, from its point on, in units of length") {
    const Image seen = picture_with("texturefilter nearest\ntexture four.pfm\n" + wall);
    CHECK(pixel(seen, 0, 0) == Vec3(1, 0, 0));
    CHECK(pixel(seen, 7, 0) == Vec3(0, 1, 0));
    CHECK(pixel(seen, 0, 7) == Vec3(0, 0, 1));
    CHECK(pixel(seen, 7, 7) == Vec3(0.5));
}

TEST_CASE("a picture goes with the transform of its object") {
    // Turned upside down about z; twice as large.
    const Image turned = picture_with(
        "orthographic 1\nambient 1 1 1\ntexturefilter nearest\n"
        "texture four.pfm\nrotate 0 0 1 180\ntranslate -.5 -.5 0\n"
        "plane 0 0 0 0 0 1\n");
    CHECK(pixel(turned, 0, 0) == Vec3(0.5));
    CHECK(pixel(turned, 7, 7) == Vec3(1, 0, 0));
    const Image large = picture_with(
        "orthographic 1\nambient 1 1 1\ntexturefilter nearest\n"
        "texture four.pfm\nscale 2 2 2\ntranslate -.25 -.25 0\n"
        "plane 0 0 0 0 0 1\n");
    CHECK(pixel(large, 0, 0) == Vec3(0, 0, 1));
    CHECK(pixel(large, 7, 0) == Vec3(0, 0, 1));
}

TEST_CASE("beyond its edges a picture is repeated, mirrored, or keeps its last colour") {
    const std::string beside = "orthographic 1\nambient 1 1 1\ntranslate -1.5 -.5 0\nplane 0 0 0 0 0 1\n";
    const auto first = [&](const std::string& wrap) {
        return pixel(
            picture_with("texturefilter nearest\ntexturewrap " + wrap + "\ntexture four.pfm\n" + beside), 0,
            0);
    };
    CHECK(first("repeat") == Vec3(1, 0, 0));
    CHECK(first("mirror") == Vec3(0, 1, 0));
    CHECK(first("clamp") == Vec3(0, 1, 0));
}

TEST_CASE("`textured` says which numbers are multiplied") {
    const std::string with = "texturefilter nearest\ntexture four.pfm\n",
                      lit = "diffuse 1 1 1\ndirectional 0 0 1 .25 .25 .25\n";
    CHECK(pixel(picture_with(with + "textured diffuse\n" + lit + wall), 0, 0) == Vec3(1.25, 1, 1));
    CHECK(pixel(picture_with(with + "textured ambient\n" + lit + wall), 0, 0) == Vec3(1.25, 0.25, 0.25));
    CHECK(pixel(picture_with(with + "textured specular\n" + lit + wall), 0, 0) == Vec3(1.25));
    CHECK(error_of("textured ambiant\n") ==
          "test.scene:3:10: 'ambiant' is not a known textured; did you mean 'ambient'?; expected: textured "
          "ambient|diffuse|emission|specular|transmission|absorption|shininess|finish|coat|gloss|"
          "translucency|roughness ...");
    CHECK(error_of("textured ior\n")
              .find("test.scene:3:10: 'ior' is not a known textured; a body has one index "
                    "of refraction, by which light bends where it enters and leaves") == 0);
}

TEST_CASE("a pattern takes the place of the one before, and white ones are none") {
    const Scene scene = scene_of(camera +
                                 "stripes 1 0 0 0 1 0 .5\nrings 1 1 0 0 0 1 2\nsphere 0 0 0 1\n"
                                 "rings 1 1 1 1 1 1 1\nsphere 0 0 0 1\n");
    REQUIRE(scene.texturings.size() == 1);
    REQUIRE(scene.texturings[0].pattern);
    CHECK(scene.texturings[0].pattern->kind == PatternKind::Rings);
    CHECK(scene.texturings[0].pattern->size == 2);
    CHECK(scene.materials[1].texturing == -1);
}

TEST_CASE("a plane exactly between two stripes has one colour") {
    for (const char* const place : {"-1", "0", ".1", ".7", "3"}) {
        const Image seen = picture_of(
            "camera 9 0 0 0 0 0 0 1 0 30\nsize 16 16\northographic 1\nambient 1 1 1\n"
            "stripes 1 0 0 0 0 1 .1\nplane " +
            std::string(place) + " 0 0 1 0 0\n");
        INFO("a plane at x = " << place);
        CHECK(std::ranges::count(seen.pixels, seen.pixels[0]) == 256);
    }
}

TEST_CASE("a polygon shows its picture from its first vertex to its second and its last") {
    const std::string square =
        "orthographic 2\nambient 1 1 1\ntexturefilter nearest\ntexture four.pfm\n"
        "vertex -1 -1 0\nvertex 1 -1 0\nvertex 1 1 0\nvertex -1 1 0\n";
    const Image seen = picture_with(square + "polygon 0 1 2 3\n");
    CHECK(pixel(seen, 0, 0) == Vec3(1, 0, 0));
    CHECK(pixel(seen, 7, 0) == Vec3(0, 1, 0));
    CHECK(pixel(seen, 0, 7) == Vec3(0, 0, 1));
    const Image turned = picture_with(square + "rotate 0 0 1 180\npolygon 0 1 2 3\n");
    CHECK(pixel(turned, 0, 0) == Vec3(0.5));
    CHECK(pixel(turned, 7, 7) == Vec3(1, 0, 0));
    CHECK(
        error_of("texture four.pfm\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex -1 1 0\nvertex -1 0 0\n"
                 "polygon 0 1 2 3 4\n") ==
        "test.scene:9:1: the corner of this polygon between its last, first and second vertex, which tells "
        "where its picture lies, is straight: begin with another vertex");
}

TEST_CASE("a ball that a quadric, a formula or a combination says shows the ball's picture") {
    const std::string look = "ambient 1 1 1\ntexture four.pfm\n", turned = "rotate 1 2 3 40\n";
    const std::string quadric = "quadric 1 1 1 0 0 0 0 0 0 -1 -2 -2 -2 2 2 2\n",
                      formula = "implicit -2 -2 -2 2 2 2 x^2+y^2+z^2-1\n",
                      both = "intersection\nsphere 0 0 0 1\nbox -2 -2 -2 2 2 2\nend\n";
    for (const std::string& place : {std::string(), turned}) {
        const Image ball = picture_with(look + place + "sphere 0 0 0 1\n");
        for (const std::string& shape : {quadric, formula, both}) {
            INFO(place << shape);
            // The points that are met differ by rounding.
            CHECK(test::differing(ball, picture_with(look + place + shape), 1e-9) == 0);
        }
    }
}

TEST_CASE("the parts of a combination show pictures as they would alone") {
    const std::string look = "ambient 1 1 1\ntexturefilter nearest\ntexture four.pfm\n";
    // From a box a tilted half space is taken away, beside what is seen; then all in front of it.
    const std::string box = "box -1 -1 -1 1 1 1\n", cut = "rotate 0 0 1 90\nplane 0 0 .5 0 0 -1\n";
    CHECK(test::differing(picture_with(look + box),
                          picture_with(look + "difference\n" + box + "sphere 0 0 -1 .5\nend\n")) == 0);
    const Image face = picture_with(look + "difference\n" + box + cut + "end\n"),
                half_space = picture_with(look + cut);
    CHECK(pixel(face, 4, 4) == pixel(half_space, 4, 4));
    CHECK(pixel(face, 3, 4) == pixel(half_space, 3, 4));
    CHECK(pixel(face, 4, 3) == pixel(half_space, 4, 3));
    CHECK(pixel(face, 3, 3) != pixel(face, 4, 4));
}

TEST_CASE("what moves takes its picture along") {
    const std::string look = "ambient 1 1 1\ntexturefilter nearest\ntexture four.pfm\northographic 1\n";
    const std::string corners = "vertex 0 0 0\nvertex 2 0 0\nvertex 2 2 0\nvertex 0 2 0\n";
    for (const std::string& shape :
         {std::string("tri 0 1 3\n"), std::string("polygon 0 1 2 3\n"), std::string("sphere 0 0 0 1\n")}) {
        INFO(shape);
        const Image still = picture_with(look + corners + shape);
        // So little that no pixel's centre sees another texel.
        const Image moving = picture_with(look + corners + "motion 1e-9 0 0\n" + shape);
        CHECK(test::differing(still, moving, 1e-6) <= 1);
        const Image turning = picture_with(look + corners + "spin 0 0 1 1e-7\n" + shape);
        CHECK(test::differing(still, turning, 1e-6) <= 1);
        // A whole turn, of which one sample sees the half.
        const std::string half = "spp 1\nsampler regular\n" + look + corners;
        CHECK(test::differing(picture_with(half + "spin 0 0 1 360\n" + shape),
                              picture_with(half + "rotate 0 0 1 180\n" + shape), 1e-6) <= 1);
        // So are the directions in which the picture runs.
        const std::string relief =
            "integrator normals\nnormalmap four.pfm\northographic 1\nspp 1\n"
            "sampler regular\n" +
            corners;
        CHECK(test::differing(picture_with(relief + "spin 0 0 1 360\n" + shape),
                              picture_with(relief + "rotate 0 0 1 180\n" + shape), 1e-6) <= 1);
        CHECK(test::differing(picture_with(relief + "spin 0 0 1 360\n" + shape),
                              picture_with("integrator normals\northographic 1\n" + corners + shape),
                              1e-6) > 9);
    }
}

TEST_CASE("a world keeps what varies a material only where the picture shows it") {
    const auto needs = [](const std::string& text) { return compile(scene_of(camera + text)).needs; };
    const std::string ball = "sphere 0 0 0 1\n";
    CHECK_FALSE(needs(ball).textures);
    CHECK_FALSE(needs(ball).uvs);
    CHECK(needs("texture four.pfm\n" + ball).textures);
    CHECK(needs("texture four.pfm\n" + ball).uvs);
    CHECK_FALSE(needs("integrator normals\ntexture four.pfm\n" + ball).textures);
    CHECK_FALSE(needs("integrator normals\ntexture four.pfm\n" + ball).uvs);
    CHECK(needs("wood 1 1 1 0 0 0 1\n" + ball).textures);
    CHECK_FALSE(needs("wood 1 1 1 0 0 0 1\n" + ball).uvs);
    CHECK(needs("integrator normals\nbumps .1 .1\n" + ball).bumps);
    CHECK_FALSE(needs("integrator flat\nbumps .1 .1\n" + ball).bumps);
    CHECK(needs("skyGradient 1 1 1 0 0 0 0 0 0\n" + ball).sky);
    CHECK_FALSE(needs("skyGradient 1 1 1 0 0 0 0 0 0\nskylight on\n" + ball).skylight);
    CHECK(needs("skyGradient 1 1 1 0 0 0 0 0 0\nskylight on\ndiffuse 1 1 1\n" + ball).skylight);
}

TEST_CASE("the sky is seen where nothing is hit, in mirrors and through glass") {
    const std::string sky = "skyGradient 0 0 1 0 1 0 1 0 0\nambient 0 0 0\n";
    const Image nothing = picture_with(sky);
    CHECK(pixel(nothing, 4, 0).z > 0);
    CHECK(pixel(nothing, 4, 7).x > 0);
    // A floor that mirrors shows above what is seen below.
    const Image mirror = picture_with(sky + "specular 1 1 1\nplane 0 -.01 0 0 1 0\n");
    CHECK(pixel(mirror, 4, 7).z > 0);
    CHECK(pixel(mirror, 4, 7).x == 0);
    // A sheet of glass that does not bend light changes nothing.
    const Image through = picture_with(sky + "transmission 1 1 1\nbox -9 -9 -1 9 9 1\n");
    CHECK(test::differing(nothing, through, 1e-12) == 0);
}

TEST_CASE("a sky of radiance 1 lights a white thing with 1") {
    const Image seen = picture_with(
        "skyGradient 1 1 1 1 1 1 1 1 1\nskylight on\nambient 0 0 0\ndiffuse 1 1 1\nplane 0 0 0 0 0 1\n");
    // The sky is summed in 1024 rows.
    CHECK(test::near(pixel(seen, 4, 4), Vec3(1), 1e-6));
    CHECK(std::ranges::count(seen.pixels, seen.pixels[0]) == 64);
}

TEST_CASE("bumps turn the normal, and leave it as it is where they are flat") {
    const std::string ball = "integrator normals\nsphere 0 0 0 1\n";
    const Image smooth = picture_with(ball), flat = picture_with("bumps 0 1\n" + ball),
                bumped = picture_with("bumps .05 .2\n" + ball);
    CHECK(test::differing(smooth, flat) == 0);
    CHECK(test::differing(smooth, bumped, 0.01) > 16);
    CHECK(test::differing(smooth, bumped, 0.5) == 0);
}

TEST_CASE("a matte finish without roughness is as bright as a plain one, and others are not") {
    const std::string lit = "diffuse .8 .6 .4\npoint 2 3 4 1 1 1\ndirectional -1 1 1 .2 .3 .4\n",
                      ball = "sphere 0 0 0 1\n";
    const Image plain = picture_with(lit + ball);
    CHECK(test::differing(plain, picture_with("finish matte 0\n" + lit + ball), 1e-12) == 0);
    for (const char* const finish : {"matte 1", "velvet .5", "metal .5", "coated 1.5"}) {
        INFO("finish " << finish);
        const Image seen = picture_with("finish " + std::string(finish) + "\n" + lit + ball);
        CHECK(test::differing(plain, seen, 0.01) > 20);
        for (const Vec3& p : seen.pixels) CHECK((test::is_finite(p) && p.x >= 0 && p.y >= 0 && p.z >= 0));
    }
}

TEST_CASE("the value of a finish is in its range") {
    CHECK(error_of("finish matte 1.5\n") ==
          "test.scene:3:14: the value of 'matte' must be from 0 to 1, not 1.5");
    CHECK(error_of("finish coated .5\n") ==
          "test.scene:3:15: the value of 'coated' must be from 1 to 4, not 0.5");
    CHECK(error_of("finish plain 1\n").find("test.scene:3:14: 'plain' has no value") == 0);
    const auto needs = [](const std::string& text) { return compile(scene_of(camera + text)).needs; };
    CHECK_FALSE(needs("finish metal\ndiffuse 1 1 1\nsphere 0 0 0 1\n").finishes);
    CHECK(needs("finish metal\ndiffuse 1 1 1\npoint 1 2 3 1 1 1\nsphere 0 0 0 1\n").finishes);
}

namespace {

/// Writes a picture of unit normals, as a normal map has them, and returns its name.
std::string normal_map_of(const std::string& name, int side,
                          const std::function<Vec3(const Vec2& uv)>& normal) {
    Image image = make_image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            pixel(image, x, y) = 0.5 + 0.5 * normal({(x + 0.5) / side, 1 - (y + 0.5) / side});
    write_image(with_picture() / name, image);
    return name;
}

const std::string shown_normals = "integrator normals\northographic 1\n";

}  // namespace

TEST_CASE("a normal map made of heights shows the normals of a surface with these heights") {
    // h = sin(2πu)·cos(2πv)/10 over the plane z = 0, on which u and v are x and y.
    const auto normal = [](const Vec2& uv) {
        const Real a = 2 * pi * uv.x, b = 2 * pi * uv.y;
        return unit(Vec3(-0.2 * pi * std::cos(a) * std::cos(b), 0.2 * pi * std::sin(a) * std::sin(b), 1));
    };
    const std::string map = normal_map_of("waves.pfm", 8, normal);
    const Image seen = picture_with("texturefilter nearest\nnormalmap " + map + "\n" + shown_normals + wall);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            INFO("pixel (" << x << ", " << y << ")");
            const Vec3 expected = 0.5 + 0.5 * normal({(x + 0.5) / 8, 1 - (y + 0.5) / 8});
            // Single precision in the file.
            CHECK(test::near(pixel(seen, x, y), expected, 1e-6));
        }
}

TEST_CASE("a normal map leans along growing u and v, on a ball as well") {
    const Vec3 lean(0.48, -0.36, 0.8);
    const std::string map = normal_map_of("lean.pfm", 2, [&](const Vec2&) { return lean; });
    const std::string ball = "integrator normals\northographic 3\nrotate 1 2 3 40\nsphere 0 0 0 1\n";
    const Image smooth = picture_with(ball), seen = picture_with("normalmap " + map + "\n" + ball);
    // Where the ball's own axis is after the turn (Rodrigues).
    const Vec3 k = unit(Vec3(1, 2, 3)), y(0, 1, 0);
    const Real angle = radians(Real(40));
    const Vec3 axis = y * std::cos(angle) + cross(k, y) * std::sin(angle) + k * (k.y * (1 - std::cos(angle)));
    int compared = 0;
    for (std::size_t i = 0; i < smooth.pixels.size(); ++i) {
        const Vec3 n = Real(2) * smooth.pixels[i] - Real(1);
        if (std::abs(length(n) - 1) > 1e-9) continue;  // nothing is there
        // u runs from x towards z: against the turn about the axis. v climbs towards the axis.
        const Vec3 du = unit(cross(n, axis)), dv = unit(axis - dot(axis, n) * n);
        const Vec3 expected = lean.x * du + lean.y * dv + lean.z * n;
        if (2 * expected.z * dot(expected, n) < 1.1 * n.z) continue;  // leans too far to be seen
        ++compared;
        CHECK(test::near(seen.pixels[i], 0.5 + 0.5 * expected, 1e-6));
    }
    CHECK(compared > 4);
}

TEST_CASE("a flat normal map changes nothing, and a normal that looks away is turned back") {
    const std::string flat = normal_map_of("flat.pfm", 2, [](const Vec2&) { return Vec3(0, 0, 1); });
    const std::string ball = "integrator normals\nsphere 0 0 0 1\n";
    CHECK(test::differing(picture_with(ball), picture_with("normalmap " + flat + "\n" + ball), 1e-12) == 0);
    CHECK(test::differing(picture_with(ball), picture_with("normalmap four.pfm\nnormalmap off\n" + ball)) ==
          0);
    const std::string away = normal_map_of("away.pfm", 2, [](const Vec2&) { return unit(Vec3(3, 0, -1)); });
    for (const Vec3& p : picture_with("normalmap " + away + "\n" + shown_normals + wall).pixels) {
        const Vec3 n = Real(2) * p - Real(1);
        CHECK(test::near(length(n), 1, 1e-9));
        CHECK(n.z >= 0.5);
        CHECK(n.x > 0.1);
    }
}

TEST_CASE("for POV-Ray an object with a picture and bumps declares its own coordinates once") {
    write_image(with_picture() / "dark.png", make_image(2, 2), Encoding::Linear);
    const Scene scene = scene_of(camera + "texture dark.png\nbumps .01 .1\nplane 0 -1 0  0 1 .2\n");
    const std::string text = export_povray(scene);
    INFO(text);
    const std::string declared = "#declare OwnX0 = ";
    REQUIRE(text.find(declared) != std::string::npos);
    CHECK(text.find(declared) == text.rfind(declared));
}

TEST_CASE("of a normal map, 8 bits are numbers, even if the file is a texture as well") {
    Image grey = make_image(1, 1);
    grey.pixels[0] = Vec3(128 / 255.0);
    write_image(with_picture() / "grey.png", grey, Encoding::Linear);
    const Scene scene = scene_of(camera +
                                 "texture grey.png\nnormalmap grey.png\nsphere 0 0 0 1\n"
                                 "normalmap grey.png\nsphere 1 0 0 1\n");
    REQUIRE(scene.pictures.size() == 2);
    CHECK(scene.pictures[0].image->pixels[0].x < 0.25);
    CHECK(test::near(scene.pictures[1].image->pixels[0], Vec3(128 / 255.0), 1e-9));
}

TEST_CASE("a normal map is kept only where normals are asked for, and a bad one is an error") {
    const auto needs = [](const std::string& text) { return compile(scene_of(camera + text)).needs; };
    const std::string mapped = "normalmap four.pfm\nsphere 0 0 0 1\n";
    CHECK_FALSE(needs("sphere 0 0 0 1\n").normal_maps);
    CHECK_FALSE(needs("bumps .1 .1\nsphere 0 0 0 1\n").normal_maps);
    CHECK_FALSE(needs("integrator flat\n" + mapped).normal_maps);
    CHECK_FALSE(needs("integrator flat\n" + mapped).uvs);
    CHECK(needs(mapped).normal_maps);
    CHECK(needs("texturefilter anisotropic\n" + mapped).footprints);
    const Image seen =
        picture_with("texturefilter anisotropic\ndiffuse 1 1 1\ndirectional 1 1 1 .5 .5 .5\n" + mapped);
    for (const Vec3& p : seen.pixels) CHECK(test::is_finite(p));
    CHECK(error_of("normalmap none.png\n") == "test.scene:3:11: picture " +
                                                  (with_picture() / "none.png").string() +
                                                  ": cannot be read: No such file or directory");
    const std::string refused = test::error_of([&] {
        const Scene scene = scene_of(camera + mapped);
        export_povray(scene, snapshots_of(scene));
    });
    CHECK(
        refused ==
        "test.scene:4:1: POV-Ray cannot express this object: a normal map: its bump maps know heights only");
}

TEST_CASE("a normal map is averaged over a pixel, also where its normals are the picture") {
    // Columns that lean to the left and to the right, eight to a pixel: together they lean nowhere.
    const std::string map = normal_map_of("columns.pfm", 64, [](const Vec2& uv) {
        return Vec3(static_cast<int>(uv.x * 64) % 2 == 0 ? 0.6 : -0.6, 0, 0.8);
    });
    const auto seen = [&](const std::string& filter) {
        return picture_with("texturefilter " + filter + "\nnormalmap " + map + "\n" + shown_normals + wall);
    };
    const Vec3 straight(0.5, 0.5, 1);
    for (const char* const filter : {"trilinear", "anisotropic"})
        for (const Vec3& p : seen(filter).pixels) CHECK(test::near(p, straight, 1e-6));
    for (const Vec3& p : seen("nearest").pixels) CHECK(std::abs(p.x - 0.5) > 0.2);
}

TEST_CASE("averaged textures are the same by scan conversion as by rays") {
    const std::string map = normal_map_of("waving.pfm", 64, [](const Vec2& uv) {
        return unit(Vec3(std::sin(uv.x * 40), std::cos(uv.y * 30), 1.5));
    });
    const std::string triangle =
        "vertex -1 -1 0\nvertex 1 -1 -3\nvertex 0 1 0\nambient 1 1 1\ntexturefilter anisotropic\n";
    const std::string mapped = "normalmap " + map + "\ntri 0 1 2\n",
                      pictured = "texture " + map + "\ntri 0 1 2\n";
    for (const std::string& shown :
         {"integrator normals\n" + triangle + mapped, "integrator flat\n" + triangle + pictured}) {
        INFO(shown);
        const Image rays = picture_with(shown), scanned = picture_with("visibility rasterize\n" + shown);
        CHECK(test::differing(rays, scanned, 1e-9) == 0);
    }
}

TEST_CASE("for POV-Ray each part of a combination has its own coordinates") {
    const Scene scene = scene_of(camera +
                                 "texture four.pfm\nintegrator uv\ndifference\nsphere 0 0 0 1\nunion\n"
                                 "box 0 0 0 1 1 1\nquadric 1 1 1 0 0 0 0 0 0 -1 -2 -2 -2 2 2 2\nend\nend\n");
    const std::string text = export_povray(scene, snapshots_of(scene));
    INFO(text);
    // The sphere is part 0; the box and the quadric, 1 and 2, stand before their union.
    for (const char* const name : {"Uv1", "Uv2", "Uv3"}) {
        CHECK(text.find("#declare " + std::string(name) + " =") != std::string::npos);
        CHECK(text.find("texture { " + std::string(name) + " }") != std::string::npos);
    }
}

TEST_CASE("the roughness of a finish can be textured") {
    const std::string lit = "diffuse .8 .6 .4\nspecular 0 0 0\npoint 2 3 4 1 1 1\n",
                      ball = "sphere 0 0 0 1\n", quarter = "textured finish\nstripes .5 1 1 .5 1 1 1\n";
    for (const char* const finish : {"matte", "velvet", "metal"}) {
        INFO("finish " << finish);
        const std::string whole = "finish " + std::string(finish) + " .8\n",
                          half = "finish " + std::string(finish) + " .4\n";
        CHECK(test::differing(picture_with(lit + quarter + whole + ball), picture_with(lit + half + ball),
                              1e-12) == 0);
        CHECK(test::differing(picture_with(lit + whole + ball), picture_with(lit + half + ball), 1e-3) > 10);
    }
}

TEST_CASE("rough glass sends on light from behind, in one direction as in the other") {
    // The lesson's example: α = ½, n = 1.5, straight through. f = 34.56/π out of the glass, 15.36/π into it,
    // and straight back 0.04·(4/π)/4. A lamp of L makes π·f·|cos|·L.
    const std::string
        glass = "orthographic 1\nambient 0 0 0\ndiffuse 1 1 1\nior 1.5\nfinish glass .70710678118654752\n",
        behind = "directional 0 0 -1 .01 .01 .01\n", front = "directional 0 0 1 1 1 1\n",
        out = "disc 0 0 0 0 0 1 9\n", in = "disc 0 0 0 0 0 -1 9\n";
    CHECK(test::near(pixel(picture_with(glass + behind + out), 3, 3), Vec3(0.3456), 1e-9));
    CHECK(test::near(pixel(picture_with(glass + behind + in), 3, 3), Vec3(0.1536), 1e-9));
    CHECK(test::near(pixel(picture_with(glass + front + out), 3, 3), Vec3(0.04), 1e-9));
    const std::string body = "maxdepth 0\nbox -9 -9 -1 9 9 0\n";
    CHECK(pixel(picture_with(glass + behind + body), 3, 3) == Vec3(0));
    CHECK(test::near(pixel(picture_with(glass + behind + "transmission .5 .25 1\n" + body), 3, 3),
                     0.3456 * Vec3(0.5, 0.25, 1), 1e-9));
    // The side on which a face has its corners counter-clockwise is outside, and stays so in a mirror.
    const std::string corners = "vertex -9 -9 0\nvertex 9 -9 0\nvertex 0 9 0\n";
    for (const std::string face : {"tri 0 1 2\n", "polygon 0 1 2\n", "disc 0 0 0 0 0 1 9\n"})
        for (const std::string transform :
             {"", "scale -1 1 1\n", "scale 1 -1 1\n", "motion 0 0 .001\nscale -1 1 1\n"}) {
            INFO(transform << face);
            CHECK(test::near(pixel(picture_with(glass + behind + corners + transform + face), 3, 3),
                             Vec3(0.3456), 1e-9));
        }
    CHECK(error_of("finish glass\nsphere 0 0 0 1\n") ==
          "test.scene:4:1: 'finish glass' takes an 'ior' from 1.01 to 4, and the one in force is 1");
    CHECK(error_of("finish glass 2\n").find("test.scene:3:14: the value of 'glass' must be from 0 to 1") ==
          0);
}

TEST_CASE("finishes under lights with an extent") {
    const std::string lit =
        "diffuse .8 .6 .4\nambient 0 0 0\nspp 4\nquadLight -1 3 2 2 0 0 0 0 1 3 3 3\nsphereLight 3 2 3 .5 2 "
        "2 2\n";
    const std::string ball = "sphere 0 0 0 1\n";
    const Image plain = picture_with(lit + ball);
    CHECK(test::differing(plain, picture_with("finish matte 0\n" + lit + ball), 1e-12) == 0);
    for (const char* const finish : {"matte 1", "velvet .5", "metal .5", "coated 1.5", "glass .5\nior 1.5"}) {
        INFO("finish " << finish);
        const Image seen = picture_with("finish " + std::string(finish) + "\n" + lit + ball);
        CHECK(test::differing(plain, seen, 0.003) > 10);
        for (const Vec3& p : seen.pixels) CHECK((test::is_finite(p) && p.x >= 0 && p.y >= 0 && p.z >= 0));
    }
}
