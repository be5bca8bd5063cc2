// Pictures of several scenes by several ways of sampling: how wrong they are, and how long they take.
#include "tests/report/pictures.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "common/render/compile.hpp"
#include "common/render/integrators.hpp"
#include "common/scene/parse.hpp"
#include "tests/report/curves.hpp"
#include "tests/stability/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace rt::report {
namespace {

// --------------------------------------------------------------------------------------------- scenes

struct Subject {
    std::string name, title, chapter;
    std::string file;                        ///< below references/, or empty
    std::string text;                        ///< the scene itself, where there is no file
    Image (*truth)(const World&) = nullptr;  ///< the formula, where there is one
    bool smooth = false;                     ///< without edges
};

/// The sphere of the first scene, as the picture shows it; lengths in units of the picture's height.
constexpr test::Disk disk{{0.0372, -0.0241}, 0.3719};

Image disk_truth(const World& world) {
    const View& view = world.view;
    const Real step = 1.0 / view.height;  // the picture is 1 high
    Image image = make_image(view.width, view.height);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Vec2 low((x - view.width / 2.0) * step, 0.5 - (y + 1) * step);
            const Real part = test::mean(disk, low, low + step);
            pixel(image, x, y) = part * Vec3(0.9, 0.6, 0.3) + (1 - part) * Vec3(0.05, 0.1, 0.2);
        }
    return image;
}

/// The 8-point rule of Gauss and Legendre, for the interval [0, 1].
constexpr std::array<std::pair<Real, Real>, 4> gauss{{{0.1834346424956498, 0.3626837833783620},
                                                      {0.5255324099163290, 0.3137066458778873},
                                                      {0.7966664774136267, 0.2223810344533745},
                                                      {0.9602898564975363, 0.1012285362903763}}};

/// Mean of the colour over each pixel: 8 × 8 points integrate what is smooth to rounding.
Image smooth_truth(const World& world) {
    const RayColor color = color_function(world);
    Image image = make_image(world.view.width, world.view.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const auto& [a, weight_a] : gauss)
                for (const auto& [b, weight_b] : gauss)
                    for (const int sign : {0, 1, 2, 3}) {
                        const Real at_x = x + 0.5 + (sign % 2 == 0 ? a : -a) / 2;
                        const Real at_y = y + 0.5 + (sign / 2 == 0 ? b : -b) / 2;
                        Stream stream = stream_of(world, x, y);
                        const Ray ray = pixel_ray(world.view, at_x, at_y);
                        pixel(image, x, y) += weight_a * weight_b / 4 * color(world, ray, stream);
                    }
    return image;
}

std::vector<Subject> subjects(bool chapters) {
    std::vector<Subject> all{
        {"disk", "A disk on an empty ground", "08", "",
         "version 1\nintegrator flat\northographic 1\ncamera 0 0 5 0 0 0 0 1 0 45\nbackground .05 .1 .2\n"
         "ambient 0 0 0\nemission .9 .6 .3\nsphere 0.0372 -0.0241 0 0.3719\n",
         disk_truth, false},
        {"sky", "Ray directions, smooth everywhere", "08", "",
         "version 1\nintegrator directions\ncamera 0 0 0 .3 .2 -1 0 1 0 100\n", smooth_truth, true},
    };
    if (chapters) {
        all.push_back({"highlights", "Highlights on spheres", "05", "05_lighting/highlights.scene", "",
                       nullptr, false});
        all.push_back(
            {"shadows", "Two lamps and their shadows", "06", "06_shadows/shadows.scene", "", nullptr, false});
        all.push_back({"whitted", "Glass and mirror over a checkerboard", "07", "07_recursion/whitted.scene",
                       "", nullptr, false});
    }
    return all;
}

Scene read(const Subject& subject, const std::string& repository, int height) {
    Scene scene = subject.file.empty() ? parse_scene_text(subject.text, subject.name)
                                       : parse_scene(repository + "/references/" + subject.file);
    const Real shape = static_cast<Real>(scene.width) / scene.height;
    scene.height = height;
    scene.width = static_cast<int>(std::lround(shape * height));
    return scene;
}

// -------------------------------------------------------------------------------------------- methods

struct Method {
    const char* name;
    Sampler sampler;
    bool adaptive;
    double on_edges, on_smooth;  ///< the exponents of theory; 0 where none is printed
};

constexpr Method methods[] = {
    {"random", Sampler::Random, false, -0.5, -0.5},    {"regular", Sampler::Regular, false, 0, -1},
    {"jittered", Sampler::Jittered, false, -0.75, -1}, {"Poisson disk", Sampler::Poisson, false, 0, 0},
    {"adaptive", Sampler::Jittered, true, 0, 0},
};

PictureScene measure(const Subject& subject, const std::string& repository, const PictureOptions& options,
                     const Told& told) {
    Scene scene = read(subject, repository, options.height);
    PictureScene result{
        subject.name, subject.title, subject.chapter, scene.width, scene.height, false, 0, 0, infinity, {}};
    const World world = compile(scene);
    const double truth_part = subject.truth ? 0 : 0.5;
    const Truth truth = subject.truth ? Truth{subject.truth(world), true, 0x1p-50, 0}
                                      : converged(scene, options.truth_count, options.truth_renders,
                                                  [&](double done) { told(truth_part * done); });
    result.analytic = truth.analytic;
    result.truth_error = truth.error;
    result.truth_samples = truth.samples;

    const Way one{"one sample", Sampler::Regular};
    measure_point(scene, one, 1, truth.image, 1);  // the first render of all is slower
    PictureCurve alone{one.name, {measure_point(scene, one, 1, truth.image, 5)}, {}, {}, 0, ""};
    result.curves.push_back(alone);

    const double all =
        std::accumulate(options.counts.begin(), options.counts.end(), 0.0) * std::size(methods);
    double done = 0;
    for (const Method& method : methods) {
        const Way way{method.name, method.sampler, method.adaptive,
                      subject.smooth ? method.on_smooth : method.on_edges};
        std::vector<PicturePoint> points;
        for (const int count : options.counts) {
            points.push_back(measure_point(scene, way, count, truth.image, options.repeats));
            result.best = std::min(result.best, points.back().error);
            done += count;
            told(truth_part + (1 - truth_part) * done / all);
        }
        result.curves.push_back(curve_of(way, std::move(points), truth));
    }
    return result;
}

}  // namespace

PictureOptions quick_pictures() { return {24, {4, 9, 16, 36, 64}, 3, 1600, 4, true}; }

std::vector<PictureScene> measure_pictures(const std::string& repository, const PictureOptions& options,
                                           const Told& told) {
    const std::vector<Subject> all = subjects(options.chapters);
    std::vector<PictureScene> scenes;
    for (std::size_t i = 0; i < all.size(); ++i)
        scenes.push_back(measure(all[i], repository, options, [&](double done) {
            if (told) told((static_cast<double>(i) + done) / static_cast<double>(all.size()));
        }));
    return scenes;
}

}  // namespace rt::report
