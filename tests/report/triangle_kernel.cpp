// Rays and triangles: how wrong each method is, and how long it takes.
#include "chapters/03_triangles/triangle.hpp"
#include "common/math/error.hpp"
#include "tests/oracle/enclosure.hpp"
#include "tests/oracle/triangle.hpp"
#include "tests/report/kernel.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/triangles.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <optional>

namespace rt::report {
namespace {

using stability::TriangleCase;
using test::Random;

constexpr Method<TriangleCase> triangle_methods[] = {
    {"textbook", "float", textbook_look,
     [](const TriangleCase& q) { return textbook_triangle<float>(q.triangle, q.ray); }},
    {"textbook", "double", textbook_look,
     [](const TriangleCase& q) { return textbook_triangle<double>(q.triangle, q.ray); }},
    {"textbook with its constants", "double", constants_look,
     [](const TriangleCase& q) {
         const std::optional<Hit> hit = naive::intersect(q.triangle, q.ray, Interval{});
         return hit ? hit_at(hit->t) : Answer{};
     }},
    {"textbook", "long double", textbook_look,
     [](const TriangleCase& q) { return textbook_triangle<long double>(q.triangle, q.ray); }},
    {"textbook", "double-double", textbook_look,
     [](const TriangleCase& q) { return textbook_triangle<DoubleDouble>(q.triangle, q.ray); }},
    {"watertight", "float", course_look,
     [](const TriangleCase& q) { return watertight_triangle<float>(q.triangle, q.ray); }},
    {"watertight", "double", course_look,
     [](const TriangleCase& q) {
         const std::optional<Hit> hit = intersect(q.triangle, q.ray, Interval{});
         return hit ? hit_at(hit->t) : Answer{};
     },
     true},
    {"volumes", "interval", interval_look,
     [](const TriangleCase& q) { return answer_of(oracle::enclose_triangle(q.triangle, q.ray)); }},
    {"exact", "exact", exact_look,
     [](const TriangleCase& q) {
         const oracle::TriangleTruth truth = oracle::judge_triangle(q.triangle, q.ray, 0);
         return truth.hit ? hit_at(truth.t) : Answer{};
     }},
};

constexpr const char* triangle_family =
    "aspect from 1 to 1e4, distance from 0.1 to 1000 edges, half of them seen at cosines from 1e-8 to 1 to "
    "the "
    "normal, half of the rays within 1e-16 to 0.1 edges of an edge, inside or outside";

std::vector<TriangleCase> triangle_cases(std::size_t count) {
    Random random(kernel_seed + 1);
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

}  // namespace

void measure_triangles(const KernelOptions& options, Kernels& kernels, const Told& told) {
    measure<TriangleCase>(
        {"triangle", triangle_family, triangle_methods, triangle_cases(options.cases), judge}, options,
        kernels, told);
}

}  // namespace rt::report
