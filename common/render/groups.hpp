// The questions of common/world/query.hpp, asked of one group: its shapes are known, so nothing is
// dispatched. Here all chapters' contracts meet the list of shapes (common/world/shapes.hpp).
#pragma once

#include "chapters/contracts.hpp"  // all of them; made by the build
#include "common/render/combinations.hpp"
#include "common/render/moving.hpp"
#include "common/world/query.hpp"

#include <concepts>
#include <variant>
#include <vector>

namespace rt {

/// As std::visit, which of more than eleven alternatives reads the address of a function from a table: here
/// they are asked for one by one, the oldest first, and what is done with each is in the function that asks.
template <std::size_t first = 0, class Use>
decltype(auto) visit_group(const AnyGroup& any, const Use& use) {
    if constexpr (first + 1 < std::variant_size_v<AnyGroup>)
        if (any.index() != first) return visit_group<first + 1>(any, use);
    const auto* group = std::get_if<first>(&any);
    if (!group) __builtin_unreachable();
    return use(*group);
}

/// The group's shapes. Their number comes from the indices, which are as many: to divide by the size of four
/// bytes is a shift.
template <class Shape>
std::span<const Shape> shapes_of(const Group<Shape>& group) {
    return {group.shapes.data(), group.primitive.size()};
}

/// Whether boxes can be around shapes of this kind.
template <class Shape>
constexpr bool has_bounds() {
    constexpr bool is_given = requires(const Shape& shape) { bounds_of(shape); };
    static_assert(is_given || words<Shape>.is_endless,
                  "bounds_of is missing in this shape's contract; a shape without an end says in its words "
                  "that it is_endless (common/world/shapes.hpp)");
    return is_given && !words<Shape>.is_endless;
}

// Whichever accelerator it is: there is one search for each kind of shape, and not one for each pair of a
// kind and an accelerator.
template <class Any>
requires std::same_as<Any, Accelerator>
bool serves(const Any& any, const Ray& ray) {
    return std::visit([&](const auto& accelerator) { return serves(accelerator, ray); }, any);
}
template <class Any>
requires std::same_as<Any, Accelerator>
void search(const Any& any, const Ray& ray, Interval range, const Ask& ask) {
    std::visit([&](const auto& accelerator) { search(accelerator, ray, range, ask); }, any);
}

// What is asked of an accelerator is kept out of the functions that ask, which else would save registers for
// it always.
template <class Shape>
[[gnu::noinline]] std::optional<Hit> closest_by_accelerator(const Group<Shape>& group, const Ray& ray,
                                                            Interval range) {
    return closest_hit(group.accelerator, std::span<const Shape>(group.shapes), ray, range,
                       mailbox_of(group.mailbox));
}
template <class Shape>
[[gnu::noinline]] bool any_by_accelerator(const Group<Shape>& group, const Ray& ray, Interval range) {
    return any_hit(group.accelerator, std::span<const Shape>(group.shapes), ray, range,
                   mailbox_of(group.mailbox));
}

/// Nearest hit with the group's shapes; `Hit::primitive` is the index into the group.
template <class Shape>
std::optional<Hit> closest_in(const Group<Shape>& group, const Ray& ray, Interval range) {
    if (has_accelerator(group)) return closest_by_accelerator(group, ray, range);
    return closest_hit(shapes_of(group), ray, range);
}

/// Whether any of the group's shapes is hit.
template <class Shape>
bool any_in(const Group<Shape>& group, const Ray& ray, Interval range) {
    if (has_accelerator(group)) return any_by_accelerator(group, ray, range);
    return any_hit(shapes_of(group), ray, range);
}

/// Appends a hit for each of the group's shapes that is hit, its nearest in the range, which should be short;
/// `Hit::primitive` is the index into the group.
template <class Shape>
void append_in(const Group<Shape>& group, const Ray& ray, Interval range, std::vector<Hit>& hits) {
    append_hits(group.accelerator, shapes_of(group), ray, range, mailbox_of(group.mailbox), hits);
}

// Texture coordinates: `has_uv` says whether a shape has any, `uv_at` what they are at a point of its
// surface.

template <class Shape>
constexpr bool has_uv = requires(const Shape& shape) {
    texture_point(shape, Vec3(), std::uint32_t());
};
template <class Shape>
constexpr bool has_uv<Placed<Shape>> = has_uv<Shape>;
template <>
inline constexpr bool has_uv<Triangle> = true;  // those of its corners
template <>
inline constexpr bool has_uv<MeshUse> = true;
template <>
inline constexpr bool has_uv<Combination> = true;  // those of its parts

template <class Shape>
Vec2 uv_at(const Shape& shape, const Vec3& point, std::uint32_t element) {
    if constexpr (requires { texture_uv(shape, point, element); })
        return texture_uv(shape, point, element);
    else
        return texture_point(shape, point, element).uv;
}
template <class Shape>
Vec2 uv_at(const Placed<Shape>& placed, const Vec3& point, std::uint32_t element) {
    return uv_at(placed.shape, transform_point(placed.transform.to_local, point), element);
}

// Sets the surface's uv at an element of a shape that has any.
template <class Shape>
void set_uv(const Shape& shape, std::uint32_t element, Surface& surface) {
    surface.uv = uv_at(shape, surface.point, element);
}
/// The weights of a mesh's triangle are the hit's, and chapter 4 has looked at them.
inline void set_uv(const Instance&, std::uint32_t, Surface&) {}
inline void set_uv(const Combination& tree, std::uint32_t element, Surface& surface) {
    const PartHit hit = part_hit(tree, element);
    std::visit([&](const auto& solid) { set_uv(solid, hit.element, surface); }, hit.part.solid);
}

/// The surface at a hit with the group's shape `index`, with what the group keeps beside the shapes.
template <class Shape>
Surface surface_in(const World& world, const Group<Shape>& group, std::uint32_t index, const Ray& ray,
                   const Hit& hit) {
    const Shape& shape = group.shapes[index];
    Surface surface = surface_at(shape, ray, hit);
    if constexpr (has_uv<Shape>)
        if (world.needs.uvs) set_uv(shape, hit.element, surface);
    return surface;
}
inline Surface surface_in(const World&, const Group<Triangle>& group, std::uint32_t index, const Ray& ray,
                          const Hit& hit) {
    Surface surface = surface_at(group.shapes[index], ray, hit);
    if (!group.normals.empty())
        surface.shading_normal = interpolate(group.normals[index], hit.uv, surface.normal);
    if (!group.uvs.empty()) surface.uv = interpolate(group.uvs[index], hit.uv);
    return surface;
}

inline Surface surface_in(const World& world, const Group<Moving>& group, std::uint32_t index, const Ray& ray,
                          const Hit& hit) {
    return surface_at(group.shapes[index], ray, hit, world.needs.uvs);
}

inline Surface surface_in(const World& world, const Group<Turning>& group, std::uint32_t index,
                          const Ray& ray, const Hit& hit) {
    return surface_at(group.shapes[index], ray, hit, world.needs.uvs);
}

/// The group of a world that has no other; it must be of this shape. It holds all the primitives in the order
/// of the file, so that an index into the group is one into world.primitives.
template <class Shape>
const Group<Shape>& only_group(const World& world) {
    const auto* group = std::get_if<Group<Shape>>(&world.groups.front());
    // Whoever calls this for Shape has looked, once a picture, so that no ray has to.
    if (!group) __builtin_unreachable();
    return *group;
}

}  // namespace rt
