// Chapter 12 measured: each blur by several samplers, ways to ask lights, and what blurs cost alone and
// together.
#include "tests/report/blurs.hpp"

#include "common/scene/parse.hpp"
#include "tests/report/curves.hpp"
#include "tests/stability/blurs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace rt::report {
namespace {

// One blur a scene. What does not blur is as even as possible, so that it hides nothing.

constexpr const char* through_a_lens =
    "version 1\nsize 32 32\nintegrator flat\ncamera 0 0 5  0 0 0  0 1 0  40\nlens .5 2.5\n"
    "background .05 .1 .2\nambient 0 0 0\nemission .9 .6 .3\nsphere .0372 -.0241 0  .9\n";
constexpr const char* in_motion =
    "version 1\nsize 32 32\nintegrator flat\ncamera 0 0 5  0 0 0  0 1 0  40\nbackground .05 .1 .2\n"
    "ambient 0 0 0\nemission .9 .6 .3\nmotion 1.6 .7 0\nsphere -.8 -.35 0  .7\n";
constexpr const char* under_a_lamp =
    "version 1\nsize 32 32\nmaxdepth 0\ncamera 0 4 4  0 0 0  0 1 0  40\nambient 0 0 0\ndiffuse .8 .8 .8\n"
    "plane 0 0 0  0 1 0\nsphere .1 1.1 .2  .4\nquadLight -.7 4 -.7  0 0 1.4  1.4 0 0  9 8 7\n";
constexpr const char* in_a_dull_mirror =
    "version 1\nsize 32 32\nmaxdepth 1\ncamera 0 2.5 4  0 .2 0  0 1 0  40\nbackground .3 .35 .45\n"
    "ambient 0 0 0\nspecular .8 .8 .8\ngloss 60\nbox -3 -.2 -3  3 0 3\nspecular 0 0 0\nemission .9 .5 .2\n"
    "box -1.5 1 -2.2  -.6 3 -2\nemission .2 .5 .9\nbox .3 1 -2.2  1.3 3 -2\n";

/// What theory says of many samples: of independent ones, always the same; the others pair at random what
/// blurs with the place in the pixel, and nobody knows how much either explains alone.
constexpr Way samplers[] = {
    {"random", Sampler::Random, false, -0.5}, {"jittered", Sampler::Jittered}, {"sobol", Sampler::Sobol}};

/// A lamp that stands on the floor, which sees all of it under a large angle.
constexpr const char* near_lamp =
    "version 1\nsize 32 32\nmaxdepth 0\ncamera 0 2.5 2  0 0 .4  0 1 0  30\nambient 0 0 0\ndiffuse .8 .8 .8\n"
    "plane 0 0 0  0 1 0\nquadLight -1.5 0 -.6  0 1.5 0  3 0 0  1 .9 .8\n";

/// Lamps above what the camera sees, the strongest of which is a hundred times as strong as the weakest.
std::string many_lamps() {
    std::string text =
        "version 1\nsize 32 32\nmaxdepth 0\ncamera 0 2.5 2  0 0 0  0 1 0  40\nambient 0 0 0\n"
        "diffuse .8 .8 .8\nplane 0 0 0  0 1 0\nsphere 0 .4 0  .4\n";
    constexpr int lamps = 24;
    for (int i = 0; i < lamps; ++i) {
        const Real angle = 2 * pi * i / lamps, strength = std::pow(100, std::fmod(i * 0.618, 1));
        text += fmt::format("sphereLight {:.4f} {:.4f} {:.4f}  .1  {:.4f} {:.4f} {:.4f}\n",
                            3 * std::cos(angle), 3.5 + std::sin(3 * angle), 3 * std::sin(angle), strength,
                            0.9 * strength, 0.7 * strength);
    }
    return text;
}

Scene resized(Scene scene, int height) {
    const Real shape = static_cast<Real>(scene.width) / scene.height;
    scene.height = height;
    scene.width = static_cast<int>(std::lround(shape * height));
    return scene;
}

Scene billiards(const std::string& repository, const test::Blurs& blurs, int height) {
    return test::with_blurs(
        resized(parse_scene(repository + "/references/12_distribution/billiards.scene"), height), blurs);
}

// Measuring -------------------------------------------------------------------------------------------

/// A curve: a scene, and how it is sampled.
struct Contender {
    Scene scene;
    Way way;
};

PictureScene named(const std::string& name, const std::string& title, const Scene& scene,
                   const Truth& truth) {
    return {name,           title,       "12",          scene.width, scene.height,
            truth.analytic, truth.error, truth.samples, infinity,    {}};
}

Truth truth_of(Scene scene, const BlursOptions& options) {
    return converged(scene, options.truth_count, options.truth_renders, [](double) {});
}

/// In turns: a point of each contender, then the next point of each.
PictureScene measured(PictureScene result, std::vector<Contender> contenders, const Truth& truth,
                      const BlursOptions& options, bool estimated) {
    std::vector<std::vector<PicturePoint>> points(contenders.size());
    Contender& first = contenders.front();
    measure_point(first.scene, first.way, options.counts.front(), truth.image, 1, false);  // the slowest
    for (const int count : options.counts)
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            Contender& one = contenders[i];
            points[i].push_back(
                measure_point(one.scene, one.way, count, truth.image, options.repeats, estimated));
            result.best = std::min(result.best, points[i].back().error);
        }
    for (std::size_t i = 0; i < contenders.size(); ++i)
        result.curves.push_back(curve_of(contenders[i].way, std::move(points[i]), truth));
    return result;
}

