// Rough mirrors and rough glass in pictures: what `brdf ggx` sends on is what chapter 11's lobes say, summed
// over all directions here.
#include "chapters/11_textures/microfacet.hpp"
#include "chapters/11_textures/rough_glass.hpp"
#include "common/math/axes.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

using namespace rt;

namespace {

World world_of(const std::string& text) { return compile(parse_scene_text(text, "rough.scene")); }

/// A sky that is another from each side, and nothing in it gives light.
const std::string sky = "skyGradient 1 .2 .1   .3 .9 .2   .2 .1 1\nambient 0 0 0\nmaxdepth 1\n";

/// Parallel rays, all to one point of the plane y = 0, from so many degrees beside straight above; from below
/// where they are more than 90.
std::string seen_from(Real degrees) {
    const Real t = degrees * pi / 180;
    return fmt::format("size 16 16\northographic 1e-6\ncamera {} {} 0  0 0 0  0 0 1  45\n", 5 * std::sin(t),
                       5 * std::cos(t));
}

/// The sum over all directions of the lobe, its cosine and the sky. In the lobe's frame z is the world's y.
template <class Lobe>
Vec3 under_the_sky(const World& world, const Lobe& lobe, Real degrees, int n) {
    const Real t = degrees * pi / 180;
    const Vec3 v(std::sin(t), 0, std::cos(t));
    Vec3 sum(0);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            // The middles of cells of equal steps of both angles.
            const Real theta = pi * (i + 0.5) / n, phi = pi * (k + 0.5) / n;  // half of it, the rest is alike
            const Real sine = std::sin(theta), x = sine * std::cos(phi), y = sine * std::sin(phi);
            const Vec3 l(x, y, std::cos(theta));
            sum += evaluate(lobe, l, v) * (std::abs(l.z) * sine) * background(world, {x, l.z, y});
        }
    return sum * (2 * pi * pi / (Real(n) * n));
}

/// The greatest difference between the picture's mean and the sum, as far as that is right, in standard
/// errors of the mean. Every pixel is of independent samples.
Real errors_off(const World& world, const Vec3& truth, const Vec3& sums_error) {
    RenderOptions options;
    options.estimate = false;
    const Image image = render(world, options).image;
    const Real n = static_cast<Real>(image.pixels.size());
    Vec3 mean(0), squares(0);
    for (const Vec3& pixel : image.pixels) mean += pixel / n;
    for (const Vec3& pixel : image.pixels) squares += (pixel - mean) * (pixel - mean) / (n * (n - 1));
    INFO("its mean is " << mean.x << ", " << mean.y << ", " << mean.z << ", and the sum " << truth.x << ", "
                        << truth.y << ", " << truth.z);
    return max_component(glm::max(glm::abs(mean - truth) - sums_error, Vec3(0)) / glm::sqrt(squares));
}

/// Student's t of 255 degrees of freedom is beyond 6.5 once in 2e9, and of the 36 numbers below one is so
/// once in 6e7.
constexpr Real most_errors = 6.5;

template <class Lobe>
void compare(const std::string& text, const Lobe& lobe, Real degrees) {
    INFO(text << "seen from " << degrees << " degrees");
    const World world =
        world_of("spp 128\nsampler random\n" + seen_from(degrees) + sky + text + "plane 0 0 0  0 1 0\n");
    REQUIRE(world.needs.rough);
    const Vec3 truth = under_the_sky(world, lobe, degrees, 600);
    // The rule's error falls with the number of its steps, by Fresnel's corners, or faster: so half as many
    // steps differ by as much as it is still wrong, or more.
    const Vec3 sums_error = glm::abs(under_the_sky(world, lobe, degrees, 300) - truth);
    CHECK(length(sums_error) < 3e-4 * length(truth));
    CHECK(errors_off(world, truth, sums_error) < most_errors);
}

}  // namespace

TEST_CASE("a rough mirror shows the sum of its lobe over what is around", "[rough]") {
    // Fresnel's part of a mirror is its `specular`: the lobe of white metal, in that colour.
    for (const Real alpha : {0.2, 0.5, 1.0})
        for (const Real degrees : {20.0, 70.0})
            compare(fmt::format("brdf ggx\nroughness {}\nspecular 1 1 1\n", alpha),
                    RoughMetal{Vec3(1), std::sqrt(alpha)}, degrees);
}

TEST_CASE("rough glass mirrors and refracts as its lobe says, from outside and from inside", "[rough]") {
    for (const Real alpha : {0.2, 0.5})
        for (const Real degrees : {20.0, 70.0, 150.0})
            compare(
                fmt::format("brdf ggx\nroughness {}\ntransmission 1 1 1\nior 1.5\nfresnel exact\n", alpha),
                RoughGlass{Vec3(1), std::sqrt(alpha), 1.5}, degrees);
}

