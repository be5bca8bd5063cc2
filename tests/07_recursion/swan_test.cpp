// Step 07.6 on the chapter's ice sculpture: a closed surface lets no ray leak.
#include "chapters/01_ray_casting/camera.hpp"
#include "common/render/compile.hpp"
#include "common/render/trace.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <cmath>
#include <map>
#include <utility>

using namespace rt;
using namespace rt::test;

namespace {

Scene ice() { return parse_scene(repository() + "/references/07_recursion/ice.scene"); }

}  // namespace

TEST_CASE("the swan is one closed surface: each edge occurs once in either direction", "[07.6]") {
    const Scene scene = ice();
    REQUIRE(scene.meshes.size() == 1);
    std::map<std::pair<int, int>, int> edges;
    for (const auto& corner : scene.meshes[0].triangles)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{corner[i].position, corner[(i + 1) % 3].position}];
    for (const auto& [edge, count] : edges) {
        const bool matched = count == 1 && edges.count({edge.second, edge.first}) == 1;
        if (!matched) FAIL("edge from vertex " << edge.first << " to " << edge.second);
    }
    CHECK(edges.size() == 3 * scene.meshes[0].triangles.size());
}

TEST_CASE("what has left the swan is outside of it, and blue is what ice leaves of white", "[07.6]") {
    Scene scene = ice();
    scene.width = cases(80) < 80 ? 16 : 80;
    scene.height = scene.width * 3 / 4;
    // Long trees, pruned where nothing is to be seen any more.
    scene.max_depth = 100;
    scene.min_contribution = 1e-3;
    const World world = compile(scene);
    int through = 0;
    for (int y = 0; y < scene.height; ++y) {
        for (int x = 0; x < scene.width; ++x) {
            for (const TraceRecord& record : trace_tree(world, pixel_ray(world.view, x + 0.5, y + 0.5))) {
                // Only the swan's inner side can be met from inside, and the sky only from outside.
                const bool inside = !record.branch.media.empty();
                const bool at_swan = record.hit && world.materials[record.material].transmission != Vec3(0);
                INFO("pixel " << x << " " << y << ", depth " << record.branch.depth);
                if (inside && !at_swan) FAIL("a ray leaked out of the ice");
                if (!inside) continue;
                ++through;
                const Vec3& before = record.branch.weight;
                const Vec3 left(record.weight.x / before.x, record.weight.y / before.y,
                                record.weight.z / before.z);
                const bool blue = left.x < left.y && left.y < left.z && left.z < 1;
                if (!blue) FAIL("not absorbed: " << left.x << " " << left.y << " " << left.z);
                // Each channel by its own coefficient over the same way.
                const Real way = -std::log(left.x) / 0.8;
                CHECK(std::abs(-std::log(left.z) / 0.08 - way) <= 1e-9 * (1 + way));
            }
        }
    }
    CHECK(through > 10);
}
