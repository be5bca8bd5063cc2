// Triangles from the outline of a polygon in the plane. What makes it fast: only corners that are not convex
// can be in the way, a tree of boxes finds one that is, and a corner is asked again only when that one is
// gone.
#include "common/scene/ear_clipping.hpp"

#include "common/math/exact.hpp"

#include <algorithm>
#include <numeric>
#include <queue>

namespace rt {

namespace {

using Index = std::uint32_t;

struct Box {
    Vec2 low{infinity};
    Vec2 high{-infinity};
};

/// A triangle with counterclockwise corners.
struct Ear {
    Vec2 before{0}, tip{0}, after{0};
};

/// Whether the whole box is right of the line from a to b.
bool is_right_of(const Box& box, const Vec2& a, const Vec2& b) {
    // The corner of the box that lies farthest to the left.
    return orientation(a, b, {b.y > a.y ? box.low.x : box.high.x, b.x > a.x ? box.high.y : box.low.y}) < 0;
}

bool may_overlap(const Box& box, const Ear& ear) {
    const Vec2 low = glm::min(glm::min(ear.before, ear.tip), ear.after);
    const Vec2 high = glm::max(glm::max(ear.before, ear.tip), ear.after);
    if (box.high.x < low.x || box.low.x > high.x || box.high.y < low.y || box.low.y > high.y) return false;
    return !is_right_of(box, ear.before, ear.tip) && !is_right_of(box, ear.tip, ear.after) &&
           !is_right_of(box, ear.after, ear.before);
}

/// Finds marked points in a triangle: a tree of boxes, each halved along its longer side.
class PointTree {
public:
    explicit PointTree(std::span<const Vec2> all) : points(all), order(all.size()), place(all.size()) {
        std::iota(order.begin(), order.end(), Index{0});
        build(0, 0, order.size());
        for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
        marked.resize(points.size());
    }

    bool is_marked(Index point) const { return marked[point]; }

    void mark(Index point, bool value) {
        if (marked[point] == value) return;
        marked[point] = value;
        std::size_t node = 0, first = 0, last = order.size();
        while (true) {
            value ? ++nodes[node].count : --nodes[node].count;
            if (last - first <= leaf) return;
            const std::size_t middle = (first + last) / 2;
            node = 2 * node + (place[point] < middle ? 1 : 2);
            (place[point] < middle ? last : first) = middle;
        }
    }

    /// Some marked point near the triangle for which `is_it` holds, or nothing.
    template <class IsIt>
    std::optional<Index> find(const Ear& ear, const IsIt& is_it) const {
        return find(ear, is_it, 0, 0, order.size());
    }

private:
    static constexpr std::size_t leaf = 8;
    struct Node {
        Box box;
        std::size_t count = 0;  ///< of marked points
    };

    void build(std::size_t node, std::size_t first, std::size_t last) {
        if (nodes.size() <= node) nodes.resize(node + 1);
        Box box;
        for (std::size_t i = first; i < last; ++i)
            box = {glm::min(box.low, points[order[i]]), glm::max(box.high, points[order[i]])};
        nodes[node].box = box;
        if (last - first <= leaf) return;
        const std::size_t middle = (first + last) / 2;
        const int axis = box.high.x - box.low.x >= box.high.y - box.low.y ? 0 : 1;
        const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(last), [&](Index a, Index b) {
            return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
        });
        build(2 * node + 1, first, middle);
        build(2 * node + 2, middle, last);
    }

    template <class IsIt>
    std::optional<Index> find(const Ear& ear, const IsIt& is_it, std::size_t node, std::size_t first,
                              std::size_t last) const {
        if (nodes[node].count == 0 || !may_overlap(nodes[node].box, ear)) return std::nullopt;
        if (last - first <= leaf) {
            for (std::size_t i = first; i < last; ++i)
                if (marked[order[i]] && is_it(order[i])) return order[i];
            return std::nullopt;
        }
        const std::size_t middle = (first + last) / 2;
        if (const auto found = find(ear, is_it, 2 * node + 1, first, middle)) return found;
        return find(ear, is_it, 2 * node + 2, middle, last);
    }

    std::span<const Vec2> points;
    std::vector<Index> order;        ///< of the points in the tree
    std::vector<std::size_t> place;  ///< of each point in `order`
    std::vector<bool> marked;
    std::vector<Node> nodes;  ///< node k has the children 2k + 1 and 2k + 2
};

class EarClipper {
public:
    explicit EarClipper(std::span<const Vec2> outline)
        : points(outline),
          tree(outline),
          before(outline.size()),
          after(outline.size()),
          is_gone(outline.size()),
          asked(outline.size()),
          waits_for(outline.size()),
          waiting(outline.size()),
          left(outline.size()) {
        for (Index i = 0; i < left; ++i) {
            before[i] = i == 0 ? static_cast<Index>(left) - 1 : i - 1;
            after[i] = i + 1 == left ? 0 : i + 1;
        }
    }

