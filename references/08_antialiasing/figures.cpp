// Draws the figures of lesson 8 into the directory that it is given.
// Numbers in the figures are computed here, by the course's own functions where there is one.
#include "references/figures.hpp"
#include "chapters/08_antialiasing/estimate.hpp"
#include "chapters/08_antialiasing/film.hpp"
#include "chapters/08_antialiasing/samples.hpp"
#include "common/math/stopwatch.hpp"
#include "common/render/integrators.hpp"
#include "references/panels.hpp"
#include "tests/pictures.hpp"
#include "tests/stability/coverage.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <numeric>

using namespace rt;
using namespace rt::figures;
using rt::test::HalfPlane;

namespace {

/// Numbers in the lesson's prose.
Numbers numbers;

using Pattern = std::vector<PixelSample>;

/// `count` samples, from random numbers that nobody else has who says another `use`.
using Maker = std::function<Pattern(int count, std::uint64_t use)>;

/// Poisson disk patterns take long to make, so 32 are kept and moved about, as the renderer does.
Pattern poisson(int count, std::uint64_t use) {
    static std::vector<std::pair<int, std::vector<Pattern>>> known;
    auto kept = std::ranges::find_if(known, [&](const auto& pair) { return pair.first == count; });
    if (kept == known.end()) {
        kept = known.insert(known.end(), {count, {}});
        for (std::uint64_t i = 0; i < 32; ++i)
            kept->second.push_back(poisson_disk_samples(count, random_for(8, i, 0)).samples);
    }
    Random random = random_for(8, use, 1);
    Pattern pattern = kept->second[random_index(random, 32)];
    const Vec2 by = random_point(random);
    for (PixelSample& sample : pattern) sample.at = glm::fract(sample.at + by);
    return pattern;
}

struct Method {
    const char* name;
    const char* color;
    Maker samples;
    int most = 4096;  ///< samples in a pattern; more take too long
};
const Method regular{"regular", blue, [](int n, std::uint64_t) { return regular_samples(n); }};
const Method independent{"random", red,
                         [](int n, std::uint64_t use) { return random_samples(n, random_for(8, use, 2)); }};
const Method jittered{"jittered", green,
                      [](int n, std::uint64_t use) { return jittered_samples(n, random_for(8, use, 3)); }};
const Method poisson_disk{"Poisson disk", orange, poisson, 1024};
const Method halton{"Halton", purple,
                    [](int n, std::uint64_t use) { return halton_samples(n, random_for(8, use, 10)); }};

/// n = k² jittered samples, one in each of k × k squares, and at the same time one in each of n columns and
/// in each of n rows (Chiu, Shirley and Wang 1994): in the columns of the squares the same n rows are dealt
/// out at random.
Pattern multi_jittered_samples(int n, Random random) {
    const int k = static_cast<int>(std::lround(std::sqrt(n)));
    std::vector<int> row_of(static_cast<std::size_t>(n)), column_of(static_cast<std::size_t>(n));
    const auto deal = [&](std::vector<int>& order) {
        for (int i = 0; i < k; ++i) {
            const auto first = order.begin() + i * k;
            std::iota(first, first + k, 0);
            for (int j = k - 1; j > 0; --j)
                std::iter_swap(first + j, first + static_cast<int>(random_index(
                                                      random, static_cast<std::uint64_t>(j) + 1)));
        }
    };
    deal(column_of);
    deal(row_of);
    Pattern samples;
    for (int y = 0; y < k; ++y)
        for (int x = 0; x < k; ++x) {
            const Vec2 cell(x * k + column_of[static_cast<std::size_t>(x * k + y)],
                            y * k + row_of[static_cast<std::size_t>(y * k + x)]);
            samples.push_back({(cell + random_point(random)) / Real(n), Real(1) / n});
        }
    return samples;
}
const Method multi_jittered{"multi-jittered", ink, [](int n, std::uint64_t use) {
                                return multi_jittered_samples(n, random_for(8, use, 11));
                            }};
const Method trapezoid{"trapezoid", purple, [](int n, std::uint64_t) { return trapezoid_samples(n); }};
const Method centered{"centred", ink, [](int n, std::uint64_t) { return centered_samples(n); }};

// Patterns ----------------------------------------------------------------------------------------------

void draw_patterns(const Path& directory) {
    Svg svg{.width = 820, .height = 460};
    const std::array<std::pair<Method, int>, 7> panels{{{regular, 16},
                                                        {independent, 16},
                                                        {jittered, 16},
                                                        {poisson_disk, 16},
                                                        {halton, 16},
                                                        {trapezoid, 25},
                                                        {centered, 17}}};
    const Real side = 170;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const auto& [method, count] = panels[i];
        const Vec2 corner(25 + 200 * static_cast<Real>(i % 4) + (i < 4 ? 0 : 100),
                          40 + 225 * static_cast<Real>(i / 4));
        text(svg, corner + Vec2(side / 2, -13), fmt::format("{}, {}", method.name, count), heading);
        if (i == 0 || i == 2 || i == 6)
            for (const Stratum& part : strata(16))
                rectangle(svg, corner + side * part.low, side * (part.high - part.low),
                          {.stroke = "#c8c8c8", .width = 1});
        rectangle(svg, corner, {side, side});
        const Real even = Real(1) / count;
        for (const PixelSample& sample : method.samples(count, 5))
            dot_at(svg, corner + side * sample.at, method.color,
                   5 * std::sqrt(sample.weight / (i == 5 ? Real(1) / 16 : even)));
    }
    write_svg(directory / "patterns.svg", svg);
}

// Aliases -----------------------------------------------------------------------------------------------

