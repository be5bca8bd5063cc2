// Writes swan.obj, the ice sculpture of lesson 7, into the directory that it is given:
//     g++ -std=c++20 -I. references/07_recursion/make_swan.cpp -o build/make_swan && build/make_swan
//     references/07_recursion
#include "common/math/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace rt;

namespace {

/// A station of the swan's spine, from tail to beak, in the plane z = 0; half the height and width of the
/// cross-section there, and how far the folded wings stand out of it.
struct Station {
    Real x, y, half_height, half_width, wing;
};

constexpr std::array<Station, 15> spine{{{-1.62, 0.98, 0.03, 0.05, 0},
                                         {-1.3, 0.8, 0.16, 0.24, 0.1},
                                         {-0.85, 0.6, 0.34, 0.46, 0.3},
                                         {-0.25, 0.5, 0.44, 0.6, 0.4},
                                         {0.3, 0.5, 0.42, 0.52, 0.25},
                                         {0.72, 0.64, 0.31, 0.35, 0},
                                         {1.0, 0.97, 0.2, 0.21, 0},
                                         {1.0, 1.34, 0.145, 0.145, 0},
                                         {0.84, 1.68, 0.12, 0.12, 0},
                                         {0.76, 2.02, 0.11, 0.11, 0},
                                         {0.88, 2.31, 0.115, 0.115, 0},
                                         {1.12, 2.43, 0.145, 0.14, 0},
                                         {1.36, 2.36, 0.12, 0.115, 0},
                                         {1.54, 2.24, 0.055, 0.06, 0},
                                         {1.8, 2.1, 0.02, 0.035, 0}}};

/// Catmull and Rom's curve through four values, between the middle two.
Real between(Real a, Real b, Real c, Real d, Real t) {
    return b + t * ((c - a) / 2 + t * (a - 2.5 * b + 2 * c - d / 2 + t * ((d - a) / 2 + 1.5 * (b - c))));
}

Station at(Real s) {
    const auto last = static_cast<int>(spine.size()) - 1;
    const int i = std::min(static_cast<int>(s), last - 1);
    const auto station = [&](int k) { return spine[static_cast<std::size_t>(std::clamp(k, 0, last))]; };
    const Station a = station(i - 1), b = station(i), c = station(i + 1), d = station(i + 2);
    const auto mix = [&](Real Station::*m) { return between(a.*m, b.*m, c.*m, d.*m, s - i); };
    return {mix(&Station::x), mix(&Station::y), mix(&Station::half_height), mix(&Station::half_width),
            mix(&Station::wing)};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make_swan DIRECTORY\n";
        return 2;
    }
    constexpr int rings = 28, sides = 12;
    std::vector<Vec3> vertices;
    for (int r = 0; r < rings; ++r) {
        const Real s = r * static_cast<Real>(spine.size() - 1) / (rings - 1);
        const Station here = at(s), before = at(std::max(s - 0.1, 0.0)), after = at(std::min(s + 0.1, 14.0));
        const Vec3 along = glm::normalize(Vec3(after.x - before.x, after.y - before.y, 0));
        const Vec3 up(-along.y, along.x, 0);
        for (int k = 0; k < sides; ++k) {
            // Every other ring is turned by half a side: that makes the facets of a chisel.
            const Real angle = 2 * pi * (k + 0.5 * (r % 2)) / sides;
            const Real c = std::cos(angle), q = std::sin(angle);
            const Real wing = 1 + here.wing * std::pow(std::max(std::abs(c) * q * 2, 0.0), 3.0);
            vertices.push_back(Vec3(here.x, here.y, 0) + wing * q * here.half_height * up +
                               wing * c * here.half_width * Vec3(0, 0, 1));
        }
    }
    const Station tail = spine.front(), beak = spine.back();
    vertices.emplace_back(tail.x - 0.03, tail.y + 0.02, 0);
    vertices.emplace_back(beak.x + 0.03, beak.y - 0.02, 0);

    std::ofstream file(std::string(argv[1]) + "/swan.obj");
    file << "# A swan, carved: one closed surface of flat facets. Made by make_swan.cpp.\n";
    const auto write = [&](const char* format, auto... numbers) {
        char text[80];
        std::snprintf(text, sizeof text, format, numbers...);
        file << text;
    };
    for (const Vec3& v : vertices) write("v %.4f %.4f %.4f\n", v.x, v.y, v.z);
    const auto index = [](int r, int k) { return r * sides + (k + sides) % sides + 1; };
    const auto face = [&](int a, int b, int c) { write("f %d %d %d\n", a, b, c); };
    for (int k = 0; k < sides; ++k) {
        face(rings * sides + 1, index(0, k), index(0, k + 1));
        face(rings * sides + 2, index(rings - 1, k + 1), index(rings - 1, k));
    }
    for (int r = 0; r + 1 < rings; ++r) {
        for (int k = 0; k < sides; ++k) {
            if (r % 2 == 0) {
                face(index(r, k), index(r + 1, k), index(r, k + 1));
                face(index(r + 1, k), index(r + 1, k + 1), index(r, k + 1));
            } else {
                face(index(r, k), index(r + 1, k + 1), index(r, k + 1));
                face(index(r, k), index(r + 1, k), index(r + 1, k + 1));
            }
        }
    }
}
