// Steps 07.4 to 07.6: the media around a ray, the rays that go on from a hit, and the tree of rays.
#include "chapters/07_recursion/optics.hpp"
#include "chapters/07_recursion/radiance.hpp"

#include "common/math/error.hpp"
#include "common/render/compile.hpp"
#include "common/render/trace.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string>

namespace {

// Memory that this thread has taken by `new` while it is watched.
thread_local bool watched = false;
thread_local std::size_t taken = 0;
thread_local std::size_t most_taken = 0;

constexpr std::size_t header = alignof(std::max_align_t);

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    auto* block = static_cast<char*>(std::malloc(size + header));
    if (!block) return nullptr;
    const std::size_t counted = watched ? size : 0;
    taken += counted;
    most_taken = std::max(most_taken, taken);
    *reinterpret_cast<std::size_t*>(block) = counted;
    return block + header;
}
void* operator new(std::size_t size) {
    if (void* block = operator new(size, std::nothrow)) return block;
    throw std::bad_alloc();
}
void operator delete(void* pointer) noexcept {
    if (!pointer) return;
    char* block = static_cast<char*>(pointer) - header;
    taken -= std::min(taken, *reinterpret_cast<std::size_t*>(block));
    std::free(block);
}
void operator delete(void* pointer, std::size_t) noexcept { operator delete(pointer); }
void operator delete(void* pointer, const std::nothrow_t&) noexcept { operator delete(pointer); }

using namespace rt;
using namespace rt::test;

namespace {

constexpr Real u = unit_roundoff;

/// The world of a scene text that looks along −z from (0, 0, 5).
World world_of(const std::string& text, const std::string& camera = "camera 0 0 5 0 0 0 0 1 0 45\n") {
    return compile(parse_scene_text("size 4 4\nambient 0 0 0\n" + camera + text, "test.scene"));
}

const Ray forward{{0, 0, 5}, {0, 0, -1}};

/// A camera ray's branch that has just met something, and what it met.
struct Arrival {
    Branch branch;
    Hit hit;
    Surface surface;
    Material material;
};
Arrival arrive(const World& world, const Branch& branch) {
    const auto hit = closest_hit(world, branch.ray, {0, infinity});
    INFO(branch.ray);
    REQUIRE(hit);
    const auto surface = surface_at(world, branch.ray, *hit);
    return {branch, *hit, surface, material_at(world, *hit, surface)};
}
Branches scatter_at(const World& world, const Ray& ray, Media media = {}, Vec3 weight = Vec3(1),
                    int depth = 0) {
    const Arrival a = arrive(world, {ray, weight, depth, RayKind::Camera, media});
    return scatter(world, a.branch, a.hit, a.surface, a.material);
}

/// What is checked of the branches that go on, and in which words.
void check_count(const Branches& next, int count) {
    INFO("how many rays go on");
    REQUIRE(next.count == count);
}
void check_direction(const Branch& branch, const Vec3& direction, Real bound = 0) {
    INFO(branch << ": its direction");
    CHECK(near_direction(branch.ray.direction, direction, bound));
}
void check_weight(const Branch& branch, const Vec3& weight, Real bound = 0) {
    INFO(branch << ": its weight, what it counts in the pixel");
    CHECK(near_color(branch.weight, weight, bound));
}
void check_depth_in(const Branch& branch, std::size_t media) {
    INFO(branch << ": how many media it is inside of");
    CHECK(branch.media.size() == media);
}

Media media_of(std::initializer_list<std::uint32_t> objects) {
    Media media;
    for (const std::uint32_t object : objects) media.push_back({object, 10 + object});
    return media;
}
void check_media(const Media& actual, std::initializer_list<std::uint32_t> objects) {
    std::vector<std::uint32_t> got;
    for (const Medium& medium : actual) got.push_back(medium.object);
    INFO("the objects that the ray is inside of, in the order in which they were entered");
    CHECK(or_say(got == std::vector<std::uint32_t>(objects),
                 show(got) + ", expected " + show(std::vector<std::uint32_t>(objects))));
    INFO("each with its own material, which here has the object's number and 10");
    for (const Medium& medium : actual) CHECK(medium.material == 10 + medium.object);
}
Media crossed(const Media& media, std::uint32_t object) { return cross(media, {object, 10 + object}); }

}  // namespace

// 07.4, media --------------------------------------------------------------------------------------------

TEST_CASE("a surface met for the first time is entered, met again it is left", "[07.4]") {
    const Media inside = crossed({}, 3);
    check_media(inside, {3});
    INFO("3 crossed twice");
    check_media(crossed(inside, 3), {});
}

