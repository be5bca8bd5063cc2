// Hierarchies of spheres, of boxes with axes of their own, and of ellipsoids, over any shapes. All is given.
#pragma once

#include "chapters/09_grids/bounds.hpp"
#include "chapters/13_hierarchies/ellipsoid_around.hpp"
#include "chapters/13_hierarchies/oriented_box.hpp"
#include "chapters/13_hierarchies/sphere_around.hpp"
#include "common/world/bounding_volumes.hpp"
#include "common/world/hierarchy.hpp"
#include "common/world/search.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// Points around each shape: a convex volume that contains all of a shape's points contains the shape.
struct ShapePoints {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> first{0};  ///< shape i has points[first[i]] up to points[first[i + 1]]
};

/// Adds a shape: a triangle's corners, a polygon's vertices, or else the corners of its box; none where that
/// is empty.
template <class Shape>
void add_points(ShapePoints& to, const Shape& shape, const Bounds& box) {
    if constexpr (requires { shape.a, shape.b, shape.c; }) {
        for (const Vec3& corner : {shape.a, shape.b, shape.c}) to.points.push_back(corner);
    } else if constexpr (requires { shape.vertices; }) {
        to.points.insert(to.points.end(), shape.vertices.begin(), shape.vertices.end());
    } else if (!is_empty(box)) {
        for (const Real x : {box.low.x, box.high.x})
            for (const Real y : {box.low.y, box.high.y})
                for (const Real z : {box.low.z, box.high.z}) to.points.push_back({x, y, z});
    }
    to.first.push_back(static_cast<std::uint32_t>(to.points.size()));
}

// ---------------------------------------------------------------------------------------- around many points

/// Some of the points, at most 26: those that are farthest out in the directions of the corners, edges and
/// faces of the box along these axes. There must be a point.
std::vector<Vec3> outermost(std::span<const Vec3> points, const Mat3& axes);

/// A small box around the points: refined from the principal axes by the outermost points, or along the
/// world's axes where that is as small. Empty where there is no point.
OrientedBox small_box(std::span<const Vec3> points);

/// An ellipsoid around the points, of which there is at least one. Its volume is at most 1.2 times that of
/// the smallest where the outermost points are all that count. Points in a plane would leave it without an
/// inside: to both sides of its middle it is at least as thick as `thickness`, which is greater than 0
/// unless some points are apart, and as 2^-15 of its longest axis.
BoundingEllipsoid small_ellipsoid(std::span<const Vec3> points, Real thickness);

// ---------------------------------------------------------------------------------------------------- trees

using SphereTree = VolumeTree<BoundingSphere>;
using OrientedBoxTree = VolumeTree<OrientedBox>;
using EllipsoidTree = VolumeTree<BoundingEllipsoid>;

/// The hierarchy with a sphere for each box: the smallest around the points of the node's shapes, grown so
/// that it contains what is up to a margin away from them along each axis.
SphereTree sphere_tree(const Hierarchy& hierarchy, const ShapePoints& shapes);
/// The same with small boxes.
OrientedBoxTree oriented_box_tree(const Hierarchy& hierarchy, const ShapePoints& shapes);
/// The same with small ellipsoids.
EllipsoidTree ellipsoid_tree(const Hierarchy& hierarchy, const ShapePoints& shapes);

// As for Hierarchy (13.2), but that a ray of length beyond 2^±150, or a tree of such a reach, is not served:
// squares of their numbers would leave the range of Real.

bool serves(const SphereTree& tree, const Ray& ray);
void search(const SphereTree& tree, const Ray& ray, Interval range, const Ask& ask);
std::size_t bytes_of(const SphereTree& tree);
std::string in_words(const SphereTree& tree);

bool serves(const OrientedBoxTree& tree, const Ray& ray);
void search(const OrientedBoxTree& tree, const Ray& ray, Interval range, const Ask& ask);
std::size_t bytes_of(const OrientedBoxTree& tree);
std::string in_words(const OrientedBoxTree& tree);

bool serves(const EllipsoidTree& tree, const Ray& ray);
void search(const EllipsoidTree& tree, const Ray& ray, Interval range, const Ask& ask);
std::size_t bytes_of(const EllipsoidTree& tree);
std::string in_words(const EllipsoidTree& tree);

}  // namespace rt
