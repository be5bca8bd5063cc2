// The optics of chapter 7 against 64-bit mantissas, on cases made to break them.
// Demands and condition numbers: tests/stability/optics.hpp.
#include "chapters/07_recursion/optics.hpp"
#include "tests/stability/check.hpp"
#include "tests/stability/optics.hpp"

#include <limits>

using namespace rt;
using namespace rt::stability;

namespace {

constexpr std::uint64_t seed = 7;
constexpr bool have_precise = std::numeric_limits<long double>::digits >= 64;

Tally tally("07 recursion");

template <class Method>
std::vector<std::optional<Vec3>> refracted(const std::vector<InterfaceCase>& questions, Method method) {
    std::vector<std::optional<Vec3>> answers;
    answers.reserve(questions.size());
    for (const InterfaceCase& q : questions) answers.push_back(method(q.d, q.n, q.eta));
    return answers;
}

template <class Method>
std::vector<Real> reflected(const std::vector<CosineCase>& questions, Method method) {
    std::vector<Real> answers;
    answers.reserve(questions.size());
    for (const CosineCase& q : questions) answers.push_back(method(q.cos_i, q.eta));
    return answers;
}

void check(const InterfaceFamily& family, const Verdict& verdict) {
    add(tally.stable, verdict);
    check_right(family.name, verdict);
    INFO(family.name << ": how many cases are too close to call");
    CHECK(verdict.undecided < verdict.cases);
}

/// A textbook method; it must fail somewhere on the families, else they show nothing.
struct Naive {
    const char* name;
    Verdict total = {};
    void judged(const Verdict& verdict) {
        add(total, verdict);
        add(tally.naive, verdict);
    }
    void must_have_failed() const {
        INFO(name << ": " << describe(total));
        check_fails(total.mismatches);
    }
};

}  // namespace

TEST_CASE("refraction is right at and beside the critical angle, grazing, and between equal media",
          "[07.2][stability]") {
    if (!have_precise) return;
    Naive root_first{"taking the root first"}, cancelling{"1 - eta²(1 - cos²)"};
    for (const InterfaceFamily& family : interface_families()) {
        const auto questions = family.make(how_many(tally, 100'000), seed);
        check(family, judge_refraction(questions, refracted(questions, refract)));
        root_first.judged(judge_refraction(questions, refracted(questions, naive::refract_root_first)));
        cancelling.judged(judge_refraction(questions, refracted(questions, naive::refract_cancelling)));
    }
    root_first.must_have_failed();
    cancelling.must_have_failed();
}

TEST_CASE("light goes back the same way", "[07.2][stability]") {
    if (!have_precise) return;
    Naive cancelling{"1 - eta²(1 - cos²)"};
    const auto way_back = [](const std::vector<InterfaceCase>& questions, auto method) {
        const auto there = refracted(questions, method);
        std::vector<std::optional<Vec3>> back(questions.size());
        for (std::size_t i = 0; i < questions.size(); ++i)
            if (there[i]) back[i] = method(-*there[i], -questions[i].n, 1 / questions[i].eta);
        return judge_way_back(questions, there, back);
    };
    for (const InterfaceFamily& family : interface_families()) {
        const auto questions = family.make(how_many(tally, 100'000), seed + 1);
        check(family, way_back(questions, refract));
        cancelling.judged(way_back(questions, naive::refract_cancelling));
    }
    cancelling.must_have_failed();
}

TEST_CASE("Fresnel's reflectance is right on the same cases", "[07.3][stability]") {
    if (!have_precise) return;
    Naive root_first{"taking the root first"}, cancelling{"1 - eta²(1 - cos²)"};
    for (const InterfaceFamily& family : interface_families()) {
        const auto questions = cosine_cases(family, how_many(tally, 100'000), seed + 2);
        check(family, judge_reflectance(questions, reflected(questions, fresnel)));
        root_first.judged(judge_reflectance(questions, reflected(questions, naive::fresnel_root_first)));
        cancelling.judged(judge_reflectance(questions, reflected(questions, naive::fresnel_cancelling)));
    }
    root_first.must_have_failed();
    cancelling.must_have_failed();
}

TEST_CASE("what is reflected and what goes through make 1, to 4 roundings of each step",
          "[07.3][stability]") {
    if (!have_precise) return;
    Naive cancelling{"1 - eta²(1 - cos²)"};
    for (const InterfaceFamily& family : interface_families()) {
        const auto questions = cosine_cases(family, how_many(tally, 100'000), seed + 3);
        check(family, judge_energy(questions, reflected(questions, fresnel)));
        cancelling.judged(judge_energy(questions, reflected(questions, naive::fresnel_cancelling)));
    }
    cancelling.must_have_failed();
}
