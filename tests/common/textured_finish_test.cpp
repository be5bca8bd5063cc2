// Numbers of a finish that a texture multiplies: at each place the picture is that of the plain number.
#include "common/image/file.hpp"
#include "common/povray/export.hpp"
#include "common/render/explain.hpp"
#include "common/render/snapshots.hpp"
#include "tests/catch.hpp"
#include "tests/show.hpp"
#include "tests/worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

using namespace rt;

namespace {

namespace fs = std::filesystem;

/// A directory that has a checker of 1 and ½ in red, as `halves.pfm`; green and blue do not count.
fs::path with_picture() {
    const fs::path directory = fs::path(test::scratch_directory()) / "textured_finish";
    fs::create_directories(directory);
    Image image = make_image(2, 2);
    image.pixels = {Vec3(1, 0.25, 0), Vec3(0.5, 4, 3), Vec3(0.5, 1, 1), Vec3(1)};
    write_image(directory / "halves.pfm", image);
    return directory;
}

Scene scene_of(const std::string& text) {
    return parse_scene_text("camera 0 0 4 0 0 0 0 1 0 30\nsize 8 8\n" + text, "t.scene", with_picture());
}
Image picture_of(const std::string& text) { return render(compile(scene_of(text))).image; }

/// A material with a number, and what shows it on the wall below.
struct Case {
    const char* word;     ///< after `textured`
    const char* command;  ///< takes the number
    Real number;
    const char* rest;  ///< of the scene
};

const std::string sky = "skyGradient 1 .2 .1  .3 .9 .2  .2 .1 1\nambient 0 0 0\nspp 4\n",
                  lamps = "ambient 0 0 0\npoint 2 3 4 1 1 1\ndiffuse .8 .6 .4\n",
                  square = "quadLight -1 1 2  2 0 0  0 2 0  3 3 3\nintegrator direct\nspecular .5 .6 .7\n";

std::vector<std::pair<Case, std::string>> cases() {
    return {
        {{"gloss", "gloss", 40, "specular .9 .8 .7\n"}, sky},
        {{"translucency", "translucency", 40, "transmission .9 .8 .7\nior 1.5\n"}, sky},
        {{"roughness", "roughness", 0.6, "brdf ggx\nspecular .9 .8 .7\n"}, sky},
        {{"roughness", "roughness", 0.6, "brdf ggx\ntransmission .9 .8 .7\nior 1.5\nfresnel exact\n"}, sky},
        {{"roughness", "roughness", 0.6, "brdf ggx\n"}, square},
        {{"shininess", "shininess", 12, ""}, square},
        {{"finish", "finish metal", 0.8, ""}, lamps},
        {{"coat", "finish coated", 3, ""}, lamps}};
}

/// A wall that fills the view; a picture on it has its four texels in the four quarters.
const std::string wall = "orthographic 1\ntranslate -.5 -.5 0\nplane 0 0 0 0 0 1\n";

std::string plain(const Case& of, Real number, const std::string& rest) {
    return fmt::format("{}{}{} {:.17g}\n{}", rest, of.rest, of.command, number, wall);
}

}  // namespace

TEST_CASE("a checker of two numbers shows at each place what the plain number shows") {
    for (const auto& [of, rest] : cases()) {
        INFO(of.command << " " << of.number << ", textured " << of.word << "\n" << of.rest << rest);
        const Image seen =
            picture_of(fmt::format("texturefilter nearest\ntexture halves.pfm\ntextured {}\n", of.word) +
                       plain(of, of.number, rest));
        const Image whole = picture_of(plain(of, of.number, rest)),
                    half = picture_of(plain(of, of.number / 2, rest));
        int apart = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                INFO("pixel (" << x << ", " << y << ")");
                const bool is_whole = (x < 4) == (y < 4);
                CHECK(pixel(seen, x, y) == pixel(is_whole ? whole : half, x, y));
                apart += length(pixel(whole, x, y) - pixel(half, x, y)) > 1e-3;
            }
        // Else nothing would be tested.
        CHECK(apart > 32);
    }
}

