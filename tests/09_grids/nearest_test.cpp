// What is found by a grid, the nearest hit or any: the same as by asking all, with few questions.
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "tests/09_grids/show.hpp"
#include "tests/catch.hpp"
#include "tests/stability/grids.hpp"
#include "tests/support.hpp"

#include <algorithm>

using namespace rt;
using rt::test::cases;
using rt::test::Random;
using rt::test::show;

namespace {

/// Without grids in it, unless they are asked for.
template <class Shape>
Grid grid_of(const std::vector<Shape>& shapes, const GridOptions& options = {.nested = false}) {
    return build_grid(std::span<const Shape>(shapes), options);
}

template <class Shape>
std::optional<Hit> nearest(const Grid& grid, const std::vector<Shape>& shapes, const Ray& ray,
                           Interval range = {}) {
    Mailbox mailbox;
    return closest_hit(grid, shapes, ray, range, mailbox);
}

/// What is counted while `action` runs.
template <class Action>
SearchCounts counted(const Action& action) {
    const SearchCounts before = search_counts();
    action();
    return {search_counts().cells - before.cells, search_counts().shapes - before.shapes};
}

/// Which shapes a search asks along a row of cells, where a hit at t = `end` is known from the first on.
std::vector<std::uint32_t> asked_along_x(const Grid& grid, Real end) {
    std::vector<std::uint32_t> asked;
    const auto ask = [&](std::span<const std::uint32_t> shapes, Interval) {
        asked.insert(asked.end(), shapes.begin(), shapes.end());
        return end;
    };
    search(grid, {{0, 0.5, 0.5}, {1, 0, 0}}, {}, ask);
    return asked;
}

/// Three cells of edge 1 along x. The first lists shape 0, the third shape 2; the second has a grid that
/// takes up its first half, and lists shape 1.
Grid with_grid_in_second_cell() {
    Grid grid, inner;
    grid.shape = {{Vec3(0), {3, 1, 1}}, {3, 1, 1}};
    grid.first = {0, 1, 1, 2};
    grid.items = {0, 2};
    grid.inner = {0, 1, 0};
    inner.shape = {{{1, 0, 0}, {1.5, 1, 1}}, {1, 1, 1}};
    inner.first = {0, 1};
    inner.items = {1};
    grid.grids = {inner};
    return grid;
}

/// How many shapes the mailbox's last ray asked.
std::uint64_t marked(const Mailbox& mailbox) {
    return static_cast<std::uint64_t>(std::ranges::count(mailbox.asked_by, mailbox.ray));
}

/// Spheres of radius 0.4 at 0, 1, ..., count − 1 on the x axis.
std::vector<Sphere> row_of_spheres(int count) {
    std::vector<Sphere> spheres;
    for (int k = 0; k < count; ++k) spheres.push_back({{k, 0, 0}, 0.4});
    return spheres;
}

/// A ball of small triangles on a large floor.
std::vector<Triangle> ball_in_stadium() {
    const int n = 24;
    std::vector<Triangle> triangles;
    const auto at = [&](int i, int j) {
        const Real u = 2 * pi * i / (2 * n), v = pi * j / n;
        return Vec3(10 + std::sin(v) * std::cos(u), 1 + std::cos(v), 10 + std::sin(v) * std::sin(u));
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < 2 * n; ++i) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    triangles.push_back({{-1000, 0, -1000}, {-1000, 0, 1000}, {1000, 0, 1000}});
    triangles.push_back({{-1000, 0, -1000}, {1000, 0, 1000}, {1000, 0, -1000}});
    return triangles;
}

/// Camera rays that all pass near the ball.
std::vector<Ray> rays_at_ball(int count) {
    Random random(930);
    std::vector<Ray> rays;
    for (int k = 0; k < count; ++k) {
        const Vec3 from(13, 4, 20);
        rays.push_back({from, Vec3(10, 1, 10) + random.in_cube() - from});
    }
    return rays;
}

}  // namespace