TEST_CASE("under an even sky no rough surface sends out more than it gets, and smooth ones all", "[rough]") {
    const auto mean = [](const std::string& text) {
        const Image image = render(world_of("spp 16\n" + seen_from(60) + "background 1 1 1\nambient 0 0 0\n" +
                                            text + "plane 0 0 0  0 1 0\n"))
                                .image;
        Real sum = 0;
        for (const Vec3& pixel : image.pixels) sum += pixel.x / static_cast<Real>(image.pixels.size());
        return sum;
    };
    Real before = 1;
    for (const Real alpha : {0.01, 0.2, 0.5, 1.0}) {
        const Real mirror = mean(fmt::format("brdf ggx\nroughness {}\nspecular 1 1 1\n", alpha));
        const Real glass =
            mean(fmt::format("brdf ggx\nroughness {}\ntransmission 1 1 1\nior 1.5\nfresnel exact\n", alpha));
        INFO("alpha " << alpha << ": mirror " << mirror << ", glass " << glass);
        CHECK(mirror < before);
        CHECK(mirror > 0.4);
        CHECK(glass < 1);
        CHECK(glass > mirror);
        before = mirror;
    }
    CHECK(mean("brdf ggx\nroughness .01\nspecular 1 1 1\n") > 0.999);
}

TEST_CASE("roughness 0 is a mirror to the bit, and little roughness is nearly one", "[rough]") {
    const std::string things =
        "size 24 18\ncamera 0 2 5  0 .4 0  0 1 0  40\nspp 4\nsampler regular\ndirectional 1 2 1  .7 .7 .7\n"
        "diffuse .6 .3 .2\nsphere -.8 .6 0 .6\nspecular .5 .5 .5\n";
    const std::string mirrors =
        "plane 0 0 0  0 1 0\ndiffuse 0 0 0\ntransmission .9 .9 .9\nior 1.4\nfresnel exact\nsphere .8 .6 .4 "
        ".6\n";
    const auto picture = [&](const std::string& brdf) { return render(world_of(things + brdf + mirrors)); };
    const RenderResult smooth = picture("");
    CHECK(picture("brdf ggx\nroughness 0\n").image.pixels == smooth.image.pixels);
    CHECK(picture("brdf ggx\nroughness 0\n").rays.random_numbers == smooth.rays.random_numbers);
    // `roughness` alone says nothing.
    CHECK(picture("roughness .5\n").image.pixels == smooth.image.pixels);
    const auto off = [&](const std::string& brdf) {
        const Image rough = picture(brdf).image;
        Real most = 0;
        for (std::size_t i = 0; i < rough.pixels.size(); ++i)
            most += length(rough.pixels[i] - smooth.image.pixels[i]) / static_cast<Real>(rough.pixels.size());
        return most;
    };
    const Real hardly = off("brdf ggx\nroughness 1e-5\n"), clearly = off("brdf ggx\nroughness .3\n");
    INFO(hardly << " and " << clearly);
    CHECK(hardly < 0.01);
    CHECK(clearly > 5 * hardly);
}

TEST_CASE("a surface of 'brdf ggx' knows no 'gloss', others in the scene do", "[rough]") {
    const std::string head =
        "size 16 12\ncamera 0 2 5  0 .4 0  0 1 0  40\nspp 4\nmaxdepth 2\nspecular .5 .5 .5\n";
    const std::string ball = "brdf ggx\nroughness .3\nsphere -.8 .6 0 .6\n";
    const auto picture = [&](const std::string& text) { return render(world_of(head + text)).image.pixels; };
    CHECK(picture(ball) == picture("gloss 30\n" + ball));
    const std::string floor = "plane 0 0 0  0 1 0\n";
    CHECK(picture(floor + ball) != picture("gloss 30\n" + floor + ball));
}

TEST_CASE("who has no rough mirror does not ask for facets", "[rough]") {
    const std::string head = "size 16 12\ncamera 0 2 5  0 .4 0  0 1 0  40\nbrdf ggx\nroughness .3\n";
    for (const char* text :
         {"diffuse .5 .5 .5\nsphere 0 0 0 1\n", "maxdepth 0\nspecular .5 .5 .5\nsphere 0 0 0 1\n",
          "integrator flat\nspecular .5 .5 .5\nsphere 0 0 0 1\n",
          "integrator direct\nspecular .5 .5 .5\nsphere 0 0 0 1\n",
          "diffuse .5 .5 .5\nsphere 0 0 0 1\nbrdf phong\nspecular .5 .5 .5\nsphere 2 0 0 1\n"}) {
        INFO(text);
        CHECK_FALSE(world_of(head + text).needs.rough);
    }
    CHECK(world_of(head + "specular .5 .5 .5\nsphere 0 0 0 1\n").needs.rough);
}

TEST_CASE("rough pictures have the same bits on any number of threads, and state their error", "[rough]") {
    const World world = world_of(
        "size 24 18\ncamera 0 2 5  0 .4 0  0 1 0  40\nspp 16\nbackground .2 .3 .4\ndirectional 1 2 1  .7 .7 "
        ".7\n"
        "diffuse .6 .3 .2\nsphere -.8 .6 0 .6\nbrdf ggx\nroughness .2\nspecular .8 .8 .8\nplane 0 0 0  0 1 "
        "0\n");
    RenderOptions one, three;
    one.threads = 1, three.threads = 3;
    const RenderResult result = render(world, one);
    CHECK(result.image.pixels == render(world, three).image.pixels);
    REQUIRE(result.rms_error);
    CHECK(*result.rms_error > 0);
}
