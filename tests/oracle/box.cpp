// The exact judge of rays, boxes and cells.
// All that is asked here is rational, so every answer is a comparison or a quotient of exact numbers.
#include "tests/oracle/box.hpp"

#include "common/math/error.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>

namespace rt::oracle {
namespace {

using Exact = CGAL::Gmpq;

Real rounded(const Exact& x) { return CGAL::to_double(x); }

/// low + i · (high − low)/cells.
Exact boundary(const GridShape& shape, int axis, int number) {
    const Exact low(shape.box.low[axis]), high(shape.box.high[axis]);
    return low + (high - low) * Exact(number) / Exact(shape.cells[axis]);
}

/// The greatest coordinate that has to do with this axis.
Exact size_of(const Bounds& box, const Exact& o, int axis) {
    return std::max({CGAL::abs(o), Exact(std::abs(box.low[axis])), Exact(std::abs(box.high[axis]))});
}

}  // namespace

ClipTruth judge_clip(const Bounds& box, const Ray& ray, Interval range, std::optional<Interval> proposed) {
    ClipTruth truth;
    std::optional<Exact> near, far;
    bool meets_all = true;
    for (int a = 0; a < 3; ++a) {
        const Exact low(box.low[a]), high(box.high[a]), o(ray.origin[a]);
        if (low > high) return truth;
        if (ray.direction[a] == 0) {
            if (o < low || o > high) meets_all = false;
            continue;
        }
        const Exact d(ray.direction[a]);
        Exact entry = (low - o) / d, exit = (high - o) / d;
        if (entry > exit) std::swap(entry, exit);
        if (!near || entry > *near) near = entry;
        if (!far || exit < *far) far = exit;
    }
    if (!meets_all) {
        truth.excess = proposed ? infinity : 0;
        return truth;
    }
    if (std::isfinite(range.min) && (!near || Exact(range.min) > *near)) near = Exact(range.min);
    if (std::isfinite(range.max) && (!far || Exact(range.max) < *far)) far = Exact(range.max);
    truth.near = near ? rounded(*near) : -infinity;
    truth.far = far ? rounded(*far) : infinity;
    truth.inside = !near || !far || *near <= *far;
    if (!proposed) {
        truth.lost = truth.inside;
        return truth;
    }
    const Real unit =
        unit_roundoff * std::max(near ? std::abs(truth.near) : 0, far ? std::abs(truth.far) : 0);
    const auto in_units = [&](const Exact& x) { return x == 0 ? 0 : rounded(x) / unit; };
    if (!truth.inside) {
        truth.excess = in_units(*near - *far);
        return truth;
    }
    // Where there is no exact end, there can be no end at all.
    if (near && std::isfinite(proposed->min)) {
        truth.lost |= Exact(proposed->min) > *near;
        truth.excess = std::max(truth.excess, in_units(*near - Exact(proposed->min)));
    }
    if (far && std::isfinite(proposed->max)) {
        truth.lost |= Exact(proposed->max) < *far;
        truth.excess = std::max(truth.excess, in_units(Exact(proposed->max) - *far));
    }
    if (near && !std::isfinite(proposed->min)) truth.excess = infinity;
    if (far && !std::isfinite(proposed->max)) truth.excess = infinity;
    return truth;
}

WalkTruth judge_walk(const GridShape& shape, const Ray& ray, Interval part) {
    struct Crossing {
        Exact t;
        int axis;
        int step;
    };
    std::vector<Crossing> crossings;
    std::vector<Exact> events{Exact(part.min), Exact(part.max)};
    WalkTruth truth;
    Cells cell(0);
    Exact greatest(0), beside(1);
    for (int a = 0; a < 3; ++a) {
        const Exact o(ray.origin[a]);
        if (ray.direction[a] == 0) {
            while (cell[a] < shape.cells[a] - 1 && boundary(shape, a, cell[a] + 1) <= o) ++cell[a];
            for (int i = 1; i < shape.cells[a]; ++i)
                beside =
                    std::min<Exact>(beside, CGAL::abs(boundary(shape, a, i) - o) / size_of(shape.box, o, a));
            continue;
        }
        const Exact d(ray.direction[a]);
        const int step = ray.direction[a] > 0 ? 1 : -1;
        cell[a] = step > 0 ? 0 : shape.cells[a] - 1;
        for (int i = 0; i <= shape.cells[a]; ++i)
            greatest = std::max<Exact>(greatest, CGAL::abs((boundary(shape, a, i) - o) / d));
        for (int i = 1; i < shape.cells[a]; ++i) {
            const Exact t = (boundary(shape, a, i) - o) / d;
            if (t <= Exact(part.min))
                cell[a] += step;
            else if (t <= Exact(part.max))
                crossings.push_back({t, a, step});
            events.push_back(t);
        }
    }
    std::ranges::sort(events);
    Exact least = greatest;
    for (std::size_t i = 1; i < events.size(); ++i) least = std::min<Exact>(least, events[i] - events[i - 1]);
    truth.least_gap = std::min(rounded(beside), greatest == 0 ? 1 : rounded(least / greatest));

    std::ranges::sort(crossings, [](const Crossing& p, const Crossing& q) { return p.t < q.t; });
    truth.cells.push_back(cell);
    for (const Crossing& crossing : crossings) {
        cell[crossing.axis] += crossing.step;
        truth.cells.push_back(cell);
    }
    return truth;
}

Real distance_from_cell(const GridShape& shape, const Cells& cell, const Ray& ray, Real t) {
    Exact distance(0);
    for (int a = 0; a < 3; ++a) {
        const Exact p = Exact(ray.origin[a]) + Exact(t) * Exact(ray.direction[a]);
        distance = std::max<Exact>(distance, boundary(shape, a, cell[a]) - p);
        distance = std::max<Exact>(distance, p - boundary(shape, a, cell[a] + 1));
    }
    return rounded(distance);
}

}  // namespace rt::oracle