TEST_CASE("a shape may be hit far ahead of the cell in which it is asked", "[09.12]") {
    // The ray comes into its cells at a quarter of its length, and meets it near the end.
    const std::vector<Triangle> triangles{{{0, 0.8, 0}, {10, 0.92, 0}, {10, 0.92, 2}}};
    const Ray ray{{-1, 0.9, 0.5}, {1, 0, 0}};
    const std::optional<Hit> alone = closest_hit(triangles, ray, {});
    REQUIRE(alone);
    const std::optional<Hit> hit =
        nearest(grid_of(triangles, {.density = 500, .nested = false}), triangles, ray);
    INFO("a long slanted triangle, " << ray << "; expected what asking it without a grid says");
    CHECK(test::same_hit(hit, alone));
}

TEST_CASE("the nearest of a row of spheres", "[09.12]") {
    const std::vector<Sphere> spheres = row_of_spheres(10);
    const Grid grid = grid_of(spheres);
    REQUIRE(grid.shape.cells.x > 10);
    const auto check = [&](const Ray& ray, Interval range, std::uint32_t primitive, Real t) {
        const std::optional<Hit> hit = nearest(grid, spheres, ray, range);
        INFO("spheres of radius 0.4 at 0, 1, ... 9 on the x axis; " << ray << " in " << range
                                                                    << ": which is hit, and at which t");
        REQUIRE(hit);
        CHECK(hit->primitive == primitive);
        CHECK(hit->t == Approx(t));
    };
    check({{-5, 0, 0}, {1, 0, 0}}, {}, 0, 4.6);
    check({{15, 0, 0}, {-1, 0, 0}}, {}, 9, 5.6);
    check({{4.5, 0, 0}, {1, 0, 0}}, {}, 5, 0.1);
    check({{4, 0, 0}, {0, 2, 0}}, {}, 4, 0.2);
    check({{-5, 0, 0}, {1, 0, 0}}, {7.5, infinity}, 3, 7.6);
    INFO("the row of spheres: before it, away from it, and between two");
    CHECK_FALSE(nearest(grid, spheres, {{-5, 0, 0}, {1, 0, 0}}, {0, 4.5}));
    CHECK_FALSE(nearest(grid, spheres, {{-5, 0, 0}, {-1, 0, 0}}));
    CHECK_FALSE(nearest(grid, spheres, {{0.5, -5, 0}, {0, 1, 0}}));
}

TEST_CASE("the search goes on to the cell of the hit, and no farther", "[09.12]") {
    // Eight cells of edge 1; the first lists shape 0, the fifth shape 1.
    Grid grid;
    grid.shape = {{Vec3(0), {8, 1, 1}}, {8, 1, 1}};
    grid.first = {0, 1, 1, 1, 1, 2, 2, 2, 2};
    grid.items = {0, 1};
    const auto check = [&](Real end, std::uint64_t cells, const std::vector<std::uint32_t>& expected) {
        std::vector<std::uint32_t> asked;
        const SearchCounts counts = counted([&] { asked = asked_along_x(grid, end); });
        INFO("a row of 8 cells of edge 1; shape 0, in the first, is hit at t = " << end);
        {
            INFO("which shapes are asked");
            CHECK(test::or_say(asked == expected, show(asked) + ", expected " + show(expected)));
        }
        INFO("how many cells are visited: up to the one where the hit lies");
        CHECK(counts.cells == cells);
    };
    check(0.5, 1, {0});
    check(3.5, 4, {0});
    check(6.5, 7, {0, 1});
    check(infinity, 8, {0, 1});
    // Just where a cell ends, the next one may list another that is as near.
    check(4, 5, {0, 1});
}

TEST_CASE("a hit in a later cell does not hide a nearer one of another shape", "[09.12]") {
    // The long triangle is asked first, because it reaches into the first cell, but the ray meets it far
    // away.
    const std::vector<Triangle> triangles{{{0, 0.8, 0}, {10, 0.92, 0}, {10, 0.92, 2}},
                                          {{5, 0, 0}, {5, 2, 0}, {5, 0, 2}}};
    const Grid grid = grid_of(triangles, {.density = 50, .nested = false});
    const Ray ray{{-1, 0.9, 0.5}, {1, 0, 0}};
    const std::optional<Hit> hit = nearest(grid, triangles, ray);
    {
        INFO("triangle 0 is long, hit at t = 9.33; triangle 1 stands across before it, at t = 6; found: "
             << hit);
        REQUIRE(hit);
        CHECK(hit->primitive == 1);
        CHECK(hit->t == Approx(6));
    }
    INFO("a search that stops in the first cell with a hit has to be wrong here");
    const std::optional<Hit> naive = naive::closest_hit(grid, triangles, ray, {});
    REQUIRE(naive);
    CHECK(naive->primitive == 0);
}

