// The outline of a polygon in the plane: a sweep from left to right, and upwards where x is equal.
#include "common/scene/outline.hpp"

#include "common/math/exact.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace rt {

namespace {

/// The order in which the sweep meets points.
bool is_before(const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// A side of the outline, or the part of one right of a corner that touches it.
struct Side {
    Vec2 left{0};
    Vec2 right{0};
    int upwards = 0;  ///< what the number of turns gains across it: 1 where the outline goes rightwards
    std::uint32_t side = 0;
    int turns_above = 0;
};

/// The order of sides along the sweeping line, and of a point among them.
struct IsBelow {
    using is_transparent = void;

    bool operator()(const Side& a, const Vec2& p) const { return orientation(a.left, a.right, p) > 0; }
    bool operator()(const Vec2& p, const Side& a) const { return orientation(a.left, a.right, p) < 0; }
    bool operator()(const Side& a, const Side& b) const {
        // Whichever begins later is seen from the other one's line, by its begin and then by its end.
        if (is_before(a.left, b.left)) {
            const int sign = orientation(a.left, a.right, b.left);
            return (sign != 0 ? sign : orientation(a.left, a.right, b.right)) > 0;
        }
        const int sign = orientation(b.left, b.right, a.left);
        return (sign != 0 ? sign : orientation(b.left, b.right, a.right)) < 0;
    }
};

/// Whether `low`, now below `high`, will be above it before one of them ends.
bool will_cross(const Side& low, const Side& high) {
    if (is_before(low.right, high.right)) return orientation(high.left, high.right, low.right) > 0;
    return orientation(low.left, low.right, high.right) < 0;
}

class Sweep {
public:
    explicit Sweep(std::span<const Vec2> outline) : corners(outline) {}

    OutlineCheck run() {
        std::vector<std::uint32_t> order(corners.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return corners[a] != corners[b] ? is_before(corners[a], corners[b]) : a < b;
        });
        for (auto first = order.begin(); first != order.end() && !result.crosses;) {
            const auto last = std::find_if(first, order.end(),
                                           [&](std::uint32_t i) { return corners[i] != corners[*first]; });
            visit({first, last});
            first = last;
        }
        // Found from left to right; sides that go leftwards have them the other way around.
        std::stable_sort(result.touches.begin(), result.touches.end(),
                         [](const Touch& a, const Touch& b) { return a.side < b.side; });
        for (auto first = result.touches.begin(); first != result.touches.end();) {
            const auto last = std::find_if(first, result.touches.end(),
                                           [&](const Touch& touch) { return touch.side != first->side; });
            if (is_before(corners[next(first->side)], corners[first->side])) std::reverse(first, last);
            first = last;
        }
        return std::move(result);
    }

private:
    std::uint32_t next(std::uint32_t i) const { return i + 1 == corners.size() ? 0 : i + 1; }
    std::uint32_t previous(std::uint32_t i) const {
        return i == 0 ? static_cast<std::uint32_t>(corners.size()) - 1 : i - 1;
    }

    /// The sweep meets a place with one corner or more.
    void visit(std::span<const std::uint32_t> here) {
        const Vec2 place = corners[here.front()];
        std::vector<Side> begin = sides_from(here);

        // What goes through the place ends there; what does not end there begins there again.
        auto [first, last] = active.equal_range(place);
        for (auto side = first; side != last; ++side) {
            if (side->right == place) continue;
            result.touches.push_back({side->side, here.front()});
            begin.push_back({place, side->right, side->upwards, side->side});
        }
        last = active.erase(first, last);

        std::sort(begin.begin(), begin.end(),
                  [&](const Side& a, const Side& b) { return orientation(place, a.right, b.right) > 0; });
        const bool has_below = last != active.begin();
        const Side* below = has_below ? &*std::prev(last) : nullptr;
        const Side* const above = last != active.end() ? &*last : nullptr;
        int turns = below ? below->turns_above : 0;
        for (std::size_t i = 0; i < begin.size(); ++i) {
            turns += begin[i].upwards;
            begin[i].turns_above = turns;
            // Between sides that lie on one another there is nothing.
            if (i + 1 == begin.size() || orientation(place, begin[i].right, begin[i + 1].right) != 0)
                check(turns);
            const Side& inserted = *active.insert(last, begin[i]);
            if (i == 0 && below && will_cross(*below, inserted)) result.crosses = true;
            if (i + 1 == begin.size() && above && will_cross(inserted, *above)) result.crosses = true;
        }
        if (begin.empty() && below && above && will_cross(*below, *above)) result.crosses = true;
    }

    /// The sides that begin at these corners, which are at one place.
    std::vector<Side> sides_from(std::span<const std::uint32_t> here) const {
        std::vector<Side> sides;
        for (const std::uint32_t i : here) {
            const Vec2& place = corners[i];
            if (is_before(place, corners[next(i)])) sides.push_back({place, corners[next(i)], 1, i});
            if (is_before(place, corners[previous(i)]))
                sides.push_back({place, corners[previous(i)], -1, previous(i)});
        }
        return sides;
    }

    void check(int turns) {
        if (turns == 0) return;
        if (result.turns == 0) result.turns = turns > 0 ? 1 : -1;
        if (turns != result.turns) result.crosses = true;
    }

    std::span<const Vec2> corners;
    std::multiset<Side, IsBelow> active;
    OutlineCheck result;
};

}  // namespace

OutlineCheck check_outline(std::span<const Vec2> corners) { return Sweep(corners).run(); }

}  // namespace rt
