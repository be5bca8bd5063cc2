// Accelerators in a World: built where they pay, and nowhere seen in the picture.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/09_grids/walk.hpp"
#include "common/render/accelerate.hpp"
#include "common/render/compile.hpp"
#include "common/render/explain.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/worlds.hpp"

#include <algorithm>
#include <cmath>
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

World world_of(const std::string& text) { return test::world_of(text, test::repository() + "/references"); }

std::size_t accelerators_of(const World& world) {
    std::size_t count = 0;
    for (const AnyGroup& any : world.groups)
        count += std::visit([](const auto& group) { return std::size_t(has_accelerator(group)); }, any);
    for (const auto& mesh : world.meshes) count += has_accelerator(mesh->triangles);
    return count;
}

}  // namespace

TEST_CASE("the picture is the same to the bit with and without accelerators", "[accelerator]") {
    const std::string text = crowd(test::cases(400));
    const Image plain = render(world_of(text + "accelerator none\n")).image;
    for (const char* accelerator : {"grid", "nested", "bvh", "auto"}) {
        INFO(accelerator);
        const World world = world_of(text + "accelerator " + accelerator + "\n");
        CHECK((render(world).image.pixels == plain.pixels));
        CHECK(world.needs.accelerators == (accelerators_of(world) > 0));
    }
    CHECK(accelerators_of(world_of(text + "accelerator none\n")) == 0);
    // Spheres, ellipsoids, triangles and polygons; no grid holds the plane.
    CHECK(accelerators_of(world_of(text + "accelerator grid\n")) == 4);
    CHECK(accelerators_of(world_of(text + "accelerator bvh\n")) == 4);
}

TEST_CASE("instances have an accelerator, and so has the mesh that they share", "[accelerator]") {
    std::string text =
        "size 48 36\ncamera 0 2 30 0 0 0 0 1 0 45\npoint 9 9 9 1 1 1\nambient 0 0 0\ndiffuse .7 .7 .7\n";
    for (int i = 0; i < 40; ++i)
        text += "pushTransform\ntranslate " + std::to_string(i % 8 * 3 - 12) + " 0 " +
                std::to_string(i / 8 * 3 - 12) + "\nrotate 0 1 0 " + std::to_string(17 * i) +
                "\nscale .4 .5 .4\nmesh 03_triangles/knot_smooth.obj\npopTransform\n";
    const Image plain = render(world_of(text + "accelerator none\n")).image;
    for (const char* accelerator : {"nested", "bvh"}) {
        INFO(accelerator);
        const World world = world_of(text + "accelerator " + accelerator + "\n");
        CHECK(accelerators_of(world) == 2);
        CHECK((render(world).image.pixels == plain.pixels));
    }
}

TEST_CASE("solids made of others and smooth triangles are the same in a hierarchy and without",
          "[accelerator]") {
    test::Random random(13);
    std::ostringstream text;
    text << "size 48 36\ncamera 0 2 9 0 0 0 0 1 0 45\nmaxdepth 3\npoint 4 6 5 .6 .6 .6\nambient .1 .1 .1\n"
         << "diffuse .5 .6 .7\nspecular .2 .2 .2\nshininess 30\n";
    for (int i = 0; i < 40; ++i) {
        const Vec3 p = Real(3) * random.in_cube();
        text << "difference\nsphere " << p.x << ' ' << p.y << ' ' << p.z << " .4\nsphere " << p.x + 0.2 << ' '
             << p.y << ' ' << p.z + 0.2 << " .35\nend\n";
        text << "torus " << p.y << ' ' << p.z << ' ' << p.x << " 1 2 3 .3 .1\n";
    }
    text << "pushTransform\nscale .8 .8 .8\nmesh 03_triangles/knot_smooth.obj\npopTransform\n";
    const World world = world_of(text.str() + "accelerator bvh\n");
    // Differences, tori and triangles.
    CHECK(accelerators_of(world) == 3);
    CHECK((render(world).image.pixels == render(world_of(text.str() + "accelerator none\n")).image.pixels));
}