TEST_CASE("of equal distances the lowest index wins, in whichever cell it is met", "[09.12]") {
    const Triangle t{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    const std::vector<Triangle> same(20, t);
    const std::optional<Hit> first = nearest(grid_of(same), same, {{0, 0.2, 0.2}, {1, 0, 0}});
    {
        INFO("20 times the same triangle: which of them is hit");
        REQUIRE(first);
        CHECK(first->primitive == 0);
    }

    // All pass through the same line, x = y = 5; the last reaches farthest towards the ray and is asked
    // first.
    std::vector<Triangle> fan;
    for (int k = 0; k < 6; ++k) fan.push_back({{5, 5, -1}, {5, 5, 9}, {4.0 - k * 0.75, 5.25 + k, 4}});
    const Grid grid = grid_of(fan, {.density = 40, .nested = false});
    const std::optional<Hit> hit = nearest(grid, fan, {{-5, -5, 4}, {1, 1, 0}});
    INFO("six triangles through one line, all hit at t = 10; then the same in the other order: which is hit");
    CHECK(test::same_hit(hit, Hit{.t = 10, .primitive = 0}));
    std::ranges::reverse(fan);
    const std::optional<Hit> other =
        nearest(grid_of(fan, {.density = 40, .nested = false}), fan, {{-5, -5, 4}, {1, 1, 0}});
    CHECK(test::same_hit(other, Hit{.t = 10, .primitive = 0}));
}

TEST_CASE("no shape is asked twice, and none behind the hit", "[09.12]") {
    Random random(931);
    std::vector<Triangle> triangles;
    for (int k = 0; k < 200; ++k)  // long ones, each in many cells
        triangles.push_back({random.in_cube(), random.in_cube(), random.in_cube()});
    const Grid grid = grid_of(triangles);
    Mailbox mailbox;
    for (int k = 0; k < cases(500); ++k) {
        const Ray ray{3.0 * random.direction(), random.in_cube() - 2.0 * random.direction()};
        std::optional<Hit> hit;
        const SearchCounts counts = counted([&] { hit = closest_hit(grid, triangles, ray, {}, mailbox); });
        INFO("ray " << k
                    << ": how many of 200 triangles were asked, expected how many the mailbox has marked");
        CHECK(counts.shapes == marked(mailbox));
        CHECK(counts.shapes <= triangles.size());
        if (hit) CHECK(counts.shapes >= 1);
        if (hit) CHECK(counts.cells >= 1);
    }

    const std::vector<Sphere> spheres = row_of_spheres(100);
    const Grid row = grid_of(spheres);
    Mailbox of_row;
    const SearchCounts first = counted([&] {
        closest_hit(row, spheres, {{-5, 0, 0}, {1, 0, 0}}, {}, of_row);
    });
    INFO("the ray hits the first of a row of 100 spheres: how many it asks, and how many cells it visits");
    CHECK(first.shapes <= 2);
    CHECK(first.cells <= 4);
    const SearchCounts none = counted([&] {
        closest_hit(row, spheres, {{-5, 0.399, 0.399}, {1, 0, 0}}, {}, of_row);
    });
    INFO("another passes all of them: how many it asks, expected those that the mailbox has marked");
    CHECK(none.shapes == marked(of_row));
    CHECK(none.shapes <= 100);
}

TEST_CASE("an instance in many cells takes the ray through its mesh once", "[09.12]") {
    SharedMesh mesh;
    for (int k = 0; k < 100; ++k) {  // stairs, with nothing where the ray passes
        const Real y = k * 0.01;
        mesh.triangles.shapes.push_back({{-1, y, -1}, {1, y + 0.01, -1}, {0, y, -0.2}});
        mesh.triangles.primitive.push_back(static_cast<std::uint32_t>(k));
    }
    mesh.bound = {Vec3(0), 2};
    const MeshUse plain{std::make_shared<const SharedMesh>(mesh)};
    const Grid of_mesh = grid_of(mesh.triangles.shapes);
    mesh.triangles.accelerator = of_mesh;
    mesh.triangles.mailbox = 1;
    const MeshUse shown{std::make_shared<const SharedMesh>(mesh)};
    const std::vector<Instance> instances(8, Instance{{}, shown});
    const Grid grid = grid_of(instances, {.density = 500, .nested = false});
    const Ray ray{{-3, 0.505, -0.9}, {1, 0, 0.1}};
    const std::uint64_t cells_of_grid = cells_along(grid.shape, ray, {}).size();
    const std::uint64_t cells_of_mesh = cells_along(of_mesh.shape, ray, {}).size();
    Mailbox mailbox;
    std::optional<Hit> hit;
    const SearchCounts counts = counted([&] { hit = closest_hit(grid, instances, ray, {}, mailbox); });
    INFO("8 instances, each in many cells: how many cells are visited, those of the grid, "
         << cells_of_grid << ", and for each instance once those of its mesh, " << cells_of_mesh);
    CHECK(counts.cells <= cells_of_grid + 8 * cells_of_mesh);
    const std::optional<Hit> expected = intersect(Instance{{}, plain}, ray, {});
    INFO("the hit, expected that of one instance without grids");
    CHECK(test::same_hit(hit, expected));
    if (hit && expected) CHECK(hit->element == expected->element);
}

TEST_CASE("rays from beyond the reach, or with numbers out of range, ask all the shapes", "[09.12]") {
    const std::vector<Sphere> spheres = row_of_spheres(10);
    const Grid grid = grid_of(spheres);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Ray& ray :
         {Ray{{-2 * grid.reach, 0, 0}, {1, 0, 0}}, Ray{{0, 3 * grid.reach, 0}, {0, -1e8, 0}},
          Ray{{-1, 0, 0}, {1, 0, 1e-310}}, Ray{{0, -1, 0}, {0, 1e-290, 0}}, Ray{{nan, 0, 0}, {1, 0, 0}},
          Ray{{0, 0, 0}, {nan, 0, 0}}, Ray{{0, 0, 0}, {infinity, 0, 0}}}) {
        Mailbox mailbox;
        std::optional<Hit> hit;
        const SearchCounts counts = counted([&] { hit = closest_hit(grid, spheres, ray, {}, mailbox); });
        const std::optional<Hit> expected = closest_hit(spheres, ray, {});
        INFO("beyond the reach: " << ray << "; how many cells are visited, and the hit, as by asking all");
        CHECK(counts.cells == 0);
        CHECK(test::same_hit(hit, expected));
    }
}