    std::optional<std::vector<std::array<Index, 3>>> run() {
        for (Index i = 0; i < points.size(); ++i) look_again(i);
        while (left > 2) {
            // What has no area is taken away before an ear could be found beside it.
            if (!spikes.empty()) {
                const Index i = spikes.back();
                spikes.pop_back();
                if (!is_gone[i] && turn(i) == 0 && turns_back(i)) remove(i);
            } else if (!queue.empty()) {
                const Question question = queue.top();
                queue.pop();
                if (question.number == asked[question.corner]) try_to_cut(question.corner);
            } else {
                return std::nullopt;
            }
        }
        return std::move(triangles);
    }

private:
    /// Is the corner an ear? Short cuts first: what is nearer than their ends is gone before long ones are
    /// asked.
    struct Question {
        Real length = 0;  ///< of the cut, along the axis where it is longer
        Index corner = 0;
        Index number = 0;  ///< of the question about this corner; the last one counts
    };
    struct IsLater {
        bool operator()(const Question& a, const Question& b) const {
            return a.length != b.length ? a.length > b.length : a.corner > b.corner;
        }
    };

    int turn(Index i) const { return orientation(points[before[i]], points[i], points[after[i]]); }

    /// Whether the outline turns back on itself at a corner without a turn, or stands still.
    bool turns_back(Index i) const {
        const Vec2 &p = points[before[i]], &v = points[i], &n = points[after[i]];
        if (p == v || n == v) return true;
        // One coordinate is enough, because the three are on a line.
        const bool along_y = p.x == v.x && n.x == v.x;
        return along_y ? (p.y > v.y) == (n.y > v.y) : (p.x > v.x) == (n.x > v.x);
    }

    /// A corner is new, or has other neighbours.
    void look_again(Index i) {
        const int sign = turn(i);
        if (sign == 0 && turns_back(i)) spikes.push_back(i);
        if (sign > 0) ask(i);
        const bool in_the_way = sign <= 0;
        if (!in_the_way && tree.is_marked(i)) wake(i);
        tree.mark(i, in_the_way);
    }

    void ask(Index i) {
        const Vec2 cut = glm::abs(points[after[i]] - points[before[i]]);
        queue.push({std::max(cut.x, cut.y), i, ++asked[i]});
    }

    /// Corner i is not in the way any more.
    void wake(Index i) {
        for (const Index other : waiting[i])
            if (waits_for[other] == i) ask(other);
        waiting[i].clear();
    }

    void try_to_cut(Index i) {
        waits_for[i] = i;
        if (is_gone[i] || turn(i) <= 0) return;
        const Ear ear{points[before[i]], points[i], points[after[i]]};
        const auto blocker = tree.find(ear, [&](Index other) { return blocks(other, i, ear); });
        if (blocker) {
            waits_for[i] = *blocker;
            waiting[*blocker].push_back(i);
            return;
        }
        triangles.push_back({before[i], i, after[i]});
        if (left == 3)
            left = 0;
        else
            remove(i);
    }

    void remove(Index i) {
        const Index p = before[i], n = after[i];
        after[p] = n;
        before[n] = p;
        is_gone[i] = true;
        --left;
        tree.mark(i, false);
        wake(i);
        look_again(p);
        look_again(n);
    }

    /// Whether the outline at corner `other` is in the ear at corner i, or on the line along which that would
    /// be cut off.
    bool blocks(Index other, Index i, const Ear& ear) const {
        if (other == i || other == before[i] || other == after[i]) return false;
        const Vec2& point = points[other];
        if (point == ear.before || point == ear.after) return false;
        const int first = orientation(ear.before, ear.tip, point);
        const int second = orientation(ear.tip, ear.after, point);
        if (first < 0 || second < 0 || orientation(ear.after, ear.before, point) < 0) return false;
        if (first > 0 && second > 0) return true;
        // On a side of the ear: it depends on where the outline goes from there.
        const auto goes_in = [&](const Vec2& to) {
            return (first > 0 || orientation(ear.before, ear.tip, to) > 0) &&
                   (second > 0 || orientation(ear.tip, ear.after, to) > 0);
        };
        return goes_in(points[before[other]]) || goes_in(points[after[other]]);
    }

    std::span<const Vec2> points;
    PointTree tree;  ///< corners that are not convex are marked
    std::vector<Index> before, after;
    std::vector<bool> is_gone;
    std::vector<Index> asked;                 ///< how often each corner has been asked
    std::vector<Index> waits_for;             ///< the corner that blocks it; itself where there is none
    std::vector<std::vector<Index>> waiting;  ///< for each corner those that it blocks
    std::priority_queue<Question, std::vector<Question>, IsLater> queue;
    std::vector<Index> spikes;  ///< corners where the outline may turn back
    std::vector<std::array<Index, 3>> triangles;
    std::size_t left;  ///< number of corners
};

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 3>>> clip_ears(std::span<const Vec2> outline) {
    if (outline.size() < 3) return std::vector<std::array<std::uint32_t, 3>>{};
    return EarClipper(outline).run();
}

}  // namespace rt
