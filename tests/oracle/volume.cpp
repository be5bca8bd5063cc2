// The exact judge of rays and bounding volumes.
// A point of the ray is inside where polynomials in t of degree 2, which nowhere bend down, are all at most
// 0.
#include "tests/oracle/volume.hpp"

#include <CGAL/Gmpq.h>

#include <cmath>
#include <vector>

namespace rt::oracle {
namespace {

using Exact = CGAL::Gmpq;

/// a·t² + 2·b·t + c.
struct Parabola {
    Exact a, b, c;
    Exact at(const Exact& t) const { return (a * t + Exact(2) * b) * t + c; }
};

/// A coordinate of the ray's points: from + t · step.
struct Line {
    Exact from, step;
};

/// The lengths along the rows of m of a point of the ray, seen from the centre.
std::vector<Line> lines_of(const Mat3& m, const Vec3& center, const Ray& ray) {
    std::vector<Line> lines;
    for (int row = 0; row < 3; ++row) {
        Line line{0, 0};
        for (int k = 0; k < 3; ++k) {
            line.from += Exact(m[k][row]) * (Exact(ray.origin[k]) - Exact(center[k]));
            line.step += Exact(m[k][row]) * Exact(ray.direction[k]);
        }
        lines.push_back(line);
    }
    return lines;
}

/// The sum of the squares of the lines less the square of the radius.
Parabola ball(const std::vector<Line>& lines, Real radius) {
    Parabola p{0, 0, -Exact(radius) * Exact(radius)};
    for (const Line& line : lines) {
        p.a += line.step * line.step;
        p.b += line.from * line.step;
        p.c += line.from * line.from;
    }
    return p;
}

std::vector<Parabola> parabolas_of(const BoundingSphere& sphere, const Ray& ray) {
    return {ball(lines_of(Mat3(1), sphere.center, ray), sphere.radius)};
}
std::vector<Parabola> parabolas_of(const BoundingEllipsoid& ellipsoid, const Ray& ray) {
    return {ball(lines_of(ellipsoid.to_unit, ellipsoid.center, ray), 1)};
}
std::vector<Parabola> parabolas_of(const OrientedBox& box, const Ray& ray) {
    const std::vector<Line> lines = lines_of(glm::transpose(box.axes), box.center, ray);
    std::vector<Parabola> parabolas;
    for (int k = 0; k < 3; ++k) parabolas.push_back(ball({lines[static_cast<std::size_t>(k)]}, box.half[k]));
    return parabolas;
}

/// An end of a range, which may be missing.
using End = std::optional<Exact>;

End end_of(Real t) { return std::isfinite(t) ? End(Exact(t)) : End(); }

/// Where between low and high the parabola is least; it is not a constant where an end is missing.
Exact lowest(const Parabola& p, const End& low, const End& high) {
    if (p.a == 0) return low ? *low : high ? *high : Exact(0);
    const Exact vertex = -p.b / p.a;
    return low && vertex < *low ? *low : high && vertex > *high ? *high : vertex;
}

/// Whether all are at most 0 somewhere between low and high. Where there are several, each is a square less a
/// square: it is at most 0 between two t that are rational.
bool meets(const std::vector<Parabola>& parabolas, const std::vector<Line>& lines, const Vec3& half, End low,
           End high) {
    if (parabolas.size() == 1) return parabolas[0].at(lowest(parabolas[0], low, high)) <= 0;
    for (int k = 0; k < 3; ++k) {
        const Line& line = lines[static_cast<std::size_t>(k)];
        const Exact h(half[k]);
        if (line.step == 0) {
            if (CGAL::abs(line.from) > h) return false;
            continue;
        }
        Exact near = (-h - line.from) / line.step, far = (h - line.from) / line.step;
        if (near > far) std::swap(near, far);
        if (!low || near > *low) low = near;
        if (!high || far < *high) high = far;
    }
    return !low || !high || *low <= *high;
}

template <class Volume>
PartTruth judge(const Volume& volume, const Volume& larger, const std::vector<Line>& lines, const Vec3& half,
                const Ray& ray, Interval range, const std::optional<Interval>& proposed) {
    const std::vector<Parabola> inside = parabolas_of(volume, ray);
    const End low = end_of(range.min), high = end_of(range.max);
    const auto any = [&](const End& from, const End& to) { return meets(inside, lines, half, from, to); };
    PartTruth truth;
    truth.inside = (!low || !high || *low <= *high) && any(low, high);
    if (!proposed) {
        truth.lost = truth.inside;
        return truth;
    }
    // Just outside of what is proposed: as far from its ends as no rounding reaches.
    const auto beyond = [](Real t, const Exact& by) {
        return Exact(t) + by * Exact(std::max(std::abs(t), 0x1p-1000));
    };
    const Exact tiny = Exact(1) / Exact(0x1p200);
    if (std::isfinite(proposed->min)) {
        const Exact before = beyond(proposed->min, -tiny);
        truth.lost |= (!low || *low <= before) && any(low, before);
    }
    if (std::isfinite(proposed->max)) {
        const Exact behind = beyond(proposed->max, tiny);
        truth.lost |= (!high || behind <= *high) && any(behind, high);
    }
    for (const Parabola& p : parabolas_of(larger, ray))
        for (const Real t : {proposed->min, proposed->max})
            truth.too_much |= !std::isfinite(t) || p.at(Exact(t)) > 0;
    return truth;
}

}  // namespace

PartTruth judge_part(const BoundingSphere& sphere, const BoundingSphere& larger, const Ray& ray,
                     Interval range, std::optional<Interval> proposed) {
    return judge(sphere, larger, {}, Vec3(0), ray, range, proposed);
}
PartTruth judge_part(const OrientedBox& box, const OrientedBox& larger, const Ray& ray, Interval range,
                     std::optional<Interval> proposed) {
    return judge(box, larger, lines_of(glm::transpose(box.axes), box.center, ray), box.half, ray, range,
                 proposed);
}
PartTruth judge_part(const BoundingEllipsoid& ellipsoid, const BoundingEllipsoid& larger, const Ray& ray,
                     Interval range, std::optional<Interval> proposed) {
    return judge(ellipsoid, larger, {}, Vec3(0), ray, range, proposed);
}

}  // namespace rt::oracle
