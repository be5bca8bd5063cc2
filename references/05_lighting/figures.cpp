// Draws the figures of lesson 5 into the directory that it is given.
// Numbers in the figures are computed here, by the course's own functions where there is one.
#include "references/figures.hpp"
#include "chapters/05_lighting/lighting.hpp"
#include "chapters/05_lighting/spot.hpp"
#include "references/panels.hpp"

#include <fmt/format.h>

#include <functional>

using namespace rt;
using namespace rt::figures;

namespace {

const SvgFont label{.size = 17, .italic = true};

/// Unit vector on the page, `degrees` from upwards to the right.
Vec2 leaning(Real degrees) { return {std::sin(radians(degrees)), -std::cos(radians(degrees))}; }

/// A piece of ground from x0 to x1 at height y.
void ground(Svg& svg, Real x0, Real x1, Real y) {
    rectangle(svg, {x0, y}, {x1 - x0, 9}, {.stroke = "none", .fill = light});
    line(svg, {x0, y}, {x1, y}, {.stroke = ink, .width = 2});
}

// Lambert's cosine --------------------------------------------------------------------------------------

void draw_cosine(const Path& directory) {
    Svg svg{.width = 760, .height = 250};
    const Real width = 64, floor = 200;
    const std::vector<Real> angles{0, 45, 70};
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const Real angle = angles[i];
        const Vec2 d = -leaning(-angle), foot(i == 0 ? 85.0 : i == 1 ? 310.0 : 640.0, floor);
        const Real lit = width / std::cos(radians(angle));
        ground(svg, foot.x - (i == 0 ? 70 : 112), foot.x + (i == 0 ? 70 : 112), floor);
        const Vec2 left = foot - Vec2(lit / 2, 0), right = foot + Vec2(lit / 2, 0);
        const Vec2 back = Real(130) * d;
        const std::vector<Vec2> beam{left, right, right - back, left - back};
        polygon(svg, beam, {.stroke = "none", .fill = orange, .opacity = 0.25});
        for (int k = 0; k <= 4; ++k) {
            const Vec2 end = left + (k / 4.0) * (right - left);
            arrow(svg, end - back, end, {.stroke = orange, .width = 1.4}, 8);
        }
        line(svg, left, right, {.stroke = red, .width = 5});
        if (i == 0) arrow(svg, foot, foot - Vec2(0, 75), {.stroke = blue, .width = 2.2});
        if (i == 0) text(svg, foot + Vec2(8, -66), "n", colored(label, blue));
        text(svg, foot + Vec2(0, 34), angle == 0 ? "1 wide" : decimal(1 / std::cos(radians(angle))) + " wide",
             anchored(SvgFont{.size = 14, .color = red}, "middle"));
        text(svg, {foot.x, 24}, decimal(angle) + "°: n·l = " + decimal(std::cos(radians(angle))),
             anchored(SvgFont{.size = 15}, "middle"));
    }
    write_svg(directory / "cosine.svg", svg);
}

// Half vector and reflection vector ---------------------------------------------------------------------

void draw_vectors(const Path& directory) {
    Svg svg{.width = 700, .height = 290};
    const Real size = 170, floor = 235;
    const Real to_light = -55, to_viewer = 25;
    for (const bool half : {true, false}) {
        const Vec2 foot(half ? 175 : 525, floor);
        text(svg, {foot.x, 24}, half ? "half vector (Blinn 1977)" : "reflection vector (Phong 1975)",
             heading);
        ground(svg, foot.x - 150, foot.x + 150, floor);
        const Real third = half ? (to_light + to_viewer) / 2 : -to_light;
        const auto vector = [&](Real angle, const char* name, const char* color, Real width) {
            const Vec2 tip = foot + size * leaning(angle);
            arrow(svg, foot, tip, {.stroke = color, .width = width}, 11);
            text(svg, tip + Vec2(angle < 0 ? -14 : 6, angle == 0 ? 2 : -4), name, colored(label, color));
        };
        vector(to_light, "l", "#b07800", 2.2);
        vector(0, "n", blue, 2.2);
        vector(to_viewer, "v", ink, 2.2);
        vector(third, half ? "h" : "r", red, 2.6);
        const Real from = half ? 0 : to_viewer, to = third;
        // The angle whose cosine is raised to a power.
        const Real a = radians(90 - std::max(from, to)), b = radians(90 - std::min(from, to));
        arc(svg, foot, 120, a, b, {.stroke = red, .width = 2});
        const Vec2 at = foot + Real(half ? 132 : 138) * leaning((from + to) / 2);
        text(svg, at + Vec2(0, half ? 0 : 5), decimal(std::abs(to - from)) + "°",
             anchored(SvgFont{.size = 14, .color = red}, "middle"));
        if (!half) arc(svg, foot, 60, radians(90), radians(90 - to_light), {.stroke = grey, .width = 1.3});
        if (!half) arc(svg, foot, 60, radians(90 + to_light), radians(90), {.stroke = grey, .width = 1.3});
        const SvgFont formula{.size = 15, .anchor = "middle"};
        text(svg, {foot.x - 72, 273}, half ? "h = normalize(l + v)" : "r = 2(n·l)n − l", formula);
        text(svg, {foot.x + 94, 273}, half ? "highlight = (n·h)ˢ" : "highlight = (r·v)ˢ", formula);
        dot_at(svg, foot, ink, 4);
    }
    write_svg(directory / "vectors.svg", svg);
}

