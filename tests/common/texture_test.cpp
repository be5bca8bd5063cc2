// Pictures, patterns and skies in whole scenes: what is read, what a world keeps, what is seen.
#include "common/image/file.hpp"
#include "common/scene/language/commands.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"
#include "tests/worlds.hpp"

#include <filesystem>

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
          "ambient|diffuse|emission|specular|transmission|absorption|shininess ...");
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

TEST_CASE("surfaces without texture coordinates refuse a picture") {
    CHECK(error_of("texture four.pfm\nimplicit -1 -1 -1 1 1 1 x\n") ==
          "test.scene:4:1: this implicit surface has no texture coordinates for its 'texture'");
    CHECK(error_of("texture four.pfm\nunion\nsphere 0 0 0 1\nsphere 1 0 0 1\nend\n")
              .find("has no texture coordinates") != std::string::npos);
    CHECK(error_of("marble 1 1 1 0 0 0 1\nimplicit -1 -1 -1 1 1 1 x\n").empty());
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
