// POV-Ray's lights fade by one power of the distance; ours are put together from them.
#include "common/povray/lights.hpp"

#include "common/povray/area_lights.hpp"
#include "common/povray/refuse.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace rt::povray {
namespace {

/// Where lights that shine in parallel stand; only their direction matters.
constexpr Real far_away = 1e5;

/// Nothing behind such a light is lit. So where the eye is far from the origin, the light goes with it.
void write_parallel_light(Writer& out, const Vec3& direction, const Vec3& color, std::string_view more = "") {
    const Vec3& eye = out.scene.camera.eye;
    const bool is_far = glm::length(eye) > far_away / 10;
    out.line("light_source {{ {} {} parallel point_at {}{} }}",
             triple(far_away * direction + (is_far ? eye : Vec3(0))), rgb(color), is_far ? triple(eye) : "0",
             more);
}

/// A light that POV-Ray divides by (1 + (d / fade_distance)^power) / 2 at distance d.
void write_fading_light(Writer& out, const PointLight& light, Real factor, Real fade_distance, int power) {
    out.line("light_source {{ {} {} fade_distance {} fade_power {} }}", triple(light.position),
             rgb(light.color * factor), number(fade_distance), power);
}

/// 1/(c + l·d + q·d²) in terms of 2/(1 + (d/f)^p): one light where two of the terms suffice. With all
/// three, partial fractions give 1/(q·(r2 − r1)) · (1/(d + r1) − 1/(d + r2)) with −r1, −r2 the roots of
/// the quadratic in d: two lights, the second with negative colour.
void write_light(Writer& out, const PointLight& light, std::size_t index) {
    const Real c = light.attenuation.x, l = light.attenuation.y, q = light.attenuation.z;
    // Stands for distance 0, where a light without a constant term is infinitely bright.
    const Real near = 1e-6;
    if (l == 0 && q == 0) {
        out.line("light_source {{ {} {} }}", triple(light.position), rgb(light.color / c));
    } else if (q == 0) {
        const Real f = c > 0 ? c / l : near;
        write_fading_light(out, light, 1 / (2 * l * f), f, 1);
    } else if (l == 0) {
        const Real f = c > 0 ? std::sqrt(c / q) : near;
        write_fading_light(out, light, 1 / (2 * q * f * f), f, 2);
    } else {
        const Real discriminant = l * l - 4 * c * q;
        // Where the roots are closer than this, the difference of two single-precision colours is
        // less exact than a 16-bit step.
        if (!(discriminant > 1e-4 * l * l))
            refuse(out.scene, fmt::format("light {} has attenuation {} {} {}, and only quadratics with two "
                                          "real roots (l*l > 4*c*q) can be put together from its lights",
                                          index + 1, number(c), number(l), number(q)));
        const Real far_root = (l + std::sqrt(discriminant)) / (2 * q);
        const Real near_root = std::max(c / (q * far_root), near);
        const Real k = 1 / (q * (far_root - near_root));
        write_fading_light(out, light, k / (2 * near_root), near_root, 1);
        write_fading_light(out, light, -k / (2 * far_root), far_root, 1);
    }
}

void write_light(Writer& out, const DirectionalLight& light, std::size_t) {
    write_parallel_light(out, unit_along(light.direction), light.color);
}

}  // namespace

void write_lights(Writer& out) {
    for (std::size_t i = 0; i < out.scene.lights.size(); ++i)
        std::visit([&](const auto& light) { write_light(out, light, i); }, out.scene.lights[i]);
    write_facing_lights(out);
}

void write_normal_lights(Writer& out, Real sign) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real side : {1., -1.}) {
            Vec3 direction(0), color(0);
            direction[axis] = side;
            color[axis] = sign * side / 2;
            write_parallel_light(out, direction, color, " shadowless");
        }
    }
}

}  // namespace rt::povray
