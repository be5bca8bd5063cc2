// Steps 05.2 to 05.5: what a surface does with the light.
#include "chapters/05_lighting/lighting.hpp"
#include "common/math/error.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using namespace rt::test;

namespace {

const Vec3 up(0, 0, 1);

/// Unit vector in the x-z plane, `degrees` from +z towards +x.
Vec3 leaning(Real degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }

/// A hundred roundings of numbers near 1: far less than any mistake makes, more than any sound way needs.
constexpr Real bound = 100 * unit_roundoff;

void check_lambert(const Vec3& n, const Vec3& l, Real expected, Real within = 0) {
    INFO("normal " << n << ", direction to the light " << l << ": the part of light by Lambert's law");
    CHECK(near(lambert(n, l), expected, within));
}

/// What a highlight's name is in a message.
struct Asked {
    const char* name;
    Real (*highlight)(const Vec3&, const Vec3&, const Vec3&, Real);
};
constexpr Asked of_blinn{"Blinn", blinn}, of_phong{"Phong", phong};

void check_highlight(const Asked& asked, const Vec3& n, const Vec3& l, const Vec3& v, Real shininess,
                     Real expected, Real within = 0) {
    INFO(asked.name << "'s highlight: normal " << n << ", to the light " << l << ", to the viewer " << v
                    << ", shininess " << shininess);
    CHECK(near(asked.highlight(n, l, v, shininess), expected, within));
}

using Highlights = Real (*)(const Vec3&, const Vec3&, const Vec3&, Real);

/// Directions that are made to give trouble: nearly equal, nearly opposite, perpendicular.
Vec3 awkward(const Vec3& other, Random& random) {
    switch (random.index(5)) {
        case 0:
            return other;
        case 1:
            return -other;
        case 2:
            return normalize(other + random.magnitude(-17, -1) * random.direction());
        case 3:
            return normalize(random.magnitude(-17, -1) * random.direction() - other);
        default:
            return random.direction();
    }
}

void check_range(Highlights highlight) {
    Random random(54);
    for (int i = 0; i < cases(50'000); ++i) {
        const Vec3 n = random.direction(), l = awkward(n, random);
        const Vec3 v = random.index(2) == 0 ? awkward(n, random) : awkward(l, random);
        const Real choices[] = {0, 1, 40, 1e6, random.magnitude(-6, 12)};
        const Real shininess = choices[random.index(5)];
        const Real part = highlight(n, l, v, shininess);
        INFO("normal " << n << ", to the light " << l << ", to the viewer " << v << ", shininess "
                       << shininess << ": the highlight, from 0 to 1");
        REQUIRE(part >= 0);
        REQUIRE(part <= 1);
    }
}

Material matte(const Vec3& diffuse) {
    Material material;
    material.ambient = Vec3(0);
    material.diffuse = diffuse;
    return material;
}

}  // namespace

// ------------------------------------------------------------------------------------------- 05.2 Lambert

TEST_CASE("by hand: light from (3, 4, 0) falls on the floor with the cosine 0.8", "[05.2]") {
    check_lambert({0, 1, 0}, {0.6, 0.8, 0}, 0.8, bound);
}

TEST_CASE("Lambert: the cosine between normal and light", "[05.2]") {
    check_lambert(up, up, 1);
    check_lambert(up, {0, 0.6, 0.8}, 0.8);
    check_lambert(up, {-0.8, 0, 0.6}, 0.6);
    check_lambert(up, leaning(60), 0.5, bound);
}

TEST_CASE("Lambert: nothing from the side or from behind", "[05.2]") {
    check_lambert(up, {1, 0, 0}, 0);
    check_lambert(up, {0, 0.6, -0.8}, 0);
    check_lambert(up, -up, 0);
}

TEST_CASE("Lambert: zero vectors give 0", "[05.2]") {
    check_lambert(Vec3(0), up, 0);
    check_lambert(up, Vec3(0), 0);
}

TEST_CASE("Lambert: light from all around a surface adds up to π", "[05.2]") {
    // The integral of the cosine over the hemisphere, by the mean over directions that are uniform in height.
    const int count = 1000;
    Real sum = 0;
    for (int i = 0; i < count; ++i) {
        const Real z = -1 + (2 * i + 1.0) / count;
        sum += lambert(up, {std::sqrt(1 - z * z), 0, z});
    }
    // z is spaced evenly, so the midpoint rule is exact for the linear integrand.
    INFO("the sum over all directions of the part by Lambert's law: π");
    CHECK(near(4 * pi * sum / count, pi, count * bound));
}

// --------------------------------------------------------------------------------------------- 05.3 Blinn

TEST_CASE("by hand: halfway between (0.6, 0.8, 0) and straight up, n·h squared is 0.9", "[05.3]") {
    const Vec3 n(0, 1, 0), l(0.6, 0.8, 0);
    check_highlight(of_blinn, n, l, n, 2, 0.9, bound);
    check_highlight(of_blinn, n, l, n, 4, 0.81, bound);
}

TEST_CASE("Blinn: brightest where the normal is halfway between light and viewer", "[05.3]") {
    for (const Real shininess : {1.0, 10.0, 1000.0})
        check_highlight(of_blinn, up, leaning(40), leaning(-40), shininess, 1, shininess * bound);
}

TEST_CASE("Blinn: light from above, viewer at 60 degrees, halfway at 30", "[05.3]") {
    check_highlight(of_blinn, up, up, leaning(60), 1, std::sqrt(3.0) / 2, bound);
    check_highlight(of_blinn, up, up, leaning(60), 2, 0.75, bound);
    check_highlight(of_blinn, up, up, leaning(60), 8, 0.31640625, bound);
}

TEST_CASE("Blinn: light and viewer may change places", "[05.3]") {
    Random random(55);
    for (int i = 0; i < cases(1'000); ++i) {
        const Vec3 n = random.direction(), l = random.direction(), v = random.direction();
        INFO("normal " << n << ", to the light " << l << ", to the viewer " << v
                       << ": the highlight, expected that with the two exchanged");
        REQUIRE(blinn(n, l, v, 7) == blinn(n, v, l, 7));
    }
}

TEST_CASE("Blinn: nothing where the half vector points away, or has no direction", "[05.3]") {
    check_highlight(of_blinn, up, -leaning(20), -leaning(10), 5, 0);
    check_highlight(of_blinn, up, -leaning(20), -leaning(10), 0, 0);
    check_highlight(of_blinn, up, leaning(50), -leaning(50), 5, 0);
    check_highlight(of_blinn, up, leaning(50), -leaning(50), 0, 0);
    check_highlight(of_blinn, Vec3(0), up, up, 5, 0);
    check_highlight(of_blinn, up, Vec3(0), Vec3(0), 5, 0);
}

TEST_CASE("Blinn: shininess 0 is a highlight all over, shininess 1e6 a pinprick", "[05.3]") {
    check_highlight(of_blinn, up, up, leaning(80), 0, 1);
    check_highlight(of_blinn, up, up, up, 1e6, 1);
    // h is 0.05 degrees off: cos^1e6 is about exp(-1e6 · 0.05²/2) with the angle in radians.
    check_highlight(of_blinn, up, up, leaning(0.1), 1e6, std::exp(-0.5e6 * radians(0.05) * radians(0.05)),
                    1e-6);
    check_highlight(of_blinn, up, up, leaning(10), 1e6, 0, 1e-300);
}

TEST_CASE("Blinn: nothing at a right angle, not even with shininess 0", "[05.3]") {
    check_highlight(of_blinn, up, {1, 0, 0}, {1, 0, 0}, 5, 0);
    check_highlight(of_blinn, up, {1, 0, 0}, {1, 0, 0}, 0, 0);
}

TEST_CASE("Blinn: always between 0 and 1", "[05.3]") { check_range(blinn); }

// --------------------------------------------------------------------------------------------- 05.4 Phong

TEST_CASE("by hand: (0.6, 0.8, 0) is mirrored to (-0.6, 0.8, 0), 0.8 from straight up", "[05.4]") {
    const Vec3 n(0, 1, 0), l(0.6, 0.8, 0);
    check_highlight(of_phong, n, l, n, 1, 0.8, bound);
    check_highlight(of_phong, n, l, n, 2, 0.64, bound);
}

TEST_CASE("Phong: brightest in the mirror direction", "[05.4]") {
    check_highlight(of_phong, {0, 1, 0}, {0.6, 0.8, 0}, {-0.6, 0.8, 0}, 3, 1, bound);
    for (const Real shininess : {1.0, 10.0, 1000.0})
        check_highlight(of_phong, up, leaning(40), leaning(-40), shininess, 1, shininess * bound);
}

TEST_CASE("Phong: light from above, viewer at 60 degrees, so the mirror direction is 60 degrees away",
          "[05.4]") {
    check_highlight(of_phong, up, up, leaning(60), 1, 0.5, bound);
    check_highlight(of_phong, up, up, leaning(60), 3, 0.125, bound);
}

TEST_CASE("Phong: nothing where the mirror direction is 90 degrees away or more", "[05.4]") {
    check_highlight(of_phong, {0, 1, 0}, {0.6, 0.8, 0}, {0.8, 0.6, 0}, 0.5, 0, 1e-7);
    check_highlight(of_phong, {0, 1, 0}, {0.6, 0.8, 0}, {0.96, 0.28, 0}, 0, 0);
    check_highlight(of_phong, {0, 1, 0}, {0.6, 0.8, 0}, {0.96, 0.28, 0}, 5, 0);
    check_highlight(of_phong, up, up, {1, 0, 0}, 0, 0);
}

TEST_CASE("Phong: shininess 0 is a highlight all over, shininess 1e6 a pinprick", "[05.4]") {
    check_highlight(of_phong, up, leaning(-30), leaning(40), 0, 1);
    check_highlight(of_phong, up, up, up, 1e6, 1);
    check_highlight(of_phong, up, up, leaning(10), 1e6, 0, 1e-300);
}

TEST_CASE("Phong: always between 0 and 1", "[05.4]") { check_range(phong); }

TEST_CASE("Phong: where light, normal and viewer lie in a plane, their angles add up", "[05.4]") {
    Random random(56);
    for (int i = 0; i < cases(5'000); ++i) {
        const Real to_light = random.uniform(-89, 89), to_viewer = random.uniform(-89, 89);
        if (std::abs(to_light + to_viewer) > 89) continue;
        INFO("light at " << to_light << " degrees from the normal, viewer at " << to_viewer
                         << ": the mirror direction is at " << -to_light
                         << "; Phong's highlight with shininess 1, the cosine between that and the viewer");
        REQUIRE(near(phong(up, leaning(to_light), leaning(to_viewer), 1),
                     std::cos(radians(to_light + to_viewer)), bound));
    }
}

// ------------------------------------------------------------------------------------- 05.5 the whole sum

TEST_CASE("by hand: what the lamp at (3, 4, 0) adds on the floor, seen from straight above", "[05.5]") {
    const LightSample light{.direction = {0.6, 0.8, 0}, .distance = 5, .color = {1, 2, 0.5}};
    Material material = matte({0.5, 0.25, 0});
    material.specular = Vec3(0.5);
    material.shininess = 2;
    const auto check = [&](const char* name, const Vec3& expected) {
        INFO(
            "light (1, 2, 0.5) on diffuse (0.5, 0.25, 0), cosine 0.8; specular 0.5, shininess 2, highlight "
            "by "
            << name << ": what the surface reflects");
        CHECK(near_color(reflected_light(material, {0, 1, 0}, {0, 1, 0}, light, Vec3(1)), expected, bound));
    };
    check("Blinn", {0.85, 1.3, 0.225});
    material.highlight = Highlight::Phong;
    check("Phong", {0.72, 1.04, 0.16});
}

TEST_CASE("a matte surface: visibility · colour · diffuse · cosine", "[05.5]") {
    const LightSample light{.direction = {0, 0.6, 0.8}, .distance = 1, .color = {2, 4, 1}};
    const Material material = matte({0.5, 0.25, 1});
    const auto check = [&](const Vec3& visibility, const Vec3& expected) {
        INFO(
            "light of colour (2, 4, 1) on a surface of diffuse colour (0.5, 0.25, 1), cosine 0.8, visibility "
            << visibility << ": what the surface reflects");
        CHECK(near_color(reflected_light(material, up, up, light, visibility), expected, bound));
    };
    check(Vec3(1), {0.8, 0.8, 0.8});
    check({1, 0.5, 0}, {0.8, 0.4, 0});
    check(Vec3(0), Vec3(0));
}

TEST_CASE("where specular is black, no highlight is computed", "[05.5]") {
    // Whatever is computed with a shininess that is not a number is not a number either, even times 0.
    const LightSample light{.direction = {0, 0.6, 0.8}, .distance = 1, .color = {2, 4, 1}};
    Material material = matte({0.5, 0.25, 1});
    material.shininess = std::numeric_limits<Real>::quiet_NaN();
    for (const Highlight highlight : {Highlight::Blinn, Highlight::Phong}) {
        material.highlight = highlight;
        INFO(
            "light of colour (2, 4, 1) on a matte surface of diffuse colour (0.5, 0.25, 1), cosine 0.8, "
            "whose shininess is not a number, which shows whether it is used: what the surface "
            "reflects");
        CHECK(near_color(reflected_light(material, up, up, light, Vec3(1)), {0.8, 0.8, 0.8}, bound));
    }
}

TEST_CASE("a shiny surface adds specular · highlight", "[05.5]") {
    const LightSample light{.direction = up, .distance = 1, .color = {1, 2, 4}};
    Material material = matte({0.5, 0, 0});
    material.specular = {0, 0.25, 0.5};
    material.shininess = 2;
    const auto check = [&](const char* name, const Vec3& expected) {
        INFO(
            "light of colour (1, 2, 4) from straight above, the viewer at 60 degrees; diffuse (0.5, 0, 0), "
            "specular (0, 0.25, 0.5), shininess 2, highlight by "
            << name << ": what the surface reflects");
        CHECK(near_color(reflected_light(material, up, leaning(60), light, Vec3(1)), expected, bound));
    };
    // h is at 30 degrees from the normal, r at 60 from the viewer.
    check("Blinn", {0.5, 0.375, 1.5});
    material.highlight = Highlight::Phong;
    check("Phong", {0.5, 0.125, 0.5});
}

TEST_CASE("a white highlight of light from the side", "[05.5]") {
    const LightSample light{.direction = leaning(60), .distance = 1, .color = {1, 2, 4}};
    Material material = matte({0.5, 0, 0});
    material.specular = Vec3(1);
    material.shininess = 2;
    const auto check = [&](const char* name, const Vec3& expected) {
        INFO(
            "light of colour (1, 2, 4) at 60 degrees from the normal, the viewer straight above; diffuse "
            "(0.5, "
            "0, 0), specular (1, 1, 1), shininess 2, highlight by "
            << name << ": what the surface reflects");
        CHECK(near_color(reflected_light(material, up, up, light, Vec3(1)), expected, bound));
    };
    // The part by Lambert's law is 0.25; h is at 30 degrees from the normal, r at 60 from the viewer.
    check("Blinn", {1, 1.5, 3});
    material.highlight = Highlight::Phong;
    check("Phong", {0.5, 0.5, 1});
}

TEST_CASE("light from behind gives nothing, not even a highlight", "[05.5]") {
    Material material = matte(Vec3(0.5));
    material.specular = Vec3(1);
    material.shininess = 1;
    // The half vector is on the normal's side; the surface is in the way all the same.
    const LightSample behind{.direction = leaning(95), .distance = 1, .color = Vec3(1)};
    for (const Highlight highlight : {Highlight::Blinn, Highlight::Phong}) {
        material.highlight = highlight;
        const char* const name = highlight == Highlight::Blinn ? "Blinn" : "Phong";
        {
            INFO("light from 5 degrees below the surface, highlight by " << name
                                                                         << ": what the surface reflects");
            CHECK(near_color(reflected_light(material, up, leaning(-60), behind, Vec3(1)), Vec3(0), 0));
        }
        INFO("light along the surface, highlight by " << name << ": what the surface reflects");
        CHECK(near_color(reflected_light(material, up, leaning(-60), {{1, 0, 0}, 1, Vec3(1)}, Vec3(1)),
                         Vec3(0), 0));
    }
}

TEST_CASE("zero normals and directions, and light on the surface, give black and never NaN", "[05.5]") {
    Material material = matte(Vec3(0.5));
    material.specular = Vec3(1);
    const Vec3 vectors[] = {Vec3(0), up, -up, {1, 0, 0}};
    for (const Real shininess : {0.0, 1.0, 1e6}) {
        material.shininess = shininess;
        for (const Vec3& n : vectors)
            for (const Vec3& l : vectors)
                for (const Vec3& v : vectors)
                    for (const Highlight highlight : {Highlight::Blinn, Highlight::Phong}) {
                        material.highlight = highlight;
                        const Vec3 color = reflected_light(material, n, v, {l, 0, Vec3(1)}, Vec3(1));
                        INFO("normal " << n << ", to the light " << l << ", to the viewer " << v
                                       << ", shininess " << shininess << ", highlight by "
                                       << (highlight == Highlight::Blinn ? "Blinn" : "Phong")
                                       << ": what the surface reflects");
                        REQUIRE(or_say(is_finite(color), show(color) + ", expected finite numbers"));
                        if (n == Vec3(0) || l == Vec3(0)) REQUIRE(near_color(color, Vec3(0), 0));
                    }
    }
    const LightSample on_the_point = sample_light(PointLight{.position = up, .color = Vec3(1)}, up);
    INFO("what 05.1 says of a lamp on the very point is " << on_the_point
                                                          << ": what the surface reflects of it");
    CHECK(near_color(reflected_light(material, up, up, on_the_point, Vec3(1)), Vec3(0), 0));
}

TEST_CASE("twice the light is twice the radiance, and lights do not disturb each other", "[05.5]") {
    Random random(57);
    for (int i = 0; i < cases(5'000); ++i) {
        Material material = matte(Vec3(random.uniform(0, 1)));
        material.specular = Vec3(random.uniform(0, 1), 0, random.uniform(0, 1));
        material.shininess = random.magnitude(-1, 3);
        LightSample light{
            .direction = random.direction(), .distance = 1, .color = Vec3(random.uniform(0, 1))};
        const Vec3 n = random.direction(), v = random.direction();
        const Vec3 once = reflected_light(material, n, v, light, Vec3(1));
        light.color *= 2;
        INFO("a surface reflects " << once << " of some light: what it reflects of light twice as bright");
        REQUIRE(reflected_light(material, n, v, light, Vec3(1)) == Real(2) * once);
    }
}

TEST_CASE("what a surface shows without light is ambient plus emission", "[05.5]") {
    Material material = matte({0.5, 0.75, 0.25});
    material.ambient = {0.125, 0.25, 0};
    material.emission = {0.25, 0, 0.5};
    INFO(
        "ambient (0.125, 0.25, 0), emission (0.25, 0, 0.5), diffuse (0.5, 0.75, 0.25), which is for lights: "
        "what the surface shows without any light");
    CHECK(near_color(emitted_light(material), {0.375, 0.25, 0.5}, 0));
}

TEST_CASE("the light of very many lamps adds up", "[05.5]") {
    const int count = cases(1'000'000);
    World world;
    world.point_lights.assign(
        static_cast<std::size_t>(count),
        {.position = {0, 0, 2}, .color = Vec3(1.0 / count), .attenuation = {0, 0, 0.25}});
    Surface surface;
    surface.normal = surface.shading_normal = up;
    Material material = matte(Vec3(0.5));
    material.ambient = Vec3(0.125);
    const Vec3 color = local_light(world, surface, material, up, up);
    INFO(count << " lights, together white, above a surface of diffuse 0.5 and ambient 0.125: what it shows");
    // Half of all the light, and the ambient; a rounding for each addition.
    CHECK(near_color(color, Vec3(0.625), count * unit_roundoff));
}
