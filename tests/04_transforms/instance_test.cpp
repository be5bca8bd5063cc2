// Step 04.6: ellipsoids, and instances of a mesh.
#include "chapters/04_transforms/instance.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/math/error.hpp"
#include "tests/04_transforms/show.hpp"
#include "tests/catch.hpp"
#include "tests/oracle/triangle.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using test::ahead;
using test::cases;
using test::demanded;
using test::Random;
using test::show;

namespace {

Transform transform(const Mat4& m) {
    const std::optional<Mat4> back = inverse(m);
    INFO("the inverse of" << m);
    REQUIRE(back);
    return {m, *back};
}

Ellipsoid ellipsoid(const Mat4& m) { return {transform(m), unit_sphere}; }

MeshUse use_of(const SharedMesh& mesh) { return {std::make_shared<const SharedMesh>(mesh)}; }

Instance instance_of(const Mat4& m, const SharedMesh& mesh) { return {transform(m), use_of(mesh)}; }

/// Turned, stretched and slanted; reflected every second time.
Mat4 some_map(Random& random) {
    Vec3 by(random.magnitude(-1, 1), random.magnitude(-1, 1), random.magnitude(-1, 1));
    if (random.index(2) == 0) by.x = -by.x;
    const Mat4 first = rotation(random.direction(), random.uniform(-4, 4));
    return translation(5.0 * random.in_cube()) * rotation(random.direction(), random.uniform(-4, 4)) *
           scaling(by) * first;
}

/// A closed mesh around the origin: an octahedron with uneven corners, its faces counterclockwise from
/// outside.
SharedMesh some_mesh(Random& random) {
    SharedMesh mesh;
    Vec3 corners[6];
    for (int i = 0; i < 6; ++i) {
        corners[i] = Vec3(0);
        corners[i][i / 2] = (i % 2 == 0 ? 1 : -1) * random.uniform(0.5, 1);
    }
    for (int i = 0; i < 8; ++i) {
        Triangle face{corners[i & 1], corners[2 + (i >> 1 & 1)], corners[4 + (i >> 2 & 1)]};
        if (((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 == 1) std::swap(face.b, face.c);
        mesh.triangles.shapes.push_back(face);
        mesh.triangles.normals.push_back({face.a, face.b, face.c});
    }
    mesh.bound = {Vec3(0), 1 + 0x1p-20};
    return mesh;
}

Triangle baked(const Triangle& triangle, const Mat4& m) {
    return {transform_point(m, triangle.a), transform_point(m, triangle.b), transform_point(m, triangle.c)};
}

/// From somewhere outside of the image of the unit ball to somewhere in or near it.
Ray towards(Random& random, const Mat4& m) {
    const Vec3 from = transform_point(m, 3.0 * random.direction());
    return {from, random.uniform(0.2, 2) * (transform_point(m, 1.1 * random.in_cube()) - from)};
}

}  // namespace

// ------------------------------------------------------------------------------------------- ellipsoids

TEST_CASE("an ellipsoid is hit where its axis ends", "[04.6]") {
    const Ellipsoid e = ellipsoid(scaling({2, 1, 0.5}));
    const auto check = [&](const Ray& ray, Real t) {
        INFO("half axes 2, 1 and 0.5; " << ray << ": the t of the hit");
        const std::optional<Hit> hit = intersect(e, ray, ahead);
        REQUIRE(hit);
        CHECK(hit->t == t);
    };
    check({{5, 0, 0}, {-1, 0, 0}}, 3);
    check({{0, 5, 0}, {0, -1, 0}}, 4);
    check({{0, 0, 5}, {0, 0, -1}}, 4.5);
    check({{0, 0, 0}, {1, 0, 0}}, 2);
}

TEST_CASE("t counts lengths of the world ray's direction", "[04.6]") {
    const Ellipsoid e = ellipsoid(translation({0, 0, -10}) * scaling({1, 1, 4}));
    for (const Real speed : {0.5, 1.0, 2.0, 1024.0}) {
        const std::optional<Hit> hit = intersect(e, {{0, 0, 0}, {0, 0, -speed}}, ahead);
        INFO("the ellipsoid begins 6 in front of a ray whose direction is " << speed
                                                                            << " long: the t of the hit");
        REQUIRE(hit);
        CHECK(hit->t == 6 / speed);
    }
}

TEST_CASE("beside an ellipsoid there is nothing", "[04.6]") {
    const Ellipsoid e = ellipsoid(scaling({2, 1, 0.5}));
    INFO("half axes 2, 1 and 0.5; rays along -z");
    CHECK_FALSE(intersect(e, {{0, 1.25, 5}, {0, 0, -1}}, ahead));
    CHECK(intersect(e, {{1.25, 0, 5}, {0, 0, -1}}, ahead));
    CHECK_FALSE(intersect(e, {{0, 0, -5}, {0, 0, -1}}, ahead));
}

TEST_CASE("the range is that of the world ray", "[04.6]") {
    const Ellipsoid e = ellipsoid(scaling({2, 1, 0.5}));
    const Ray ray{{5, 0, 0}, {-1, 0, 0}};  // roots 3 and 7
    INFO("an ellipsoid that the ray meets at t = 3 and at t = 7; ranges (0, 3], (0, 2.5] and (3, inf]");
    CHECK(intersect(e, ray, {0, 3}));
    CHECK_FALSE(intersect(e, ray, {0, 2.5}));
    const std::optional<Hit> far = intersect(e, ray, {3, infinity});
    REQUIRE(far);
    CHECK(far->t == 7);
}

TEST_CASE("the surface of an ellipsoid has its point and normal in the world", "[04.6]") {
    const Ellipsoid e = ellipsoid(translation({1, 0, 0}) * scaling({2, 1, 1}));
    const Ray ray{{1, 5, 0}, {0, -1, 0}};
    INFO("half axes 2, 1 and 1 around (1, 0, 0)");
    const auto check = [&](const Ray& from, const Vec3& point, const Vec3& normal, Real bound) {
        INFO(from << ": the point in the world, then the normal and the shading normal");
        const std::optional<Hit> hit = intersect(e, from, ahead);
        REQUIRE(hit);
        const Surface surface = surface_at(e, from, *hit);
        CHECK(test::near(surface.point, point, bound));
        CHECK(test::near_direction(surface.normal, normal, bound));
        CHECK(test::near_direction(surface.shading_normal, normal, bound));
    };
    check(ray, {1, 1, 0}, {0, 1, 0}, 0);

    // At (2·0.6, 0.8): the gradient of (x/2)² + y² is along (0.6/2, 0.8) = (3, 8)/10.
    check({{2.2, 5, 0}, {0, -1, 0}}, {2.2, 0.8, 0}, Vec3(3, 8, 0) / std::sqrt(73.0), gamma(16));
}

TEST_CASE("points lie on the ellipsoid and normals point outward, reflected or not", "[04.6]") {
    Random random(4601);
    int hits = 0;
    for (int i = 0; i < cases(5000); ++i) {
        const Mat4 m = some_map(random);
        const Ellipsoid e = ellipsoid(m);
        const Ray ray = towards(random, m);
        const std::optional<Hit> hit = intersect(e, ray, ahead);
        if (!hit) continue;
        ++hits;
        const Surface surface = surface_at(e, ray, *hit);
        INFO("the map" << m << "\npoint " << surface.point << ", normal " << surface.normal);
        // In the ellipsoid's own units a point is off by no more than the error that it claims.
        const Mat4& back = e.transform.to_local;
        const Vec3 local = transform_point(back, surface.point);
        Vec3 error(0);
        for (int c = 0; c < 3; ++c) error += abs(Vec3(back[c])) * surface.error[c];
        CHECK(test::or_say(std::abs(length(local) - 1) <= dot(abs(local), error),
                           "the point is farther from the ellipsoid than its error says"));
        CHECK(test::or_say(std::abs(length(surface.normal) - 1) <= gamma(4), "the normal is not 1 long"));
        CHECK(test::or_say(dot(surface.normal, surface.point - Vec3(m[3])) > 0, "the normal points inward"));
    }
    CHECK(hits > cases(5000) / 4);
}

TEST_CASE("a ray that starts outside of the error box does not meet the surface again", "[04.6]") {
    Random random(4602);
    int tried = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const Mat4 m = some_map(random);
        const Ellipsoid e = ellipsoid(m);
        const Ray ray = towards(random, m);
        const std::optional<Hit> hit = intersect(e, ray, ahead);
        if (!hit) continue;
        const Surface surface = surface_at(e, ray, *hit);
        const Vec3 n = surface.normal;
        const Real step = dot(abs(n), surface.error) * (1 + gamma(8));
        Vec3 direction = random.direction();
        // Grazing ones too.
        if (i % 2 == 0) direction = normalize(cross(n, direction) + random.magnitude(-12, 0) * n);
        if (dot(direction, n) <= 0) continue;
        ++tried;
        INFO(show(m) << "\npoint " << show(surface.point) << ", direction " << show(direction));
        CHECK_FALSE(intersect(e, {surface.point + step * n, direction}, ahead));
    }
    CHECK(tried > cases(20000) / 8);
}

TEST_CASE("an ellipsoid that is a ball is hit as a sphere is", "[04.6]") {
    Random random(4603);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 center = 3.0 * random.in_cube();
        const Real radius = random.uniform(0.5, 2);
        const Mat4 m = translation(center) * rotation(random.direction(), random.uniform(-4, 4)) *
                       scaling({radius, -radius, radius});
        const Ray ray = towards(random, m);
        const std::optional<Hit> hit = intersect(ellipsoid(m), ray, ahead);
        if (!hit) continue;
        const Real distance = length(point_at(ray, hit->t) - center);
        INFO("a ball around " << center << " of radius " << radius << ", hit at t = " << hit->t
                              << ": how far from the centre that is");
        // The point on the ray is known to u·|o| or so; grazing rays are off by no more across the surface.
        CHECK(test::near(distance, radius, gamma(64) * (length(ray.origin) + length(center) + radius)));
    }
}

