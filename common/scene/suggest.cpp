// "Did you mean …?": the nearest of some names to a word that is none of them.
// Distances by the table of prefixes, three rows of which are kept.
#include "common/scene/suggest.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace rt {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool begins_with(std::string_view name, std::string_view beginning) {
    return name.size() >= beginning.size() &&
           std::equal(beginning.begin(), beginning.end(), name.begin(), same_letter);
}

}  // namespace

bool same_letter(char a, char b) { return lower(a) == lower(b); }

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(above);
        above.swap(row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replace = above[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replace});
            if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::optional<std::string> suggest(std::string_view word, std::span<const std::string_view> candidates) {
    // Longer words are no misspelling of anything, and would make the table large.
    if (word.empty() || word.size() > 64) return std::nullopt;

    int best = std::max(1, static_cast<int>(word.size()) / 3) + 1;
    std::optional<std::string> nearest;
    for (const std::string_view candidate : candidates) {
        // The distance is at least the difference of the lengths.
        if (std::abs(static_cast<int>(candidate.size()) - static_cast<int>(word.size())) >= best) continue;
        const int distance = edit_distance(word, candidate);
        if (distance >= best) continue;
        best = distance;
        nearest = candidate;
    }
    if (nearest || word.size() < 3) return nearest;

    for (const std::string_view candidate : candidates) {
        if (!begins_with(candidate, word)) continue;
        if (nearest) return std::nullopt;
        nearest = candidate;
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    const std::optional<std::string> nearest = suggest(word, candidates);
    return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace rt
