// Intersections of rays with spheres and triangles: how wrong each method is, and how long it takes.
#include "tests/report/kernels.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "common/math/error.hpp"
#include "tests/oracle/enclosure.hpp"
#include "tests/oracle/sphere.hpp"
#include "tests/oracle/triangle.hpp"
#include "tests/report/cpu_clock.hpp"
#include "tests/report/formulas.hpp"
#include "tests/report/statistics.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/spheres.hpp"
#include "tests/stability/triangles.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace rt::report {
namespace {

using stability::SphereCase;
using stability::TriangleCase;
using test::Random;

constexpr std::uint64_t seed = 20;

// -------------------------------------------------------------------------------------------- methods

Answer answer_of(const oracle::Enclosure& enclosure) {
    using Kind = Answer::Kind;
    const Kind kinds[] = {Kind::Miss, Kind::Hit, Kind::Unknown};
    const Kind kind = kinds[static_cast<int>(enclosure.decision)];
    // The halves first, so that infinite ends do not make a NaN of the width.
    return {kind, enclosure.low / 2 + enclosure.high / 2, enclosure.high / 2 - enclosure.low / 2};
}

template <class Case>
struct Method {
    const char* method;
    const char* number;
    Answer (*ask)(const Case&);
    bool course = false;
};

constexpr Method<SphereCase> sphere_methods[] = {
    {"textbook", "float", [](const SphereCase& q) { return textbook_sphere<float>(q.sphere, q.ray); }},
    {"textbook", "double", [](const SphereCase& q) { return textbook_sphere<double>(q.sphere, q.ray); }},
    {"textbook", "long double",
     [](const SphereCase& q) { return textbook_sphere<long double>(q.sphere, q.ray); }},
    {"textbook", "double-double",
     [](const SphereCase& q) { return textbook_sphere<DoubleDouble>(q.sphere, q.ray); }},
    {"stable", "float", [](const SphereCase& q) { return stable_sphere<float>(q.sphere, q.ray); }},
    {"stable", "double",
     [](const SphereCase& q) {
         const Roots roots = intersections(q.sphere, q.ray);
         return roots.count > 0 ? hit_at(roots.t0) : Answer{};
     },
     true},
    {"stable", "interval",
     [](const SphereCase& q) { return answer_of(oracle::enclose_sphere(q.sphere, q.ray)); }},
    {"exact", "exact",
     [](const SphereCase& q) {
         const oracle::SphereTruth truth = oracle::judge_sphere(q.sphere, q.ray, 0, 0);
         return truth.roots > 0 ? hit_at(truth.t0) : Answer{};
     }},
};

constexpr Method<TriangleCase> triangle_methods[] = {
    {"textbook", "float", [](const TriangleCase& q) { return textbook_triangle<float>(q.triangle, q.ray); }},
    {"textbook", "double",
     [](const TriangleCase& q) { return textbook_triangle<double>(q.triangle, q.ray); }},
    {"textbook with its constants", "double",
     [](const TriangleCase& q) {
         const std::optional<Hit> hit = naive::intersect(q.triangle, q.ray, Interval{});
         return hit ? hit_at(hit->t) : Answer{};
     }},
    {"textbook", "long double",
     [](const TriangleCase& q) { return textbook_triangle<long double>(q.triangle, q.ray); }},
    {"textbook", "double-double",
     [](const TriangleCase& q) { return textbook_triangle<DoubleDouble>(q.triangle, q.ray); }},
    {"watertight", "float",
     [](const TriangleCase& q) { return watertight_triangle<float>(q.triangle, q.ray); }},
    {"watertight", "double",
     [](const TriangleCase& q) {
         const std::optional<Hit> hit = intersect(q.triangle, q.ray, Interval{});
         return hit ? hit_at(hit->t) : Answer{};
     },
     true},
    {"volumes", "interval",
     [](const TriangleCase& q) { return answer_of(oracle::enclose_triangle(q.triangle, q.ray)); }},
    {"exact", "exact",
     [](const TriangleCase& q) {
         const oracle::TriangleTruth truth = oracle::judge_triangle(q.triangle, q.ray, 0);
         return truth.hit ? hit_at(truth.t) : Answer{};
     }},
};

// ------------------------------------------------------------------------------------------- families

constexpr const char* sphere_family =
    "distance/radius from 1 to 1e8; the ray passes 1e-16 to 1 radii inside the rim, one in eight outside it";

/// A ray towards a point beside the centre, `depth` radii inside the rim.
SphereCase towards_rim(Random& random, Real distance, Real depth) {
    const Real radius = random.magnitude(-1, 1);
    const Vec3 d = random.direction(), center = Real(10) * radius * random.in_cube();
    const Vec3 aside = normalize(cross(d, random.direction()));
    const Vec3 target = center + radius * (1 - depth) * aside;
    const Vec3 origin = center - radius * distance * d;
    return {{center, radius}, {origin, (target - origin) * (random.uniform(0.5, 2) / (radius * distance))}};
}

std::vector<SphereCase> sphere_cases(std::size_t count) {
    Random random(seed);
    std::vector<SphereCase> cases(count);
    for (SphereCase& item : cases) {
        const Real distance = 1 + random.magnitude(-1, 8);
        const Real depth = random.magnitude(-16, 0);
        item = towards_rim(random, distance, random.index(8) == 0 ? -depth : depth);
    }
    return cases;
}

constexpr const char* triangle_family =
    "aspect from 1 to 1e4, distance from 0.1 to 1000 edges, half of them seen at cosines from 1e-8 to 1 to "
    "the "
    "normal, half of the rays within 1e-16 to 0.1 edges of an edge, inside or outside";

std::vector<TriangleCase> triangle_cases(std::size_t count) {
    Random random(seed + 1);
    std::vector<TriangleCase> cases(count);
    for (TriangleCase& item : cases) {
        const Vec3 along = random.direction(), across = normalize(cross(along, random.direction()));
        const Vec3 normal = cross(along, across), a = random.in_cube();
        const Real height = random.magnitude(-4, 0);
        const Vec3 to_c = random.uniform(0, 1) * along + height * across;
        Real v = random.uniform(0, 1), w = random.uniform(0, 1 - v);
        if (random.index(2) == 0) v = (random.index(2) == 0 ? 1 : -1) * random.magnitude(-16, -1);
        const Vec3 target = a + v * along + w * to_c;
        const Vec3 d = random.index(2) == 0
                           ? random.direction()
                           : random.magnitude(-8, 0) * normal + normalize(cross(normal, random.direction()));
        const Vec3 origin = target - random.magnitude(-1, 3) * d;
        item = {{a, a + along, a + to_c}, {origin, (target - origin) * random.uniform(0.5, 2)}};
    }
    return cases;
}

// ---------------------------------------------------------------------------------------------- judge

struct Judged {
    Real error = -1;  ///< in units of κu|t|; negative where there is none to judge
    bool wrong = false;
};

/// How far a point of the line, or the sphere, moves when all data move by a relative 1.
Real reach(const SphereCase& item, const oracle::SphereTruth& truth) {
    return length(item.ray.origin - item.sphere.center) + std::abs(truth.t0) * std::sqrt(truth.a) +
           item.sphere.radius;
}

/// κ|t|: how far t moves then.
Real sensitivity(const SphereCase& item, const oracle::SphereTruth& truth) {
    return reach(item, truth) * item.sphere.radius / std::sqrt(truth.discriminant);
}

Judged judge(const SphereCase& item, const Answer& answer) {
    const oracle::SphereTruth truth = oracle::judge_sphere(item.sphere, item.ray, answer.t, answer.t);
    Judged result;
    if (answer.kind == Answer::Kind::Unknown) return result;
    // The course's own judge decides on hit or miss: it is given the exact roots.
    const Roots roots = answer.is_hit() ? Roots{2, truth.t0, truth.t1} : Roots{};
    result.wrong = stability::judge(std::span(&item, 1), std::span(&roots, 1)).mismatches > 0;
    if (answer.is_hit() && truth.roots == 2)
        result.error = (std::abs(truth.error0) + answer.radius) / (unit_roundoff * sensitivity(item, truth));
    return result;
}

Real sensitivity(const TriangleCase& item, const oracle::TriangleTruth& truth) {
    const auto& [a, b, c] = item.triangle;
    const Vec3& o = item.ray.origin;
    const Real far = std::max({length(a - o), length(b - o), length(c - o)}) +
                     std::abs(truth.t) * length(item.ray.direction);
    return far * (length(cross(b - a, c - a)) / std::abs(truth.sum));
}

Judged judge(const TriangleCase& item, const Answer& answer) {
    const oracle::TriangleTruth truth = oracle::judge_triangle(item.triangle, item.ray, answer.t);
    Judged result;
    if (answer.kind == Answer::Kind::Unknown || truth.degenerate || truth.sum == 0) return result;
    std::optional<Hit> hit;
    if (answer.is_hit())
        hit = Hit{.t = truth.t, .uv = {truth.volumes.y / truth.sum, truth.volumes.z / truth.sum}};
    result.wrong = stability::judge(std::span(&item, 1), std::span(&hit, 1)).mismatches > 0;
    if (answer.is_hit() && !result.wrong)
        result.error = (std::abs(truth.error) + answer.radius) / (unit_roundoff * sensitivity(item, truth));
    return result;
}

// ------------------------------------------------------------------------------------------ measuring

volatile Real sink = 0;  // what is measured must not be optimised away

/// CPU seconds for `rounds` times all the cases.
template <class Case>
double seconds(const Method<Case>& method, std::span<const Case> cases, int rounds) {
    const double start = cpu_seconds();
    Real sum = 0;
    for (int round = 0; round < rounds; ++round)
        for (const Case& item : cases) sum += method.ask(item).t;
    sink = sum;
    return cpu_seconds() - start;
}

/// Nanoseconds a call, for each method. The repeats of all methods take turns, so that whatever else the
/// machine does falls on all of them.
template <class Case>
std::vector<double> nanoseconds(std::span<const Method<Case>> methods, std::span<const Case> all,
                                const KernelOptions& options, const Told& told) {
    const std::span<const Case> cases = all.first(std::min<std::size_t>(all.size(), 4096));
    std::vector<int> rounds;
    for (const Method<Case>& method : methods) {
        const double once = seconds(method, cases, 1);
        rounds.push_back(std::max(1, static_cast<int>(options.repeat_ms * 1e-3 / once)));
    }
    std::vector<std::vector<double>> times(methods.size());
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        for (std::size_t i = 0; i < methods.size(); ++i)
            times[i].push_back(seconds(methods[i], cases, rounds[i]) * 1e9 /
                               (rounds[i] * static_cast<double>(cases.size())));
        told((repeat + 1.0) / options.repeats);
    }
    std::vector<double> medians;
    for (std::vector<double>& time : times) medians.push_back(median(std::move(time)));
    return medians;
}

