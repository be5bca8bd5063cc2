// The teapot of Martin Newell (University of Utah, 1975): 32 Bézier patches of 4 × 4 control points, z up.
// Its 306 control points are so symmetric that 24 points of profiles and 14 cross-sections say them all.
#pragma once

#include "common/scene/shapes.hpp"

#include <array>
#include <vector>

namespace rt::teapot {

/// Control points, [row][column]; rows go along v, columns along u.
using Patch = std::array<std::array<Vec3, 4>, 4>;

/// A point of a profile that goes around the z axis: its radius, its height, and where the two middle control
/// points of a quarter turn stand: at (r, round · r) and (round · r, r).
struct Turned {
    Real radius, height, round = 0.56;
};

/// Four profiles of a surface of (nearly) revolution each, from the axis or the top; each makes four patches.
inline constexpr std::array<std::array<Turned, 4>, 6> turned{{
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},  // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}},                // body, upper part
    {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},                // body, lower part
    {{{0, 3.15}, {0.8, 3.15, 0.5625}, {0, 2.85}, {0.2, 2.7}}},         // knob
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},              // lid
    {{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}},                 // bottom
}};

/// A cross-section of handle or spout: two points in the plane y = 0, and half of its width.
struct Section {
    Real x, z, across_x, across_z, half_width;
};

/// Seven cross-sections of handle and spout each; the middle one belongs to two patches on each side.
inline constexpr std::array<std::array<Section, 7>, 2> tubes{{
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3},
      {-2.7, 1.575, -3, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

/// All 32 patches; (d/du) × (d/dv) points outwards.
inline std::vector<Patch> patches() {
    std::vector<Patch> all;
    for (std::size_t i = 0; i < turned.size(); ++i)
        for (int quarter = 0; quarter < 4; ++quarter) {
            Patch patch;
            for (std::size_t row = 0; row < 4; ++row) {
                const auto& [r, z, round] = turned[i][row];
                const std::array<Vec2, 4> arc{Vec2(r, 0), Vec2(r, round * r), Vec2(round * r, r), Vec2(0, r)};
                for (std::size_t k = 0; k < 4; ++k) {
                    Vec2 p = arc[k];
                    for (int turn = 0; turn < quarter; ++turn) p = Vec2(-p.y, p.x);
                    // Against the clock seen from below, so that all but the bottom, which is listed from
                    // its centre up and not down, face outwards.
                    patch[row][k] = Vec3(p.x, i == 5 ? p.y : -p.y, z);
                }
            }
            all.push_back(patch);
        }
    for (const auto& tube : tubes)
        for (const std::size_t first : {0u, 3u})
            for (const int side : {-1, 1}) {
                Patch patch;
                for (std::size_t row = 0; row < 4; ++row) {
                    const auto& [x, z, across_x, across_z, half_width] = tube[first + row];
                    const Vec3 near(x, 0, z), far(across_x, 0, across_z), out(0, side * half_width, 0);
                    patch[row] = side < 0 ? std::array{near, near + out, far + out, far}
                                          : std::array{far, far + out, near + out, near};
                }
                all.push_back(patch);
            }
    return all;
}

/// Bernstein's polynomials of degree 3 at t.
inline std::array<Real, 4> bernstein(Real t) {
    const Real s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// Their derivatives.
inline std::array<Real, 4> slopes(Real t) {
    const Real s = 1 - t;
    return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
}

inline Vec3 sum(const Patch& patch, const std::array<Real, 4>& of_row, const std::array<Real, 4>& of_column) {
    Vec3 result(0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) result += of_row[i] * of_column[j] * patch[i][j];
    return result;
}

/// Whether the first row of control points is one point, so that the four-sided patch has a tip there.
inline bool has_tip(const Patch& patch) { return patch[0][0] == patch[0][3]; }

/// Unit normal at (u, v), outwards.
inline Vec3 normal(const Patch& patch, Real u, Real v) {
    const Vec3 dv = sum(patch, slopes(v), bernstein(u));
    // At a tip d/du is 0. Near it it is v times its own derivative along v, which says its direction.
    const Vec3 du =
        v == 0 && has_tip(patch) ? sum(patch, slopes(v), slopes(u)) : sum(patch, bernstein(v), slopes(u));
    return normalize(cross(du, dv));
}

/// The teapot as triangles with a normal at each corner, y up: 2·fineness² a patch, and `fineness` fewer at a
/// tip, where they would be without area. It stands on the plane y = 0, is 3.15 high and 6.5 wide. The first
/// `count` patches only: 28 are a teapot without its bottom.
inline Mesh tessellate(int fineness) {
    Mesh mesh;
    const auto y_up = [](const Vec3& p) { return Vec3(p.x, p.z, 0 - p.y); };
    for (const Patch& patch : patches()) {
        const int first = static_cast<int>(mesh.positions.size());
        const auto corner = [&](int i, int j) {
            const int index = first + i * (fineness + 1) + j;
            return Mesh::Corner{.position = index, .normal = index};
        };
        for (int i = 0; i <= fineness; ++i)
            for (int j = 0; j <= fineness; ++j) {
                const Real v = static_cast<Real>(i) / fineness, u = static_cast<Real>(j) / fineness;
                mesh.positions.push_back(y_up(sum(patch, bernstein(v), bernstein(u))));
                mesh.normals.push_back(y_up(normal(patch, u, v)));
                if (i == fineness || j == fineness) continue;
                if (i > 0 || !has_tip(patch))
                    mesh.triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
                mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
            }
    }
    return mesh;
}

}  // namespace rt::teapot