/// A wave of 0.9 cycles a pixel, and the one of 0.1 that has the same values in the pixels' centres.
void draw_alias(const Path& directory) {
    Svg svg{.width = 760, .height = 210};
    constexpr int pixels = 20;
    const Real left = 20, wide = 36, middle_line = 105, high = 55;
    const auto place = [&](Real x, Real value) { return Vec2(left + wide * x, middle_line - high * value); };
    for (int x = 0; x <= pixels; ++x)
        line(svg, place(x, 1.25), place(x, -1.25), {.stroke = light, .width = 1.5});
    const auto wave = [](Real cycles, Real x) { return std::cos(2 * pi * cycles * (x - 0.5)); };
    const auto draw = [&](Real cycles, const SvgStyle& style) {
        std::vector<Vec2> points;
        for (int i = 0; i <= 40 * pixels; ++i) points.push_back(place(i / 40.0, wave(cycles, i / 40.0)));
        polyline(svg, points, style);
    };
    draw(0.9, {.stroke = blue, .width = 1.5});
    draw(0.1, {.stroke = red, .width = 2.5, .dash = "7 5"});
    for (int x = 0; x < pixels; ++x) dot_at(svg, place(x + 0.5, wave(0.9, x + 0.5)), ink, 5);
    text(svg, {left, 24}, "the wave, 0.9 cycles a pixel", colored({.size = 17, .bold = true}, blue));
    text(svg, {left + wide * pixels, 24}, "its alias, 0.1 cycles a pixel",
         anchored(colored({.size = 17, .bold = true}, red), "end"));
    text(svg, {left + wide * pixels / 2, 198}, "pixels, with one sample in the middle of each",
         middle(SvgFont{.size = 15}));
    write_svg(directory / "alias.svg", svg);
}

// An edge in a pixel ------------------------------------------------------------------------------------

/// What part of the pixel lies on the side of the edge where its function is 1.
Real coverage(const HalfPlane& edge) { return mean(edge, {0, 0}, {1, 1}); }

/// An edge through a random point of the pixel, in a random direction.
HalfPlane random_edge(std::uint64_t which) {
    Random random = random_for(8, which, 4);
    const Vec2 point = random_point(random);
    const Real angle = 2 * pi * random_real(random);
    const Vec2 normal(std::cos(angle), std::sin(angle));
    return {normal, glm::dot(normal, point)};
}

void draw_edge(const Path& directory) {
    Svg svg{.width = 700, .height = 330};
    const HalfPlane edge{glm::normalize(Vec2(-0.42, 1)), 0.33};
    const Real side = 250;
    const std::array<int, 2> counts{16, 64};
    for (std::size_t i = 0; i < 2; ++i) {
        const int n = counts[i];
        const Vec2 corner(65 + 320 * static_cast<Real>(i), 36);
        int crossed = 0;
        for (const Stratum& part : strata(n)) {
            const Real covered = mean(edge, part.low, part.high);
            const bool is_crossed = covered > 0 && covered < 1;
            crossed += is_crossed;
            rectangle(svg, corner + side * part.low, side * (part.high - part.low),
                      {.stroke = "#c8c8c8",
                       .width = 1,
                       .fill = is_crossed    ? "#fbe3b0"
                               : covered > 0 ? "#cfe4f3"
                                             : "#ffffff"});
        }
        rectangle(svg, corner, {side, side});
        const Real left = edge.offset / edge.normal.y, right = (edge.offset - edge.normal.x) / edge.normal.y;
        line(svg, corner + side * Vec2(0, left), corner + side * Vec2(1, right),
             {.stroke = ink, .width = 2.5});
        Real sum = 0;
        for (const PixelSample& sample : jittered.samples(n, 1)) {
            dot_at(svg, corner + side * sample.at, value(edge, sample.at) > 0 ? blue : grey,
                   n == 16 ? 4.5 : 3);
            sum += value(edge, sample.at);
        }
        text(svg, corner + Vec2(side / 2, -12), fmt::format("{} strata, {} on the edge", n, crossed),
             heading);
        text(svg, corner + Vec2(side / 2, side + 27),
             fmt::format("{} of {} above: {:.3f}; exact: {:.3f}", sum, n, sum / n, coverage(edge)),
             middle(SvgFont{.size = 17}));
    }
    write_svg(directory / "edge.svg", svg);
}

// The zone plate ----------------------------------------------------------------------------------------

/// A colour for each point of the picture, in pixels from its top left corner.
using Scenery = std::function<Vec3(const Vec2&)>;

/// Rings that become narrower outwards: `cycles` of them a pixel at distance `reach` from the top left.
Scenery zone_plate(Real reach, Real cycles) {
    return [=](const Vec2& p) { return Vec3(0.5 + 0.5 * std::cos(pi * cycles / reach * glm::dot(p, p))); };
}

std::vector<FilmSample> samples_of(const Scenery& scenery, int width, int height, const Maker& method,
                                   int count) {
    std::vector<FilmSample> samples;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const PixelSample& sample : method(count, static_cast<std::uint64_t>(y * width + x))) {
                const Vec2 at = Vec2(x, y) + sample.at;
                samples.push_back({at, scenery(at), sample.weight});
            }
    return samples;
}

Image filtered(const std::vector<FilmSample>& samples, int width, int height, const Filter& filter) {
    Image image = make_image(width, height);
    const std::vector<FilmPixel> film = film_of(samples, filter, {0, 0, width, height});
    for (std::size_t i = 0; i < film.size(); ++i) image.pixels[i] = color_of(film[i]);
    return image;
}

