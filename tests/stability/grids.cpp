// Families of extreme scenes for chapter 9, and their judge.
#include "tests/stability/grids.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace rt::stability {
namespace {

using test::Random;

constexpr int kinds = 5;

// ------------------------------------------------------------------------------------ shapes at a place

/// Where a shape is to be, and how large.
struct Place {
    Vec3 center;
    Real size;
};

Mat4 map_to(const Place& place, const Mat4& turn) {
    return translation(place.center) * scaling(Vec3(place.size)) * turn;
}

Mat4 some_turn(Random& random) {
    const Mat4 stretch =
        scaling(Vec3(random.magnitude(-1, 0), random.magnitude(-1, 0), random.magnitude(-1, 0)));
    switch (random.index(4)) {
        case 0:
            return stretch;
        case 1:
            return rotation(random.direction(), random.uniform(0, 6)) * stretch;
        // Stretched after it was turned: distorted.
        case 2:
            return stretch * rotation(random.direction(), random.uniform(0, 6));
        default:
            return scaling(Vec3(1, random.magnitude(-4, -1), 1)) * rotation(random.direction(), 1);
    }
}

Triangle triangle_at(const Place& place, Random& random) {
    const auto corner = [&] { return place.center + place.size * random.in_cube(); };
    return {corner(), corner(), corner()};
}

Polygon polygon_at(const Place& place, Random& random) {
    const Vec3 u = random.direction(), v = normalize(cross(u, random.direction()));
    Polygon polygon;
    for (int k = 0; k < 5; ++k) {
        const Real angle = 2 * pi * k / 5, r = place.size * random.uniform(0.3, 1);
        polygon.vertices.push_back(place.center + r * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return polygon;
}

/// A closed surface of eight triangles or a fan of many.
SharedMesh some_mesh(Random& random) {
    SharedMesh mesh;
    std::vector<Triangle>& t = mesh.triangles.shapes;
    const int around = random.index(2) == 0 ? 4 : 40;
    for (int k = 0; k < around; ++k) {
        const auto rim = [&](int i) {
            const Real angle = 2 * pi * (i % around) / around;
            return Vec3(std::cos(angle), 0, std::sin(angle));
        };
        t.push_back({rim(k), Vec3(0, 1, 0), rim(k + 1)});
        t.push_back({rim(k + 1), Vec3(0, -1, 0), rim(k)});
    }
    for (std::uint32_t i = 0; i < t.size(); ++i) mesh.triangles.primitive.push_back(i);
    mesh.bound = {Vec3(0), 1 + 0x1p-20};
    return mesh;
}

/// Instances of two meshes, each of which may have a grid.
std::vector<Instance> instances_at(const std::vector<Place>& places, Random& random) {
    std::vector<MeshUse> meshes;
    for (std::uint32_t m = 0; m < 2; ++m) {
        SharedMesh mesh = some_mesh(random);
        if (random.index(2) == 0) {
            mesh.triangles.accelerator =
                build_grid(std::span<const Triangle>(mesh.triangles.shapes), {.nested = false});
            mesh.triangles.mailbox = m;
        }
        meshes.push_back({std::make_shared<const SharedMesh>(std::move(mesh))});
    }
    std::vector<Instance> instances;
    for (const Place& place : places) {
        const Mat4 m = map_to(place, some_turn(random));
        if (const std::optional<Mat4> back = inverse(m))
            instances.push_back({{m, *back}, meshes[random.index(2)]});
    }
    return instances;
}

/// Shapes of this kind (or of any) at the places.
AnyShapes shapes_at(const std::vector<Place>& places, std::size_t kind, Random& random) {
    const auto each = [&](auto&& make) {
        std::vector<decltype(make(places[0]))> shapes;
        for (const Place& place : places) shapes.push_back(make(place));
        return shapes;
    };
    switch (kind) {
        case 0:
            return each([&](const Place& p) { return Sphere{p.center, p.size}; });
        case 1:
            return each([&](const Place& p) { return triangle_at(p, random); });
        case 2:
            return each([&](const Place& p) { return polygon_at(p, random); });
        case 3: {
            std::vector<Ellipsoid> shapes;
            for (const Place& p : places) {
                const Mat4 m = map_to(p, some_turn(random));
                if (const std::optional<Mat4> back = inverse(m)) shapes.push_back({{m, *back}, unit_sphere});
            }
            return shapes;
        }
        default:
            return instances_at(places, random);
    }
}

AnyShapes shapes_at(const std::vector<Place>& places, Random& random) {
    return shapes_at(places, random.index(kinds), random);
}

// ---------------------------------------------------------------------------------------------- families

std::size_t some_count(Random& random) {
    constexpr std::size_t counts[] = {2, 5, 12, 30, 60};
    return counts[random.index(5)];
}

std::vector<Place> soup(Random& random, std::size_t count, Real scale, const Vec3& offset) {
    std::vector<Place> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({offset + scale * random.in_cube(), scale * random.magnitude(-2, -0.3)});
    return places;
}

AnyShapes soups(Random& random) { return shapes_at(soup(random, some_count(random), 1, Vec3(0)), random); }

AnyShapes scales(Random& random) {
    const Real scale = random.magnitude(-12, 12);
    return shapes_at(soup(random, some_count(random), scale, scale * random.in_cube()), random);
}

AnyShapes offsets(Random& random) {
    return shapes_at(soup(random, some_count(random), 1, random.magnitude(3, 8) * random.direction()),
                     random);
}

AnyShapes few(Random& random) { return shapes_at(soup(random, 1 + random.index(2), 1, Vec3(0)), random); }

/// Whole numbers for corners, centres and radii: neighbours touch, and are at equal distances from many rays.
AnyShapes lattice(Random& random) {
    const int edge = 2 + static_cast<int>(random.index(3));
    const auto whole = [&](int low, int high) {
        return static_cast<Real>(low +
                                 static_cast<int>(random.index(static_cast<std::size_t>(high - low + 1))));
    };
    std::vector<Place> places;
    for (int k = 0; k < 40; ++k) {
        const Real x = whole(0, edge), y = whole(0, edge), z = whole(0, edge);
        places.push_back({{x, y, z}, whole(1, 2) / 2});
    }
    const std::size_t kind = random.index(3);
    if (kind == 0) return shapes_at(places, 0, random);
    std::vector<Triangle> triangles;
    std::vector<Polygon> squares;
    for (const Place& place : places) {
        const Vec3& p = place.center;
        Vec3 u(0), v(0);
        const std::size_t axis = random.index(3);
        u[static_cast<int>(axis)] = 1;
        v[static_cast<int>(axis + 1) % 3] = 1;
        triangles.push_back({p, p + u, p + v + Vec3(whole(0, 1), 0, 0)});
        squares.push_back({{p, p + u, p + u + v, p + v}});
    }
    if (kind == 1) return triangles;
    return squares;
}

/// No thickness along one axis.
AnyShapes flat(Random& random) {
    const int axis = static_cast<int>(random.index(3));
    const Real height = random.index(2) == 0 ? 0 : random.uniform(-1, 1);
    std::vector<Triangle> triangles;
    std::vector<Polygon> polygons;
    const std::size_t count = some_count(random);
    for (std::size_t i = 0; i < count; ++i) {
        Triangle t = triangle_at({random.in_cube(), random.magnitude(-2, 0)}, random);
        t.a[axis] = t.b[axis] = t.c[axis] = height;
        triangles.push_back(t);
        polygons.push_back({{t.a, t.b, t.c}});
    }
    if (random.index(2) == 0) return triangles;
    return polygons;
}

/// One shape 1e6 times as large as all the others are together.
AnyShapes giants(Random& random) {
    std::vector<Place> places = soup(random, some_count(random), 1e-6, 0.3 * random.in_cube());
    const std::size_t at = random.index(places.size());
    places[at] = {Vec3(0), 1};
    return shapes_at(places, random);
}

/// A teapot in a stadium: many small shapes in one place, and a few large ones around.
AnyShapes crowds(Random& random) {
    std::vector<Place> places = soup(random, 6, 1, Vec3(0));
    const std::vector<Place> crowd = soup(random, 120, random.magnitude(-5, -1), random.in_cube());
    places.insert(places.end(), crowd.begin(), crowd.end());
    return shapes_at(places, random);
}

template <class Shape>
std::vector<Shape> copies_of(const std::vector<Shape>& shapes, Random& random) {
    std::vector<Shape> copies;
    for (int k = 0; k < 40; ++k) copies.push_back(shapes[random.index(shapes.size())]);
    return copies;
}

/// The same shapes again and again: the lowest index wins.
AnyShapes copies(Random& random) {
    AnyShapes shapes = shapes_at(soup(random, 1 + random.index(4), 1, Vec3(0)), random);
    std::visit([&]<class Shapes>(Shapes& some) { some = copies_of(some, random); }, shapes);
    return shapes;
}

/// Needles and slivers.
AnyShapes needles(Random& random) {
    std::vector<Triangle> needles;
    const std::size_t count = some_count(random);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 from = random.in_cube(), to = random.in_cube();
        const Vec3 aside = random.magnitude(-10, -1) * random.direction();
        needles.push_back({from, to, from + random.uniform(-0.5, 1.5) * (to - from) + aside});
    }
    return needles;
}

/// A height field: every edge but those at the rim belongs to two triangles.
AnyShapes surfaces(Random& random) {
    const int n = 3 + static_cast<int>(random.index(5));
    const Real height = random.index(2) == 0 ? 0 : 1;
    std::vector<Vec3> points;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) points.push_back({x, y, random.uniform(0, height)});
    std::vector<Triangle> triangles;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(j * (n + 1) + i)]; };
            triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    return triangles;
}

