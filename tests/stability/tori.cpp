// Families of extreme cases for chapter 10's quartics and tori, and their judge.
#include "tests/stability/tori.hpp"

#include "common/math/error.hpp"
#include "tests/oracle/polynomial.hpp"
#include "tests/oracle/torus.hpp"
#include "tests/stability/leaving.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace rt::stability {
namespace {

using test::many;
using test::Random;
using test::towards;

// 4 ulp, as a relative error: an ulp is at most 2u.
constexpr Real band = 8 * unit_roundoff;

// ---------------------------------------------------------------------------------------------- quartics

using Cases = std::vector<PolynomialCase>;

/// (t − roots[0])···(t − roots[3]), times a number, each coefficient rounded once, and then nudged now and
/// then; between places beyond all the roots.
PolynomialCase from_roots(Random& random, std::array<Real, 4> roots) {
    std::array<long double, 5> a{1};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = i + 2; k-- > 0;) a[k] = (k > 0 ? a[k - 1] : 0) - roots[i] * a[k];
    const Real times = random.sign() * random.magnitude(-3, 3);
    const bool nudged = random.index(2) == 0;
    PolynomialCase item;
    Real beyond = 0;
    for (const Real root : roots) beyond = std::max(beyond, std::abs(root) * random.uniform(1.1, 2));
    for (std::size_t i = 0; i < 5; ++i)
        item.polynomial.a[i] = times * static_cast<Real>(a[i]) * (nudged ? random.nudge() : 1);
    item.low = random.index(3) == 0 ? 0 : -beyond;
    item.high = beyond;
    return item;
}

Cases apart(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        std::array<Real, 4> roots;
        for (Real& root : roots) root = random.sign() * random.magnitude(-8, 0);
        return from_roots(random, roots);
    });
}

Cases nearly_double(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real a = random.uniform(-1, 1), apart = random.magnitude(-16, -1);
        return from_roots(random, {a, a * (1 + apart), random.uniform(-1, 1), random.uniform(-1, 1)});
    });
}

Cases two_nearly_double(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real a = random.uniform(-1, 1), b = random.uniform(-1, 1);
        return from_roots(random,
                          {a, a * (1 + random.magnitude(-16, -1)), b, b * (1 + random.magnitude(-16, -1))});
    });
}

Cases threefold_and_fourfold(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        std::array<Real, 4> roots;
        const Real a = random.uniform(-1, 1);
        for (Real& root : roots) root = a * (1 + random.sign() * random.magnitude(-8, -1));
        if (random.index(2) == 0) roots[3] = random.uniform(-1, 1);
        return from_roots(random, roots);
    });
}

/// Two complex pairs, or one: t² − 2ct + c² + w², with w small now and then.
Cases nearly_real(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        PolynomialCase item = from_roots(random, {0, 0, random.uniform(-1, 1), random.uniform(-1, 1)});
        const Real c = random.uniform(-1, 1), w2 = random.magnitude(-17, 0);
        const std::array<Real, 5> a = item.polynomial.a;  // only 2, 3 and 4 are not 0
        const std::array<Real, 3> pair{c * c + w2, -2 * c, 1};
        for (std::size_t i = 0; i < 5; ++i) {
            item.polynomial.a[i] = 0;
            for (std::size_t k = 0; k < 3; ++k)
                if (i + 2 >= k && i + 2 - k < 5) item.polynomial.a[i] += pair[k] * a[i + 2 - k];
        }
        item.low = -2, item.high = 2;
        return item;
    });
}

/// Two quartics on which closed formulas fail (Orellana & De Michele 2020), nudged and scaled.
Cases of_the_literature(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const bool first = random.index(2) == 0;
        PolynomialCase item{first
                                ? Polynomial{{26471900.25, -1325880, 25449, -240, 1}}
                                : Polynomial{{57126150.652217, -476217.617178, -48660.891842, 19.534611, 1}},
                            -300, 300};
        Real scale = 1;
        const Real s = random.magnitude(-3, 3);
        for (std::size_t i = 5; i-- > 0; scale *= s) item.polynomial.a[i] *= scale * random.nudge();
        item.low *= s, item.high *= s;
        return item;
    });
}

