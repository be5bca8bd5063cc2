// Step 01.6: the colour along a ray, and the loop over the pixels.
#include "chapters/01_ray_casting/raycast.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

/// Planes z = −1, −2, ... in this order, plane k with ambient (k + 1)/8 and emission (0, 0, 1/4), in front of
/// a sky.
World walls(int count) {
    World world;
    world.background = {0.5, 0.625, 0.75};
    world.integrator = Integrator::Flat;
    Group<Plane> planes;
    for (int k = 0; k < count; ++k) {
        const auto index = static_cast<std::uint32_t>(k);
        planes.shapes.push_back({{0, 0, -1.0 - k}, {0, 0, 1}});
        planes.primitive.push_back(index);
        world.primitives.push_back({.group = 0, .index = index, .material = index, .object = index});
        Material material;
        material.ambient = Vec3((k + 1) / 8.0);
        material.diffuse = Vec3(0.9);  // no light falls here: it must not show
        material.emission = Vec3(0, 0, 0.25);
        world.materials.push_back(material);
    }
    if (count > 0) world.groups.push_back(planes);
    return world;
}

/// Makes the world look along −z from the origin, orthographically: each pixel is 1 × 1, the ray through
/// the point (x, y) starts at (x − width/2, height/2 − y, 0).
World with_pixels(World world, int width, int height) {
    world.view.projection = Projection::Orthographic;
    world.view.width = width;
    world.view.height = height;
    world.view.half_height = height / 2.0;
    return world;
}

/// Positions up to 5 are off by some roundings at most, however a and b are computed.
constexpr Real bound = 64 * unit_roundoff;

Vec3 origin_as_color(const World&, const Ray& ray, Stream&) { return ray.origin; }

Vec3 cast_as_color(const World& world, const Ray& ray, Stream&) { return cast_ray(world, ray); }

void check_color(int count, const Ray& ray, const Vec3& color) {
    INFO(count << " walls at z = -1, -2, ..., wall k with ambient k/8 and emission (0, 0, 0.25); background "
                  "(0.5, 0.625, 0.75)\nthe colour of the "
               << ray);
    CHECK(near_color(cast_ray(walls(count), ray), color, 0));
}

/// The colours of a tile, as many as it has pixels.
std::vector<Vec3> tile_of(const World& world, const Tile& tile, const RayColor& color) {
    const std::vector<Vec3> colors = render_tile(world, tile, color);
    INFO("how many colours there are of the tile from (" << tile.x0 << ", " << tile.y0 << ") to (" << tile.x1
                                                         << ", " << tile.y1 << "), a pixel each");
    REQUIRE(colors.size() == static_cast<std::size_t>((tile.x1 - tile.x0) * (tile.y1 - tile.y0)));
    return colors;
}

}  // namespace

TEST_CASE("a ray that meets nothing shows the background", "[01.6]") {
    const Ray away{{0, 0, 0}, {0, 0, 1}};
    check_color(0, away, {0.5, 0.625, 0.75});
    check_color(2, away, {0.5, 0.625, 0.75});
}

TEST_CASE("a ray shows ambient plus emission of what it meets", "[01.6]") {
    check_color(1, {{0, 0, 0}, {0, 0, -1}}, {0.125, 0.125, 0.375});
}

TEST_CASE("a ray shows the nearest thing in front of it", "[01.6]") {
    check_color(3, {{0, 0, 0}, {0, 0, -1}}, {0.125, 0.125, 0.375});
    check_color(3, {{0, 0, -1.5}, {0, 0, -1}}, {0.25, 0.25, 0.5});
    check_color(3, {{0, 0, -9}, {0, 0, 1}}, {0.375, 0.375, 0.625});
}

TEST_CASE("a ray goes on as far as there is something", "[01.6]") {
    check_color(1, {{0, 0, 1e12}, {0, 0, -1}}, {0.125, 0.125, 0.375});
    check_color(1, {{0, 0, 0}, {0, 0, -1e-15}}, {0.125, 0.125, 0.375});
}

TEST_CASE("a tile comes row by row from its top left, each pixel seen through its centre", "[01.6]") {
    const World world = with_pixels(walls(0), 4, 2);
    const std::vector<Vec3> colors = tile_of(world, {.x0 = 0, .y0 = 0, .x1 = 4, .y1 = 2}, origin_as_color);
    const auto check = [&](std::size_t i, const Vec3& origin) {
        INFO("of 4 x 2 pixels number " << i << ", counted from 0: where its ray starts");
        CHECK(near(colors[i], origin, bound));
    };
    check(0, {-1.5, 0.5, 0});
    check(1, {-0.5, 0.5, 0});
    check(3, {1.5, 0.5, 0});
    check(4, {-1.5, -0.5, 0});
    check(7, {1.5, -0.5, 0});
}

