// Optics of a smooth surface: where light goes, and how much of it.
#include "chapters/07_recursion/optics.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// cosₜ² by Snell's law, negative where reflection is total.
[[maybe_unused]] Real refracted_cosine_squared(Real cos_i, Real eta) {
    // [exercise 07.2] Return cosₜ² by the one of the lesson's two forms in which nothing cancels.
    return (1 - eta) * (1 + eta) + (eta * cos_i) * (eta * cos_i);
    // [/exercise]
}

}  // namespace

Vec3 reflect(const Vec3& d, const Vec3& n) {
    // [exercise 07.1] Return the direction in which d goes on from a mirror with the normal n.
    return d - 2 * dot(d, n) * n;
    // [/exercise]
}

std::optional<Vec3> refract(const Vec3& d, const Vec3& n, Real eta) {
    // [exercise 07.2] Return the refracted direction, a unit vector, or nothing where reflection is total.
    // The function above gives cosₜ². No NaN may appear on the way.
    const Real cos_i = -dot(d, n);
    const Real cos_t_squared = refracted_cosine_squared(cos_i, eta);
    // Written so that a NaN, which is not less than 0 either, takes this way out too.
    if (!(cos_t_squared >= 0)) return std::nullopt;
    return normalize(eta * d + (eta * cos_i - std::sqrt(cos_t_squared)) * n);
    // [/exercise]
}

Real fresnel(Real cos_i, Real eta) {
    // [exercise 07.3] Return the part of unpolarised light that is mirrored, by Fresnel's formulas: 1 where
    // reflection is total, and where the ray grazes.
    const Real cos_t_squared = refracted_cosine_squared(cos_i, eta);
    if (!(cos_i > 0) || !(cos_t_squared > 0)) return 1;
    const Real cos_t = std::sqrt(cos_t_squared);
    const auto amplitude = [](Real a, Real b) { return 1 - 2 * std::min(a, b) / (a + b); };
    const Real parallel = amplitude(cos_i, eta * cos_t);
    const Real perpendicular = amplitude(eta * cos_i, cos_t);
    return (parallel * parallel + perpendicular * perpendicular) / 2;
    // [/exercise]
}

Real schlick(Real cos_i, Real eta) {
    // [exercise 07.3] Return the same by Schlick's approximation, with the cosine on the side of the
    // lower index: 1 where reflection is total.
    const Real root = (1 - eta) / (1 + eta);
    const Real f0 = root * root;
    Real cosine = cos_i;
    if (eta > 1) {
        const Real cos_t_squared = refracted_cosine_squared(cos_i, eta);
        if (!(cos_t_squared > 0)) return 1;
        cosine = std::sqrt(cos_t_squared);
    }
    // A cosine may be 1 + u by rounding, and an odd power keeps the sign.
    const Real m = std::max(1 - cosine, Real(0));
    return f0 + (1 - f0) * m * m * m * m * m;
    // [/exercise]
}

Vec3 transmitted(const Vec3& absorption, Real distance) {
    // [exercise 07.4] Return what is left in each channel. The distance may be infinite: even then all is
    // left in a channel without absorption.
    Vec3 left(1);
    for (int i = 0; i < 3; ++i)
        if (absorption[i] != 0) left[i] = std::exp(-absorption[i] * distance);
    return left;
    // [/exercise]
}

Vec3 soap_film(Real cos_i, Real ior, Real thickness) {
    // [exercise 07.7] Return, for each of the three `wavelengths`, the part of unpolarised light that comes
    // back when all the waves that do are added up: the mean of both polarisations.
    const Real eta = 1 / ior, cos_t = std::sqrt(refracted_cosine_squared(cos_i, eta));
    const Real along = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const Real across = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    Vec3 part(0);
    for (int i = 0; i < 3; ++i) {
        const Real sine = std::sin(2 * pi * ior * thickness * cos_t / wavelengths[i]);
        for (const Real rho : {along * along, across * across}) {
            const Real wave = 4 * rho * sine * sine;
            part[i] += wave / ((1 - rho) * (1 - rho) + wave) / 2;
        }
    }
    return part;
    // [/exercise]
}

}  // namespace rt
