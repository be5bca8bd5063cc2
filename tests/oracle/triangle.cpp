// The exact judge of rays and triangles.
// All that is asked here is rational, so every answer is a sign or a quotient of exact numbers.
#include "tests/oracle/triangle.hpp"

#include "tests/oracle/exact.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>

namespace rt::oracle {
namespace {

using Vec = ExactVec3<Exact>;

bool is_zero(const Vec& v) { return CGAL::is_zero(v.x) && CGAL::is_zero(v.y) && CGAL::is_zero(v.z); }

}  // namespace

TriangleTruth judge_triangle(const Triangle& triangle, const Ray& ray, Real proposed) {
    const Vec origin(ray.origin), d(ray.direction);
    const Vec a = Vec(triangle.a) - origin, b = Vec(triangle.b) - origin, c = Vec(triangle.c) - origin;
    const Vec normal = cross(b - a, c - a);

    TriangleTruth truth;
    truth.degenerate = is_zero(normal);
    if (truth.degenerate) return truth;

    const Vec b_c = cross(b, c);
    const Exact sum = dot(normal, d), u = dot(d, b_c), v = dot(d, cross(c, a)), w = sum - u - v;
    truth.volumes = {CGAL::to_double(u), CGAL::to_double(v), CGAL::to_double(w)};
    truth.sum = CGAL::to_double(sum);
    if (CGAL::is_zero(sum)) return truth;

    const Exact height = dot(a, b_c);
    truth.t = CGAL::to_double(height) / truth.sum;
    if (std::isfinite(proposed)) truth.error = CGAL::to_double(Exact(proposed) * sum - height) / truth.sum;
    const int side = CGAL::sign(sum);
    truth.hit = CGAL::sign(u) * side >= 0 && CGAL::sign(v) * side >= 0 && CGAL::sign(w) * side >= 0 &&
                CGAL::sign(height) * side >= 0;
    return truth;
}

Vec3 unit_normal(const Triangle& triangle) {
    using Rational = CGAL::Gmpq;
    const ExactVec3<Rational> a(triangle.a);
    const auto normal = cross(ExactVec3<Rational>(triangle.b) - a, ExactVec3<Rational>(triangle.c) - a);
    const Rational greatest = std::max({CGAL::abs(normal.x), CGAL::abs(normal.y), CGAL::abs(normal.z)});
    if (greatest == 0) return Vec3(0);
    // Quotients by the greatest coordinate are in the range of Real, whatever the size.
    const auto part = [&](const Rational& x) { return CGAL::to_double(x / greatest); };
    return glm::normalize(Vec3(part(normal.x), part(normal.y), part(normal.z)));
}

std::optional<bool> cgal_ray_meets_triangle(const Triangle& triangle, const Ray& ray) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    const Vec3 second = ray.origin + ray.direction;
    if (!is_zero(Vec(second) - Vec(ray.origin) - Vec(ray.direction))) return std::nullopt;
    const Kernel::Triangle_3 exact_triangle(point(triangle.a), point(triangle.b), point(triangle.c));
    if (exact_triangle.is_degenerate()) return std::nullopt;
    return CGAL::do_intersect(Kernel::Ray_3(point(ray.origin), point(second)), exact_triangle);
}

}  // namespace rt::oracle