TEST_CASE("any factor on a number of a finish is the plain number that is as many times as large") {
    test::Random random(11);
    for (int i = 0; i < test::cases(40); ++i) {
        const auto all = cases();
        const auto& [of, rest] = all[random.index(all.size())];
        const Real number = of.number * random.uniform(0.5, 1);
        const bool coat = std::string_view(of.word) == "coat";
        // Single precision holds it.
        const Real factor = static_cast<Real>(1 + random.index(64)) / 64, times = number * factor;
        const std::string textured =
            fmt::format("stripes {0} 1 7 {0} 0 5 .3\ntextured {1}\n", factor, of.word) +
            plain(of, number, rest);
        INFO(textured);
        const Image seen = picture_of(textured);
        CHECK(seen.pixels == picture_of(plain(of, coat ? std::max<Real>(times, 1) : times, rest)).pixels);
    }
}

TEST_CASE("what a texture makes of a finish stays in its range, and no gloss is a sharp mirror") {
    const auto same = [](const Case& of, Real number, Real factor, Real expected, const std::string& rest) {
        INFO(of.command << " " << number << " times " << factor << " is " << expected);
        const std::string stripes = fmt::format("stripes {0} 1 1 {0} 1 1 1\ntextured {1}\n", factor, of.word);
        const Image seen = picture_of(stripes + plain(of, number, rest)),
                    known = picture_of(plain(of, expected, rest));
        for (std::size_t i = 0; i < seen.pixels.size(); ++i)
            CHECK(test::near(seen.pixels[i], known.pixels[i], 1e-12));
    };
    for (const auto& [of, rest] : cases()) {
        const std::string_view word = of.word;
        if (word == "roughness" || word == "finish") same(of, 0.6, 1e6, 1, rest);
        if (word == "roughness" || word == "finish") same(of, 0.6, -1, 0, rest);
        if (word == "coat") same(of, 1.5, 8, 4, rest);
        if (word == "coat") same(of, 1.5, 0, 1, rest);
        if (word == "gloss" || word == "translucency") {
            same(of, 40, 1e30, 1e8, rest);
            same(of, 40, 0, 0, rest);
            same(of, 40, -2, 0, rest);
        }
    }
}

TEST_CASE("`finish` leaves alone what other commands said of how light spreads") {
    const Scene scene = scene_of(
        "gloss 30\ntranslucency 20\nbrdf ggx\nroughness .4\ntextured coat gloss\n"
        "finish coated 1.4\nsphere 0 0 0 1\nfinish plain\nsphere 0 0 0 1\n");
    REQUIRE(scene.finishes.size() == 2);
    for (const Finish& finish : scene.finishes) {
        CHECK(finish.gloss == 30);
        CHECK(finish.translucency == 20);
        CHECK(finish.brdf == Brdf::Ggx);
        CHECK(finish.roughness == 0.4);
        CHECK((finish.textured.coat && finish.textured.gloss && !finish.textured.finish));
    }
    CHECK(scene.finishes[0].value == 1.4);
    CHECK(scene.finishes[1].kind == FinishKind::Plain);
}

TEST_CASE("that a texture says how far rays spread is explained, and refused for POV-Ray") {
    const std::string tiles = "stripes .5 1 1 1 1 1 .3\ntextured gloss\nspecular .5 .5 .5\n";
    const auto why_spread = [](const std::string& text) -> std::string {
        const Scene scene = scene_of(text + "sphere 0 0 0 1\n");
        for (const auto& feature : explain(scene, compile(scene)).kept)
            if (feature.what == "spread rays") return feature.why;
        return "";
    };
    CHECK(why_spread(tiles) == "");
    CHECK(why_spread("gloss 20\nspecular .5 .5 .5\n") == "some material is glossy, translucent or rough");
    CHECK(why_spread("gloss 20\n" + tiles) ==
          "some material is glossy, translucent or rough, and a texture says how much");
    const auto error = [](const std::string& text) {
        return test::error_of([&] {
            const Scene scene = scene_of(text + "sphere 0 0 0 1\n");
            export_povray(scene, snapshots_of(scene));
        });
    };
    CHECK(
        error("gloss 20\n" + tiles) ==
        "t.scene:7:1: POV-Ray cannot express this object: mirrored or refracted rays that spread in a lobe");
    CHECK(error(tiles).empty());
    CHECK(error("gloss 20\nmaxdepth 0\n" + tiles).empty());
}
