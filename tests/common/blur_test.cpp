// Pictures through a lens, of what moves, and under lights with an extent: what chapter 12 brings to a scene.
#include "chapters/06_shadows/shadow.hpp"
#include "chapters/12_distribution/motion.hpp"
#include "common/render/compile.hpp"
#include "common/render/explain.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"
#include "tests/pictures.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace rt;

namespace {

const std::string view = "size 40 30\ncamera 0 1 6  0 0.5 0  0 1 0  40\n";
const std::string things =
    "directional 1 2 2  .8 .8 .7\ndiffuse .7 .7 .7\nplane 0 0 0  0 1 0\nsphere -.8 .5 0 .5\n"
    "box .3 0 -.5  1.1 .8 .3\n";

World world_of(const std::string& text) { return compile(parse_scene_text(view + text, "blur.scene")); }

Image picture(const std::string& text) { return render(world_of(text)).image; }

bool same(const Image& a, const Image& b) { return a.pixels == b.pixels; }

constexpr const char* things_of_all_kinds[] = {
    "sphere .3 .5 0 .5\n",
    "box -.5 0 -.5  .5 1 .5\n",
    "disc 0 .5 0  0 .3 1  .6\n",
    "cylinder 0 0 0  0 1 0 .4\n",
    "cone 0 0 0 .5  0 1 0 0\n",
    "torus 0 .5 0  0 1 .4  .5 .15\n",
    "openCylinder 0 0 0  0 1 0 .4\n",
    "vertex -1 0 0\nvertex 1 0 0\nvertex 0 1 .2\ntri 0 1 2\n",
    "vertex -1 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex -1 1 0\npolygon 0 1 2 3\n",
    ("vertexnormal -1 0 0 -1 0 1\nvertexnormal 1 0 0 1 0 1\nvertexnormal 0 1 0 0 1 1\n"
     "trinormal 0 1 2\n"),
    "intersection\nsphere 0 .5 0 .5\nbox -.4 0 -.4  .4 .9 .4\nend\n",
    "quadric 1 2 3 0 0 0 0 -1 0 0  -1 -1 -1  1 2 1\n",
    "translate 0 .5 0\nrotate 1 1 0 30\nscale .5 .3 .4\nsphere 0 0 0 1\n"};

Vec3 center(const Image& image) { return pixel(image, image.width / 2, image.height / 2); }

}  // namespace

TEST_CASE("what does not blur costs nothing and changes no bit", "[blur]") {
    const std::string spp = GENERATE("", "spp 4\n", "spp 4\nsampler regular\n");
    const Image plain = picture(spp + things);
    for (const char* nothing : {"lens 0 5\n", "aperture 5\n", "cameramotion 0 0 0\n", "motion 0 0 0\n",
                                "spin 1 2 3 0\n", "shutter .5 .5\n", "gloss 10\n", "lightsamples 9\n"}) {
        INFO(spp << nothing);
        const World world = world_of(spp + nothing + things);
        CHECK_FALSE(world.needs.blur);
        CHECK_FALSE(world.needs.distribution);
        const RenderResult result = render(world);
        CHECK(same(result.image, plain));
    }
    CHECK(render(world_of(things)).rays.random_numbers == 0);
}

TEST_CASE("a lens becomes a pinhole as it gets smaller", "[blur]") {
    const std::string regular = "spp 4\nsampler regular\n";
    const Image pinhole = picture(regular + things);
    const auto off = [&](const char* lens) {
        return test::rms_difference(picture(regular + lens + things), pinhole);
    };
    CHECK(off("lens .2 6\n") > 4 * off("lens .02 6\n"));
    CHECK(off("lens 1e-9 6\n") < 1e-6);
}

