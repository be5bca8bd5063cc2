// Which transparent objects the eye is inside of.
#include "common/render/eye_inside.hpp"

#include "common/world/query.hpp"

#include <algorithm>

namespace rt {

namespace {

/// Corrects what the line says of planes: inside is the side that the normal points away from, also where no
/// line out of it crosses the plane. Those are left last.
void decide_planes(const World& world, std::vector<Medium>& inside) {
    for (const Primitive& primitive : world.primitives) {
        const auto* planes = std::get_if<Group<Plane>>(&world.groups[primitive.group]);
        if (!planes || world.materials[primitive.material].transmission == Vec3(0)) continue;
        const Plane& plane = planes->shapes[primitive.index];
        const bool behind = glm::dot(plane.normal, world.view.eye - plane.point) < 0;
        const auto same =
            std::ranges::find(inside, primitive.object, [](const Medium& m) { return m.object; });
        if (behind && same == inside.end()) inside.push_back({primitive.object, primitive.material});
        if (!behind && same != inside.end()) inside.erase(same);
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
        const auto same = std::find_if(inside.begin(), inside.end(),
                                       [&](const Medium& m) { return m.object == primitive.object; });
        // Crossed twice: the line entered and left again, so the eye is outside.
        if (same == inside.end())
            inside.push_back({primitive.object, primitive.material});
        else
            inside.erase(same);
    }
    decide_planes(world, inside);
    std::reverse(inside.begin(), inside.end());
    return inside;
}

}  // namespace rt
