// Families of extreme cases for chapter 10's implicit surfaces and quadrics, and their judge.
#include "tests/stability/implicits.hpp"

#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/quadric.hpp"
#include "common/math/error.hpp"
#include "common/scene/evaluate.hpp"
#include "tests/oracle/implicit.hpp"
#include "tests/stability/leaving.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace rt::stability {
namespace {

using test::many;
using test::Random;
using test::towards;

constexpr KnownSurface known[] = {
    {"the heart (Taubin 1993)", "(x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3", 2},
    {"Barth's sextic",
     "4*(2.618033988749895*x^2-y^2)*(2.618033988749895*y^2-z^2)*(2.618033988749895*z^2-x^2)"
     "-4.23606797749979*(x^2+y^2+z^2-1)^2",
     1.8},
    {"a torus", "(x^2+y^2+z^2+3/4)^2-4*(x^2+y^2)", 2},
    {"a drop", "4*(x^2+y^2)-(1+z)*(1-z)^3", 1.5},
    {"Cayley's cubic", "4*(x^2+y^2+z^2)+16*x*y*z-1", 1},
    {"Steiner's Roman surface", "x^2*y^2+y^2*z^2+z^2*x^2-2*x*y*z", 1.5},
    {"Whitney's umbrella", "x^2-y^2*z", 1},
    {"a cuspidal edge", "x^3-y^2", 1},
    {"ding-dong", "x^2+y^2-(1-z)*z^2", 1.5},
    {"a tangle cube", "x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8", 3},
    {"Kummer's surface", "(x^2+y^2+z^2-1.5^2)^2-3.5*((1-z)^2-2*x^2)*((1+z)^2-2*y^2)", 2},
};

const Implicit& one_of_all(Random& random) {
    static const std::vector<Implicit> all = [] {
        std::vector<Implicit> made_surfaces;
        for (const KnownSurface& one : known) made_surfaces.push_back(surface(one));
        return made_surfaces;
    }();
    return all[random.index(all.size())];
}
const Implicit& heart() {
    static const Implicit one = surface(known[0]);
    return one;
}

using Implicits = std::vector<SolidCase<Implicit>>;

// ------------------------------------------------------------------------------------- implicit surfaces

Implicits all_surfaces(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Implicit& one = one_of_all(random);
        return SolidCase<Implicit>{
            one, towards(random, one.box.high.x * random.in_cube(), random.magnitude(-1, 1))};
    });
}

/// Towards a point near the surface, as a rule.
Implicits far(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Vec3 target = random.direction() * random.uniform(0, 1.3);
        return SolidCase<Implicit>{heart(), towards(random, target, random.magnitude(0, 8))};
    });
}

/// Near the two points of the heart where it is thinner than anything: the cleft and the tip.
Implicits lobes(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Vec3 tip(0, 0, random.sign());
        const Vec3 target = tip + random.magnitude(-8, -0.5) * random.in_cube();
        Ray ray = towards(random, target, random.magnitude(-1, 1));
        if (random.index(3) == 0) ray.direction[static_cast<int>(random.index(2))] = 0;
        return SolidCase<Implicit>{heart(), ray};
    });
}

/// Through the edge of a cusp, or just beside it.
Implicits cusps(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Vec3 edge(0, 0, random.uniform(-1, 1));
        const Vec3 beside = random.index(3) == 0 ? Vec3(0) : random.magnitude(-12, -1) * random.in_cube();
        static const Implicit cusp = surface_of("x^3-y^2", 1);
        return SolidCase<Implicit>{cusp, towards(random, edge + beside, random.magnitude(-1, 1))};
    });
}

/// Two spheres that are nearly the same: between them f is below 0 by the square of their distance.
Implicits double_roots(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real gap = random.index(4) == 0 ? 0 : random.magnitude(-17, -2);
        const Implicit shells = surface_of(fmt::format("(x^2+y^2+z^2-1)^2-{}", gap), 1.25);
        return SolidCase<Implicit>{shells, towards(random, random.in_cube(), random.magnitude(-1, 1))};
    });
}