TEST_CASE("the numbers of rays begin anew after 2^32, and no old note is taken for a new one", "[09.12]") {
    const std::vector<Sphere> spheres = row_of_spheres(10);
    const Grid grid = grid_of(spheres);
    const Ray ray{{-5, 0, 0}, {1, 0, 0}};
    Mailbox mailbox{.ray = 0xffffffffu, .asked_by = std::vector<std::uint32_t>(10, 1)};
    for (int k = 0; k < 3; ++k) {
        const std::optional<Hit> hit = closest_hit(grid, spheres, ray, {}, mailbox);
        INFO("ray number " << k << " after 2^32 - 1 others: which of a row of spheres is hit");
        REQUIRE(hit);
        CHECK(hit->primitive == 0);
    }
}

TEST_CASE("by hand: the search goes on to the cell of the hit, also if that has a grid of its own",
          "[09.14]") {
    Grid grid = with_grid_in_second_cell();
    const auto check = [&](Real end, const std::vector<std::uint32_t>& expected) {
        const std::vector<std::uint32_t> asked = asked_along_x(grid, end);
        INFO(
            "three cells of edge 1 along the ray; the second has a grid in its first half, up to t = 1.5; "
            "the nearest hit is at t = "
            << end << ": which shapes are asked, one in each cell");
        CHECK(test::or_say(asked == expected, show(asked) + ", expected " + show(expected)));
    };
    check(0.5, {0});
    check(1.25, {0, 1});
    // In the second cell, but not in its grid.
    check(1.75, {0, 1});
    check(2.5, {0, 1, 2});
    check(infinity, {0, 1, 2});
    // The ray passes beside the inner grid.
    grid.grids[0].shape.box.high.y = 0.25;
    check(1.25, {0});
    check(2.5, {0, 2});
}

