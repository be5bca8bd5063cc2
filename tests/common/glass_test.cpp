// Glass and filters in whole scenes: no light is lost, what encloses a body is one, and of several sheets in
// one place each counts. The first case of most of these came from the field.
#include "common/image/file.hpp"
#include "common/math/error.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/worlds.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace rt;
using namespace rt::test;

namespace {

void write_mesh(const std::string& name, const std::string& text) {
    write_file(std::filesystem::path(scratch_directory()) / name, text);
}

std::string error_in(const std::string& text) {
    return test::error_of([&] { world_of(text); });
}

/// An octahedron whose normals are those of the ball around it: nowhere are smooth triangles flatter.
std::string octahedron() {
    write_mesh("glass_octahedron.obj",
               "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
               "vn 1 0 0\nvn -1 0 0\nvn 0 1 0\nvn 0 -1 0\nvn 0 0 1\nvn 0 0 -1\n"
               "f 1//1 3//3 5//5\nf 3//3 2//2 5//5\nf 2//2 4//4 5//5\nf 4//4 1//1 5//5\n"
               "f 3//3 1//1 6//6\nf 2//2 3//3 6//6\nf 4//4 2//2 6//6\nf 1//1 4//4 6//6\n");
    return "mesh glass_octahedron.obj\n";
}

/// A regular tetrahedron whose normals are those of the ball around it: nowhere do they lean farther.
std::string tetrahedron() {
    write_mesh("glass_tetrahedron.obj",
               "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nvn 1 1 1\nvn 1 -1 -1\nvn -1 1 -1\nvn -1 -1 1\n"
               "f 1//1 2//2 3//3\nf 1//1 4//4 2//2\nf 1//1 3//3 4//4\nf 2//2 4//4 3//3\n");
    return "mesh glass_tetrahedron.obj\n";
}

/// A picture in a white world that is as large as there is time for.
std::string white_world(int side) {
    const int pixels = cases(100) < 100 ? side / 4 : side;
    return "size " + std::to_string(pixels) + " " + std::to_string(pixels) +
           "\ncamera .4 .3 4 0 0 0 0 1 0 35\nbackground 1 1 1\nambient 0 0 0\n";
}

/// The darkest and the brightest pixel.
std::pair<Real, Real> extremes(const Image& image) {
    std::pair<Real, Real> found{infinity, -infinity};
    for (const Vec3& color : image.pixels) {
        // Written so that NaN is the darkest of all.
        if (!(color.x >= found.first)) found.first = color.x;
        if (!(color.x <= found.second)) found.second = color.x;
    }
    return found;
}

/// A view from in front on a checkered floor.
const std::string floor_scene =
    "size 100 100\ncamera 0 .6 4 0 0 0 0 1 0 35\nbackground .3 .5 .9\nmaxdepth 40\nambient 1 1 1\n"
    "checker .9 .9 .9 .1 .1 .1 .5\nplane 0 -1 0 0 1 0\nchecker 1 1 1 1 1 1 1\nambient 0 0 0\n"
    "transmission 1 1 1\n";

/// The faces of a prism, as objects or as the lines of a mesh.
const std::vector<std::string> prism_faces{"0 1 2", "3 5 4", "0 3 4", "0 4 1",
                                           "1 4 5", "1 5 2", "0 2 5", "0 5 3"};
const std::string prism_corners =
    "vertex -1 -1 1\nvertex 1 -1 1\nvertex -1 1 1\nvertex -1 -1 -1\nvertex 1 -1 -1\nvertex -1 1 -1\n";
const std::string prism_place = "rotate 0 1 0 20\nscale .7 .7 .7\n";

std::string prism_of_triangles(std::size_t faces = 8) {
    std::string text;
    for (std::size_t i = 0; i < faces; ++i) text += "tri " + prism_faces[i] + "\n";
    return text;
}

std::string prism_mesh() {
    write_mesh("glass_prism.obj",
               "v -1 -1 1\nv 1 -1 1\nv -1 1 1\nv -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\n"
               "f 1 2 3\nf 4 6 5\nf 1 4 5\nf 1 5 2\nf 2 5 6\nf 2 6 3\nf 1 3 6\nf 1 6 4\n");
    return "mesh glass_prism.obj\n";
}

}  // namespace

// Smooth glass and mirrors --------------------------------------------------------------------------------