// -------------------------------------------------------------------------------------------- instances

namespace {

const Triangle upright{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};

SharedMesh one_triangle() {
    SharedMesh mesh;
    mesh.triangles.shapes = {upright};
    mesh.bound = {Vec3(0), 2};
    return mesh;
}

void check_hit(const std::optional<Hit>& hit, Real t, std::uint32_t primitive, std::uint32_t element) {
    INFO("expected a hit at t = " << t << ", of instance (primitive) " << primitive << ", triangle (element) "
                                  << element << " of its mesh, both counted from 0; found: " << hit);
    REQUIRE(hit);
    CHECK(hit->t == t);
    CHECK(hit->primitive == primitive);
    CHECK(hit->element == element);
}

}  // namespace

TEST_CASE("where there are no instances nothing is hit", "[04.6]") {
    INFO("no instances at all");
    CHECK_FALSE(closest_hit(std::span<const Instance>(), {{0, 0, 5}, {0, 0, -1}}, ahead));
}

TEST_CASE("an instance is hit where its mesh was moved to", "[04.6]") {
    const std::vector<Instance> instances{instance_of(translation({0, 0, -4}), one_triangle()),
                                          instance_of(translation({8, 0, 2}), one_triangle())};
    check_hit(closest_hit(instances, {{0, 0, 5}, {0, 0, -1}}, ahead), 9, 0, 0);
    check_hit(closest_hit(instances, {{8, 0, 5}, {0, 0, -1}}, ahead), 3, 1, 0);
    INFO("between two instances");
    CHECK_FALSE(closest_hit(instances, {{4, 0, 5}, {0, 0, -1}}, ahead));
}