template <class Case>
void measure(const char* shape, std::span<const Method<Case>> methods, const std::vector<Case>& cases,
             const KernelOptions& options, std::vector<KernelRow>& rows, const Told& told) {
    const std::vector<double> ns =
        nanoseconds(methods, std::span<const Case>(cases), options, [&](double part) { told(part / 2); });
    for (std::size_t i = 0; i < methods.size(); ++i) {
        KernelRow row;
        row.shape = shape;
        row.method = methods[i].method;
        row.number = methods[i].number;
        row.course = methods[i].course;
        row.ns = ns[i];
        row.cases = cases.size();
        std::vector<double> errors;
        for (const Case& item : cases) {
            const Answer answer = methods[i].ask(item);
            const Judged judged = judge(item, answer);
            row.wrong += judged.wrong;
            row.undecided += answer.kind == Answer::Kind::Unknown;
            if (judged.error >= 0 && !judged.wrong) errors.push_back(judged.error);
        }
        row.error_max = quantile(errors, 1);
        row.error_9999 = quantile(errors, 0.9999);
        row.error_median = quantile(errors, 0.5);
        rows.push_back(std::move(row));
        told(0.5 + (static_cast<double>(i) + 1) / (2 * static_cast<double>(methods.size())));
    }
}

// ------------------------------------------------------------------------------------------ the map