TEST_CASE("by hand: an inner grid is searched within the range", "[09.14]") {
    const Grid grid = with_grid_in_second_cell();
    std::vector<Interval> parts;
    const auto ask = [&](std::span<const std::uint32_t>, Interval t) {
        parts.push_back(t);
        return infinity;
    };
    search(grid, {{0, 0.5, 0.5}, {1, 0, 0}}, {1.125, 1.25}, ask);
    INFO("a ray in the range (1.125, 1.25] that is all in one cell of an inner grid");
    {
        INFO("how many cells are asked");
        REQUIRE(parts.size() == 1);
    }
    {
        INFO("where the part of the ray begins that is in this cell and in the range");
        CHECK(parts[0].min == 1.125);
    }
    INFO("where that part ends");
    CHECK(parts[0].max == 1.25);
}

TEST_CASE("behind an inner grid, and behind the shapes in it, the search goes on", "[09.14]") {
    // Forty small spheres near each other, in two rows beside the ray, and one far behind them.
    std::vector<Sphere> spheres{{{0, 0, 0}, 0.1}};
    for (int k = 0; k < 40; ++k) spheres.push_back({{4 + 0.02 * k, k % 2 == 0 ? 0.3 : -0.3, 0}, 0.005});
    spheres.push_back({{9, 0, 0}, 0.1});
    const Grid grid = grid_of(spheres, {.density = 0.2, .crowd = 8});
    INFO("forty small spheres in two rows beside the ray, in inner grids, and number 41 far behind them");
    REQUIRE(grid.grids.size() > 0);
    const std::optional<Hit> behind = nearest(grid, spheres, {{2, 0, 0}, {1, 0, 0}});
    {
        INFO("a ray between the two rows finds: " << behind << ", expected number 41");
        REQUIRE(behind);
        CHECK(behind->primitive == 41);
        CHECK(behind->t == Approx(6.9));
    }
    const std::optional<Hit> inside = nearest(grid, spheres, {{2, 0.3, 0}, {1, 0, 0}});
    {
        INFO("a ray along the upper row finds: " << inside << ", expected number 1");
        REQUIRE(inside);
        CHECK(inside->primitive == 1);
        CHECK(inside->t == Approx(1.995));
    }
    Mailbox mailbox;
    INFO(
        "whether any_hit finds one between the rows; there, but only up to t = 6.8; along the lower row up "
        "to 2.1");
    CHECK(any_hit(grid, spheres, {{2, 0, 0}, {1, 0, 0}}, {}, mailbox) == true);
    CHECK(any_hit(grid, spheres, {{2, 0, 0}, {1, 0, 0}}, {0, 6.8}, mailbox) == false);
    CHECK(any_hit(grid, spheres, {{2, -0.3, 0}, {1, 0, 0}}, {0, 2.1}, mailbox) == true);
}

TEST_CASE("a ball in a stadium: one grid asks nearly all of it, a grid of grids asks a few", "[09.14]") {
    const std::vector<Triangle> triangles = ball_in_stadium();
    const Grid uniform = grid_of(triangles);
    const Grid nested = grid_of(triangles, {});
    const std::vector<Ray> rays = rays_at_ball(cases(400));
    Mailbox mailbox;
    std::size_t different = 0;
    const auto per_ray = [&](const Grid& grid) {
        const SearchCounts counts = counted([&] {
            for (const Ray& ray : rays) closest_hit(grid, triangles, ray, {}, mailbox);
        });
        return static_cast<Real>(counts.shapes) / static_cast<Real>(rays.size());
    };
    const Real by_one = per_ray(uniform), by_many = per_ray(nested);
    for (const Ray& ray : rays) {
        const std::optional<Hit> a = closest_hit(uniform, triangles, ray, {}, mailbox);
        const std::optional<Hit> b = closest_hit(nested, triangles, ray, {}, mailbox);
        if (a.has_value() != b.has_value() || (a && (a->t != b->t || a->primitive != b->primitive)))
            ++different;
    }
    {
        INFO("of " << rays.size()
                   << " rays, how many find something else by a grid of grids than by one grid");
        CHECK(different == 0);
    }
    INFO("of " << triangles.size()
               << " triangles how many a ray asks: by one grid nearly all, by a grid of grids few");
    CHECK(by_one > 0.8 * static_cast<Real>(triangles.size()));
    CHECK(by_many < 30);
}