Image picture(const Scenery& scenery, int width, int height, const Maker& method, int count,
              const Filter& filter = {}) {
    return filtered(samples_of(scenery, width, height, method, count), width, height, filter);
}

/// With few levels a picture of noise is a small file.
Image in_levels(Image image, int levels) {
    for (Vec3& p : image.pixels) {
        for (int i = 0; i < 3; ++i)
            p[i] = decode(std::round(encode(p[i], Encoding::Srgb) * (levels - 1)) / (levels - 1),
                          Encoding::Srgb);
    }
    return image;
}

void draw_zone_plate(const Path& directory) {
    const int size = 110;
    const Scenery rings = zone_plate(size, 4.5);
    struct One {
        const char* words;
        Method method;
        int count;
    };
    const One ones[] = {{"1, in the middle", regular, 1}, {"16, regular", regular, 16},
                        {"16, random", independent, 16},  {"1, random", jittered, 1},
                        {"16, jittered", jittered, 16},   {"16, Poisson disk", poisson_disk, 16}};
    std::vector<Panel> panels;
    for (const One& one : ones)
        panels.push_back(
            {in_levels(picture(rings, size, size, one.method.samples, one.count), 8), one.words});
    write_svg(directory / "zone_plate.svg", side_by_side(panels, 3, 2));
}

// Filters -----------------------------------------------------------------------------------------------

struct NamedFilter {
    const char* name;
    const char* color;
    Filter filter;
};
const std::array<NamedFilter, 4> filters{{{"box", blue, {FilterKind::Box, 0.5}},
                                          {"tent", green, {FilterKind::Tent, 1}},
                                          {"Gaussian", orange, {FilterKind::Gaussian, 1.5}},
                                          {"Mitchell", red, {FilterKind::Mitchell, 2}}}};

/// The filter along one axis, with an area of 1 below its curve.
std::vector<Vec2> profile(const Filter& filter, int steps) {
    std::vector<Vec2> curve;
    Real area = 0;
    for (int i = 0; i <= steps; ++i) {
        const Real x = filter.radius * (2 * (i + 0.5) / (steps + 1) - 1);
        curve.emplace_back(x, filter_weight(filter, {x, 0}));
        area += curve.back().y * 2 * filter.radius / (steps + 1);
    }
    for (Vec2& p : curve) p.y /= area;
    return curve;
}

void draw_filters(const Path& directory) {
    Svg svg{.width = 700, .height = 360};
    const Plot shape{{50, 40}, {280, 260}, {-2.2, 2.2}, {-0.2, 1.1}};
    const Plot edge{{400, 40}, {280, 260}, {-2.2, 2.2}, {-0.15, 1.15}};
    const Ticks xs{{-2, "−2"}, {-1, "−1"}, {0, "0"}, {1, "1"}, {2, "2"}};
    text(svg, {190, 24}, "The weights", heading);
    text(svg, {540, 24}, "What they make of an edge", heading);
    draw_axes(svg, shape, xs, {{0, "0"}, {0.5, "0.5"}, {1, "1"}});
    draw_axes(svg, edge, xs, {{0, "0"}, {0.5, "0.5"}, {1, "1"}});
    line(svg, edge.place(0, 0), edge.place(0, 1), {.stroke = grey, .width = 1, .dash = "4 4"});
    for (std::size_t i = 0; i < filters.size(); ++i) {
        const auto& [name, color, filter] = filters[i];
        std::vector<Vec2> weights, response;
        weights.push_back(shape.place(-2.2, 0));
        weights.push_back(shape.place(-filter.radius, 0));
        response.push_back(edge.place(-2.2, 0));
        response.push_back(edge.place(-filter.radius, 0));
        Real sum = 0;
        const int steps = filter.kind == FilterKind::Box ? 2 : 80;
        for (const Vec2& p : profile(filter, steps)) {
            weights.push_back(shape.place(p.x, p.y));
            if (filter.kind == FilterKind::Box && weights.size() == 3)
                weights.back().x = shape.place(-filter.radius, 0).x;
        }
        if (filter.kind == FilterKind::Box) weights.back().x = shape.place(filter.radius, 0).x;
        weights.push_back(shape.place(filter.radius, 0));
        weights.push_back(shape.place(2.2, 0));
        const std::vector<Vec2> fine = profile(filter, 80);
        for (const Vec2& p : fine) {
            const Real step = 2 * filter.radius / static_cast<Real>(fine.size());
            sum += p.y * step;
            response.push_back(edge.place(p.x + step / 2, sum));
        }
        response.push_back(edge.place(2.2, 1));
        polyline(svg, weights, {.stroke = color, .width = 2});
        polyline(svg, response, {.stroke = color, .width = 2});
        text(svg, {65, 64 + 20 * static_cast<Real>(i)}, name, colored(small, color));
    }
    text(svg, {190, 342}, "pixels from the centre", middle(small));
    text(svg, {540, 342}, "pixels from the edge", middle(small));
    write_svg(directory / "filters.svg", svg);

    const int size = 90;
    const std::vector<FilmSample> samples = samples_of(zone_plate(size, 1), size, size, jittered.samples, 64);
    std::vector<Panel> panels;
    for (const NamedFilter& one : filters)
        panels.push_back({in_levels(filtered(samples, size, size, one.filter), 64), one.name});
    write_svg(directory / "filtered.svg", side_by_side(panels, 4, 2));
}

// Spectra -----------------------------------------------------------------------------------------------

constexpr int spectrum_count = 64;  ///< samples of the patterns whose spectra are shown
constexpr int reach = 24;           ///< frequencies from −reach to reach cycles a pixel