TEST_CASE("a closed body of smooth glass in a white world stays white", "[glass]") {
    // Every ray gets out at last, with the weight exp(-0.001 · its way).
    const Image image =
        picture_of(white_world(200) +
                   "maxdepth 1000\ntransmission 1 1 1\nior 1.5\nabsorption .001 .001 .001\n" + octahedron());
    const auto [darkest, brightest] = extremes(image);
    INFO("pixels from " << darkest << " to " << brightest);
    CHECK(darkest > 0.9);
    CHECK(brightest <= 1);
    CHECK(darkest < 0.999);  // the body is in the picture
}

TEST_CASE("smooth glass that mirrors by Fresnel's law, and air in glass, lose no light either", "[glass]") {
    const std::string cut = "maxdepth 100\nmincontribution 1e-4\ntransmission 1 1 1\n";
    for (const char* what : {"ior 1.5\nfresnel exact\n", "ior 1.5\nfresnel schlick\n", "ior .8\n"}) {
        const auto [darkest, brightest] = extremes(picture_of(white_world(80) + cut + what + octahedron()));
        INFO(what << "pixels from " << darkest << " to " << brightest);
        CHECK(darkest > 0.9);
        CHECK(brightest <= 1 + 1000 * unit_roundoff);
    }
}

TEST_CASE("no light is caught in a coarse body of smooth glass", "[glass]") {
    // Mirrors that lean as the interpolated normals do catch some of it in rings of total reflections.
    const std::string glass = "maxdepth 1000\ntransmission 1 1 1\nior 2.4\n";
    for (const char* what : {"absorption .001 .001 .001\n", "fresnel exact\nmincontribution 1e-4\n"}) {
        const auto [darkest, brightest] =
            extremes(picture_of(white_world(60) + glass + what + tetrahedron()));
        INFO(what << "pixels from " << darkest << " to " << brightest);
        CHECK(darkest > 0.9);
        CHECK(brightest <= 1 + 1000 * unit_roundoff);
    }
}

TEST_CASE("a smooth mirror in a white world is white: no ray is mirrored into the body", "[glass]") {
    const auto [darkest, brightest] =
        extremes(picture_of(white_world(200) + "maxdepth 20\nspecular 1 1 1\n" + octahedron()));
    INFO("pixels from " << darkest << " to " << brightest);
    CHECK(darkest == 1);
    CHECK(brightest == 1);
}

// Nested media --------------------------------------------------------------------------------------------

TEST_CASE("shells around glass that bend and filter nothing change nothing, however many", "[glass]") {
    const std::string ball = "ior 1.5\nsphere 0 0 0 .3\n";
    const Image alone = picture_of(floor_scene + ball);
    for (const int count : {8, 16}) {
        std::string shells = "ior 1\n";
        for (int i = 0; i < count; ++i) shells += "sphere 0 0 0 " + std::to_string(1 - 0.04 * i) + "\n";
        INFO(count << " shells");
        // Rays are made unit vectors anew at each shell: a few roundings.
        CHECK(differing(picture_of(floor_scene + shells + ball), alone, 1e-12) == 0);
    }
}

// Bodies of several objects -------------------------------------------------------------------------------

TEST_CASE("glass of single triangles that enclose a body looks as the mesh of them does", "[glass]") {
    const Image mesh = picture_of(floor_scene + "ior 1.5\n" + prism_place + prism_mesh());
    CHECK(
        differing(picture_of(floor_scene + prism_corners + "ior 1.5\n" + prism_place + prism_of_triangles()),
                  mesh, 0) == 0);
    // With other things between, which take their material and transform from other lines.
    const std::string between =
        "pushTransform\ntranslate 0 0 90\ntransmission 0 0 0\nsphere 0 0 0 1\npopTransform\ntransmission 1 1 "
        "1\n";
    std::string scattered;
    for (const std::string& face : prism_faces) scattered += "tri " + face + "\n" + between;
    CHECK(differing(picture_of(floor_scene + prism_corners + "ior 1.5\n" + prism_place + scattered), mesh) ==
          0);
}

TEST_CASE("triangles and polygons enclose a body together", "[glass]") {
    const World world = world_of(floor_scene + prism_corners + "ior 1.5\n" + prism_place +
                                 "tri 0 1 2\ntri 5 4 3\npolygon 0 3 4 1\npolygon 1 4 5 2\npolygon 2 5 3 0\n");
    REQUIRE(world.primitives.size() == 6);
    for (std::size_t i = 1; i < 6; ++i) CHECK(world.primitives[i].object == 1);
    CHECK(world.sheets.empty());
    REQUIRE(world.faces.size() == 4);
    CHECK(world.faces[0].primitive == 2);
    CHECK(world.faces[3].object == 5);
}

