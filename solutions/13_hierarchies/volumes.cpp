// Hierarchies of spheres, of boxes with axes of their own, and of ellipsoids, over any shapes. All is given.
#include "chapters/13_hierarchies/volumes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
namespace {

/// Which part of `items` the shapes below each node are: from begin to end.
struct Part {
    std::uint32_t begin = 0, end = 0;
};

std::vector<Part> parts_of(const Hierarchy& hierarchy) {
    std::vector<Part> parts(hierarchy.nodes.size());
    // Children have greater numbers than their parents.
    for (std::size_t i = parts.size(); i-- > 0;) {
        const HierarchyNode& node = hierarchy.nodes[i];
        if (node.count > 0) {
            parts[i] = {node.first, node.first + node.count};
        } else {
            const Part &a = parts[node.first], &b = parts[node.first + 1];
            parts[i] = {std::min(a.begin, b.begin), std::max(a.end, b.end)};
        }
    }
    return parts;
}

/// The tree of the volumes that `fit` puts around points.
template <class Volume, class Fit>
VolumeTree<Volume> tree_of(const Hierarchy& hierarchy, const ShapePoints& shapes, const Fit& fit) {
    VolumeTree<Volume> tree;
    if (hierarchy.nodes.empty()) return tree;
    tree.items = hierarchy.items;
    tree.box = grown(hierarchy.nodes[0].box, -hierarchy.margin);
    tree.margin = hierarchy.margin;
    tree.reach = hierarchy.reach;
    const std::vector<Part> parts = parts_of(hierarchy);
    tree.nodes.reserve(parts.size());
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        points.clear();
        for (std::uint32_t k = parts[i].begin; k < parts[i].end; ++k) {
            const std::uint32_t shape = tree.items[k];
            points.insert(points.end(), shapes.points.begin() + shapes.first[shape],
                          shapes.points.begin() + shapes.first[shape + 1]);
        }
        tree.nodes.push_back({fit(points), hierarchy.nodes[i].first, hierarchy.nodes[i].count});
    }
    return tree;
}

/// A node that is to be looked into, and the part of the ray in its volume.
struct Waiting {
    std::uint32_t node = 0;
    Real begin = 0, end = 0;
};

template <class Volume>
void search_tree(const VolumeTree<Volume>& tree, const Ray& ray, const Interval& range, const Ask& ask) {
    std::array<Waiting, deepest_leaf + 2> stack;
    std::size_t height = 0;
    std::uint64_t looked_into = 0;
    Interval still = range;  // in which there is something to find
    const auto wait = [&](std::uint32_t number) {
        if (const std::optional<Interval> part = clip(tree.nodes[number].volume, ray, still))
            stack[height++] = {number, part->min, part->max};
    };
    wait(0);
    while (height > 0) {
        const Waiting on = stack[--height];
        if (on.begin > still.max) continue;
        ++looked_into;
        const VolumeNode<Volume>& node = tree.nodes[on.node];
        if (node.count > 0) {
            still.max = std::min(still.max, ask({&tree.items[node.first], node.count}, {on.begin, on.end}));
            continue;
        }
        const std::size_t below = height;
        wait(node.first + 1);
        wait(node.first);
        // The one on top is next.
        if (height == below + 2 && stack[below].begin < stack[below + 1].begin)
            std::swap(stack[below], stack[below + 1]);
    }
    search_counts().cells += looked_into;
}

template <class Volume>
bool tree_serves(const VolumeTree<Volume>& tree, const Ray& ray) {
    const auto is_moderate = [](Real x) { return x >= 0x1p-150 && x <= 0x1p150; };
    return !tree.nodes.empty() && is_moderate(tree.reach) && is_moderate(size_of(ray.direction)) &&
           is_within_reach(ray, tree.box, tree.reach);
}

template <class Volume>
std::size_t tree_bytes(const VolumeTree<Volume>& tree) {
    return sizeof tree + tree.nodes.capacity() * sizeof tree.nodes[0] +
           tree.items.capacity() * sizeof tree.items[0];
}

template <class Volume>
std::string tree_words(const VolumeTree<Volume>& tree, const char* volumes) {
    return "hierarchy of " + std::to_string(tree.nodes.size()) + " " + volumes;
}

}  // namespace