/// |Σ exp(−2πi k·at)|²/n for whole k, averaged over patterns; 1 everywhere for independent samples.
std::vector<Real> spectrum(const Maker& method, int patterns) {
    constexpr int side = 2 * reach + 1;
    std::vector<Real> power(side * side, 0);
    for (int p = 0; p < patterns; ++p) {
        const Pattern pattern = method(spectrum_count, static_cast<std::uint64_t>(1000 + p));
        for (int ky = -reach; ky <= reach; ++ky)
            for (int kx = 0; kx <= reach; ++kx) {
                Vec2 sum(0);
                for (const PixelSample& sample : pattern) {
                    const Real angle = 2 * pi * (kx * sample.at.x + ky * sample.at.y);
                    sum += Vec2(std::cos(angle), std::sin(angle));
                }
                const Real here = glm::dot(sum, sum) / spectrum_count / patterns;
                power[static_cast<std::size_t>((ky + reach) * side + kx + reach)] += here;
                if (kx > 0) power[static_cast<std::size_t>((reach - ky) * side + reach - kx)] += here;
            }
    }
    return power;
}

void draw_spectra(const Path& directory) {
    constexpr int side = 2 * reach + 1;
    const std::array<Method, 3> methods{independent, jittered, poisson_disk};
    const std::array<const char*, 3> names{"random", "jittered", "Poisson disk"};
    std::vector<Panel> panels;
    std::array<std::vector<Real>, 3> curves;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const std::vector<Real> power = spectrum(methods[m].samples, 200);
        Image image = make_image(side, side);
        std::vector<Real> sum(reach + 1, 0), number(reach + 1, 0);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const bool middle_one = x == reach && y == reach;  // the mean, n: no news
                const Real here = middle_one ? 0 : power[static_cast<std::size_t>(y * side + x)];
                pixel(image, x, y) = Vec3(decode(here / 2.2, Encoding::Srgb));
                const auto ring = static_cast<std::size_t>(std::lround(std::hypot(x - reach, y - reach)));
                if (middle_one || ring > reach) continue;
                sum[ring] += here;
                number[ring] += 1;
            }
        for (std::size_t k = 1; k <= reach; ++k) curves[m].push_back(sum[k] / number[k]);
        panels.push_back({in_levels(image, 24), names[m]});
    }
    write_svg(directory / "spectra_seen.svg", side_by_side(panels, 3, 4));

    std::string csv = "cycles a pixel,random,jittered,poisson disk\n";
    for (std::size_t k = 0; k < reach; ++k)
        csv += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", k + 1, curves[0][k], curves[1][k], curves[2][k]);
    write_file(directory / "spectra.csv", csv);

    Svg svg{.width = 700, .height = 300};
    const Plot plot{{70, 30}, {590, 210}, {0, reach}, {0, 2}};
    Ticks xs;
    for (int k = 0; k <= reach; k += 4) xs.emplace_back(k, std::to_string(k));
    draw_axes(svg, plot, xs, {{0, "0"}, {0.5, "0.5"}, {1, "1"}, {1.5, "1.5"}, {2, "2"}});
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<Vec2> points;
        for (std::size_t k = 0; k < reach; ++k)
            points.push_back(plot.place(static_cast<Real>(k + 1), curves[m][k]));
        polyline(svg, points, {.stroke = methods[m].color, .width = 2.5});
        text(svg, {560, 190 + 18 * static_cast<Real>(m)}, methods[m].name, colored(small, methods[m].color));
    }
    text(svg, {365, 285}, "frequency, cycles a pixel", middle(small));
    text(svg, {22, 135}, "power", {.size = 13, .anchor = "middle", .turn = -90});
    write_svg(directory / "spectra.svg", svg);
}

// Error against samples ---------------------------------------------------------------------------------

/// What is averaged over the unit square, and its exact mean.
struct Question {
    std::function<Real(const Vec2&)> function;
    Real mean;
};

Question edge_question(std::uint64_t which) {
    const HalfPlane edge = random_edge(which);
    return {[=](const Vec2& p) { return value(edge, p); }, coverage(edge)};
}

/// An upright edge at a random place, such as those of a fence.
Question upright_question(std::uint64_t which) {
    Random random = random_for(8, which, 12);
    const HalfPlane edge{{1, 0}, random_real(random)};
    return {[=](const Vec2& p) { return value(edge, p); }, coverage(edge)};
}

/// A wave of half a cycle a pixel in a random direction, with a random phase.
Question smooth_question(std::uint64_t which) {
    Random random = random_for(8, which, 5);
    const Real angle = 2 * pi * random_real(random), phase = 2 * pi * random_real(random);
    const Vec2 wave = pi * Vec2(std::cos(angle), std::sin(angle));
    const auto sinc = [](Real x) { return x == 0 ? 1 : std::sin(x) / x; };
    const Real center = std::cos(phase + (wave.x + wave.y) / 2);
    return {[=](const Vec2& p) { return 0.5 + 0.5 * std::cos(phase + glm::dot(wave, p)); },
            0.5 + 0.5 * center * sinc(wave.x / 2) * sinc(wave.y / 2)};
}

Real estimated(const Question& question, const Pattern& pattern) {
    Real sum = 0;
    for (const PixelSample& sample : pattern) sum += sample.weight * question.function(sample.at);
    return sum;
}

