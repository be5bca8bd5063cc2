// Cells: how far it is to the nearest of points that are strewn through space.
// ε is the unit roundoff of `Real`.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// How far the two nearest feature points are.
struct CellDistances {
    Real first = 0;        ///< to the nearest; at most sqrt(3)
    Real second = 0;       ///< to the second nearest: not less than `first`, and at most sqrt(3), too
    Vec3 nearest_cell{0};  ///< the cube that the nearest is in, by its lowest corner: whole numbers
};

/// Where the feature point of a unit cube is, as seen from the cube's lowest corner: each coordinate in [0,
/// 1), as if drawn by chance, but always the same for the same cube. `cell` is that corner: whole numbers of
/// any size; they are taken modulo 2^32. Given.
Vec3 cell_point(const Vec3& cell);

/// [11.9] The distances from q to the two nearest feature points, of which each unit cube of space has one
/// (Worley 1996), and which cube has the nearest; of equally near ones, any. For any finite q; distances to
/// 16ε, for |q| < 2^52. Beyond, cubes side by side are no longer told apart, and only the ranges above are
/// promised.
CellDistances cell_distances(const Vec3& q);

}  // namespace rt
