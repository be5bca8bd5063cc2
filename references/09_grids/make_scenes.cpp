// Writes this chapter's long scenes and its cloud, the same text on every machine.
// make_scenes stadium.scene|crowd.scene|forest.scene|cloud.obj FILE
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/vec.hpp"
#include "references/scene_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace rt;

// --------------------------------------------------------------------------------------------- stadium

/// A corner of a quadrilateral, and the normal there.
struct Corner {
    Vec3 place, normal;
};

/// Triangles of a scene, their vertices counted.
struct Builder {
    std::string text;
    int vertices = 0;

    void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
        for (const auto& [p, n] : {a, b, c, d})
            text += fmt::format("vertexnormal {} {} {} {} {} {}\n", number(p.x, 3), number(p.y, 3),
                                number(p.z, 3), number(n.x, 3), number(n.y, 3), number(n.z, 3));
        text += fmt::format("trinormal {0} {1} {2}\ntrinormal {0} {2} {3}\n", vertices, vertices + 1,
                            vertices + 2, vertices + 3);
        vertices += 4;
    }
    /// On the level y, with these limits.
    void level(Real y, Real low_x, Real high_x, Real low_z, Real high_z) {
        const auto corner = [&](Real x, Real z) { return Corner{{x, y, z}, {0, 1, 0}}; };
        quad(corner(low_x, high_z), corner(high_x, high_z), corner(high_x, low_z), corner(low_x, low_z));
    }
};

/// A strip that goes around the middle of the field along ellipses, from one of semi-axes `width` and `depth`
/// to one whose semi-axes are `out` more, and from the height `from` to the height `to`.
struct Strip {
    const char* name;
    Real width, depth, out, from, to;
    Vec3 color, other;  ///< in turn
    Real glow;          ///< light from the rest of the stadium, as a part of the colour
};

/// The part of the strip that is number i of `parts`.
void add_part(Builder& scene, const Strip& strip, int i, int parts) {
    const auto corner = [&](int number, Real end) {
        const Real turn = 2 * pi * number / parts, c = std::cos(turn), s = std::sin(turn);
        const Real width = strip.width + end * strip.out, depth = strip.depth + end * strip.out;
        const Vec3 along(-width * s, 0, depth * c),
            outwards(strip.out * c, strip.to - strip.from, strip.out * s);
        return Corner{{width * c, strip.from + end * (strip.to - strip.from), depth * s},
                      normalize(cross(outwards, along))};
    };
    scene.quad(corner(i, 0), corner(i + 1, 0), corner(i + 1, 1), corner(i, 1));
}

std::string stadium() {
    Builder scene;
    scene.text =
        R"(# The picture of chapter 9: a teapot in a stadium, 102,080 small triangles in the middle of 870 large ones.
# All have normals: so they are of one kind, and in one grid.
# Written by make_scenes stadium.scene; the teapot is made by the build: make_teapot 40 teapot.obj
version 1
size 320 240
output stadium.png
encoding srgb
background .42 .58 .78
maxdepth 2

camera -3.1 3.1 9.2   .25 3.05 0   0 1 0   50

directional .55 .8 .5   .72 .68 .6
directional -.6 .5 .45   .12 .14 .18

# The field.
ambient .01 .02 .01
diffuse .22 .42 .13
checker 1 1 1 .8 .86 .8 8
)";
    scene.level(0, -140, 140, -120, 120);
    scene.text += "checker 1 1 1 1 1 1 1\n# Chalk.\nambient .06 .06 .06\ndiffuse .75 .75 .72\n";
    const int parts = 48;
    const Real chalk = 0.015;
    const Strip circle{"", 9, 9, 0.5, chalk, chalk, {}, {}, 0};
    for (int i = 0; i < parts; ++i) add_part(scene, circle, i, parts);
    for (const Real side : {-1, 1}) scene.level(chalk, -0.15, 0.15, 27.5 * side - 18, 27.5 * side + 18);

    const Vec3 cream(0.72, 0.66, 0.52), red(0.62, 0.13, 0.09), blue(0.12, 0.24, 0.5), stone(0.42, 0.4, 0.38);
    const std::array<Strip, 6> bowl{{{"Boards around the field", 66, 50, 0, 0, 1.2, cream, blue, 0.1},
                                     {"Lower tier", 66, 50, 24, 1.2, 11, red, cream, 0.1},
                                     {"Wall", 90, 74, 0, 11, 14, stone, stone, 0.2},
                                     {"Upper tier", 90, 74, 26, 14, 31, blue, cream, 0.1},
                                     {"Back", 116, 100, 0, 31, 39, stone, stone, 0.2},
                                     {"Roof", 116, 100, -16, 39, 44, cream, stone, 0.35}}};
    for (const Strip& strip : bowl) {
        scene.text += fmt::format("# {}.\n", strip.name);
        for (const int odd : {0, 1}) {
            const Vec3& color = odd ? strip.other : strip.color;
            scene.text += line("ambient", strip.glow * color, 3) + line("diffuse", color);
            for (int i = odd; i < parts; i += 2) add_part(scene, strip, i, parts);
        }
    }

    scene.text +=
        "# A plinth that mirrors, and the teapot.\nambient .02 .02 .02\ndiffuse .16 .16 .17\n"
        "specular .3 .3 .3\nshininess 50\n";
    const Strip top{"", 0.4, 0.4, 3, 0.8, 0.8, {}, {}, 0}, side{"", 3.4, 3.4, 0, 0, 0.8, {}, {}, 0};
    for (const Strip& strip : {top, side})
        for (int i = 0; i < parts; ++i) add_part(scene, strip, i, parts);
    scene.text +=
        "ambient .06 .04 .01\ndiffuse .46 .27 .05\nspecular .42 .3 .12\nshininess 90\n"
        "translate 0 .82 0\nrotate 0 1 0 -28\nmesh teapot.obj\n";
    return scene.text;
}

