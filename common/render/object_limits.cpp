// What is refused because rounding would draw it wrong: objects out of the range of numbers.
#include "common/render/object_limits.hpp"

#include "chapters/04_transforms/transform.hpp"
#include "common/math/input_error.hpp"
#include "common/render/object_transforms.hpp"
#include "common/scene/parse.hpp"
#include "common/scene/range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rt {

void refuse(const Scene& scene, SourcePlace place, const std::string& what) {
    throw InputError(at_place(scene.file, place.line, place.column, what));
}

void ObjectLimits::check_place(const Vec3& p) const {
    if (!in_range(p))
        fail(fmt::format("coordinates beyond {}: a point of this object is at {} {} {}", largest_number, p.x,
                         p.y, p.z));
}

void ObjectLimits::check_size(const char* noun, Real size) const {
    if (!(size >= smallest_size && size <= largest_number))
        fail(fmt::format("{} from {} to {} can be drawn, but this is {}", noun, smallest_size, largest_number,
                         size));
}

void ObjectLimits::check_corners(std::span<const Vec3> corners) const {
    Vec3 low(infinity), high(-infinity);
    for (const Vec3& corner : corners) {
        check_place(corner);
        low = glm::min(low, corner), high = glm::max(high, corner);
    }
    if (low != high) check_size("faces", std::min(size_of(high - low), largest_number));
}

void ObjectLimits::check_ball(const Vec3& center, Real shortest, Real longest, Real flattening) const {
    const Camera& camera = scene.camera;
    if (camera.projection == Projection::Perspective) {
        const Real most = most_flattening * std::min(Real(1), camera.fovy);
        if (!(flattening <= 3 * most))
            fail(fmt::format("a ball that is flattened too much: by at most {:.2g} it can be drawn here",
                             most));
        return;
    }
    // What is smaller than a pixel shows nothing that could be wrong.
    const bool is_seen = longest * largest_side >= camera.view_height;
    const Real far = glm::length(center - camera.eye);
    if (is_seen && !(far <= most_flattening * shortest))
        fail(
            fmt::format("a ball whose shortest half-axis, {:.2g}, is less than 1/{} of its distance from "
                        "the eye; bring the eye of the parallel projection nearer",
                        shortest, most_flattening));
}

void ObjectLimits::check_ellipsoid(const Transform& map) const {
    Real there = 0, back = 0;
    for (int i = 0; i < 3; ++i) {
        there = std::max(there, size_of(Vec3(map.to_world[i])));
        back = std::max(back, size_of(Vec3(map.to_local[i])));
    }
    check_place(Vec3(map.to_world[3]));
    check_size("half-axes", there);
    check_size("half-axes", 1 / back);
    check_ball(Vec3(map.to_world[3]), 1 / back, there, flattening_of(map));
}

void ObjectLimits::check_instance(const Transform& map, const Sphere& bound) const {
    check_place(bound.center + bound.radius);
    check_place(bound.center - bound.radius);
    if (bound.radius > 0) check_size("meshes", bound.radius);
    Real reach = 0;
    for (int row = 0; row < 3; ++row)
        reach = std::max(reach,
                         glm::length(Vec3(map.to_world[0][row], map.to_world[1][row], map.to_world[2][row])));
    const Vec3 center = transform_point(map.to_world, bound.center);
    check_place(center + reach * bound.radius);
    check_place(center - reach * bound.radius);
}

}  // namespace rt