/// Slope of the line through (log x, log y) with the least squares, and its standard error.
struct Slope {
    Real value, error;
};
Slope slope_of(const std::vector<Vec2>& points) {
    const auto n = static_cast<Real>(points.size());
    Vec2 mean(0);
    for (const Vec2& p : points) mean += glm::log(p) / n;
    Real xx = 0, xy = 0, yy = 0;
    for (const Vec2& p : points) {
        const Vec2 d = glm::log(p) - mean;
        xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
    }
    const Real slope = xy / xx;
    return {slope, std::sqrt(std::max(yy - slope * xy, 0.0) / (n - 2) / xx)};
}

void draw_error(const Path& directory) {
    const std::array<int, 6> counts{4, 16, 64, 256, 1024, 4096};
    const std::array<Method, 6> methods{independent, poisson_disk, jittered, regular, halton, multi_jittered};
    struct Panel {
        const char* title;
        const char* name;
        Question (*question)(std::uint64_t);
        Axis error;
    };
    const std::array<Panel, 3> panels{{{"an edge", "edge", edge_question, {1e-4, 1, true}},
                                       {"an upright edge", "upright", upright_question, {1e-4, 1, true}},
                                       {"a smooth wave", "wave", smooth_question, {1e-6, 1, true}}}};
    std::string csv = "function and method,4,16,64,256,1024,4096\n",
                slopes = "function and method,slope,standard error\n";
    Svg svg{.width = 940, .height = 440};
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const Panel& panel = panels[p];
        const Plot plot{{66 + 306 * static_cast<Real>(p), 40}, {240, 340}, {3, 5500, true}, panel.error};
        draw_axes(svg, plot, {{4, "4"}, {16, "16"}, {64, "64"}, {256, "256"}, {1024, "1024"}, {4096, "4096"}},
                  p < 2 ? decades(-4, 0) : decades(-6, 0));
        text(svg, plot.corner + Vec2(120, -14), panel.title, heading);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            const Method& method = methods[m];
            std::vector<Vec2> points, places;
            for (const int n : counts) {
                if (n > method.most) continue;
                const std::uint64_t cases = 2000;
                Real squares = 0;
                for (std::uint64_t i = 0; i < cases; ++i) {
                    const Question question = panel.question(i);
                    const Pattern pattern = method.samples(n, 10'000 + i);
                    const Real error = estimated(question, pattern) - question.mean;
                    squares += error * error;
                }
                points.emplace_back(n, std::sqrt(squares / static_cast<Real>(cases)));
                places.push_back(plot.place(points.back().x, points.back().y));
            }
            csv += fmt::format("{}: {}", panel.name, method.name);
            for (const Vec2& point : points) csv += fmt::format(",{:.3g}", point.y);
            csv += '\n';
            const Slope slope = slope_of(points);
            slopes +=
                fmt::format("{}: {},{:.3f},{:.3f}\n", panel.name, method.name, slope.value, slope.error);
            if (m + 1 == methods.size()) continue;  // an answer, which the figure does not give away
            polyline(svg, places, {.stroke = method.color, .width = 2});
            for (const Vec2& place : places) dot_at(svg, place, method.color);
            text(svg, plot.place(3.3, panel.error.low) + Vec2(0, -10 - 19 * static_cast<Real>(m)),
                 fmt::format("{}: −{:.2f}", method.name, -slope.value), colored({.size = 15}, method.color));
        }
        text(svg, plot.corner + Vec2(120, 388), "samples a pixel", middle(small));
    }
    text(svg, {16, 205}, "RMS error", {.size = 13, .anchor = "middle", .turn = -90});
    write_svg(directory / "error.svg", svg);
    write_file(directory / "error.csv", csv);
    write_file(directory / "slopes.csv", slopes);
}

// How wrong? --------------------------------------------------------------------------------------------

/// What s/√n of the samples of one pattern says of the error on edges, what replicates say, and the truth.
void write_estimates(const Path& directory) {
    std::string csv = "samples";
    for (const char* name : {"random", "jittered"})
        csv += fmt::format(
            ",{0}: rms error,{0}: by s/sqrt(n),{0}: by 8 replicates,{0}: s/sqrt(n) too large by", name);
    csv += '\n';
    for (const int n : {4, 16, 64, 256}) {
        csv += std::to_string(n);
        for (const Method& method : {independent, jittered}) {
            const std::uint64_t cases = 4000, replicates = 8;
            Real truth = 0, naive = 0, by_replicates = 0;
            for (std::uint64_t i = 0; i < cases; ++i) {
                const Question question = edge_question(i);
                std::vector<Vec3> means;
                for (std::uint64_t k = 0; k < replicates; ++k) {
                    const Pattern pattern = method.samples(n, i * replicates + k);
                    std::vector<Vec3> values;
                    for (const PixelSample& sample : pattern)
                        values.emplace_back(question.function(sample.at));
                    const Estimate one = estimate(values);
                    const Real error = one.mean.x - question.mean;
                    truth += error * error;
                    naive += one.standard_error.x * one.standard_error.x;
                    means.push_back(one.mean);
                }
                const Real error = estimate(means).standard_error.x;
                by_replicates += error * error * replicates;
            }
            truth = std::sqrt(truth / (cases * replicates));
            naive = std::sqrt(naive / (cases * replicates));
            by_replicates = std::sqrt(by_replicates / cases);
            csv += fmt::format(",{:.4f},{:.4f},{:.4f},{:.2f}", truth, naive, by_replicates, naive / truth);
        }
        csv += '\n';
    }
    write_file(directory / "estimates.csv", csv);
}

// The bias of stopping early ----------------------------------------------------------------------------