TEST_CASE("a moving thing has the same bits in an accelerator and without", "[blur]") {
    std::string balls = "diffuse .6 .5 .4\n";
    for (int i = 0; i < 40; ++i)
        balls += "motion " + std::to_string((i % 5 - 2) * 0.3) + " " + std::to_string((i % 3) * 0.2) +
                 " 0\nsphere " + std::to_string(i % 8 * 0.4 - 1.4) + " " + std::to_string(i / 8 * 0.3) + " " +
                 std::to_string(i % 7 * -0.3) + " .12\n";
    const std::string lamp = "spp 4\ndirectional 1 2 2  1 1 1\nquadLight -1 3 0  0 0 1  1 0 0  5 5 5\n";
    const Image none = picture("accelerator none\n" + lamp + balls);
    for (const char* accelerator : {"accelerator grid\n", "accelerator nested\n", "accelerator bvh\n"})
        CHECK(same(none, picture(accelerator + lamp + balls)));
}

TEST_CASE("moving things of all kinds are where they would stand at that time", "[blur]") {
    // At the time ½ each is where the same thing stands that does not move. A shutter that is open around
    // one instant only is one sample of `sampler regular`.
    for (const char* thing : things_of_all_kinds) {
        INFO(thing);
        const std::string lamp = "spp 1\nsampler regular\ndirectional 1 2 2  1 1 1\ndiffuse .8 .7 .6\n";
        const Image moving = picture(lamp + "motion .5 .25 -.5\n" + thing);
        const Image still =
            picture(lamp + "pushTransform\ntranslate .25 .125 -.25\n" + thing + "popTransform\n");
        // The numbers are not the same ones; where an edge runs through a pixel's centre that may show.
        int different = 0;
        for (std::size_t i = 0; i < still.pixels.size(); ++i)
            different += length(moving.pixels[i] - still.pixels[i]) > 1e-9;
        CHECK(different <= 2);
        CHECK_FALSE(same(still, picture(lamp + thing)));
    }
}

TEST_CASE("turning things have the same bits in a grid and without", "[blur]") {
    std::string turning = "diffuse .6 .5 .4\n";
    for (int i = 0; i < 40; ++i) {
        const std::string turns = std::to_string(i % 7 * 60 - 150);
        turning += "motion " + std::to_string(i % 3 * 0.2) + " 0 0\npushTransform\ntranslate " +
                   std::to_string(i % 8 * 0.4 - 1.4) + " " + std::to_string(i / 8 * 0.3) + " " +
                   std::to_string(i % 7 * -0.3) + "\nspin " + std::to_string(i % 4 - 1) + " 1 0.5 " + turns +
                   "\n";
        if (i % 5 == 0) turning += "translate .3 0 0\nspin 0 1 0 -400\n";
        turning += i % 2 == 0 ? "box -.05 -.1 -.02  .25 .1 .06\n" : "cone 0 0 0 .1  .2 .1 0 0\n";
        turning += "popTransform\n";
    }
    const std::string lamp = "spp 4\ndirectional 1 2 2  1 1 1\nquadLight -1 3 0  0 0 1  1 0 0  5 5 5\n";
    const Image none = picture("accelerator none\n" + lamp + turning);
    for (const char* grid : {"accelerator grid\n", "accelerator nested\n"})
        CHECK(same(none, picture(grid + lamp + turning)));
}

TEST_CASE("turning things of all kinds are where they would stand at that time", "[blur]") {
    // As above, but turned; half of the time is half of the turn.
    const std::string lamp = "spp 1\nsampler regular\ndirectional 1 2 2  1 1 1\ndiffuse .8 .7 .6\n";
    for (const char* thing : things_of_all_kinds) {
        INFO(thing);
        const auto scene = [&](const std::string& first, const std::string& second,
                               const std::string& inner) {
            return lamp + first + "translate .2 .1 -.2\n" + second + "translate .1 0 0\n" + inner + thing;
        };
        const Image turning = picture(scene("motion .2 0 -.2\n", "spin 0 1 2 70\n", "spin 1 0 0 -30\n"));
        const Image still = picture(scene("translate .1 0 -.1\n", "rotate 0 1 2 35\n", "rotate 1 0 0 -15\n"));
        int different = 0;
        for (std::size_t i = 0; i < still.pixels.size(); ++i)
            different += length(turning.pixels[i] - still.pixels[i]) > 1e-9;
        CHECK(different <= 2);
        CHECK_FALSE(same(still, picture(scene("", "", ""))));
    }
}