/// To the tube of a torus, or to a ball, at r(1 + k ulp).
Implicits tangents(std::size_t count, std::uint64_t seed) {
    static const Implicit ball = surface_of("x^2+y^2+z^2-1", 1.25), torus = surface(known[2]);
    return many(count, seed, [](Random& random) {
        const bool is_ball = random.index(2) == 0;
        const Vec3 n = random.direction();
        const Real beside = random.index(2) == 0 ? std::floor(random.uniform(-80, 81)) * 2 * unit_roundoff
                                                 : random.sign() * random.magnitude(-15, -3);
        const Vec3 ring = is_ball ? Vec3(0) : normalize(Vec3(n.x, n.y, 0));
        const Vec3 point = ring + (is_ball ? 1 : 0.5) * (1 + beside) * n;
        const Vec3 d = random.perpendicular_to(n);
        return SolidCase<Implicit>{is_ball ? ball : torus, {point - random.magnitude(-1, 1) * d, d}};
    });
}

Implicits inside(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Implicit& one = one_of_all(random);
        return SolidCase<Implicit>{
            one, {one.box.high.x * random.in_cube(), random.magnitude(-20, 20) * random.direction()}};
    });
}

constexpr std::array<SolidFamily<Implicit>, 7> implicits{{
    {"the catalogue", all_surfaces, false},
    {"the heart from 1 to 1e8 away", far, false},
    {"thin lobes of the heart", lobes},
    {"through a cuspidal edge", cusps},
    {"double roots, and pairs as close as 1e-9", double_roots},
    {"nearly tangent rays", tangents},
    {"origin in the box, directions of length 1e-20 to 1e20", inside},
}};

// ------------------------------------------------------------------------------------------------ quadrics

Quadric some_quadric(Random& random) {
    const std::size_t kind = random.index(4);
    const auto sign = [&] { return kind == 0 ? 1 : random.sign(); };
    Quadric q{{sign() * random.magnitude(-2, 2), sign() * random.magnitude(-2, 2),
               sign() * random.magnitude(-2, 2)},
              kind == 1 ? random.in_cube() : Vec3(0),
              kind >= 2 ? random.in_cube() : Vec3(0),
              kind == 3 ? 0 : -random.magnitude(-2, 0),
              {Vec3(-2), Vec3(2)}};
    if (random.index(4) == 0) q.squares[static_cast<int>(random.index(3))] = 0;
    return q;
}

using Quadrics = std::vector<SolidCase<Quadric>>;

Quadrics far_quadrics(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        return SolidCase<Quadric>{some_quadric(random),
                                  towards(random, random.in_cube(), random.magnitude(0, 8))};
    });
}

/// In a box that is much larger than it is.
Quadrics small_quadrics(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real radius = random.magnitude(-5, 0);
        const Vec3 target = 1.2 * radius * random.direction();
        return SolidCase<Quadric>{{Vec3(1), Vec3(0), Vec3(0), -radius * radius, {Vec3(-2), Vec3(2)}},
                                  towards(random, target, random.magnitude(0, 2))};
    });
}

Quadrics tangent_quadrics(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Vec3 axes(random.magnitude(-1, 0), random.magnitude(-1, 0), random.magnitude(-1, 0));
        const Vec3 n = random.direction(), d = axes * random.perpendicular_to(n);
        const Vec3 point = axes * n * random.nudge();
        return SolidCase<Quadric>{{Real(1) / (axes * axes), Vec3(0), Vec3(0), -1, {Vec3(-2), Vec3(2)}},
                                  {point - random.magnitude(-1, 1) * d, d}};
    });
}

