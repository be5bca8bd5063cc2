// What two texts have in common, wherever it stands: greedy string tiling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rt {

/// Places from which on two texts have the same kinds.
struct SharedRun {
    std::size_t first = 0, second = 0;  ///< where it begins in the one, and in the other
    std::size_t length = 0;
};

/// Runs of at least `least` kinds that two texts share, so that no place of either is in two of them: the
/// longest first, of equal ones the earliest, and of runs that overlap with these what is left, if that is
/// long enough (Wise 1993). Kind 0 is shared with nothing.
///
/// `begun` are pairs of places where a run may pass through; only such runs are found. They are sorted here.
std::vector<SharedRun> shared_runs(std::span<const std::uint16_t> first,
                                   std::span<const std::uint16_t> second,
                                   std::vector<std::pair<std::size_t, std::size_t>>& begun,
                                   std::size_t least);

}  // namespace rt
