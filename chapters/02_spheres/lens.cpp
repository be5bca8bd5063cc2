// The lens: what two balls have in common.
#include "chapters/02_spheres/lens.hpp"

#include "common/math/todo.hpp"

namespace rt {

std::optional<Hit> intersect_lens(const Sphere& a, const Sphere& b, const Ray& ray, Interval range) {
    // 02.6  Return the nearest hit in the range with the surface of what the two balls have in
    // common, and in its `primitive` which of them it belongs to; std::nullopt if there is none.
    return todo("02.6");
}

}  // namespace rt
