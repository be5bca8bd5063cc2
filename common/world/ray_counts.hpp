// How many rays were traced, and how many random numbers were drawn for them.
#pragma once

#include <cstdint>

namespace rt {

/// How many rays of each kind were traced.
struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;
    std::uint64_t reflection = 0;
    std::uint64_t refraction = 0;
    std::uint64_t random_numbers = 0;  ///< that were drawn for samples
};

/// The calling thread's counts so far; whoever starts a ray adds it here.
RayCounts& ray_counts();

}  // namespace rt
