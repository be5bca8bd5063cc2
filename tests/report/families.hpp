// The stability families at full size, in batches, with their verdicts side by side.
#pragma once

#include "tests/report/kernels.hpp"
#include "tests/stability/verdict.hpp"

namespace rt::report {

/// What one family says of the course's method and of the textbook's.
struct FamilyRow {
    std::string chapter;   ///< "02"
    std::string question;  ///< what is asked, such as "nearest hit with a sphere"
    std::string family;
    std::string condition;  ///< what κ is like in the family, or what is extreme
    std::string
        demand;  ///< the unit of `stable.worst`, such as "8κu"; empty where answers are right or wrong
    std::string textbook;  ///< which method `naive` is; empty where there is none
    stability::Verdict stable, naive;
};

struct FamiliesOptions {
    std::size_t judged = 1'000'000;  ///< cases a family whose answers are judged by exact arithmetic
    std::size_t aimed = 10'000'000;  ///< rays at edges, at corners, and of the families of shadow rays and
                                     ///< grids together
};

/// What `course report --quick` measures.
inline constexpr FamiliesOptions quick_families{10'000, 80'000};

/// Batches run on all cores; the seeds, and so the verdicts, do not depend on their number.
std::vector<FamilyRow> measure_families(const FamiliesOptions& options = {}, const Told& told = {});

}  // namespace rt::report
