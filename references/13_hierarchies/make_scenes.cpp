// Writes this chapter's scenes and its needles, the same text on every machine.
// make_scenes_13 city.scene|forest.scene|swarm.scene|needles.obj FILE
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/vec.hpp"
#include "references/scene_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

using namespace rt;

std::string box(const Vec3& low, const Vec3& high) {
    const auto triple = [](const Vec3& v) { return number(v.x) + " " + number(v.y) + " " + number(v.z); };
    return "box " + triple(low) + "  " + triple(high) + "\n";
}

/// Blocks of houses between streets, higher towards the middle; lamps along one street, and hills far away.
std::string city() {
    std::string scene =
        "# The picture of chapter 13: a city. Towers, their roofs' huts and the lamps at the kerb are boxes "
        "and\n"
        "# balls of all sizes, from 6 cm to 400 m, and most of them are small and in one street.\n"
        "# Written by make_scenes_13 city.scene\n"
        "version 1\nsize 320 240\noutput city.png\nencoding srgb\nbackground .5 .64 .82\nmaxdepth 1\n"
        "accelerator bvh\n\n"
        "camera 0 34 150   0 26 0   0 1 0   44\n\n"
        "directional -.6 .8 .55   .8 .72 .58\ndirectional .7 .5 .6   .12 .14 .2\n\n"
        "ambient .05 .05 .06\ndiffuse .3 .3 .31\nplane 0 0 0 0 1 0\n"
        "ambient .2 .26 .34\ndiffuse .1 .13 .12\n";
    for (int k = 0; k < 9; ++k) {
        const Real x = 420 * (k - 4) + 160 * scatter(900u + static_cast<std::uint32_t>(k));
        scene += fmt::format("sphere {} -260 -1500 {}\n", number(x, 0),
                             number(330 + 70 * scatter(950u + static_cast<std::uint32_t>(k)), 0));
    }
    const Vec3 walls[] = {{0.62, 0.55, 0.46}, {0.42, 0.46, 0.52}, {0.55, 0.36, 0.28}, {0.7, 0.68, 0.64}};
    const auto block_number = [](int i, int j) { return static_cast<std::uint32_t>(40 * (i + 8) + j + 14); };
    for (int color = 0; color < 4; ++color) {
        scene += line("ambient", Real(0.14) * walls[color], 3) + line("diffuse", walls[color]);
        for (int i = -8; i < 8; ++i)
            for (int j = -14; j < 5; ++j) {
                const auto random = [&](std::uint32_t k) { return scatter(16 * block_number(i, j) + k); };
                // A block of 16 m in a grid of 22 m, with a street in the middle that is as wide as three.
                if (static_cast<int>(4 * random(0)) != color) continue;
                const Real x = 22 * i + (i < 0 ? -6 : 12), z = 22 * j;
                const Real away = std::hypot(x / 130, (z + 60) / 160);
                const Real height = (8 + 70 * std::exp(-2 * away * away)) * (0.45 + 0.9 * random(1));
                const Real in = 3 * random(2), deep = 3 * random(3);
                const Vec3 low(x + in, 0, z + deep), high(x + 16 - in / 2, height, z + 16 - deep / 2);
                scene += box(low, high);
                // A hut and a mast on the roof.
                const Vec3 at(low.x + 2 + 8 * random(4), height, low.z + 2 + 8 * random(5));
                scene += box(at, at + Vec3(2 + 2 * random(6), 2 + 2 * random(7), 3));
                if (random(8) > 0.7) scene += box(at + Vec3(0.4, 0, 0.4), at + Vec3(0.7, 12, 0.7));
            }
    }
    scene += "ambient .02 .02 .02\ndiffuse .1 .1 .11\n";
    std::string lights = "ambient .75 .68 .5\ndiffuse .2 .2 .18\n";
    for (int side = 0; side < 2; ++side)
        for (int k = 0; k < 40; ++k) {
            const Vec3 foot(side == 0 ? -3.2 : 8.9, 0, 110 - 8 * k);
            scene += box(foot, foot + Vec3(0.12, 5, 0.12));
            lights += fmt::format("sphere {} 5.2 {} .35\n", number(foot.x + 0.06), number(foot.z + 0.06));
        }
    // Cars in both lanes, each of two boxes.
    const Vec3 paints[] = {{0.6, 0.08, 0.06}, {0.1, 0.2, 0.5}, {0.75, 0.75, 0.72}};
    for (int paint = 0; paint < 3; ++paint) {
        lights += "specular .2 .2 .2\nshininess 60\n" + line("ambient", Real(0.12) * paints[paint], 3) +
                  line("diffuse", paints[paint]);
        for (int k = paint; k < 36; k += 3) {
            const auto number_of = static_cast<std::uint32_t>(k);
            const Vec3 at(k % 2 == 0 ? -1 : 5, 0.3, 108 - 7.5 * k - 3 * scatter(2000 + number_of));
            lights +=
                box(at, at + Vec3(1.8, 0.7, 4.2)) + box(at + Vec3(0.2, 0.7, 1), at + Vec3(1.6, 1.2, 3.2));
        }
    }
    return scene + lights;
}