/// Decimal digits of a number with this relative error.
Real digits(Real relative_error) {
    return std::clamp(-std::log10(std::max(relative_error, Real(1e-17))), Real(0), Real(16));
}

std::vector<DigitsMap> measure_maps(const KernelOptions& options, const Told& told) {
    const auto textbook = [](const SphereCase& q) { return textbook_sphere<double>(q.sphere, q.ray); };
    const auto stable = [](const SphereCase& q) {
        const Roots roots = intersections(q.sphere, q.ray);
        return roots.count > 0 ? hit_at(roots.t0) : Answer{};
    };
    constexpr Real distances = 8, tangencies = 16;  // decades
    std::vector<DigitsMap> maps{
        {"textbook", {}, {}, {}}, {"stable", {}, {}, {}}, {"what the data allow", {}, {}, {}}};
    for (DigitsMap& map : maps) {
        for (int i = 0; i < options.map_columns; ++i)
            map.distance.push_back((i + 0.5) * distances / options.map_columns);
        for (int j = 0; j < options.map_rows; ++j)
            map.tangency.push_back((j + 0.5) * tangencies / options.map_rows - tangencies);
    }
    for (int j = 0; j < options.map_rows; ++j) {
        for (int i = 0; i < options.map_columns; ++i) {
            Random random(seed + static_cast<std::uint64_t>(1000 * j + i));
            Real worst[3] = {16, 16, 16};
            int met = 0;
            for (int k = 0; k < options.map_samples; ++k) {
                const auto index = [](int n) { return static_cast<std::size_t>(n); };
                const Real distance = 1 + std::pow(10, maps[0].distance[index(i)]);
                const SphereCase item =
                    towards_rim(random, distance, std::pow(10, maps[0].tangency[index(j)]));
                oracle::SphereTruth truth;
                bool surely_met = false;
                for (const int m : {0, 1}) {
                    const Answer answer = m == 0 ? textbook(item) : stable(item);
                    truth = oracle::judge_sphere(item.sphere, item.ray, answer.t, answer.t);
                    // Where 4 ulp of the data decide between hit and miss there is nothing to be right about.
                    surely_met = truth.roots == 2 && truth.depth > 8 * unit_roundoff * reach(item, truth);
                    const Real right = answer.is_hit() ? digits(std::abs(truth.error0 / truth.t0)) : 0;
                    if (surely_met) worst[m] = std::min(worst[m], right);
                }
                if (!surely_met) continue;
                ++met;
                worst[2] =
                    std::min(worst[2], digits(unit_roundoff * sensitivity(item, truth) / std::abs(truth.t0)));
            }
            for (std::size_t m = 0; m < 3; ++m)
                maps[m].digits.push_back(met > 0 ? worst[m] : std::numeric_limits<Real>::quiet_NaN());
        }
        told((j + 1.0) / options.map_rows);
    }
    return maps;
}

}  // namespace

Kernels measure_kernels(const KernelOptions& options, const Told& told) {
    const auto part = [&](double from, double to) -> Told {
        return [&told, from, to](double done) {
            if (told) told(from + (to - from) * done);
        };
    };
    Kernels kernels{sphere_family, triangle_family, {}, {}};
    measure<SphereCase>("sphere", sphere_methods, sphere_cases(options.cases), options, kernels.rows,
                        part(0, 0.4));
    measure<TriangleCase>("triangle", triangle_methods, triangle_cases(options.cases), options, kernels.rows,
                          part(0.4, 0.9));
    kernels.maps = measure_maps(options, part(0.9, 1));
    return kernels;
}

}  // namespace rt::report
