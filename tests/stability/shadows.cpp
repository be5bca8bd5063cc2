// Families of extreme cases for chapter 6, and their judge.
#include "tests/stability/shadows.hpp"

#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/verdict.hpp"

#include <array>
#include <bit>
#include <cmath>

namespace rt::stability {
namespace {

using test::Random;

constexpr Real least_gap = 64;  ///< in units of the error bound along the normal

// --------------------------------------------------------------------------------------- asking a shape

MeshUse mesh_of(const Triangle& triangle) {
    SharedMesh mesh;
    mesh.triangles.shapes.push_back(triangle);
    const Vec3 center = (triangle.a + triangle.b + triangle.c) / Real(3);
    Real radius = 0;
    for (const Vec3& p : {triangle.a, triangle.b, triangle.c}) radius = std::max(radius, length(p - center));
    mesh.bound = {center, radius * (1 + 0x1p-20)};
    return {std::make_shared<const SharedMesh>(std::move(mesh))};
}

template <class Shape>
std::optional<Hit> hit_of(const Shape& shape, const Ray& ray, Interval range) {
    return intersect(shape, ray, range);
}
std::optional<Hit> hit_of(const PlacedTriangle& placed, const Ray& ray, Interval range) {
    return intersect(Instance{placed.transform, mesh_of(placed.triangle)}, ray, range);
}

template <class Shape>
Surface surface_of(const Shape& shape, const Ray& ray, const Hit& hit) {
    return surface_at(shape, ray, hit);
}
Surface surface_of(const PlacedTriangle& placed, const Ray& ray, const Hit& hit) {
    return surface_at(Instance{placed.transform, mesh_of(placed.triangle)}, ray, hit);
}

template <class Variant>
bool meets(const Variant& shape, const ShadowRay& shadow) {
    return std::visit([&](const auto& s) { return hit_of(s, shadow.ray, shadow.range).has_value(); }, shape);
}

// ------------------------------------------------------------------------------------- light and occluder

Vec3 perpendicular_to(const Vec3& n, Random& random) {
    for (;;) {
        const Vec3 v = cross(n, random.direction());
        if (length(v) > 0.1) return normalize(v);
    }
}

/// A light in front of the surface where the ray meets the shape, and an occluder before it. `solid`: the
/// light is outside.
template <class Shape>
std::optional<ShadowCase> lit(Random& random, const Shape& shape, const Ray& view, Real scale, bool solid) {
    const std::optional<Hit> hit = hit_of(shape, view, Interval{});
    if (!hit) return std::nullopt;
    ShadowCase made{.shape = shape, .surface = surface_of(shape, view, *hit), .light = {}, .occluder = {}};
    const Vec3& p = made.surface.point;
    const Vec3 n = !solid && random.index(2) == 0 ? -made.surface.normal : made.surface.normal;
    const Vec3 across = perpendicular_to(n, random);
    const Real cosine = random.magnitude(-6, 0);
    made.light.direction = normalize(cosine * n + std::sqrt(1 - cosine * cosine) * across);

    const Real bound = dot(glm::abs(n), made.surface.error);
    made.gap = least_gap * bound * random.uniform(1, 4);
    if (random.index(2) == 0) made.gap = std::max(made.gap, 4e-5 * scale);
    const Real way = made.gap / cosine;
    made.light.distance = way * random.magnitude(0.2, 6);
    made.light.color = Vec3(1);

    const Vec3 q = p + made.gap * n;
    if (random.index(2) == 0) {
        made.occluder = Plane{q, n};
    } else {
        const Vec3 up = cross(n, across);
        const Real size = 4 * way;
        made.occluder = Triangle{q + 2 * size * across, q - size * across + 2 * size * up,
                                 q - size * across - 2 * size * up};
    }
    return made;
}

// ---------------------------------------------------------------------------------------------- families

Real some_scale(Random& random) { return random.magnitude(-6, 6); }
Vec3 some_place(Random& random) { return random.magnitude(-3, 7) * random.direction(); }

Ray towards(const Vec3& from, const Vec3& target) { return {from, normalize(target - from)}; }

/// A ray from some way off, towards a point of the triangle.
Ray towards(const Triangle& t, Real distance, Random& random) {
    const Real b = random.uniform(0, 1), c = random.uniform(0, 1 - b);
    const Vec3 target = t.a + b * (t.b - t.a) + c * (t.c - t.a);
    return towards(target + distance * random.direction(), target);
}

std::optional<ShadowCase> planes(Random& random) {
    const Real scale = some_scale(random);
    const Vec3 place = some_place(random);
    const Plane plane{place + scale * random.direction(), random.magnitude(-3, 3) * random.direction()};
    return lit(random, plane, {place + scale * random.in_cube(), random.direction()}, scale, false);
}

std::optional<ShadowCase> spheres(Random& random) {
    const Real scale = some_scale(random);
    const Vec3 place = some_place(random);
    const Vec3 from = place + scale * random.magnitude(-1, 3) * random.direction();
    const Vec3 target = place + scale * random.uniform(0, 1) * random.direction();
    return lit(random, Sphere{place, scale}, towards(from, target), scale, true);
}

std::optional<ShadowCase> triangles(Random& random) {
    const Real scale = some_scale(random);
    const Vec3 place = some_place(random);
    const auto corner = [&] { return place + scale * random.in_cube(); };
    const Triangle triangle{corner(), corner(), corner()};
    return lit(random, triangle, towards(triangle, scale * random.magnitude(-1, 3), random), scale, false);
}

/// Thin triangles of all shapes: two corners together, or all three nearly on one line.
std::optional<ShadowCase> needles(Random& random) {
    const Real scale = some_scale(random);
    const Vec3 place = some_place(random);
    const Vec3 edge = scale * random.direction();
    const Vec3 aside = scale * random.magnitude(-15, -1) * random.direction();
    const Real along = random.index(2) == 0 ? 1 : random.uniform(-1, 2);
    const std::array<Vec3, 3> corners{place, place + edge, place + along * edge + aside};
    const std::size_t first = random.index(3);
    const Triangle needle{corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
    return lit(random, needle, towards(needle, scale * random.magnitude(-1, 3), random), scale, false);
}

/// Floors up to 1e6 units wide, the hit within a few units of the middle; level ones half of the time.
std::optional<ShadowCase> floors(Random& random) {
    const Real size = random.magnitude(0, 6);
    Mat4 turn(1);
    if (random.index(2) == 0) turn = rotation(random.direction(), random.uniform(0, 6));
    const auto turned = [&](const Vec3& p) { return transform_point(turn, p); };
    const Triangle floor{turned({-size, -1, -size}), turned({size, -1, -size}), turned({0, -1, size})};
    const Vec3 target(random.uniform(-1, 1), -1, random.uniform(-0.5, 0));
    return lit(random, floor, towards(turned(Vec3(0, 2, 5) + random.in_cube()), turned(target)), 1, false);
}

std::optional<ShadowCase> polygons(Random& random) {
    const Real scale = some_scale(random);
    const Vec3 place = some_place(random);
    const Vec3 u = random.direction(), v = perpendicular_to(u, random);
    Polygon polygon;
    for (int k = 0; k < 5; ++k) {
        const Real angle = 2 * pi * k / 5;
        polygon.vertices.push_back(place + scale * (std::cos(angle) * u + std::sin(angle) * v));
    }
    const Vec3 target = place + scale * random.uniform(-0.8, 0.8) * u;
    const Vec3 from = place + scale * random.magnitude(-1, 3) * random.direction();
    return lit(random, polygon, towards(from, target), scale, false);
}

/// A map with axes up to 1e4 apart in length, turned, slanted and moved.
std::optional<Transform> some_transform(Random& random, Real scale) {
    const Vec3 axes(random.magnitude(-2, 2), random.magnitude(-2, 2), 1);
    const Mat4 m = translation(some_place(random)) * rotation(random.direction(), random.uniform(0, 6)) *
                   scaling(scale * axes) * rotation(random.direction(), random.uniform(0, 6));
    const std::optional<Mat4> back = inverse(m);
    if (!back) return std::nullopt;
    return Transform{m, *back};
}

std::optional<ShadowCase> ellipsoids(Random& random) {
    const Real scale = some_scale(random);
    const std::optional<Transform> transform = some_transform(random, scale);
    if (!transform) return std::nullopt;
    const Vec3 from = random.magnitude(-1, 3) * random.direction(),
               target = random.uniform(0, 1) * random.direction();
    const Vec3 start = transform_point(transform->to_world, from);
    const Vec3 end = transform_point(transform->to_world, target);
    return lit(random, Ellipsoid{*transform, unit_sphere}, towards(start, end), scale, true);
}

std::optional<ShadowCase> instances(Random& random) {
    const Real scale = some_scale(random);
    const std::optional<Transform> transform = some_transform(random, scale);
    if (!transform) return std::nullopt;
    const Vec3 place = random.magnitude(-3, 1) * random.direction();
    const auto corner = [&] { return place + random.in_cube(); };
    const Triangle triangle{corner(), corner(), corner()};
    const Ray local = towards(triangle, random.magnitude(-1, 3), random);
    const Vec3 start = transform_point(transform->to_world, local.origin);
    const Ray view{start, normalize(transform_vector(transform->to_world, local.direction))};
    return lit(random, PlacedTriangle{*transform, triangle}, view, scale, false);
}

constexpr std::array<ShadowFamily, 8> families{{
    {"planes", "scale 1e-6 to 1e6, up to 1e7 from the origin", planes},
    {"spheres", "radius 1e-6 to 1e6, up to 1e7 from the origin", spheres},
    {"triangles", "size 1e-6 to 1e6, up to 1e7 from the origin", triangles},
    {"needles", "the same, aspect 10 to 1e15", needles},
    {"large floors", "corners up to 1e6 away", floors},
    {"polygons", "size 1e-6 to 1e6, up to 1e7 from the origin", polygons},
    {"ellipsoids", "the same, axes up to 1e4 apart", ellipsoids},
    {"instances", "the same, slanted", instances},
}};

// ------------------------------------------------------------------------------------------------- judge

std::string text_of(const ShadowCase& item, const ShadowRay& answer) {
    return "point " + literal(item.surface.point) + ", error " + literal(item.surface.error) + ", normal " +
           literal(item.surface.normal) + "\n  light along " + literal(item.light.direction) +
           ", occluder at gap " + literal(item.gap) + "\n  shadow ray " + literal(answer.ray) + " in (" +
           literal(answer.range.min) + ", " + literal(answer.range.max) + "]";
}

}  // namespace

std::span<const ShadowFamily> shadow_families() { return families; }

std::vector<ShadowCase> make_cases(const ShadowFamily& family, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<ShadowCase> made;
    made.reserve(count);
    while (made.size() < count)
        if (std::optional<ShadowCase> one = family.make(random)) made.push_back(std::move(*one));
    return made;
}

ShadowVerdict judge(std::span<const ShadowCase> cases, std::span<const ShadowRay> answers) {
    ShadowVerdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const ShadowCase& item = cases[i];
        if (meets(item.shape, answers[i]) && verdict.self_hits++ == 0)
            verdict.first_self_hit = text_of(item, answers[i]);
        if (!meets(item.occluder, answers[i]) && verdict.lost++ == 0)
            verdict.first_lost = text_of(item, answers[i]);
    }
    return verdict;
}

void add(ShadowVerdict& total, const ShadowVerdict& batch) {
    total.cases += batch.cases;
    total.self_hits += batch.self_hits;
    total.lost += batch.lost;
    if (total.first_self_hit.empty()) total.first_self_hit = batch.first_self_hit;
    if (total.first_lost.empty()) total.first_lost = batch.first_lost;
}

std::string describe(const ShadowVerdict& verdict) {
    const std::string of_all = " of " + std::to_string(verdict.cases) + " shadow rays ";
    std::string text = std::to_string(verdict.self_hits) + of_all + "hit the surface that they start on, " +
                       std::to_string(verdict.lost) + " miss what stands in their way";
    if (!verdict.first_self_hit.empty())
        text += "\nthe first that hits its own surface:\n  " + verdict.first_self_hit;
    if (!verdict.first_lost.empty())
        text += "\nthe first that misses what stands in its way:\n  " + verdict.first_lost;
    return text;
}

}  // namespace rt::stability

namespace rt::naive {

ShadowRay shadow_ray_without_offset(const Surface& surface, const LightSample& light) {
    return {{surface.point, light.direction}, {0, light.distance}};
}

ShadowRay shadow_ray_with_epsilon(const Surface& surface, const LightSample& light) {
    return {{surface.point, light.direction}, {epsilon, light.distance}};
}

ShadowRay shadow_ray_by_integers(const Surface& surface, const LightSample& light) {
    const Vec3 n = dot(surface.normal, light.direction) < 0 ? -surface.normal : surface.normal;
    Vec3 origin = surface.point;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(origin[i]) < 1.0 / 32) {
            origin[i] += n[i] / 65536;
        } else {
            const auto ulps = static_cast<std::int64_t>(256 * n[i]);
            origin[i] =
                std::bit_cast<Real>(std::bit_cast<std::int64_t>(origin[i]) + (origin[i] < 0 ? -ulps : ulps));
        }
    }
    return {{origin, light.direction}, {0, light.distance}};
}

}  // namespace rt::naive
