// Affine maps: matrices, their stack, their inverse, and what they do to points, vectors, normals and rays.
// u is the unit roundoff of `Real`.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/scene.hpp"
#include "common/world/world.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// [04.1] Matrix that moves points by `by` and leaves directions alone.
Mat4 translation(const Vec3& by);

/// [04.1] Matrix that multiplies each coordinate by its factor.
Mat4 scaling(const Vec3& by);

/// [04.2] Matrix that rotates by `angle` radians about `axis` through the origin, counterclockwise seen
/// from the axis's tip (Rodrigues 1840). The axis may have any length but 0. Each element is right to a few
/// roundings.
Mat4 rotation(const Vec3& axis, Real angle);

/// The matrix of one step. Given.
Mat4 matrix(const TransformStep& step);

/// [04.3] The matrix stack of a scene file: for each node of the tree its matrix, which is its parent's
/// times its own step's; the last step written acts first on a point. Parents stand before children.
std::vector<Mat4> compose(std::span<const TransformNode> nodes);

/// [04.4] Inverse of an affine matrix by elimination with pivoting (rows scaled first), its last bits set
/// right by Newton's steps (Schulz 1933): |MM⁻¹ − I| and |M⁻¹M − I| are at most 8u·|M||M⁻¹| and 8u·|M⁻¹||M|,
/// element by element. Nothing if the matrix is singular to working precision (its rows in units of their
/// greatest element), or if a number of it or of its inverse is not finite. In another unit of length, a
/// power of two, the inverse has the same digits.
std::optional<Mat4> inverse(const Mat4& m);

/// [04.5] M·(p, 1): points feel the translation.
Vec3 transform_point(const Mat4& m, const Vec3& p);

/// [04.5] M·(v, 0): directions do not.
Vec3 transform_vector(const Mat4& m, const Vec3& v);

/// [04.5] Normal of the image of a surface: the transpose of the inverse, times n. `inverse` is the map
/// from the image back. Not of unit length.
Vec3 transform_normal(const Mat4& inverse, const Vec3& n);

/// [04.5] The ray in the local space of `transform`; its direction is not made a unit vector, so that t
/// means the same point in both spaces.
Ray to_local(const Transform& transform, const Ray& ray);

/// [04.7] The rotation nearest to the linear part of `m`, or the rotation with a reflection if `m` reflects:
/// the orthogonal factor R of L = R·S, where S is symmetric and stretches (Higham 1986). The translation is
/// that of `m`. Nothing if `m` has no inverse. Asked of matrices that stretch by factors from 2^-20 to 2^20;
/// right to some roundings where they are near 1.
std::optional<Mat4> nearest_rotation(const Mat4& m);

/// A surface from the local space of `transform` to world space: point and unit normals, and an error bound
/// that also covers the way back, which the next ray takes. Given.
Surface to_world(const Transform& transform, const Surface& local);

}  // namespace rt
