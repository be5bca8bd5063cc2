// Families of extreme cases for chapter 7, their judges, and the textbook methods that break on them.
#include "tests/stability/optics.hpp"

#include "common/math/error.hpp"
#include "tests/show.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::many;
using test::Random;

/// Stands for exact arithmetic: 11 more bits than Real where `long double` is the 80-bit format.
using Precise = long double;

struct Precise3 {
    Precise x, y, z;
};
Precise3 precise(const Vec3& v) { return {v.x, v.y, v.z}; }
Precise dot(const Precise3& a, const Precise3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Precise3 sum(Precise f, const Precise3& a, Precise g, const Precise3& b) {
    return {f * a.x + g * b.x, f * a.y + g * b.y, f * a.z + g * b.z};
}
Precise length(const Precise3& a) { return std::sqrt(dot(a, a)); }
Precise3 unit(const Precise3& a) { return sum(1 / length(a), a, 0, a); }

// --------------------------------------------------------------------------------------------- families

/// The case with this sine and cosine, in a random place or along the axes, where they come out exact.
InterfaceCase at_angle(Random& random, Real sine, Real cosine, Real eta) {
    if (random.index(2) == 0) {
        const int axis = static_cast<int>(random.index(3)), other = (axis + 1) % 3;
        Vec3 n(0), d(0);
        n[axis] = random.index(2) == 0 ? 1 : -1;
        d[other] = random.index(2) == 0 ? sine : -sine;
        return {d - cosine * n, n, eta};
    }
    const Vec3 n = random.direction();
    const Precise3 across = unit(precise(cross(n, random.direction())));
    const Precise3 d = unit(sum(sine, across, -cosine, unit(precise(n))));
    const Vec3 rounded(static_cast<Real>(d.x), static_cast<Real>(d.y), static_cast<Real>(d.z));
    return {rounded, glm::dot(rounded, n) > 0 ? -n : n, eta};
}

/// From air to diamond (2.42) and back.
Real ratio(Random& random) { return std::pow(Real(2.5), random.uniform(-1, 1)); }

InterfaceCase at_sine(Random& random, Real sine, Real eta) {
    sine = std::min(sine, Real(1));
    return at_angle(random, sine, std::sqrt((1 - sine) * (1 + sine)), eta);
}
InterfaceCase at_cosine(Random& random, Real cosine, Real eta) {
    return at_angle(random, std::sqrt((1 - cosine) * (1 + cosine)), cosine, eta);
}

std::vector<InterfaceCase> all_angles(std::size_t count, std::uint64_t seed) {
    return many(count, seed,
                [](Random& random) { return at_cosine(random, random.uniform(0, 1), ratio(random)); });
}

std::vector<InterfaceCase> critical(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real eta = std::pow(Real(2.5), random.uniform(0, 1));
        const Real sign = random.index(2) == 0 ? 1 : -1;
        // Exactly critical, one or a few ulp beside it, or anything up to a thousandth.
        const Real off = random.index(2) == 0 ? 2 * unit_roundoff * static_cast<Real>(random.index(9))
                                              : random.magnitude(-16, -3);
        return at_sine(random, (1 + sign * off) / eta, eta);
    });
}

std::vector<InterfaceCase> grazing(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real cosine = random.index(16) == 0 ? 0 : random.magnitude(-18, -2);
        return at_cosine(random, cosine, ratio(random));
    });
}

std::vector<InterfaceCase> nearly_equal(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real off = random.index(16) == 0 ? 0 : random.magnitude(-16, -2);
        const Real eta = random.index(2) == 0 ? 1 + off : 1 - off;
        return at_cosine(random, random.magnitude(-9, 0), eta);
    });
}

std::vector<InterfaceCase> perpendicular(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real sine = random.index(16) == 0 ? 0 : random.magnitude(-18, -3);
        return at_sine(random, sine, ratio(random));
    });
}

constexpr std::array<InterfaceFamily, 5> families{{
    {"all angles, ratios from 0.4 to 2.5", "a few, more near the critical angle", all_angles},
    {"the critical angle, eta·sin = 1 ± k ulp", "up to 1e8, near 1/sqrt(k ulp)", critical},
    {"grazing, cosine 0 and 1e-18 to 1e-2", "a few; on the way back 1/cosine", grazing},
    {"nearly equal media, eta = 1 ± 1e-16 to 1e-2", "about 2, more near the critical angle", nearly_equal},
    {"nearly perpendicular, sine 0 and 1e-18 to 1e-3", "1 + eta", perpendicular},
}};

// ------------------------------------------------------------------------------------------------ judge

std::string literal_of(const InterfaceCase& item) {
    return "d = " + literal(item.d) + ", n = " + literal(item.n) + ", eta = " + literal(item.eta);
}
std::string literal_of(const CosineCase& item) {
    return "cos_i = " + literal(item.cos_i) + ", eta = " + literal(item.eta);
}
std::string literal_of(const std::optional<Vec3>& answer) { return answer ? literal(*answer) : "nothing"; }
std::string literal_of(Real answer) { return literal(answer); }