Quadrics apexes(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Quadric cone{
            {1, random.magnitude(-2, 2), -random.magnitude(-2, 2)}, Vec3(0), Vec3(0), 0, {Vec3(-2), Vec3(2)}};
        const Vec3 beside = random.index(3) == 0 ? Vec3(0) : random.magnitude(-12, -1) * random.in_cube();
        return SolidCase<Quadric>{cone, towards(random, beside, random.magnitude(-1, 1))};
    });
}

constexpr std::array<SolidFamily<Quadric>, 4> quadrics{{
    {"all kinds, from 1 to 1e8 away", far_quadrics},
    {"1e-5 to 1 times as large as half the box", small_quadrics},
    {"nearly tangent rays", tangent_quadrics, false},
    {"through the tip of a cone", apexes},
}};

// --------------------------------------------------------------------------------------------------- judge

Formula expression_of(const Quadric& q) {
    return parse_formula(
        fmt::format("{}*x^2+({})*y^2+({})*z^2+({})*x*y+({})*x*z+({})*y*z+({})*x+({})*y+({})*z+({})",
                    q.squares.x, q.squares.y, q.squares.z, q.mixed.x, q.mixed.y, q.mixed.z, q.linear.x,
                    q.linear.y, q.linear.z, q.constant));
}

std::string words_of(const Implicit& implicit) {
    return implicit.f->text + " in " + literal(implicit.box.low) + ", " + literal(implicit.box.high);
}
std::string words_of(const Quadric& quadric) { return expression_of(quadric).text; }

template <class Shape>
Verdict judge_all(std::span<const SolidCase<Shape>> cases, std::span<const std::optional<Hit>> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Shape& shape = cases[i].shape;
        const Ray& ray = cases[i].ray;
        const std::optional<Chord> line = chord(shape.box, ray, {0, infinity});
        const std::optional<Hit>& answer = answers[i];
        const auto complain = [&](const char* what) {
            count_mismatch(verdict, words_of(shape) + "\n  " + literal(ray) + "\n  " + what + "; answered: " +
                                        (answer ? "a hit at " + literal(answer->t) : "a miss"));
        };
        if (!line) {
            if (answer) complain("the line is not in the box");
            continue;
        }
        std::optional<Real> lambda;
        if (answer) lambda = (answer->t - line->from) / line->length;
        // λ from t: both may have lost what is small beside the way to the box.
        const Real slack = gamma(4) * (1 + line->from / line->length);
        const auto [f, rounding] = polynomial_of(shape);
        const oracle::LineTruth truth =
            oracle::judge_line(f, line->start, line->way, rounding, lambda, slack);
        if (truth.is_overlooked)
            complain("an earlier crossing is overlooked");
        else if (answer && !(answer->t > 0))
            complain("it is not in the range");
        else if (answer && !truth.is_on)
            complain("it is not on the surface");
        else if (truth.has_hidden)
            ++verdict.undecided;
    }
    return verdict;
}

template <class Shape>
Verdict judge_leaving_in_box(const LeavingRays<SolidCase<Shape>>& rays,
                             std::span<const std::optional<Hit>> answers) {
    Verdict verdict = judge_all<Shape>(rays.cases, answers);
    for (std::size_t i = 0; i < rays.cases.size(); ++i) {
        const auto& [shape, ray] = rays.cases[i];
        const Formula f = polynomial_of(shape).f;
        if (rays.goes_back[i] && (oracle::sign_on_line(f, ray.origin, ray.direction, 0) > 0) != rays.outward)
            count_mismatch(verdict, words_of(shape) + "\n  " + literal(ray) + "\n  begins on the wrong side");
    }
    return verdict;
}

}  // namespace