/// Four samples; where they differ 12 more, and the mean of all, or of the further ones only.
Real adaptive_mean(const HalfPlane& edge, bool keep_pilot, std::uint64_t use) {
    const Pattern pilot = independent.samples(4, 2 * use), further = independent.samples(12, 2 * use + 1);
    Real first = 0, second = 0;
    for (const PixelSample& sample : pilot) first += value(edge, sample.at);
    for (const PixelSample& sample : further) second += value(edge, sample.at);
    const bool same = first == 0 || first == 4;
    if (keep_pilot) return same ? first / 4 : (first + second) / 16;
    if (!same) return second / 12;
    return value(edge, further.front().at);
}

void draw_bias(const Path& directory) {
    Svg svg{.width = 700, .height = 330};
    const Plot plot{{80, 30}, {440, 240}, {0, 1}, {-0.08, 0.08}};
    draw_axes(svg, plot, {{0, "0"}, {0.25, "0.25"}, {0.5, "0.5"}, {0.75, "0.75"}, {1, "1"}},
              {{-0.05, "−0.05"}, {0, "0"}, {0.05, "0.05"}});
    std::vector<Vec2> theory;
    for (int i = 0; i <= 100; ++i) {
        const Real p = i / 100.0, q = 1 - p;
        theory.push_back(plot.place(p, 0.75 * p * q * (p * p * p - q * q * q)));
    }
    polyline(svg, theory, {.stroke = red, .width = 2});
    std::string csv = "coverage,bias by theory,bias with the pilot,bias without it\n";
    for (int i = 1; i < 20; ++i) {
        const Real p = i / 20.0, q = 1 - p;
        const HalfPlane edge{{1, 0}, p};
        Vec2 sum(0);
        const std::uint64_t cases = 200'000;
        for (std::uint64_t k = 0; k < cases; ++k)
            sum +=
                Vec2(adaptive_mean(edge, true, k), adaptive_mean(edge, false, k)) / static_cast<Real>(cases);
        dot_at(svg, plot.place(p, sum.x - p), red, 4);
        dot_at(svg, plot.place(p, sum.y - p), blue, 4);
        csv += fmt::format("{:.2f},{:.4f},{:.4f},{:.4f}\n", p, 0.75 * p * q * (p * p * p - q * q * q),
                           sum.x - p, sum.y - p);
        if (i == 4)
            numbers.add("a pixel that is white to a fifth: its mean where the pilot is kept",
                        fmt::format("{:.3f}", sum.x));
    }
    text(svg, {535, 70}, "the pilot's samples", colored(small, red));
    text(svg, {535, 87}, "are kept", colored(small, red));
    text(svg, {535, 140}, "they are thrown away", colored(small, blue));
    text(svg, {300, 315}, "what part of the pixel is white", middle(small));
    text(svg, {24, 150}, "mean − truth", {.size = 13, .anchor = "middle", .turn = -90});
    write_svg(directory / "bias.svg", svg);
    write_file(directory / "bias.csv", csv);
}

// Sums --------------------------------------------------------------------------------------------------

__extension__ using Whole = __int128;

/// How far `mean` is from sum/count, relative, in units of 2^-53. `sum` counts units of 2^-56, of which every
/// number from 1/16 on is a multiple.
Real off(Real mean, long long count, Whole sum) {
    const Whole wrong = static_cast<Whole>(std::ldexp(mean, 56)) * count - sum;
    return std::abs(static_cast<Real>(wrong)) / static_cast<Real>(sum) * 0x1p53;
}

/// Errors of the means of up to 10^7 colours: of equal ones, and of random ones.
void draw_sums(const Path& directory) {
    struct Curve {
        const char* name;
        const char* color;
        std::vector<Vec2> points;
    };
    std::array<Curve, 3> curves{{{"plain, equal colours", red, {}},
                                 {"plain, random colours", orange, {}},
                                 {"Neumaier, either", blue, {}}}};
    const Real constant = 0.1;
    Real plain_equal = 0, plain_random = 0;
    float single = 0;
    FilmPixel kept_equal, kept_random;
    Whole exact_equal = 0, exact_random = 0;
    Random random = random_for(8, 0, 6);
    std::string csv =
        "samples,plain equal,plain random,neumaier equal,neumaier random,single precision plain equal\n";
    Real next = 10;
    std::array<Real, 4> worst{};
    Real worst_kept = 0;
    for (long long n = 1; n <= 10'000'000; ++n) {
        const Real value = random_real(random);
        const auto count = static_cast<Real>(n);
        plain_equal += constant;
        plain_random += value;
        single += static_cast<float>(constant);
        kept_equal = add(kept_equal, Vec3(constant), 1);
        kept_random = add(kept_random, Vec3(value), 1);
        exact_equal += static_cast<Whole>(std::ldexp(constant, 56));
        exact_random += static_cast<Whole>(std::ldexp(value, 56));
        const std::array<Real, 4> now{
            off(plain_equal / count, n, exact_equal), off(plain_random / count, n, exact_random),
            off(color_of(kept_equal).x, n, exact_equal), off(color_of(kept_random).x, n, exact_random)};
        for (std::size_t i = 0; i < 4; ++i) worst[i] = std::max(worst[i], now[i]);
        worst_kept = std::max({worst_kept, now[2], now[3]});
        if (count < next) continue;
        csv += fmt::format("{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g}\n", n, worst[0], worst[1], worst[2],
                           worst[3], single / (count * constant) - 1);
        curves[0].points.emplace_back(n, worst[0]);
        curves[1].points.emplace_back(n, worst[1]);
        curves[2].points.emplace_back(n, std::max(worst[2], worst[3]));
        worst = {};
        next *= std::pow(10, 0.25);
    }
    write_file(directory / "sums.csv", csv);
    numbers.add("worst compensated mean in units of 2^-53 of it", fmt::format("{:.2f}", worst_kept));
    numbers.add("single precision: equal samples are too bright by (percent)",
                fmt::format("{:.2f}", 100 * (single / (1e7 * constant) - 1)));

    Svg svg{.width = 700, .height = 330};
    const Plot plot{{80, 30}, {430, 240}, {10, 1e7, true}, {0.1, 1e7, true}};
    draw_axes(svg, plot, decades(1, 7), decades(-1, 7));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::vector<Vec2> places;
        for (const Vec2& p : curves[i].points) places.push_back(plot.place(p.x, std::max(p.y, 0.1)));
        polyline(svg, places, {.stroke = curves[i].color, .width = 2});
        text(svg, {525, 70 + 20 * static_cast<Real>(i)}, curves[i].name, colored(small, curves[i].color));
    }
    text(svg, {295, 315}, "samples in the sum", middle(small));
    text(svg, {24, 150}, "relative error, units of 2⁻⁵³", {.size = 13, .anchor = "middle", .turn = -90});
    write_svg(directory / "sums.svg", svg);
}

