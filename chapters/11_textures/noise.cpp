// Perlin's improved noise, and what is added up from it.
#include "chapters/11_textures/noise.hpp"

#include "common/math/todo.hpp"

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
    // 11.7  Return the smooth step from 0 to 1.
    return todo("11.7");
}

LatticeCell lattice_cell(const Vec3& p) {
    // 11.7  Which cell of the lattice of whole numbers is p in, and where in it? The corner's
    // coordinates are from 0 to 255, for every p: also for a negative one, and for one that no int holds.
    return todo("11.7");
}

Real noise(const Vec3& p) {
    // 11.7  Return the weighted mean of what the eight corners of p's cell say.
    return todo("11.7");
}

Vec3 noise_gradient(const Vec3& p) {
    // 11.10  Return the derivatives of noise by x, y and z at p.
    return todo("11.10");
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
