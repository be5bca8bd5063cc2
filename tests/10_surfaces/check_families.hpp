// How the chapter's families are asked and judged: one by one, and each with what fails on it.
#pragma once

#include "tests/stability/check.hpp"
#include "tests/stability/leaving.hpp"

#include <algorithm>

namespace rt::stability {

/// What the textbook's method is asked: a tenth of `full` cases, which a quick run has as well.
template <class Case>
std::vector<Case> a_tenth(const std::vector<Case>& questions, int full) {
    const auto count = std::min(static_cast<std::ptrdiff_t>(questions.size()), std::ptrdiff_t{full} / 10);
    return {questions.begin(), questions.begin() + count};
}

/// Counts both verdicts; the course's method must be right, and some of its answers decided. The textbook's
/// must fail, unless it is right on this family, too.
inline void check_family(Tally& tally, const char* name, const Verdict& right, const Verdict& textbook,
                         bool breaks_textbook = true) {
    add(tally.stable, right);
    add(tally.naive, textbook);
    check_right(name, right);
    INFO(name << ": how many cases are too close to call");
    // Of known cases. Of a few others, all may happen to be too close to call.
    if (test::case_seed == 0) CHECK(right.undecided < right.cases);
    if (breaks_textbook) check_fails(textbook.mismatches);
}

/// Rays that leave the shapes of all the families must be right, and those that begin where they hit must
/// not, on one of the families at least.
template <class Family>
void check_leaving(Tally& tally, std::span<const Family> families, int full, std::uint64_t seed) {
    std::size_t broken = 0;
    for (const Family& family : families) {
        const auto first = family.make(how_many(tally, full), seed + 1);
        const Verdict textbook = leave(a_tenth(first, full), seed, Start::AtHit);
        check_family(tally, family.name, leave(first, seed), textbook, false);
        broken += textbook.mismatches;
    }
    check_fails(broken);
}

}  // namespace rt::stability
