// Figures of chapter 12. Usage: figures_12 DIRECTORY
#include "references/figures.hpp"
#include "chapters/11_textures/microfacet.hpp"
#include "chapters/12_distribution/area_light.hpp"
#include "chapters/12_distribution/glossy.hpp"
#include "chapters/12_distribution/lambert_polygon.hpp"
#include "chapters/12_distribution/lens.hpp"
#include "chapters/12_distribution/rectangle_light.hpp"
#include "references/12_distribution/slopes.hpp"
#include "tests/pictures.hpp"
#include "tests/stability/blurs.hpp"

#include <bit>
#include <set>
#include <span>

using namespace rt;
using rt::figures::Path;

namespace {

using namespace figures;

// ------------------------------------------------------------------------------------------------- nets

/// 16 points in the five shapes of 16 strata, and the strata that have no point: Sobol' points, jittered
/// ones.
Svg nets() {
    Svg svg{900, 430};
    std::array<std::vector<Vec2>, 2> points;
    for (std::uint32_t i = 0; i < 16; ++i) {
        points[0].push_back(sobol_point(i, 6));
        points[1].push_back(stratified_point(i, 16, 6));
    }
    text(svg, {10, 24}, "scrambled Sobol' points", anchored(heading, "start"));
    text(svg, {10, 234}, "jittered points", anchored(heading, "start"));
    for (std::size_t row = 0; row < 2; ++row)
        for (int shape = 0; shape < 5; ++shape) {
            const Vec2 corner(10 + 178 * shape, row == 0 ? 36 : 246);
            const int columns = 1 << shape, rows = 16 >> shape;
            const Vec2 cell(160.0 / columns, 160.0 / rows);
            std::vector<int> inside(16, 0);
            for (const Vec2& p : points[row])
                ++inside[static_cast<std::size_t>(static_cast<int>(p.y * rows) * columns +
                                                  static_cast<int>(p.x * columns))];
            for (int i = 0; i < 16; ++i)
                rectangle(svg, corner + Vec2(i % columns, i / columns) * cell, cell,
                          {.stroke = grey,
                           .width = 0.7,
                           .fill = inside[static_cast<std::size_t>(i)] == 0 ? "#f6d5bf" : "none"});
            for (const Vec2& p : points[row]) dot_at(svg, corner + 160.0 * p, blue, 3);
        }
    return svg;
}

/// In how many of the eight possible ways the first three coins fall, and how often each of them is heads:
/// Burley's hash with his constants, and a hash for each coin.
std::string coins() {
    const auto reversed = [](std::uint32_t bits) {
        std::uint32_t result = 0;
        for (int i = 0; i < 32; ++i) result = result << 1 | (bits >> i & 1);
        return result;
    };
    const auto burley = [&](std::uint32_t bits, std::uint64_t key) {
        std::uint32_t x = reversed(bits) + static_cast<std::uint32_t>(key);
        for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u})
            x ^= x * factor;
        return reversed(x);
    };
    std::string text = "way,keys,ways of three coins\n";
    const auto add = [&](const char* name, auto scrambled) {
        std::set<std::uint32_t> ways;
        for (std::uint64_t key = 1; key <= 100'000; ++key) {
            // Of 0 the first two coins, of ½ the third one.
            const std::uint32_t low = scrambled(0, stirred(key)), high = scrambled(0x80000000u, stirred(key));
            ways.insert((low >> 30) << 1 | (high >> 30 & 1));
        }
        text += fmt::format("{},100000,{}\n", name, ways.size());
    };
    add("Burley 2020", burley);
    add("12.4", owen_scrambled);
    return text;
}

// ------------------------------------------------------------------------------------------------- lens

Vec2 polar(const Vec2& random) {
    return std::sqrt(random.x) * Vec2(std::cos(2 * pi * random.y), std::sin(2 * pi * random.y));
}
Vec2 crowded(const Vec2& random) {
    return random.x * Vec2(std::cos(2 * pi * random.y), std::sin(2 * pi * random.y));
}