TEST_CASE("in a mirror a turn goes the other way, and a larger thing turns as a small one", "[blur]") {
    const std::string lamp = "spp 1\nsampler regular\ndirectional 1 2 2  1 1 1\ndiffuse .8 .7 .6\n";
    for (const char* scale : {"scale -1 1 1\n", "scale 2 2 2\n", "scale .5 -.5 -.5\n", "scale -2 -2 -2\n"}) {
        INFO(scale);
        const std::string box = "box -.2 0 -.1  .4 .7 .1\n";
        const Image turning = picture(lamp + scale + "spin 0 1 2 70\n" + box);
        const Image still = picture(lamp + scale + "rotate 0 1 2 35\n" + box);
        int different = 0;
        for (std::size_t i = 0; i < still.pixels.size(); ++i)
            different += length(turning.pixels[i] - still.pixels[i]) > 1e-9;
        CHECK(different <= 2);
    }
}

TEST_CASE("at time 0 a turning thing is the thing at rest to the bit", "[blur]") {
    const std::string where = "diffuse .7 .7 .7\ntranslate .1 .2 .3\n",
                      thing = "scale .3 .4 .5\nsphere 0 0 0 1\n";
    const World still = world_of(where + thing), turning = world_of(where + "spin 1 2 3 500\n" + thing);
    for (const Real x : {-0.1, 0.0, 0.2, 0.35}) {
        const Ray ray{{x, 0.25, 5}, {0, 0.01, -1}, 0};
        const auto hit = closest_hit(still, ray, {}), same_hit = closest_hit(turning, ray, {});
        REQUIRE(hit);
        REQUIRE(same_hit);
        CHECK(hit->t == same_hit->t);
        CHECK(surface_at(still, ray, *hit).point == surface_at(turning, ray, *same_hit).point);
        CHECK(surface_at(still, ray, *hit).normal == surface_at(turning, ray, *same_hit).normal);
    }
}

TEST_CASE("a turning thing throws no shadow on itself, however far it turns from", "[blur]") {
    // What stands at the origin turns about a line that is 1000 away, and so more is rounded than where it
    // stands.
    Spin spin;
    spin.center = Vec3(1000, 0, 0), spin.axis = unit(Vec3(0, 1, 0.25)), spin.angle = radians(4000);
    const std::string turn = "translate 1000 0 0\nspin 0 1 .25 4000\ntranslate -1000 0 0\n";
    test::Random random(1);
    for (const char* thing : {"sphere 0 0 0 1\n", "rotate 1 2 3 40\nbox -1 -.8 -.9  .9 .7 .6\n",
                              "scale .001 .001 .001\nbox -1000 -800 -900  900 700 600\n"}) {
        const World world = world_of(turn + thing);
        int hits = 0, shadows = 0;
        for (int i = 0; i < test::cases(4000); ++i) {
            const Real time = random.uniform(0, 1);
            const Vec3 aside = random.direction(), around = random.direction();
            // Where the thing's middle is: turned back the other way.
            const Vec3 middle =
                seen_while_turning({Vec3(0), aside, time}, {spin.center, spin.axis, -spin.angle}).origin;
            const Ray ray{middle + 5.0 * aside, -aside + 0.1 * around, time};
            const auto hit = closest_hit(world, ray, {});
            if (!hit) continue;
            ++hits;
            const Surface surface = surface_at(world, ray, *hit);
            // Steep, and nearly along the surface.
            const Real rise = random.magnitude(-3, 0);
            const Vec3 out = unit(random.perpendicular_to(surface.normal) + rise * surface.normal);
            shadows += occluded(world, {offset_origin(surface, out), out, time}, {});
        }
        INFO(thing << shadows << " of " << hits << " points are in their own shadow");
        CHECK(hits > test::cases(4000) / 2);
        CHECK(shadows == 0);
    }
}

