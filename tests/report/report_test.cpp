// What `course report` measures, small: exponents of errors, and which method is better; never seconds.
#include "tests/catch.hpp"
#include "tests/report/blurs.hpp"
#include "tests/report/families.hpp"
#include "tests/report/filters.hpp"
#include "tests/report/grids.hpp"
#include "tests/report/hierarchies.hpp"
#include "tests/report/kernels.hpp"
#include "tests/report/pictures.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

using namespace rt;
using namespace rt::report;

namespace {

const KernelRow& row(const Kernels& kernels, const std::string& shape, const std::string& method,
                     const std::string& number) {
    const auto at = std::ranges::find_if(kernels.rows, [&](const KernelRow& one) {
        return one.shape == shape && one.method == method && one.number == number;
    });
    INFO(shape << ", " << method << ", " << number);
    REQUIRE(at != kernels.rows.end());
    return *at;
}

/// Timings are not looked at, so they are short.
const Kernels& kernels() {
    static const Kernels measured = measure_kernels({5'000, 1, 0.01, 8, 8, 4});
    return measured;
}

/// The scenes whose truth is a formula; enough renders a point for exponents to two digits.
const std::vector<PictureScene>& pictures() {
    static const std::vector<PictureScene> measured = measure_pictures(
        test::repository(), {24, {4, 9, 16, 36, 64, 144}, test::cases(20) == 20 ? 8 : 4, 0, 0, false});
    return measured;
}

const PictureScene& scene(const std::string& name) {
    const auto at = std::ranges::find(pictures(), name, &PictureScene::name);
    INFO(name);
    REQUIRE(at != pictures().end());
    return *at;
}

const PictureCurve& curve(const std::string& name, const std::string& method) {
    const auto& curves = scene(name).curves;
    const auto at = std::ranges::find(curves, method, &PictureCurve::method);
    INFO(name << ", " << method);
    REQUIRE(at != curves.end());
    return *at;
}

}  // namespace

TEST_CASE("a power law that is exact is found exactly, with no doubt") {
    const double x[] = {1, 10, 100, 1000}, y[] = {3, 3 / std::sqrt(10.), 0.3, 0.03 * std::sqrt(10.)};
    const PowerLaw law = fit_power_law(x, y);
    CHECK(law.slope == Approx(-0.5).epsilon(1e-12));
    CHECK(law.intercept == Approx(std::log10(3.)).epsilon(1e-12));
    CHECK(law.high - law.low < 1e-12);
    CHECK(law.points == 4);
}

TEST_CASE("the confidence interval of a slope holds the truth in 95 % of noisy fits") {
    test::Random random(1);
    const std::vector<double> x{4, 9, 16, 36, 64, 144, 256};
    int held = 0;
    constexpr int fits = 4000;
    for (int i = 0; i < fits; ++i) {
        std::vector<double> y;
        for (const double at : x) {
            // The sum of twelve uniform numbers is as good as normal.
            double noise = -6;
            for (int k = 0; k < 12; ++k) noise += random.uniform(0, 1);
            y.push_back(std::pow(at, -0.75) * std::exp(0.05 * noise));
        }
        const PowerLaw law = fit_power_law(x, y);
        held += law.low <= -0.75 && -0.75 <= law.high;
    }
    // Four standard deviations of a count of 4000 are 55, or 1.4 %.
    CHECK(std::abs(held / static_cast<double>(fits) - 0.95) < 0.014);
}

TEST_CASE("medians and quantiles of small sets") {
    CHECK(median({3, 1, 2}) == 2);
    CHECK(median({4, 1, 2, 3}) == 2.5);
    CHECK(quantile({5, 1, 4, 2, 3}, 1) == 5);
    CHECK(quantile({5, 1, 4, 2, 3}, 0.5) == 3);
    CHECK(quantile({5, 1, 4, 2, 3}, 0.2) == 1);
}

TEST_CASE("the course's intersections are within 8κu and never wrong, where the textbook's are not") {
    for (const auto& [shape, method] : {std::pair{"sphere", "stable"}, std::pair{"triangle", "watertight"}}) {
        const KernelRow& stable = row(kernels(), shape, method, "double");
        const KernelRow& textbook = row(kernels(), shape, "textbook", "double");
        INFO(shape);
        CHECK(stable.course);
        CHECK(stable.error_max <= 8);
        CHECK(stable.wrong == 0);
        CHECK(textbook.error_max > 100 * stable.error_max);
        // Better arithmetic helps less than the better formula, unless it has more than twice the digits.
        CHECK(row(kernels(), shape, method, "float").error_max > 1e6);
        CHECK(row(kernels(), shape, "textbook", "double-double").error_max < 1);
        CHECK(row(kernels(), shape, "exact", "exact").wrong == 0);
    }
    for (const auto& [shape, method, textbook] :
         {std::tuple{"torus", "sign changes near", "closed formulas from the eye"},
          std::tuple{"quadric", "where it is deepest", "h² − ac from the eye"}}) {
        const KernelRow& course = row(kernels(), shape, method, "double");
        const KernelRow& formulas = row(kernels(), shape, textbook, "double");
        INFO(shape);
        CHECK(course.course);
        CHECK(course.error_max <= 8);
        CHECK(course.wrong == 0);
        CHECK(formulas.error_max > 100 * course.error_max);
        CHECK(formulas.wrong > 0);
    }
    const KernelRow& intervals = row(kernels(), "heart", "intervals", "double");
    CHECK(intervals.course);
    CHECK(intervals.error_max <= 8);
    CHECK(intervals.wrong == 0);
    CHECK(row(kernels(), "heart", "equal steps", "100 steps").wrong > 0);
    CHECK(row(kernels(), "heart", "sphere tracing", "to 1e-4").error_max > 1e6);
    CHECK(row(kernels(), "sphere", "textbook", "double").wrong > 0);
    CHECK(row(kernels(), "triangle", "textbook with its constants", "double").wrong > 0);
}

TEST_CASE("intervals are never wrong: they hold the truth, or say that they can't decide") {
    for (const auto& [shape, method] : {std::pair{"sphere", "stable"}, std::pair{"triangle", "volumes"}}) {
        const KernelRow& interval = row(kernels(), shape, method, "interval");
        CHECK(interval.wrong == 0);
        CHECK(interval.undecided > 0);
        CHECK(interval.undecided < interval.cases / 2);
    }
}

TEST_CASE("the map shows a stable method that keeps the digits that the data allow") {
    const auto& maps = kernels().maps;
    REQUIRE(maps.size() == 3);
    std::size_t lost = 0, judged = 0;
    for (std::size_t i = 0; i < maps[0].digits.size(); ++i) {
        if (std::isnan(maps[2].digits[i])) continue;
        ++judged;
        lost += maps[0].digits[i] < maps[2].digits[i] - 1;
        CHECK(maps[1].digits[i] >= maps[2].digits[i] - 1);  // 8κu is 0.9 digits
    }
    CHECK(judged > maps[0].digits.size() / 2);
    CHECK(lost > judged / 3);
}

TEST_CASE("errors of pictures fall with the number of samples as theory says") {
    // Exponents from so few renders scatter by 0.03, those on the disk's few edge pixels by 0.06.
    CHECK(curve("disk", "random").by_samples.slope == Approx(-0.5).margin(0.06));
    CHECK(curve("disk", "jittered").by_samples.slope == Approx(-0.75).margin(0.06));
    CHECK(curve("sky", "random").by_samples.slope == Approx(-0.5).margin(0.03));
    CHECK(curve("sky", "jittered").by_samples.slope == Approx(-1).margin(0.03));
    CHECK(curve("sky", "regular").by_samples.slope == Approx(-1).margin(0.01));
}

TEST_CASE(
    "at equal samples jittered is better than random, and adaptive better than uniform on sparse edges") {
    const auto error = [](const std::string& name, const std::string& method, int count) {
        for (const PicturePoint& point : curve(name, method).points)
            if (point.asked == count) return point.error;
        FAIL("no such point");
        return 0.0;
    };
    const double one = scene("disk").curves.front().points.front().error;
    for (const int count : {16, 36, 64, 144}) {
        INFO(count << " samples a pixel");
        CHECK(error("disk", "jittered", count) < 0.7 * error("disk", "random", count));
        CHECK(error("disk", "Poisson disk", count) < 0.8 * error("disk", "random", count));
        CHECK(error("sky", "regular", count) < 0.1 * error("sky", "jittered", count));
        CHECK(error("disk", "random", count) < one);
    }
    // Part of few samples goes into looking where the edges are.
    for (const int count : {36, 64, 144}) {
        INFO(count << " samples a pixel");
        CHECK(error("disk", "adaptive", count) < error("disk", "jittered", count));
    }
}

TEST_CASE("renders know how wrong they are, within a factor 1.5") {
    for (const auto* name : {"disk", "sky"})
        for (const auto* method : {"random", "jittered", "Poisson disk"})
            for (const PicturePoint& point : curve(name, method).points) {
                INFO(name << ", " << method << ", " << point.asked << " samples a pixel: true " << point.error
                          << ", estimated " << point.estimate);
                CHECK(point.error < 1.5 * point.estimate);
                CHECK(point.estimate < 1.5 * point.error);
            }
}

TEST_CASE(
    "filtered textures are less wrong than four texels at one sample, and more samples help everybody") {
    const std::vector<PictureScene> scenes = measure_filters(test::repository(), {40, {1, 4, 16}, 1, 400, 4});
    REQUIRE(scenes.size() == 1);
    const auto errors = [&](const std::string& filter) {
        const auto at = std::ranges::find(scenes[0].curves, filter, &PictureCurve::method);
        INFO(filter);
        REQUIRE(at != scenes[0].curves.end());
        std::vector<double> all;
        for (const PicturePoint& point : at->points) all.push_back(point.error);
        REQUIRE(all.size() == 3);
        return all;
    };
    for (const auto* filter : {"nearest", "bilinear", "trilinear", "anisotropic"}) {
        const std::vector<double> error = errors(filter);
        INFO(filter << ": " << error[0] << ", " << error[1] << ", " << error[2]);
        CHECK(error[1] < error[0]);
        CHECK(error[2] < error[1]);
    }
    CHECK(errors("trilinear")[0] < 0.5 * errors("bilinear")[0]);
    CHECK(errors("anisotropic")[0] < 0.5 * errors("bilinear")[0]);
    CHECK(scenes[0].truth_error < scenes[0].best / 3);
}

TEST_CASE("what blurs is sampled better by strata than at random, and its renders know how wrong they are") {
    const std::vector<PictureScene> scenes = measure_blurs(test::repository(), {8, {4, 16, 64}, 3, 512, 4});
    REQUIRE(scenes.size() == 5);
    for (const PictureScene& one : scenes) {
        REQUIRE(one.curves.size() == 3);
        const PictureCurve &random = one.curves[0], &jittered = one.curves[1];
        INFO(one.name << ": random samples err by n^" << random.by_samples.slope << ", jittered ones by n^"
                      << jittered.by_samples.slope);
        // From so few pixels exponents scatter by 0.05.
        CHECK(random.by_samples.slope == Approx(-0.5).margin(0.2));
        CHECK(jittered.points.back().error < 0.85 * random.points.back().error);
        for (const PictureCurve& curve : one.curves)
            for (const PicturePoint& point : curve.points) {
                INFO(curve.method << ", " << point.asked << " samples a pixel: true " << point.error
                                  << ", estimated " << point.estimate);
                CHECK(point.error < 1.5 * point.estimate);
                CHECK(point.estimate < 1.5 * point.error);
            }
    }
}

TEST_CASE("a near lamp is sampled by angle, few of many lights are asked, and no question is nested") {
    const std::vector<PictureScene> scenes = compare_blurs(test::repository(), {8, {4, 16}, 2, 256, 2});
    const auto at = [&](const std::string& name, const std::string& method) {
        for (const PictureScene& one : scenes)
            for (const PictureCurve& curve : one.curves)
                if (one.name == name && curve.method == method) return curve.points.back();
        FAIL(name << ", " << method);
        return PicturePoint{};
    };
    CHECK(at("near_lamp", "by angle").error < 0.5 * at("near_lamp", "by area").error);
    CHECK(at("many_lights", "one light at random").rays < 0.2 * at("many_lights", "all").rays);
    // Sixteen times the shadow rays, and hardly less error.
    const PicturePoint one = at("nesting", "one shadow ray to a lamp"),
                       many = at("nesting", "16 shadow rays");
    INFO("nested: " << many.rays << " rays and " << many.error << " instead of " << one.rays << " and "
                    << one.error);
    CHECK(many.rays > 8 * one.rays);
    CHECK(many.error > 0.5 * one.error);
    // All blurs together take as many rays as none.
    CHECK(at("together", "all blurs").rays < 1.1 * at("together", "no blur").rays);
}

TEST_CASE("a grid asks few triangles, ever fewer of them all, and answers as brute force does") {
    const Grids grids = measure_grids({{1e3, 1e4, 1e5}, 2'000, 2e6, 1});
    REQUIRE(grids.points.size() == 3);
    for (const GridPoint& point : grids.points) {
        INFO(point.triangles << " triangles");
        CHECK(point.asked < point.triangles / 50);
        CHECK(point.different == 0);
        CHECK(point.bytes > 4);    // a triangle is listed at least once, with 4 bytes,
        CHECK(point.bytes < 200);  // and not in dozens of cells
    }
    // The ball's surface crosses some N^(2/3) of N cells, with N^(1/3) along a ray; a third is the worst
    // case.
    CHECK(grids.asked.slope < 0.35);
}

TEST_CASE("hierarchies answer as brute force does, and lines pay what is predicted") {
    const std::vector<SearchPoint> points = measure_searches({2e4, 2'000, 1e7, 1});
    REQUIRE(points.size() == 4 * 10);
    const auto at = [&](const char* scene, const char* way) {
        for (const SearchPoint& point : points)
            if (point.scene == scene && point.way == way) return point;
        return SearchPoint{};
    };
    for (const SearchPoint& point : points) {
        INFO(point.scene << ", " << point.way << ": " << point.nodes << " nodes and " << point.asked
                         << " triangles a ray, predicted " << point.predicted << ", paid " << point.paid);
        CHECK(point.different == 0);
        if (point.predicted == 0) continue;
        CHECK(point.compared > 100);
        // Lines that come from everywhere alike: 2,000 of them give the mean to some hundredths.
        CHECK(point.paid > 0.85 * point.predicted);
        CHECK(point.paid < 1.15 * point.predicted);
        CHECK(point.bytes < 200);
    }
    // What the heuristic is for: a crowd in a large box.
    for (const char* scene : {"dented ball", "ball in a stadium", "city", "needles"}) {
        const SearchPoint halves = at(scene, "hierarchy by halves"), bins = at(scene, "hierarchy by bins"),
                          sweep = at(scene, "hierarchy by sweep");
        INFO(scene << ", predicted by halves " << halves.predicted << ", bins " << bins.predicted
                   << ", sweep " << sweep.predicted);
        CHECK(bins.predicted < halves.predicted);
        CHECK(sweep.predicted < 1.1 * bins.predicted);
        CHECK(bins.nodes + bins.asked < halves.nodes + halves.asked);
    }
    const SearchPoint grid = at("ball in a stadium", "grid"),
                      tree = at("ball in a stadium", "hierarchy by bins");
    INFO("a ball in a stadium: a uniform grid asks " << grid.asked << " triangles a ray, a hierarchy "
                                                     << tree.asked);
    CHECK(tree.asked < grid.asked / 10);
}

TEST_CASE(
    "the families at a small size: the course's methods are right, and the textbook's fail in every "
    "chapter") {
    std::map<std::string, std::size_t> naive;  // by chapter, however many there are
    for (const FamilyRow& family : measure_families({1'000, 4'000})) {
        INFO(family.chapter << " " << family.question << ", " << family.family << ": "
                            << stability::describe(family.stable));
        CHECK(family.stable.cases > 0);
        CHECK(family.stable.mismatches == 0);
        CHECK(family.stable.worst <= 1);
        naive[family.chapter] += family.naive.mismatches;
    }
    for (const char* chapter : {"02", "03", "04", "06", "07", "09", "13"}) CHECK(naive[chapter] > 0);
}