/// 8 × 8 strata of the square, each with its point, as they come to the disc by three maps.
Svg disc_maps() {
    Svg svg{900, 260};
    const auto panel = [&](Real left, const char* title, auto map) {
        text(svg, {left + 105, 24}, title, heading);
        const auto place = [&](Real a, Real b) {
            const Vec2 p = map(Vec2(a, b));
            return Vec2(left + 105 + 100 * p.x, 145 - 100 * p.y);
        };
        for (int cell = 0; cell < 64; ++cell) {
            const Real x = cell % 8 / 8.0, y = cell / 8 / 8.0;
            std::vector<Vec2> rim;
            for (int side = 0; side < 4; ++side)
                for (int i = 0; i < 5; ++i) {
                    const Real t = i / 40.0;
                    const Vec2 at = side == 0   ? Vec2(t, 0)
                                    : side == 1 ? Vec2(0.125, t)
                                    : side == 2 ? Vec2(0.125 - t, 0.125)
                                                : Vec2(0, 0.125 - t);
                    rim.push_back(place(x + at.x, y + at.y));
                }
            polygon(svg, rim,
                    {.stroke = grey, .width = 0.7, .fill = (cell + cell / 8) % 2 == 0 ? light : "none"});
        }
        for (std::uint32_t i = 0; i < 64; ++i) {
            const Vec2 p = stratified_point(i, 64, 12);
            dot_at(svg, place(p.x, p.y), blue, 2.2);
        }
    };
    panel(10, "the square", [](const Vec2& p) { return 2.0 * p - Vec2(1); });
    panel(233, "radius x", crowded);
    panel(456, "radius √x", polar);
    panel(679, "concentric", disc_point);
    return svg;
}

// ----------------------------------------------------------------------------------------------- lights

/// 256 samples of a rectangle close above the viewer, by area and by angle: where they are on the light, and
/// in the half sphere of directions, which is shown so that equal solid angles are equal areas.
Svg light_points() {
    Svg svg{720, 500};
    const QuadLight lamp{Vec3(-1, -0.8, 0.5), Vec3(3, 0, 0), Vec3(0, 1.6, 0)};
    const Vec3 from(0);
    const auto panel = [&](Real left, const char* title, auto direction_for) {
        text(svg, {left + 170, 24}, title, heading);
        const Vec2 corner(left + 20, 40);
        rectangle(svg, corner, {300, 160}, {.stroke = grey});
        const auto on_lamp = [&](const Vec3& p) { return corner + 100.0 * Vec2(p.x + 1, 0.8 - p.y); };
        const Vec2 middle_point(left + 170, 350);
        circle(svg, middle_point, 130, {.stroke = grey});
        const auto in_sky = [&](const Vec3& d) {
            return middle_point + 130 / std::sqrt(1 + d.z) * Vec2(d.x, -d.y);
        };
        std::vector<Vec2> rim;
        for (int i = 0; i < 128; ++i) {
            const Real t = i % 32 / 32.0;
            const Vec3 a = lamp.corner, ab = lamp.ab, ac = lamp.ac;
            const Vec3 at = i < 32   ? a + t * ab
                            : i < 64 ? a + ab + t * ac
                            : i < 96 ? a + (1 - t) * ab + ac
                                     : a + (1 - t) * ac;
            rim.push_back(in_sky(glm::normalize(at - from)));
        }
        polygon(svg, rim, {.stroke = grey, .fill = light});
        for (std::uint32_t i = 0; i < 256; ++i) {
            const std::optional<LightDirection> found = direction_for(stratified_point(i, 256, 3));
            if (!found) continue;
            dot_at(svg, on_lamp(from + found->distance * found->direction), blue, 2);
            dot_at(svg, in_sky(found->direction), blue, 2);
        }
        line(svg, on_lamp(Vec3(-0.1, 0, 0)), on_lamp(Vec3(0.1, 0, 0)), {.stroke = red, .width = 3});
        line(svg, on_lamp(Vec3(0, -0.1, 0)), on_lamp(Vec3(0, 0.1, 0)), {.stroke = red, .width = 3});
        text(svg, {left + 20, 217}, "on the lamp");
        text(svg, {left + 20, 492}, "in the hemisphere");
    };
    panel(10, "by area", [&](const Vec2& random) { return seen_from(point_on(lamp, random), from); });
    panel(370, "by angle", [&](const Vec2& random) { return toward(lamp, from, random); });
    return svg;
}