TEST_CASE("smooth triangles enclose a body, too", "[glass]") {
    const World world = world_of(floor_scene +
                                 "ior 1.5\nvertexnormal 0 0 0 -1 -1 -1\nvertexnormal 1 0 0 1 0 0\n"
                                 "vertexnormal 0 1 0 0 1 0\nvertexnormal 0 0 1 0 0 1\n"
                                 "trinormal 0 2 1\ntrinormal 0 1 3\ntrinormal 0 3 2\ntrinormal 1 2 3\n");
    for (std::size_t i = 1; i < 5; ++i) CHECK(world.primitives[i].object == 1);
}

TEST_CASE("glass that encloses nothing is an error at its line", "[glass]") {
    const std::string head = "camera 0 0 5 0 0 0 0 1 0 40\n" + prism_corners + "transmission 1 1 1\n";
    const std::string why = ": a transparent object without an inside";
    CHECK(error_in(head + "ior 1.5\n" + prism_of_triangles(7)).find("test.scene:10:1" + why) == 0);
    CHECK(error_in(head + "absorption 0 0 1\npolygon 0 1 4 3\n").find("test.scene:10:1" + why) == 0);
    CHECK(error_in(head + "ior 1.5\n" + prism_of_triangles(8)).empty());
    // One face in another material, or in another place.
    CHECK(error_in(head + "ior 1.5\n" + prism_of_triangles(7) + "ior 1.4\ntri 0 5 3\n").find(why) !=
          std::string::npos);
    CHECK(error_in(head + "ior 1.5\n" + prism_of_triangles(7) + "translate 0 0 1\ntri 0 5 3\n").find(why) !=
          std::string::npos);
    // The same face twice encloses nothing.
    CHECK(error_in(head + "ior 1.5\ntri 0 1 2\ntri 0 1 2\n").find(why) != std::string::npos);
    // Where no ray goes through things, nothing is asked for.
    CHECK(error_in(head + "maxdepth 0\nior 1.5\ntri 0 1 2\n").empty());
}

TEST_CASE("glass that its box cuts open is an error at its line", "[glass]") {
    const std::string head = "camera 0 0 5 0 0 0 0 1 0 40\ntransmission 1 1 1\n";
    const auto error = [&](const std::string& shape) { return error_in(head + "ior 1.5\n" + shape + "\n"); };
    CHECK(error("implicit -1 -1 -1 1 1 .5 x^2+y^2+z^2-.9") ==
          "test.scene:4:1: a transparent implicit surface that its box cuts open: at 0 0 0.5, on a face, is "
          "its "
          "inside; make the box larger, or close it by an `intersection` with a `box`");
    const std::string why = " that its box cuts open: ";
    CHECK(error("quadric 1 0 1 0 0 0 0 0 0 -.5   -1 -1 -1 1 1 1")
              .find("test.scene:4:1: a transparent quadric" + why) == 0);
    CHECK(error_in(head + "absorption 0 0 1\nquadric 1 1 1 0 0 0 0 0 0 -1.1   -1 -2 -2 1 2 2\n").find(why) !=
          std::string::npos);
    // A small opening, away from the middle; and one where the values are of all sizes.
    CHECK(error("implicit -1 -1 -1 1 1 1 (x-.3)^2+(y-.2)^2+z^2-.700001^2").find(why) != std::string::npos);
    CHECK(error("implicit -1 -1 -1 1 1 1 exp(9*x)*exp(-9*y)-2").find(why) != std::string::npos);
    // An inside that fills the box; and one that ends where there is no value.
    CHECK(error("implicit -1 -1 -1 1 1 1 x-2").find(why) != std::string::npos);
    CHECK(error("implicit -1 -1 -1 1 1 1 sqrt(x)-.9").find(why) != std::string::npos);
    // Where no ray goes through things, nothing is asked for.
    CHECK(error_in(head + "maxdepth 0\nior 1.5\nquadric 1 0 1 0 0 0 0 0 0 -.5   -1 -1 -1 1 1 1\n").empty());
}