PictureScene by_samplers(const std::string& name, const std::string& title, const Scene& scene,
                         const BlursOptions& options) {
    const Truth truth = truth_of(scene, options);
    std::vector<Contender> contenders;
    for (const Way& way : samplers) contenders.push_back({scene, way});
    return measured(named(name, title, scene, truth), contenders, truth, options, true);
}

PictureScene area_or_angle(const BlursOptions& options) {
    Scene by_angle = resized(parse_scene_text(near_lamp, "near lamp"), options.height);
    Scene by_area = by_angle;
    by_area.light_samples.how = LightSampling::Area;
    const Truth truth = truth_of(by_angle, options);
    return measured(named("near_lamp", "A floor close under a large lamp", by_angle, truth),
                    {{by_angle, {"by angle", Sampler::Jittered}}, {by_area, {"by area", Sampler::Jittered}}},
                    truth, options, false);
}

PictureScene all_or_one(const BlursOptions& options) {
    Scene all = resized(parse_scene_text(many_lamps(), "many lamps"), options.height);
    Scene one = all;
    one.light_samples.all = false;
    const Truth truth = truth_of(one, options);
    return measured(named("many_lights", "Two dozen lamps, of which few are strong", one, truth),
                    {{one, {"one light at random", Sampler::Jittered}}, {all, {"all", Sampler::Jittered}}},
                    truth, options, false);
}

PictureScene nested(const std::string& repository, const BlursOptions& options) {
    const Scene scene = billiards(repository, {true, true, true, true}, options.height);
    const Truth truth = truth_of(scene, options);
    std::vector<Contender> contenders;
    for (const auto& [shadow_rays, name] :
         {std::pair{1, "one shadow ray to a lamp"}, {4, "4 shadow rays"}, {16, "16 shadow rays"}}) {
        contenders.push_back({scene, {name, Sampler::Jittered}});
        contenders.back().scene.light_samples.count = shadow_rays;
        contenders.back().scene.light_samples.stratified = true;
    }
    return measured(named("nesting", "All blurs at once, and shadow rays nested in them", scene, truth),
                    contenders, truth, options, false);
}

PictureScene alone_and_together(const std::string& repository, const BlursOptions& options) {
    PictureScene result;
    for (const auto& [name, blurs] : {std::pair{"no blur", test::Blurs{}},
                                      {"lens", test::Blurs{.lens = true}},
                                      {"motion", test::Blurs{.motion = true}},
                                      {"lamps", test::Blurs{.lamps = true}},
                                      {"gloss", test::Blurs{.gloss = true}},
                                      {"all blurs", test::Blurs{true, true, true, true}}}) {
        const Scene scene = billiards(repository, blurs, options.height);
        const Truth truth = truth_of(scene, options);
        PictureScene one = measured(named("together", "Billiards: each blur alone, and all", scene, truth),
                                    {{scene, {name, Sampler::Jittered}}}, truth, options, false);
        one.truth_error = std::max(one.truth_error, result.truth_error);
        if (!result.curves.empty()) one.best = std::min(one.best, result.best);
        one.curves.insert(one.curves.begin(), result.curves.begin(), result.curves.end());
        result = std::move(one);
    }
    return result;
}

template <class Scenes>
std::vector<PictureScene> one_by_one(const Scenes& scenes, const Told& told) {
    std::vector<PictureScene> all;
    for (const auto& measure : scenes) {
        all.push_back(measure());
        if (told) told(static_cast<double>(all.size()) / static_cast<double>(std::size(scenes)));
    }
    return all;
}

using Measured = std::function<PictureScene()>;

}  // namespace

BlursOptions quick_blurs() { return {12, {4, 16, 64}, 2, 512, 4}; }

std::vector<PictureScene> measure_blurs(const std::string& repository, const BlursOptions& options,
                                        const Told& told) {
    const auto one = [&](const char* name, const char* title, const char* text) -> Measured {
        return [=] {
            return by_samplers(name, title, resized(parse_scene_text(text, name), options.height), options);
        };
    };
    return one_by_one(
        std::vector<Measured>{
            one("lens", "A disk out of focus", through_a_lens), one("motion", "A disk in motion", in_motion),
            one("lamp", "The shadow of a ball under a square lamp", under_a_lamp),
            one("gloss", "Two windows in a dull mirror", in_a_dull_mirror),
            [&] {
                return by_samplers("billiards", "Billiards: lens, motion, lamps and gloss",
                                   billiards(repository, {true, true, true, true}, options.height), options);
            }},
        told);
}

std::vector<PictureScene> compare_blurs(const std::string& repository, const BlursOptions& options,
                                        const Told& told) {
    return one_by_one(
        std::vector<Measured>{[&] { return area_or_angle(options); }, [&] { return all_or_one(options); },
                              [&] { return nested(repository, options); },
                              [&] { return alone_and_together(repository, options); }},
        told);
}

}  // namespace rt::report
