// Solids made of solids: constructive solid geometry, one line at a time.
#include "chapters/10_surfaces/combination.hpp"

#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/09_grids/bounds.hpp"
#include "chapters/10_surfaces/box.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/quadric.hpp"
#include "chapters/10_surfaces/torus.hpp"
#include "common/world/query.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rt {

bool is_inside(SetOperation operation, bool in_a, bool in_b) {
    // [exercise 10.15] Return whether the point is inside of the two solids as one.
    switch (operation) {
        case SetOperation::Union:
            return in_a || in_b;
        case SetOperation::Intersection:
            return in_a && in_b;
        case SetOperation::Difference:
            return in_a && !in_b;
    }
    return false;
    // [/exercise]
}

std::vector<Hit> combine(SetOperation operation, std::span<const Hit> a, std::span<const Hit> b) {
    std::vector<Hit> both;
    // [exercise 10.15] Put into `both` the hits of a and b at which the line crosses the surface of the
    // whole, in order.
    bool in_a = false, in_b = false;
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        const bool was_in_a = in_a, was_inside = is_inside(operation, in_a, in_b);
        const Hit* next_a = i < a.size() ? &a[i] : nullptr;
        const Hit* next_b = j < b.size() ? &b[j] : nullptr;
        const Real t = std::min(next_a ? next_a->t : infinity, next_b ? next_b->t : infinity);
        for (; i < a.size() && a[i].t == t; ++i) in_a = !in_a;
        for (; j < b.size() && b[j].t == t; ++j) in_b = !in_b;
        if (is_inside(operation, in_a, in_b) != was_inside)
            both.push_back(in_a != was_in_a ? *next_a : *next_b);
    }
    // [/exercise]
    return both;
}

namespace {

/// The two ends of what is inside, as hits.
std::vector<Hit> ends(const std::optional<Span>& span) {
    if (!span) return {};
    return {Hit{.t = span->enter, .element = span->enter_face},
            Hit{.t = span->leave, .element = span->leave_face}};
}

std::vector<Hit> crossings(const Box& box, const Ray& ray) { return ends(inside(box, ray)); }
std::vector<Hit> crossings(const Torus& torus, const Ray& ray) {
    const TorusSpans spans = inside(torus, ray);
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < static_cast<std::size_t>(spans.count); ++i)
        for (const Hit& end : ends(spans.spans[i])) hits.push_back(end);
    return hits;
}
std::vector<Hit> crossings(const Cone& cone, const Ray& ray) { return ends(inside(cone, ray)); }

std::vector<Hit> crossings(const std::vector<Span>& spans) {
    std::vector<Hit> hits;
    for (const Span& span : spans)
        for (const Hit& end : ends(span)) hits.push_back(end);
    return hits;
}
std::vector<Hit> crossings(const Implicit& implicit, const Ray& ray) {
    return crossings(inside(implicit, ray));
}
std::vector<Hit> crossings(const Quadric& quadric, const Ray& ray) { return crossings(inside(quadric, ray)); }

std::vector<Hit> crossings(const Sphere& sphere, const Ray& ray) {
    const Roots roots = intersections(sphere, ray);
    if (roots.count == 0) return {};
    return {Hit{.t = roots.t0}, Hit{.t = roots.t1}};
}

/// Inside is the side that the normal points away from.
std::vector<Hit> crossings(const Plane& plane, const Ray& ray) {
    const Real slope = dot(plane.normal, ray.direction);
    const std::optional<Hit> hit = intersect(plane, ray, {-infinity, infinity});
    const Hit before{.t = -infinity}, after{.t = infinity};
    if (!hit)
        return dot(plane.normal, ray.origin - plane.point) <= 0 ? std::vector{before, after}
                                                                : std::vector<Hit>{};
    return slope < 0 ? std::vector{*hit, after} : std::vector{before, *hit};
}