constexpr std::array<GridFamily, 12> families{{
    {"soups", "shapes of very different sizes, at random", soups},
    {"scales", "the same, 1e-12 to 1e12 units large", scales},
    {"offsets", "the same, up to 1e8 from the origin", offsets},
    {"few", "one or two shapes", few},
    {"lattices", "whole numbers everywhere; equal distances", lattice},
    {"flat", "no thickness along one axis", flat},
    {"giants", "one shape 1e6 times the extent of the others", giants},
    {"crowds", "many shapes in a small part of the box", crowds},
    {"copies", "the same shapes many times", copies},
    {"needles", "triangles of aspect 10 to 1e10", needles},
    {"surfaces", "triangles that share edges, hit at edges and corners", surfaces},
    {"flat surfaces far away", "two floors of squares, 1e6 from the origin",
     [](Random& random) -> AnyShapes {
         std::vector<Polygon> squares;
         const Vec3 corner(random.uniform(-1e6, 1e6), 1e6, random.uniform(-1, 1));
         for (int k = 0; k < 32; ++k) {
             const Vec3 p = corner + Vec3(k % 4, k / 16, k / 4 % 4);
             squares.push_back({{p, p + Vec3(1, 0, 0), p + Vec3(1, 0, 1), p + Vec3(0, 0, 1)}});
         }
         return squares;
     }},
}};

