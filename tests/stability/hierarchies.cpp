// Families of extreme scenes for chapter 13.
#include "tests/stability/hierarchies.hpp"

#include "chapters/03_triangles/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace rt::stability {

using test::Random;

HierarchyOptions some_options(Random& random) {
    constexpr SplitMethod methods[] = {SplitMethod::Halves, SplitMethod::Sweep, SplitMethod::Bins,
                                       SplitMethod::Codes};
    HierarchyOptions options;
    options.method = methods[random.index(4)];
    options.most = std::size_t{1} << random.index(5);
    options.costs = {random.magnitude(-1, 1), 1};
    return options;
}

Hierarchy hierarchy_over(const AnyShapes& shapes, const HierarchyOptions& options) {
    return std::visit([&](const auto& some) { return build_hierarchy(some, options); }, shapes);
}

GridScene make_scene_of_trees(const GridFamily& family, std::uint64_t seed) {
    GridScene scene = make_scene(family, seed);
    auto* instances = std::get_if<std::vector<Instance>>(&scene.shapes);
    if (!instances) return scene;
    std::map<std::shared_ptr<const SharedMesh>, std::shared_ptr<const SharedMesh>> others;
    for (Instance& instance : *instances) {
        std::shared_ptr<const SharedMesh>& mesh = instance.shape.mesh;
        std::shared_ptr<const SharedMesh>& other = others[mesh];
        if (!other) {
            SharedMesh copy = *mesh;
            if (has_accelerator(copy.triangles))
                copy.triangles.accelerator = build_hierarchy(copy.triangles.shapes);
            other = std::make_shared<const SharedMesh>(std::move(copy));
        }
        mesh = other;
    }
    return scene;
}

std::vector<Sphere> ladder(std::size_t count) {
    std::vector<Sphere> spheres;
    for (std::size_t k = 0; k < count; ++k) {
        const Real size = std::ldexp(Real(1), -static_cast<int>(k));
        spheres.push_back({{3 * size, 0, 0}, size});
    }
    return spheres;
}

std::vector<Triangle> closed_mesh(Random& random, int rings) {
    const int around = 2 * rings;
    std::vector<Vec3> corners;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i < around; ++i) {
            const Real u = 2 * pi * i / around, v = pi * j / rings;
            const Vec3 on_ball(std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u));
            corners.push_back(random.uniform(0.8, 1.2) * on_ball);
        }
    const auto corner = [&](int i, int j) {
        // All of a pole's corners are one.
        const bool pole = j == 0 || j == rings;
        return corners[static_cast<std::size_t>(j * around + (pole ? 0 : i % around))];
    };
    std::vector<Triangle> mesh;
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            if (j > 0) mesh.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
            if (j + 1 < rings) mesh.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    return mesh;
}

Ray ray_at_edge(const std::vector<Triangle>& mesh, Random& random) {
    const Triangle& t = mesh[random.index(mesh.size())];
    const Vec3 from = Real(0.3) * random.in_cube();
    const Vec3 to = random.index(2) == 0 ? t.b : t.a + random.uniform(0, 1) * (t.b - t.a);
    return {from, (to - from) * random.magnitude(-2, 2)};
}

}  // namespace rt::stability

namespace rt::naive {
namespace {

struct Search {
    const Hierarchy& hierarchy;
    std::span<const Triangle> shapes;
    const Ray& ray;
    Nearest nearest;
};

void search_below(Search& search, std::uint32_t number) {
    const HierarchyNode& node = search.hierarchy.nodes[number];
    const Interval range{search.nearest.range.min, search.nearest.range.max};
    const std::optional<Interval> inside =
        naive::clip(grown(node.box, -search.hierarchy.margin), search.ray, range);
    if (!inside || inside->min >= search.nearest.range.max) return;
    for (std::uint32_t k = 0; k < node.count; ++k)
        search.nearest.ask(search.shapes, search.hierarchy.items[node.first + k], search.ray);
    if (node.count > 0) return;
    search_below(search, node.first);
    search_below(search, node.first + 1);
}

}  // namespace

std::optional<Hit> closest_hit(const Hierarchy& hierarchy, std::span<const Triangle> shapes, const Ray& ray,
                               Interval range) {
    Search search{hierarchy, shapes, ray, {range}};
    search_below(search, 0);
    return search.nearest.hit;
}

}  // namespace rt::naive
