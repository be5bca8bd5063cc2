// Optics of a smooth surface: where light goes, and how much of it.
#include "chapters/07_recursion/optics.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// cosₜ² by Snell's law, negative where reflection is total.
[[maybe_unused]] Real refracted_cosine_squared(Real cos_i, Real eta) {
    // 07.2  Return cosₜ² by the one of the lesson's two forms in which nothing cancels.
    return todo("07.2");
}

}  // namespace

Vec3 reflect(const Vec3& d, const Vec3& n) {
    // 07.1  Return the direction in which d goes on from a mirror with the normal n.
    return todo("07.1");
}

std::optional<Vec3> refract(const Vec3& d, const Vec3& n, Real eta) {
    // 07.2  Return the refracted direction, a unit vector, or nothing where reflection is total.
    // The function above gives cosₜ². No NaN may appear on the way.
    return todo("07.2");
}

Real fresnel(Real cos_i, Real eta) {
    // 07.3  Return the part of unpolarised light that is mirrored, by Fresnel's formulas: 1 where
    // reflection is total, and where the ray grazes.
    return todo("07.3");
}

Real schlick(Real cos_i, Real eta) {
    // 07.3  Return the same by Schlick's approximation, with the cosine on the side of the
    // lower index: 1 where reflection is total.
    return todo("07.3");
}

Vec3 transmitted(const Vec3& absorption, Real distance) {
    // 07.4  Return what is left in each channel. The distance may be infinite: even then all is
    // left in a channel without absorption.
    return todo("07.4");
}

Vec3 soap_film(Real cos_i, Real ior, Real thickness) {
    // 07.7  Return, for each of the three `wavelengths`, the part of unpolarised light that comes
    // back when all the waves that do are added up: the mean of both polarisations.
    return todo("07.7");
}

}  // namespace rt