TEST_CASE("any hit will do, and ends the search", "[09.12]") {
    const std::vector<Sphere> spheres = row_of_spheres(100);
    const Grid grid = grid_of(spheres);
    Mailbox mailbox;
    const auto check = [&](const Ray& ray, const Interval& range, bool expected) {
        INFO("a row of 100 spheres; whether any_hit finds one along the " << ray << " in " << range);
        CHECK(any_hit(grid, spheres, ray, range, mailbox) == expected);
    };
    const Ray along{{-5, 0, 0}, {1, 0, 0}};
    check(along, {}, true);
    check(along, {4.5, 4.7}, true);
    check(along, {0, 4.5}, false);              // before the first sphere
    check(along, {5.45, 5.55}, false);          // between two
    check({{-5, 1, 0}, {1, 0, 0}}, {}, false);  // beside all

    bool hit = false;
    const SearchCounts first = counted([&] {
        hit = any_hit(grid, spheres, {{-5, 0, 0}, {1, 0, 0}}, {}, mailbox);
    });
    CHECK(test::or_say(hit, "any_hit finds nothing"));
    INFO("the ray hits the first of a row of 100 spheres: how many it asks");
    CHECK(first.shapes == 1);
}

TEST_CASE("any hit counts wherever on the ray it is: a long shape may be hit far ahead", "[09.12]") {
    const std::vector<Triangle> triangles{{{0, 0.8, 0}, {10, 0.92, 0}, {10, 0.92, 2}},
                                          {{5, 0, 0}, {5, 2, 0}, {5, 0, 2}}};
    const Grid grid = grid_of(triangles, {.density = 50, .nested = false});
    Mailbox mailbox;
    bool hit = false;
    const SearchCounts counts = counted([&] {
        hit = any_hit(grid, triangles, {{-1, 0.9, 0.5}, {1, 0, 0}}, {}, mailbox);
    });
    CHECK(test::or_say(hit, "any_hit finds nothing"));
    INFO(
        "the first shape in the first cells is hit in the last ones, the other need not be asked: how many "
        "are");
    CHECK(counts.shapes == 1);
}

TEST_CASE("a shadow ray in a crowd asks a few shapes, each once", "[09.14]") {
    const std::vector<Triangle> triangles = ball_in_stadium();
    const Grid grid = grid_of(triangles, {});
    Mailbox mailbox;
    std::uint64_t asked = 0, wrong = 0;
    const std::vector<Ray> rays = rays_at_ball(cases(400));
    for (const Ray& ray : rays) {
        bool hit = false;
        const SearchCounts counts = counted([&] { hit = any_hit(grid, triangles, ray, {}, mailbox); });
        if (hit != any_hit(triangles, ray, {}) || counts.shapes != marked(mailbox)) ++wrong;
        asked += counts.shapes;
    }
    {
        INFO("of " << rays.size() << " rays, for how many any_hit is wrong or asks a shape twice");
        CHECK(wrong == 0);
    }
    {
        INFO("how many shapes " << rays.size() << " rays ask, less than 30 each");
        CHECK(asked < 30 * rays.size());
    }
    INFO("whether any_hit finds the floor from 3 above it; and where the range ends at 2.9");
    CHECK(any_hit(grid, triangles, {{500, 3, 400}, {0, -1, 0}}, {}, mailbox) == true);
    CHECK(any_hit(grid, triangles, {{500, 3, 400}, {0, -1, 0}}, {0, 2.9}, mailbox) == false);
}
