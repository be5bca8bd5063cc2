// The lens: what two balls have in common.
#include "chapters/02_spheres/lens.hpp"

namespace rt {

std::optional<Hit> intersect_lens(const Sphere& a, const Sphere& b, const Ray& ray, Interval range) {
    // [exercise 02.6] Return the nearest hit in the range with the surface of what the two balls have in
    // common, and in its `primitive` which of them it belongs to; std::nullopt if there is none.
    const Roots through_a = intersections(a, ray), through_b = intersections(b, ray);
    if (through_a.count == 0 || through_b.count == 0) return std::nullopt;
    // The line is inside of both from where it enters the later ball to where it leaves the earlier one.
    const Hit in = through_a.t0 >= through_b.t0 ? Hit{.t = through_a.t0, .primitive = 0}
                                                : Hit{.t = through_b.t0, .primitive = 1};
    const Hit out = through_a.t1 <= through_b.t1 ? Hit{.t = through_a.t1, .primitive = 0}
                                                 : Hit{.t = through_b.t1, .primitive = 1};
    if (in.t > out.t) return std::nullopt;
    if (contains(range, in.t)) return in;
    if (contains(range, out.t)) return out;
    return std::nullopt;
    // [/exercise]
}

}  // namespace rt