std::span<const SolidFamily<Implicit>> implicit_families() { return implicits; }
std::span<const SolidFamily<Quadric>> quadric_families() { return quadrics; }
std::span<const KnownSurface> known_surfaces() { return known; }
Implicit surface(const KnownSurface& one) { return surface_of(one.expression, one.reach); }
Implicit surface_named(std::string_view name) {
    return surface(*std::ranges::find_if(
        known, [&](const KnownSurface& one) { return std::string_view(one.name).starts_with(name); }));
}
Implicit surface_of(const std::string& expression, Real reach) {
    return {{Vec3(-reach), Vec3(reach)}, std::make_shared<const Formula>(parse_formula(expression))};
}
Implicit tight_heart() { return {{{-1.25, -0.75, -1.1}, {1.25, 0.75, 1.3}}, surface_named("the heart").f}; }

JudgedPolynomial polynomial_of(const Implicit& implicit) {
    int operations = 0;
    for (const Instruction& step : implicit.f->steps) {
        const bool is_coordinate = Operation::X <= step.operation && step.operation <= Operation::Z;
        operations += is_coordinate ? 2 : 1 + std::max(0, step.exponent - 2);
    }
    return {*implicit.f, gamma(8 * operations)};
}
JudgedPolynomial polynomial_of(const Quadric& quadric) { return {expression_of(quadric), gamma(32)}; }

Verdict judge(std::span<const SolidCase<Implicit>> cases, std::span<const std::optional<Hit>> answers) {
    return judge_all(cases, answers);
}
Verdict judge(std::span<const SolidCase<Quadric>> cases, std::span<const std::optional<Hit>> answers) {
    return judge_all(cases, answers);
}

Verdict judge_leaving(const LeavingRays<SolidCase<Implicit>>& rays,
                      std::span<const std::optional<Hit>> answers) {
    return judge_leaving_in_box(rays, answers);
}
Verdict judge_leaving(const LeavingRays<SolidCase<Quadric>>& rays,
                      std::span<const std::optional<Hit>> answers) {
    return judge_leaving_in_box(rays, answers);
}

}  // namespace rt::stability

namespace rt::naive {

std::optional<Hit> march(const Implicit& implicit, const Ray& ray, Interval range, int steps) {
    const std::optional<Span> in_box = inside(implicit.box, ray);
    if (!in_box) return std::nullopt;
    const Real enter = std::max(in_box->enter, range.min), leave = std::min(in_box->leave, range.max);
    const auto f = [&](Real t) { return value_at(*implicit.f, point_at(ray, t)); };
    Real t = enter;
    for (int i = 1; i <= steps && enter < leave; ++i) {
        Real before = t;
        t = enter + (leave - enter) * i / steps;
        const bool is_inside = f(before) < 0;
        if ((f(t) < 0) == is_inside) continue;
        for (int k = 0; k < 60; ++k) {
            const Real middle = (before + t) / 2;
            ((f(middle) < 0) == is_inside ? before : t) = middle;
        }
        return contains(range, t) ? std::optional(Hit{.t = t, .element = surface_face}) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<Hit> intersect(const Implicit& implicit, const Ray& ray, Interval range) {
    return march(implicit, ray, range, 100);
}

std::optional<Hit> intersect(const Quadric& q, const Ray& ray, Interval range) {
    const Vec3 &o = ray.origin, &d = ray.direction;
    const auto both = [&](const Vec3& u, const Vec3& v) {
        return dot(q.squares, u * v) +
               (q.mixed.x * (u.x * v.y + u.y * v.x) + q.mixed.y * (u.x * v.z + u.z * v.x) +
                q.mixed.z * (u.y * v.z + u.z * v.y)) /
                   2;
    };
    const Real a = both(d, d), h = both(o, d) + dot(q.linear, d) / 2,
               c = both(o, o) + dot(q.linear, o) + q.constant;
    const Real root = std::sqrt(h * h - a * c);
    for (const Real t : {(-h - root) / a, (-h + root) / a}) {
        const Vec3 p = point_at(ray, t);
        if (contains(range, t) && glm::all(glm::lessThanEqual(q.box.low, p)) &&
            glm::all(glm::lessThanEqual(p, q.box.high)))
            return Hit{.t = t, .element = surface_face};
    }
    return std::nullopt;
}

}  // namespace rt::naive