TEST_CASE("media nest: the last entered is the one around the ray", "[07.4]") {
    INFO("inside of 5, 2 is crossed; and then again");
    check_media(crossed(media_of({5}), 2), {5, 2});
    check_media(crossed(media_of({5, 2}), 2), {5});
}

TEST_CASE("where media overlap, the first may be left first", "[07.4]") {
    INFO("inside of 5 and 2, 5 is crossed; inside of 1, 2, 3 and 4, 2 is crossed");
    check_media(crossed(media_of({5, 2}), 5), {2});
    check_media(crossed(media_of({1, 2, 3, 4}), 2), {1, 3, 4});
}

TEST_CASE("there may be any number of media at once", "[07.4]") {
    INFO("inside of 1 to 8, 9 is crossed, and crossed again, or 1; then a thousand objects");
    const Media eight = media_of({1, 2, 3, 4, 5, 6, 7, 8});
    check_media(crossed(eight, 9), {1, 2, 3, 4, 5, 6, 7, 8, 9});
    check_media(crossed(crossed(eight, 9), 9), {1, 2, 3, 4, 5, 6, 7, 8});
    check_media(crossed(crossed(eight, 9), 1), {2, 3, 4, 5, 6, 7, 8, 9});
    Media media;
    for (std::uint32_t object = 0; object < 1000; ++object) media = crossed(media, object);
    CHECK(media.size() == 1000);
    for (std::uint32_t object = 0; object < 999; ++object) media = crossed(media, object);
    check_media(media, {999});
}

TEST_CASE("entering and leaving in any order ends outside", "[07.4]") {
    Random random(78);
    for (int i = 0; i < cases(2000); ++i) {
        Media media;
        std::vector<std::uint32_t> inside;
        for (int step = 0; step < 40; ++step) {
            const auto object = static_cast<std::uint32_t>(random.index(6));
            media = crossed(media, object);
            const auto at = std::find(inside.begin(), inside.end(), object);
            if (at != inside.end())
                inside.erase(at);
            else
                inside.push_back(object);
            INFO("object " << object
                           << " was crossed: how many media the ray is inside of, and which, by entering");
            REQUIRE(media.size() == inside.size());
            for (std::size_t k = 0; k < inside.size(); ++k) REQUIRE(media[k].object == inside[k]);
        }
    }
}

// 07.5 ---------------------------------------------------------------------------------------------------

TEST_CASE("a mirror sends one ray on, weighted by its specular colour", "[07.5]") {
    const World world = world_of("specular .5 .25 1\nplane 0 0 0 0 0 1\n");
    const Branches next = scatter_at(world, forward, {}, {1, 0.5, 0.25}, 2);
    INFO(
        "a mirror of specular (0.5, 0.25, 1), met straight by a branch of weight (1, 0.5, 0.25) and depth 2");
    check_count(next, 1);
    CHECK(next.branch[0].kind == RayKind::Reflection);
    check_weight(next.branch[0], {0.5, 0.125, 0.25});
    check_direction(next.branch[0], {0, 0, 1});
    check_depth_in(next.branch[0], 0);
    INFO("its depth, one more than the branch's; its origin, in front of the mirror");
    CHECK(next.branch[0].depth == 3);
    CHECK(next.branch[0].ray.origin.z >= 0);
}

TEST_CASE("a mirror mirrors on both sides, whichever way its normal points", "[07.5]") {
    for (const char* normal : {"0 1 1", "0 -1 -1"}) {
        const World world = world_of(std::string("specular 1 1 1\nplane 0 0 0 ") + normal + "\n");
        const Branches next = scatter_at(world, forward);
        INFO("a slanted mirror whose normal is along " << normal << ", met along -z");
        check_count(next, 1);
        check_direction(next.branch[0], {0, 1, 0}, 8 * u);
    }
}

TEST_CASE("an opaque mirror mirrors by its specular colour, whatever Fresnel's law it names", "[07.5]") {
    for (const char* law : {"exact", "schlick"}) {
        const World world =
            world_of(std::string("specular .5 .25 1\nior 1.5\nfresnel ") + law + "\nplane 0 0 0 0 0 1\n");
        const Branches next = scatter_at(world, forward);
        INFO("a mirror of specular (0.5, 0.25, 1) without transmission, ior 1.5, fresnel " << law);
        check_count(next, 1);
        check_weight(next.branch[0], {0.5, 0.25, 1});
    }
}

TEST_CASE("a matte surface sends nothing on", "[07.5]") {
    check_count(
        scatter_at(world_of("diffuse 1 1 1\nplane 0 0 0 0 0 1\nspecular 1 0 0\nsphere 9 9 9 1\n"), forward),
        0);
}