// Mistakes ----------------------------------------------------------------------------------------------

/// A star of 36 rays.
Vec3 star(const Vec2& p) {
    const Vec2 d = p - Vec2(49.3, 46.7);
    const Real turns = std::atan2(d.y, d.x) / (2 * pi) + 1;
    const bool ray = glm::length(d) < 42 && std::fmod(turns * 36, 1) < 0.5;
    return ray ? Vec3(0.02, 0.06, 0.16) : Vec3(0.78, 0.74, 0.62);
}

void draw_mistakes(const Path& directory) {
    const int size = 96;
    const Filter bell{FilterKind::Gaussian, 1.5};
    const Maker& right = jittered.samples;
    const auto same_everywhere = [&](int n, std::uint64_t) { return right(n, 7); };
    const Scenery dim = [](const Vec2& p) { return 0.55 * star(p); };
    std::vector<FilmSample> encoded = samples_of(dim, size, size, right, 16);
    for (FilmSample& sample : encoded)
        for (int i = 0; i < 3; ++i) sample.color[i] = encode(sample.color[i], Encoding::Srgb);
    Image by_encoded = filtered(encoded, size, size, {});
    for (Vec3& p : by_encoded.pixels)
        for (int i = 0; i < 3; ++i) p[i] = decode(p[i], Encoding::Srgb);
    const std::vector<FilmPixel> film =
        film_of(samples_of(dim, size, size, right, 16), bell, {0, 0, size, size});
    Image not_divided = make_image(size, size);
    for (std::size_t i = 0; i < film.size(); ++i) not_divided.pixels[i] = film[i].sum;
    const Panel good{picture(dim, size, size, right, 16, bell), "right"};
    write_svg(directory / "film_mistakes.svg",
              side_by_side({good, {not_divided, "not divided"}, {by_encoded, "bytes added up"}}, 3, 2));
    const auto upper_left = [](const Image& whole) {
        Image part = make_image(52, 52);
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) pixel(part, x, y) = pixel(whole, x + 4, y + 2);
        return part;
    };
    write_svg(
        directory / "same_numbers.svg",
        side_by_side({{upper_left(picture(star, size, size, right, 4)), "right"},
                      {upper_left(picture(star, size, size, same_everywhere, 4)), "the same in all pixels"}},
                     2, 5));
    numbers.add("the light of a mean of the bytes of black and white",
                fmt::format("{:.3f}", decode(0.5, Encoding::Srgb)));
}

// Adaptive ----------------------------------------------------------------------------------------------

/// The adaptive scene, where its samples go, and what is left without it: as the renderer decides it.
void draw_adaptive(const Path& directory) {
    constexpr int pilot = 7;  // of 24
    const World world = compile(scene_beside(__FILE__, "adaptive"));
    const int width = world.view.width, height = world.view.height;
    const std::vector<int> counts = render(world).counts;
    const int most = *std::ranges::max_element(counts), least = *std::ranges::min_element(counts);
    Image map = make_image(width, height);
    for (std::size_t i = 0; i < counts.size(); ++i) map.pixels[i] = Vec3(static_cast<Real>(counts[i]) / most);
    write_image(directory / "adaptive_counts.png", in_levels(map, 24));
    const auto flat = std::ranges::count(counts, least);

    // The same number of samples with and without, both against many.
    Scene scene = scene_beside(__FILE__, "adaptive", 160, 120);
    const auto image_of = [&](int count, bool adaptive) {
        scene.sampling.count = count;
        scene.sampling.adaptive = adaptive;
        scene.sampling.seed += 1;
        return render(compile(scene)).image;
    };
    const Image truth = image_of(1024, false);
    const int count = world.sampling.count;
    Real uniform = 0, adaptive = 0;
    for (int i = 0; i < 4; ++i) {
        uniform += test::rms_difference(image_of(count, false), truth) / 4;
        adaptive += test::rms_difference(image_of(count, true), truth) / 4;
    }
    write_file(directory / "adaptive.csv",
               fmt::format("samples a pixel,pilot,least,percent of the pixels with the least,most,rms error "
                           "uniform,adaptive\n"
                           "{},{},{},{:.1f},{},{:.5f},{:.5f}\n",
                           count, pilot, least, 100.0 * static_cast<Real>(flat) / (width * height), most,
                           uniform, adaptive));
}

// What half the error costs -----------------------------------------------------------------------------

