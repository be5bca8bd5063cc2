// One section a shape, and the functions that ask for one at the end.
#include "common/povray/area_lights.hpp"

#include <algorithm>

namespace rt::povray {
namespace {

/// Beyond this, light fades by 1/d².
constexpr Real near = 1e-6;

Real farthest(const Vec3& from, std::initializer_list<Vec3> points) {
    Real distance = 0;
    for (const Vec3& p : points) distance = std::max(distance, glm::length(p - from));
    return distance;
}

// A texture is on the side to which POV-Ray's normal points, and that of a triangle points to where its
// corners run clockwise: they are written the other way about.

// Parallelogram ---------------------------------------------------------------------------------------------

std::string statement_of(const QuadLight& quad) {
    return fmt::format("polygon {{ 5, {0}, {1}, {2}, {3}, {0}", triple(quad.corner),
                       triple(quad.corner + quad.ac), triple(quad.corner + quad.ab + quad.ac),
                       triple(quad.corner + quad.ab));
}

Real reach(const QuadLight& quad, const Vec3& from) {
    return farthest(
        from, {quad.corner, quad.corner + quad.ab, quad.corner + quad.ac, quad.corner + quad.ab + quad.ac});
}

Real length_of(const QuadLight& quad) { return std::max(glm::length(quad.ab), glm::length(quad.ac)); }

void multiply(QuadLight& quad, Real factor) { quad.corner *= factor, quad.ab *= factor, quad.ac *= factor; }

// Disc ------------------------------------------------------------------------------------------------------

std::string statement_of(const DiscLight& disc) {
    return fmt::format("disc {{ {}, {}, {}", triple(disc.center), triple(unit_along(disc.normal)),
                       number(disc.radius));
}

Real reach(const DiscLight& disc, const Vec3& from) { return glm::length(disc.center - from) + disc.radius; }

Real length_of(const DiscLight& disc) { return 2 * disc.radius; }

void multiply(DiscLight& disc, Real factor) { disc.center *= factor, disc.radius *= factor; }

// Sphere ----------------------------------------------------------------------------------------------------

std::string statement_of(const SphereLight& sphere) {
    return fmt::format("sphere {{ {}, {}", triple(sphere.center), number(sphere.radius));
}

Real reach(const SphereLight& sphere, const Vec3& from) {
    return glm::length(sphere.center - from) + sphere.radius;
}

Real length_of(const SphereLight& sphere) { return sphere.radius; }

void multiply(SphereLight& sphere, Real factor) { sphere.center *= factor, sphere.radius *= factor; }

// Triangle --------------------------------------------------------------------------------------------------

std::string statement_of(const TriangleLight& triangle) {
    return fmt::format("triangle {{ {}, {}, {}", triple(triangle.a), triple(triangle.c), triple(triangle.b));
}

Real reach(const TriangleLight& triangle, const Vec3& from) {
    return farthest(from, {triangle.a, triangle.b, triangle.c});
}

Real length_of(const TriangleLight& triangle) {
    return std::max(glm::length(triangle.b - triangle.a), glm::length(triangle.c - triangle.a));
}

void multiply(TriangleLight& triangle, Real factor) {
    triangle.a *= factor, triangle.b *= factor, triangle.c *= factor;
}

}  // namespace

void write_facing_lights(Writer& out) {
    // A power of the cosine, 1, within 90 degrees; where it fades by 2/(1 + (d/near)²).
    const Real strength = out.factor * out.factor / (2 * near * near);
    for (const FacingLight& light : out.snapshot.lights) {
        if (light.color == Vec3(0)) continue;
        const Vec3 point = out.factor * light.point;
        out.line(
            "light_source {{ {} {} spotlight point_at {} radius 90 falloff 90 tightness 1 fade_distance {} "
            "fade_power 2 }}",
            triple(point), rgb(strength * light.color), triple(point + light.normal), number(near));
    }
}

std::string open_statement(const AreaLight& light) {
    return std::visit([](const auto& shape) { return statement_of(shape); }, light.shape);
}

Real reach_of(const AreaLight& light, const Vec3& from) {
    return std::visit([&](const auto& shape) { return reach(shape, from); }, light.shape);
}

Real least_length_of(const AreaLight& light) {
    return std::visit([](const auto& shape) { return length_of(shape); }, light.shape);
}

void scale(AreaLight& light, Real factor) {
    std::visit([&](auto& shape) { multiply(shape, factor); }, light.shape);
}

}  // namespace rt::povray