TEST_CASE("glass by Fresnel's formulas sends R one way and 1 - R times its colour the other", "[07.5]") {
    for (const char* law : {"exact", "schlick"}) {
        const World world =
            world_of(std::string("transmission 1 .5 .25\nior 1.5\nfresnel ") + law + "\nsphere 0 0 0 1\n");
        const Branches next = scatter_at(world, forward);
        INFO("a ball of glass of transmission (1, 0.5, 0.25), ior 1.5, fresnel " << law << ", met straight");
        check_count(next, 2);
        const Branch &mirrored = next.branch[0], &through = next.branch[1];
        CHECK(mirrored.kind == RayKind::Reflection);
        check_weight(mirrored, Vec3(0.04), 8 * u);
        check_depth_in(mirrored, 0);
        check_direction(mirrored, {0, 0, 1}, 8 * u);
        CHECK(through.kind == RayKind::Refraction);
        check_weight(through, 0.96 * Vec3(1, 0.5, 0.25), 8 * u);
        check_depth_in(through, 1);
        check_direction(through, {0, 0, -1}, 8 * u);
        INFO("the z at which each starts, outside of the ball and in it");
        CHECK(mirrored.ray.origin.z >= 1);
        CHECK(through.ray.origin.z <= 1);
    }
}

TEST_CASE("glass that is met aslant mirrors by the law that it names", "[07.5]") {
    // The cosine is 0.28, and by Snell's law the sine inside 0.96 / 1.5.
    const Real inside = std::sqrt(1 - 0.64 * 0.64);
    const Real across = (0.28 - 1.5 * inside) / (0.28 + 1.5 * inside);
    const Real along = (1.5 * 0.28 - inside) / (1.5 * 0.28 + inside);
    const auto check = [](const char* law, Real part) {
        const World world =
            world_of(std::string("transmission 1 1 1\nior 1.5\nfresnel ") + law + "\nplane 0 0 0 0 0 1\n");
        const Branches next = scatter_at(world, {{0, 0, 1}, {0.96, 0, -0.28}});
        INFO("glass of ior 1.5, met at a cosine of 0.28, fresnel " << law);
        check_count(next, 2);
        check_weight(next.branch[0], Vec3(part), 32 * u);
        check_weight(next.branch[1], Vec3(1 - part), 32 * u);
    };
    check("exact", (across * across + along * along) / 2);
    check("schlick", 0.04 + 0.96 * std::pow(0.72, 5));
}

TEST_CASE("without a Fresnel law glass mirrors by its specular colour and lets all its colour through",
          "[07.5]") {
    const World world = world_of("specular .1 .2 .3\ntransmission .9 .8 .7\nior 1.5\nsphere 0 0 0 1\n");
    const Branches next = scatter_at(world, forward);
    INFO("a ball of glass of specular (0.1, 0.2, 0.3) and transmission (0.9, 0.8, 0.7), no Fresnel law");
    check_count(next, 2);
    check_weight(next.branch[0], {0.1, 0.2, 0.3});
    check_weight(next.branch[1], {0.9, 0.8, 0.7});
}

TEST_CASE("light bends towards the normal on its way into glass and away from it on its way out", "[07.5]") {
    const World world = world_of("transmission 1 1 1\nior 1.5\nplane 0 0 0 0 0 1\n");
    const Ray slanted{{0, 0, 1}, {0.6, 0, -0.8}};
    const Branches in = scatter_at(world, slanted);
    INFO("glass of ior 1.5 below z = 0: a ray of sine 0.6 on its way in; and one of sine 0.4 on its way out");
    check_count(in, 1);
    check_direction(in.branch[0], {0.4, 0, -std::sqrt(0.84)}, 8 * u);
    // From the other side, inside: sine 0.4 becomes 0.6.
    const Ray back{{0, 0, -1}, {0.4, 0, std::sqrt(0.84)}};
    const Branches out = scatter_at(world, back, in.branch[0].media);
    check_count(out, 1);
    check_direction(out.branch[0], {0.6, 0, 0.8}, 8 * u);
    check_depth_in(out.branch[0], 0);
}