// ------------------------------------------------------------------------------------------------- rays

Vec3 place_on(const Sphere& sphere, Random& random) {
    if (random.index(2) == 0) return sphere.center + sphere.radius * random.direction();
    Vec3 pole = sphere.center;
    pole[static_cast<int>(random.index(3))] += random.index(2) == 0 ? sphere.radius : -sphere.radius;
    return pole;
}

Vec3 place_on(const Triangle& t, Random& random) {
    switch (random.index(5)) {
        case 0:
            return t.a;
        case 1:
            return t.c;
        case 2:
            return (t.a + t.b) * Real(0.5);
        case 3:
            return t.b + random.uniform(0, 1) * (t.c - t.b);
        default:
            return (t.a + t.b + t.c) / Real(3);
    }
}

Vec3 place_on(const Polygon& polygon, Random& random) {
    const std::vector<Vec3>& v = polygon.vertices;
    const std::size_t i = random.index(v.size());
    if (random.index(3) == 0) return v[i];
    if (random.index(2) == 0) return (v[i] + v[(i + 1) % v.size()]) * Real(0.5);
    return (v[0] + v[1] + v[2]) / Real(3);
}

Vec3 place_on(const Ellipsoid& ellipsoid, Random& random) {
    return transform_point(ellipsoid.transform.to_world, place_on(unit_sphere, random));
}

Vec3 place_on(const Instance& instance, Random& random) {
    const std::vector<Triangle>& t = instance.shape.mesh->triangles.shapes;
    return transform_point(instance.transform.to_world, place_on(t[random.index(t.size())], random));
}

/// A point of one of the shapes, up to rounding; where rays are likely to meet trouble.
Vec3 place_on(const AnyShapes& shapes, Random& random) {
    return std::visit([&](const auto& some) { return place_on(some[random.index(some.size())], random); },
                      shapes);
}

