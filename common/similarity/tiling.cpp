// What two texts have in common, wherever it stands: greedy string tiling.
#include "common/similarity/tiling.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace rt {
namespace {

using Kinds = std::span<const std::uint16_t>;
using Place = std::pair<std::size_t, std::size_t>;

/// The longest run that passes through two places.
SharedRun run_through(Kinds a, Kinds b, const Place& place) {
    const auto same = [&](std::size_t i, std::size_t j) {
        return i < a.size() && j < b.size() && a[i] != 0 && a[i] == b[j];
    };
    const auto [i, j] = place;
    if (!same(i, j)) return {i, j, 0};
    std::size_t before = 0, after = 1;
    while (before < std::min(i, j) && same(i - before - 1, j - before - 1)) ++before;
    while (same(i + after, j + after)) ++after;
    return {i - before, j - before, before + after};
}

std::vector<SharedRun> longest_runs(Kinds a, Kinds b, std::vector<Place>& places, std::size_t least) {
    // A run stays on a diagonal, on which one ends before the next begins.
    const auto diagonal = [](const Place& place) {
        return static_cast<std::ptrdiff_t>(place.first) - static_cast<std::ptrdiff_t>(place.second);
    };
    std::sort(places.begin(), places.end(), [&](const Place& x, const Place& y) {
        return std::pair(diagonal(x), x.first) < std::pair(diagonal(y), y.first);
    });
    std::vector<SharedRun> runs;
    std::size_t end = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const bool is_known =
            k > 0 && diagonal(places[k]) == diagonal(places[k - 1]) && places[k].first < end;
        if (is_known) continue;
        const SharedRun run = run_through(a, b, places[k]);
        end = run.first + run.length;
        if (run.length >= least) runs.push_back(run);
    }
    return runs;
}

bool comes_later(const SharedRun& x, const SharedRun& y) {
    return std::tuple(x.length, y.first, y.second) < std::tuple(y.length, x.first, x.second);
}

}  // namespace

std::vector<SharedRun> shared_runs(Kinds first, Kinds second, std::vector<Place>& begun, std::size_t least) {
    std::vector<char> used_first(first.size()), used_second(second.size());
    std::priority_queue queue(comes_later, longest_runs(first, second, begun, least));
    std::vector<SharedRun> taken;
    while (!queue.empty()) {
        const SharedRun run = queue.top();
        queue.pop();
        for (std::size_t begin = 0; begin < run.length;) {
            std::size_t end = begin;
            while (end < run.length && !used_first[run.first + end] && !used_second[run.second + end]) ++end;
            const SharedRun free{run.first + begin, run.second + begin, end - begin};
            if (free.length == run.length) {
                taken.push_back(free);
                std::fill_n(&used_first[free.first], free.length, char{1});
                std::fill_n(&used_second[free.second], free.length, char{1});
            } else if (free.length >= least) {
                queue.push(free);
            }
            begin = end + 1;
        }
    }
    return taken;
}

}  // namespace rt