/// Of lower degree, or even, or with numbers of all sizes.
Cases of_all_sizes(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        PolynomialCase item;
        for (Real& a : item.polynomial.a)
            a = random.index(4) == 0 ? 0 : random.sign() * random.magnitude(-20, 20);
        // Near a manifold root at 0 its values would be smaller than all numbers.
        if (item.polynomial.a[1] == 0) item.polynomial.a[0] = random.sign();
        item.high = random.magnitude(-10, 10);
        item.low =
            random.index(2) == 0 ? -item.high * random.magnitude(-2, 2) : item.high * random.uniform(0, 1);
        return item;
    });
}

constexpr std::array<PolynomialFamily, 7> polynomials{{
    {"roots from 1e-8 to 1 in size", apart},
    {"two roots 1e-16 to 0.1 apart", nearly_double},
    {"two such pairs", two_nearly_double},
    {"three or four roots 1e-8 to 0.1 apart", threefold_and_fourfold},
    {"a pair of roots that are nearly real", nearly_real},
    {"two quartics of the literature, nudged", of_the_literature},
    {"coefficients from 1e-20 to 1e20, and 0", of_all_sizes},
}};

// -------------------------------------------------------------------------------------------------- tori

using Tori = std::vector<TorusCase>;

/// `part` is the tube's radius over the ring's.
Torus some_torus(Random& random, Real size, Real part) {
    Vec3 axis = random.magnitude(-3, 3) * random.direction();
    if (random.index(4) == 0) axis = Vec3(0), axis[static_cast<int>(random.index(3))] = random.sign();
    const Vec3 center = random.index(4) == 0 ? Vec3(0) : size * random.magnitude(-2, 2) * random.in_cube();
    return {center, axis, size * std::min<Real>(1, 1 / part), size * std::min<Real>(1, part)};
}
Torus some_torus(Random& random, Real size) { return some_torus(random, size, random.magnitude(-1.5, 0.5)); }

Real size_of(const Torus& torus) { return torus.ring + torus.tube; }

/// A point of the plane through the axis and `radial`, by its angle around the tube: 0 on the outer equator,
/// π on the inner one.
Vec3 on_tube(const Torus& torus, const Vec3& radial, Real angle, Real radii = 1) {
    const Vec3 n = normalize(torus.axis), out = std::cos(angle) * radial + std::sin(angle) * n;
    return torus.center + torus.ring * radial + radii * torus.tube * out;
}
Vec3 some_radial(Random& random, const Torus& torus) { return random.perpendicular_to(torus.axis); }

/// A point of the torus, or a little outside.
Vec3 aim(Random& random, const Torus& torus) {
    return on_tube(torus, some_radial(random, torus), random.uniform(0, 2 * pi), random.uniform(0, 1.2));
}

/// The line through the target along d, seen from somewhere on it, so that it is not moved.
Ray through(Random& random, const Torus& torus, const Vec3& target, const Vec3& d) {
    return {target - size_of(torus) * random.sign() * random.magnitude(-1, 2) * d,
            random.uniform(0.5, 2) * d};
}

template <class MakeTorus>
Tori aimed(std::size_t count, std::uint64_t seed, Real farthest, MakeTorus make) {
    return many(count, seed, [&](Random& random) {
        const Torus torus = make(random);
        return TorusCase{
            torus, towards(random, aim(random, torus), size_of(torus) * random.magnitude(-1, farthest))};
    });
}

Tori far(std::size_t count, std::uint64_t seed) {
    return aimed(count, seed, 8, [](Random& random) { return some_torus(random, random.magnitude(-3, 3)); });
}

Tori thin(std::size_t count, std::uint64_t seed) {
    return aimed(count, seed, 4,
                 [](Random& random) { return some_torus(random, 1, random.magnitude(-8, -1)); });
}

Real nearly_touching(Random& random) {
    return random.index(2) == 0 ? random.nudge() : 1 + random.sign() * random.magnitude(-16, -1);
}

Tori self_touching(std::size_t count, std::uint64_t seed) {
    return aimed(count, seed, 3, [](Random& random) {
        return some_torus(random, random.magnitude(-3, 3),
                          random.index(2) == 0 ? 1 : nearly_touching(random));
    });
}

Tori spindles(std::size_t count, std::uint64_t seed) {
    return aimed(count, seed, 3,
                 [](Random& random) { return some_torus(random, 1, random.magnitude(0, 8)); });
}