TEST_CASE("what turns is said, and nothing else pays for it", "[blur]") {
    const auto kept = [](const std::string& text) {
        const Scene scene = parse_scene_text(view + text, "blur.scene");
        std::string all;
        for (const auto& one : explain(scene, compile(scene)).kept) all += one.what + "\n";
        return all;
    };
    CHECK_THAT(kept("spin 0 0 1 90\nsphere 1 0 0 1\n"), Catch::Contains("1 turning shape\n"));
    CHECK_THAT(kept("pushTransform\nspin 0 0 1 90\nsphere 1 0 0 1\npopTransform\nmotion 1 0 0\n"
                    "sphere 0 0 0 1\n"),
               Catch::Contains("1 moving shape\n"));
    CHECK_THAT(kept("pushTransform\nspin 0 0 1 90\npopTransform\nsphere 0 0 0 1\n"),
               Catch::Contains("1 sphere\n") && !Catch::Contains("a time for each ray"));
}

TEST_CASE("what cannot turn is refused with its place", "[blur]") {
    const auto refused = [](const std::string& text, const std::string& message) {
        INFO(text);
        CHECK_THROWS_WITH(world_of(text), Catch::Contains(message));
    };
    refused("spin 0 0 1 90\nplane 0 0 0  0 1 0\n", "blur.scene:4:1: this plane has no end");
    refused("scale 1 2 1\nspin 0 0 1 90\nsphere 0 0 0 1\n", "blur.scene:4:1: a turn under a scale");
    refused("union\nspin 0 0 1 90\nsphere 0 0 0 1\nspin 0 0 1 90\nsphere 1 0 0 1\nend\n",
            "blur.scene:7:1: the parts of one solid turn together");
    refused(
        "spin 0 0 1 90\nunion\nsphere 0 0 0 1\nunion\nsphere 0 0 0 1\nspin 1 0 0 5\nsphere 1 0 0 1\n"
        "end\nend\n",
        "blur.scene:9:1: the parts of one solid turn together");
    refused("spin 0 0 0 90\nsphere 0 0 0 1\n", "blur.scene:3:6: ");
    std::string many;
    for (int i = 0; i < 101; ++i) many += "spin 0 0 1 1\n";
    refused(many + "sphere 0 0 0 1\n", "more than 100 turns");
    // What turns as one may be a solid; a plane may be a part of it.
    CHECK_NOTHROW(world_of("spin 0 0 1 90\nintersection\nsphere 0 0 0 1\nplane 0 0 0  0 1 0\nend\n"));
    CHECK_NOTHROW(world_of("spin 0 0 1 90\nscale 1 2 3\nsphere 0 0 0 1\n"));
}

TEST_CASE("an endless plane does not move", "[blur]") {
    CHECK_THROWS_WITH(world_of("motion 1 0 0\nplane 0 0 0  0 1 0\n"),
                      Catch::Contains("blur.scene:4:1: this plane"));
}

TEST_CASE("lamps are there to be seen, on their bright side", "[blur]") {
    const std::string far = "diffuse 1 1 1\nsphere 99 99 99 1\n";
    // The camera looks along −z, from z = 6.
    const std::string towards = "quadLight -1 -1 0  0 2 0  2 0 0  3 2 1\n",
                      away = "quadLight -1 -1 0  2 0 0  0 2 0  3 2 1\n";
    CHECK(center(picture(towards + far)) == Vec3(3, 2, 1));
    CHECK(center(picture(away + far)) == Vec3(0));
    // Also where nothing reflects, or something moves.
    CHECK(center(picture(towards)) == Vec3(3, 2, 1));
    CHECK(center(picture(away)) == Vec3(0));
    CHECK(center(picture("spp 4\nmotion 1 0 0\n" + away + "sphere 9 9 9 .1\n")) == Vec3(0));
    // A checker's second colour is a material, too.
    CHECK(center(picture("integrator flat\nchecker 1 0 0  0 0 1  1\n" + far + towards)) == Vec3(3, 2, 1));
}