/// Highlights over the viewer's angle, light at 40 degrees: Phong with exponent s, Blinn with 4s.
void draw_exponents(const Path& directory) {
    Svg svg{.width = 700, .height = 290};
    const Vec2 corner(70, 30);
    const Real right = 590, down = 200;
    const auto place = [&](Real degrees, Real value) {
        return corner + Vec2(right * (degrees + 90) / 180, down * (1 - value));
    };
    for (int angle = -90; angle <= 90; angle += 30) {
        line(svg, place(angle, 0), place(angle, 1), {.stroke = light, .width = 1});
        text(svg, place(angle, 0) + Vec2(0, 19), decimal(angle) + "°",
             anchored(SvgFont{.size = 13}, "middle"));
    }
    for (const Real value : {0.0, 0.5, 1.0}) {
        line(svg, place(-90, value), place(90, value), {.stroke = light, .width = 1});
        text(svg, place(-90, value) + Vec2(-8, 5), decimal(value), anchored(SvgFont{.size = 13}, "end"));
    }
    const auto in_space = [](Real degrees) {
        return Vec3(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
    };
    const Vec3 n(0, 0, 1), l = in_space(-40);
    const char* colors[] = {green, blue, red};
    const Real exponents[] = {2, 10, 100};
    for (int i = 0; i < 3; ++i) {
        std::vector<Vec2> by_phong, by_blinn;
        for (Real angle = -90; angle <= 90; angle += 1) {
            by_phong.push_back(place(angle, phong(n, l, in_space(angle), exponents[i])));
            by_blinn.push_back(place(angle, blinn(n, l, in_space(angle), 4 * exponents[i])));
        }
        polyline(svg, by_phong, {.stroke = colors[i], .width = 2.2, .dash = "6 4"});
        polyline(svg, by_blinn, {.stroke = colors[i], .width = 2.2});
        const std::string names = "s = " + decimal(4 * exponents[i]) + " and " + decimal(exponents[i]);
        text(svg, corner + Vec2(14, 24.0 + 22 * i), names, colored(SvgFont{.size = 14}, colors[i]));
    }
    line(svg, place(40, 0), place(40, 1.04), {.stroke = grey, .width = 1.2, .dash = "3 3"});
    text(svg, place(40, 1.04) + Vec2(0, -5), "mirror direction", anchored(note, "middle"));
    text(svg, {corner.x + right / 2, 276},
         "direction to the viewer, light from −40°; solid: Blinn; dashed: Phong, exponent/4",
         anchored(SvgFont{.size = 14}, "middle"));
    write_svg(directory / "exponents.svg", svg);
}

// Attenuation -------------------------------------------------------------------------------------------

/// Light at distance d on the axis of a disc of radius 1 that shines like paper: rings of small patches.
Real from_disc(Real d) {
    constexpr int rings = 2000;
    Real sum = 0;
    for (int i = 0; i < rings; ++i) {
        const Real r = (i + 0.5) / rings, square = r * r + d * d;
        sum += 2 * r / rings * (d * d) / (square * square);
    }
    return sum;
}

/// Light at distance d beside the middle of a thin tube 200 long, as if made of points.
Real from_tube(Real d) {
    constexpr int points = 400'000;
    Real sum = 0;
    for (int i = 0; i < points; ++i) {
        const Real x = 200 * ((i + 0.5) / points - 0.5);
        sum += 200.0 / points * d / std::pow(d * d + x * x, 1.5);
    }
    return sum / 2;
}

void draw_attenuation(const Path& directory) {
    Svg svg{.width = 730, .height = 330};
    const Vec2 corner(85, 25);
    const Real right = 430, down = 235;
    const auto place = [&](Real d, Real value) {
        return corner + Vec2(right * (std::log10(d) + 1) / 2.5, down * (1.5 - std::log10(value)) / 4.5);
    };
    for (int k = -1; k <= 1; ++k) {
        const Real d = std::pow(10.0, k);
        line(svg, place(d, std::pow(10, -3)), place(d, std::pow(10, 1.5)), {.stroke = light, .width = 1});
        text(svg, place(d, 1e-3) + Vec2(0, 19), decimal(d), anchored(SvgFont{.size = 13}, "middle"));
    }
    for (int k = -3; k <= 1; ++k) {
        line(svg, place(0.1, std::pow(10, k)), place(std::pow(10, 1.5), std::pow(10, k)),
             {.stroke = light, .width = 1});
        text(svg, place(0.1, std::pow(10, k)) + Vec2(-8, 5), decimal(std::pow(10, k), 3),
             anchored(SvgFont{.size = 13}, "end"));
    }
    struct Curve {
        const char* color;
        std::string name;
        Vec3 attenuation;
        Real (*truth)(Real);
    };
    const Curve curves[] = {{purple, "1 0 0: all around, or far", {1, 0, 0}, nullptr},
                            {green, "0 1 0: long tube", {0, 1, 0}, from_tube},
                            {red, "1 0 1: disc, radius 1", {1, 0, 1}, from_disc},
                            {blue, "0 0 1: point", {0, 0, 1}, nullptr}};
    int row = 0;
    for (const Curve& curve : curves) {
        std::vector<Vec2> points;
        for (Real e = -1; e <= 1.5001; e += 0.02) {
            const Real d = std::pow(10, e);
            const PointLight lamp{.position = {0, 0, d}, .color = Vec3(1), .attenuation = curve.attenuation};
            const Real value = sample_light(lamp, Vec3(0)).color.x;
            if (value <= std::pow(10, 1.5) * 1.0001) points.push_back(place(d, value));
        }
        polyline(svg, points, {.stroke = curve.color, .width = 2.2});
        for (Real e = -1; curve.truth && e <= 1.5001; e += 0.25)
            dot_at(svg, place(std::pow(10, e), curve.truth(std::pow(10, e))), curve.color, 4.5);
        text(svg, {corner.x + right + 14, 60.0 + 26 * row++}, curve.name,
             colored(SvgFont{.size = 14}, curve.color));
    }
    text(svg, {corner.x + right + 14, 180}, "lines: the attenuation", note);
    text(svg, {corner.x + right + 14, 198}, "dots: the lamp, summed", note);
    text(svg, {corner.x + right + 14, 216}, "up from small patches", note);
    text(svg, {corner.x + right / 2, 318}, "distance d", anchored(SvgFont{.size = 14}, "middle"));
    text(svg, {28, corner.y + down / 2}, "light on a surface facing the lamp",
         {.size = 14, .anchor = "middle", .turn = -90});
    write_svg(directory / "attenuation.svg", svg);
}

// Pictures ----------------------------------------------------------------------------------------------

/// A scene as it is looked at.
Panel shown(const char* name, const char* words) {
    return {render(compile(scene_beside(__FILE__, name))).image, words};
}

void draw_goals(const Path& directory) {
    write_svg(directory / "goals.svg",
              side_by_side({shown("lambert", "the cosine law"), shown("highlights", "highlights"),
                            shown("attenuation", "attenuation"), shown("smooth", "round and flat")},
                           2));
}

/// Its two halves are two ways of making highlights.
void draw_phong(const Path& directory) {
    const Image whole = render(compile(scene_beside(__FILE__, "phong"))).image;
    std::vector<Panel> halves{{{}, "half vector"}, {{}, "reflection vector"}};
    for (int k = 0; k < 2; ++k) {
        Image& half = halves[static_cast<std::size_t>(k)].image = make_image(whole.width / 2, whole.height);
        for (int y = 0; y < half.height; ++y)
            for (int x = 0; x < half.width; ++x) pixel(half, x, y) = pixel(whole, k * half.width + x, y);
    }
    write_svg(directory / "phong.svg", side_by_side(halves, 2));
}

/// The same light twice: encoded for the screen, and with its numbers written into the file as they are.
void draw_encoding(const Path& directory) {
    const Image right = render(compile(scene_beside(__FILE__, "encoding"))).image;
    Image wrong = right;
    for (Vec3& p : wrong.pixels)
        for (int i = 0; i < 3; ++i) p[i] = decode(p[i], Encoding::Srgb);
    write_svg(directory / "encoding.svg", side_by_side({{right, "encoded"}, {wrong, "light as bytes"}}, 2));
}

/// What one pixel of the picture of mistakes shows.
using Shade = std::function<Vec3(const Vec3& n, const Vec3& v)>;

Panel ball(const Shade& shade, const std::string& words) {
    const int size = 170;
    Image image = make_image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Real a = 2.2 * ((x + 0.5) / size - 0.5), b = -2.2 * ((y + 0.5) / size - 0.5);
            const Real square = a * a + b * b;
            const Vec3 n(a, b, std::sqrt(std::max(1 - square, 0.0)));
            pixel(image, x, y) = square < 1 ? shade(n, {0, 0, 1}) : Vec3(0.03);
        }
    return {image, words};
}