/// Through a point near the centre, of tori whose hole is nearly closed, or just so; along the axis now and
/// then.
Tori through_the_center(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, 1, random.index(3) == 0 ? 1 : nearly_touching(random));
        const Vec3 n = normalize(torus.axis);
        Vec3 target = torus.center + random.magnitude(-17, 0) * random.direction();
        if (random.index(2) == 0)
            target = torus.center + random.magnitude(-9, 0) * n +
                     random.magnitude(-17, -1) * some_radial(random, torus);
        const Vec3 d = random.index(2) == 0 ? random.direction()
                                            : normalize(n + random.magnitude(-17, 0) * random.direction());
        return TorusCase{torus, through(random, torus, target, d)};
    });
}

/// Where the dimple of a spindle is deepest, and its surface meets the axis.
Tori dimples(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, 1, 1 + random.magnitude(-8, 2));
        const Vec3 n = normalize(torus.axis);
        const Real height = std::sqrt((torus.tube - torus.ring) * (torus.tube + torus.ring));
        const Vec3 deepest = torus.center + random.sign() * height * n;
        const Vec3 target = deepest + random.magnitude(-17, 0) * random.direction();
        const Vec3 d = random.index(4) == 0 ? n : random.direction();
        return TorusCase{torus, through(random, torus, target, d)};
    });
}

/// In the plane that touches the tube, at r(1 + k ulp), anywhere or at one of the equators.
Tori tangent(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, random.magnitude(-3, 3));
        const Real equator = random.index(2) == 0 ? 0 : pi;
        const Real angle = random.index(2) == 0 ? equator : random.uniform(0, 2 * pi);
        const Vec3 radial = some_radial(random, torus), n = normalize(torus.axis);
        const Vec3 around = normalize(cross(n, radial)),
                   across = std::cos(angle) * n - std::sin(angle) * radial;
        const Real turn = random.index(3) == 0 ? 0 : random.uniform(0, pi);
        const Vec3 d = std::cos(turn) * around + std::sin(turn) * across;
        return TorusCase{torus, through(random, torus, on_tube(torus, radial, angle, random.nudge()), d)};
    });
}

/// At the inner equator, in the directions in which the surface is straight: three roots in one.
Tori threefold(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, 1, random.magnitude(-3, -0.01));
        const Vec3 radial = some_radial(random, torus), n = normalize(torus.axis);
        const Real turn = std::atan2(std::sqrt(torus.tube), std::sqrt(torus.ring - torus.tube));
        const Vec3 d = std::cos(turn) * normalize(cross(n, radial)) + random.sign() * std::sin(turn) * n;
        const Vec3 off = random.index(2) == 0 ? Vec3(0) : random.magnitude(-17, -3) * random.direction();
        return TorusCase{
            torus, through(random, torus, on_tube(torus, radial, pi, random.nudge()), normalize(d + off))};
    });
}

/// Lines that touch the tube twice, or just not: in the plane on which the torus lies, and through the
/// centre. Some ulps beside it all are too close to call; therefore half of them are farther away.
Tori bitangent(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, 1, random.magnitude(-6, -0.01));
        const Vec3 radial = some_radial(random, torus), n = normalize(torus.axis);
        const Vec3 around = normalize(cross(n, radial));
        const Real sine = torus.tube / torus.ring;
        const Real beside =
            random.index(2) == 0 ? random.nudge() : 1 + random.sign() * random.magnitude(-14, -3);
        if (random.index(2) == 0)
            return TorusCase{
                torus, through(random, torus, torus.center,
                               normalize(std::sqrt((1 - sine) * (1 + sine)) * radial + sine * beside * n))};
        const Vec3 top = torus.center + torus.tube * beside * n;
        return TorusCase{torus,
                         through(random, torus, top + torus.ring * random.uniform(0, 1) * radial, around)};
    });
}

/// Along the axis, or nearly: through the hole, or down the inner wall.
Tori along_the_axis(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, 1, random.magnitude(-4, 1));
        const Vec3 n = normalize(torus.axis), radial = some_radial(random, torus);
        const Real walls[] = {0, (torus.ring - torus.tube) * random.nudge(), torus.ring,
                              (torus.ring + torus.tube) * random.nudge()};
        Vec3 d = n;
        if (random.index(2) == 0) d = normalize(d + random.magnitude(-17, -2) * random.direction());
        return TorusCase{torus, through(random, torus, torus.center + walls[random.index(4)] * radial, d)};
    });
}

