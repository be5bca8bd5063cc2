// Solids with flat faces, as many as one likes.
#include "chapters/10_surfaces/gem.hpp"

namespace rt {

std::optional<Span> inside_gem(std::span<const Plane> planes, const Ray& ray) {
    // [exercise 10.16] Return the part of the line that is behind all of the planes, or nothing. The faces
    // are the planes' numbers.
    std::optional<Span> gem = Span{};
    for (std::uint32_t i = 0; i < planes.size() && gem; ++i) {
        const Plane& plane = planes[i];
        const Real height = dot(plane.normal, ray.origin - plane.point);
        const Real climb = dot(plane.normal, ray.direction);
        Span behind;
        if (climb < 0) behind.enter = -height / climb, behind.enter_face = i;
        if (climb > 0) behind.leave = -height / climb, behind.leave_face = i;
        if (climb == 0 && height > 0) return std::nullopt;
        gem = common_part(*gem, behind);
    }
    return gem;
    // [/exercise]
}

}  // namespace rt
