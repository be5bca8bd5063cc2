// Rays and spheres: how wrong each method is, how long it takes, and where digits are lost.
#include "chapters/02_spheres/sphere.hpp"
#include "common/math/error.hpp"
#include "tests/oracle/enclosure.hpp"
#include "tests/oracle/sphere.hpp"
#include "tests/report/kernel.hpp"
#include "tests/stability/spheres.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <limits>

namespace rt::report {
namespace {

using stability::SphereCase;
using test::Random;

constexpr Method<SphereCase> sphere_methods[] = {
    {"textbook", "float", textbook_look,
     [](const SphereCase& q) { return textbook_sphere<float>(q.sphere, q.ray); }},
    {"textbook", "double", textbook_look,
     [](const SphereCase& q) { return textbook_sphere<double>(q.sphere, q.ray); }},
    {"textbook", "long double", textbook_look,
     [](const SphereCase& q) { return textbook_sphere<long double>(q.sphere, q.ray); }},
    {"textbook", "double-double", textbook_look,
     [](const SphereCase& q) { return textbook_sphere<DoubleDouble>(q.sphere, q.ray); }},
    {"stable", "float", course_look,
     [](const SphereCase& q) { return stable_sphere<float>(q.sphere, q.ray); }},
    {"stable", "double", course_look,
     [](const SphereCase& q) {
         const Roots roots = intersections(q.sphere, q.ray);
         return roots.count > 0 ? hit_at(roots.t0) : Answer{};
     },
     true},
    {"stable", "interval", interval_look,
     [](const SphereCase& q) { return answer_of(oracle::enclose_sphere(q.sphere, q.ray)); }},
    {"exact", "exact", exact_look,
     [](const SphereCase& q) {
         const oracle::SphereTruth truth = oracle::judge_sphere(q.sphere, q.ray, 0, 0);
         return truth.roots > 0 ? hit_at(truth.t0) : Answer{};
     }},
};

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
    Random random(kernel_seed);
    std::vector<SphereCase> cases(count);
    for (SphereCase& item : cases) {
        const Real distance = 1 + random.magnitude(-1, 8);
        const Real depth = random.magnitude(-16, 0);
        item = towards_rim(random, distance, random.index(8) == 0 ? -depth : depth);
    }
    return cases;
}

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

/// Decimal digits of a number with this relative error.
Real digits(Real relative_error) {
    return std::clamp(-std::log10(std::max(relative_error, Real(1e-17))), Real(0), Real(16));
}

}  // namespace

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
            Random random(kernel_seed + static_cast<std::uint64_t>(1000 * j + i));
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

void measure_spheres(const KernelOptions& options, Kernels& kernels, const Told& told) {
    measure<SphereCase>({"sphere", sphere_family, sphere_methods, sphere_cases(options.cases), judge},
                        options, kernels, told);
}

}  // namespace rt::report
