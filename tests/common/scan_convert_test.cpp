// Scan conversion finds what ray casting finds, pixel by pixel.
#include "common/render/scan_convert.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "common/math/input_error.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "tests/worlds.hpp"

#include <cmath>

using namespace rt;

namespace {

/// Seen from (0, 0, 5).
World seen(const std::string& text) { return test::world_of("camera 0 0 5  0 0 0  0 1 0  40\n" + text); }

World knot(const std::string& more = "") {
    return test::world_of(
        "size 160 120\nintegrator normals\nmesh knot_smooth.obj\n"
        "camera 1.5 -4.5 8.5  0 -.1 0  0 1 0  42\n" +
            more,
        test::repository() + "/references/03_triangles");
}

std::vector<std::optional<Hit>> cast_rays(const World& world) {
    std::vector<std::optional<Hit>> hits;
    for (int y = 0; y < world.view.height; ++y)
        for (int x = 0; x < world.view.width; ++x)
            hits.push_back(closest_hit(world, pixel_ray(world.view, x + 0.5, y + 0.5), {0, infinity}));
    return hits;
}

/// Which triangle a hit is on; −1 for none.
std::pair<std::int64_t, std::int64_t> identity(const std::optional<Hit>& hit) {
    if (!hit) return {-1, -1};
    return {hit->primitive, hit->element};
}

struct Agreement {
    int differing = 0;        ///< pixels with another triangle
    int off_silhouettes = 0;  ///< of those, the ones whose eight neighbours all see the same as they do
    Real greatest_error = 0;  ///< of t, relative, and of the weights, where the triangle is the same
    int covered = 0;
};

Agreement compare_hits(const World& world) {
    const auto cast = cast_rays(world), scanned = scan_convert(world);
    REQUIRE(cast.size() == scanned.size());
    const int width = world.view.width, height = world.view.height;
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    Agreement result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto &c = cast[at(x, y)], &s = scanned[at(x, y)];
            result.covered += c.has_value();
            if (identity(c) != identity(s)) {
                ++result.differing;
                bool silhouette = false;
                for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
                    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
                        silhouette = silhouette || identity(cast[at(i, j)]) != identity(c);
                result.off_silhouettes += !silhouette;
            } else if (c) {
                const Vec2 uv = glm::abs(c->uv - s->uv);
                result.greatest_error =
                    std::max({result.greatest_error, std::abs(c->t - s->t) / c->t, uv.x, uv.y});
            }
        }
    return result;
}

void check_agreement(const World& world, int least_covered) {
    const Agreement result = compare_hits(world);
    INFO(result.covered << " pixels covered, " << result.differing << " differ, " << result.off_silhouettes
                        << " of them away from silhouettes; greatest error " << result.greatest_error);
    CHECK(result.covered >= least_covered);
    // Only a sample that rounding puts on the other side of an edge may differ.
    CHECK(result.differing <= result.covered / 1000 + 1);
    CHECK(result.off_silhouettes == 0);
    // A triangle of the knot seen at a slant, from 10 of its sizes away, amplifies rounding by 1e5 at most.
    CHECK(result.greatest_error <= 1e-10);
}

}  // namespace

TEST_CASE("scan conversion sees the same triangles as ray casting, in perspective") {
    check_agreement(knot(), 5000);
}

TEST_CASE("scan conversion sees the same triangles as ray casting, in an orthographic view") {
    check_agreement(knot("orthographic 8\n"), 5000);
}

TEST_CASE("from inside a mesh, with triangles around and behind the eye, both see the same") {
    check_agreement(knot("camera 3 0 0  2.4 1.5 .2  0 0 1  70\n"), 10000);
    check_agreement(knot("camera 0 0 0  1 .3 -.2  0 0 1  100\n"), 5000);
    check_agreement(knot("camera 0 0 0  0 0 -1  0 1 0  60\northographic 8\n"), 4000);
}

TEST_CASE("scan conversion and ray casting paint the same picture") {
    World world = knot();
    const Image cast = render(world).image;
    const Image scanned = rasterize(world);
    const auto rays = cast_rays(world), raster = scan_convert(world);
    for (std::size_t i = 0; i < cast.pixels.size(); ++i) {
        if (identity(rays[i]) != identity(raster[i])) continue;
        INFO("pixel " << i % 160 << ", " << i / 160);
        REQUIRE(glm::length(cast.pixels[i] - scanned.pixels[i]) <= 1e-9);
    }
}

TEST_CASE("a triangle that reaches behind the eye covers the pixels that see it") {
    // A ground that begins far behind the eye: everything below the horizon.
    const World ground =
        seen("size 64 48\nvertex 0 -1 -1e6\nvertex -1e6 -1 1e3\nvertex 1e6 -1 1e3\ntri 0 1 2\n");
    const auto hits = scan_convert(ground);
    CHECK_FALSE(hits[0]);
    CHECK(hits.back());
    check_agreement(ground, 64 * 20);
}

TEST_CASE("what lies behind the eye is not drawn") {
    const std::string triangle = "size 8 8\nvertex -50 -50 9\nvertex 50 -50 9\nvertex 0 80 9\ntri 0 1 2\n";
    for (const auto& hit : scan_convert(seen(triangle))) REQUIRE_FALSE(hit);
    for (const auto& hit : scan_convert(seen(triangle + "orthographic 4\n"))) REQUIRE_FALSE(hit);
}

TEST_CASE("of equally near triangles the first in the file is drawn") {
    const std::string both =
        "size 8 8\nvertex -5 -5 0\nvertex 5 -5 0\nvertex 0 8 0\n"
        "tri 0 1 2\ntri 0 1 2\n";
    for (const auto& hit : scan_convert(seen(both))) {
        REQUIRE(hit);
        REQUIRE(hit->primitive == 0);
    }
}

TEST_CASE("t is the distance along the pixel's ray, not the depth") {
    const World world = seen("size 9 9\nvertex -50 -50 0\nvertex 50 -50 0\nvertex 0 80 0\ntri 0 1 2\n");
    const auto hits = scan_convert(world);
    REQUIRE(hits[40]);
    CHECK(hits[40]->t == Approx(5).epsilon(1e-14));
    REQUIRE(hits[0]);
    // The corner pixel's centre is 4/9 of the picture's height from the middle, in both directions.
    const Real side = 8.0 / 9 * std::tan(radians(20));
    CHECK(hits[0]->t == Approx(5 * std::sqrt(1 + 2 * side * side)).epsilon(1e-14));
}

TEST_CASE("a triangle seen edge-on is not drawn") {
    const std::string edge_on = "size 9 9\nvertex 0 -5 0\nvertex 0 5 0\nvertex 0 0 3\ntri 0 1 2\n";
    for (const auto& hit : scan_convert(seen(edge_on))) REQUIRE_FALSE(hit);
    for (const auto& hit : scan_convert(seen(edge_on + "orthographic 4\n"))) REQUIRE_FALSE(hit);
}

TEST_CASE("scan conversion refuses other shapes than triangles") {
    CHECK_THROWS_AS(scan_convert(seen("sphere 0 0 0 1\n")), InputError);
}

TEST_CASE("an empty world is an empty picture") {
    World world = seen("size 4 3\nbackground .25 .5 .75\n");
    for (const Vec3& color : rasterize(world).pixels) REQUIRE(color == Vec3(0.25, 0.5, 0.75));
}
