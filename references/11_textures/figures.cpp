// Figures of chapter 11, and the pictures that its scenes lay on things. Usage: figures_11 DIRECTORY
#include "references/figures.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/07_recursion/optics.hpp"
#include "chapters/11_textures/bump.hpp"
#include "chapters/11_textures/cells.hpp"
#include "chapters/11_textures/footprint.hpp"
#include "chapters/11_textures/harmonics.hpp"
#include "chapters/11_textures/image_texture.hpp"
#include "chapters/11_textures/mip_map.hpp"
#include "chapters/11_textures/pattern.hpp"
#include "chapters/11_textures/sky.hpp"
#include "chapters/11_textures/texture_coordinates.hpp"
#include "common/image/compare.hpp"
#include "references/11_textures/lobe_figures.hpp"
#include "references/11_textures/texture_pictures.hpp"
#include "references/panels.hpp"
#include "tests/pictures.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

using namespace rt;
using rt::figures::Path;

namespace {

using namespace figures;

/// Scenes find them beside themselves, in the folder of figures.
void draw_texture_pictures(const Path& out) {
    write_image(out / "map.png", map_picture());
    write_image(out / "bricks.png", bricks_picture());
    write_image(out / "earth.png", earth_picture());
    write_png16(out / "sunset.png", sunset_picture());
}

// ------------------------------------------------------------------------------- affine and perspective

/// The weights of the corners a, b, c of a triangle of the screen at p; nothing outside of it.
std::optional<Vec3> weights_in(const std::array<Vec2, 3>& corners, const Vec2& p) {
    const auto area = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const auto& [a, b, c] = corners;
    const Vec3 parts = Vec3(area(b, c, p), area(c, a, p), area(a, b, p)) / area(a, b, c);
    if (parts.x < 0 || parts.y < 0 || parts.z < 0) return std::nullopt;
    return parts;
}

/// A tiled floor of two triangles, its texture linear on the screen or right in perspective.
Image floor_of_two_triangles(bool is_right) {
    const std::array<Vec3, 4> corners = {Vec3(-1.1, -1, -1.3), Vec3(1.1, -1, -1.3), Vec3(1.1, -1, -6),
                                         Vec3(-1.1, -1, -6)};
    const std::array<Vec2, 4> uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 2), Vec2(0, 2)};
    const Image picture = map_picture();
    Image image = make_image(280, 200);
    for (Vec3& p : image.pixels) p = Vec3(0.55, 0.62, 0.7);
    const auto on_screen = [](const Vec3& p) { return Vec2(140 - 150 * p.x / p.z, 10 + 150 * p.y / p.z); };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const std::array<std::size_t, 3>& face : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
                std::array<Vec2, 3> screen, uv;
                Vec3 depths(0);
                for (int i = 0; i < 3; ++i) {
                    const std::size_t corner = face[static_cast<std::size_t>(i)];
                    screen[static_cast<std::size_t>(i)] = on_screen(corners[corner]);
                    uv[static_cast<std::size_t>(i)] = uvs[corner];
                    depths[i] = -corners[corner].z;
                }
                const std::optional<Vec3> weights = weights_in(screen, Vec2(x + 0.5, y + 0.5));
                if (!weights) continue;
                const Vec2 at = is_right ? perspective_uv(uv, depths, *weights) : affine_uv(uv, *weights);
                pixel(image, x, y) = bilinear(picture, at, Wrap::Repeat);
                break;
            }
    return image;
}

// ----------------------------------------------------------------------------------- texels and levels

/// A few texels of the earth, far too near.
Image magnified(bool smooth) {
    const Image small = mip_map(earth_picture()).levels[4];  // 32 × 16
    Image image = make_image(280, 160);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Vec2 uv(0.3 + 0.45 * (x + 0.5) / image.width, 0.3 + 0.5 * (1 - (y + 0.5) / image.height));
            pixel(image, x, y) = (smooth ? bilinear : nearest)(small, uv, Wrap::Repeat);
        }
    return image;
}