TEST_CASE("where reflection is total all light goes along the mirror direction, inside", "[07.5]") {
    const Ray slanted{{0, 0, -1}, {0.8, 0, 0.6}};
    for (const char* law : {"none", "exact", "schlick"}) {
        const World world =
            world_of(std::string("specular .1 .1 .1\ntransmission .8 .8 .8\nior 1.5\nfresnel ") + law +
                     "\nplane 0 0 0 0 0 1\n");
        const Branches next = scatter_at(world, slanted, cross({}, {0, world.primitives[0].material}));
        INFO("inside of glass of ior 1.5, sine 0.8, which is beyond the critical angle; fresnel " << law);
        check_count(next, 1);
        CHECK(next.branch[0].kind == RayKind::Reflection);
        check_direction(next.branch[0], {0.8, 0, -0.6}, 8 * u);
        check_weight(next.branch[0], Vec3(1));
        check_depth_in(next.branch[0], 1);
        INFO("the z at which it starts, inside");
        CHECK(next.branch[0].ray.origin.z <= 0);
    }
}

TEST_CASE("nothing goes on at the greatest depth", "[07.5]") {
    const World world = world_of("maxdepth 3\nspecular 1 1 1\nplane 0 0 0 0 0 1\n");
    INFO("a mirror, maxdepth 3; met by a branch of depth 2, and by one of depth 3");
    check_count(scatter_at(world, forward, {}, Vec3(1), 2), 1);
    check_count(scatter_at(world, forward, {}, Vec3(1), 3), 0);
}

TEST_CASE("a ray goes on where one channel contributes more than the least contribution", "[07.5]") {
    const World world = world_of("mincontribution .125\nspecular .5 .5 .5\nplane 0 0 0 0 0 1\n");
    const auto check = [&](const Vec3& weight, int count) {
        INFO("a mirror of specular 0.5, mincontribution 0.125, met by a branch of weight " << weight);
        check_count(scatter_at(world, forward, {}, weight), count);
    };
    check(Vec3(0.26), 1);
    check({0, 0, 0.26}, 1);
    check(Vec3(0.25), 0);
    check(Vec3(0.24), 0);
}

TEST_CASE("light from water into glass bends by the ratio of the two", "[07.5]") {
    const World world =
        world_of("transmission 1 1 1\nior 1.33\nsphere 0 0 0 2\nior 1.5\nplane 0 0 0 0 0 1\n");
    const Media water = cross({}, {0, world.primitives[0].material});
    const Branches in = scatter_at(world, {{0, 0, 1}, {0.6, 0, -0.8}}, water);
    INFO("from water, ior 1.33, with sine 0.6 into glass, ior 1.5");
    check_count(in, 1);
    {
        INFO("the sine in the glass, 0.6 * 1.33 / 1.5");
        CHECK(near(in.branch[0].ray.direction.x, 0.6 * 1.33 / 1.5, 8 * u));
    }
    check_depth_in(in.branch[0], 2);
}