TEST_CASE("a tile inside the picture holds its own pixels and no others", "[01.6]") {
    const World world = with_pixels(walls(0), 10, 8);
    const std::vector<Vec3> colors = tile_of(world, {.x0 = 3, .y0 = 2, .x1 = 5, .y1 = 5}, origin_as_color);
    for (int y = 2; y < 5; ++y) {
        for (int x = 3; x < 5; ++x) {
            INFO("a tile from (3, 2) to (5, 5); where the ray of pixel (" << x << ", " << y << ") starts");
            const auto place = static_cast<std::size_t>((y - 2) * 2 + x - 3);
            CHECK(near(colors[place], Vec3(x + 0.5 - 5, 4 - (y + 0.5), 0), bound));
        }
    }
}

TEST_CASE("a tile of one pixel, and empty ones", "[01.6]") {
    const World world = with_pixels(walls(0), 4, 2);
    const std::vector<Vec3> last = tile_of(world, {.x0 = 3, .y0 = 1, .x1 = 4, .y1 = 2}, origin_as_color);
    INFO("where the ray of the one pixel starts");
    CHECK(near(last[0], Vec3(1.5, -0.5, 0), bound));
    tile_of(world, {.x0 = 2, .y0 = 0, .x1 = 2, .y1 = 2}, origin_as_color);
    tile_of(world, {.x0 = 0, .y0 = 1, .x1 = 4, .y1 = 1}, origin_as_color);
}

TEST_CASE("tiles side by side make the same picture as one tile", "[01.6]") {
    Random random(61);
    for (int i = 0; i < cases(100); ++i) {
        const int width = 1 + static_cast<int>(random.index(20)),
                  height = 1 + static_cast<int>(random.index(20));
        World world = with_pixels(walls(0), width, height);
        world.view.projection = Projection::Perspective;
        const auto direction = [](const World&, const Ray& ray, Stream&) { return ray.direction; };
        const Tile whole{.x0 = 0, .y0 = 0, .x1 = width, .y1 = height};
        const std::vector<Vec3> picture = tile_of(world, whole, direction);
        const int x = static_cast<int>(random.index(static_cast<std::size_t>(width))), y = height / 2;
        for (const Tile& tile :
             {Tile{0, 0, x, y}, Tile{x, 0, width, y}, Tile{0, y, x, height}, Tile{x, y, width, height}}) {
            const std::vector<Vec3> part = tile_of(world, tile, direction);
            std::size_t next = 0;
            for (int row = tile.y0; row < tile.y1; ++row) {
                for (int column = tile.x0; column < tile.x1; ++column) {
                    INFO("a picture of " << width << " x " << height << " pixels in tiles: the pixel ("
                                         << column << ", " << row << "), and the same in one tile");
                    REQUIRE(part[next++] == picture[static_cast<std::size_t>(row * width + column)]);
                }
            }
        }
    }
}

TEST_CASE("the loop hands on the world that it was given", "[01.6]") {
    const World world = with_pixels(walls(2), 2, 2);
    INFO("a wall of colour (0.125, 0.125, 0.375) fills the picture");
    for (const Vec3& color : tile_of(world, {.x0 = 0, .y0 = 0, .x1 = 2, .y1 = 2}, cast_as_color))
        CHECK(near_color(color, {0.125, 0.125, 0.375}, 0));
}

TEST_CASE("each pixel has random numbers of its own, the same in any tile", "[01.6]") {
    const World world = with_pixels(walls(0), 4, 3);
    const RayColor noise = [](const World&, const Ray&, Stream& stream) {
        const Vec3 color(stream.x, stream.y, 10 * stream.sample + stream.dimension);
        next_real(stream);
        return color;
    };
    for (const Tile& tile : {Tile{0, 0, 4, 3}, Tile{1, 2, 4, 3}}) {
        const std::vector<Vec3> colors = tile_of(world, tile, noise);
        std::size_t next = 0;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                INFO("the stream of pixel (" << x << ", " << y << "): its x, its y, and how much was taken");
                CHECK(near(colors[next++], Vec3(x, y, 0), 0));
            }
    }
}