/// The levels of a mip map beside each other, the first five with their numbers.
Svg levels() {
    const std::vector<Image> levels = mip_map(map_picture()).levels;
    const Real top = 30, gap = 6;
    Svg svg{.width = 2 * levels[0].width + 64, .height = levels[0].height + 36};
    Vec2 corner(gap, top);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        corner.y = top + levels[0].height - levels[k].height;
        picture(svg, corner, levels[k]);
        if (k < 5) text(svg, corner + Vec2(levels[k].width / 2.0, -8), std::to_string(k), heading);
        corner.x += levels[k].width + gap;
    }
    return svg;
}

// -------------------------------------------------------------------------------------------- patterns

/// Grey by a value at each point of a square of space, z = 0, `size` units wide.
template <class ValueAt>
Image slice(Real size, ValueAt value_at) {
    Image image = make_image(180, 180);
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 180; ++x)
            pixel(image, x, y) = Vec3(value_at(Vec3(x + 0.5, 179.5 - y, 63) / 180.0 * size));
    return image;
}

Svg slices() {
    const auto of = [](PatternKind kind) { return [kind](const Vec3& p) { return pattern_value(kind, p); }; };
    return side_by_side({{slice(8, [](const Vec3& p) { return 0.5 + 0.5 * noise(p); }), "noise"},
                         {slice(4, [](const Vec3& p) { return 0.7 * turbulence(p, 6); }), "turbulence"},
                         {slice(6, of(PatternKind::Marble)), "marble"},
                         {slice(30, of(PatternKind::Wood)), "wood"},
                         {slice(8, [](const Vec3& p) { return 0.8 * cell_distances(p).first; }), "F1"},
                         {slice(8, of(PatternKind::Cellular)), "cells"}},
                        3);
}

/// Noise whose weights are linear in the offset.
Real noise_without_fade(const Vec3& p) {
    const auto [corner, offset] = lattice_cell(p);
    Real sum = 0;
    for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        const Vec3 way = offset - Vec3(i, j, k), nearness = Real(1) - glm::abs(way);
        const Vec3 gradient = lattice_gradient(corner[0] + i, corner[1] + j, corner[2] + k);
        sum += nearness.x * nearness.y * nearness.z * dot(gradient, way);
    }
    return sum;
}

/// A sheet with the heights of a function of space, in slanting light; five cells wide.
template <class HeightAt>
Image sheet(HeightAt height_at) {
    const Vec3 to_light = normalize(Vec3(-1, 0.6, 0.8));
    Image image = make_image(240, 180);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Vec3 p(x / 48.0 + 3.02, 8 - y / 48.0, 2.3), right(1e-4, 0, 0), up(0, 1e-4, 0);
            const Vec3 gradient(height_at(p + right) - height_at(p - right),
                                height_at(p + up) - height_at(p - up), 0);
            const Vec3 normal = bumped(Vec3(0, 0, 1), gradient / 2e-4 * 0.7);
            pixel(image, x, y) = Vec3(0.9, 0.86, 0.8) * std::max(dot(normal, to_light), Real(0));
        }
    return image;
}

Svg creases() {
    return side_by_side({{sheet(noise_without_fade), "linear: creases"},
                         {sheet([](const Vec3& p) { return noise(p); }), "fade: smooth"}},
                        2);
}

// ----------------------------------------------------------------------------------------------- bumps