TEST_CASE("the nearest instance wins wherever it stands in the list, and of equals the first", "[04.6]") {
    const Instance near = instance_of(translation({0, 0, 2}), one_triangle());
    const Instance far = instance_of(translation({0, 0, -2}), one_triangle());
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    check_hit(closest_hit(std::vector{near, far}, ray, ahead), 3, 0, 0);
    check_hit(closest_hit(std::vector{far, near}, ray, ahead), 3, 1, 0);
    check_hit(closest_hit(std::vector{far, near, near}, ray, ahead), 3, 1, 0);
}

TEST_CASE("element says which triangle of the mesh", "[04.6]") {
    SharedMesh mesh;
    mesh.triangles.shapes = {{{-1, -1, -3}, {1, -1, -3}, {0, 1, -3}}, upright};
    mesh.bound = {Vec3(0), 4};
    const std::vector<Instance> instances{instance_of(translation({50, 0, 0}), one_triangle()),
                                          instance_of(scaling({1, 1, 2}), mesh)};
    check_hit(closest_hit(instances, {{0, 0, 5}, {0, 0, -1}}, ahead), 5, 1, 1);
    check_hit(closest_hit(instances, {{0, 0, -15}, {0, 0, 2}}, ahead), 4.5, 1, 0);
}

TEST_CASE("a ray that misses the bounding sphere asks none of the mesh's triangles", "[04.6]") {
    SharedMesh mesh = one_triangle();
    mesh.bound = {{10, 0, 0}, 1};
    const std::vector<Instance> instances{instance_of(translation({0, 0, -4}), mesh)};
    INFO(
        "a mesh whose one triangle lies outside of its bounding sphere, around (10, 0, 0), radius 1: a ray "
        "that misses the sphere asks no triangle");
    CHECK_FALSE(closest_hit(instances, {{0, 0, 5}, {0, 0, -1}}, ahead));
}

