// Matte surfaces: Lambert's, and rough ones, which look flatter.
#include "chapters/11_textures/matte.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec3 evaluate(const Matte& matte, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.15  Return Fujii's lobe, or 0 if one of the directions is not above the surface.
    return todo("11.15");
}

Real oren_nayar_1994(Real sigma, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.15  Return the lobe of 1994. It needs no angles: what is sin α · tan β · cos Δφ in terms
    // of s?
    return todo("11.15");
}

Vec3 cosine_direction(Real a, Real b) {
    // 11.15  Lift a point of the unit disc onto the hemisphere.
    return todo("11.15");
}

Real pdf(const Matte&, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.15  The density of cosine_direction, where both directions are above the surface.
    return todo("11.15");
}

std::optional<LobeSample> sample(const Matte& matte, const Vec3& to_viewer, const Vec3& random) {
    // 11.15  Return a direction, how much light from there counts, and the density. Which factors
    // of the weight cancel?
    return todo("11.15");
}

}  // namespace rt