/// A normal that mirrors the viewer's ray into the surface, and the one to which it is led back; angles in
/// degrees from the geometric normal.
std::string led_back() {
    const auto leant = [](Real degrees) {
        return Vec3(std::sin(radians(degrees)), std::cos(radians(degrees)), 0);
    };
    const Real toward = 45, away = 30;
    const Vec3 geometric = leant(0), viewer = leant(toward), shading = leant(-away);
    const Vec3 kept = kept_visible(shading, geometric, viewer);
    const auto rise = [&](const Vec3& n) { return dot(reflect(-viewer, n), geometric); };
    return fmt::format(
        "viewer,normal_leans_away_by,mirrored_ray_goes_down_by,led_back_to,viewer_is_higher_than_mirrored_"
        "ray\n"
        "{},{},{:.2f},{:.1f},{:.3g}\n",
        toward, away, -rise(shading), -std::atan2(kept.x, kept.y) * 180 / pi,
        dot(viewer, geometric) / rise(kept));
}

// ------------------------------------------------------------------------------------------------- sky

/// The same sky in each of the three layouts.
Svg sky_maps() {
    const Sky sky = ImageSky{std::make_shared<const Image>(sunset_picture())};
    const auto in = [&](SkyMap map) {
        return picture_from(180, 180, [&](Real u, Real v) {
            const std::optional<Vec3> direction = sky_direction(map, {u, v});
            return direction ? sky_radiance(sky, *direction) : Vec3(1);
        });
    };
    return side_by_side({{in(SkyMap::LatitudeLongitude), "world"},
                         {in(SkyMap::Angular), "light probe"},
                         {in(SkyMap::MirrorBall), "mirrored ball"}},
                        3);
}

/// E(n)/π as the sum over all pixels of the sky.
Vec3 summed_irradiance(const Image& sky, const Vec3& normal) {
    Vec3 sum(0);
    for (int y = 0; y < sky.height; ++y) {
        const Real top = pi / 2 - pi * y / sky.height, bottom = pi / 2 - pi * (y + 1) / sky.height;
        const Real angle = 2 * pi / sky.width * (std::sin(top) - std::sin(bottom));
        for (int x = 0; x < sky.width; ++x) {
            const Vec2 uv((x + 0.5) / sky.width, 1 - (y + 0.5) / sky.height);
            const Real cosine = dot(normal, *sky_direction(SkyMap::LatitudeLongitude, uv));
            if (cosine > 0) sum += cosine * angle * pixel(sky, x, y);
        }
    }
    return sum / pi;
}

/// A sky whose light is all in one pixel.
Image one_point_of_light() {
    Image image = make_image(64, 32);
    pixel(image, 40, 9) = Vec3(90, 80, 60);
    return image;
}

/// White balls under a sky: by the sum over the sky, by nine numbers, and eight times the difference.
std::array<Image, 3> balls_under(const Image& sky) {
    const SkyLight light = projected(sky);
    std::array<Image, 3> images;
    images.fill(make_image(150, 150));
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 150; ++x) {
            const Vec2 at((x - 74.5) / 72, (74.5 - y) / 72);
            if (dot(at, at) >= 1) continue;
            const Vec3 normal(at, std::sqrt(1 - dot(at, at)));
            const Vec3 summed = summed_irradiance(sky, normal), nine = irradiance(light, normal) / pi;
            pixel(images[0], x, y) = summed, pixel(images[1], x, y) = nine;
            pixel(images[2], x, y) = 8.0 * glm::abs(nine - summed);
        }
    return images;
}

/// Such balls under two skies, a row each.
Svg balls() {
    std::vector<Panel> panels;
    for (const Image& sky : {halved(halved(sunset_picture())), one_point_of_light()}) {
        const auto [summed, nine, error] = balls_under(sky);
        panels.insert(panels.end(), {{summed, "all pixels"}, {nine, "nine numbers"}, {error, "error × 8"}});
    }
    return side_by_side(panels, 3);
}