/// How many samples a pixel a scene without filters or chance in its lights needs for two errors.
void count_for_errors() {
    for (const Sampler sampler : {Sampler::Jittered, Sampler::Random}) {
        Scene scene = scene_beside(__FILE__, "aliased", 80, 60);
        scene.sampling.sampler = sampler;
        const World world = compile(scene);
        std::array<Real, 2> needed{};
        const std::array<Real, 2> errors{0.01, 0.005};
        for (std::size_t i = 0; i < 2; ++i) {
            RenderOptions options;
            options.error = errors[i];
            needed[i] = render(world, options).samples_per_pixel;
        }
        const char* name = sampler == Sampler::Jittered ? "jittered" : "random";
        numbers.add(fmt::format("{}: for an error of 0.01 samples a pixel", name),
                    fmt::format("{:.0f}", needed[0]));
        numbers.add(fmt::format("{}: for an error of 0.005 samples a pixel", name),
                    fmt::format("{:.0f}", needed[1]));
        numbers.add(fmt::format("{}: how many times the samples for half the error", name),
                    fmt::format("{:.2f}", needed[1] / needed[0]));
    }
}

// Errors and costs --------------------------------------------------------------------------------------

struct Sampled {
    const char* name;
    Sampler sampler;
    int count;
    Method method;
};
const std::array<Sampled, 6> sampled{{{"random", Sampler::Random, 16, independent},
                                      {"regular", Sampler::Regular, 16, regular},
                                      {"Poisson disk", Sampler::Poisson, 16, poisson_disk},
                                      {"jittered", Sampler::Jittered, 16, jittered},
                                      {"trapezoid", Sampler::Trapezoid, 25, trapezoid},
                                      {"centred", Sampler::Centered, 17, centered}}};

/// The scene of the star with each of the patterns, at 160 × 120.
Scene star_scene(Sampler sampler, int count) {
    Scene scene = scene_beside(__FILE__, "regular", 160, 120);
    scene.sampling.count = count;
    scene.sampling.sampler = sampler;
    scene.sampling.seed = 1;
    scene.accelerator = AcceleratorChoice::None;
    return scene;
}

/// How wrong the scene is with each pattern: RMS over eight pictures of other seeds, which for patterns that
/// are not random are all the same one.
void write_picture_errors(const Path& directory) {
    Scene many = star_scene(Sampler::Jittered, 2048);
    many.sampling.seed = 100;
    RenderOptions plain;
    plain.estimate = false;
    const Image truth = render(compile(many), plain).image;
    std::string csv = "sampler,samples,rms error,its estimate\n";
    for (const Sampled& one : sampled) {
        Real squares = 0, estimated_squares = 0;
        for (int seed = 1; seed <= 8; ++seed) {
            Scene scene = star_scene(one.sampler, one.count);
            scene.sampling.seed = static_cast<std::uint64_t>(seed);
            const RenderResult result = render(compile(scene));
            const Real error = test::rms_difference(result.image, truth), said = result.rms_error.value_or(0);
            squares += error * error / 8;
            estimated_squares += said * said / 8;
        }
        csv += fmt::format("{},{},{:.4f},{:.4f}\n", one.name, one.count, std::sqrt(squares),
                           std::sqrt(estimated_squares));
    }
    write_file(directory / "picture_errors.csv", csv);
}

/// What making patterns costs, and what a sample of a picture with them costs in all: the least of several,
/// because a busy machine only ever adds to it.
void measure_costs(const Path& directory) {
    std::array<double, sampled.size()> making{}, drawing{};
    making.fill(1e30);
    drawing.fill(1e30);
    std::vector<World> worlds;
    for (const Sampled& one : sampled) worlds.push_back(compile(star_scene(one.sampler, one.count)));
    RenderOptions plain;
    plain.threads = 1;
    plain.estimate = false;
    for (int round = 0; round < 15; ++round)
        for (std::size_t i = 0; i < sampled.size(); ++i) {
            const Sampled& one = sampled[i];
            const double pixels = 160 * 120;
            const double cpu = render(worlds[i], plain).cpu_seconds;
            drawing[i] = std::min(drawing[i], 1e9 * cpu / (pixels * one.count));
            std::size_t made = 0;
            const Stopwatch watch;
            const std::uint64_t patterns = one.sampler == Sampler::Poisson ? 200 : 5000;
            for (std::uint64_t k = 0; k < patterns; ++k)
                made += one.sampler == Sampler::Poisson
                            ? poisson_disk_samples(one.count, random_for(8, k, 9)).samples.size()
                            : one.method.samples(one.count, k).size();
            making[i] = std::min(making[i], 1e9 * watch.seconds() / static_cast<double>(made));
        }
    std::string csv = "sampler,samples,ns a sample to make the pattern,ns a sample of the picture in all\n";
    for (std::size_t i = 0; i < sampled.size(); ++i)
        csv += fmt::format("{},{},{:.0f},{:.0f}\n", sampled[i].name, sampled[i].count, making[i], drawing[i]);
    write_file(directory / "measured_costs.csv", csv);
    std::cout << csv;
}

void draw_all(const Path& directory) {
    draw_patterns(directory);
    draw_alias(directory);
    draw_edge(directory);
    draw_zone_plate(directory);
    draw_filters(directory);
    draw_spectra(directory);
    draw_error(directory);
    write_estimates(directory);
    draw_bias(directory);
    draw_sums(directory);
    draw_mistakes(directory);
    draw_adaptive(directory);
    draw_scenes(directory, __FILE__,
                {"aliased", "random", "regular", "poisson", "trapezoid", "centered", "jittered", "filters"},
                240, 180);
    draw_scenes(directory, __FILE__, {"adaptive"});
    count_for_errors();
    write_picture_errors(directory);
    numbers.write(directory);
    measure_costs(directory);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw_all); }
