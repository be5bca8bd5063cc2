// The recorded ray tree: the same colour as the renderer's, and what it says of decisions.
#include "chapters/01_ray_casting/camera.hpp"
#include "common/math/error.hpp"
#include "common/render/compile.hpp"
#include "common/render/decisions.hpp"
#include "common/render/integrators.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/worlds.hpp"

#include <algorithm>

using namespace rt;

namespace {

/// A mirror ball, a glass ball with absorption and a checkered ground under two lights.
constexpr const char* balls = R"(version 1
size 48 32
maxdepth 5
camera 0 1 6  0 0.5 0  0 1 0  45
background .2 .3 .5
point 3 5 4  .6 .6 .6
directional -1 2 1  .3 .3 .3
ambient .05 .05 .05
diffuse .6 .5 .4
checker 1 1 1  .3 .3 .3  .7
plane 0 -.5 0  0 1 0
checker 1 1 1  1 1 1  1
diffuse .1 .1 .1
specular .7 .6 .5
shininess 30
sphere -1.1 .4 0 .9
specular 0 0 0
transmission .9 .95 .9
ior 1.5
fresnel exact
absorption .3 .1 .2
sphere 1.1 .4 .5 .9
)";

Ray ray_of(const World& world, int x, int y) { return pixel_ray(world.view, x + 0.5, y + 0.5); }

}  // namespace

TEST_CASE("the sum over a recorded tree is the pixel's colour") {
    const World world = test::world_of(balls);
    std::size_t deepest = 0;
    for (int y = 0; y < world.view.height; ++y)
        for (int x = 0; x < world.view.width; ++x) {
            const Ray ray = ray_of(world, x, y);
            const std::vector<TraceRecord> tree = trace_tree(world, ray);
            Vec3 sum(0);
            for (const TraceRecord& record : tree) sum += record.weight * record.local;
            const Vec3 color = color_along(world, ray);
            CAPTURE(x, y, tree.size());
            // The same terms, added in another order: at most one rounding a light and a ray.
            for (int i = 0; i < 3; ++i)
                REQUIRE(std::abs(sum[i] - color[i]) <=
                        gamma(4 * static_cast<int>(tree.size()) + 8) * color[i]);
            deepest = std::max(deepest, tree.size());
        }
    CHECK(deepest > 8);
}

TEST_CASE("a recorded tree says who spawned whom, and how deep") {
    const World world = test::world_of(balls);
    const std::vector<TraceRecord> tree = trace_tree(world, ray_of(world, 33, 15));
    REQUIRE(tree.size() > 3);
    CHECK(tree[0].parent == -1);
    CHECK(tree[0].branch.kind == RayKind::Camera);
    for (std::size_t i = 1; i < tree.size(); ++i) {
        REQUIRE(tree[i].parent >= 0);
        REQUIRE(tree[i].parent < static_cast<int>(i));
        const Branch& parent = tree[static_cast<std::size_t>(tree[i].parent)].branch;
        CHECK(tree[i].branch.depth == parent.depth + 1);
        CHECK(tree[i].branch.kind != RayKind::Camera);
    }
}

TEST_CASE("a recorded tree ends where it is told to, with the rays that it would begin with") {
    const World world = test::world_of(balls);
    const Ray ray = ray_of(world, 33, 15);
    const std::vector<TraceRecord> whole = trace_tree(world, ray), part = trace_tree(world, ray, 3);
    REQUIRE(whole.size() > 3);
    REQUIRE(part.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(part[i].parent == whole[i].parent);
        CHECK(part[i].local == whole[i].local);
    }
}

TEST_CASE("the tree of a sample is what the renderer adds up, whatever is random about it") {
    const std::string things =
        "size 24 18\ncamera 0 2 5  0 .4 0  0 1 0  40\nspp 4\nbackground .2 .3 .4\nmaxdepth 3\nlightsamples "
        "2\n"
        "directional 1 2 1  .4 .4 .4\nquadLight -1 3 -1  0 0 2  2 0 0  3 3 3\ndiffuse .5 .3 .2\n"
        "specular .3 .3 .3\nplane 0 0 0  0 1 0\n";
    const std::string ball =
        "motion .3 0 0\nsphere -.8 .6 0 .6\nmotion 0 0 0\ntransmission .8 .8 .8\nior 1.4\n";
    for (const char* spread : {"", "gloss 30\ntranslucency 50\n", "brdf ggx\nroughness .3\n",
                               "lightchoice one\n", "integrator direct\n"}) {
        INFO(spread);
        const World world = test::world_of(spread + things + ball + "sphere .8 .6 .4 .6\n");
        REQUIRE(world.needs.distribution);
        std::size_t most = 0;
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 24; ++x) {
                Stream stream = stream_of(world, x, y);
                const Ray ray = camera_ray(world, Vec2(x + 0.5, y + 0.5), stream);
                const std::vector<TraceRecord> tree = trace_sample(world, ray, stream);
                Vec3 sum(0);
                for (const TraceRecord& record : tree) sum += record.weight * record.local;
                most = std::max(most, tree.size());
                const Vec3 color = color_function(world)(world, ray, stream);
                CHECK(length(sum - color) <= 1e-12 * length(color));
            }
        CHECK(most > (world.integrator == Integrator::Direct ? 0u : 3u));
    }
}

TEST_CASE("decisions change where something else is hit, and not inside of one surface") {
    const World world = test::world_of(R"(size 9 9
camera 0 0 5  0 0 0  0 1 0  45
ambient .5 .5 .5
sphere 0 0 0 1
)");
    const std::vector<std::uint64_t> all = decisions(world);
    const auto at = [&](int x, int y) { return all[static_cast<std::size_t>(y * 9 + x)]; };
    CHECK(at(0, 0) == at(8, 8));
    CHECK(at(4, 4) == at(5, 4));
    CHECK(at(4, 4) != at(0, 0));
}

TEST_CASE("decisions change at the edge of a shadow and at the edge of a square") {
    const World lit = test::world_of(R"(version 1
size 40 40
camera 0 6 0.001  0 0 0  0 0 -1  45
point 0 4 0  1 1 1
diffuse 1 1 1
plane 0 0 0  0 1 0
sphere 0 2 0 .5
)");
    const auto different = [](std::vector<std::uint64_t> all) {
        std::sort(all.begin(), all.end());
        return std::unique(all.begin(), all.end()) - all.begin();
    };
    // The ball where it faces the light and where it does not, the ground in the light and in the shadow.
    CHECK(different(decisions(lit)) == 4);

    const World checkered = test::world_of(R"(version 1
size 40 40
camera 0 6 0.001  0 0 0  0 0 -1  45
integrator flat
ambient .5 .5 .5
checker 1 1 1  .2 .2 .2  1
plane 0 0 0  0 1 0
)");
    CHECK(different(decisions(checkered)) == 2);
}