// --------------------------------------------------------------------------------------- crowd and forest

std::string crowd() {
    std::string scene =
        "# A crowd around a mirror ball: 1500 spheres and 1500 ellipsoids, each kind in a grid of its own.\n"
        "# Written by make_scenes crowd.scene\n"
        "version 1\nsize 320 240\noutput crowd.png\nencoding srgb\nbackground .3 .42 .6\nmaxdepth 1\n\n"
        "camera 0 17 31   0 .2 3.2   0 1 0   36\n\n"
        "directional -.7 .55 .35   .8 .7 .55\ndirectional .5 .6 .5   .09 .1 .14\n\n"
        "ambient .02 .02 .03\ndiffuse .52 .46 .38\nplane 0 0 0 0 1 0\n"
        "diffuse .02 .02 .02\nspecular .8 .8 .8\nshininess 300\nsphere 0 4.1 0 4\n"
        "specular .1 .1 .1\nshininess 20\n";
    // Places follow each other by the golden angle, which fills a disc evenly. Every 34th stands on the same
    // arm, and 21 later on the next, where the hue is one thirty-fourth further: 13 · 21 is 1 modulo 34.
    const int people = 1500;
    for (int i = 0; i < people; ++i) {
        const auto n = static_cast<std::uint32_t>(i);
        const Real radius = 0.46 * std::sqrt(i + 110.0), angle = radians(137.50776) * i;
        const Real x = radius * std::cos(angle), z = radius * std::sin(angle),
                   size = 0.8 + 0.4 * scatter(3 * n);
        const Real hue = 2 * pi * (13 * i % 34) / 34.0;
        const Vec3 color =
            Vec3(0.42) + Real(0.3) * Vec3(std::cos(hue), std::cos(hue - 2.1), std::cos(hue + 2.1));
        scene += line("diffuse", color);
        scene += fmt::format("sphere {} {} {} {}\n", number(x), number(1.02 * size), number(z),
                             number(0.17 * size, 3));
        scene += fmt::format(
            "pushTransform\ntranslate {} {} {}\nrotate {} 0 {} {}\nscale {} {} {}\n"
            "sphere 0 0 0 1\npopTransform\n",
            number(x), number(0.44 * size), number(z), number(std::cos(angle)), number(-std::sin(angle)),
            number(12 * scatter(3 * n + 1) - 6, 0), number((0.2 + 0.06 * scatter(3 * n + 2)) * size, 3),
            number(0.45 * size, 3), number(0.19 * size, 3));
    }
    return scene;
}

