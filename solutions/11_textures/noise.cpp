// Perlin's improved noise, and what is added up from it.
#include "chapters/11_textures/noise.hpp"

#include <cmath>

namespace rt {
namespace {

/// The 12 directions, four of them twice so that four bits choose (Perlin 2002).
constexpr std::array<std::array<int, 3>, 16> directions{{{1, 1, 0},
                                                         {-1, 1, 0},
                                                         {1, -1, 0},
                                                         {-1, -1, 0},
                                                         {1, 0, 1},
                                                         {-1, 0, 1},
                                                         {1, 0, -1},
                                                         {-1, 0, -1},
                                                         {0, 1, 1},
                                                         {0, -1, 1},
                                                         {0, 1, -1},
                                                         {0, -1, -1},
                                                         {1, 1, 0},
                                                         {0, -1, 1},
                                                         {-1, 1, 0},
                                                         {0, -1, -1}}};

int permuted(int i) { return noise_permutation[static_cast<std::size_t>(i & 255)]; }

}  // namespace

Vec3 lattice_gradient(int i, int j, int k) {
    const int hash = permuted(permuted(permuted(i) + (j & 255)) + (k & 255));
    const std::array<int, 3>& direction = directions[static_cast<std::size_t>(hash & 15)];
    return {direction[0], direction[1], direction[2]};
}

Real fade(Real t) {
    // [exercise 11.7] Return the smooth step from 0 to 1.
    return t * t * t * (10 + t * (6 * t - 15));
    // [/exercise]
}

LatticeCell lattice_cell(const Vec3& p) {
    // [exercise 11.7] Which cell of the lattice of whole numbers is p in, and where in it? The corner's
    // coordinates are from 0 to 255, for every p: also for a negative one, and for one that no int holds.
    const Vec3 whole = glm::floor(p);
    LatticeCell cell{.offset = p - whole};
    for (int axis = 0; axis < 3; ++axis) {
        // Both are exact, whatever the size: a multiple of 256, and what is left of a whole number.
        const Real turns = 256 * std::floor(whole[axis] / 256);
        cell.corner[static_cast<std::size_t>(axis)] = static_cast<int>(whole[axis] - turns);
    }
    return cell;
    // [/exercise]
}

Real noise(const Vec3& p) {
    // [exercise 11.7] Return the weighted mean of what the eight corners of p's cell say.
    const auto [corner, offset] = lattice_cell(p);
    const Vec3 upper(fade(offset.x), fade(offset.y), fade(offset.z));
    Real sum = 0;
    for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        const Vec3 weight = glm::mix(Real(1) - upper, upper, Vec3(i, j, k));
        const Vec3 gradient = lattice_gradient(corner[0] + i, corner[1] + j, corner[2] + k);
        sum += weight.x * weight.y * weight.z * dot(gradient, offset - Vec3(i, j, k));
    }
    return sum;
    // [/exercise]
}

Vec3 noise_gradient(const Vec3& p) {
    // [exercise 11.10] Return the derivatives of noise by x, y and z at p.
    const auto [corner, t] = lattice_cell(p);
    const Vec3 upper(fade(t.x), fade(t.y), fade(t.z)),
        rise = Real(30) * t * t * (t - Real(1)) * (t - Real(1));
    Vec3 sum(0);
    for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        const Vec3 side(i, j, k);
        const Vec3 w = glm::mix(Real(1) - upper, upper, side), slope = (Real(2) * side - Real(1)) * rise;
        const Vec3 weight_slope(slope.x * w.y * w.z, w.x * slope.y * w.z, w.x * w.y * slope.z);
        const Vec3 gradient = lattice_gradient(corner[0] + i, corner[1] + j, corner[2] + k);
        sum += w.x * w.y * w.z * gradient + dot(gradient, t - side) * weight_slope;
    }
    return sum;
    // [/exercise]
}

Real turbulence(const Vec3& p, int octaves) {
    Real sum = 0, scale = 1;
    for (int i = 0; i < octaves; ++i, scale *= 2) {
        const Vec3 finer = scale * p;
        if (!std::isfinite(size_of(finer))) break;
        sum += std::abs(noise(finer)) / scale;
    }
    return sum;
}

}  // namespace rt