/// Counts one case; `error` is in units of what is allowed, NaN is wrong.
template <class Case, class Answer>
void count(Verdict& verdict, const Case& item, Precise error, const Answer& answer) {
    if (error <= 1) {
        if (error > verdict.worst) {
            verdict.worst = static_cast<Real>(error);
            verdict.worst_case = literal_of(item);
        }
    } else {
        const std::string times = test::show_size(static_cast<Real>(error));
        count_mismatch(verdict, literal_of(item) + "\n  answered: " + literal_of(answer) + ", " +
                                    (error < 1e300 ? "off by " + times + " times what is allowed"
                                                   : "which is wrong by any measure"));
    }
}

/// The exact truth about a case whose d and n are taken for directions, of whatever length.
struct Truth {
    Precise3 d, n, t;
    Precise c, s, cos_t_squared, cos_t;
    Precise
        mean_cos_t;  ///< of the refracted ray's cosine, and that of data moved by 4 ulp towards the border
    bool near_critical;  ///< moving the data by 4 ulp decides between refracted and total
};

Truth truth_of(const InterfaceCase& item) {
    Truth truth{};
    truth.d = unit(precise(item.d));
    truth.n = unit(precise(item.n));
    truth.c = -dot(truth.d, truth.n);
    truth.s = length(sum(1, truth.d, truth.c, truth.n));
    const Precise eta = item.eta;
    truth.cos_t_squared = (1 - eta) * (1 + eta) + eta * eta * truth.c * truth.c;
    // d cosₜ²/d angle is −2 eta² s c, and 4 ulp are at most 8u.
    const Precise moved = 16 * unit_roundoff * eta * eta * truth.s * truth.c;
    truth.near_critical = std::abs(truth.cos_t_squared) <= moved;
    if (truth.cos_t_squared >= 0) {
        truth.cos_t = std::sqrt(truth.cos_t_squared);
        truth.mean_cos_t = (truth.cos_t + std::sqrt(std::max<Precise>(truth.cos_t_squared - moved, 0))) / 2;
        truth.t = sum(eta, truth.d, eta * truth.c - truth.cos_t, truth.n);
    }
    return truth;
}

/// Whether a few roundings of its terms decide the sign of cosₜ².
bool is_near_critical(Precise eta, Precise c, Precise cos_t_squared) {
    return std::abs(cos_t_squared) <= 16 * unit_roundoff * eta * eta * c * c;
}

/// The reflected part, and how much of a relative error of u in each step it shows.
struct Reflectance {
    Precise exact = 0;
    Precise kappa = 0;
};
Reflectance reflectance_of(Precise eta, Precise c, Precise cos_t_squared) {
    const Precise cos_t = std::sqrt(cos_t_squared);
    Precise exact = 0, slope = 0;
    for (const Precise x : {eta * cos_t / c, cos_t / (eta * c)}) {
        const Precise r = (1 - x) / (1 + x);
        exact += r * r / 2;
        slope += std::abs(r) * 2 * x / ((1 + x) * (1 + x));
    }
    return {exact, 1 + slope * (1 + eta * eta * c * c / cos_t_squared)};
}

bool is_unit(const Vec3& v) { return std::abs(length(precise(v)) - 1) <= 4 * unit_roundoff; }

Precise wrong() { return std::numeric_limits<Precise>::infinity(); }

}  // namespace

std::span<const InterfaceFamily> interface_families() { return families; }

Verdict judge_refraction(std::span<const InterfaceCase> cases, std::span<const std::optional<Vec3>> answers) {
    Verdict verdict;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::optional<Vec3>& answer = answers[i];
        const Truth truth = truth_of(cases[i]);
        ++verdict.cases;
        Precise error = 0;
        if (truth.near_critical) {
            ++verdict.undecided;
            error = answer && !is_unit(*answer) ? wrong() : 0;
        } else if (truth.cos_t_squared < 0 || !answer) {
            error = (truth.cos_t_squared < 0) == !answer ? 0 : wrong();
        } else {
            const Precise kappa = 1 + cases[i].eta * truth.c / truth.mean_cos_t;
            error = is_unit(*answer)
                        ? length(sum(1, precise(*answer), -1, truth.t)) / (8 * kappa * unit_roundoff)
                        : wrong();
        }
        count(verdict, cases[i], error, answer);
    }
    return verdict;
}

Verdict judge_way_back(std::span<const InterfaceCase> cases, std::span<const std::optional<Vec3>> there,
                       std::span<const std::optional<Vec3>> back) {
    Verdict verdict;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Truth truth = truth_of(cases[i]);
        if (!there[i] || truth.cos_t_squared < 0) continue;
        ++verdict.cases;
        // On the way back the cosine to be found is c, by the same rule as cosₜ on the way there.
        const Precise eta = cases[i].eta;
        const Precise rounding = std::abs(eta * static_cast<Precise>(1 / cases[i].eta) - 1);
        const Precise moved = truth.s * (32 * unit_roundoff * truth.cos_t / eta + 4 * rounding * truth.s);
        if (truth.c * truth.c <= moved) {
            ++verdict.undecided;
            count(verdict, cases[i], back[i] && !is_unit(*back[i]) ? wrong() : 0, back[i]);
            continue;
        }
        const Precise kappa = 2 * (1 + truth.cos_t / (eta * truth.c));
        const Precise allowed = 8 * kappa * unit_roundoff + 2 * rounding * truth.s / truth.c;
        const Precise error = back[i] ? length(sum(1, precise(*back[i]), 1, truth.d)) / allowed : wrong();
        count(verdict, cases[i], error, back[i]);
    }
    return verdict;
}

