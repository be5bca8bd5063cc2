// The part of a line that is in a box, counted from near: given.
#include "chapters/10_surfaces/chord.hpp"

#include <algorithm>

namespace rt {

std::optional<Chord> chord(const Box& box, const Ray& ray, Interval part) {
    const std::optional<Span> span = inside(box, ray);
    return span ? chord(*span, ray, part) : std::nullopt;
}

std::optional<Chord> chord(const Span& in_box, const Ray& ray, Interval part) {
    const Real enter = std::max(in_box.enter, part.min), leave = std::min(in_box.leave, part.max);
    if (!(enter < leave)) return std::nullopt;
    const Real length = leave - enter;
    return Chord{ray.origin + enter * ray.direction, length * ray.direction, enter, length};
}

Vec3 point_in(const Box& box, const Ray& ray, Real t) {
    const std::optional<Chord> part = chord(box, ray, {0, infinity});
    const bool is_on_it = part && part->from <= t && t <= part->from + part->length;
    return is_on_it ? part->at((t - part->from) / part->length) : point_at(ray, t);
}

}  // namespace rt
