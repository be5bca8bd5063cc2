// Hierarchies against asking every shape, to the bit, on scenes and rays made to break them.
// Families and demand: tests/stability/hierarchies.hpp.
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "tests/13_hierarchies/trees.hpp"
#include "tests/catch.hpp"
#include "tests/stability/hierarchies.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using namespace rt::stability;
using namespace rt::test;

namespace {

constexpr std::uint64_t seed = 13;
constexpr std::size_t rays_a_scene = 100;

std::vector<Bounds> boxes_of(const AnyShapes& shapes) {
    return std::visit(
        [](const auto& some) {
            std::vector<Bounds> boxes;
            for (const auto& shape : some) boxes.push_back(bounds_of(shape));
            return boxes;
        },
        shapes);
}

using Judge = Verdict (*)(const GridScene&, const Hierarchy&, std::span<const GridQuestion>);

void check_families(Judge judge, int rays) {
    for (const GridFamily& family : grid_families()) {
        Verdict verdict;
        const auto scenes = static_cast<std::size_t>(rays) / rays_a_scene / grid_families().size() + 1;
        for (std::uint64_t k = 0; k < scenes; ++k) {
            const GridScene scene = make_scene_of_trees(family, seed + k);
            Random random(seed + k);
            HierarchyOptions options = some_options(random);
            if (options.method == SplitMethod::Codes) options.method = SplitMethod::Bins;
            const Hierarchy tree = hierarchy_over(scene.shapes, options);
            INFO("seed " << seed + k << " of " << family.name << ": what the contract says of the tree");
            REQUIRE(is_right(tree, boxes_of(scene.shapes), 16));
            add(verdict, judge(scene, tree, make_questions(scene, rays_a_scene, seed + k)));
            if (verdict.mismatches > 0) break;
        }
        INFO(family.name << " (" << family.extremes << "): " << describe(verdict));
        CHECK(verdict.mismatches == 0);
    }
}

}  // namespace