/// A point of the box; often on boundaries of cells, of this grid or of one inside it.
Vec3 place_in(const Grid& grid, Random& random) {
    if (!grid.grids.empty() && random.index(2) == 0)
        return place_in(grid.grids[random.index(grid.grids.size())], random);
    Vec3 place;
    const Vec3 size = (grid.shape.box.high - grid.shape.box.low) / Vec3(grid.shape.cells);
    const std::size_t boundaries = random.index(4);  // 0: none, ..., 3: a corner
    for (int a = 0; a < 3; ++a) {
        const Real number =
            static_cast<std::size_t>(a) < boundaries
                ? static_cast<Real>(random.index(static_cast<std::size_t>(grid.shape.cells[a]) + 1))
                : random.uniform(0, grid.shape.cells[a]);
        place[a] = grid.shape.box.low[a] + number * size[a];
    }
    return place;
}

Vec3 somewhere(const GridScene& scene, Random& random) {
    return random.index(2) == 0 ? place_on(scene.shapes, random) : place_in(scene.grid, random);
}

Real some_sign(Random& random) { return random.index(2) == 0 ? 1 : -1; }

GridQuestion some_question(const GridScene& scene, Random& random) {
    const Bounds& box = scene.grid.shape.box;
    const Vec3 edges(box.high - box.low);
    const Real edge = max_component(edges);
    const Vec3 target = somewhere(scene, random);
    Vec3 d(0);
    switch (random.index(5)) {
        case 0:  // along an axis, with zeros of either sign
            d = {some_sign(random) * 0.0, some_sign(random) * 0.0, some_sign(random) * 0.0};
            d[static_cast<int>(random.index(3))] = some_sign(random);
            break;
        case 1:  // a diagonal, of space or of a plane
            d = {some_sign(random), some_sign(random), some_sign(random)};
            if (random.index(2) == 0) d[static_cast<int>(random.index(3))] = some_sign(random) * 0.0;
            break;
        case 2:  // nearly along a plane
            d = random.direction();
            d[static_cast<int>(random.index(3))] *= random.index(4) == 0 ? 1e-300 : random.magnitude(-20, -5);
            break;
        default:
            d = random.direction();
    }
    const Real length = edge * (random.index(4) == 0 ? random.magnitude(-3, 5) : random.uniform(0, 3));
    Ray ray{target - length * d, d};
    if (random.index(4) == 0) {  // from one place to another
        ray.origin = somewhere(scene, random);
        if (target != ray.origin) ray.direction = target - ray.origin;
    } else if (random.index(2) == 0) {
        ray.direction *= random.magnitude(-20, 20);
    }

    GridQuestion question{ray, {}};
    if (random.index(4) > 0) return question;
    // The range begins or ends somewhere, often at exactly a hit.
    Real t = random.uniform(0, 2) * length / glm::length(d);
    if (random.index(2) == 0)
        if (const std::optional<Hit> hit = nearest_of_all(scene, question)) t = hit->t;
    if (random.index(2) == 0)
        question.range.min = t;
    else
        question.range.max = t;
    if (random.index(8) == 0) question.range.min = -infinity;
    return question;
}

// ------------------------------------------------------------------------------------------------ judge

bool equal(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (a.has_value() != b.has_value()) return false;
    return !a || (a->t == b->t && a->uv == b->uv && a->primitive == b->primitive && a->element == b->element);
}

std::string text_of(const std::optional<Hit>& hit) {
    if (!hit) return "a miss";
    return "t = " + literal(hit->t) + ", primitive " + std::to_string(hit->primitive) + ", element " +
           std::to_string(hit->element) + ", uv " + literal(hit->uv);
}

std::string text_of(const GridScene& scene, const GridQuestion& question) {
    return std::to_string(count_of(scene.shapes)) + " shapes of kind " +
           std::to_string(scene.shapes.index()) + ", " + literal(question.ray) + " in (" +
           literal(question.range.min) + ", " + literal(question.range.max) + "]";
}

}  // namespace

std::span<const GridFamily> grid_families() { return families; }

std::size_t count_of(const AnyShapes& shapes) {
    return std::visit([](const auto& some) { return some.size(); }, shapes);
}

