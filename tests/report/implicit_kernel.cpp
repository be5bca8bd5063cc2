// Rays and surfaces f = 0 in a box, quadrics and the heart: how wrong each method is, and how long it takes.
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/quadric.hpp"
#include "chapters/10_surfaces/sphere_tracing.hpp"
#include "common/math/error.hpp"
#include "tests/oracle/implicit.hpp"
#include "tests/report/kernel.hpp"
#include "tests/stability/implicits.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <optional>

namespace rt::report {
namespace {

using test::Random;
using QuadricCase = stability::SolidCase<Quadric>;
using ImplicitCase = stability::SolidCase<Implicit>;

constexpr Interval ahead{0, infinity};

Answer answer_of(const std::optional<Hit>& hit) { return hit ? hit_at(hit->t) : Answer{}; }

// -------------------------------------------------------------------------------------------- methods

/// h² − a·c, but from the chord's start.
Answer textbook_in_chord(const QuadricCase& q) {
    const std::optional<Chord> part = chord(q.shape.box, q.ray, ahead);
    if (!part) return {};
    const std::optional<Hit> hit = naive::intersect(q.shape, Ray{part->start, part->way}, {0, 1});
    return hit ? hit_at(part->t_at(hit->t)) : Answer{};
}

constexpr Method<QuadricCase> quadric_methods[] = {
    {"h² − ac from the eye",
     "double",
     {1, "h² − ac from the eye"},
     [](const QuadricCase& q) { return answer_of(naive::intersect(q.shape, q.ray, ahead)); }},
    {"h² − ac in the chord", "double", {2, "h² − ac in the chord"}, textbook_in_chord},
    {"where it is deepest",
     "double",
     {3, "where it is deepest"},
     [](const QuadricCase& q) { return answer_of(intersect(q.shape, q.ray, ahead)); },
     true},
};

template <int steps>
Answer equal_steps(const ImplicitCase& q) {
    return answer_of(naive::march(q.shape, q.ray, ahead, steps));
}

/// All methods get the tight box.
const Implicit& heart() {
    static const Implicit one = stability::tight_heart();
    return one;
}

template <int digits>
Answer by_spheres(const ImplicitCase& q) {
    static const Real lipschitz = lipschitz_bound(heart());
    return answer_of(sphere_trace(q.shape, lipschitz, q.ray, ahead, std::pow(Real(10), -digits)));
}

constexpr Look steps_look{1, "equal steps"}, spheres_look{2, "sphere tracing"};

constexpr Method<ImplicitCase> implicit_methods[] = {
    {"equal steps", "30 steps", steps_look, equal_steps<30>},
    {"equal steps", "100 steps", steps_look, equal_steps<100>},
    {"equal steps", "1000 steps", steps_look, equal_steps<1000>},
    {"sphere tracing", "to 1e-2", spheres_look, by_spheres<2>},
    {"sphere tracing", "to 1e-4", spheres_look, by_spheres<4>},
    {"intervals",
     "double",
     {3, "intervals"},
     [](const ImplicitCase& q) { return answer_of(intersect(q.shape, q.ray, ahead)); },
     true},
};

// ------------------------------------------------------------------------------------------- families

constexpr const char* quadric_family =
    "ellipsoids in a box, axes from 0.1 to 1, distance from 1 to 1e6; the ray passes 1e-16 to 1 of them "
    "below "
    "the surface, one in eight above it";

std::vector<QuadricCase> quadric_cases(std::size_t count) {
    Random random(kernel_seed + 3);
    std::vector<QuadricCase> cases(count);
    for (auto& [quadric, ray] : cases) {
        const Vec3 axes(random.magnitude(-1, 0), random.magnitude(-1, 0), random.magnitude(-1, 0));
        const Vec3 center = random.in_cube(), squares = Real(1) / (axes * axes);
        quadric = {squares,
                   Vec3(0),
                   Real(-2) * squares * center,
                   dot(squares, center * center) - 1,
                   {Vec3(-2), Vec3(2)}};
        const Vec3 n = random.direction();
        const Real depth = random.magnitude(-16, 0);
        const Vec3 target = center + (1 + (random.index(8) == 0 ? depth : -depth)) * axes * n;
        const Vec3 d = normalize(axes * random.perpendicular_to(n));
        const Vec3 origin = target - (4 + random.magnitude(0, 6)) * d;
        ray = {origin, (target - origin) * (random.uniform(0.5, 2) / length(target - origin))};
    }
    return cases;
}

constexpr const char* implicit_family =
    "from 4 to 1e6 away, half of the rays towards points in and around it, half past its cleft or its tip, "
    "where "
    "it is thinner than any step";

std::vector<ImplicitCase> implicit_cases(std::size_t count) {
    Random random(kernel_seed + 4);
    std::vector<ImplicitCase> cases;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 thin(0, 0, random.sign());
        const Vec3 target = i % 2 == 0 ? random.direction() * random.uniform(0, 1.3)
                                       : thin + random.magnitude(-3, -0.5) * random.in_cube();
        const Vec3 origin = target - (4 + random.magnitude(0, 6)) * random.direction();
        const Real speed = random.uniform(0.5, 2) / length(target - origin);
        cases.push_back({heart(), {origin, speed * (target - origin)}});
    }
    return cases;
}

// ---------------------------------------------------------------------------------------------- judge

/// A hit is wrong where f has no root on the chord, and clearly none; a miss, and a hit, where a crossing is
/// overlooked. How far t is off is judged against the course's, which one exact step of Newton's brings to
/// the truth.
template <class Shape>
Judged judge(const stability::SolidCase<Shape>& item, const Answer& answer) {
    const auto& [shape, ray] = item;
    Judged result;
    const std::optional<Chord> part = chord(shape.box, ray, ahead);
    if (!part) return {.wrong = answer.is_hit()};
    const auto [f, rounding] = stability::polynomial_of(shape);
    std::optional<Real> lambda;
    if (answer.is_hit()) lambda = (answer.t - part->from) / part->length;
    const oracle::LineTruth truth = oracle::judge_line(f, part->start, part->way, rounding, lambda, 1e-3);
    result.wrong = truth.is_overlooked || (answer.is_hit() && truth.roots == 0 && !truth.is_on);
    const std::optional<Hit> own = intersect(shape, ray, ahead);
    if (!answer.is_hit() || !own || own->element != surface_face || result.wrong) return result;
    const oracle::NearRoot near = oracle::near_root(f, ray.origin, ray.direction, own->t);
    const Real toward = std::abs(dot(surface_at(shape, ray, *own).normal, ray.direction));
    const Real size = std::max(max_component(abs(shape.box.low)), max_component(abs(shape.box.high)));
    const Real way = length(ray.origin) + own->t * length(ray.direction) + size;
    const Real moved = unit_roundoff * (way / toward + near.magnitude / std::abs(near.slope));
    // Where rounding the data could change the slope itself, there is nothing to be right about.
    if (16 * std::max(moved, std::abs(near.step)) * std::abs(near.bend) < std::abs(near.slope))
        result.error = std::abs((answer.t - own->t) - near.step) / moved;
    return result;
}

}  // namespace

void measure_quadrics(const KernelOptions& options, Kernels& kernels, const Told& told) {
    measure<QuadricCase>({"quadric", quadric_family, quadric_methods,
                          quadric_cases(options.cases / slow_part), judge<Quadric>},
                         options, kernels, told);
}

void measure_implicits(const KernelOptions& options, Kernels& kernels, const Told& told) {
    measure<ImplicitCase>({"heart", implicit_family, implicit_methods,
                           implicit_cases(options.cases / slow_part), judge<Implicit>},
                          options, kernels, told);
}

}  // namespace rt::report
