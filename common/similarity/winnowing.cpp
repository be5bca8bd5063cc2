// Winnowing: a few fingerprints that stand for a whole text (Schleimer, Wilkerson & Aiken 2003).
#include "common/similarity/winnowing.hpp"

#include <algorithm>

namespace rt {
namespace {

/// Odd, so that no power of it is 0 modulo 2^64.
constexpr std::uint64_t base = 0x9E3779B97F4A7C15;

/// Spreads what differs over all bits, so that the least is as good as drawn by chance (Steele, Lea & Flood
/// 2014). A bijection.
std::uint64_t spread(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
    return x ^ (x >> 31);
}

}  // namespace

std::vector<std::uint64_t> hashes_of_grams(std::span<const std::uint16_t> kinds, std::size_t length) {
    std::vector<std::uint64_t> hashes;
    std::uint64_t sum = 0, highest = 1;  // the power by which the first of a gram counts
    for (std::size_t i = 1; i < length; ++i) highest *= base;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (i >= length) sum -= kinds[i - length] * highest;
        sum = sum * base + kinds[i];
        if (i + 1 >= length) hashes.push_back(spread(sum));
    }
    return hashes;
}

std::vector<std::size_t> winnowed(std::span<const std::uint64_t> hashes, std::size_t window) {
    std::vector<std::size_t> kept;
    if (hashes.empty()) return kept;
    window = std::min(window, hashes.size());
    std::size_t least = 0;  // of the window that ends at `last`
    for (std::size_t last = 0; last < hashes.size(); ++last) {
        if (least + window <= last) {  // it has left the window
            least = last + 1 - window;
            for (std::size_t i = least + 1; i < last; ++i)
                if (hashes[i] <= hashes[least]) least = i;
        }
        if (hashes[last] <= hashes[least]) least = last;
        if (last + 1 >= window && (kept.empty() || kept.back() != least)) kept.push_back(least);
    }
    return kept;
}

}  // namespace rt
