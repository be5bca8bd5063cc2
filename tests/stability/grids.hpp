// Families of extreme scenes for chapter 9, and their judge: shapes of every kind, on the boundaries of
// cells, without thickness, far away, tiny or huge, alone, in crowds and in copies, and rays that are aimed
// at trouble. A family makes a scene from a seed, and any number of rays for it once its grid is built.
//
// Demand: what the grid answers is what asking every shape answers, to the bit: hit or miss, t, uv, which
// shape, which triangle of an instance.
#pragma once

#include "chapters/09_grids/walk.hpp"
#include "chapters/13_hierarchies/walk.hpp"
#include "tests/stability/verdict.hpp"
#include "tests/support.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace rt::stability {

using AnyShapes = std::variant<std::vector<Sphere>, std::vector<Triangle>, std::vector<Polygon>,
                               std::vector<Ellipsoid>, std::vector<Instance>>;

struct GridScene {
    AnyShapes shapes;
    GridOptions options;
    Grid grid;  ///< what build_grid makes of the shapes
};

struct GridFamily {
    const char* name;
    const char* extremes;  ///< what is extreme in it
    AnyShapes (*make)(test::Random& random);
};

/// All the families.
std::span<const GridFamily> grid_families();

/// A scene of the family, its options chosen at random, and its grid.
GridScene make_scene(const GridFamily& family, std::uint64_t seed);

/// The same with a uniform grid, or with grids in it, and so the meshes that are placed.
GridScene make_scene(const GridFamily& family, std::uint64_t seed, bool nested);

struct GridQuestion {
    Ray ray;
    Interval range;
};

/// Rays for the scene: at corners of shapes and of cells, along axes and diagonals, with zeros of either
/// sign, from inside, from boundaries, and from up to 2^17 edges of the box away.
std::vector<GridQuestion> make_questions(const GridScene& scene, std::size_t count, std::uint64_t seed);

/// The nearest hit, found by asking all the shapes, and all the triangles of an instance.
std::optional<Hit> nearest_of_all(const GridScene& scene, const GridQuestion& question);

/// Judges what closest_hit answers with the scene's grid.
Verdict judge_nearest(const GridScene& scene, std::span<const GridQuestion> questions);

/// Judges what any_hit answers with the scene's grid.
Verdict judge_any(const GridScene& scene, std::span<const GridQuestion> questions);

/// Judge what they answer with a hierarchy over the scene's shapes.
Verdict judge_nearest(const GridScene& scene, const Hierarchy& hierarchy,
                      std::span<const GridQuestion> questions);
Verdict judge_any(const GridScene& scene, const Hierarchy& hierarchy,
                  std::span<const GridQuestion> questions);

/// How many shapes there are.
std::size_t count_of(const AnyShapes& shapes);

}  // namespace rt::stability

namespace rt::naive {

/// The slab test as it is often written: multiplication by 1/d, minimum and maximum, and no thought of 0 · ∞.
std::optional<Interval> clip(const Bounds& box, const Ray& ray, Interval range);

/// The walk with the next boundary found by adding to the last (Amanatides & Woo 1987, as printed).
std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range);

/// The nearest hit in the first cell in which any shape is hit at all, wherever the hit lies.
std::optional<Hit> closest_hit(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray,
                               Interval range);

}  // namespace rt::naive
