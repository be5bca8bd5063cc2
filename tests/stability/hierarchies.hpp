// Families of extreme scenes for chapter 13. Those of chapter 9 are asked of hierarchies, too; here are those
// that are extreme for a tree: sizes in geometric progression, which make it deep, and closed meshes, through
// which no ray may leak.
//
// Demand: what the hierarchy answers is what asking every shape answers, to the bit.
#pragma once

#include "chapters/13_hierarchies/build.hpp"
#include "tests/stability/grids.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt::stability {

/// What a scene's hierarchy is made like, at random: each method, and leaves of 1 to 16 shapes.
HierarchyOptions some_options(test::Random& random);

/// The hierarchy over the scene's shapes.
Hierarchy hierarchy_over(const AnyShapes& shapes, const HierarchyOptions& options);

/// A scene of a family of chapter 9, whose meshes have hierarchies where that has grids.
GridScene make_scene_of_trees(const GridFamily& family, std::uint64_t seed);

/// Spheres in a row, each of which is half as large as the one before it and touches it, or nearly.
std::vector<Sphere> ladder(std::size_t count);

/// A closed mesh around the origin: a ball of radius 1 whose corners are moved at random. No edge is open.
std::vector<Triangle> closed_mesh(test::Random& random, int rings);

/// A ray from inside of the closed mesh to one of its corners, or to a point on one of its edges, up to
/// rounding.
Ray ray_at_edge(const std::vector<Triangle>& mesh, test::Random& random);

}  // namespace rt::stability

namespace rt::naive {

/// The nearest hit by a search that passes over nodes whose boxes are entered exactly at the nearest hit so
/// far, and by boxes without a margin and a slab test that is not widened.
std::optional<Hit> closest_hit(const Hierarchy& hierarchy, std::span<const Triangle> shapes, const Ray& ray,
                               Interval range);

}  // namespace rt::naive
