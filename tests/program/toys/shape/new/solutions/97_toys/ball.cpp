// A toy shape: a sphere by another name.
#include "chapters/97_toys/ball.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/09_grids/bounds.hpp"

namespace rt {

namespace {

Sphere sphere_of(const Ball& ball) { return {ball.middle, ball.half_width}; }

}  // namespace

std::optional<Hit> intersect(const Ball& ball, const Ray& ray, Interval range) {
    // [exercise 97.1] Ask the sphere.
    return intersect(sphere_of(ball), ray, range);
    // [/exercise]
}

Surface surface_at(const Ball& ball, const Ray& ray, const Hit& hit) {
    // [exercise 97.1] Ask the sphere.
    return surface_at(sphere_of(ball), ray, hit);
    // [/exercise]
}

Bounds bounds_of(const Ball& ball) { return bounds_of(sphere_of(ball)); }

}  // namespace rt