std::string forest() {
    std::string scene =
        "# A flooded forest: 1600 times the same tree of 10,000 triangles, in a grid of instances, and "
        "inside each\n"
        "# the grid of the tree. The water is a plane: it has no end, so no grid holds it.\n"
        "# Written by make_scenes forest.scene; the tree is that of chapter 4.\n"
        "version 1\nsize 320 240\noutput forest.png\nencoding srgb\nbackground .40 .50 .60\nmaxdepth 1\n\n"
        "camera 0 13 74   0 3.6 0   0 1 0   40\n\n"
        "directional -.75 .55 .1   .85 .72 .5\n\n"
        "ambient .004 .012 .016\ndiffuse .02 .035 .04\nspecular .42 .46 .5\nshininess 400\nplane 0 0 0 0 1 "
        "0\n"
        "specular 0 0 0\n";
    int trees = 0;
    for (std::uint32_t n = 0; trees < 1600; ++n) {
        const Real x = 330 * (scatter(6 * n) - 0.5), z = 62 - 330 * scatter(6 * n + 1);
        // A creek winds through, wider towards the eye, and nothing grows far outside the picture.
        const Real creek = 10 * std::sin(z / 24) - 0.12 * z;
        if (std::abs(x - creek) < 6 + 0.07 * (z + 120) || std::abs(x) > 0.6 * (100 - z)) continue;
        ++trees;
        const Real wide = 0.55 + 0.45 * scatter(6 * n + 2), high = wide * (0.9 + 0.5 * scatter(6 * n + 3));
        const Real air = 1 - std::exp((z - 62) / 190), autumn = scatter(6 * n + 4);
        const Vec3 leaf =
            autumn > 0.86 ? Vec3(0.5, 0.24, 0.05) : Vec3(0.08, 0.25, 0.07) + autumn * Vec3(0.12, 0.1, 0);
        scene += line("ambient", air * Vec3(0.3, 0.37, 0.43) + (1 - air) * Real(0.1) * leaf);
        scene += line("diffuse", (1 - air) * leaf);
        scene += fmt::format(
            "pushTransform\ntranslate {} -.2 {}\nrotate 0 1 0 {}\nscale {} {} {}\n"
            "mesh ../04_transforms/tree.obj\npopTransform\n",
            number(x, 1), number(z, 1), number(360 * scatter(6 * n + 5), 0), number(wide), number(high),
            number(wide));
    }
    return scene;
}

// ----------------------------------------------------------------------------------------------- cloud

/// A heap of balls, the rind of each full of small triangles that lie nearly flat in it.
std::string cloud() {
    struct Ball {
        Vec3 center;
        Real radius;
    };
    std::uint32_t n = 0;
    const auto random = [&n] { return scatter(n++); };
    const auto in_ball = [&] {
        for (;;) {
            // One after the other: in the call compilers would draw them in any order.
            const Real z = 2 * random() - 1;
            const Real y = 2 * random() - 1;
            const Real x = 2 * random() - 1;
            const Vec3 p(x, y, z);
            if (dot(p, p) < 1) return p;
        }
    };
    std::vector<Ball> balls{{{0, 60, 0}, 150},     {{-150, 15, 20}, 115}, {{160, 10, 10}, 110},
                            {{60, 165, -30}, 105}, {{-75, 140, 10}, 95},  {{-275, -15, 0}, 75},
                            {{285, -20, 30}, 70},  {{95, 10, 120}, 85},   {{-80, 0, 120}, 85}};
    // Each has smaller ones on it.
    for (std::size_t i = 0; i < 9; ++i)
        for (int k = 0; k < 7; ++k) {
            const Ball ball = balls[i];
            Vec3 out = normalize(in_ball());
            out.y = std::abs(out.y);
            balls.push_back(
                {ball.center + Real(0.85) * ball.radius * out, ball.radius * (0.3 + 0.25 * random())});
        }
    const Real floor = -45;
    std::string positions, faces;
    const int triangles = 200'000;
    for (int i = 0; i < triangles;) {
        const Ball& ball = balls[static_cast<std::size_t>(random() * static_cast<Real>(balls.size()))];
        // Large balls have more rind.
        if (random() > ball.radius * ball.radius / (150 * 150)) continue;
        const Vec3 out = normalize(in_ball());
        const Vec3 place = ball.center + ball.radius * (0.93 + 0.07 * random()) * out;
        bool hidden = place.y < floor + 9 * random();
        for (const Ball& other : balls) hidden |= length(place - other.center) < 0.9 * other.radius;
        if (hidden) continue;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 step = Real(7) * in_ball();
            positions += line("v", place + step - 0.75 * dot(step, out) * out, 1);
        }
        faces += fmt::format("f {} {} {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
        ++i;
    }
    return fmt::format("# A cloud of {} triangles, made by make_scenes\n", triangles) + positions + faces;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc == 3 ? argv[1] : "";
    std::string text;
    if (what == "stadium.scene") text = stadium();
    if (what == "crowd.scene") text = crowd();
    if (what == "forest.scene") text = forest();
    if (what == "cloud.obj") text = cloud();
    if (text.empty()) {
        std::fputs("usage: make_scenes stadium.scene|crowd.scene|forest.scene|cloud.obj FILE\n", stderr);
        return 2;
    }
    try {
        write_file(argv[2], text);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
