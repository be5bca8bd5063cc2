// The trees of combinations, from their parts upwards.
#include "common/render/combinations.hpp"

#include "common/math/error.hpp"
#include "common/render/groups.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt {
namespace {

/// No solid but a mesh has more faces.
constexpr std::uint32_t most_faces = 8;

template <class Shape>
std::uint32_t elements_of(const Shape&) {
    return most_faces;
}
std::uint32_t elements_of(const Instance& instance) {
    return static_cast<std::uint32_t>(instance.shape.mesh->triangles.shapes.size());
}

/// Wider by more than rounding has made the box, and will make a line that meets the shape.
template <class Shape>
Bounds around(const Shape& shape) {
    if constexpr (has_bounds<Shape>()) {
        const Bounds box = bounds_of(shape);
        Real distortion = 1;
        if constexpr (requires { shape.transform; }) distortion = distortion_of(shape.transform);
        return grown(box, gamma(64) * distortion * std::max(size_of(box.low), size_of(box.high)));
    } else {
        return {Vec3(-infinity), Vec3(infinity)};
    }
}

const Bounds& bounds_in(const Combination& tree, std::int32_t solid) {
    return solid >= 0 ? tree.parts[static_cast<std::size_t>(solid)].bounds
                      : tree.nodes[static_cast<std::size_t>(~solid)].bounds;
}

Bounds joined(SetOperation operation, const Bounds& a, const Bounds& b) {
    if (operation == SetOperation::Union) return merge(a, b);
    if (operation == SetOperation::Difference) return a;
    const Bounds both{glm::max(a.low, b.low), glm::min(a.high, b.high)};
    return glm::all(glm::lessThanEqual(both.low, both.high)) ? both : Bounds{};
}

/// A flat face of a solid that lies across an axis of the world, and how far rounding may have moved it.
struct FlatFace {
    Combination::CommonPlane plane;
    Real slack = 0;
    std::size_t part = 0;
};
using FlatFaces = std::vector<FlatFace>;

template <class Shape>
FlatFaces flat_faces(const Shape&, const Mat4&) {
    return {};
}

/// The face through `point` with this normal, both in the solid's own space; nothing if it lies askew in the
/// world.
void append_face(FlatFaces& faces, std::uint32_t element, const Mat4& m, const Vec3& point,
                 const Vec3& normal) {
    // The normals of an affine map's image are those of its inverse's rows; whether they lie along an axis
    // can be seen without it, where the map exchanges and stretches the axes.
    int own = -1;
    for (int axis = 0; axis < 3; ++axis)
        if (normal[(axis + 1) % 3] == 0 && normal[(axis + 2) % 3] == 0) own = axis;
    if (own < 0) return;
    int world = -1;
    for (int row = 0; row < 3; ++row)
        if (m[own][row] != 0) {
            if (world >= 0) return;
            world = row;
        }
    for (int column = 0; column < 3; ++column)
        if (column != own && m[column][world] != 0) return;
    const Real scaled = m[own][world] * point[own], moved = m[3][world];
    faces.push_back({{element, world, scaled + moved}, gamma(16) * (std::abs(scaled) + std::abs(moved))});
}

FlatFaces flat_faces(const Plane& plane, const Mat4& m) {
    FlatFaces faces;
    append_face(faces, 0, m, plane.point, plane.normal);
    return faces;
}

FlatFaces flat_faces(const Box& box, const Mat4& m) {
    FlatFaces faces;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        Vec3 normal(0);
        normal[static_cast<int>(axis)] = 1;
        append_face(faces, 2 * axis, m, box.low, normal);
        append_face(faces, 2 * axis + 1, m, box.high, normal);
    }
    return faces;
}

FlatFaces flat_faces(const Cone& cone, const Mat4& m) {
    FlatFaces faces;
    append_face(faces, 1, m, cone.a, cone.b - cone.a);
    append_face(faces, 2, m, cone.b, cone.b - cone.a);
    return faces;
}

// In a combination the box closes what it cuts.
FlatFaces flat_faces(const Implicit& implicit, const Mat4& m) { return flat_faces(implicit.box, m); }
FlatFaces flat_faces(const Quadric& quadric, const Mat4& m) { return flat_faces(quadric.box, m); }

template <class Shape>
FlatFaces flat_faces(const Placed<Shape>& placed, const Mat4&) {
    return flat_faces(placed.shape, placed.transform.to_world);
}

}  // namespace

void find_common_planes(Combination& tree) {
    FlatFaces all;
    for (std::size_t i = 0; i < tree.parts.size(); ++i)
        for (FlatFace face :
             std::visit([](const auto& solid) { return flat_faces(solid, Mat4(1)); }, tree.parts[i].solid)) {
            face.part = i;
            all.push_back(face);
        }
    std::ranges::sort(all, {},
                      [](const FlatFace& face) { return std::pair(face.plane.axis, face.plane.place); });
    // Neighbours that only rounding keeps apart, such as 0.3 and 0.1 + 0.2, lie where the first of them lies.
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        const auto& [element, axis, place] = all[first].plane;
        for (end = first + 1; end < all.size() && all[end].plane.axis == axis; ++end)
            if (all[end].plane.place - place > std::max(all[first].slack, all[end].slack)) break;
        if (end - first < 2) continue;
        for (std::size_t i = first; i < end; ++i)
            tree.parts[all[i].part].common_planes.push_back({all[i].plane.element, axis, place});
    }
}

std::int32_t add_part(Combination& tree, Solid solid, bool is_taken_away) {
    std::uint32_t first = 0;
    if (!tree.parts.empty()) {
        const Combination::Part& last = tree.parts.back();
        first = last.first_element + std::visit([](const auto& one) { return elements_of(one); }, last.solid);
    }
    const Bounds bounds = std::visit([](const auto& one) { return around(one); }, solid);
    tree.parts.push_back({std::move(solid), first, is_taken_away, bounds, {}});
    return static_cast<std::int32_t>(tree.parts.size()) - 1;
}

std::int32_t join(Combination& tree, SetOperation operation, std::span<const std::int32_t> solids) {
    if (solids.size() == 1) return solids.front();
    const bool is_difference = operation == SetOperation::Difference;
    const std::size_t middle = is_difference ? 1 : solids.size() / 2;
    const std::int32_t first = join(tree, operation, solids.first(middle));
    const std::int32_t second =
        join(tree, is_difference ? SetOperation::Union : operation, solids.subspan(middle));
    tree.nodes.push_back(
        {operation, first, second, joined(operation, bounds_in(tree, first), bounds_in(tree, second))});
    return -static_cast<std::int32_t>(tree.nodes.size());
}

PartHit part_hit(const Combination& tree, std::uint32_t element) {
    const auto after = std::ranges::upper_bound(tree.parts, element, {}, &Combination::Part::first_element);
    const Combination::Part& part = *std::prev(after);
    return {part, element - part.first_element};
}

Real crossings_of(const Instance& instance) { return elements_of(instance); }

Real crossings_of(const Moving& moving) {
    return std::visit([](const auto& shape) { return crossings_of(shape); }, moving.shape);
}

Real crossings_of(const Turning& turning) {
    return std::visit([](const auto& shape) { return crossings_of(shape); }, turning.shape);
}

Real crossings_of(const Combination& tree) {
    Real sum = 0;
    for (const Combination::Part& part : tree.parts)
        sum += std::visit([](const auto& solid) { return crossings_of(solid); }, part.solid);
    return sum;
}

}  // namespace rt