/// Whole numbers, so that rays pass exactly through the centre, in the plane of the ring and along edges.
Tori whole_numbers(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const auto whole = [&](int limit) {
            return static_cast<Real>(random.index(2 * static_cast<std::size_t>(limit) + 1)) - limit;
        };
        Torus torus{{whole(5), whole(5), whole(5)}, {0, 0, 0}, 3 + whole(2), 3 + whole(2)};
        torus.axis[static_cast<int>(random.index(3))] = random.sign();
        Vec3 d(whole(2), whole(2), whole(2));
        if (d == Vec3(0)) d.x = 1;
        const Vec3 target = torus.center + Vec3(whole(8), whole(8), whole(8));
        return TorusCase{torus, {target - (4 + whole(3)) * d, d}};
    });
}

Tori tiny_and_huge(std::size_t count, std::uint64_t seed) {
    return aimed(count, seed, 4, [](Random& random) {
        return some_torus(
            random, random.uniform(1, 2) * std::pow(10.0, random.sign() * (random.index(2) == 0 ? 12 : 27)));
    });
}

Tori long_and_short_directions(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Torus torus = some_torus(random, random.magnitude(-1, 1));
        Ray ray = towards(random, aim(random, torus), size_of(torus) * random.magnitude(0, 4));
        ray.direction *= random.sign() > 0 ? 1e20 : 1e-20;
        return TorusCase{torus, ray};
    });
}

constexpr std::array<TorusFamily, 13> tori{{
    {"distance over size from 0.1 to 1e8", far},
    {"ring over tube from 10 to 1e8", thin},
    {"hole closed, or nearly", self_touching},
    {"spindles, tube over ring from 1 to 1e8", spindles},
    {"near the centre of a hole that is closed, or nearly", through_the_center},
    {"where the dimples of spindles are deepest", dimples},
    {"nearly tangent, at r(1 + k ulp)", tangent},
    {"three roots in one, at the inner equator", threefold},
    {"touching twice, at r(1 + k ulp) and up to r/1000 beside it", bitangent},
    {"along the axis, but for some ulps", along_the_axis},
    {"whole numbers", whole_numbers},
    {"size 1e-27, 1e-12, 1e12 and 1e27", tiny_and_huge},
    {"directions of length 1e-20 and 1e20", long_and_short_directions},
}};

// ------------------------------------------------------------------------------------------------ judges

std::string literal(const PolynomialCase& item) {
    std::string text = "{";
    for (const Real a : item.polynomial.a) text += (text.size() > 1 ? ", " : "") + stability::literal(a);
    return text + "}, from " + stability::literal(item.low) + " to " + stability::literal(item.high);
}

int count_moved(const PolynomialCase& item, Real part) {
    return oracle::count_roots(item.polynomial.a, {item.low, item.high}, part);
}

/// Why an answer is wrong; empty if it is right.
std::string fault(const PolynomialCase& item, const SignChanges& answer) {
    const oracle::Coefficients& a = item.polynomial.a;
    bool is_positive = evaluate(item.polynomial, item.low).value > 0;
    Real from = item.low;
    for (int i = 0; i <= answer.count; ++i, is_positive = !is_positive) {
        const bool is_last = i == answer.count;
        const Real t = is_last ? item.high : answer.t[static_cast<std::size_t>(i)];
        if (!(from <= t && t <= item.high)) return "not in order";
        if (!is_last && oracle::residual(a, t) > 2 * band) return "not a root: " + stability::literal(t);
        const Interval part{from, t};
        const bool can_be =
            is_positive ? oracle::can_be_positive(a, part, band) : oracle::can_be_not_positive(a, part, band);
        if (!can_be) return "a root is missing before " + stability::literal(t);
        from = t;
    }
    return "";
}

/// Whether moving the coefficients by up to 4 ulp may change the number of roots.
bool is_undecided(const PolynomialCase& item, int count) {
    return count_moved(item, band) != count || count_moved(item, -band) != count;
}

std::string literal(const Torus& torus) {
    return "Torus{" + stability::literal(torus.center) + ", " + stability::literal(torus.axis) + ", " +
           stability::literal(torus.ring) + ", " + stability::literal(torus.tube) + "}";
}

std::string literal(const TorusCase& item) {
    return literal(item.torus) + ", " + stability::literal(item.ray);
}

struct TorusJudge {
    const TorusCase& item;
    Real eta = band * (length(item.ray.origin - item.torus.center) + 5 * size_of(item.torus));
    oracle::LineAndTorus grown{item.torus, item.ray, eta}, shrunk{item.torus, item.ray, -eta};

    static Real slack(Real t) { return std::isfinite(t) ? band * std::abs(t) : 0; }

    /// But for rounding in t.
    static Interval between(Real low, Real high) { return {low + slack(low), high - slack(high)}; }