TEST_CASE("light from an area comes as often as it is asked for, and by either way", "[blur]") {
    const std::string lamp =
        "quadLight -.6 2 -.6  0 0 1.2  1.2 0 0  4 4 4\nsphereLight 1.5 1.5 0 .3  3 3 3\n"
        "discLight -1.5 1.5 0  1 -1 0  .4  3 3 3\n"
        "triangleLight 1 1.5 1  0 1.5 1  0 2 1.5  3 3 3\n";
    const std::string floor = "ambient 0 0 0\ndiffuse .8 .8 .8\nplane 0 0 0  0 1 0\nsphere 0 .4 0 .4\n";
    const Image truth = picture("spp 256\nsampler sobol\nseed 77\n" + lamp + floor);
    for (const char* how :
         {"spp 64\n", "spp 64\nlightsampling area\n", "spp 16\nlightsamples 4\n",
          "spp 16\nlightsamples 4\nlightstratify on\n", "spp 64\nlightchoice one\n",
          "spp 64\nsampler random\n", "spp 64\nsampler sobol\n", "spp 64\nsampler poisson\n"}) {
        INFO(how);
        const Image image = picture(how + lamp + floor);
        Vec3 mean(0), right(0);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            mean += image.pixels[i], right += truth.pixels[i];
        // Of 77,000 samples each, which differ by up to three times their mean.
        CHECK(length(mean - right) < 0.05 * length(right));
        CHECK(test::rms_difference(image, truth) < 0.06);
    }
}

TEST_CASE("one sample a pixel is at random in all but its place", "[blur]") {
    // The lamp and what gives the shadow are above the picture, so that it has no edges.
    const std::string lit =
        "quadLight -.6 4 -.6  0 0 1.2  1.2 0 0  9 9 9\nambient 0 0 0\ndiffuse .8 .8 .8\n"
        "plane 0 0 0  0 1 0\nbox -.4 3 -.4  .4 3.1 .4\n";
    const Image middle = picture("sampler regular\n" + lit), soft = picture("spp 1024\n" + lit);
    const Real one = test::rms_difference(picture(lit), soft),
               many = test::rms_difference(picture("lightsamples 64\n" + lit), soft);
    INFO("one shadow ray a pixel is wrong by " << one << ", 64 by " << many << ", the lamp's middle by "
                                               << test::rms_difference(middle, soft));
    CHECK(many < one / 2);
    CHECK(many < test::rms_difference(middle, soft) / 2);
    CHECK_FALSE(same(picture("lens .2 6\n" + lit), picture(lit)));
}

TEST_CASE("the stated error is honest whatever blurs", "[blur]") {
    const std::string blurred = "quadLight -.6 2.5 -.6  0 0 1.2  1.2 0 0  6 6 6\nmaxdepth 2\n" + things +
                                "motion .6 0 0\nspecular .3 .3 .3\ngloss 40\nsphere -.3 .5 1 .3\n";
    for (const char* camera : {"", "lens .1 6\n"}) {
        const std::string all = camera + blurred;
        const Image truth = picture("spp 1024\nsampler sobol\nseed 77\n" + all);
        for (const char* sampler : {"jittered", "random", "sobol", "poisson"}) {
            const RenderResult result =
                render(world_of("spp 16\nsampler " + std::string(sampler) + "\n" + all));
            REQUIRE(result.rms_error);
            const Real really = test::rms_difference(result.image, truth);
            INFO(camera << sampler << ": stated " << *result.rms_error << ", really " << really);
            CHECK(*result.rms_error > really / 1.5);
            CHECK(*result.rms_error < really * 1.5);
        }
    }
}

TEST_CASE("blurred pictures have the same bits on any number of threads", "[blur]") {
    for (const char* sampler : {"jittered", "random", "regular", "sobol", "poisson"}) {
        const World world = world_of("lens .1 6\nspp 4\nsampler " + std::string(sampler) +
                                     "\nquadLight -.6 2.5 -.6  0 0 1.2  1.2 0 0  6 6 6\nmotion .5 0 0\n"
                                     "diffuse .7 .7 .7\nspecular .3 .3 .3\ngloss 40\nsphere 0 .5 0 .5\n");
        RenderOptions one, many;
        one.threads = 1, many.threads = 5;
        CHECK(same(render(world, one).image, render(world, many).image));
    }
}

