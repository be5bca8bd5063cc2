// Grids in a World: built where they pay, and nowhere seen in the picture.
#include "common/render/compile.hpp"
#include "common/render/explain.hpp"
#include "common/render/grids.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

using namespace rt;

namespace {

/// A box full of spheres, stretched spheres, triangles and polygons, on a plane, under two lights.
std::string crowd(int count) {
    test::Random random(9);
    std::ostringstream text;
    text << "size 64 48\ncamera 0 2 9 0 0 0 0 1 0 45\nmaxdepth 2\n"
         << "point 4 6 5 .6 .6 .6\ndirectional 1 2 1 .3 .3 .3\nambient .05 .05 .05\ndiffuse .5 .6 .7\n"
         << "plane 0 -3 0 0 1 0\n";
    for (int i = 0; i < count; ++i) {
        const Vec3 p = Real(3) * random.in_cube();
        text << (i % 7 == 0 ? "specular .3 .3 .3\n" : "specular 0 0 0\n");
        switch (i % 4) {
            case 0:
                text << "sphere " << p.x << ' ' << p.y << ' ' << p.z << " .15\n";
                break;
            case 1:
                text << "pushTransform\ntranslate " << p.x << ' ' << p.y << ' ' << p.z
                     << "\nrotate 1 2 3 40\nscale .3 .1 .2\nsphere 0 0 0 1\npopTransform\n";
                break;
            default:
                for (int corner = 0; corner < 4; ++corner)
                    text << "vertex " << p.x + (corner == 1 || corner == 2) * 0.5 << ' ' << p.y << ' '
                         << p.z + (corner > 1) * 0.5 << '\n';
                const int first = 4 * (i / 4 * 2 + i % 4 - 2);
                text << (i % 4 == 2 ? "tri " : "polygon ") << first << ' ' << first + 1 << ' ' << first + 2;
                if (i % 4 == 3) text << ' ' << first + 3;
                text << '\n';
        }
    }
    return text.str();
}

World world_of(const std::string& text) {
    return compile(parse_scene_text(text, "s", std::filesystem::path(test::repository()) / "references"));
}

std::size_t grids_of(const World& world) {
    std::size_t count = 0;
    for (const AnyGroup& any : world.groups)
        count += std::visit([]<class Kind>(const Kind&) { return std::size_t(has_grid<Kind>); }, any);
    for (const SharedMesh& mesh : world.meshes) count += !mesh.grid.empty();
    return count;
}

}  // namespace

TEST_CASE("the picture is the same to the bit with and without grids", "[accelerator]") {
    const std::string text = crowd(test::cases(400));
    const Image plain = render(world_of(text + "accelerator none\n")).image;
    for (const char* accelerator : {"grid", "nested", "auto"}) {
        INFO(accelerator);
        const World world = world_of(text + "accelerator " + accelerator + "\n");
        CHECK((render(world).image.pixels == plain.pixels));
        CHECK(world.needs.grids == (grids_of(world) > 0));
    }
    CHECK(grids_of(world_of(text + "accelerator none\n")) == 0);
    // Spheres, ellipsoids, triangles and polygons; no grid holds the plane.
    CHECK(grids_of(world_of(text + "accelerator grid\n")) == 4);
}

TEST_CASE("instances have a grid, and so has the mesh that they share", "[accelerator]") {
    std::string text =
        "size 48 36\ncamera 0 2 30 0 0 0 0 1 0 45\npoint 9 9 9 1 1 1\nambient 0 0 0\ndiffuse .7 .7 .7\n";
    for (int i = 0; i < 40; ++i)
        text += "pushTransform\ntranslate " + std::to_string(i % 8 * 3 - 12) + " 0 " +
                std::to_string(i / 8 * 3 - 12) + "\nrotate 0 1 0 " + std::to_string(17 * i) +
                "\nscale .4 .5 .4\nmesh 03_triangles/knot_smooth.obj\npopTransform\n";
    const World grid = world_of(text + "accelerator nested\n");
    CHECK(grids_of(grid) == 2);
    CHECK((render(grid).image.pixels == render(world_of(text + "accelerator none\n")).image.pixels));
}

TEST_CASE("scenes too small for a grid build none", "[accelerator]") {
    const World world = world_of(crowd(16));
    CHECK_FALSE(world.needs.grids);
    const Scene scene = parse_scene_text(crowd(16), "s");
    const Explanation explanation = explain(scene, compile(scene));
    CHECK(std::any_of(explanation.left_out.begin(), explanation.left_out.end(),
                      [](const Reason& reason) { return reason.what == "grids"; }));
}

TEST_CASE("a grid pays where many rays ask many shapes", "[accelerator]") {
    CHECK_FALSE(grid_pays(10, 1e9));
    CHECK(grid_pays(1000, 1e4));
    // A picture of a few rays is done before the grid would be built.
    CHECK_FALSE(grid_pays(1'000'000, 20));
    CHECK(grid_pays(1'000'000, 1000));
}

TEST_CASE("a scene that says 'accelerator' needs chapter 9, and explain says what was built",
          "[accelerator]") {
    const auto explained = [](const std::string& text) {
        const Scene scene = parse_scene_text(text, "s");
        return explain(scene, compile(scene));
    };
    const Explanation asked = explained(crowd(100) + "accelerator nested\n");
    CHECK(std::count(asked.chapters.begin(), asked.chapters.end(), "09") == 1);
    CHECK(std::any_of(asked.kept.begin(), asked.kept.end(),
                      [](const Reason& reason) { return reason.what.starts_with("grid of"); }));
    const Explanation chosen = explained(crowd(400));
    CHECK(std::count(chosen.chapters.begin(), chosen.chapters.end(), "09") == 0);
    const Explanation sampled = explained(crowd(10) + "spp 4\n");
    CHECK(std::count(sampled.chapters.begin(), sampled.chapters.end(), "08") == 1);
}
