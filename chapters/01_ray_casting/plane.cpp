// The plane: where a ray meets it, and which of several planes it meets first.
// The lesson uses the same letters: n and q for the plane, o and d for the ray, t along it.
#include "chapters/01_ray_casting/plane.hpp"

#include "common/math/error.hpp"
#include "common/math/todo.hpp"

namespace rt {

std::optional<Hit> intersect(const Plane& plane, const Ray& ray, Interval range) {
    // 01.4  Return a Hit with the t at which the ray meets the plane, if that lies in the range,
    // and std::nullopt if it does not, or if the ray is parallel to the plane.
    return todo("01.4");
}

Surface surface_at(const Plane& plane, const Ray& ray, const Hit& hit) {
    const Vec3 n = glm::normalize(plane.normal);
    const Vec3 p = point_at(ray, hit.t);
    const Vec3 from_q = p - plane.point;
    const Vec3 point = p - glm::dot(n, from_q) * n;
    // The exact foot of p on the plane is p − (n · (p − q)) n. Roundings behind its computed coordinates: n
    // 5, p − q 1, the dot product 3, n again 5 and the product with it 1, all in terms no larger than |n| ·
    // |p − q| times |n|; and 1 in the last subtraction, of the size of the result. The next ray, which starts
    // here, finds its distance from the plane with 4 more of the first kind. One more each pays for this
    // bound's own roundings. Chapter 6 derives it.
    const Real sum = glm::dot(glm::abs(n), glm::abs(from_q));
    const Vec3 error = gamma(2) * glm::abs(point) + gamma(20) * sum * glm::abs(n);
    return Surface{.point = point, .error = error, .normal = n, .shading_normal = n};
}

std::optional<Hit> closest_hit(std::span<const Plane> planes, const Ray& ray, Interval range) {
    // 01.5  Return the hit with the smallest t of all in the range, and the index of its plane in
    // Hit::primitive. At equal t the plane that comes first in `planes` wins.
    return todo("01.5");
}

}  // namespace rt
