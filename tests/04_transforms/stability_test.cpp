// The maps of chapter 4 against exact arithmetic, on cases made to break them.
// Demands and condition numbers: tests/stability/transforms.hpp.
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/transforms.hpp"
#include "tests/support.hpp"

#include <string>

using namespace rt;
using namespace rt::stability;
using rt::test::cases;

namespace {

constexpr std::uint64_t seed = 4;

Tally tally("04 transforms");

std::size_t how_many(int full) {
    tally.print = cases(full) == full;
    return static_cast<std::size_t>(cases(full));
}

/// All the answers of `method` to the cases, in order.
template <class Answer, class Case, class Method>
std::vector<Answer> ask(const std::vector<Case>& questions, Method method) {
    std::vector<Answer> answers;
    answers.reserve(questions.size());
    for (const Case& question : questions) answers.push_back(method(question));
    return answers;
}

/// A tenth of the cases is enough to see the textbook method fail.
template <class Case>
std::vector<Case> some(const std::vector<Case>& questions) {
    return {questions.begin(), questions.begin() + static_cast<std::ptrdiff_t>(questions.size() / 10)};
}

/// Counts both verdicts; the stable method must be right, and the textbook method must fail.
void check(const std::string& family, const Verdict& stable, const Verdict& naive) {
    add(tally.stable, stable);
    add(tally.naive, naive);
    INFO(family << ": " << describe(stable));
    CHECK(stable.mismatches == 0);
    INFO("the textbook method has to fail here, else the family shows nothing");
    CHECK(naive.mismatches > 0);
}

}  // namespace

TEST_CASE("a matrix times its inverse is the identity, on extreme cases, and a singular one has none",
          "[04.4][stability]") {
    for (const MatrixFamily& family : matrix_families()) {
        const auto questions = family.make(how_many(50'000), seed);
        check(family.name,
              judge(questions, ask<std::optional<Mat4>>(questions, [](const Mat4& m) { return inverse(m); })),
              judge(some(questions), ask<std::optional<Mat4>>(
                                         some(questions), [](const Mat4& m) { return naive::inverse(m); })));
    }
}

TEST_CASE("normals stay at right angles to the surface, on extreme cases", "[04.5][stability]") {
    for (const MatrixFamily& family : matrix_families().first(6)) {
        const auto questions = normal_cases(family, how_many(30'000), seed + 1);
        const auto moved = [](const NormalCase& q) {
            Surface local;
            local.normal = local.shading_normal = normalize(q.normal);
            return to_world(q.transform, local).normal;
        };
        const auto naive = [](const NormalCase& q) {
            return normalize(naive::transform_normal(q.transform.to_world, q.normal));
        };
        check(family.name, judge(questions, ask<Vec3>(questions, moved)),
              judge(some(questions), ask<Vec3>(some(questions), naive)));
    }
}

TEST_CASE("hits with ellipsoids are right on extreme cases", "[04.6][stability]") {
    const auto stable = [](const EllipsoidCase& q) { return intersect(q.ellipsoid, q.ray, Interval{}); };
    const auto naive = [](const EllipsoidCase& q) {
        return naive::intersect(Sphere{Vec3(0), 1}, naive::to_local(q.ellipsoid.transform, q.ray),
                                Interval{});
    };
    for (const EllipsoidFamily& family : ellipsoid_families()) {
        const auto questions = family.make(how_many(50'000), seed + 2);
        check(family.name, judge(questions, ask<std::optional<Hit>>(questions, stable)),
              judge(some(questions), ask<std::optional<Hit>>(some(questions), naive)));
    }
}