/// What the line is told of by each triangle it meets: that it is inside now, or that it was until now. Where
/// two triangles share an edge both say so, and on a silhouette one says that it goes in and the other that
/// it goes out; so there is a piece inside wherever the one before and the one after agree on it. Of those at
/// one t the ones that go out come first: a line that touches an edge from inside goes on inside.
std::vector<Hit> crossings(const MeshUse& shown, const Ray& ray) {
    std::vector<Hit> all = all_hits(*shown.mesh, ray), pieces;
    const auto enters = [&](const Hit& hit) {
        const Triangle& triangle = shown.mesh->triangles.shapes[hit.primitive];
        return dot(cross(triangle.b - triangle.a, triangle.c - triangle.a), ray.direction) < 0;
    };
    std::sort(all.begin(), all.end(), [&](const Hit& a, const Hit& b) {
        if (a.t != b.t) return a.t < b.t;
        return enters(a) != enters(b) ? enters(b) : a.primitive < b.primitive;
    });
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        if (!enters(all[i]) || enters(all[i + 1])) continue;
        const bool goes_on = !pieces.empty() && pieces.back().t == all[i].t;
        if (goes_on)
            pieces.pop_back();
        else
            pieces.push_back(all[i]);
        pieces.push_back(all[i + 1]);
    }
    for (Hit& hit : pieces) hit.element = hit.primitive;
    return pieces;
}

template <class Shape>
std::vector<Hit> crossings(const Placed<Shape>& placed, const Ray& ray) {
    return crossings(placed.shape, to_local(placed.transform, ray));
}

/// Where two parts have a face in one plane, both cross it at one t, whatever each of them has rounded on its
/// way. (The far end of what is behind a Plane is not in that plane.)
void cross_common_planes(const Combination::Part& part, const Ray& ray, std::vector<Hit>& hits) {
    for (const auto& [element, axis, place] : part.common_planes)
        for (Hit& hit : hits)
            if (hit.element == element && std::isfinite(hit.t) && ray.direction[axis] != 0)
                hit.t = (place - ray.origin[axis]) / ray.direction[axis];
    std::ranges::sort(hits, {}, &Hit::t);
}

/// Where a line only touches a part it meets nothing that has a volume.
void leave_out_points(std::vector<Hit>& hits) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 1 < hits.size(); i += 2) {
        if (hits[i].t == hits[i + 1].t) continue;
        hits[kept++] = hits[i];
        hits[kept++] = hits[i + 1];
    }
    hits.resize(kept);
}

bool is_met(const Bounds& bounds, const Ray& ray) {
    return clip(bounds, ray, {-infinity, infinity}).has_value();
}

/// Of a part, or of a node of the tree and all below it.
std::vector<Hit> crossings(const Combination& whole, std::int32_t solid, const Ray& ray) {
    if (solid >= 0) {
        const Combination::Part& part = whole.parts[static_cast<std::size_t>(solid)];
        if (!is_met(part.bounds, ray)) return {};
        std::vector<Hit> hits = std::visit([&](const auto& one) { return crossings(one, ray); }, part.solid);
        if (!part.common_planes.empty()) cross_common_planes(part, ray, hits);
        leave_out_points(hits);
        for (Hit& hit : hits) hit.element += part.first_element;
        return hits;
    }
    const Combination::Node& node = whole.nodes[static_cast<std::size_t>(~solid)];
    if (!is_met(node.bounds, ray)) return {};
    std::vector<Hit> first = crossings(whole, node.first, ray);
    if (first.empty() && node.operation != SetOperation::Union) return first;
    const std::vector<Hit> second = crossings(whole, node.second, ray);
    if (second.empty() && node.operation != SetOperation::Intersection) return first;
    return combine(node.operation, first, second);
}

}  // namespace

std::vector<Hit> crossings(const Combination& combination, const Ray& ray) {
    return crossings(combination, -static_cast<std::int32_t>(combination.nodes.size()), ray);
}

std::optional<Hit> intersect(const Combination& combination, const Ray& ray, Interval range) {
    for (const Hit& hit : crossings(combination, ray))
        if (contains(range, hit.t)) return Hit{.t = hit.t, .uv = hit.uv, .element = hit.element};
    return std::nullopt;
}

Surface surface_at(const Combination& combination, const Ray& ray, const Hit& hit) {
    const auto part = std::prev(std::upper_bound(
        combination.parts.begin(), combination.parts.end(), hit.element,
        [](std::uint32_t element, const Combination::Part& one) { return element < one.first_element; }));
    Hit own = hit;
    own.element -= part->first_element;
    Surface surface = std::visit([&](const auto& solid) { return surface_at(solid, ray, own); }, part->solid);
    if (part->is_taken_away)
        surface.normal = -surface.normal, surface.shading_normal = -surface.shading_normal;
    return surface;
}

Bounds bounds_of(const Combination& combination) {
    return combination.nodes.empty() ? combination.parts.front().bounds : combination.nodes.back().bounds;
}

}  // namespace rt
