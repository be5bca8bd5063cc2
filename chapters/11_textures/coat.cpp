// Paint under a smooth clear coat: part of the light is mirrored, the rest goes through twice.
#include "chapters/11_textures/coat.hpp"

#include "chapters/07_recursion/optics.hpp"
#include "chapters/11_textures/matte.hpp"

#include "common/math/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// T: the part of light that passes the coat, from a direction with this cosine. Given.
[[maybe_unused]] Real passed(const Coated& coated, Real cosine) {
    return 1 - fresnel(std::min(cosine, Real(1)), 1 / coated.ior);
}

}  // namespace

Real mean_fresnel(Real ior) {
    const Real n = ior;
    // Where n is nearly 1 the terms below cancel; the mean is (n − 1)/3 then.
    if (n < 1.0001) return std::max(n - 1, Real(0)) / 3;
    const Real square = n * n, fourth = square * square, sum = square + 1, less = (n - 1) * (n + 1);
    return Real(0.5) + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           square * less * less / (sum * sum * sum) * std::log((n - 1) / (n + 1)) -
           2 * n * square * (square + 2 * n - 1) / (sum * sum * less) +
           8 * fourth * (fourth + 1) / (sum * (sum * less) * (sum * less)) * std::log(n);
}

Real inner_reflectance(Real ior) {
    // 11.22  Return the part of even light inside that does not get out. By which paths did it get
    // in?
    return todo("11.22");
}

Vec3 evaluate(const Coated& coated, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.22  Return what passes inwards, meets the ground once or more often, with the coat in
    // between, and passes outwards.
    return todo("11.22");
}

Real pdf(const Coated& coated, const Vec3& to_light, const Vec3& to_viewer) {
    // 11.22  Return the density of the directions that sample draws for the ground.
    return todo("11.22");
}

std::optional<LobeSample> sample(const Coated& coated, const Vec3& to_viewer, const Vec3& random) {
    // 11.22  Return a sample of the mirror or of the ground, as random.z decides.
    return todo("11.22");
}

}  // namespace rt
