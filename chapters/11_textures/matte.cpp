// Matte surfaces: Lambert's, and rough ones, which look flatter.
#include "chapters/11_textures/matte.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec3 evaluate(const Matte& matte, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.13  Fujii's lobe, or 0 if one of the directions is not above the surface. s is the dot
    // product of the parts of l and v along the surface; t is s, divided by the greater cosine if s > 0.
    return todo("11.13");
}

Real oren_nayar_1994(Real sigma, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.13  The model of 1994. It needs no angles: what is sin α · tan β · cos Δφ in terms of s?
    return todo("11.13");
}

Vec3 cosine_direction(Real a, Real b) {
    // 11.13  The point of the disc, and above it z: what is left of 1 when x² + y² = a is taken
    // away.
    return todo("11.13");
}

Real pdf(const Matte&, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.13  The density of cosine_direction, where both directions are above the surface.
    return todo("11.13");
}

std::optional<LobeSample> sample(const Matte& matte, const Vec3& to_viewer, const Vec3& random) {
    // 11.13  A direction and its density. In the weight the cosine cancels: f·cos/(cos/π).
    return todo("11.13");
}

}  // namespace rt
