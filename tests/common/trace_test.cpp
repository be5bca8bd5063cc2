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

TEST_CASE("a recorded tree says how finishes spread the light of lamps and of the sky") {
    const std::string things =
        "size 24 18\ncamera 0 2 5  0 .4 0  0 1 0  40\nmaxdepth 3\nskyGradient .1 .2 .4  .3 .3 .3  .1 .1 0\n"
        "directional 1 2 1  .4 .4 .4\npoint 0 1 -3  .5 .5 .5\ndiffuse .5 .3 .2\nspecular .3 .3 .3\nior 1.5\n"
        "plane 0 0 0  0 1 0\nsphere -.8 .6 0 .6\ntransmission .5 .5 .5\nsphere .8 .6 .4 .6\n";
    const std::string area_light = "quadLight -1 3 -1  0 0 2  2 0 0  3 3 3\n";
    for (const std::string finish : {"plain", "matte 1", "velvet .4", "metal .4", "coated 1.6", "glass .5"})
        for (const std::string rest :
             {"", "skylight on\n", "stripes .5 1 1 .25 1 1 .3\ntextured finish coat\n"})
            for (const std::string& lights : {std::string(), area_light}) {
                INFO("finish " << finish << "\n" << rest << lights);
                const World world = test::world_of(lights + "finish " + finish + "\n" + rest + things);
                std::size_t lobes = 0;
                for (int y = 0; y < 18; ++y)
                    for (int x = 0; x < 24; ++x) {
                        const Ray ray = ray_of(world, x, y);
                        const std::vector<TraceRecord> tree =
                            lights.empty() ? trace_tree(world, ray) : trace_sample(world, ray, Stream());
                        Vec3 sum(0);
                        for (const TraceRecord& record : tree) {
                            sum += record.weight * record.local;
                            CHECK((record.skylight == Vec3(0) || world.needs.skylight));
                            Vec3 of_lights(0);
                            for (const LightRecord& light : record.lights) {
                                of_lights += light.contribution;
                                CHECK(light.lobe.has_value() == record.finish.has_value());
                                lobes += light.lobe.has_value();
                            }
                            if (!record.hit || record.material >= world.materials.size()) continue;
                            const Material& m = world.materials[record.material];
                            const Vec3 all = m.ambient + m.emission + record.skylight + of_lights;
                            if (record.local != Vec3(3) &&
                                record.local != Vec3(0))  // of the area light itself
                                CHECK(length(all - record.local) <= 1e-12 * length(all));
                        }
                        Stream stream;
                        const Vec3 color = color_function(world)(world, ray, stream);
                        CHECK(length(sum - color) <= 1e-12 * length(color));
                    }
                CHECK((lobes > 0) == (finish != "plain"));
            }
}

TEST_CASE("a recorded tree says how far rays are spread, by the numbers of the place") {
    const auto spread = [](const std::string& text) {
        const World world = test::world_of(
            "size 8 8\ncamera 0 0 4  0 0 0  0 1 0  20\ntransmission .5 .5 .5\n"
            "ior 1.5\nspecular .5 .5 .5\nstripes .5 1 1 .5 1 1 1\n" +
            text + "sphere 0 0 0 1\n");
        return trace_sample(world, ray_of(world, 4, 4), Stream()).front().spread;
    };
    const SpreadRecord lobes = spread("gloss 40\ntranslucency 30\ntextured gloss\n");
    CHECK(lobes.gloss == 20);
    CHECK(lobes.translucency == 30);
    CHECK(lobes.alpha == 0);
    CHECK(spread("brdf ggx\nroughness .5\ntextured roughness\n").alpha == 0.25);
    CHECK(spread("brdf ggx\nroughness .5\n").alpha == 0.5);
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