std::vector<CosineCase> cosine_cases(const InterfaceFamily& family, std::size_t count, std::uint64_t seed) {
    std::vector<CosineCase> result;
    result.reserve(count);
    for (const InterfaceCase& item : family.make(count, seed)) {
        Real cosine = std::clamp(-glm::dot(item.d, item.n), Real(0), Real(1));
        if (result.size() % 64 == 0) cosine = result.size() % 128 == 0 ? 0 : 1;
        result.push_back({cosine, item.eta});
    }
    return result;
}

Verdict judge_reflectance(std::span<const CosineCase> cases, std::span<const Real> answers) {
    Verdict verdict;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ++verdict.cases;
        const Precise c = cases[i].cos_i, eta = cases[i].eta;
        const Precise cos_t_squared = (1 - eta) * (1 + eta) + eta * eta * c * c;
        Precise error = 0;
        if (is_near_critical(eta, c, cos_t_squared)) {
            ++verdict.undecided;
            error = answers[i] >= 0 && answers[i] <= 1 + 8 * unit_roundoff ? 0 : wrong();
        } else if (cos_t_squared < 0 || c == 0) {
            error = answers[i] == 1 ? 0 : wrong();
        } else {
            const Reflectance truth = reflectance_of(eta, c, cos_t_squared);
            error = std::abs(answers[i] - truth.exact) / (8 * truth.kappa * unit_roundoff);
        }
        count(verdict, cases[i], error, answers[i]);
    }
    return verdict;
}

Verdict judge_energy(std::span<const CosineCase> cases, std::span<const Real> answers) {
    Verdict verdict;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ++verdict.cases;
        const Precise c = cases[i].cos_i, eta = cases[i].eta;
        const Precise cos_t_squared = (1 - eta) * (1 + eta) + eta * eta * c * c;
        if (is_near_critical(eta, c, cos_t_squared)) {
            ++verdict.undecided;
            continue;
        }
        Precise through = 0, kappa = 1;
        if (c > 0 && cos_t_squared > 0) {
            // Transmitted amplitudes 2·eta·c/(...), times the ratio of the beams' widths and speeds.
            const Precise a = eta * c, b = std::sqrt(cos_t_squared);
            const Precise parallel = 2 * a / (c + eta * b), perpendicular = 2 * a / (a + b);
            through = b / a * (parallel * parallel + perpendicular * perpendicular) / 2;
            kappa = reflectance_of(eta, c, cos_t_squared).kappa;
        }
        const Precise error = std::abs(answers[i] + through - 1) / (4 * kappa * unit_roundoff);
        count(verdict, cases[i], error, answers[i]);
    }
    return verdict;
}

}  // namespace rt::stability

namespace rt::naive {
namespace {

std::optional<Vec3> bent(const Vec3& d, const Vec3& n, Real eta, Real cos_t) {
    return glm::normalize(eta * d + (eta * -glm::dot(d, n) - cos_t) * n);
}

Real reflectance(Real cos_i, Real eta, Real cos_t) {
    const Real r_parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const Real r_perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return (r_parallel * r_parallel + r_perpendicular * r_perpendicular) / 2;
}

}  // namespace

std::optional<Vec3> refract_root_first(const Vec3& d, const Vec3& n, Real eta) {
    const Real cos_i = -glm::dot(d, n);
    const Real cos_t = std::sqrt(1 - eta * eta * (1 - cos_i * cos_i));
    if (cos_t < 0) return std::nullopt;
    return bent(d, n, eta, cos_t);
}

std::optional<Vec3> refract_cancelling(const Vec3& d, const Vec3& n, Real eta) {
    const Real cos_i = -glm::dot(d, n);
    const Real cos_t_squared = 1 - eta * eta * (1 - cos_i * cos_i);
    if (cos_t_squared < 0) return std::nullopt;
    return bent(d, n, eta, std::sqrt(cos_t_squared));
}

Real fresnel_root_first(Real cos_i, Real eta) {
    return reflectance(cos_i, eta, std::sqrt(1 - eta * eta * (1 - cos_i * cos_i)));
}

Real fresnel_cancelling(Real cos_i, Real eta) {
    const Real cos_t_squared = 1 - eta * eta * (1 - cos_i * cos_i);
    if (cos_t_squared <= 0 || cos_i <= 0) return 1;
    return reflectance(cos_i, eta, std::sqrt(cos_t_squared));
}

}  // namespace rt::naive
