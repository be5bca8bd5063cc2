// Which transparent objects the eye is inside of.
#include "common/render/eye_inside.hpp"

#include "common/render/groups.hpp"

#include <algorithm>

namespace rt {

namespace {

/// Inside is the side that the normal points away from.
bool contains(const Plane& plane, const Vec3& point) {
    return glm::dot(plane.normal, point - plane.point) < 0;
}

template <class Shape>
bool contains(const Placed<Shape>& placed, const Vec3& point) {
    return contains(placed.shape, transform_point(placed.transform.to_local, point));
}

/// Corrects what the line says of shapes without an end: a line out of one need not cross its surface. Those
/// are left last.
void decide_endless(const World& world, std::vector<Medium>& inside) {
    for (const Primitive& primitive : world.primitives) {
        if (world.materials[primitive.material].transmission == Vec3(0)) continue;
        const auto decide = [&]<class Shape>(const Group<Shape>& group) {
            if constexpr (words<Shape>.is_endless) {
                const bool is_inside = contains(group.shapes[primitive.index], world.view.eye);
                const auto same = std::ranges::find(inside, primitive.object, &Medium::object);
                if (is_inside && same == inside.end())
                    inside.push_back({primitive.object, primitive.material});
                if (!is_inside && same != inside.end()) inside.erase(same);
            }
        };
        std::visit(decide, world.groups[primitive.group]);
    }
}

}  // namespace

std::vector<Medium> objects_around_eye(const World& world) {
    // A direction in general position, so that the line does not run along edges of things that are
    // aligned with the axes.
    const Ray ray{world.view.eye, glm::normalize(Vec3(0.41, 0.83, 0.37))};
    std::vector<Medium> inside;  // in the order of leaving, so innermost first
    for (std::optional<Hit> hit = closest_hit(world, ray, {}); hit; hit = next_hit(world, ray, *hit, {})) {
        const Primitive& primitive = world.primitives[hit->primitive];
        if (world.materials[primitive.material].transmission == Vec3(0)) continue;
        const auto same = std::ranges::find(inside, primitive.object, &Medium::object);
        // Crossed twice: the line entered and left again, so the eye is outside.
        if (same == inside.end())
            inside.push_back({primitive.object, primitive.material});
        else
            inside.erase(same);
    }
    decide_endless(world, inside);
    std::reverse(inside.begin(), inside.end());
    return inside;
}

}  // namespace rt
