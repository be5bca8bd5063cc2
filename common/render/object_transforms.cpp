// The transforms of a scene's objects: their matrices, and what can be said of them without looking at
// numbers.
#include "common/render/object_transforms.hpp"

#include "chapters/04_transforms/transform.hpp"
#include "common/render/object_limits.hpp"
#include "common/scene/range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace rt {
namespace {

/// More would be nothing but a mistake of the program that wrote the file.
constexpr std::size_t most_turns = 100;

/// The matrix's inverse; a matrix without one, or out of range, is an error at this step of the file.
Mat4 checked_inverse(const Scene& scene, const TransformNode& node, const Mat4& m) {
    const auto complain = [&](std::string_view what) {
        refuse(scene, node.place, fmt::format("the transform in force after this step {}", what));
    };
    if (!in_range(m)) complain(fmt::format("has numbers beyond {}", largest_number));
    const std::optional<Mat4> back = inverse(m);
    if (!back) complain("is singular: it has no inverse");
    if (!in_range(Mat3(*back)))
        complain(fmt::format("makes lengths shorter by more than {}", largest_number));
    return *back;
}

}  // namespace

ObjectTransforms::ObjectTransforms(const Scene& of) : scene(of) {
    const auto transformed = [](const Object& object) { return object.transform >= 0; };
    if (std::ranges::none_of(scene.objects, transformed) && std::ranges::none_of(scene.parts, transformed))
        return;
    matrix = compose(scene.transforms);
    inverse.resize(scene.transforms.size());
    for (const TransformNode& node : scene.transforms) {
        const auto parent = static_cast<std::size_t>(node.parent);
        std::optional<Real> same = node.parent < 0 ? 1 : factor[parent];
        bool is_turned = node.parent >= 0 && turned[parent];
        if (const auto* scale = std::get_if<Scale>(&node.step)) {
            const Vec3 by = glm::abs(scale->by);
            same = same && by.x == by.y && by.y == by.z ? std::optional(*same * by.x) : std::nullopt;
            is_turned = is_turned || by != scale->by;
        }
        is_turned = is_turned || std::holds_alternative<Rotate>(node.step);
        factor.push_back(same);
        turned.push_back(is_turned);
        spin.push_back(node.spin != 0 ? static_cast<int>(spin.size()) : node.parent >= 0 ? spin[parent] : -1);
    }
}

std::optional<Transform> ObjectTransforms::of(const Object& object) {
    if (object.transform < 0) return std::nullopt;
    std::vector<std::size_t> chain;
    for (int i = object.transform; i >= 0 && !inverse[static_cast<std::size_t>(i)];
         i = scene.transforms[static_cast<std::size_t>(i)].parent)
        chain.push_back(static_cast<std::size_t>(i));
    for (auto node = chain.rbegin(); node != chain.rend(); ++node)
        inverse[*node] = checked_inverse(scene, scene.transforms[*node], matrix[*node]);
    const auto node = static_cast<std::size_t>(object.transform);
    return Transform{matrix[node], *inverse[node]};
}

std::optional<Real> ObjectTransforms::similarity(const Object& object) const {
    return object.transform < 0 ? 1 : factor[static_cast<std::size_t>(object.transform)];
}

bool ObjectTransforms::turns(const Object& object) const {
    return object.transform >= 0 && turned[static_cast<std::size_t>(object.transform)];
}

int ObjectTransforms::last_spin(const Object& object) const {
    return object.transform < 0 ? -1 : spin[static_cast<std::size_t>(object.transform)];
}

std::vector<Spin> ObjectTransforms::turns_until(int last_spin) const {
    std::vector<Spin> turns;
    for (int i = last_spin; i >= 0;) {
        const auto own = static_cast<std::size_t>(i);
        const TransformNode& node = scene.transforms[own];
        if (turns.size() == most_turns)
            refuse(scene, node.place, fmt::format("more than {} turns, one inside the other", most_turns));
        if (!factor[own])
            refuse(scene, node.place,
                   "a turn under a scale that is not the same along all axes: let 'scale' follow 'spin'");
        const Mat4& m = matrix[own];
        const Vec3 axis = transform_vector(m, unit(std::get<Rotate>(node.step).axis));
        // In a mirror it goes the other way.
        turns.push_back({Vec3(m[3]), unit(axis), glm::determinant(Mat3(m)) < 0 ? -node.spin : node.spin});
        i = node.parent < 0 ? -1 : spin[static_cast<std::size_t>(node.parent)];
    }
    std::ranges::reverse(turns);
    return turns;
}

/// How much longer the longest half-axis of a ball's image is than the shortest; too much by a factor of 3 at
/// most.
Real flattening_of(const Transform& t) {
    Real there = 0, back = 0;
    for (int column = 0; column < 3; ++column) {
        there += dot(Vec3(t.to_world[column]), Vec3(t.to_world[column]));
        back += dot(Vec3(t.to_local[column]), Vec3(t.to_local[column]));
    }
    return std::sqrt(there) * std::sqrt(back);
}

}  // namespace rt
