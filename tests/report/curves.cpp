// A curve of error against samples and seconds: pictures of one scene by one way of sampling.
#include "tests/report/curves.hpp"

#include "tests/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt::report {
namespace {

/// What stops a curve: told from where its last points lie and how steep they are.
std::string what_stopped(const PictureCurve& curve, const Truth& truth) {
    if (curve.points.size() < 2) return "";
    const PicturePoint& last = curve.points.back();
    if (truth.error > 0 && last.error < 3 * truth.error)
        return truth.analytic ? "rounding" : "the truth's own error";
    const PicturePoint& before = curve.points[curve.points.size() - 2];
    const double slope = std::log(last.error / before.error) / std::log(last.samples / before.samples);
    if (slope > curve.by_samples.slope / 2) return "its pattern, which falls on each edge in its own way";
    return "nothing yet: the samples ended";
}

double rays_of(const RenderResult& result) {
    const RayCounts& rays = result.rays;
    return static_cast<double>(rays.camera + rays.shadow + rays.reflection + rays.refraction) /
           static_cast<double>(result.image.pixels.size());
}

}  // namespace

PicturePoint measure_point(Scene& scene, const Way& way, int count, const Image& truth, int repeats,
                           bool estimated) {
    PicturePoint point{count, 1, 0, 0, 0, infinity, 0, 0};
    std::vector<double> seconds, errors, estimates;
    for (int i = 0; i < repeats; ++i) {
        const Sampling sampling{count, way.sampler, way.adaptive, {}, static_cast<std::uint64_t>(i)};
        const RenderResult timed = render_with(scene, sampling, drawn_only(1));
        seconds.push_back(timed.cpu_seconds);
        errors.push_back(test::rms_difference(timed.image, truth));
        point.samples = timed.samples_per_pixel;
        point.rays += rays_of(timed) / repeats;
        if (count == 1 || !estimated) continue;
        const Real estimate = render_with(scene, sampling, {}).rms_error.value_or(0);
        estimates.push_back(estimate);
        point.ratio_low = std::min(point.ratio_low, errors.back() / estimate);
        point.ratio_high = std::max(point.ratio_high, errors.back() / estimate);
    }
    if (estimates.empty()) point.ratio_low = 0;
    point.seconds = median(seconds);
    point.error = root_mean_square(errors);
    point.estimate = root_mean_square(estimates);
    return point;
}

PictureCurve curve_of(const Way& way, std::vector<PicturePoint> points, const Truth& truth) {
    PictureCurve curve{way.name, std::move(points), {}, {}, way.theory, ""};
    std::vector<double> samples, seconds, errors;
    for (const PicturePoint& point : curve.points) {
        samples.push_back(point.samples);
        seconds.push_back(point.seconds);
        errors.push_back(point.error);
    }
    curve.by_samples = fit_power_law(samples, errors);
    curve.by_seconds = fit_power_law(seconds, errors);
    curve.stopped = what_stopped(curve, truth);
    return curve;
}

}  // namespace rt::report
