// Draws the figures of lesson 5 into the directory that it is given.
// Numbers in the figures are computed here, by the course's own functions where there is one.
#include "references/figures.hpp"
#include "chapters/05_lighting/lighting.hpp"

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
    Svg svg{.width = 700, .height = 250};
    const Real width = 70, floor = 200;
    const std::vector<Real> angles{0, 45, 70};
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const Real angle = angles[i];
        const Vec2 d = -leaning(-angle), foot(i == 0 ? 110.0 : i == 1 ? 320.0 : 575.0, floor);
        const Real lit = width / std::cos(radians(angle));
        ground(svg, foot.x - 108, foot.x + 108, floor);
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
        const Vec2 at = foot + Real(half ? 96 : 138) * leaning((from + to) / 2);
        text(svg, at + Vec2(0, 5), decimal(std::abs(to - from)) + "°",
             anchored(SvgFont{.size = 14, .color = red}, "middle"));
        if (!half) arc(svg, foot, 60, radians(90), radians(90 - to_light), {.stroke = grey, .width = 1.3});
        if (!half) arc(svg, foot, 60, radians(90 + to_light), radians(90), {.stroke = grey, .width = 1.3});
        const SvgFont formula{.size = 15, .anchor = "middle"};
        text(svg, {foot.x - 62, 273}, half ? "h = normalize(l + v)" : "r = 2(n·l)n − l", formula);
        text(svg, {foot.x + 88, 273}, half ? "highlight = (n·h)ˢ" : "highlight = (r·v)ˢ", formula);
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
    Svg svg{.width = 700, .height = 330};
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
    text(svg, {28, corner.y + down / 2}, "light on a surface that faces the lamp",
         {.size = 14, .anchor = "middle", .turn = -90});
    write_svg(directory / "attenuation.svg", svg);
}

// Pictures ----------------------------------------------------------------------------------------------

/// The same light twice: encoded for the screen, and with its numbers written into the file as they are.
void draw_encoding(const Path& directory) {
    const Image right = render(compile(scene_beside(__FILE__, "encoding"))).image;
    Image wrong = right;
    for (Vec3& p : wrong.pixels)
        for (int i = 0; i < 3; ++i) p[i] = decode(p[i], Encoding::Srgb);
    write_image(directory / "encoding.png", in_rows({right, wrong}, 2));
}

/// What one pixel of the picture of mistakes shows.
using Shade = std::function<Vec3(const Vec3& n, const Vec3& v)>;

Image ball(const Shade& shade) {
    const int size = 112;
    Image image = make_image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Real a = 2.3 * ((x + 0.5) / size - 0.5), b = -2.3 * ((y + 0.5) / size - 0.5);
            const Real square = a * a + b * b;
            const Vec3 n(a, b, std::sqrt(std::max(1 - square, 0.0)));
            pixel(image, x, y) = square < 1 ? shade(n, {0, 0, 1}) : Vec3(0.03);
        }
    return image;
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
    write_image(directory / "mistakes.png",
                in_rows({ball(sum(right)), ball(sum(not_clamped)), ball(sum(both_sides)), ball(sum(away)),
                         ball(sum(from_behind)), ball(sum(long_half))},
                        3));
}

void draw_all(const Path& directory) {
    draw_cosine(directory);
    draw_vectors(directory);
    draw_exponents(directory);
    draw_attenuation(directory);
    draw_encoding(directory);
    draw_mistakes(directory);
    draw_scenes(directory, __FILE__, {"lambert", "highlights", "phong", "attenuation", "smooth"}, 240, 180);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw_all); }
