// Velvet: fibres that stand up, and shine at the horizon.
#include "chapters/11_textures/sheen.hpp"

#include "chapters/07_recursion/optics.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real velvet_density(Real sigma, const Vec3& h) {
    // 11.16  D. Near the z axis the exponential is 0 long before sin⁴θ is: that is asked first.
    return todo("11.16");
}

Real cavity_g1(const Vec3& w, const Vec3& h) {
    // 11.16  The part of the facet that its partner leaves to w.
    return todo("11.16");
}

Vec3 evaluate(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.16  color·D·G/(4·l.z·v.z), with the facet's normal halfway between l and v.
    return todo("11.16");
}

Real pdf(const Velvet& velvet, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.16  The density of directions that visible facets mirror to v.
    return todo("11.16");
}

std::optional<LobeSample> sample(const Velvet& velvet, const Vec3& to_viewer, const Vec3& random) {
    // 11.16  A facet with the density D·cosθ: cot²θ is −σ²·ln(1 − random.x). Then it or its
    // partner, as random.z decides, and the light that it mirrors to v.
    return todo("11.16");
}

}  // namespace rt