TEST_CASE("a bar that moves across a pixel covers it as long as it takes", "[blur]") {
    // In a parallel projection of 2 units, the middle pixel of 3 × 3 is from −⅓ to ⅓. A wall with its edge at
    // x = −1 moves by 2, past the pixel's middle at the time ½: each point is covered as long as the edge has
    // passed it, so the middle pixel's mean is ½, the left one's 5/6, the right one's 1/6. Places and times
    // are paired at random: what depends on both has the standard deviation √(1/4/4096) = 0.008 at most.
    const std::string text =
        "size 3 3\ncamera 0 0 5  0 0 0  0 1 0  40\northographic 2\nspp 4096\nambient 1 1 1\nmotion 2 0 0\n"
        "box -9 -9 -.1  -1 9 .1\n";
    const Image image = render(compile(parse_scene_text(text, "bar.scene"))).image;
    CHECK(pixel(image, 0, 1).x == Approx(5. / 6).margin(0.03));
    CHECK(pixel(image, 1, 1).x == Approx(0.5).margin(0.03));
    CHECK(pixel(image, 2, 1).x == Approx(1. / 6).margin(0.03));
}

TEST_CASE("a bar that turns is seen as long as it is there, at any distance from its end", "[blur]") {
    // A bar .2 wide turns about its end by a right angle. At the distance r from there and in the direction φ
    // it is there while its own direction is nearer to φ than asin(.1/r). The shutter says how much light
    // comes in meanwhile.
    const World world = world_of("rotate 0 1 0 180\nspin 0 0 -1 90\nbox -2 -.1 -.1  0 .1 .1\n");
    const int count = 2000;
    for (const Shutter& shutter : {Shutter{0, 0}, Shutter{0.25, 0.5}, Shutter{0, 1}})
        for (const Real r : {0.2, 0.5, 1.0, 1.9})
            for (const Real degrees : {0.0, 10.0, 45.0, 71.0, 90.0}) {
                const Real phi = radians(degrees), half = std::asin(0.1 / r);
                int seen = 0;
                for (int i = 0; i < count; ++i) {
                    const Real time = shutter_time(shutter, (i + 0.5) / count);
                    seen +=
                        occluded(world, {{r * std::cos(phi), r * std::sin(phi), 5}, {0, 0, -1}, time}, {});
                }
                const auto light_until = [&](Real t) {
                    t = std::clamp(t, Real(0), Real(1));
                    const Real rise = shutter.opening, fall = shutter.closing;
                    Real light = std::clamp(t, rise, 1 - fall) - rise;
                    if (rise > 0) light += std::min(t, rise) * std::min(t, rise) / (2 * rise);
                    const Real late = std::max(t - (1 - fall), Real(0));
                    if (late > 0) light += late - late * late / (2 * fall);
                    return light / (1 - rise / 2 - fall / 2);
                };
                const Real expected =
                    light_until((phi + half) / (pi / 2)) - light_until((phi - half) / (pi / 2));
                INFO("shutter " << shutter.opening << " " << shutter.closing << ", at the distance " << r
                                << ", at " << degrees << " degrees");
                // Of evenly spread numbers at most one at either end is on the wrong side.
                CHECK(std::abs(static_cast<Real>(seen) / count - expected) <= 1.0 / count);
            }
}

TEST_CASE("where a rolling wheel touches the floor it stands still", "[blur]") {
    // A ball at the rim's lowest point, and one at its highest, which goes twice as far as the hub: how many
    // pixels are neither covered all the time nor never.
    const auto blur = [](const char* mark) {
        const Image image = picture(
            "spp 64\northographic 4\nambient 1 1 1\nmotion .3 0 0\ntranslate 0 1 0\n"
            "spin 0 0 1 -17.188733853924695\nsphere 0 " +
            std::string(mark) + " 0 .2\n");
        return std::ranges::count_if(image.pixels, [](const Vec3& p) { return p.x > 0.01 && p.x < 0.99; });
    };
    CHECK(blur("1") > 2 * blur("-1"));
}