TEST_CASE("from a smooth surface rays leave on the right side of its flat triangle", "[07.5]") {
    // The triangle lies in z = 0, and its normals lean so far that many directions would come out wrong.
    const std::string corners =
        "vertexnormal -9 -9 0 1 0 .2\nvertexnormal 9 -9 0 1 0 .2\nvertexnormal 0 9 0 1 0 .2\n"
        "vertexnormal 0 0 -9 0 0 -1\n";
    const std::string pyramid = "trinormal 0 1 2\ntrinormal 0 3 1\ntrinormal 1 3 2\ntrinormal 2 3 0\n";
    const World mirror = world_of("specular 1 1 1\n" + corners + "trinormal 0 1 2\n");
    const World glass = world_of("transmission 1 1 1\nior 1.5\nfresnel exact\n" + corners + pyramid);
    Random random(85);
    const Vec3 lean = normalize(Vec3(1, 0, 0.2));
    int steep = 0, refused = 0, total = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 d = random.direction();
        if (std::abs(d.z) < 0.01) continue;  // would miss the triangle
        const Real from = d.z < 0 ? 1 : -1;  // the side that the ray comes from
        const Ray ray{{-d.x / std::abs(d.z) * 1e-3, 0, from * 1e-3}, d};
        for (const World* world : {&mirror, &glass}) {
            const bool leaving = from < 0 && world == &glass;
            const Media inside = leaving ? Media{Medium{0, world->primitives[0].material}} : Media{};
            const Branches next = scatter_at(*world, ray, inside);
            Vec3 sum(0);
            for (int k = 0; k < next.count; ++k) {
                const Branch& one = next.branch[static_cast<std::size_t>(k)];
                const bool mirrored = one.kind == RayKind::Reflection;
                const Real side = mirrored ? from : -from;
                INFO("ray along " << show(d) << ": " << (mirrored ? "mirrored" : "refracted") << " from "
                                  << show(one.ray.origin) << " along " << show(one.ray.direction)
                                  << "; the flat triangle lies in z = 0");
                REQUIRE(or_say(one.ray.direction.z * side >= 0,
                               "it leaves to the wrong side of the flat triangle"));
                REQUIRE(
                    or_say(one.ray.origin.z * side >= 0, "it starts on the wrong side of the flat triangle"));
                REQUIRE(
                    or_say(std::abs(length(one.ray.direction) - 1) <= 16 * u, "its direction is not 1 long"));
                sum += one.weight;
            }
            {
                INFO("ray along " << d
                                  << ": the sum of the weights of the rays that go on; no light is lost");
                REQUIRE(near_color(sum, Vec3(1), 8 * u));
            }
            if (leaving && next.count == 1) {
                INFO("ray along " << show(d) << ", totally reflected along "
                                  << show(next.branch[0].ray.direction) << " inside the glass, the triangle "
                                  << "is z = 0");
                INFO("total reflection is at the flat triangle, not at the leaning normal: its direction");
                REQUIRE(near_direction(next.branch[0].ray.direction, {d.x, d.y, -d.z}, 8 * u));
                ++total;
            }
            if (leaving && next.count == 2) {
                Vec3 mirrored = d - 2 * dot(d, lean) * lean;
                if (mirrored.z > 0) mirrored.z = -mirrored.z;
                INFO("ray along " << show(d) << ", inside the glass, from where a part gets out");
                INFO(
                    "the other part is mirrored at the leaning normal, and turned back into the glass: its "
                    "direction");
                REQUIRE(near_direction(next.branch[0].ray.direction, mirrored, 16 * u));
            }
            if (world != &glass || leaving) continue;
            // By Snell's law for the leaning normal: does the refracted ray get through the triangle at all?
            const Vec3 n = dot(lean, d) > 0 ? -lean : lean;
            const Vec3 along = (d - dot(d, n) * n) / 1.5;
            const Vec3 refracted = along - std::sqrt(1 - dot(along, along)) * n;
            if (std::abs(refracted.z) < 1e-9) continue;
            INFO("ray along " << show(d) << ", refracted along " << show(refracted)
                              << "; the triangle is z = 0, so what is refracted "
                              << (refracted.z * from < 0 ? "gets through" : "does not get through")
                              << "\nhow many rays go on");
            REQUIRE(next.count == (refracted.z * from < 0 ? 2 : 1));
            refused += next.count == 1;
        }
        steep += (d - 2 * dot(d, lean) * lean).z * from < 0;
    }
    CHECK(steep > cases(2000) / 10);  // directions that the leaning normal would send to the wrong side
    CHECK(refused > demanded(cases(2000) / 100, 0));
    CHECK(total > demanded(cases(2000) / 100, 0));
}

// 07.6 ---------------------------------------------------------------------------------------------------

TEST_CASE("a ray that meets nothing sees the background", "[07.6]") {
    const World world = world_of("background .1 .2 .3\nspecular 1 1 1\nsphere 0 9 0 1\n");
    INFO("background (0.1, 0.2, 0.3), a ray that meets nothing: its radiance");
    CHECK(near_color(radiance(world, forward), {0.1, 0.2, 0.3}, 0));
}

TEST_CASE("a mirror shows what stands in front of it, weighted by its colour", "[07.6]") {
    const World world = world_of(
        "specular .5 .25 1\nemission .125 .125 .125\nplane 0 0 0 0 1 1\n"
        "specular 0 0 0\nemission 1 .5 .25\nsphere 0 5 0 1\n");
    const Vec3 color = radiance(world, forward);
    INFO(
        "a mirror of specular (0.5, 0.25, 1) and emission 0.125 that shows a sphere of emission (1, 0.5, "
        "0.25)");
    CHECK(near_color(color, {0.625, 0.25, 0.375}, 8 * u));
}

TEST_CASE("between two mirrors the sum has one term a bounce", "[07.6]") {
    for (const int depth : {0, 1, 2, 6}) {
        const World world =
            world_of("maxdepth " + std::to_string(depth) +
                     "\nemission 1 1 1\nspecular .5 .25 0\n"
                     "plane 0 0 -1 0 0 1\nplane 0 0 9 0 0 -1\nspecular 1 1 1\nsphere 99 0 0 1\n");
        Vec3 expected(0), weight(1);
        for (int k = 0; k <= depth; ++k) expected += weight, weight *= Vec3(0.5, 0.25, 0);
        const RayCounts before = ray_counts();
        const Vec3 color = radiance(world, forward);
        INFO("two facing mirrors of emission 1 and specular (0.5, 0.25, 0), maxdepth " << depth);
        {
            INFO("the radiance");
            CHECK(near_color(color, expected, 0));
        }
        INFO("how many mirrored rays, and how many refracted ones, were counted in ray_counts()");
        CHECK(ray_counts().reflection - before.reflection == static_cast<std::uint64_t>(depth));
        CHECK(ray_counts().refraction == before.refraction);
    }
}

