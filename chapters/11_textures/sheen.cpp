// Velvet: fibres that stand up, and shine at the horizon.
#include "chapters/11_textures/sheen.hpp"

#include "chapters/07_recursion/optics.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real velvet_density(Real sigma, const Vec3& h) {
    // 11.20  Return D, which is 0 where the facet lies flat.
    return todo("11.20");
}

Real cavity_g1(const Vec3& w, const Vec3& h) {
    // 11.20  Return the part of the facet that its partner does not hide from w.
    return todo("11.20");
}

Vec3 evaluate(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.20  Return the lobe of velvet, or 0 if one of the directions is not above the surface.
    return todo("11.20");
}

Real pdf(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.20  Return the density of directions that visible facets mirror to v; 0 as in evaluate.
    return todo("11.20");
}

std::optional<LobeSample> sample(const Velvet& velvet, const Vec3& to_viewer, const Vec3& random) {
    // 11.21  Draw a facet with the density D·cosθ, let random.z choose it or its partner as the
    // viewer sees them, and return the light that the chosen one mirrors there.
    return todo("11.21");
}

}  // namespace rt