namespace {

Grid grid_over(const GridScene& scene) {
    return std::visit(
        [&]<class Shapes>(const Shapes& some) {
            return build_grid(std::span<const typename Shapes::value_type>(some), scene.options);
        },
        scene.shapes);
}

GridScene scene_without_grid(const GridFamily& family, std::uint64_t seed) {
    Random random(seed);
    GridScene scene{family.make(random), {}, {}};
    scene.options.density = random.magnitude(-0.5, 1.3);
    scene.options.nested = random.index(3) > 0;
    scene.options.crowd = 1 + static_cast<int>(random.index(10));
    return scene;
}

/// Gives the grids of placed meshes grids in them.
void nest_grids_of_meshes(AnyShapes& shapes) {
    auto* instances = std::get_if<std::vector<Instance>>(&shapes);
    if (!instances) return;
    std::map<std::shared_ptr<const SharedMesh>, std::shared_ptr<const SharedMesh>> nested;
    for (Instance& instance : *instances) {
        std::shared_ptr<const SharedMesh>& mesh = instance.shape.mesh;
        std::shared_ptr<const SharedMesh>& other = nested[mesh];
        if (!other) {
            SharedMesh copy = *mesh;
            if (has_accelerator(copy.triangles))
                copy.triangles.accelerator =
                    build_grid(std::span<const Triangle>(copy.triangles.shapes), {.crowd = 4});
            other = std::make_shared<const SharedMesh>(std::move(copy));
        }
        mesh = other;
    }
}

}  // namespace

GridScene make_scene(const GridFamily& family, std::uint64_t seed) {
    GridScene scene = scene_without_grid(family, seed);
    if (scene.options.nested) nest_grids_of_meshes(scene.shapes);
    scene.grid = grid_over(scene);
    return scene;
}

GridScene make_scene(const GridFamily& family, std::uint64_t seed, bool nested) {
    GridScene scene = scene_without_grid(family, seed);
    scene.options.nested = nested;
    if (nested) nest_grids_of_meshes(scene.shapes);
    scene.grid = grid_over(scene);
    return scene;
}

std::vector<GridQuestion> make_questions(const GridScene& scene, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<GridQuestion> questions;
    questions.reserve(count);
    while (questions.size() < count) questions.push_back(some_question(scene, random));
    return questions;
}

namespace {

/// Asks all the triangles of all the instances.
std::optional<Hit> nearest_of_instances(const std::vector<Instance>& instances,
                                        const GridQuestion& question) {
    std::optional<Hit> best;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const std::vector<Triangle>& triangles = instances[i].shape.mesh->triangles.shapes;
        std::optional<Hit> hit =
            closest_hit(triangles, to_local(instances[i].transform, question.ray), question.range);
        if (!hit || (best && hit->t >= best->t)) continue;
        hit->element = hit->primitive;
        hit->primitive = i;
        best = hit;
    }
    return best;
}

}  // namespace

std::optional<Hit> nearest_of_all(const GridScene& scene, const GridQuestion& question) {
    return std::visit(
        [&]<class Shapes>(const Shapes& some) {
            if constexpr (std::is_same_v<Shapes, std::vector<Instance>>)
                return nearest_of_instances(some, question);
            else
                return closest_hit(some, question.ray, question.range);
        },
        scene.shapes);
}

namespace {

template <class OneAccelerator>
Verdict judge_nearest_by(const OneAccelerator& accelerator, const GridScene& scene,
                         std::span<const GridQuestion> questions) {
    Verdict verdict;
    Mailbox mailbox;
    for (const GridQuestion& question : questions) {
        const std::optional<Hit> actual = std::visit(
            [&](const auto& some) {
                return closest_hit(accelerator, some, question.ray, question.range, mailbox);
            },
            scene.shapes);
        const std::optional<Hit> expected = nearest_of_all(scene, question);
        ++verdict.cases;
        if (equal(actual, expected)) continue;
        count_mismatch(verdict, text_of(scene, question) + "\n  right: " + text_of(expected) +
                                    "\n  answered: " + text_of(actual));
    }
    return verdict;
}

template <class OneAccelerator>
Verdict judge_any_by(const OneAccelerator& accelerator, const GridScene& scene,
                     std::span<const GridQuestion> questions) {
    Verdict verdict;
    Mailbox mailbox;
    for (const GridQuestion& question : questions) {
        const bool actual = std::visit(
            [&](const auto& some) {
                return any_hit(accelerator, some, question.ray, question.range, mailbox);
            },
            scene.shapes);
        const std::optional<Hit> expected = nearest_of_all(scene, question);
        ++verdict.cases;
        if (actual == expected.has_value()) continue;
        count_mismatch(verdict, text_of(scene, question) + "\n  any_hit says " + (actual ? "yes" : "no") +
                                    ", the nearest hit is " + text_of(expected));
    }
    return verdict;
}

}  // namespace

