// Grids against asking every shape, to the bit, on scenes and rays made to break them.
// Families and demand: tests/stability/grids.hpp.
#include "tests/catch.hpp"
#include "tests/stability/grids.hpp"
#include "tests/support.hpp"

#include <iostream>

using namespace rt;
using namespace rt::stability;
using rt::test::cases;

namespace {

constexpr std::uint64_t seed = 9;
constexpr std::size_t rays_a_scene = 100;

using Judge = Verdict (*)(const GridScene&, std::span<const GridQuestion>);

void check_families(Judge judge, int rays) {
    for (const GridFamily& family : grid_families()) {
        Verdict verdict;
        const auto scenes = static_cast<std::size_t>(rays) / rays_a_scene / grid_families().size() + 1;
        for (std::uint64_t k = 0; k < scenes; ++k) {
            const GridScene scene = make_scene(family, seed + k);
            const Verdict one = judge(scene, make_questions(scene, rays_a_scene, seed + k));
            add(verdict, one);
            if (one.mismatches > 0) {
                INFO("seed " << seed + k << " of " << family.name);
                CHECK(one.mismatches == 0);
                break;
            }
        }
        INFO(family.name << " (" << family.extremes << "): " << describe(verdict));
        CHECK(verdict.mismatches == 0);
    }
}

}  // namespace

TEST_CASE("the nearest hit by a grid is, to the bit, the nearest of all", "[09.7][stability]") {
    check_families(judge_nearest, cases(100'000));
}

TEST_CASE("any hit by a grid is whether there is one at all", "[09.8][stability]") {
    check_families(judge_any, cases(50'000));
}

TEST_CASE("a search that stops at the first hit breaks on the families", "[stability]") {
    std::size_t wrong = 0, asked = 0;
    for (const GridFamily& family : grid_families())
        for (std::uint64_t k = 0; k < 20; ++k) {
            const GridScene scene = make_scene(family, seed + k);
            const auto* triangles = std::get_if<std::vector<Triangle>>(&scene.shapes);
            if (!triangles || !scene.grid.grids.empty()) continue;
            for (const GridQuestion& question : make_questions(scene, 50, seed + k)) {
                const std::optional<Hit> right = nearest_of_all(scene, question);
                const std::optional<Hit> naive =
                    naive::closest_hit(scene.grid, *triangles, question.ray, question.range);
                ++asked;
                wrong +=
                    right.has_value() != naive.has_value() || (right && right->primitive != naive->primitive);
            }
        }
    INFO(wrong << " of " << asked << " rays");
    CHECK(wrong > asked / 1000);
}