/// How wrong nine numbers are, over all normals, as a part of what arrives at most.
std::string nine_numbers() {
    std::string text = "sky,greatest_error,percent_of_the_greatest_irradiance\n";
    const auto add = [&](const char* name, const Image& sky) {
        const SkyLight light = projected(sky);
        Real error = 0, most = 0;
        for (int i = 0; i < 2000; ++i) {
            // Points that are spread over the sphere evenly (a spiral).
            const Real z = 1 - (2 * i + 1) / 2000.0, angle = i * 2.399963229728653;
            const Vec3 n(std::sqrt(1 - z * z) * Vec2(std::cos(angle), std::sin(angle)), z);
            const Vec3 exact = summed_irradiance(sky, n);
            error = std::max(error, max_component(glm::abs(irradiance(light, n) / pi - exact)));
            most = std::max(most, max_component(exact));
        }
        text += fmt::format("{},{:.2g},{:.1f}\n", name, error, 100 * error / most);
    };
    add("sunset", halved(halved(sunset_picture())));
    add("gradient",
        sky_picture(GradientSky{Vec3(0.25, 0.45, 0.9), Vec3(0.85, 0.8, 0.7), Vec3(0.3, 0.22, 0.12)}, 64, 32));
    add("one point of light", one_point_of_light());
    return text;
}

// ------------------------------------------------------------------------------------------ footprints

/// The scene of a floor to the horizon by a filter, with this many samples a pixel.
Scene horizon(TextureFilter filter, int samples, int width, int height) {
    Scene scene = scene_beside(__FILE__, "horizon", width, height);
    for (Texturing& texturing : scene.texturings)
        if (texturing.picture) texturing.picture->filter = filter;
    scene.sampling.count = samples;
    return scene;
}

Image picture_of(const Scene& scene) { return render(compile(scene)).image; }

Svg ways_to_the_horizon() {
    const auto by = [](TextureFilter filter, int samples) {
        return picture_of(horizon(filter, samples, 280, 210));
    };
    return side_by_side({{by(TextureFilter::Bilinear, 1), "bilinear"},
                         {by(TextureFilter::Trilinear, 1), "trilinear"},
                         {by(TextureFilter::Anisotropic, 1), "anisotropic"},
                         {by(TextureFilter::Bilinear, 256), "bilinear, 256 samples"}},
                        2);
}

/// How wrong the picture of the floor alone is by each filter, against 1024 samples a pixel.
std::string filter_errors() {
    const int width = 80, height = 60;
    const auto picture_by = [&](TextureFilter filter, int samples) {
        Scene scene = horizon(filter, samples, width, height);
        std::erase_if(scene.objects, [](const Object& object) {
            return std::holds_alternative<Sphere>(object.shape);  // its outline would hide the difference
        });
        return picture_of(scene);
    };
    const Image truth = picture_by(TextureFilter::Bilinear, 1024);
    std::string text = "samples a pixel × filter,root of the mean square error\n";
    const auto add = [&](const char* name, TextureFilter filter, int samples) {
        const Image seen = picture_by(filter, samples);
        text += fmt::format("{} × {},{:.4f}\n", samples, name, test::rms_difference(seen, truth));
    };
    add("bilinear", TextureFilter::Bilinear, 1);
    add("bilinear", TextureFilter::Bilinear, 4);
    add("bilinear", TextureFilter::Bilinear, 16);
    add("trilinear", TextureFilter::Trilinear, 1);
    add("anisotropic", TextureFilter::Anisotropic, 1);
    add("anisotropic", TextureFilter::Anisotropic, 4);
    return text;
}

// ----------------------------------------------------------------------------------------------- cells

/// How often the 27 cubes around a point are not enough for the nearest and the second nearest of the points.
std::string cells_missed() {
    const int places = 2'000'000;
    test::Random random(11);
    int first = 0, second = 0;
    for (int i = 0; i < places; ++i) {
        const Vec3 q = 100.0 * random.in_cube(), corner = glm::floor(q);
        Real nearest = infinity, next = infinity;
        for (int cube = 0; cube < 27; ++cube) {
            const Vec3 cell = corner + Vec3(cube % 3 - 1, cube / 3 % 3 - 1, cube / 9 - 1);
            const Real distance = length(cell + cell_point(cell) - q);
            next = std::min(next, std::max(nearest, distance));
            nearest = std::min(nearest, distance);
        }
        const CellDistances right = cell_distances(q);
        first += nearest > right.first * (1 + 1e-9), second += next > right.second * (1 + 1e-9);
    }
    return fmt::format("places,nearest_wrong,second_wrong\n{},{},{}\n", places, first, second);
}