void draw_mistakes(const Path& directory) {
    Material paint;
    paint.ambient = Vec3(0.02);
    paint.diffuse = {0.5, 0.14, 0.06};
    paint.specular = Vec3(0.4);
    paint.shininess = 30;
    const std::vector<LightSample> lamps{{normalize(Vec3(-1, 1.2, 1)), 1, Vec3(0.8)},
                                         {normalize(Vec3(1.4, 0.2, -0.8)), 1, {0.4, 0.5, 0.7}}};
    using Term = std::function<Vec3(const Vec3&, const Vec3&, const Vec3&)>;  // of n, l, v
    const auto sum = [=](const Term& term) {
        return [=](const Vec3& n, const Vec3& v) {
            Vec3 color = emitted_light(paint);
            for (const LightSample& lamp : lamps) color += lamp.color * term(n, lamp.direction, v);
            return glm::max(color, Vec3(0));
        };
    };
    const auto right = [=](const Vec3& n, const Vec3& l, const Vec3& v) {
        return reflected_light(paint, n, v, {l, 1, Vec3(1)}, Vec3(1));
    };
    const auto not_clamped = [=](const Vec3& n, const Vec3& l, const Vec3& v) {
        return dot(n, l) * paint.diffuse + right(n, l, v) - lambert(n, l) * paint.diffuse;
    };
    const auto both_sides = [=](const Vec3& n, const Vec3& l, const Vec3& v) {
        return right(dot(n, l) < 0 ? -n : n, l, v);
    };
    const auto away = [=](const Vec3& n, const Vec3& l, const Vec3& v) { return right(n, -l, v); };
    const auto from_behind = [=](const Vec3& n, const Vec3& l, const Vec3& v) {
        return lambert(n, l) * paint.diffuse + blinn(n, l, v, 4) * paint.specular;
    };
    const auto long_half = [=](const Vec3& n, const Vec3& l, const Vec3& v) {
        const Vec3 diffuse = lambert(n, l) * paint.diffuse;
        return lambert(n, l) > 0 ? diffuse + std::pow(std::max(dot(n, l + v), 0.0), 30.0) * paint.specular
                                 : diffuse;
    };
    write_svg(directory / "wrong_cosines.svg",
              side_by_side({ball(sum(right), "right"), ball(sum(away), "l reversed"),
                            ball(sum(not_clamped), "no maximum"), ball(sum(both_sides), "both sides")},
                           4));
    write_svg(directory / "wrong_highlights.svg",
              side_by_side({ball(sum(right), "right"), ball(sum(long_half), "h too long"),
                            ball(sum(from_behind), "from behind")},
                           3));
}

