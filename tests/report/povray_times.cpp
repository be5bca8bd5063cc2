// Time to equal error against POV-Ray: soft shadows and depth of field, by ours and by what it has for them.
#include "tests/report/povray_times.hpp"

#include "common/image/file.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/process.hpp"
#include "tests/pictures.hpp"
#include "tests/report/curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include <sys/resource.h>

namespace rt::report {
namespace {

/// CPU seconds of all children that have ended.
double cpu_of_children() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

struct Drawn {
    Image image;
    double seconds = 0;
};

/// POV-Ray on one of the files of tests/report/povray.
struct Povray {
    std::string source, directory;

    Drawn draw(int width, int height, const std::vector<std::string>& declared) const {
        const std::string picture = directory + "/povray_times.png";
        std::vector<std::string> line{"povray",
                                      "+I" + source,
                                      "+O" + picture,
                                      fmt::format("+W{}", width),
                                      fmt::format("+H{}", height),
                                      "+FN16",
                                      "-D",
                                      "-A",
                                      "+WT1",
                                      "File_Gamma=1.0"};
        for (const std::string& one : declared) line.push_back("Declare=" + one);
        const double before = cpu_of_children();
        const ProcessResult result = run_process(line);
        const double seconds = cpu_of_children() - before;
        if (!succeeded(result)) throw std::runtime_error("POV-Ray failed on " + source + result.output);
        return {read_image(picture), seconds};
    }
};

/// A point of a curve: what draws its picture for the n-th time, and how many samples it takes.
struct PointToDraw {
    int samples = 1;
    std::function<Drawn(int)> draw;
};

struct CurveToDraw {
    Way way;
    std::vector<PointToDraw> points;
};

/// Measures all points in turns.
std::vector<PictureCurve> in_turns(const std::vector<CurveToDraw>& curves, const Truth& truth, int repeats,
                                   double start) {
    struct Found {
        std::vector<double> seconds, errors;
    };
    std::vector<std::vector<Found>> found;
    for (const CurveToDraw& curve : curves) found.emplace_back(curve.points.size());
    for (int repeat = 0; repeat < repeats; ++repeat)
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (std::size_t k = 0; k < curves[i].points.size(); ++k) {
                const Drawn drawn = curves[i].points[k].draw(repeat);
                // Ours is the first. What takes less than the start is no measurement of POV-Ray's drawing.
                found[i][k].seconds.push_back(i == 0 ? drawn.seconds
                                                     : std::max(drawn.seconds - start, start / 10));
                found[i][k].errors.push_back(test::rms_difference(drawn.image, truth.image));
            }
    std::vector<PictureCurve> result;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::vector<PicturePoint> points;
        for (std::size_t k = 0; k < curves[i].points.size(); ++k) {
            PicturePoint point;
            point.asked = curves[i].points[k].samples;
            point.samples = point.asked;
            point.seconds = median(found[i][k].seconds);
            point.error = root_mean_square(found[i][k].errors);
            points.push_back(point);
        }
        const bool by_count = points.front().asked != points.back().asked;
        result.push_back(curve_of(curves[i].way, std::move(points), truth));
        // POV-Ray does not say how many samples it takes where it decides that itself.
        if (!by_count) result.back().by_samples = {}, result.back().stopped = "";
    }
    return result;
}

double least_error(const std::vector<PictureCurve>& curves) {
    double least = infinity;
    for (const PictureCurve& curve : curves)
        for (const PicturePoint& point : curve.points) least = std::min(least, point.error);
    return least;
}

Drawn drawn(const RenderResult& result) { return {result.image, result.cpu_seconds}; }

Scene beside(const Povray& povray, int height) {
    Scene scene = parse_scene(povray.source.substr(0, povray.source.rfind('.')) + ".scene");
    scene.width = height * 4 / 3;
    scene.height = height;
    return scene;
}

/// POV-Ray's with these declarations for each of some numbers.
CurveToDraw povray_curve(const char* name, const Povray& povray, const Scene& scene,
                         const std::vector<std::pair<int, std::vector<std::string>>>& points) {
    CurveToDraw curve{{name, Sampler::Regular}, {}};
    for (const auto& point : points)
        curve.points.push_back({point.first, [=, declared = point.second](int) {
                                    return povray.draw(scene.width, scene.height, declared);
                                }});
    return curve;
}

/// Seconds that POV-Ray takes for all but the drawing.
double start_of(const Povray& povray, const std::vector<std::string>& declared) {
    std::vector<double> all;
    for (int i = 0; i < 3; ++i) all.push_back(povray.draw(4, 3, declared).seconds);
    return median(all);
}

PictureScene finished(const std::string& name, const std::string& title, const Scene& scene,
                      const Truth& truth, std::vector<PictureCurve> curves) {
    const double best = least_error(curves);
    return {name,           title,       "12",          scene.width, scene.height,
            truth.analytic, truth.error, truth.samples, best,        std::move(curves)};
}

// Soft shadows ----------------------------------------------------------------------------------------

/// At the pixels' centres, by so many points of the light, each in a cell of its own.
RenderResult shadows_by(Scene scene, int lamp_samples, int seed) {
    scene.light_samples.count = lamp_samples;
    const Sampling one{1, Sampler::Jittered, false, {}, static_cast<std::uint64_t>(seed)};
    return render_with(scene, one, drawn_only(1));
}

/// The mean of several pictures, and the standard error of that.
Truth true_shadows(const Scene& scene, const PovrayOptions& options) {
    Scene long_one = scene;
    long_one.light_samples.count = options.truth_count;
    return converged(long_one, 1, options.truth_renders, [](double) {});
}

PictureScene soft_shadows(const Povray& povray, const PovrayOptions& options) {
    const Scene scene = beside(povray, options.height);
    Truth truth = true_shadows(scene, options);
    truth.samples *= options.truth_count;
    std::vector<CurveToDraw> curves{{{"ours", Sampler::Jittered}, {}}};
    using Points = std::vector<std::pair<int, std::vector<std::string>>>;
    Points plain, lit, lamps;
    for (const int count : options.counts) {
        curves[0].points.push_back({count, [=](int seed) { return drawn(shadows_by(scene, count, seed)); }});
        const std::string n = fmt::format("N={}", std::lround(std::sqrt(count)));
        plain.push_back({count, {n, "Mode=0", "Jitter=1"}});
        lit.push_back({count, {n, "Mode=1", "Jitter=1"}});
        lamps.push_back({count, {n, "Mode=2"}});
    }
    Points adaptive;
    for (const int level : {0, 2, 3})
        adaptive.push_back({289, {"N=17", "Mode=0", "Jitter=1", fmt::format("Adaptive={}", level)}});
    curves.push_back(povray_curve("area_light", povray, scene, plain));
    curves.push_back(povray_curve("adaptive area_light", povray, scene, adaptive));
    curves.push_back(povray_curve("area_illumination", povray, scene, lit));
    curves.push_back(povray_curve("as many spotlights", povray, scene, lamps));
    return finished("povray_shadow", "Soft shadows of three balls", scene, truth,
                    in_turns(curves, truth, options.repeats, start_of(povray, {"N=2"})));
}

// Depth of field --------------------------------------------------------------------------------------

PictureScene depth_of_field(const Povray& povray, const PovrayOptions& options) {
    const Scene scene = beside(povray, options.height);
    Scene long_one = scene;
    const Truth truth = converged(long_one, options.truth_count, options.truth_renders, [](double) {});
    std::vector<CurveToDraw> curves{{{"ours", Sampler::Jittered}, {}}};
    using Points = std::vector<std::pair<int, std::vector<std::string>>>;
    Points all;
    for (const int count : options.counts) {
        curves[0].points.push_back(
            {count, [=](int seed) {
                 Scene own = scene;
                 const Sampling sampling{
                     count, Sampler::Jittered, false, {}, static_cast<std::uint64_t>(seed)};
                 return drawn(render_with(own, sampling, drawn_only(1)));
             }});
        all.push_back({count, {fmt::format("N={}", count)}});
    }
    Points adaptive;
    for (const char* variance : {"0.0078125", "0.001", "0.0001"})
        adaptive.push_back({400, {"N=400", fmt::format("Variance={}", variance)}});
    curves.push_back(povray_curve("focal_blur", povray, scene, all));
    curves.push_back(povray_curve("focal_blur with variance", povray, scene, adaptive));
    return finished("povray_blur", "Balls out of focus over checkers", scene, truth,
                    in_turns(curves, truth, options.repeats, start_of(povray, {"N=0"})));
}

}  // namespace

PovrayOptions quick_povray() { return {36, {4, 16, 64}, 1, 512, 4}; }

bool has_povray() { return run_process({"povray", "--version"}).exit_code != 127; }

std::vector<PictureScene> measure_povray(const std::string& repository, const std::string& directory,
                                         const PovrayOptions& options, const Told& told) {
    const auto file = [&](const char* name) {
        return Povray{repository + "/tests/report/povray/" + name, directory};
    };
    std::vector<PictureScene> scenes{soft_shadows(file("soft_shadow.pov"), options)};
    if (told) told(0.5);
    scenes.push_back(depth_of_field(file("focal_blur.pov"), options));
    return scenes;
}

}  // namespace rt::report