std::vector<Vec3> outermost(std::span<const Vec3> points, const Mat3& axes) {
    const OrientedBox box = box_along(axes, points);
    std::vector<Vec3> directions;
    for (const int x : {-1, 0, 1})
        for (const int y : {-1, 0, 1})
            for (const int z : {-1, 0, 1})
                if (x != 0 || y != 0 || z != 0)
                    directions.push_back(
                        axes * (Vec3(x, y, z) / glm::max(box.half, Vec3(0x1p-20 * max_component(box.half)))));
    std::vector<std::size_t> numbers;
    for (const Vec3& direction : directions) {
        const auto along = [&](const Vec3& point) { return dot(point - box.center, direction); };
        numbers.push_back(
            static_cast<std::size_t>(std::ranges::max_element(points, {}, along) - points.begin()));
    }
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<Vec3> some;
    for (const std::size_t number : numbers) some.push_back(points[number]);
    return some;
}

OrientedBox small_box(std::span<const Vec3> points) {
    if (points.empty()) return {};
    const Mat3 axes = principal_axes(covariance(points));
    const OrientedBox box = box_along(refined_axes(axes, outermost(points, axes)), points);
    const OrientedBox straight = box_along(Mat3(1), points);
    return half_area(box) < half_area(straight) ? box : straight;
}

BoundingEllipsoid small_ellipsoid(std::span<const Vec3> points, Real thickness) {
    const Mat3 axes = principal_axes(covariance(points));
    const OrientedBox box = box_along(axes, points);
    std::vector<Vec3> some = outermost(points, axes);
    const Real least = std::max(thickness, 0x1p-15 * max_component(box.half));
    for (int k = 0; k < 3; ++k)
        if (box.half[k] < least)
            for (const Real side : {-1.0, 1.0}) some.push_back(box.center + side * least * axes[k]);
    BoundingEllipsoid ellipsoid = ellipsoid_of(some, ellipsoid_weights(some, Real(1) / 8));
    Real farthest = 1;
    for (const Vec3& point : points)
        farthest = std::max(farthest, length(ellipsoid.to_unit * (point - ellipsoid.center)));
    ellipsoid.to_unit /= farthest;
    ellipsoid.longest *= farthest;
    return ellipsoid;
}

SphereTree sphere_tree(const Hierarchy& hierarchy, const ShapePoints& shapes) {
    return tree_of<BoundingSphere>(hierarchy, shapes, [&](std::span<const Vec3> points) {
        BoundingSphere sphere = smallest_sphere(points).sphere;
        sphere.radius += 2 * hierarchy.margin;
        return sphere;
    });
}

OrientedBoxTree oriented_box_tree(const Hierarchy& hierarchy, const ShapePoints& shapes) {
    return tree_of<OrientedBox>(hierarchy, shapes, [&](std::span<const Vec3> points) {
        OrientedBox box = small_box(points);
        box.half += 2 * hierarchy.margin;
        return box;
    });
}

EllipsoidTree ellipsoid_tree(const Hierarchy& hierarchy, const ShapePoints& shapes) {
    return tree_of<BoundingEllipsoid>(hierarchy, shapes, [&](std::span<const Vec3> points) {
        BoundingEllipsoid ellipsoid = small_ellipsoid(points, 32 * hierarchy.margin);
        // So far a margin takes a point at most.
        const Mat3& m = ellipsoid.to_unit;
        const Real by =
            1 + 2 * hierarchy.margin * std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
        ellipsoid.to_unit /= by;
        ellipsoid.longest *= by;
        return ellipsoid;
    });
}

bool serves(const SphereTree& tree, const Ray& ray) { return tree_serves(tree, ray); }
void search(const SphereTree& tree, const Ray& ray, Interval range, const Ask& ask) {
    search_tree(tree, ray, range, ask);
}
std::size_t bytes_of(const SphereTree& tree) { return tree_bytes(tree); }
std::string in_words(const SphereTree& tree) { return tree_words(tree, "spheres"); }

bool serves(const OrientedBoxTree& tree, const Ray& ray) { return tree_serves(tree, ray); }
void search(const OrientedBoxTree& tree, const Ray& ray, Interval range, const Ask& ask) {
    search_tree(tree, ray, range, ask);
}
std::size_t bytes_of(const OrientedBoxTree& tree) { return tree_bytes(tree); }
std::string in_words(const OrientedBoxTree& tree) { return tree_words(tree, "oriented boxes"); }

bool serves(const EllipsoidTree& tree, const Ray& ray) { return tree_serves(tree, ray); }
void search(const EllipsoidTree& tree, const Ray& ray, Interval range, const Ask& ask) {
    search_tree(tree, ray, range, ask);
}
std::size_t bytes_of(const EllipsoidTree& tree) { return tree_bytes(tree); }
std::string in_words(const EllipsoidTree& tree) { return tree_words(tree, "ellipsoids"); }

}  // namespace rt