// What the numbers mean ---------------------------------------------------------------------------------

/// Radiance: the light of a patch, in a narrow cone of directions.
void draw_radiance(const Path& directory) {
    Svg svg{.width = 700, .height = 300};
    const Vec2 foot(250, 250);
    const Real lean = 40, spread = 8, reach = 230;
    ground(svg, 40, 460, 250);
    const Vec2 d = leaning(lean), across(-d.y, d.x);
    const Real patch = 40;
    const Real seen = patch * std::cos(radians(lean));
    const std::vector<Vec2> beam{foot, foot + reach * leaning(lean - spread),
                                 foot + reach * leaning(lean + spread)};
    polygon(svg, beam, {.stroke = "none", .fill = orange, .opacity = 0.3});
    line(svg, beam[0], beam[1], {.stroke = orange, .width = 1.4});
    line(svg, beam[0], beam[2], {.stroke = orange, .width = 1.4});
    arrow(svg, foot, foot + (reach + 30) * d, {.stroke = ink, .width = 2});
    arrow(svg, foot, foot - Vec2(0, 150), {.stroke = blue, .width = 2.2});
    line(svg, foot - Vec2(patch, 0), foot + Vec2(patch, 0), {.stroke = red, .width = 6});
    const Vec2 mid = foot + Real(62) * d;
    line(svg, mid - seen * across, mid + seen * across, {.stroke = green, .width = 4});
    arc(svg, foot, 105, radians(90 - lean), radians(90), {.stroke = blue, .width = 1.6});
    text(svg, foot + Real(122) * leaning(lean / 2) + Vec2(-4, 4), "θ", colored(label, blue));
    text(svg, foot + Vec2(-20, -140), "n", colored(label, blue));
    text(svg, foot + (reach + 36) * d + Vec2(4, -2), "v", label);
    text(svg, foot + Vec2(-patch - 4, 34), "a patch of the surface", colored(SvgFont{.size = 15}, red));
    const SvgFont words{.size = 15};
    text(svg, {385, 215}, "the patch as seen from v:", colored(words, green));
    text(svg, {385, 234}, "cos θ times as large", colored(words, green));
    text(svg, {465, 70}, "a narrow cone of directions:", colored(words, "#b07800"));
    text(svg, {465, 90}, "its solid angle, in steradians", colored(words, "#b07800"));
    text(svg, {20, 28}, "radiance = power / (area as seen · solid angle)", {.size = 16});
    write_svg(directory / "radiance.svg", svg);
}