// --------------------------------------------------------------------------------------- single numbers

/// What the lesson says in its sentences.
Numbers lesson_numbers() {
    Numbers numbers;
    const Vec3 flat = from_normal_map(Vec3(128, 128, 255) / 255.0, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    numbers.add("lean of a flat normal map in degrees",
                fmt::format("{:.2f}", std::atan2(std::hypot(flat.x, flat.y), flat.z) * 180 / pi));

    Scene scene = horizon(TextureFilter::Nearest, 512, 80, 60);
    scene.sampling.seed = 1'000'000;
    const Image truth = picture_of(scene);
    const RenderResult seen = render(compile(horizon(TextureFilter::Anisotropic, 16, 80, 60)));
    numbers.add("stated error of 16 anisotropic samples", fmt::format("{:.4f}", seen.rms_error.value_or(0)));
    numbers.add("true error of 16 anisotropic samples",
                fmt::format("{:.4f}", test::rms_difference(seen.image, truth)));

    const Vec3 grazing = test::at_cosine(1e-6, 25);
    numbers.add("furnace of the lobe of 1994 at the horizon",
                fmt::format("{:.3f}", test::sum_over(test::dome(), 512, [&](const Vec3& l) {
                                return oren_nayar_1994(0.2, l, grazing) * l.z;
                            })));
    numbers.add("what a coat of index 1.5 mirrors of even light", fmt::format("{:.4f}", mean_fresnel(1.5)));
    numbers.add("what it mirrors inside", fmt::format("{:.4f}", inner_reflectance(1.5)));
    numbers.add("samples of each lobe", fmt::format("{}", lobe_samples));
    numbers.add("greatest chi-square by its limit", fmt::format("{:.3f}", worst_chi_square()));
    return numbers;
}

// --------------------------------------------------------------------------------------------- figures

void draw_all(const Path& out) {
    draw_texture_pictures(out);
    write_svg(out / "perspective.svg", side_by_side({{floor_of_two_triangles(false), "linear on screen: no"},
                                                     {floor_of_two_triangles(true), "on the floor: right"}},
                                                    2));
    write_svg(out / "between_texels.svg",
              side_by_side({{magnified(false), "nearest"}, {magnified(true), "bilinear"}}, 2));
    write_svg(out / "levels.svg", levels());
    write_svg(out / "slices.svg", slices());
    write_svg(out / "creases.svg", creases());
    write_svg(out / "sky_maps.svg", sky_maps());
    write_svg(out / "nine_numbers.svg", balls());
    write_file(out / "nine_numbers.csv", nine_numbers());
    write_file(out / "led_back.csv", led_back());
    write_file(out / "filter_errors.csv", filter_errors());
    write_file(out / "cells_missed.csv", cells_missed());
    write_file(out / "furnace.csv", furnaces());
    write_file(out / "furnace_table.csv", furnace_table());
    write_file(out / "chi_square.csv", chi_squares());
    lesson_numbers().write(out);
    write_svg(out / "furnace.svg", furnace_curves());
    write_svg(out / "lobes.svg", lobes_cut_open());
    write_svg(out / "white_furnace.svg", white_furnace());
    write_svg(out / "ways_to_the_horizon.svg", ways_to_the_horizon());
    draw_scenes(out, __FILE__, {"shapes", "globe", "patterns", "marble", "cells", "bumps", "skylight"}, 240,
                180);
    draw_scenes(out, __FILE__, {"evening", "finishes", "horizon"});
}

}  // namespace

int main(int argc, char** argv) { return figures::draw_figures(argc, argv, draw_all); }