/// Medians of the relative error of a square lamp's irradiance far away, against the inverse square law,
/// which is right to 1/distance².
std::string small_lamps() {
    const std::array<Vec3, 4> corners{Vec3(-0.5, -0.5, 0), Vec3(-0.5, 0.5, 0), Vec3(0.5, 0.5, 0),
                                      Vec3(0.5, -0.5, 0)};
    enum Way { Acos, FarEnd, Edge };
    const auto vector_by = [&](Way way, const Vec3& point) {
        if (way == Edge) return lambert_vector(corners, point);
        Vec3 sum(0);
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 u = glm::normalize(corners[k] - point),
                       w = glm::normalize(corners[(k + 1) % 4] - point);
            const Vec3 across = cross(u, w);
            const Real size = length(across);
            if (!(size > 0)) continue;
            const Real theta =
                way == Acos ? std::acos(std::min(dot(u, w), Real(1))) : std::atan2(size, dot(u, w));
            sum += theta / size * across / 2.0;
        }
        return sum;
    };
    std::string text = "distance in sides,acos,atan2 of unit vectors,atan2 of the edge\n";
    for (const Real distance : {1e3, 1e5, 1e7}) {
        std::array<std::vector<Real>, 3> errors;
        for (std::uint64_t i = 0; i < 10'000; ++i) {
            std::uint64_t use = 0;
            const auto next = [&] { return real_of(mixed(mixed(77, i), use++)); };
            const Real z = 0.2 + 0.8 * next(), phi = 2 * pi * next(), r = std::sqrt(1 - z * z);
            const Vec3 away(r * std::cos(phi), r * std::sin(phi), z);
            // A surface that is turned to the lamp by at least a third of a right angle.
            const Vec3 normal = around_axis(-away, 3, Vec2(0.9 * next(), next()));
            const Real exact = z * dot(normal, -away) / (distance * distance);
            for (const Way way : {Acos, FarEnd, Edge})
                errors[way].push_back(
                    std::abs(std::abs(dot(vector_by(way, distance * away), normal)) / exact - 1));
        }
        const auto median = [](std::vector<Real>& all) {
            std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2),
                             all.end());
            return all[all.size() / 2];
        };
        text += fmt::format("{:.0e},{:.1g},{:.1g},{:.1g}\n", distance, median(errors[Acos]),
                            median(errors[FarEnd]), median(errors[Edge]));
    }
    return text;
}

// ------------------------------------------------------------------------------------------------ gloss