TEST_CASE("a closed surface is a body of glass, also if it touches its box or a combination closes it",
          "[glass]") {
    const std::string head = "camera 0 0 5 0 0 0 0 1 0 40\ntransmission 1 1 1\nior 1.5\n";
    for (const std::string shape :
         {"implicit -1 -1 -1 1 1 1 x^2+y^2+z^2-.99", "implicit -1 -1 -1 1 1 1 x^2+y^2+z^2-1",
          "implicit -.3 -.3 -.3 .3 .3 .3 x^2+y^2+z^2-.09", "implicit -.7 -.7 -.7 .7 .7 .7 x^2+y^2+z^2-.49",
          "implicit -1 -1 -1 1 1 1 max(abs(x),max(abs(y),abs(z)))-1",
          "implicit -2 -2 -2 2 2 2 1/2-exp(-2*x^2-2*y^2-2*(z-1/2)^2)-exp(-2*x^2-2*y^2-2*(z+1/2)^2)",
          "implicit -2 -2 -2 2 2 2 (x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3",
          "implicit -2 -1 -1 2 1 1 -sqrt(1-x^2-y^2-z^2)", "implicit -1 -1 -1 1 1 1 x^2+1",
          "quadric 1 1 1 0 0 0 0 0 0 -1   -1 -1 -1 1 1 1",
          "quadric 1 2 3 .1 .2 .3 .1 .2 .3 -1   -2 -2 -2 2 2 2",
          "quadric 25 4 1 0 0 0 0 0 0 -1   -.2 -.5 -1 .2 .5 1",
          "intersection\nquadric 1 0 1 0 0 0 0 0 0 -.5   -1 -1 -1 1 1 1\nbox -1 -1 -1 1 1 1\nend"}) {
        INFO(shape);
        CHECK(error_in(head + shape + "\n") == "");
        CHECK(world_of(head + shape + "\n").sheets.empty());
    }
}

TEST_CASE("what its box cuts open may filter, as a sheet", "[glass]") {
    const std::string half = "ior 1\nimplicit -.7 -.7 -.7 .7 .7 0 x^2+y^2+z^2-.4\n";
    CHECK(world_of(floor_scene + half).sheets == std::vector<std::uint32_t>{1});
    // Around it a ball of glass goes on to be what is around the ray.
    const std::string ball = "ior 1.5\nsphere 0 0 0 .8\n";
    const Image alone = picture_of(floor_scene + ball);
    CHECK(differing(picture_of(floor_scene + ball + half), alone, 1e-12) == 0);
    CHECK(differing(picture_of(floor_scene + half + ball), alone, 1e-12) == 0);
}

TEST_CASE("a sheet that only filters needs no inside, and has none", "[glass]") {
    // A pane in the middle of a ball of glass: the ball goes on to be what is around the ray.
    const std::string pane = "ior 1\nvertex -9 -9 0\nvertex 9 -9 0\nvertex 9 9 0\nvertex -9 9 0\n";
    const std::string ball = "ior 1.5\nsphere 0 0 0 .8\n";
    const Image alone = picture_of(floor_scene + ball);
    CHECK(differing(picture_of(floor_scene + ball + pane + "polygon 0 1 2 3\n"), alone, 1e-12) == 0);
    CHECK(differing(picture_of(floor_scene + pane + "tri 0 1 2\ntri 0 2 3\n" + ball), alone, 1e-12) == 0);
}

// Sheets in one place -------------------------------------------------------------------------------------

namespace {

/// What arrives at a floor below sheets at height 1, in the red channel.
Real below(const std::string& sheets) {
    return picture_of(
               "size 1 1\ncamera 0 .5 5 0 0 0 0 1 0 1\nmaxdepth 0\nambient 0 0 0\ndiffuse 1 1 1\n"
               "directional 0 1 0 1 1 1\nplane 0 0 0 0 1 0\ndiffuse 0 0 0\n"
               "vertex -9 1 -9\nvertex 9 1 -9\nvertex 9 1 9\nvertex -9 1 9\n" +
               sheets)
        .pixels[0]
        .x;
}

std::string through(const std::string& part) {
    return "transmission " + part + " " + part + " " + part + "\n";
}

}  // namespace

