// Right variants, which the tests must accept.
#include "common/evidence/self_test.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/variants.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

/// Those of one program.
struct Variants {
    const Chapter* chapter = nullptr;
    std::string program;
    std::vector<Mistake> variants;
};

void expect_enough(const Chapter& chapter, const std::vector<std::vector<Mistake>>& variants,
                   SelfTest& part) {
    for (const Step& step : chapter.steps) {
        const auto count = std::count_if(variants.begin(), variants.end(), [&](const auto& together) {
            return std::any_of(together.begin(), together.end(),
                               [&](const Mistake& variant) { return variant.step == step.id; });
        });
        part.expect(count >= 2, fmt::format("step {} has {}; at least 2 are expected", step.id,
                                            counted(count, "right variant")));
    }
}

void expect_accepted(const Project& project, const Variants& tried, SelfTest& part) {
    for (const StepResult& step : judge_program(project, *tried.chapter, tried.program).steps) {
        std::string which = "the solution";
        for (const Mistake& variant : tried.variants)
            if (variant.step == step.id) which = variant.why;
        part.expect(step.state == State::Passed, fmt::format("{}: step {} is refused ({}): {}", tried.program,
                                                             step.id, which, step.message));
    }
}

}  // namespace

void test_variants(const Project& project, const std::vector<Chapter>& chapters, bool quick, SelfTest& part) {
    std::vector<Variants> programs;
    for (const Chapter& chapter : chapters) {
        const std::vector<std::vector<Mistake>> variants = right_variants(project, chapter);
        expect_enough(chapter, variants, part);
        for (std::size_t k = 0; k < (quick ? std::min<std::size_t>(variants.size(), 1) : variants.size());
             ++k)
            programs.push_back({&chapter, fmt::format("variants_{}_{}", chapter.number, k + 1), variants[k]});
    }
    std::vector<std::string> names;
    for (const Variants& variants : programs) names.push_back(variants.program);
    judge_built(project, names, part,
                [&](std::size_t i, SelfTest& result) { expect_accepted(project, programs[i], result); });
}

}  // namespace rt
