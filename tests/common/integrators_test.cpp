// The table of integrators: every row is read, drawn, explained and expressed for POV-Ray, or refused.
#include "common/scene/integrators.hpp"

#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/povray/export.hpp"
#include "common/render/compile.hpp"
#include "common/render/explain.hpp"
#include "common/render/integrators.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <algorithm>

using namespace rt;

namespace {

const std::string face =
    "size 16 12\ncamera 0 0 5  0 0 0  0 1 0  40\nbackground .125 .25 .5\npoint 1 2 3 1 1 1\n"
    "ambient .5 .25 .125\ndiffuse .5 .5 .5\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 0 1 .5\ntri 0 1 2\n";

Scene scene_of(const std::string& more) { return parse_scene_text(face + more, "face.scene"); }

Image picture_of(const std::string& more) { return render(compile(scene_of(more))).image; }

std::string error_of(const std::string& more) {
    try {
        compile(scene_of(more));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("every integrator is read by its name, and by no other", "[integrators]") {
    for (const IntegratorRow& row : integrators) {
        const std::string name(row.name);
        INFO(name);
        const Scene scene = scene_of("integrator " + name + "\n");
        CHECK(scene.integrator == row.value);
        CHECK(scene.visibility == Visibility::Rays);
        CHECK_FALSE(row.meaning.empty());
        const std::vector<std::string_view> names = integrator_names();
        CHECK(std::count(names.begin(), names.end(), row.name) == 1);
    }
    CHECK_FALSE(integrator_named("no such").has_value());
}

TEST_CASE("every integrator draws, and only those that look at lights keep any", "[integrators]") {
    for (const IntegratorRow& row : integrators) {
        INFO(row.name);
        const Scene scene = scene_of(fmt::format("integrator {}\n", row.name));
        const World world = compile(scene);
        CHECK(world.groups.empty() == !row.objects);
        CHECK(world.point_lights.empty() == !row.lights);
        CHECK(world.needs.lights == row.lights);
        CHECK(world.needs.uvs == row.uvs);
        const Explanation explanation = explain(scene, world);
        CHECK(std::find(explanation.chapters.begin(), explanation.chapters.end(), row.chapter) !=
              explanation.chapters.end());
        const Image image = render(world).image;
        CHECK((image.pixels[0] != image.pixels[16 * 6 + 8]));
    }
}

TEST_CASE("POV-Ray paints every integrator's picture, or the row says why not", "[integrators]") {
    for (const IntegratorRow& row : integrators) {
        INFO(row.name);
        const Scene scene = scene_of(fmt::format("integrator {}\n", row.name));
        if (!row.why_not_povray.empty())
            CHECK_THROWS_WITH(export_povray(scene), fmt::format("face.scene: POV-Ray cannot express this "
                                                                "scene: {}",
                                                                row.why_not_povray));
        else
            CHECK(export_povray(scene).find("camera {") != std::string::npos);
    }
}

TEST_CASE("scan conversion finds what is seen for integrators that ask no more", "[integrators]") {
    for (const IntegratorRow& row : integrators) {
        INFO(row.name);
        const std::string text = fmt::format("integrator {}\n", row.name);
        const std::string error = error_of(text + "visibility rasterize\n");
        if (!row.hit_alone) {
            CHECK(error ==
                  fmt::format("face.scene:12:1: scan conversion finds what each pixel sees and nothing "
                              "else: enough for the integrators {}, but not for {}",
                              integrators_with(&IntegratorRow::hit_alone), row.name));
            continue;
        }
        REQUIRE(error.empty());
        const Image by_rays = picture_of(text), scanned = picture_of(text + "visibility rasterize\n");
        // No pixel's centre is near an edge of the triangle.
        for (std::size_t i = 0; i < by_rays.pixels.size(); ++i)
            REQUIRE(glm::length(by_rays.pixels[i] - scanned.pixels[i]) <= 1e-12);
    }
}

TEST_CASE("'integrator rasterize' is an older word, and other words end it", "[integrators]") {
    const Scene old = scene_of("integrator rasterize\n");
    CHECK(old.integrator == Integrator::Normals);
    CHECK(old.visibility == Visibility::Rasterize);
    CHECK((picture_of("integrator rasterize\n").pixels ==
           picture_of("integrator normals\nvisibility rasterize\n").pixels));
    CHECK(scene_of("integrator rasterize\nvisibility rays\n").visibility == Visibility::Rasterize);
    CHECK(scene_of("integrator rasterize\nintegrator flat\n").visibility == Visibility::Rays);
    CHECK(scene_of("visibility rasterize\nintegrator flat\n").visibility == Visibility::Rasterize);
    CHECK(scene_of("visibility rasterize\nvisibility rays\n").visibility == Visibility::Rays);
}

TEST_CASE("scan conversion can colour the hits of just the integrators that ask for nothing else",
          "[integrators]") {
    for (const IntegratorRow& row : integrators) {
        World world;
        world.integrator = row.value;
        INFO(row.name);
        CHECK((hit_color_function(world) != nullptr) == row.hit_alone);
    }
}
