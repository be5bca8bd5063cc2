// The exact judge of lines and tori.
// A point is inside where A² ≤ 4R²ρ² or A ≤ 0, with A = |x|² + R² − r² and ρ its distance from the axis.
// Times the square of the axis, which need not be a unit vector, all of that is whole numbers times powers of
// two.
#include "tests/oracle/torus.hpp"

#include "tests/oracle/sturm.hpp"

#include <algorithm>
#include <cmath>

namespace rt::oracle {
namespace {

using Vec = ExactVec3<Exact>;
using End = std::optional<Exact>;

/// a + b·t + c·t²
struct Quadratic {
    Exact a, b, c;
    Exact at(const Exact& t) const { return (c * t + b) * t + a; }
};

Quadratic square(const Vec& f, const Vec& d) { return {dot(f, f), Exact(2) * dot(f, d), dot(d, d)}; }

End end_of(Real t) { return std::isfinite(t) ? End(Exact(t)) : End(); }

/// The t between one where q ≤ 0 and one where it is positive at which it changes its sign, to 100 binary
/// places of their distance, where q ≤ 0.
Exact edge(const Quadratic& q, Exact inside, Exact outside) {
    for (int i = 0; i < 100; ++i) {
        const Exact middle = (inside + outside) * Exact(0.5);
        (CGAL::sign(q.at(middle)) <= 0 ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace

struct LineAndTorus::Numbers {
    bool is_nothing = false;
    std::vector<Exact> coefficients;
    std::optional<Sturm> quartic;
    /// The part in the ball where A ≤ 0, all of which is inside; but for 100 binary places.
    bool has_ball = false;
    Exact ball_low, ball_high;

    bool is_inside(const Exact& t) const { return quartic->sign_at(t) <= 0; }

    /// Without regard to the ball.
    bool covers(const End& low, const End& high) const {
        if (!low || !high) return false;
        if (*low > *high) return true;
        const int sign = quartic->sign_at(*high);
        return is_inside(*low) && sign <= 0 && quartic->roots(low, high) <= (sign == 0 ? 1 : 0);
    }
};

LineAndTorus::LineAndTorus(const Torus& torus, const Ray& ray, Real growth) {
    auto made = std::make_unique<Numbers>();
    const Exact R(torus.ring), r = Exact(torus.tube) + Exact(growth);
    made->is_nothing = CGAL::sign(r) < 0;
    const Vec f = Vec(ray.origin) - Vec(torus.center), d(ray.direction), n(torus.axis);
    const Exact n2 = dot(n, n);
    Quadratic A = square(f, d);
    const Quadratic across = square(cross(f, n), cross(d, n));
    A.a = A.a + (R - r) * (R + r);
    const auto coefficients = [&](const Exact& q0, const Exact& q1, const Exact& q2) {
        const Exact k = Exact(4) * R * R;
        return std::vector<Exact>{n2 * q0 * q0 - k * across.a, Exact(2) * n2 * q0 * q1 - k * across.b,
                                  n2 * (q1 * q1 + Exact(2) * q0 * q2) - k * across.c, Exact(2) * n2 * q1 * q2,
                                  n2 * q2 * q2};
    };
    made->coefficients = coefficients(A.a, A.b, A.c);
    made->quartic.emplace(made->coefficients);
    const Exact nearest(-CGAL::to_double(A.b) / (2 * CGAL::to_double(A.c)));
    if (!made->is_nothing && CGAL::sign(A.at(nearest)) < 0) {
        const Exact beyond(2 * std::sqrt(-CGAL::to_double(A.at(nearest)) / CGAL::to_double(A.c)));
        made->has_ball = true;
        made->ball_low = edge(A, nearest, nearest - beyond);
        made->ball_high = edge(A, nearest, nearest + beyond);
    }
    numbers = std::move(made);
}

LineAndTorus::~LineAndTorus() = default;

bool LineAndTorus::meets(Interval part) const {
    const Numbers& all = *numbers;
    if (part.min > part.max || all.is_nothing) return false;
    const End low = end_of(part.min), high = end_of(part.max);
    if (all.has_ball && !(low && *low > all.ball_high) && !(high && *high < all.ball_low)) return true;
    return (low && all.is_inside(*low)) || (high && all.is_inside(*high)) ||
           all.quartic->roots(low, high) > 0;
}

Real LineAndTorus::step_from(Real t) const {
    const Exact at(t);
    Exact value(0), slope(0);
    for (std::size_t i = numbers->coefficients.size(); i-- > 0;) {
        slope = slope * at + value;
        value = value * at + numbers->coefficients[i];
    }
    return -CGAL::to_double(value) / CGAL::to_double(slope);
}

bool LineAndTorus::covers(Interval part) const {
    const Numbers& all = *numbers;
    if (part.min > part.max) return true;
    if (all.is_nothing) return false;
    const End low = end_of(part.min), high = end_of(part.max);
    if (!all.has_ball) return all.covers(low, high);
    const auto lesser = [](const End& a, const Exact& b) { return a && *a < b ? a : End(b); };
    const auto greater = [](const End& a, const Exact& b) { return a && *a > b ? a : End(b); };
    return (!low || *low < all.ball_low ? all.covers(low, lesser(high, all.ball_low)) : true) &&
           (!high || *high > all.ball_high ? all.covers(greater(low, all.ball_high), high) : true);
}

}  // namespace rt::oracle
