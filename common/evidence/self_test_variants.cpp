// Right variants, which the tests must accept.
#include "common/evidence/self_test.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/variants.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

void test_variants(const Project& project, const std::vector<Chapter>& chapters, bool quick, SelfTest& part) {
    std::vector<std::string> programs;
    for (const Chapter& chapter : chapters) {
        const std::size_t count = right_variants(project, chapter).size();
        for (std::size_t k = 0; k < (quick ? std::min<std::size_t>(count, 1) : count); ++k)
            programs.push_back(fmt::format("variants_{}_{}", chapter.number, k + 1));
    }
    const std::vector<std::string> good = built(project, programs, part);
    for (const Chapter& chapter : chapters) {
        const std::vector<std::vector<Mistake>> variants = right_variants(project, chapter);
        for (const Step& step : chapter.steps) {
            const auto count = std::count_if(variants.begin(), variants.end(), [&](const auto& together) {
                return std::any_of(together.begin(), together.end(),
                                   [&](const Mistake& variant) { return variant.step == step.id; });
            });
            part.expect(count >= 2, fmt::format("step {} has {}; at least 2 are expected", step.id,
                                                counted(count, "right variant")));
        }
        for (std::size_t k = 0; k < variants.size(); ++k) {
            const std::string name = fmt::format("variants_{}_{}", chapter.number, k + 1);
            if (std::find(good.begin(), good.end(), name) == good.end()) continue;
            for (const StepResult& step : judge_program(project, chapter, name).steps) {
                std::string which = "the solution";
                for (const Mistake& variant : variants[k])
                    if (variant.step == step.id) which = variant.why;
                part.expect(step.state == State::Passed, fmt::format("{}: step {} is refused ({}): {}", name,
                                                                     step.id, which, step.message));
            }
        }
    }
}

}  // namespace rt