    bool is_undecided() const {
        const Interval line{-infinity, infinity};
        return grown.meets(line) && !shrunk.meets(line);
    }

    /// Why an answer is wrong; empty if it is right.
    std::string fault(const TorusSpans& answer) const {
        Real last = -infinity;
        for (std::size_t i = 0; i < static_cast<std::size_t>(answer.count); ++i) {
            const auto [enter, leave, enter_face, leave_face] = answer.spans[i];
            if (!(last <= enter && enter <= leave)) return "not in order";
            if (shrunk.meets(between(last, enter))) return "too little before " + stability::literal(enter);
            if (!grown.covers(between(enter, leave))) return "too much after " + stability::literal(enter);
            last = leave;
        }
        if (shrunk.meets(between(last, infinity))) return "too little after " + stability::literal(last);
        return "";
    }

    /// Of a ray that starts outside, or inside.
    std::string fault(const std::optional<Hit>& answer, bool outside) const {
        if (outside ? grown.meets({0, 0}) : !shrunk.meets({0, 0})) return "starts too near to the surface";
        if (!answer) return !outside || shrunk.meets({0, infinity}) ? "missed" : "";
        const Real t = answer->t;
        const Interval before{0, t - slack(t)}, around{std::max<Real>(0, t - slack(t)), t + slack(t)};
        if (outside ? shrunk.meets(before) : !grown.covers(before)) return "an earlier hit is missed";
        if (outside ? !grown.meets(around) : shrunk.covers(around)) return "there is no surface";
        return "";
    }
};

std::string show(const TorusSpans& answer) {
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(answer.count); ++i)
        text += " from " + stability::literal(answer.spans[i].enter) + " to " +
                stability::literal(answer.spans[i].leave);
    return text.empty() ? " nothing" : text;
}

}  // namespace

std::span<const PolynomialFamily> polynomial_families() { return polynomials; }
std::span<const TorusFamily> torus_families() { return tori; }

Verdict judge(std::span<const PolynomialCase> cases, std::span<const SignChanges> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const PolynomialCase& item = cases[i];
        const std::string fault = stability::fault(item, answers[i]);
        if (!fault.empty()) {
            std::string given;
            for (std::size_t k = 0; k < static_cast<std::size_t>(answers[i].count); ++k)
                given += " " + stability::literal(answers[i].t[k]);
            count_mismatch(verdict, literal(item) + "\n  " + fault + "; answered:" + given);
        } else if (is_undecided(item, answers[i].count)) {
            ++verdict.undecided;
        }
        for (std::size_t k = 0; fault.empty() && k < static_cast<std::size_t>(answers[i].count); ++k)
            remember(verdict, oracle::residual(item.polynomial.a, answers[i].t[k]) / (2 * band),
                     [&] { return literal(item); });
    }
    return verdict;
}

Verdict judge(std::span<const TorusCase> cases, std::span<const TorusSpans> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const TorusJudge judge{cases[i]};
        const std::string fault = judge.fault(answers[i]);
        if (!fault.empty())
            count_mismatch(verdict, literal(cases[i]) + "\n  " + fault + "; answered:" + show(answers[i]));
        else if (judge.is_undecided())
            ++verdict.undecided;
    }
    return verdict;
}

Verdict judge_leaving(const LeavingRays<TorusCase>& rays, std::span<const std::optional<Hit>> answers) {
    const std::vector<TorusCase>& cases = rays.cases;
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string fault = TorusJudge{cases[i]}.fault(answers[i], rays.outward);
        if (!fault.empty())
            count_mismatch(verdict, literal(cases[i]) + "\n  " + fault + "; answered: " +
                                        (answers[i] ? stability::literal(answers[i]->t) : "a miss"));
    }
    return verdict;
}

}  // namespace rt::stability