TEST_CASE("rays that contribute too little end the sum", "[07.6]") {
    const World world = world_of(
        "maxdepth 100\nmincontribution .2\nemission 1 1 1\nspecular .5 .5 .5\n"
        "plane 0 0 -1 0 0 1\nplane 0 0 9 0 0 -1\n");
    INFO("two facing mirrors of emission 1 and specular 0.5, mincontribution 0.2: 1 + 0.5 + 0.25");
    CHECK(near_color(radiance(world, forward), Vec3(1 + 0.5 + 0.25), 0));
}

TEST_CASE("depth 1000 and 10000 between two facing mirrors: all terms, little memory", "[07.6]") {
    for (const int depth : {1000, 10000}) {
        // Terms of 2^-20 add up without any rounding.
        const std::string glow = "emission 9.5367431640625e-07 0 0\n";
        const World world = world_of("maxdepth " + std::to_string(depth) + "\n" + glow +
                                     "specular 1 1 1\nplane 0 0 -1 0 0 1\nplane 0 0 9 0 0 -1\n");
        INFO("two facing mirrors that add 2^-20 each, maxdepth " << depth
                                                                 << ": the sum of maxdepth + 1 terms");
        CHECK(radiance(world, forward).x == std::ldexp(depth + 1, -20));
    }
}

TEST_CASE("the tree of a glass ball in a room of mirrors needs no more memory than a stack of its depth",
          "[07.6]") {
    const int depth = cases(16) < 16 ? 12 : 16;
    // Each meeting with the glass sends two rays on, and every ray meets something again.
    const World world =
        world_of("maxdepth " + std::to_string(depth) +
                 "\nspecular 1 1 1\nsphere 0 0 0 20\nspecular .5 .5 .5\ntransmission .5 .5 .5\n"
                 "ior 1.01\nsphere 0 0 0 4\nsphere .1 0 0 3\nsphere -.1 0 0 2\nsphere 0 .1 0 1\n");
    const RayCounts before = ray_counts();
    taken = most_taken = 0;
    watched = true;
    const Vec3 color = radiance(world, {{0, 0.3, 5}, {0, 0, -1}});
    watched = false;
    const auto rays =
        ray_counts().reflection + ray_counts().refraction - before.reflection - before.refraction;
    {
        INFO("nothing shines: the radiance, and how many rays there are");
        CHECK(color == Vec3(0));
        CHECK(rays > 20u * static_cast<unsigned>(depth));
    }
    // A vector that grows by doubling holds old and new elements for a moment: three times its height. The
    // list of media of a ray may be one, too.
    const std::size_t one_ray = sizeof(Branch) + 4 * sizeof(Medium);
    INFO("a tree of " << rays << " rays, depth " << depth << ", " << one_ray
                      << " bytes a ray: how many bytes there are at once, at most");
    CHECK(most_taken <= 3 * static_cast<std::size_t>(depth + 1) * one_ray + 256);
    CHECK(most_taken >= sizeof(Branch));  // memory was counted
}

TEST_CASE("rays are counted by their kinds", "[07.6]") {
    const auto check = [](const std::string& ball, const Vec3& from, unsigned mirrored, unsigned refracted) {
        const World world =
            world_of("maxdepth 3\nspecular 1 1 1\nplane 0 0 -2 0 0 1\nspecular 0 0 0\n" + ball);
        const RayCounts before = ray_counts();
        radiance(world, {from, {0, 0, -1}});
        INFO("a camera ray from " << from << " along -z, a mirror in z = -2, maxdepth 3, " << ball);
        INFO("how many mirrored rays, and how many refracted ones, are counted");
        CHECK(ray_counts().reflection - before.reflection == mirrored);
        CHECK(ray_counts().refraction - before.refraction == refracted);
    };
    const std::string ball = "transmission 1 1 1\nior 1.5\nsphere 0 0 0 1\n";
    check(ball, {3, 0, 5}, 1, 0);
    check(ball, {0, 0, 5}, 1, 2);
}

TEST_CASE("a lamp inside a ball lights its inner side", "[07.6]") {
    // The ray meets the wall at (0, 0, -2), where the normal of the ball looks outwards, away from the lamp.
    const World world = world_of("point 0 0 0 .75 .5 .25\ndiffuse 1 1 1\nsphere 0 0 0 2\n");
    INFO(
        "a white ball of radius 2 around a lamp of colour (0.75, 0.5, 0.25), seen from inside: the radiance");
    CHECK(near_color(radiance(world, {{0, 0, 1}, {0, 0, -1}}), {0.75, 0.5, 0.25}, 32 * u));
}