TEST_CASE("a ray from 2^52 radii away that hits a triangle is not lost at the bounding sphere", "[04.6]") {
    // Of a scene with one large instance and four tiny ones; a grid is not needed for it.
    const Triangle face{{1, 0, 0}, {0, 1, 0}, {0x1.1a62633145c07p-54, 0, 1}};
    const Ray local{{0x1.08abcbc723696p+52, 0x1.a7007ef0d49b2p+51, 0x1.6688f63c3cad2p+51},
                    {-0x1.6023701b4dbbfp-29, -0x1.19659aba46e71p-29, -0x1.dd05a88c2201p-30}};
    SharedMesh mesh;
    mesh.triangles.shapes = {face};
    mesh.bound = {Vec3(0), 1 + 0x1p-20};
    const std::optional<Hit> hit = intersect(use_of(mesh), local, ahead);
    REQUIRE(oracle::judge_triangle(face, local, 0).hit);
    check_hit(hit, 0x1.80d3247c44e8cp+80, 0, 0);
    INFO("whether is_hit says the same");
    CHECK(is_hit(use_of(mesh), local, ahead));
}

TEST_CASE("however far away a ray starts, the bounding sphere loses no hit, and the range is kept",
          "[04.6]") {
    Random random(4607);
    int hits = 0, lost_by_roots = 0;
    const int all = cases(50'000);
    for (int i = 0; i < all; ++i) {
        SharedMesh mesh = some_mesh(random);
        const Triangle& face = mesh.triangles.shapes[random.index(8)];
        const Real b = random.index(2) == 0 ? 1 : random.uniform(0, 1);
        const Vec3 target = (1 - b) * face.a + b * face.b;
        // Tight around the corner that is farthest out: it is what rays are often aimed at.
        mesh.bound.radius = std::max({length(face.a), length(face.b), length(face.c)}) * (1 + 0x1p-20);
        mesh.triangles.shapes = {face};
        const Ray ray{target - random.magnitude(-1, 16) * random.direction(), Vec3(0)};
        Ray local{ray.origin, random.magnitude(-20, 20) * normalize(target - ray.origin)};
        if (i % 4 == 0) std::swap(local.direction.x, local.direction.y);  // beside it, mostly
        Interval range = ahead;
        const std::optional<Hit> ever = closest_hit(mesh.triangles.shapes, local, range);
        if (ever && random.index(3) == 0) range.max = ever->t;
        if (ever && random.index(3) == 0) range.min = std::nextafter(ever->t, -infinity);

        const std::optional<Hit> expected = closest_hit(mesh.triangles.shapes, local, range);
        const std::optional<Hit> actual = intersect(use_of(mesh), local, range);
        INFO("case " << i << ": from " << show(local.origin) << " along " << show(local.direction));
        REQUIRE(test::same_hit(actual, expected));
        INFO("whether is_hit says the same");
        CHECK(is_hit(use_of(mesh), local, range) == expected.has_value());
        if (!expected) continue;
        ++hits;
        const Roots roots = intersections(mesh.bound, local);
        if (roots.count == 0 || roots.t1 <= range.min || roots.t0 > range.max) ++lost_by_roots;
    }
    {
        INFO("how many of " << all << " rays hit");
        CHECK(hits > all / 8);
    }
    INFO("how many the roots of the sphere itself lose; there have to be some, else the cases show nothing");
    CHECK(lost_by_roots > demanded(all / 1000, 0));
}

TEST_CASE("from inside of the bounding sphere the mesh is hit", "[04.6]") {
    const std::vector<Instance> instances{instance_of(Mat4(1), one_triangle())};
    check_hit(closest_hit(instances, {{0, 0, 0.5}, {0, 0, -1}}, ahead), 0.5, 0, 0);
}

TEST_CASE("the range decides: its start is excluded and its end included", "[04.6]") {
    const std::vector<Instance> instances{instance_of(Mat4(1), one_triangle())};
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    INFO("a triangle at t = 5; ranges (0, 5], (0, 4.5] and (5, inf]");
    CHECK(closest_hit(instances, ray, {0, 5}));
    CHECK_FALSE(closest_hit(instances, ray, {0, 4.5}));
    CHECK_FALSE(closest_hit(instances, ray, {5, infinity}));
    INFO("whether any_hit finds it");
    CHECK(any_hit(instances, ray, {0, 5}) == true);
    CHECK(any_hit(instances, ray, {0, 4.5}) == false);
}

namespace {

/// A multiple of 1/16 in [−2, 2].
Real sixteenths(Random& random) { return static_cast<Real>(static_cast<int>(random.index(65)) - 32) / 16; }

Vec3 in_sixteenths(Random& random) {
    const Real x = sixteenths(random), y = sixteenths(random), z = sixteenths(random);
    return {x, y, z};
}

}  // namespace

TEST_CASE("an instance is hit where the mesh baked into the world is, by exact arithmetic", "[04.6]") {
    Random random(4604);
    int hits = 0, misses = 0, undecided = 0;
    for (int i = 0; i < cases(5000); ++i) {
        // Map and corners are so short that the baked triangles need no rounding: they are the truth.
        Mat4 m(1);
        for (int c = 0; c < 4; ++c) m[c] = Vec4(in_sixteenths(random), c == 3 ? 1 : 0);
        const std::optional<Mat4> back = inverse(m);
        if (!back) continue;
        SharedMesh mesh = some_mesh(random);
        for (Triangle& face : mesh.triangles.shapes)
            for (Vec3* corner : {&face.a, &face.b, &face.c}) *corner = glm::round(*corner * 16.0) / 16.0;
        const Instance instance{{m, *back}, use_of(mesh)};
        const Ray ray = towards(random, m);
        const std::optional<Hit> hit = intersect(instance, ray, ahead);
        {
            INFO("the map" << m << "\n" << ray << ": whether is_hit says what the nearest hit says");
            CHECK(is_hit(instance, ray, ahead) == hit.has_value());
        }

        // What rounding, or moving the data by 4 ulp, does in local space, as tests/stability/transforms.hpp
        // says.
        const Ray local = to_local(instance.transform, ray);
        const auto off = [&](Real t) {
            Vec3 sum = abs(Vec3((*back)[3]));
            for (int c = 0; c < 3; ++c)
                sum += abs(Vec3((*back)[c])) * (std::abs(ray.origin[c]) + t * std::abs(ray.direction[c]));
            return 8 * unit_roundoff * (length(sum) + 1);
        };
        Real nearest = infinity, error = 0, allowed = 0;
        std::uint32_t element = 0;
        bool close = false;
        for (std::uint32_t k = 0; k < mesh.triangles.shapes.size(); ++k) {
            const Triangle& face = mesh.triangles.shapes[k];
            const oracle::TriangleTruth truth = oracle::judge_triangle(baked(face, m), ray, hit ? hit->t : 0);
            if (truth.degenerate || truth.sum == 0) continue;
            const Real cosine = std::abs(dot(unit_normal(face), local.direction));
            const Vec3 weights = truth.volumes / truth.sum;
            const Real area = length(cross(face.b - face.a, face.c - face.a));
            // The least height is the double area over the longest edge, which is 2 at most.
            const Real moved = off(std::abs(truth.t)) * length(local.direction) / cosine * 2 / area;
            close = close || std::abs(std::min({weights.x, weights.y, weights.z})) <= moved;
            if (!truth.hit || truth.t >= nearest) continue;
            nearest = truth.t;
            element = k;
            error = std::abs(truth.error);
            allowed = off(truth.t) / cosine;
        }
        if (close) {
            ++undecided;
            continue;
        }
        INFO("the map" << m << "\n"
                       << ray << ": expected "
                       << (nearest < infinity ? "triangle " + show(element) + " at t = " + show(nearest)
                                              : "a miss")
                       << "; found: " << hit);
        REQUIRE(
            test::or_say(hit.has_value() == (nearest < infinity), hit ? "a hit, expected a miss" : "a miss"));
        ++(hit ? hits : misses);
        if (!hit) continue;
        CHECK(hit->element == element);
        INFO("by how much t is off");
        CHECK(error <= allowed);
    }
    INFO("how many of " << cases(5000) << " rays hit, miss, or are too close to call");
    CHECK(hits > cases(5000) / 8);
    CHECK(misses > cases(5000) / 8);
    CHECK(undecided < cases(5000) / 8);
}

TEST_CASE("the surface of an instance is that of the baked mesh, smooth or flat, reflected or not",
          "[04.6]") {
    Random random(4605);
    int hits = 0;
    for (int i = 0; i < cases(2000); ++i) {
        SharedMesh mesh = some_mesh(random);
        if (i % 2 == 0) mesh.triangles.normals.clear();
        const Mat4 m = some_map(random);
        const Instance instance = instance_of(m, mesh);
        const Ray ray = towards(random, m);
        const std::optional<Hit> hit = intersect(instance, ray, ahead);
        if (!hit) continue;
        ++hits;
        const Surface surface = surface_at(instance, ray, *hit);
        const Triangle face = baked(mesh.triangles.shapes[hit->element], m);
        const Vec3 flat = (glm::determinant(Mat3(m)) < 0 ? -1.0 : 1.0) * unit_normal(face);
        const Vec3 point = (1 - hit->uv.x - hit->uv.y) * face.a + hit->uv.x * face.b + hit->uv.y * face.c;
        INFO("the map" << m << "\nnormal and point; expected those of the triangle with the map baked in");
        // Corners of at most 1, moved by maps that stretch by at most 100 times and as much back.
        CHECK(test::near_direction(surface.normal, flat, gamma(100 * 100)));
        CHECK(test::near(surface.point, point, gamma(100) * (length(Vec3(m[3])) + 30)));
        if (mesh.triangles.normals.empty()) {
            CHECK(surface.shading_normal == surface.normal);
        } else {
            const Triangle& local = mesh.triangles.shapes[hit->element];
            const Vec3 n = interpolate(mesh.triangles.normals[hit->element], hit->uv, unit_normal(local));
            const Vec3 expected = unit_vector(transform_normal(instance.transform.to_local, n));
            CHECK(surface.shading_normal == expected);
        }
    }
    CHECK(hits > cases(2000) / 8);
}

TEST_CASE("a ray that starts outside of an instance's error box does not meet its triangle again", "[04.6]") {
    Random random(4606);
    int tried = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const SharedMesh mesh = some_mesh(random);
        const Mat4 m = some_map(random);
        const Instance instance = instance_of(m, mesh);
        const Ray ray = towards(random, m);
        const std::optional<Hit> hit = intersect(instance, ray, ahead);
        if (!hit) continue;
        const Surface surface = surface_at(instance, ray, *hit);
        const Vec3 n = surface.normal;
        const Real step = dot(abs(n), surface.error) * (1 + gamma(8));
        const Vec3 direction = random.direction();
        if (dot(direction, n) <= 1e-6) continue;
        ++tried;
        INFO(show(m) << "\npoint " << show(surface.point) << ", direction " << show(direction));
        // The mesh is convex and the ray goes outward: nothing is in its way.
        CHECK(test::or_say(!is_hit(instance, {surface.point + step * n, direction}, ahead),
                           "the ray hits the instance again"));
    }
    CHECK(tried > cases(20000) / 16);
}
