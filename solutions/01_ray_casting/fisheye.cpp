// Another camera: the fisheye, which can see more than half of everything.
#include "chapters/01_ray_casting/fisheye.hpp"

namespace rt {

Ray fisheye_ray(const View& view, Real x, Real y, Real field) {
    // [exercise 01.7] Return the ray from view.eye whose angle with −w grows evenly with the distance of the
    // point (x, y) from the middle of the picture: 0 there, field/2 at the middle of the top edge.
    const auto& [u, v, w] = view.frame;
    const Real a = (2 * x - view.width) / view.height;
    const Real b = (view.height - 2 * y) / view.height;
    const Real rho = std::hypot(a, b);
    if (rho == 0) return Ray{view.eye, -w};
    const Real angle = rho * field / 2;
    return Ray{view.eye, std::sin(angle) * (a / rho * u + b / rho * v) - std::cos(angle) * w};
    // [/exercise]
}

}  // namespace rt