TEST_CASE("glass absorbs along the way through it", "[07.6]") {
    // Straight through the middle: a way of 2 in the ball.
    const World world =
        world_of("background 1 1 1\ntransmission 1 .5 1\nior 1.5\nabsorption .1 .2 0\nsphere 0 0 0 1\n");
    const Vec3 expected(std::exp(-0.2), 0.25 * std::exp(-0.4), 1);
    const Vec3 color = radiance(world, forward);
    INFO(
        "a ball of glass, radius 1, transmission (1, 0.5, 1), absorption (0.1, 0.2, 0), on a white "
        "background: the radiance straight through its middle");
    CHECK(near_color(color, expected, 32 * u));
}

TEST_CASE("what glows in absorbing glass is dimmed on its way out, and not twice", "[07.6]") {
    const World world = world_of(
        "transmission 1 1 1\nior 1.5\nabsorption .5 1 2\nsphere 0 0 0 3\n"
        "transmission 0 0 0\nabsorption 0 0 0\nemission 1 1 1\nsphere 0 0 0 1\n");
    const Vec3 expected(std::exp(-1.0), std::exp(-2.0), std::exp(-4.0));
    const Vec3 color = radiance(world, forward);
    INFO(
        "a ball of radius 1 that glows white, in the middle of clear glass, radius 3, absorption (0.5, 1, "
        "2): the radiance straight towards it");
    CHECK(near_color(color, expected, 32 * u));
}

TEST_CASE("through water without an end nothing arrives", "[07.6]") {
    const World world =
        world_of("background 1 1 1\ntransmission 1 1 1\nior 1.33\nabsorption .1 0 .3\nplane 0 0 0 0 0 1\n");
    INFO("background 1, water of absorption (0.1, 0, 0.3) without an end: the radiance");
    CHECK(near_color(radiance(world, forward), {0, 1, 0}, 0));
}

TEST_CASE("a camera in glass: the first way absorbs already, and the ball is left, not entered", "[07.6]") {
    const World world =
        world_of("background 1 1 1\ntransmission 1 1 1\nior 1.5\nabsorption .1 .2 .4\nsphere 0 0 5 2\n");
    REQUIRE(world.eye_inside.size() == 1);
    const Vec3 color = radiance(world, forward);
    INFO("the eye in the middle of a ball of glass, radius 2, absorption (0.1, 0.2, 0.4)");
    {
        INFO("the radiance of white light after a way of 2");
        CHECK(near_color(color, {std::exp(-0.2), std::exp(-0.4), std::exp(-0.8)}, 16 * u));
    }
    // Off the middle the ray leaves glass for air, so the sine grows by 1.5.
    const auto tree = trace_tree(world, {{1, 0, 5}, {0, 0, -1}});
    REQUIRE(tree.size() == 2);
    const Vec3 out = tree[1].branch.ray.direction;
    const Real angle = std::asin(0.5), bent = std::asin(0.75);
    INFO("the direction in which a ray leaves the ball");
    CHECK(near_direction(out, {std::sin(angle - bent), 0, -std::cos(angle - bent)}, 16 * u));
}

TEST_CASE("through glass in water in glass the rays obey Bouguer's law", "[07.6]") {
    // In concentric shells, ior · distance of the ray's line from the centre is the same all along.
    const std::array<Real, 4> iors{1.5, 1.33, 1.7, 1.2}, radii{4, 3, 2, 1};
    std::string text = "transmission 1 1 1\nmaxdepth 20\n";
    for (std::size_t i = 0; i < 4; ++i)
        text += "ior " + std::to_string(iors[i]) + "\nsphere 0 0 0 " + std::to_string(radii[i]) + "\n";
    const World world = world_of(text);
    Random random(79);
    int deepest = 0;
    for (int i = 0; i < cases(1000); ++i) {
        const Real impact = random.uniform(0, 3.9);
        const auto tree = trace_tree(world, {{impact, 0, 10}, {0, 0, -1}});
        for (const TraceRecord& record : tree) {
            const Branch& b = record.branch;
            const Real ior = b.media.empty() ? 1 : world.materials[b.media.back().material].ior;
            const Real kept = ior * length(cross(b.ray.origin, b.ray.direction));
            deepest = std::max(deepest, static_cast<int>(b.media.size()));
            // Up to nine surfaces, each with a few roundings of points up to 4 from the centre.
            INFO("concentric shells; inside of "
                 << b.media.size() << " of them, ior " << ior
                 << ": ior times the distance of the ray's line from the centre");
            REQUIRE(near(kept, impact, 1000 * u * 4));
        }
        CHECK(tree.back().branch.media.size() == 0);  // and every ray gets out at last
    }
    CHECK(deepest == 4);
}

