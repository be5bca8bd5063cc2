// How wrong a picture is: what it should be, and the distance from that.
#include "tests/report/picture_errors.hpp"

#include "common/render/compile.hpp"

#include <cmath>

namespace rt::report {
namespace {

// Seeds of the truth are far from those of the pictures.
constexpr std::uint64_t truth_seed = 1'000'000;

}  // namespace

RenderOptions drawn_only(int threads) {
    RenderOptions options;
    options.threads = threads;
    options.estimate = false;
    return options;
}

RenderResult render_with(Scene& scene, const Sampling& sampling, const RenderOptions& options) {
    scene.sampling = sampling;
    return render(compile(scene), options);
}

Truth converged(Scene& scene, int count, int renders, const Told& told) {
    std::vector<Image> images;
    for (int i = 0; i < renders; ++i) {
        const Sampling sampling{
            count, Sampler::Jittered, false, {}, truth_seed + static_cast<std::uint64_t>(i)};
        images.push_back(render_with(scene, sampling, drawn_only(0)).image);
        told((i + 1.0) / renders);
    }
    const auto n = static_cast<Real>(images.size());
    Truth truth{make_image(scene.width, scene.height), false, 0, static_cast<double>(count) * renders};
    Real squares = 0;
    for (std::size_t i = 0; i < truth.image.pixels.size(); ++i) {
        Vec3& mean = truth.image.pixels[i];
        for (const Image& image : images) mean += image.pixels[i] / n;
        for (const Image& image : images) {
            const Vec3 off = image.pixels[i] - mean;
            squares += dot(off, off) / (n * (n - 1));
        }
    }
    truth.error = std::sqrt(squares / (3 * static_cast<Real>(truth.image.pixels.size())));
    return truth;
}

}  // namespace rt::report
