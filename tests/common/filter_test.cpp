// Chapter 11's picture to the horizon, for which POV-Ray has nothing: textures averaged over what a pixel
// sees, in the mirror, too, against very many samples of single texels.
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;

namespace {

RenderResult horizon(TextureFilter filter, int samples, std::uint64_t seed) {
    Scene scene = parse_scene(test::repository() + "/references/11_textures/horizon.scene");
    scene.width = 80, scene.height = 60;
    for (Texturing& texturing : scene.texturings)
        if (texturing.picture) texturing.picture->filter = filter;
    scene.sampling.count = samples;
    scene.sampling.seed = seed;
    return render(compile(scene));
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
        // The error of long footprints is what the picture says itself: they add little to that of the edges.
        Real squares = 0;
        for (std::size_t i = 0; i < seen.image.pixels.size(); ++i) {
            const Vec3 d = seen.image.pixels[i] - truth.image.pixels[i];
            squares += dot(d, d);
        }
        const Real error = std::sqrt(squares / (3 * static_cast<Real>(seen.image.pixels.size())));
        REQUIRE(seen.rms_error);
        INFO("error " << error << ", by its own estimate " << *seen.rms_error);
        CHECK(*seen.rms_error < 1.5 * error);
        // Squares blur; samples of what is blurred do not tell. How much is said in the lesson, and in
        // README.md.
        if (filter == TextureFilter::Trilinear)
            CHECK(test::near(error / *seen.rms_error, 1.6, 0.15));
        else
            CHECK(error < 1.5 * *seen.rms_error);
    }
    // That is not always so: one sample a pixel does not.
    const Difference single = by_blocks(horizon(TextureFilter::Bilinear, 1, 0).image, truth.image);
    CHECK(single.rms > 3 * 7e-4);
    CHECK(single.greatest > 3 * 3e-3);
}
