// What a grid over shapes would cost, found out on a sample of them.
#pragma once

#include "common/render/groups.hpp"
#include "common/render/outliers.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

// Costs are in units of one sphere asked; measured by `course report error-time`.
inline constexpr Real cost_of_shape = 60;    // to be entered in a grid
inline constexpr Real cost_of_question = 2;  // whether a sphere may be in a box
inline constexpr Real cost_of_clip = 14;     // a ray, before the first cell
inline constexpr Real cost_of_cell = 0.5;    // a ray, a cell

/// Whether a shape may be in a box.
template <class Shape>
inline constexpr Real question = cost_of_question* words<Shape>.overlap;

/// Shapes of one kind, and what chapter 9 asks of them.
template <class Shape>
struct Boxed {
    const std::vector<Shape>& shapes;
    std::vector<Bounds> bounds;
    Real distortion = 1;

    explicit Boxed(const std::vector<Shape>& all) : shapes(all) {
        bounds.reserve(shapes.size());
        for (const Shape& shape : shapes) {
            bounds.push_back(bounds_of(shape));
            if constexpr (requires { shape.transform; })
                distortion = std::max(distortion, distortion_of(shape.transform));
        }
    }

    std::size_t size() const { return shapes.size(); }
    Vec3 middle(std::size_t i) const { return bounds[i].low * Real(0.5) + bounds[i].high * Real(0.5); }

    /// The diagonal of the box around all.
    Real reach() const {
        Bounds around;
        for (const Bounds& box : bounds) around = merge(around, box);
        return glm::length(around.high - around.low);
    }

    bool may_be_in(std::uint32_t i, const Bounds& box) const {
        return rt::may_be_in(shapes[i], bounds[i], box);
    }
};

/// The cells from `low` up to and including `high`.
struct Block {
    Cells low;
    Cells high;
};

/// What it takes to list the cells of shapes, on average.
struct Listing {
    Real cells = 0;      ///< that a shape is listed in; counted up to 64
    Real questions = 0;  ///< that it takes to find them
    Real share = 0;      ///< of all cells
};

/// Finds the cells of shape i in the block by halves, as chapter 9 does, until there are more than 64.
template <class Shape>
void count_cells(const Boxed<Shape>& boxed, const GridShape& shape, std::uint32_t i, const Block& block,
                 Listing& listing) {
    if (listing.cells > 64) return;
    ++listing.questions;
    if (!boxed.may_be_in(i, {cell_box(shape, block.low).low, cell_box(shape, block.high).high})) return;
    const Cells size = block.high - block.low + 1;
    if (size == Cells(1)) {
        ++listing.cells;
        return;
    }
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Block lower = block, upper = block;
    lower.high[axis] = block.low[axis] + size[axis] / 2 - 1;
    upper.low[axis] = lower.high[axis] + 1;
    count_cells(boxed, shape, i, lower, listing);
    count_cells(boxed, shape, i, upper, listing);
}

/// The listing of a grid of this shape, from a sample of the shapes.
template <class Shape>
Listing listing_of(const Boxed<Shape>& boxed, const GridShape& shape) {
    const Vec3 per_length = Vec3(shape.cells) / (shape.box.high - shape.box.low);
    const auto cell_at = [&](const Vec3& point) {
        Cells cell(0);
        for (int a = 0; a < 3; ++a) {
            const Real place = (point[a] - shape.box.low[a]) * per_length[a];
            // Written so that NaN becomes 0.
            if (place > 0) cell[a] = static_cast<int>(std::min(place, static_cast<Real>(shape.cells[a] - 1)));
        }
        return cell;
    };
    Listing sum;
    const std::vector<std::size_t> some =
        sample(boxed.size(), std::clamp<std::size_t>(boxed.size() / 32, 8, 64));
    for (const std::size_t i : some) {
        Listing one;
        const Block block{cell_at(boxed.bounds[i].low), cell_at(boxed.bounds[i].high)};
        count_cells(boxed, shape, static_cast<std::uint32_t>(i), block, one);
        sum.cells += one.cells, sum.questions += one.questions;
    }
    const Real each = 1 / static_cast<Real>(some.size());
    const Real all = static_cast<Real>(shape.cells.x) * shape.cells.y * shape.cells.z;
    return {sum.cells * each, sum.questions * each, sum.cells * each / all};
}

}  // namespace rt