TEST_CASE("scenes too small for a grid build none", "[accelerator]") {
    const World world = world_of(crowd(16));
    CHECK_FALSE(world.needs.accelerators);
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

TEST_CASE("a scene that says 'accelerator' needs that one's chapter, and explain says what was built",
          "[accelerator]") {
    const auto explained = [](const std::string& text) {
        const Scene scene = parse_scene_text(text, "s");
        return explain(scene, compile(scene));
    };
    const Explanation asked = explained(crowd(100) + "accelerator nested\n");
    CHECK(std::count(asked.chapters.begin(), asked.chapters.end(), "09") == 1);
    CHECK(std::any_of(asked.kept.begin(), asked.kept.end(),
                      [](const Reason& reason) { return reason.what.starts_with("grid of"); }));
    const Explanation tree = explained(crowd(100) + "accelerator bvh\n");
    CHECK(std::count(tree.chapters.begin(), tree.chapters.end(), "13") == 1);
    CHECK(std::any_of(tree.kept.begin(), tree.kept.end(),
                      [](const Reason& reason) { return reason.what.starts_with("hierarchy of"); }));
    const Explanation chosen = explained(crowd(400));
    CHECK(std::count(chosen.chapters.begin(), chosen.chapters.end(), "09") == 0);
    const Explanation sampled = explained(crowd(10) + "spp 4\n");
    CHECK(std::count(sampled.chapters.begin(), sampled.chapters.end(), "08") == 1);
}

// ------------------------------------------------------------------------------- what `auto` costs, in
// counts

namespace {

/// The text of a triangle; its corners are numbers 3·i to 3·i + 2.
std::string triangle(int i, const Vec3& a, const Vec3& b, const Vec3& c) {
    std::ostringstream text;
    text.precision(17);
    for (const Vec3& p : {a, b, c}) text << "vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    text << "tri " << 3 * i << ' ' << 3 * i + 1 << ' ' << 3 * i + 2 << '\n';
    return text.str();
}

std::string sphere(const Vec3& center, Real radius) {
    std::ostringstream text;
    text.precision(17);
    text << "sphere " << center.x << ' ' << center.y << ' ' << center.z << ' ' << radius << '\n';
    return text.str();
}

std::string picture(int width, int height) {
    return "size " + std::to_string(width) + " " + std::to_string(height) +
           "\ncamera 0 2 9 0 0 0 0 1 0 45\nambient .5 .5 .5\n";
}

std::string needles(int count) {
    test::Random random(1);
    std::string text = picture(32, 24);
    for (int i = 0; i < count; ++i) {
        const Vec3 tip = Real(3) * normalize(random.in_cube());
        text += triangle(i, -tip, tip, tip + 0.003 * random.in_cube());
    }
    return text;
}

std::string balls(int count, const std::string& more) {
    test::Random random(2);
    std::string text = picture(32, 24) + more;
    for (int i = 0; i < count; ++i) text += sphere(Real(3) * random.in_cube(), 0.03);
    return text;
}

/// Shapes of one kind or of several, alike or of very different sizes, spread, in heaps or on a plane, on a
/// ground as large as a planet or not.
std::string random_scene(std::uint64_t seed) {
    test::Random random(seed);
    const auto number = [&] { return random.in_cube().x * 0.5 + 0.5; };
    const int count = static_cast<int>(100 * std::pow(30, number()));
    const int width = static_cast<int>(16 * std::pow(4, number()));
    const int kind = static_cast<int>(4 * number()), place = static_cast<int>(3 * number());
    const Real size = 0.003 * std::pow(60, number()), spread = 2 * number();
    std::string text = picture(width, width * 3 / 4);
    if (number() < 0.4) text += sphere({0, -1003, 0}, 1000);
    Vec3 heap(0);
    for (int i = 0, triangles = 0; i < count; ++i) {
        if (i % (1 + count / 8) == 0) heap = Real(3) * random.in_cube();
        Vec3 p = Real(3) * random.in_cube();
        if (place == 1) p = heap + 0.1 * p;
        if (place == 2) p.y = -2;
        const Real r = size * std::exp(spread * (number() + number() + number() - 1.5));
        switch (kind == 3 ? i % 3 : kind) {
            case 0:
                text += sphere(p, r);
                break;
            case 1: {
                std::ostringstream stretched;
                stretched << "pushTransform\ntranslate " << p.x << ' ' << p.y << ' ' << p.z
                          << "\nrotate 1 2 3 " << 360 * number() << "\nscale " << r << ' '
                          << r * (0.1 + number()) << ' ' << 2 * r << "\nsphere 0 0 0 1\npopTransform\n";
                text += stretched.str();
                break;
            }
            default:
                text += triangle(triangles++, p + r * random.in_cube(), p + r * random.in_cube(),
                                 p + r * random.in_cube());
        }
    }
    return text;
}

/// What compiling and the camera's rays cost, in units of one shape asked. The other numbers are times that
/// were measured, in units of the time that a sphere takes.
Real cost_of(const std::string& text, const std::string& accelerator) {
    const GridWork before = grid_work();
    const World world = world_of(text + "accelerator " + accelerator + "\n");
    const GridWork after = grid_work();
    bool triangles = false;
    Real outside = 0, gridded = 0;
    for (const AnyGroup& any : world.groups)
        std::visit(
            [&]<class Shape>(const Group<Shape>& group) {
                triangles |= std::is_same_v<Shape, Triangle>;
                if (has_accelerator(group))
                    ++gridded;
                else
                    outside += static_cast<Real>(group.shapes.size());
            },
            any);
    Real cost = 60 * static_cast<Real>(after.entered - before.entered) +
                (triangles ? 6 : 2) * static_cast<Real>(after.questions - before.questions) +
                static_cast<Real>(after.probes - before.probes);
    const SearchCounts walked = search_counts();
    for (int y = 0; y < world.view.height; ++y)
        for (int x = 0; x < world.view.width; ++x) {
            cost += outside + 14 * gridded;
            if (gridded > 0) closest_hit(world, pixel_ray(world.view, x + 0.5, y + 0.5), {0, infinity});
        }
    return cost + static_cast<Real>(search_counts().shapes - walked.shapes) +
           0.5 * static_cast<Real>(search_counts().cells - walked.cells);
}

}  // namespace

TEST_CASE("auto costs at most 1.3 times what the best of none, grid and nested costs", "[accelerator]") {
    std::vector<std::pair<std::string, std::string>> scenes = {
        {"needles through one point", needles(600)},
        {"equal spheres", picture(32, 24) +
                              [] {
                                  std::string text;
                                  for (int i = 0; i < 1500; ++i) text += sphere(Vec3(0), 1);
                                  return text;
                              }()},
        {"balls", balls(3000, "")},
        {"balls, and one very far", balls(3000, sphere({0, 1e12, 0}, 1))},
        {"balls, and one very large", balls(3000, sphere({0, -1e9, 0}, 1e9 - 3))},
    };
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        scenes.emplace_back("random scene " + std::to_string(seed), random_scene(seed));
    for (const auto& [name, text] : scenes) {
        const Real none = cost_of(text, "none"), grid = cost_of(text, "grid"),
                   nested = cost_of(text, "nested");
        const Real chosen = cost_of(text, "auto");
        INFO(name << ": none " << none << ", grid " << grid << ", nested " << nested << ", auto " << chosen);
        CHECK(chosen <= 1.3 * std::min({none, grid, nested}));
    }
}

TEST_CASE("far outliers are asked one by one, and everything keeps its place and its picture",
          "[accelerator]") {
    const std::string far =
        "diffuse .2 .3 .4\nsphere 0 -1e6 0 999997\nsphere 3e9 1e9 -9e9 1e9\nsphere 3e9 1e9 -9e9 1e9\n"
        "vertex -2e6 -2 -1e6\nvertex 2e6 -2 -1e6\nvertex 0 3e6 -1e6\n";
    std::string text = crowd(400);
    const auto vertices = [](const std::string& in) {
        int count = 0;
        for (std::size_t at = in.find("\nvertex"); at != std::string::npos; at = in.find("\nvertex", at + 1))
            ++count;
        return count;
    };
    const int first = vertices("\n" + text);
    text += far + "tri " + std::to_string(first) + ' ' + std::to_string(first + 1) + ' ' +
            std::to_string(first + 2) + "\nsphere .1 .2 .3 .4\n";
    const World none = world_of(text + "accelerator none\n"), chosen = world_of(text);
    CHECK(accelerators_of(chosen) == 4);
    CHECK(chosen.groups.size() == none.groups.size() + 2);  // three spheres, and one triangle
    REQUIRE(chosen.primitives.size() == none.primitives.size());
    for (std::size_t p = 0; p < chosen.primitives.size(); ++p) {
        const Primitive& primitive = chosen.primitives[p];
        CHECK(primitive.material == none.primitives[p].material);
        CHECK(primitive.object == none.primitives[p].object);
        std::visit([&](const auto& group) { CHECK(group.primitive.at(primitive.index) == p); },
                   chosen.groups[primitive.group]);
    }
    CHECK((render(chosen).image.pixels == render(none).image.pixels));
}

TEST_CASE("smooth triangles that are set apart take their normals along", "[accelerator]") {
    std::string text = "size 48 36\ncamera 0 2 9 0 0 0 0 1 0 45\nintegrator normals\n";
    test::Random random(3);
    const auto corner = [&](const Vec3& p) {
        std::ostringstream line;
        const Vec3 n = random.in_cube();
        line << "vertexnormal " << p.x << ' ' << p.y << ' ' << p.z << ' ' << n.x << ' ' << n.y << ' ' << n.z
             << '\n';
        text += line.str();
    };
    for (int i = 0; i < 200; ++i) {
        const Vec3 p = i == 100 ? Vec3(0, 0, -1e6) : Real(3) * random.in_cube();
        const Real r = i == 100 ? 1e6 : 0.5;
        for (int k = 0; k < 3; ++k) corner(p + r * random.in_cube());
        text += "trinormal " + std::to_string(3 * i) + ' ' + std::to_string(3 * i + 1) + ' ' +
                std::to_string(3 * i + 2) + '\n';
    }
    const World none = world_of(text + "accelerator none\n"), chosen = world_of(text);
    CHECK(chosen.groups.size() == 2);
    CHECK((render(chosen).image.pixels == render(none).image.pixels));
}
