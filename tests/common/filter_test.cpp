// Chapter 11's picture to the horizon, for which POV-Ray has nothing: textures averaged over what a pixel
// sees, in the mirror, too, against very many samples of single texels.
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/pictures.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;

namespace {

Scene horizon_scene(TextureFilter filter, int samples, std::uint64_t seed) {
    Scene scene = parse_scene(test::repository() + "/references/11_textures/horizon.scene");
    scene.width = 80, scene.height = 60;
    for (Texturing& texturing : scene.texturings)
        if (texturing.picture) texturing.picture->filter = filter;
    scene.sampling.count = samples;
    scene.sampling.seed = seed;
    return scene;
}

RenderResult horizon(TextureFilter filter, int samples, std::uint64_t seed) {
    return render(compile(horizon_scene(filter, samples, seed)));
}

/// How the means of blocks of 10 × 10 pixels differ, all channels together.
struct Difference {
    Real mean = 0, rms = 0, greatest = 0;
};

Difference by_blocks(const Image& image, const Image& truth) {
    constexpr int side = 10;
    Difference all;
    const int blocks = image.width / side * (image.height / side);
    for (int y = 0; y < image.height; y += side)
        for (int x = 0; x < image.width; x += side) {
            Vec3 sum(0);
            for (int i = 0; i < side * side; ++i)
                sum += pixel(image, x + i % side, y + i / side) - pixel(truth, x + i % side, y + i / side);
            const Vec3 off = sum / Real(side * side);
            all.mean += (off.x + off.y + off.z) / (3 * blocks);
            all.rms += dot(off, off) / (3 * blocks);
            all.greatest = std::max(all.greatest, max_component(glm::abs(off)));
        }
    all.rms = std::sqrt(all.rms);
    return all;
}

}  // namespace

TEST_CASE("bricks to the horizon, and in a mirror, are what very many samples of texels say") {
    const RenderResult truth = horizon(TextureFilter::Nearest, 512, 1'000'000);
    for (const TextureFilter filter : {TextureFilter::Trilinear, TextureFilter::Anisotropic}) {
        const RenderResult seen = horizon(filter, 16, 0);
        const Difference off = by_blocks(seen.image, truth.image);
        INFO((filter == TextureFilter::Trilinear ? "trilinear" : "anisotropic")
             << ": mean " << off.mean << ", blocks " << off.rms << ", at most " << off.greatest);
        CHECK(std::abs(off.mean) < 1e-4);
        CHECK(off.rms < 7e-4);
        CHECK(off.greatest < 3e-3);
        // And the picture says how wrong it is: by what its samples do not agree on, and what the filter
        // blurs.
        const Real error = test::rms_difference(seen.image, truth.image);
        REQUIRE(seen.rms_error);
        INFO("error " << error << ", by its own estimate " << *seen.rms_error);
        CHECK(*seen.rms_error < 1.2 * error);
        CHECK(error < 1.2 * *seen.rms_error);
    }
    // That is not always so: one sample a pixel does not.
    const Difference single = by_blocks(horizon(TextureFilter::Bilinear, 1, 0).image, truth.image);
    CHECK(single.rms > 3 * 7e-4);
    CHECK(single.greatest > 3 * 3e-3);
}

TEST_CASE("pictures state what averaging textures blurs, however they are made") {
    const RenderResult truth = horizon(TextureFilter::Bilinear, 256, 1'000'000);
    const auto judge = [&](const Scene& scene, const RenderOptions& options) {
        const RenderResult seen = render(compile(scene), options);
        const Real error = test::rms_difference(seen.image, truth.image);
        REQUIRE(seen.rms_error);
        INFO("error " << error << ", by its own estimate " << *seen.rms_error << ", of "
                      << seen.samples_per_pixel << " samples a pixel");
        CHECK(*seen.rms_error < 1.5 * error);
        CHECK(error < 1.5 * *seen.rms_error);
        return error;
    };
    for (const Sampler sampler : {Sampler::Jittered, Sampler::Sobol, Sampler::Poisson}) {
        INFO("sampler " << static_cast<int>(sampler));
        Scene scene = horizon_scene(TextureFilter::Trilinear, 9, 5);
        scene.sampling.sampler = sampler;
        judge(scene, {});
    }
    // Passes until the error is small enough: footprints stay those of the scene's samples, of which the blur
    // is more than that. The picture ends nevertheless, and says so.
    RenderOptions options;
    options.error = 0.004;
    CHECK(judge(horizon_scene(TextureFilter::Trilinear, 4, 5), options) > 0.004);
    options.error = 0.02;
    CHECK(judge(horizon_scene(TextureFilter::Trilinear, 4, 5), options) < 0.03);
}

TEST_CASE("what averaging blurs is stated with a filter wider than a pixel, too") {
    const auto with_tent = [](TextureFilter filter, int samples, std::uint64_t seed) {
        Scene scene = horizon_scene(filter, samples, seed);
        scene.sampling.filter = {FilterKind::Tent, 1};
        return scene;
    };
    RenderOptions options;
    options.estimate = false;
    const Image truth = render(compile(with_tent(TextureFilter::Bilinear, 256, 1'000'000)), options).image;
    for (const bool passes : {false, true}) {
        INFO((passes ? "until the error is small" : "of a given number of samples"));
        RenderOptions how;
        if (passes) how.error = 0.002;
        const RenderResult seen = render(compile(with_tent(TextureFilter::Trilinear, 4, 5)), how);
        const Real error = test::rms_difference(seen.image, truth);
        REQUIRE(seen.rms_error);
        INFO("error " << error << ", by its own estimate " << *seen.rms_error);
        CHECK(*seen.rms_error < 1.5 * error);
        CHECK(error < 1.5 * *seen.rms_error);
    }
}

TEST_CASE("where nothing is averaged there is no more to ask, and the same number of rays") {
    const auto counts = [](TextureFilter filter) { return horizon(filter, 4, 0).rays; };
    const RayCounts plain = counts(TextureFilter::Bilinear), averaged = counts(TextureFilter::Trilinear);
    // The 4 samples of about 4096 of the 4800 pixels are asked again without averages, and so are their
    // probes.
    CHECK(averaged.camera > plain.camera);
    Scene scene = horizon_scene(TextureFilter::Trilinear, 4, 0);
    for (Texturing& texturing : scene.texturings)
        if (texturing.picture) texturing.picture->filter = TextureFilter::Nearest;
    CHECK(render(compile(scene)).rays.camera == plain.camera);
}
