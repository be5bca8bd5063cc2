// Writes this chapter's meshes and its long scenes, the same text on every machine.
// make_models tree.obj|link.obj|ellipsoids.scene|forest.scene FILE
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/vec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace {

using namespace rt;

/// Rounded to `decimals`, without trailing zeros; the last bits of a machine's sine do not show.
std::string number(Real x, int decimals) {
    const Real unit = std::pow(Real(10), decimals);
    // Adding zero makes -0 a 0.
    return fmt::format("{:.10g}", std::round(x * unit) / unit + 0.0);
}

std::string line(std::string_view word, const Vec3& v, int decimals) {
    return fmt::format("{} {} {} {}\n", word, number(v.x, decimals), number(v.y, decimals),
                       number(v.z, decimals));
}

// ---------------------------------------------------------------------------------------------- meshes

/// A smooth surface of 2·along·around triangles over the unit square; it closes in the second direction, and
/// in the first if `ring`. Normals are those of the surface, (d/da) × (d/db).
std::string to_obj(std::string_view title, int along, int around, bool ring,
                   const std::function<Vec3(Real, Real)>& surface) {
    std::string positions, normals, faces;
    const int rows = ring ? along : along + 1;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < around; ++j) {
            const Real a = static_cast<Real>(i) / along, b = static_cast<Real>(j) / around, h = 1e-4;
            const Vec3 n =
                cross(surface(a + h, b) - surface(a - h, b), surface(a, b + h) - surface(a, b - h));
            positions += line("v", surface(a, b), 4);
            normals += line("vn", normalize(n), 3);
        }
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const auto at = [&](int di, int dj) { return (i + di) % rows * around + (j + dj) % around + 1; };
            faces += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\nf {0}//{0} {2}//{2} {3}//{3}\n", at(0, 0),
                                 at(1, 0), at(1, 1), at(0, 1));
        }
    return fmt::format("# {}, {} triangles, made by make_models\n", title, 2 * along * around) + positions +
           normals + faces;
}

/// A conifer, 10 high, on the plane y = 0: seven skirts of branches over a trunk.
std::string tree() {
    return to_obj("A conifer", 100, 50, false, [](Real a, Real b) {
        const Real turn = 2 * pi * b, skirts = 7, foot = 0.12;
        const Real up = (a - foot) / (1 - foot);  // along the crown; negative on the trunk
        Real radius = 0.35;
        if (up > 0) {
            const Real skirt = std::floor(up * skirts), within = up * skirts - skirt;
            const Real branches = 1 + 0.14 * std::cos(9 * turn + 2 * skirt) * (1 - within);
            radius = 0.06 + 2.7 * (1 - up) * (1 - 0.55 * within) * branches;
        }
        return Vec3(radius * std::cos(turn), 10 * a, -radius * std::sin(turn));
    });
}

/// A link of a chain, about the z axis: a ring of radius 1, 0.22 thick.
std::string link() {
    return to_obj("A link of a chain", 40, 14, true, [](Real a, Real b) {
        const Real s = 2 * pi * a, t = 2 * pi * b, r = 1 + 0.22 * std::cos(t);
        return Vec3(r * std::cos(s), r * std::sin(s), 0.22 * std::sin(t));
    });
}

// ---------------------------------------------------------------------------------------------- scenes

/// A number in [0, 1) that looks random (a hash by multiplication and shifts).
Real scatter(std::uint32_t i) {
    i = (i ^ (i >> 16)) * 0x7feb352du;
    i = (i ^ (i >> 15)) * 0x846ca68bu;
    return static_cast<Real>(i ^ (i >> 16)) * 0x1p-32;
}

std::string ellipsoids() {
    std::string scene =
        "# The picture of chapter 4: a dahlia. Each petal is the same unit sphere under its own transform.\n"
        "# Written by make_models ellipsoids.scene.\n"
        "version 1\nsize 320 240\noutput ellipsoids.png\nencoding srgb\nintegrator normals\n"
        "background .02 .02 .03\n\ncamera 0 3.6 9.4   0 -.05 0   0 1 0   23\n\n";
    // Petals follow each other by the golden angle, from the heart outward over a ball; the turns add up.
    const int petals = 230;
    for (int i = 0; i < petals; ++i) {
        const Real from_heart = (i + 0.5) / petals;
        const Real polar = std::acos(1 - 1.75 * from_heart) * 180 / pi,
                   size = 0.3 + 0.3 * std::sqrt(from_heart);
        scene += "rotate 0 1 0 137.508\npushTransform\n";
        scene += fmt::format("  rotate 0 0 1 {}\n  translate 0 1.3 0\n", number(-polar, 1));
        scene += fmt::format("  rotate 0 0 1 {}\n", number(62 - 40 * from_heart, 1));
        scene += fmt::format("  scale {} {} {}\n", number(size, 3), number(0.05 + 0.06 * size, 3),
                             number(0.52 * size, 3));
        scene += "  sphere .55 0 0 1\npopTransform\n";
    }
    return scene;
}

std::string forest() {
    std::string scene =
        "# A forest: 1024 times the same tree of 10,000 triangles, in the memory of one and 1024 pairs of "
        "matrices.\n"
        "# Near rows come first: what they hide need not be searched.\n"
        "# Written by make_models forest.scene; the tree is made by the build (make_models tree.obj).\n"
        "version 1\nsize 160 120\noutput forest.png\nencoding srgb\nintegrator flat\n"
        "background .58 .67 .68\n\ncamera 0 30 116   0 -5 0   0 1 0   38\n\n";
    const int rows = 32;
    const Vec3 near(0.015, 0.075, 0.03), far(0.53, 0.62, 0.62);
    for (int i = 0; i < rows * rows; ++i) {
        const auto n = static_cast<std::uint32_t>(i);
        const Real row = i / rows, x = 6.5 * (i % rows - 15.5) + 3.6 * (scatter(7 * n) - 0.5);
        const Real z = 6.5 * (15.5 - row) + 3.6 * (scatter(7 * n + 1) - 0.5);
        const Real wide = 0.75 + 0.35 * scatter(7 * n + 2), high = wide * (0.85 + 0.4 * scatter(7 * n + 3));
        // The air between makes far trees pale.
        const Real air = 1 - std::exp(-row / 20);
        const Vec3 tint = (0.6 + 1.3 * scatter(7 * n + 4)) * near + scatter(7 * n + 5) * Vec3(0.03, 0.01, 0);
        const Vec3 color = (1 - air) * tint + air * far;
        scene += line("ambient", color, 3);
        scene += fmt::format(
            "pushTransform\n  translate {} 0 {}\n  rotate 0 1 0 {}\n  scale {} {} {}\n"
            "  mesh tree.obj\npopTransform\n",
            number(x, 2), number(z, 2), number(360 * scatter(7 * n + 6), 0), number(wide, 2), number(high, 2),
            number(wide, 2));
    }
    return scene;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc == 3 ? argv[1] : "";
    std::string text;
    if (what == "tree.obj") text = tree();
    if (what == "link.obj") text = link();
    if (what == "ellipsoids.scene") text = ellipsoids();
    if (what == "forest.scene") text = forest();
    if (text.empty()) {
        std::fputs("usage: make_models tree.obj|link.obj|ellipsoids.scene|forest.scene FILE\n", stderr);
        return 2;
    }
    try {
        write_file(argv[2], text);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