namespace rt::naive {
namespace {

constexpr Real constant = 1e-9;
bool is_zero(Real x) { return std::abs(x) < constant; }

/// The real roots of a polynomial of degree 2, 3 or 4.
struct SomeRoots {
    std::size_t count = 0;
    std::array<Real, 4> t{};
    void add(Real root) { t[count++] = root; }
};

void add_quadratic(SomeRoots& roots, Real c0, Real c1) {
    const Real p = c1 / 2, discriminant = p * p - c0;
    if (is_zero(discriminant)) return roots.add(-p);
    if (discriminant < 0) return;
    roots.add(std::sqrt(discriminant) - p);
    roots.add(-std::sqrt(discriminant) - p);
}

SomeRoots solve_cubic(Real c, Real b, Real a) {
    const Real p = (b - a * a / 3) / 3, q = (a * (2 * a * a / 27 - b / 3) + c) / 2;
    const Real p3 = p * p * p, discriminant = q * q + p3;
    SomeRoots roots;
    if (is_zero(discriminant)) {
        const Real u = std::cbrt(-q);
        roots.add(2 * u);
        if (!is_zero(q)) roots.add(-u);
    } else if (discriminant < 0) {
        const Real angle = std::acos(-q / std::sqrt(-p3)) / 3, t = 2 * std::sqrt(-p);
        roots.add(t * std::cos(angle));
        roots.add(-t * std::cos(angle + pi / 3));
        roots.add(-t * std::cos(angle - pi / 3));
    } else {
        const Real root = std::sqrt(discriminant);
        roots.add(std::cbrt(root - q) - std::cbrt(root + q));
    }
    for (std::size_t i = 0; i < roots.count; ++i) roots.t[i] -= a / 3;
    return roots;
}

/// t⁴ + a·t³ + b·t² + c·t + d
SomeRoots solve_quartic(Real d, Real c, Real b, Real a) {
    const Real a2 = a * a, p = b - 3 * a2 / 8, q = a2 * a / 8 - a * b / 2 + c;
    const Real r = -3 * a2 * a2 / 256 + a2 * b / 16 - a * c / 4 + d;
    SomeRoots roots;
    if (is_zero(r)) {
        roots = solve_cubic(q, p, 0);
        roots.add(0);
    } else {
        const Real z = solve_cubic(r * p / 2 - q * q / 8, -r, -p / 2).t[0];
        Real u = z * z - r, v = 2 * z - p;
        if (is_zero(u)) u = 0;
        if (is_zero(v)) v = 0;
        if (u < 0 || v < 0) return {};
        u = std::sqrt(u), v = std::sqrt(v);
        add_quadratic(roots, z - u, q < 0 ? -v : v);
        add_quadratic(roots, z + u, q < 0 ? v : -v);
    }
    for (std::size_t i = 0; i < roots.count; ++i) roots.t[i] -= a / 4;
    return roots;
}

}  // namespace

SignChanges sign_changes(const Polynomial& p, Real low, Real high) {
    const Real lead = p.a[4];
    const SomeRoots all = solve_quartic(p.a[0] / lead, p.a[1] / lead, p.a[2] / lead, p.a[3] / lead);
    SignChanges in_range;
    for (std::size_t i = 0; i < all.count; ++i)
        if (low <= all.t[i] && all.t[i] <= high)
            in_range.t[static_cast<std::size_t>(in_range.count++)] = all.t[i];
    std::fill(in_range.t.begin() + in_range.count, in_range.t.end(), infinity);
    std::ranges::sort(in_range.t);
    return in_range;
}

Polynomial torus_quartic(const Torus& torus, const Ray& ray) {
    const Real speed = length(ray.direction), R = torus.ring, r = torus.tube;
    const Vec3 f = ray.origin - torus.center, e = ray.direction / speed, n = normalize(torus.axis);
    const Real q0 = dot(f, f) + R * R - r * r, q1 = 2 * dot(f, e), z = dot(f, n), dz = dot(e, n),
               k = 4 * R * R;
    return {{q0 * q0 - k * (dot(f, f) - z * z), 2 * q0 * q1 - k * (q1 - 2 * z * dz),
             q1 * q1 + 2 * q0 - k * (1 - dz * dz), 2 * q1, 1}};
}

SignChanges crossings_from_the_eye(const Torus& torus, const Ray& ray,
                                   SignChanges (*solve)(const Polynomial&, Real low, Real high)) {
    const Real distance = length(ray.origin - torus.center), reach = 2 * (torus.ring + torus.tube);
    SignChanges roots = solve(torus_quartic(torus, ray), distance - reach, distance + reach);
    for (Real& t : roots.t) t /= length(ray.direction);
    return roots;
}

TorusSpans inside(const Torus& torus, const Ray& ray) {
    const SignChanges changes = naive::sign_changes(torus_quartic(torus, ray), -infinity, infinity);
    const Real speed = length(ray.direction);
    TorusSpans spans;
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(changes.count); i += 2)
        spans.spans[static_cast<std::size_t>(spans.count++)] = {changes.t[i] / speed,
                                                                changes.t[i + 1] / speed};
    return spans;
}

}  // namespace rt::naive