/// A wall, and a lamp with a shade close before it, with a hard edge and with a soft one.
void draw_spot(const Path& directory) {
    const Vec3 lamp(-0.4, 0.6, 0.8), middle(0, 0.15, 0);
    std::vector<Panel> panels;
    for (const Real outer : {0.94, 0.84}) {
        const SpotLight light{{.position = lamp, .color = {1.6, 1.5, 1.2}, .attenuation = {0.5, 0, 1}},
                              normalize(middle - lamp),
                              0.94,
                              outer};
        Image image = make_image(320, 240);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Vec3 wall((x + 0.5 - 160) / 160, (120 - y - 0.5) / 160, 0);
                const LightSample sample = sample_light(light, wall);
                pixel(image, x, y) = Vec3(0.02) + sample.color * lambert({0, 0, 1}, sample.direction);
            }
        panels.push_back({image, outer < 0.94 ? "soft edge" : "hard edge"});
    }
    write_svg(directory / "spot.svg", side_by_side(panels, 2));
}

/// How much of what arrives a highlight of weight 1 sends on, light coming in at an angle from the normal:
/// the mean of highlight · cos θ over the hemisphere of directions v, by midpoints, over π · cos of that
/// angle.
Real sent_on(Real (*highlight)(const Vec3&, const Vec3&, const Vec3&, Real), Real shininess, Real degrees) {
    constexpr int rows = 1000, columns = 1000;
    const Vec3 n(0, 0, 1), l(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
    Real sum = 0;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) {
            // Even in the square of the sine: each cell has the same integral of the cosine,
            // π/(rows·columns).
            const Real sine = std::sqrt((i + 0.5) / rows), around = 2 * pi * (k + 0.5) / columns;
            const Vec3 v(sine * std::cos(around), sine * std::sin(around), std::sqrt(1 - sine * sine));
            sum += highlight(n, l, v, shininess);
        }
    return sum / (rows * columns) / std::cos(radians(degrees));
}

