// A textured floor to the horizon by each way of looking a texture up: how wrong the picture is, and how long
// it takes.
#include "tests/report/filters.hpp"

#include "common/scene/parse.hpp"
#include "tests/pictures.hpp"
#include "tests/report/picture_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rt::report {
namespace {

constexpr std::pair<const char*, TextureFilter> filters[] = {{"nearest", TextureFilter::Nearest},
                                                             {"bilinear", TextureFilter::Bilinear},
                                                             {"trilinear", TextureFilter::Trilinear},
                                                             {"anisotropic", TextureFilter::Anisotropic}};

/// The floor without what stands on it, whose outline would hide the difference.
Scene floor_by(TextureFilter filter, const std::string& repository, int height) {
    Scene scene = parse_scene(repository + "/references/11_textures/horizon.scene");
    const Real shape = static_cast<Real>(scene.width) / scene.height;
    scene.height = height;
    scene.width = static_cast<int>(std::lround(shape * height));
    std::erase_if(scene.objects,
                  [](const Object& object) { return std::holds_alternative<Sphere>(object.shape); });
    for (Texturing& texturing : scene.texturings)
        if (texturing.picture) texturing.picture->filter = filter;
    return scene;
}

PicturePoint measure_point(Scene& scene, int count, const Image& truth, int repeats) {
    PicturePoint point;
    point.asked = count;
    std::vector<double> seconds, errors;
    for (int i = 0; i < repeats; ++i) {
        const Sampling sampling{count, Sampler::Jittered, false, {}, static_cast<std::uint64_t>(i)};
        const RenderResult timed = render_with(scene, sampling, drawn_only(1));
        seconds.push_back(timed.cpu_seconds);
        errors.push_back(test::rms_difference(timed.image, truth));
        point.samples = timed.samples_per_pixel;
    }
    point.seconds = median(seconds);
    point.error = root_mean_square(errors);
    return point;
}

/// What stops a curve: told from where its last points lie and how steep they are.
std::string what_stopped(const PictureCurve& curve, const Truth& truth) {
    if (curve.points.size() < 2) return "";
    const PicturePoint &last = curve.points.back(), &before = curve.points[curve.points.size() - 2];
    if (last.error < 3 * truth.error) return "the truth's own error";
    const double slope = std::log(last.error / before.error) / std::log(last.samples / before.samples);
    return slope > -0.25 ? "what the filter itself blurs" : "nothing yet: the samples ended";
}

}  // namespace

FilterOptions quick_filters() { return {40, {1, 4, 16, 36}, 2, 1024, 4}; }

std::vector<PictureScene> measure_filters(const std::string& repository, const FilterOptions& options,
                                          const Told& told) {
    const auto tell = [&](double done) {
        if (told) told(done);
    };
    Scene exact = floor_by(TextureFilter::Nearest, repository, options.height);
    const double truth_part = 0.5;
    const Truth truth = converged(exact, options.truth_count, options.truth_renders,
                                  [&](double done) { tell(truth_part * done); });
    PictureScene result{"horizon",   "Bricks to the horizon", "11",     exact.width, exact.height, false,
                        truth.error, truth.samples,           infinity, {}};
    const double all =
        std::accumulate(options.counts.begin(), options.counts.end(), 0.0) * std::size(filters);
    double done = 0;
    for (const auto& [name, filter] : filters) {
        Scene scene = floor_by(filter, repository, options.height);
        measure_point(scene, 1, truth.image, 1);  // the first render of all is slower
        PictureCurve curve{name, {}, {}, {}, 0, ""};
        std::vector<double> samples, seconds, errors;
        for (const int count : options.counts) {
            const PicturePoint point = measure_point(scene, count, truth.image, options.repeats);
            samples.push_back(point.samples);
            seconds.push_back(point.seconds);
            errors.push_back(point.error);
            result.best = std::min(result.best, point.error);
            curve.points.push_back(point);
            done += count;
            tell(truth_part + (1 - truth_part) * done / all);
        }
        curve.by_samples = fit_power_law(samples, errors);
        curve.by_seconds = fit_power_law(seconds, errors);
        curve.stopped = what_stopped(curve, truth);
        result.curves.push_back(std::move(curve));
    }
    return {result};
}

}  // namespace rt::report