TEST_CASE("the nearest hit by a hierarchy is, to the bit, the nearest of all", "[13.10][stability]") {
    check_families(judge_nearest, cases(50'000));
}

TEST_CASE("a hierarchy finds a hit of a shadow ray if and only if there is one", "[13.10][stability]") {
    check_families(judge_any, cases(25'000));
}

TEST_CASE("trees by codes find what is right", "[13.12][stability]") {
    for (const GridFamily& family : grid_families()) {
        const GridScene scene = make_scene_of_trees(family, seed);
        const Hierarchy tree = hierarchy_over(scene.shapes, {.method = SplitMethod::Codes, .most = 2});
        const Verdict verdict = judge_nearest(scene, tree, make_questions(scene, rays_a_scene, seed));
        INFO(family.name << " (" << family.extremes << "): " << describe(verdict));
        CHECK(verdict.mismatches == 0);
    }
}

TEST_CASE("no ray leaks through the edges and corners of a closed mesh", "[13.10][stability]") {
    Random random(1340);
    int leaks = 0, wrong = 0, wrong_by_naive = 0;
    const int scenes = 20, rays = cases(1000);
    for (int k = 0; k < scenes; ++k) {
        const std::vector<Triangle> mesh = closed_mesh(random, 6 + k);
        HierarchyOptions options = some_options(random);
        if (options.method == SplitMethod::Codes) options.method = SplitMethod::Sweep;
        const Hierarchy tree = build_hierarchy(mesh, options);
        Mailbox mailbox;
        for (int r = 0; r < rays; ++r) {
            const Ray ray = ray_at_edge(mesh, random);
            const std::optional<Hit> hit = closest_hit(tree, mesh, ray, ahead, mailbox);
            const std::optional<Hit> all = closest_hit(mesh, ray, ahead);
            if (!hit || !any_hit(tree, mesh, ray, ahead, mailbox)) ++leaks;
            if (!same_hit(hit, all)) ++wrong;
            if (!same_hit(naive::closest_hit(tree, mesh, ray, ahead), all)) ++wrong_by_naive;
        }
    }
    {
        INFO("how many of " << scenes * rays << " rays from inside of closed meshes come out of them");
        CHECK(leaks == 0);
    }
    {
        INFO("how many of them hit another triangle, or at another place, than by asking all");
        CHECK(wrong == 0);
    }
    INFO("the naive search has to fail here, else the rays show nothing; it was wrong " << wrong_by_naive
                                                                                        << " times");
    CHECK(wrong_by_naive > 0);
}

TEST_CASE("shapes whose sizes fall by halves: deep trees, and none too deep", "[13.10][stability]") {
    const std::vector<Sphere> spheres = ladder(400);
    std::vector<Bounds> boxes;
    for (const Sphere& sphere : spheres) boxes.push_back(bounds_of(sphere));
    for (const SplitMethod method : {SplitMethod::Halves, SplitMethod::Sweep, SplitMethod::Bins}) {
        const Hierarchy tree = build_hierarchy(boxes, {.method = method, .most = 1, .costs = {0.01, 1}});
        INFO("400 spheres of which each is half as large as the one before it, method "
             << static_cast<int>(method) << ": what the contract says of the tree");
        REQUIRE(is_right(tree, boxes, 1));
        Random random(1341);
        Mailbox mailbox;
        int wrong = 0;
        for (int k = 0; k < cases(1000); ++k) {
            const Sphere& at = spheres[random.index(random.index(2) == 0 ? 40 : 400)];
            const Ray ray =
                towards(random, at.center + at.radius * random.in_cube(), random.magnitude(-3, 1));
            if (!same_hit(closest_hit(tree, spheres, ray, ahead, mailbox), closest_hit(spheres, ray, ahead)))
                ++wrong;
        }
        INFO("how many rays do not find what asking all spheres finds");
        CHECK(wrong == 0);
    }
}

TEST_CASE("a scene scaled by a power of two has the same tree", "[13.10][stability]") {
    Random random(1342);
    for (const int exponent : {-90, -1, 3, 90})
        for (const SplitMethod method : {SplitMethod::Halves, SplitMethod::Sweep, SplitMethod::Bins}) {
            std::vector<Bounds> boxes, scaled;
            for (int k = 0; k < 100; ++k) {
                const Vec3 low = random.in_cube();
                boxes.push_back({low, low + random.magnitude(-3, 0) * glm::abs(random.in_cube())});
                const Real factor = std::ldexp(Real(1), exponent);
                scaled.push_back({boxes.back().low * factor, boxes.back().high * factor});
            }
            const Hierarchy tree = build_hierarchy(boxes, {.method = method, .most = 2});
            const Hierarchy other = build_hierarchy(scaled, {.method = method, .most = 2});
            INFO("100 random boxes by method " << static_cast<int>(method) << ", multiplied by 2^" << exponent
                                               << ": the tree, expected that of the boxes as they were");
            CHECK(same_tree(other, drawn(tree)));
            REQUIRE(other.nodes.size() == tree.nodes.size());
            for (std::size_t node = 0; node < tree.nodes.size(); ++node)
                CHECK(near(other.nodes[node].box.low,
                           tree.nodes[node].box.low * std::ldexp(Real(1), exponent), 0));
        }
}

TEST_CASE("a tree that was fitted to moved shapes finds what is right", "[13.11][stability]") {
    for (const GridFamily& family : grid_families()) {
        Verdict verdict;
        for (std::uint64_t k = 0; k < 3; ++k) {
            // Two scenes with as many shapes: the tree of one is fitted to the other.
            const GridScene scene = make_scene_of_trees(family, seed + k);
            std::vector<Bounds> boxes = boxes_of(scene.shapes), before = boxes;
            Random random(seed + k);
            std::shuffle(before.begin(), before.end(), random.engine);
            Real distortion = 1;
            std::visit(
                [&](const auto& some) {
                    for (const auto& shape : some)
                        if constexpr (requires { shape.transform; })
                            distortion = std::max(distortion, distortion_of(shape.transform));
                },
                scene.shapes);
            const Hierarchy tree =
                refit(build_hierarchy(before, {.method = SplitMethod::Halves, .most = 2}), boxes, distortion);
            INFO("seed " << seed + k << " of " << family.name << ": what the contract says of the tree");
            REQUIRE(is_right(tree, boxes, 2));
            add(verdict,
                judge_nearest(scene, tree,
                              make_questions(scene, static_cast<std::size_t>(cases(300)), seed + k)));
        }
        INFO(family.name << " (" << family.extremes
                         << "), shapes that have changed places: " << describe(verdict));
        CHECK(verdict.mismatches == 0);
    }
}