/// Long thin triangles from a middle to all sides, each slanted: their boxes overlap nearly all.
std::string needles() {
    std::string positions, faces;
    const int count = 4000;
    for (int i = 0; i < count; ++i) {
        const auto random = [&](int k) { return scatter(static_cast<std::uint32_t>(8 * i + k)); };
        const Real z = 2 * random(0) - 1, turn = 2 * pi * random(1), flat = std::sqrt(1 - z * z);
        const Vec3 out(flat * std::cos(turn), z, flat * std::sin(turn));
        const Vec3 side = normalize(cross(out, Vec3(random(2) - 0.5, random(3) - 0.5, random(4) - 0.5)));
        const Real from = 0.45 + 0.3 * random(5), to = from + 0.5 + 2.2 * random(6) * random(7);
        const Vec3 foot = from * out;
        for (const Vec3& corner : {foot - Real(0.02) * side, foot + Real(0.02) * side, to * out})
            positions += line("v", corner, 4);
        faces += fmt::format("f {} {} {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
    }
    return fmt::format("# {} needles, made by make_scenes_13\n", count) + positions + faces;
}

/// A few trees near the eye, and very many far away, up to two kilometres.
std::string forest() {
    std::string scene =
        "# Trees near and far: 500 times the same tree of 10,000 triangles, the nearest 24 m and the "
        "farthest 2 km\n"
        "# away. Most of the box around all of them is empty.\n"
        "# Written by make_scenes_13 forest.scene; the tree is that of chapter 4.\n"
        "version 1\nsize 320 240\noutput forest.png\nencoding srgb\nbackground .62 .7 .78\nmaxdepth 1\n"
        "accelerator bvh\n\n"
        "camera 0 11 30   0 5 0   0 1 0   46\n\n"
        "directional .7 .6 .25   .85 .74 .55\ndirectional -.5 .4 .6   .1 .12 .16\n\n"
        "ambient .12 .14 .08\ndiffuse .3 .34 .16\nplane 0 0 0 0 1 0\n";
    for (std::uint32_t n = 0; n < 500; ++n) {
        // Evenly in the logarithm of the distance; those that are near stand beside the middle.
        const Real far = 24 * std::pow(85.0, std::pow(scatter(8 * n), 0.6));
        const Real aside = (scatter(8 * n + 1) - 0.5) * 1.1;
        const Real x = far * (far < 60 ? aside + (aside > 0 ? 0.18 : -0.18) : aside), z = 30 - far;
        const Real wide = 0.7 + 0.6 * scatter(8 * n + 2), high = wide * (0.9 + 0.4 * scatter(8 * n + 3));
        const Real air = 1 - std::exp(-far / 700), autumn = scatter(8 * n + 4);
        const Vec3 leaf =
            autumn > 0.8 ? Vec3(0.52, 0.27, 0.06) : Vec3(0.09, 0.26, 0.07) + autumn * Vec3(0.14, 0.1, 0);
        scene += line("ambient", air * Vec3(0.5, 0.56, 0.63) + (1 - air) * Real(0.14) * leaf) +
                 line("diffuse", (1 - air) * leaf);
        scene += fmt::format(
            "pushTransform\ntranslate {} 0 {}\nrotate 0 1 0 {}\nscale {} {} {}\n"
            "mesh ../04_transforms/tree.obj\npopTransform\n",
            number(x, 1), number(z, 1), number(360 * scatter(8 * n + 5), 0), number(wide), number(high),
            number(wide));
    }
    return scene;
}

/// Balls that fly in a ring, and some that stand still in the middle.
std::string swarm() {
    std::string scene =
        "# A swarm: 120 balls that move while the shutter is open, around some that stand still. Their boxes "
        "hold\n"
        "# the whole of their ways.\n"
        "# Written by make_scenes_13 swarm.scene\n"
        "version 1\nsize 320 200\noutput swarm.png\nencoding srgb\nspp 16\nsampler regular\nmaxdepth 1\n"
        "accelerator bvh\n\n"
        "camera 0 5 14   0 .9 0   0 1 0   38\nbackground .16 .2 .3\nshutter .2 .2\n\n"
        "directional 1 2 1.5   .7 .66 .58\ndirectional -1 1 .5   .16 .2 .28\n\n"
        "ambient .04 .05 .07\ndiffuse .3 .33 .4\nplane 0 0 0   0 1 0\n"
        "ambient .05 .05 .05\ndiffuse .7 .7 .68\nspecular .15 .15 .15\nshininess 60\n"
        "sphere 0 1.1 0   1.1\nsphere 1.5 .4 .9   .4\nsphere -1.6 .5 .6   .5\n";
    const Vec3 colors[] = {{0.8, 0.35, 0.12}, {0.75, 0.6, 0.15}, {0.2, 0.45, 0.6}};
    for (std::uint32_t c = 0; c < 3; ++c) {
        scene += line("ambient", Real(0.1) * colors[c], 3) + line("diffuse", colors[c]);
        for (std::uint32_t n = c; n < 120; n += 3) {
            const Real turn = 2 * pi * (n + scatter(5 * n)) / 120, out = 3 + 2.6 * scatter(5 * n + 1);
            const Vec3 at(out * std::cos(turn), 0.4 + 2.2 * scatter(5 * n + 2), out * std::sin(turn));
            const Real speed = 0.25 + 0.5 * scatter(5 * n + 3);
            scene += line("motion",
                          speed * Vec3(-std::sin(turn), 0.3 * (scatter(5 * n + 4) - 0.5), std::cos(turn)));
            scene += fmt::format("sphere {} {} {}   {}\n", number(at.x), number(at.y), number(at.z),
                                 number(0.08 + 0.14 * scatter(5 * n + 4)));
        }
    }
    return scene;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc == 3 ? argv[1] : "";
    std::string text;
    if (what == "city.scene") text = city();
    if (what == "forest.scene") text = forest();
    if (what == "swarm.scene") text = swarm();
    if (what == "needles.obj") text = needles();
    if (text.empty()) {
        std::fputs("usage: make_scenes_13 city.scene|forest.scene|swarm.scene|needles.obj FILE\n", stderr);
        return 2;
    }
    try {
        write_file(argv[2], text);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
