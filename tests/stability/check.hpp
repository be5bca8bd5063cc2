// How a chapter's test asks a family and checks the verdicts. For test programs only: the families themselves
// know no test framework.
#pragma once

#include "tests/catch.hpp"
#include "tests/stability/verdict.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <cstdint>
#include <vector>

namespace rt::stability {

/// As many cases as `test::cases` says. The tally is printed where these are all of them.
inline std::size_t how_many(Tally& tally, int full) {
    tally.print = test::cases(full) == full;
    return static_cast<std::size_t>(test::cases(full));
}

/// All the answers of `method` to the cases, in order.
template <class Answer, class Case, class Method>
std::vector<Answer> ask(const std::vector<Case>& questions, Method method) {
    std::vector<Answer> answers(questions.size());
    test::together(questions.size(), [&](std::size_t i) { answers[i] = method(questions[i]); });
    return answers;
}

/// A tenth of the cases is enough to see the textbook method fail.
template <class Case>
std::vector<Case> some(const std::vector<Case>& questions) {
    return {questions.begin(), questions.begin() + static_cast<std::ptrdiff_t>(questions.size() / 10)};
}

/// How often a textbook method was wrong on a family; it must have been.
inline void check_fails(std::size_t mismatches) {
    // Of other random cases than the known ones it may happen that it finds its way through all.
    if (test::case_seed != 0) return;
    INFO("the textbook method has to fail here, else the family shows nothing");
    CHECK(mismatches > 0);
}

/// No case of the family may be wrong.
inline void check_right(const std::string& family, const Verdict& verdict) {
    INFO("of a family of extreme cases: " << family);
    CHECK(test::or_say(verdict.mismatches == 0, describe(verdict)));
}

/// Counts both verdicts; the stable method must be right, and the textbook method must fail.
inline void check(Tally& tally, const std::string& family, const Verdict& stable, const Verdict& naive) {
    add(tally.stable, stable);
    add(tally.naive, naive);
    check_right(family, stable);
    check_fails(naive.mismatches);
}

}  // namespace rt::stability
