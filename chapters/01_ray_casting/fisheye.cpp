// Another camera: the fisheye, which can see more than half of everything.
#include "chapters/01_ray_casting/fisheye.hpp"

#include "common/math/todo.hpp"

namespace rt {

Ray fisheye_ray(const View& view, Real x, Real y, Real field) {
    // 01.7  Return the ray from view.eye whose angle with −w grows evenly with the distance of the
    // point (x, y) from the middle of the picture: 0 there, field/2 at the middle of the top edge.
    return todo("01.7");
}

}  // namespace rt