/// Samples of white facets of α = ½ that are lost, and their greatest weight: drawn as they are, and as they
/// are seen.
std::string facets() {
    const int samples = 100'000;
    std::string text = "viewer and way,samples,lost percent,greatest weight\n";
    for (const Real degrees : {0.0, 60.0, 85.0}) {
        const Vec3 v(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
        const auto add = [&](const char* name, const auto& lobe) {
            int lost = 0;
            Real greatest = 0;
            for (std::uint64_t i = 0; i < samples; ++i) {
                const std::uint64_t key = mixed(12, i);
                const Vec3 random(real_of(mixed(key, 0)), real_of(mixed(key, 1)), real_of(mixed(key, 2)));
                const std::optional<LobeSample> drawn = sample(lobe, v, random);
                if (drawn)
                    greatest = std::max(greatest, max_component(drawn->weight));
                else
                    ++lost;
            }
            text += fmt::format("{} degrees {},{},{:.0f},{:.2g}\n", degrees, name, samples,
                                100.0 * lost / samples, greatest);
        };
        add("all facets", DiffuseGgx{Vec3(0), Vec3(1), 0.5});
        add("visible facets", RoughMetal{Vec3(1), std::sqrt(0.5)});
    }
    return text;
}

/// Numbers in the texts: how well the slopes are known; degrees within which half of a lobe is; and what a
/// sample counts that the ground draws in the highlight, if it is divided by the ground's density alone.
Numbers lesson_numbers(const slopes::Errors& errors) {
    Real widest = 0;
    for (const auto& of_method : errors)
        for (const auto& squares : of_method) widest = std::max(widest, slopes::plus_minus(squares));
    Numbers numbers;
    numbers.add("slopes are known to", fmt::format("{:.2f}", widest));
    for (const Real exponent : {0.0, 10.0, 100.0})
        numbers.add(fmt::format("half of the lobe {}", exponent),
                    fmt::format("{:.1f}", 180 / pi * std::acos(std::pow(0.5, 1 / (exponent + 1)))));
    const Vec3 v(-0.6, 0, 0.8), l(0.6, 0, 0.8);
    const ModifiedPhong shiny{Vec3(0.3), Vec3(0.6), 1000};
    numbers.add("ground in the highlight", fmt::format("{:.0f}", pi * evaluate(shiny, l, v).x));
    return numbers;
}

// ------------------------------------------------------------------------------------------------ costs

/// The billiard table, small, with some of its blurs.
Scene billiards(const test::Blurs& blurs) {
    return test::with_blurs(scene_beside(__FILE__, "billiards", 60, 40), blurs);
}

RenderResult plainly_rendered(const Scene& scene) {
    RenderOptions options;
    options.estimate = false;
    return render(compile(scene), options);
}

struct Cost {
    Real camera = 0, shadow = 0, mirrored = 0;  ///< rays a pixel
    Real error = 0;                             ///< RMS, of several pictures with different random numbers
};

Cost cost_of(Scene scene, const Image& truth, int samples, int lamp_samples) {
    scene.sampling.count = samples;
    scene.light_samples.count = lamp_samples;
    scene.light_samples.stratified = true;
    const int pictures = 4;
    const Real pixels = scene.width * scene.height * pictures;
    Cost cost;
    for (int i = 1; i <= pictures; ++i) {
        scene.sampling.seed = static_cast<std::uint64_t>(i);
        const RenderResult result = plainly_rendered(scene);
        cost.camera += static_cast<Real>(result.rays.camera) / pixels;
        cost.shadow += static_cast<Real>(result.rays.shadow) / pixels;
        cost.mirrored += static_cast<Real>(result.rays.reflection + result.rays.refraction) / pixels;
        const Real error = test::rms_difference(result.image, truth);
        cost.error += error * error / pictures;
    }
    cost.error = std::sqrt(cost.error);
    return cost;
}

Image converged(Scene scene) {
    scene.sampling.count = 1024;
    return plainly_rendered(scene).image;
}

/// What each blur costs alone, and all of them together; then all of them with more shadow rays a hit and
/// fewer camera rays.
void write_costs(const Path& out) {
    std::string text = "what blurs,samples,camera,mirrored,shadow,rays a pixel,RMS error\n";
    const auto add = [&](const char* name, const Scene& scene, const Image& truth) {
        const Cost cost = cost_of(scene, truth, 16, 1);
        text += fmt::format("{},16,{:.1f},{:.1f},{:.1f},{:.1f},{:.4f}\n", name, cost.camera, cost.mirrored,
                            cost.shadow, cost.camera + cost.mirrored + cost.shadow, cost.error);
    };
    const auto add_alone = [&](const char* name, const test::Blurs& blurs) {
        const Scene scene = billiards(blurs);
        add(name, scene, converged(scene));
    };
    add_alone("nothing", {});
    add_alone("the lens", {.lens = true});
    add_alone("motion", {.motion = true});
    add_alone("the lamps", {.lamps = true});
    add_alone("gloss", {.gloss = true});
    const Scene scene = billiards({true, true, true, true});
    const Image truth = converged(scene);
    add("all four", scene, truth);
    write_file(out / "costs.csv", text);

    text = "samples a pixel and shadow rays to each lamp,rays a pixel,RMS error\n";
    for (const auto& [samples, lamp_samples] : {std::pair{16, 1}, {4, 4}, {16, 16}}) {
        const Cost cost = cost_of(scene, truth, samples, lamp_samples);
        text += fmt::format("{} and {},{:.1f},{:.4f}\n", samples, lamp_samples,
                            cost.camera + cost.mirrored + cost.shadow, cost.error);
    }
    write_file(out / "nesting.csv", text);
}

// --------------------------------------------------------------------------------------------- figures

/// Scenes whose 8-bit pictures store a power of the light, as `course render` does.
void draw_with_gamma(const Path& out, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        const Scene scene = scene_beside(__FILE__, name);
        Image image = render(compile(scene)).image;
        for (Vec3& pixel : image.pixels) pixel = glm::pow(glm::max(pixel, Vec3(0)), Vec3(1 / scene.gamma));
        write_image(out / (std::string(name) + ".png"), image, scene.encoding);
    }
}

void draw_all(const Path& out) {
    const slopes::Errors errors = slopes::measured();
    write_file(out / "slopes.csv", slopes::table(errors));
    write_file(out / "error_slopes.csv", slopes::lesson_table(errors));
    write_svg(out / "slopes.svg", slopes::curves(errors));
    write_file(out / "blocks.csv", slopes::blocks());
    write_file(out / "coins.csv", coins());
    write_svg(out / "nets.svg", nets());
    write_svg(out / "disc_maps.svg", disc_maps());
    write_svg(out / "light_points.svg", light_points());
    write_file(out / "small_lamps.csv", small_lamps());
    write_file(out / "facets.csv", facets());
    lesson_numbers(errors).write(out);
    write_costs(out);
    draw_scenes(out, __FILE__,
                {"billiards", "soft_shadow", "lamps", "lanterns", "depth", "focus", "moving", "turning",
                 "gloss", "frosted"});
    draw_with_gamma(out, {"analytic", "highlights", "direct"});
}

}  // namespace

int main(int argc, char** argv) { return figures::draw_figures(argc, argv, draw_all); }
