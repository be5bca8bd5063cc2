// Where what a ray has met lies on a texture, and how it runs there.
#include "common/render/texture_places.hpp"

#include "common/render/combinations.hpp"
#include "common/render/groups.hpp"

namespace rt {
namespace {

TexturePoint placed(const Transform& transform, TexturePoint local) {
    local.du = transform_vector(transform.to_world, local.du);
    local.dv = transform_vector(transform.to_world, local.dv);
    return local;
}

TexturePoint on_triangle(const Group<Triangle>& group, std::uint32_t index, const Hit& hit) {
    if (group.uvs.empty()) return {};
    return texture_point(group.shapes[index], group.uvs[index], hit.uv);
}

// At the hit of a shape; `point` is where the surface is, in world space.

template <class Shape>
TexturePoint on_shape(const Shape& shape, const Vec3& point, const Hit& hit) {
    if constexpr (requires { texture_point(shape, point, hit.element); })
        return texture_point(shape, point, hit.element);
    else
        return {};
}
template <class Shape>
TexturePoint on_shape(const Placed<Shape>& shape, const Vec3& point, const Hit& hit) {
    return placed(shape.transform,
                  on_shape(shape.shape, transform_point(shape.transform.to_local, point), hit));
}
TexturePoint on_shape(const Instance& instance, const Vec3&, const Hit& hit) {
    return placed(instance.transform, on_triangle(instance.shape.mesh->triangles, hit.element, hit));
}
TexturePoint on_shape(const Combination& tree, const Vec3& point, const Hit& hit) {
    const PartHit of = part_hit(tree, hit.element);
    Hit own = hit;
    own.element = of.element;
    return std::visit([&](const auto& solid) { return on_shape(solid, point, own); }, of.part.solid);
}

}  // namespace

TexturePoint texture_point_at(const World& world, const Ray& ray, const Hit& hit, const Surface& surface) {
    const Primitive& primitive = world.primitives[hit.primitive];
    return std::visit(
        [&]<class Shape>(const Group<Shape>& group) {
            if constexpr (std::is_same_v<Shape, Triangle>) {
                return on_triangle(group, primitive.index, hit);
            } else if constexpr (std::is_same_v<Shape, Moving>) {
                const Moving& moving = group.shapes[primitive.index];
                const Vec3 point = surface.point - ray.time * moving.motion;
                return std::visit([&](const auto& shape) { return on_shape(shape, point, hit); },
                                  moving.shape);
            } else if constexpr (std::is_same_v<Shape, Turning>) {
                const Turning& turning = group.shapes[primitive.index];
                const Vec3 point = seen_by(turning, {surface.point, ray.direction, ray.time}).origin;
                TexturePoint place =
                    std::visit([&](const auto& shape) { return on_shape(shape, point, hit); }, turning.shape);
                place.du = turned(turning, place.du, ray.time),
                place.dv = turned(turning, place.dv, ray.time);
                return place;
            } else {
                return on_shape(group.shapes[primitive.index], surface.point, hit);
            }
        },
        world.groups[primitive.group]);
}

}  // namespace rt
