// Rays and tori: how wrong each method is, and how long it takes.
#include "chapters/10_surfaces/torus.hpp"
#include "common/math/error.hpp"
#include "tests/oracle/torus.hpp"
#include "tests/report/kernel.hpp"
#include "tests/stability/tori.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <optional>

namespace rt::report {
namespace {

using stability::TorusCase;
using test::Random;

Answer first_of(const TorusSpans& spans) { return spans.count > 0 ? hit_at(spans.spans[0].enter) : Answer{}; }

/// The first root of the quartic by a method, expanded at the eye or near the torus.
using Solve = SignChanges (*)(const Polynomial&, Real, Real);
Answer at_the_eye(const TorusCase& q, Solve solve) {
    const SignChanges roots = naive::crossings_from_the_eye(q.torus, q.ray, solve);
    return roots.count > 0 ? hit_at(roots.t[0]) : Answer{};
}
Answer near_the_torus(const TorusCase& q, Solve solve) {
    const std::optional<TorusLine> line = torus_line(q.torus, q.ray);
    if (!line) return {};
    const Real size = q.torus.ring + q.torus.tube;
    const SignChanges roots = solve(torus_quartic(q.torus, *line, 0), -size, size);
    return roots.count > 0 ? hit_at(line->from + roots.t[0] / line->speed) : Answer{};
}

constexpr Method<TorusCase> torus_methods[] = {
    {"closed formulas from the eye",
     "double",
     {1, "closed formulas, eye"},
     [](const TorusCase& q) { return at_the_eye(q, naive::sign_changes); }},
    {"sign changes from the eye",
     "double",
     {4, "sign changes, eye"},
     [](const TorusCase& q) { return at_the_eye(q, sign_changes); }},
    {"closed formulas near",
     "double",
     {2, "closed formulas, near"},
     [](const TorusCase& q) { return near_the_torus(q, naive::sign_changes); }},
    {"sign changes near",
     "double",
     {3, "sign changes, near"},
     [](const TorusCase& q) { return first_of(inside(q.torus, q.ray)); },
     true},
};

constexpr const char* torus_family =
    "distance over size from 1 to 1e6, ring over tube from 1 to 1000; the ray passes 1e-16 to 1 tube radii "
    "below the surface, one in eight above it";

/// A ray along the surface, `depth` of the tube's radius below some point of it.
std::vector<TorusCase> torus_cases(std::size_t count) {
    Random random(kernel_seed + 2);
    std::vector<TorusCase> cases(count);
    for (TorusCase& item : cases) {
        const Real ring = random.magnitude(-1, 1), depth = random.magnitude(-16, 0);
        item.torus = {10 * ring * random.in_cube(), random.direction(), ring, ring * random.magnitude(-3, 0)};
        const Vec3 n = normalize(item.torus.axis), radial = random.perpendicular_to(n);
        const Real angle = random.uniform(0, 2 * pi), turn = random.uniform(0, 2 * pi);
        const Vec3 out = std::cos(angle) * radial + std::sin(angle) * n;
        const Vec3 along = std::cos(angle) * n - std::sin(angle) * radial;
        const Vec3 d = std::cos(turn) * cross(n, radial) + std::sin(turn) * along;
        const Vec3 target = item.torus.center + ring * radial +
                            item.torus.tube * (1 + (random.index(8) == 0 ? depth : -depth)) * out;
        const Vec3 origin = target - (ring + item.torus.tube) * (1 + random.magnitude(0, 6)) * d;
        item.ray = {origin, (target - origin) * (random.uniform(0.5, 2) / length(target - origin))};
    }
    return cases;
}

/// The method's t against the course's, which one exact step of Newton's brings to the truth.
Judged judge(const TorusCase& item, const Answer& answer) {
    constexpr Interval line{-infinity, infinity};
    const auto& [torus, ray] = item;
    const Real size = torus.ring + torus.tube, way = length(ray.origin - torus.center);
    const Real eta = 8 * unit_roundoff * (way + 5 * size);
    Judged result;
    result.wrong = answer.is_hit() ? !oracle::LineAndTorus(torus, ray, eta).meets(line)
                                   : oracle::LineAndTorus(torus, ray, -eta).meets(line);
    const Answer own = first_of(inside(torus, ray));
    if (!answer.is_hit() || !own.is_hit() || result.wrong) return result;
    const Real step = oracle::LineAndTorus(torus, ray).step_from(own.t);
    const Vec3 normal = surface_at(torus, ray, Hit{.t = own.t}).normal;
    const Real slope = std::abs(dot(normal, ray.direction));
    const Real moved = unit_roundoff * (way + std::abs(own.t) * length(ray.direction) + size) / slope;
    // Where rounding the data could move t by as much as the ray is inside, there is nothing to be right
    // about.
    const TorusSpans spans = inside(torus, ray);
    if (16 * moved < spans.spans[0].leave - spans.spans[0].enter)
        result.error = std::abs((answer.t - own.t) - step) / moved;
    return result;
}

}  // namespace

void measure_tori(const KernelOptions& options, Kernels& kernels, const Told& told) {
    measure<TorusCase>({"torus", torus_family, torus_methods, torus_cases(options.cases), judge}, options,
                       kernels, told);
}

}  // namespace rt::report