void write_energy(const Path& directory) {
    std::string csv =
        "shininess,half vector from above,half vector from 85 degrees,reflection vector from above\n";
    for (const Real s : {1.0, 8.0, 40.0, 400.0, 1000.0})
        csv += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", s, sent_on(blinn, s, 0), sent_on(blinn, s, 85),
                           sent_on(phong, s, 0));
    write_file(directory / "energy.csv", csv);
}

/// Above, highlights of the same weight; below, highlights that send on the same part of the light.
void draw_normalised(const Path& directory) {
    const Vec3 diffuse(0.06, 0.13, 0.28);
    const LightSample lamp{normalize(Vec3(-0.6, 0.7, 1)), 1, Vec3(1)};
    std::vector<Panel> panels;
    for (const bool normalised : {false, true})
        for (const Real s : {1.0, 8.0, 40.0, 400.0}) {
            Material paint;
            paint.ambient = Vec3(0.01);
            paint.diffuse = diffuse;
            paint.shininess = s;
            paint.specular = Vec3(normalised ? 0.05 / sent_on(blinn, s, 0) : 0.3);
            const Shade shade = [=](const Vec3& n, const Vec3& v) {
                return emitted_light(paint) + reflected_light(paint, n, v, lamp, Vec3(1));
            };
            panels.push_back(ball(shade, fmt::format("{}, s = {}", normalised ? "5 %" : "0.3", s)));
        }
    write_svg(directory / "normalised.svg", side_by_side(panels, 4));
}

Real luminance(const Vec3& c) { return dot(c, Vec3(0.2126, 0.7152, 0.0722)); }

/// Four times the light of a scene: cut off at 1, exposed for a quarter of the time, and by a tone curve.
void draw_above_one(const Path& directory, Numbers& numbers) {
    Image bright = render(compile(scene_beside(__FILE__, "highlights", 224, 168))).image;
    int above = 0;
    for (Vec3& p : bright.pixels) {
        p *= 4;
        if (std::max({p.x, p.y, p.z}) > 1) ++above;
    }
    Image exposed = bright, curved = bright;
    for (Vec3& p : exposed.pixels) p *= 0.25;
    for (Vec3& p : curved.pixels) p /= 1 + luminance(p);
    write_svg(directory / "above_one.svg",
              side_by_side({{bright, "cut off at 1"}, {exposed, "exposure 1/4"}, {curved, "tone curve"}}, 3));
    numbers.add("percent of pixels above 1",
                fmt::format("{:.1f}", 100.0 * above / static_cast<double>(bright.pixels.size())));
}

/// The exponent g whose curve x^(1/g) is nearest to the curve of sRGB, by the mean square over [0, 1].
Real nearest_power() {
    constexpr int points = 2000;
    Real best = 0, least = infinity;
    for (int k = 1500; k <= 3000; ++k) {
        const Real g = k / 1000.0;
        Real sum = 0;
        for (int i = 0; i < points; ++i) {
            const Real x = (i + 0.5) / points;
            const Real difference = std::pow(x, 1 / g) - encode(x, Encoding::Srgb);
            sum += difference * difference;
        }
        if (sum < least) least = sum, best = g;
    }
    return best;
}

void note_encoding(Numbers& numbers) {
    numbers.add("light of the byte 128", fmt::format("{:.4f}", decode(128 / 255.0, Encoding::Srgb)));
    numbers.add("byte of half the light", encode_byte(0.5, Encoding::Srgb));
    numbers.add("nearest plain power", fmt::format("{:.2f}", nearest_power()));
}

void draw_all(const Path& directory) {
    Numbers numbers;
    draw_goals(directory);
    draw_cosine(directory);
    draw_vectors(directory);
    draw_exponents(directory);
    draw_attenuation(directory);
    draw_phong(directory);
    draw_encoding(directory);
    draw_mistakes(directory);
    draw_radiance(directory);
    draw_spot(directory);
    draw_normalised(directory);
    draw_above_one(directory, numbers);
    write_energy(directory);
    note_encoding(numbers);
    numbers.write(directory);
    draw_scenes(directory, __FILE__, {"lambert", "highlights", "attenuation", "smooth"}, 240, 180);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw_all); }