Verdict judge_nearest(const GridScene& scene, std::span<const GridQuestion> questions) {
    return judge_nearest_by(scene.grid, scene, questions);
}

Verdict judge_any(const GridScene& scene, std::span<const GridQuestion> questions) {
    return judge_any_by(scene.grid, scene, questions);
}

Verdict judge_nearest(const GridScene& scene, const Hierarchy& hierarchy,
                      std::span<const GridQuestion> questions) {
    return judge_nearest_by(hierarchy, scene, questions);
}

Verdict judge_any(const GridScene& scene, const Hierarchy& hierarchy,
                  std::span<const GridQuestion> questions) {
    return judge_any_by(hierarchy, scene, questions);
}

}  // namespace rt::stability

namespace rt::naive {

std::optional<Interval> clip(const Bounds& box, const Ray& ray, Interval range) {
    const Vec3 inverse = Real(1) / ray.direction;
    const Vec3 p = (box.low - ray.origin) * inverse, q = (box.high - ray.origin) * inverse;
    const Vec3 near = glm::min(p, q), far = glm::max(p, q);
    range.min = std::max(range.min, std::max(near.x, std::max(near.y, near.z)));
    range.max = std::min(range.max, std::min(far.x, std::min(far.y, far.z)));
    return range.min > range.max ? std::nullopt : std::optional(range);
}

std::vector<CellVisit> cells_along(const GridShape& shape, const Ray& ray, Interval range) {
    const Vec3 size = (shape.box.high - shape.box.low) / Vec3(shape.cells);
    Cells cell(0), step(0);
    Vec3 next(infinity), delta(0);
    for (int a = 0; a < 3; ++a) {
        const Real place = (ray.origin[a] + range.min * ray.direction[a] - shape.box.low[a]) / size[a];
        cell[a] = std::clamp(static_cast<int>(std::floor(place)), 0, shape.cells[a] - 1);
        if (ray.direction[a] == 0) continue;
        step[a] = ray.direction[a] > 0 ? 1 : -1;
        delta[a] = size[a] / std::abs(ray.direction[a]);
        const Real boundary = shape.box.low[a] + (cell[a] + (step[a] > 0 ? 1 : 0)) * size[a];
        next[a] = (boundary - ray.origin[a]) / ray.direction[a];
    }
    std::vector<CellVisit> visits;
    Real t = range.min;
    for (;;) {
        const int a = next.x < next.y ? (next.x < next.z ? 0 : 2) : next.y < next.z ? 1 : 2;
        visits.push_back({cell, {t, std::min(next[a], range.max)}});
        if (!(next[a] <= range.max)) return visits;
        cell[a] += step[a];
        if (cell[a] < 0 || cell[a] >= shape.cells[a]) return visits;
        t = next[a];
        next[a] += delta[a];
    }
}

std::optional<Hit> closest_hit(const Grid& grid, std::span<const Triangle> shapes, const Ray& ray,
                               Interval range) {
    const std::optional<Interval> clipped = rt::clip(grid.shape.box, ray, range);
    if (!clipped) return std::nullopt;
    for (const CellVisit& visit : rt::cells_along(grid.shape, ray, *clipped)) {
        const Cells& c = visit.cell;
        const auto number =
            static_cast<std::size_t>((c.z * grid.shape.cells.y + c.y) * grid.shape.cells.x + c.x);
        std::optional<Hit> first;
        for (std::uint32_t k = grid.first[number]; k < grid.first[number + 1]; ++k) {
            std::optional<Hit> hit = intersect(shapes[grid.items[k]], ray, range);
            if (!hit || (first && hit->t >= first->t)) continue;
            hit->primitive = grid.items[k];
            first = hit;
        }
        if (first) return first;
    }
    return std::nullopt;
}

}  // namespace rt::naive