TEST_CASE("where two balls of one glass overlap, the faces inside bend nothing", "[07.6]") {
    const World world = world_of("transmission 1 1 1\nior 1.5\nsphere 0 0 .5 1\nsphere 0 0 -.5 1\n");
    const auto tree = trace_tree(world, {{0.3, 0.2, 5}, {0, 0, -1}});
    REQUIRE(tree.size() == 5);
    INFO("two balls of one glass; the direction behind a face inside of both, expected that before it");
    CHECK(near_direction(tree[2].branch.ray.direction, tree[1].branch.ray.direction, 16 * u));
    CHECK(near_direction(tree[3].branch.ray.direction, tree[1].branch.ray.direction, 16 * u));
    CHECK(tree[2].branch.media.size() == 2);
    CHECK(tree[4].branch.media.size() == 0);
}

TEST_CASE("faces at the same place do no harm: finite, and the tree ends", "[07.6]") {
    const World world = world_of(
        "background .5 .5 .5\nmaxdepth 10\ntransmission 1 1 1\nior 1.5\nfresnel exact\nabsorption .1 .1 .1\n"
        "sphere 0 0 0 1\nsphere 0 0 0 1\nior 1.33\nsphere 0 0 0 1\nplane 0 0 1 0 0 1\n");
    Random random(80);
    for (int i = 0; i < cases(2000); ++i) {
        const Vec3 aim = random.in_cube();
        const Vec3 color = radiance(world, {{0, 0, 5}, normalize(aim - Vec3(0, 0, 5))});
        INFO("towards " << aim << ": the radiance is " << color);
        REQUIRE(or_say(color.x >= 0 && color.x <= 0.5 * (1 + 100 * u),
                       "red is not from 0 to the background's 0.5"));
    }
}

TEST_CASE("in a closed white room glass by Fresnel's formulas loses no light", "[07.6]") {
    // Everything sees radiance 1: what is mirrored and what goes through add up to 1, but for the tree's cut.
    for (const char* law : {"exact", "schlick"}) {
        const World world = world_of(std::string("background 1 1 1\nmaxdepth 40\nmincontribution 1e-6\n"
                                                 "transmission 1 1 1\nior 1.5\nfresnel ") +
                                     law + "\nsphere 0 0 0 1\nsphere 1.5 2 0 1\n");
        Random random(81);
        for (int i = 0; i < cases(500); ++i) {
            const Vec3 aim = 1.5 * random.in_cube();
            const Vec3 color = radiance(world, {{0, 0, 5}, normalize(aim - Vec3(0, 0, 5))});
            INFO("fresnel " << law << ", towards " << aim << ": the radiance, 1 in a white room, is "
                            << color);
            // What is still in a ball after 40 bounces is (1 − R)·R³⁹ ≤ 1/(40e) of what went in; twice that.
            REQUIRE(or_say(color.x > 0.98, "light is lost"));
            REQUIRE(or_say(color.x <= 1 + 1000 * u, "light is gained"));
        }
    }
}

TEST_CASE("the tree as `course trace` prints it adds up to the pixel", "[07.6]") {
    // A lake without a bottom, a glass ball in and above it, a mirror; rays from the air and from the water.
    const World world = world_of(
        "background .4 .5 .6\nmaxdepth 6\npoint 0 4 4 .5 .5 .5\nspecular .5 .5 .5\ndiffuse .2 .2 .2\n"
        "sphere 2 1 0 .8\ntransmission .9 .9 .9\nior 1.5\nfresnel exact\nsphere 0 .3 0 1\n"
        "ior 1.33\nabsorption .3 .1 0\nplane 0 0 0 0 1 0\n",
        "camera 0 2 5 0 0 0 0 1 0 45\n");
    Random random(82);
    for (int i = 0; i < cases(1000); ++i) {
        const Ray ray{{0, 2, 5}, normalize(Vec3(2, 1.5, 1) * random.in_cube() - Vec3(0, 2, 5))};
        Vec3 sum(0);
        for (const TraceRecord& record : trace_tree(world, ray)) sum += record.weight * record.local;
        const Vec3 color = radiance(world, ray);
        INFO("ray along " << ray.direction << ": the sum over its tree, expected the radiance");
        REQUIRE(near_color(sum, color, 64 * u));
    }
}