TEST_CASE("an opaque sheet in the place of a filter blocks, whatever the order of the file", "[glass]") {
    CHECK(below(through(".5") + "polygon 0 1 2 3\n") == 0.5);
    CHECK(below(through(".5") + "polygon 0 1 2 3\n" + through("0") + "polygon 0 1 2 3\n") == 0);
    CHECK(below(through("0") + "polygon 0 1 2 3\n" + through(".5") + "polygon 0 1 2 3\n") == 0);
    CHECK(below(through(".5") + "plane 0 1 0 0 1 0\n" + through("0") + "polygon 0 1 2 3\n") == 0);
}

TEST_CASE("of several filters in one place each counts", "[glass]") {
    const std::string one = "polygon 0 1 2 3\n";
    CHECK(below(through(".5") + one + one) == 0.25);
    CHECK(below(through(".5") + one + one + one) == 0.125);
    CHECK(below(through(".5") + one + through(".25") + one) == 0.125);
    CHECK(below("accelerator grid\n" + through(".5") + one + through(".25") + one) == 0.125);
    CHECK(below("accelerator nested\n" + through(".5") + one + one + one) == 0.125);
}

TEST_CASE("a sheet of two triangles filters once on the edge between them", "[glass]") {
    // The middle of the picture is below the diagonal, exactly.
    for (const char* accelerator : {"none", "grid"}) {
        const std::string how = std::string("accelerator ") + accelerator + "\n";
        CHECK(below(how + through(".5") + "tri 0 1 2\ntri 0 2 3\n") == 0.5);
        CHECK(below(how + through(".5") + "tri 0 2 3\n" + through(".25") + "polygon 0 1 2 3\n" +
                    through(".5") + "tri 0 1 2\n") == 0.125);
    }
}

TEST_CASE("all hits of a ray come one after the other, with every accelerator", "[glass]") {
    write_mesh("glass_square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n");
    std::string things =
        "transmission .9 .9 .9\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 1 1 0\nvertex -1 1 0\n";
    // Each thing three times in the same place; the meshes are instances.
    for (const char* x : {"-2.5", "0", "2.5"})
        for (int copy = 0; copy < 3; ++copy)
            things += std::string("pushTransform\ntranslate ") + x +
                      " 0 0\npolygon 0 1 2 3\nmesh glass_square.obj\nsphere 0 0 1 .5\nscale 1 2 1\n"
                      "sphere 0 0 2 .25\ntranslate 0 0 -1\ntri 0 1 2\npopTransform\n";
    const std::string head = "size 4 4\nmaxdepth 0\ncamera 0 0 9 0 0 0 0 1 0 40\n";
    const World plain = world_of(head + "accelerator none\n" + things);
    const World grid = world_of(head + "accelerator grid\n" + things);
    const World nested = world_of(head + "accelerator nested\n" + things);
    Random random(83);
    int most = 0;
    for (int i = 0; i < cases(2000); ++i) {
        // Some rays run through edges and corners.
        const Vec3 aim(std::round(random.uniform(-14, 14)) / 4, std::round(random.uniform(-4, 4)) / 4, 0);
        const Ray ray{{aim.x, aim.y, 9}, {0, 0, -1}};
        std::optional<Hit> hit = closest_hit(plain, ray, {}), in_grid = closest_hit(grid, ray, {}),
                           in_nested = closest_hit(nested, ray, {});
        std::optional<Hit> before;
        std::vector<std::uint32_t> objects;  // at one distance
        int count = 0;
        while (hit) {
            REQUIRE(in_grid);
            REQUIRE(in_nested);
            REQUIRE(in_grid->primitive == hit->primitive);
            REQUIRE(in_nested->primitive == hit->primitive);
            const bool behind = before && hit->t > before->t;
            const bool beside = before && hit->t == before->t && hit->primitive > before->primitive;
            REQUIRE((!before || behind || beside));
            if (behind) objects.clear();
            const std::uint32_t object = plain.primitives[hit->primitive].object;
            REQUIRE(std::find(objects.begin(), objects.end(), object) == objects.end());
            objects.push_back(object);
            most = std::max(most, static_cast<int>(objects.size()));
            ++count;
            before = hit;
            hit = next_hit(plain, ray, *hit, {});
            in_grid = next_hit(grid, ray, *in_grid, {});
            in_nested = next_hit(nested, ray, *in_nested, {});
        }
        CHECK_FALSE(in_grid);
        CHECK_FALSE(in_nested);
        // All that is met is there three times: distances where a ray enters and leaves are different.
        CHECK(count % 3 == 0);
    }
    CHECK(most == 6);
}
