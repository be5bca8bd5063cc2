// Draws the figures of lesson 1 into the directory that it is given.
// Numbers in the figures are computed here, by the course's own functions where there is one.
#include "references/figures.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/01_ray_casting/fisheye.hpp"
#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/01_ray_casting/raycast.hpp"
#include "references/panels.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <array>

using namespace rt;
using namespace rt::figures;

namespace {

const SvgFont label{.size = 20, .italic = true};
const SvgFont remark{.size = 18, .color = "#666666"};
const SvgFont plain{.size = 18};

/// 1234567 as "1,234,567".
std::string grouped(long long value) {
    std::string digits = std::to_string(value);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

/// `value` with a minus sign as printers set it.
std::string signed_decimal(Real value) { return (value < 0 ? "−" : "") + decimal(std::abs(value)); }

/// A pinhole camera that looks to the left, its hole at `at`.
void camera_at(Svg& svg, Vec2 at) {
    rectangle(svg, at + Vec2(0, -13), {34, 26}, {.stroke = ink, .width = 2, .fill = light});
    rectangle(svg, at + Vec2(-2, -2.5), {4, 5}, {.stroke = "none", .fill = "#ffffff"});
}

// Forward and backward ---------------------------------------------------------------------------------

/// A lamp over a white ground, and the opening of a camera: metres, y up.
struct Room {
    Vec3 lamp{0, 2.5, 0};
    Vec3 opening{3, 1.2, 0};
    Vec3 facing = glm::normalize(Vec3(-3, -1.2, 0));
};

/// The share of the lamp's photons that get into an opening of this area, small against its distance.
/// Straight ones by the solid angle; those that the ground has scattered (Lambert's cosine law, nothing
/// absorbed) as an integral over where they met it, by the midpoint rule over directions.
Real share_entering(const Room& room, Real area) {
    const auto into = [&](const Vec3& from) {  // area of the opening as seen, over squared distance
        const Vec3 way = from - room.opening;
        return area * std::max(glm::dot(room.facing, glm::normalize(way)), 0.0) / glm::dot(way, way);
    };
    Real scattered = 0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            const Real down = (i + 0.5) / steps, phi = 2 * pi * (k + 0.5) / steps;
            const Real level = std::sqrt(1 - down * down);
            const Real far = room.lamp.y / down;
            const Vec3 ground = room.lamp + far * Vec3(level * std::cos(phi), -down, level * std::sin(phi));
            const Real cosine = glm::normalize(room.opening - ground).y;
            scattered += cosine / pi * into(ground);
        }
    }
    return into(room.lamp) / (4 * pi) + 0.5 * scattered / (steps * steps);
}

/// How many of so many photons get into an opening of this radius.
long long photons_entering(const Room& room, Real radius, long long photons) {
    test::Random random(1);
    const Plane ground, opening{room.opening, room.facing};
    const auto enters = [&](const Ray& ray) {
        if (glm::dot(ray.direction, room.facing) >= 0) return false;
        const auto hit = intersect(opening, ray, {0, infinity});
        return hit && glm::length(point_at(ray, hit->t) - room.opening) < radius;
    };
    long long count = 0;
    for (long long i = 0; i < photons; ++i) {
        const Ray ray{room.lamp, random.direction()};
        if (enters(ray)) {
            ++count;
            continue;
        }
        const auto hit = intersect(ground, ray, {0, infinity});
        // A point of the unit sphere put on top of the normal is distributed by the cosine law.
        if (hit && enters({point_at(ray, hit->t), random.direction() + Vec3(0, 1, 0)})) ++count;
    }
    return count;
}

void draw_forward_backward(const Path& directory, Numbers& numbers) {
    const Room room;
    const long long photons = 1'000'000;
    const long long entered = photons_entering(room, 0.1, photons);
    const Real pinhole = share_entering(room, pi * 0.0005 * 0.0005);
    const Real expected = static_cast<Real>(photons) * share_entering(room, pi * 0.1 * 0.1);
    // A picture of 320 × 240 pixels with a hundred photons each, at ten million photons a second.
    const Real needed = 320 * 240 * 100 / pinhole, years = needed / 1e7 / (365.25 * 24 * 3600);
    numbers.add("of a million photons into 20 cm", entered);
    numbers.add("the same by integration", fmt::format("{:.1f}", expected));
    numbers.add("photons for one into 1 mm", fmt::format("{:.4e}", 1 / pinhole));
    numbers.add("photons for a picture", fmt::format("{:.3e}", needed));
    numbers.add("years for a picture", fmt::format("{:.2f}", years));

    Svg svg{.width = 700, .height = 350};
    text(svg, {175, 26}, "Forward: light looks for the eye", heading);
    text(svg, {525, 26}, "Backward: the eye looks for light", heading);
    const Real scale = 75;
    const Real floor = 262;
    for (const Real left : {75.0, 425.0}) {
        const auto place = [&](Vec2 p) { return Vec2(left + scale * p.x, floor - scale * p.y); };
        rectangle(svg, {left - 65, floor}, {330, 8}, {.stroke = "none", .fill = light});
        line(svg, {left - 65, floor}, {left + 265, floor});
        const Vec2 lamp = place({0, 2.5}), eye = place({3, 1.2});
        if (left < 100) {
            // A cut through the room: photons in all directions, each followed over one bounce.
            test::Random random(3);
            constexpr int drawn = 44;
            for (int i = 0; i < drawn; ++i) {
                const Real angle = 2 * pi * (i + random.uniform(0, 1)) / drawn;
                const Vec2 d(std::cos(angle), std::sin(angle));
                const SvgStyle style{.stroke = orange, .width = 1.1, .opacity = 0.75};
                const Real down = d.y < 0 ? -2.5 / d.y : infinity;
                Vec2 end = lamp + 34.0 * Vec2(d.x, -d.y);
                if (down * d.x > -0.85 && down * d.x < 2.5) {
                    end = place(Vec2(0, 2.5) + down * d);
                    const Real up = std::asin(random.uniform(-1, 1));
                    arrow(svg, end, end + 46.0 * Vec2(std::sin(up), -std::cos(up)), style, 6);
                    line(svg, lamp, end, style);
                } else {
                    arrow(svg, lamp, end, style, 6);
                }
            }
        } else {
            const auto view = [&](Real x) {  // from the eye to the ground, and from there to the lamp
                const Vec2 ground = place({x, 0});
                arrow(svg, eye, ground, {.stroke = blue, .width = 1.3}, 8);
                arrow(svg, ground, lamp, {.stroke = blue, .width = 1.1, .dash = "4 3", .opacity = 0.8}, 8);
            };
            for (const Real x : {-0.7, -0.25, 0.2, 0.65, 1.1, 1.55}) view(x);
            const Vec2 first = glm::mix(eye, place({-0.75, 0}), 0.22),
                       last = glm::mix(eye, place({1.75, 0}), 0.42);
            line(svg, first, last, {.stroke = ink, .width = 3});
            text(svg, first + Vec2(-4, -8), "picture", middle(remark));
        }
        dot_at(svg, lamp, orange, 9);
        circle(svg, lamp, 9, {.stroke = ink});
        camera_at(svg, eye);
    }
    const std::string caught = grouped(entered) + " of " + grouped(photons) + " photons";
    const std::string few = "of 1 mm gets 1 in " + grouped(std::llround(1e-6 / pinhole)) + " million.";
    const std::pair<std::string, const char*> lines[] = {
        {caught, "Every ray belongs to a pixel,"},
        {"enter a hole 20 cm wide; one", "and none is lost. Dashed: is"},
        {few, "the lamp in sight? (chapter 6)"}};
    for (std::size_t i = 0; i < 3; ++i) {
        text(svg, {10, 294 + 23 * static_cast<Real>(i)}, lines[i].first, remark);
        text(svg, {360, 294 + 23 * static_cast<Real>(i)}, lines[i].second, remark);
    }
    write_svg(directory / "forward_backward.svg", svg);
}

// Ray casting and scan conversion ----------------------------------------------------------------------

void draw_two_loops(const Path& directory) {
    Svg svg{.width = 700, .height = 352};
    text(svg, {175, 26}, "Ray casting", heading);
    text(svg, {525, 26}, "Scan conversion", heading);
    const std::array<Vec2, 3> first{Vec2(1.3, 4.6), Vec2(8.4, 6.2), Vec2(4.6, 0.7)};
    const std::array<Vec2, 3> second{Vec2(5.2, 5.7), Vec2(10.6, 3.9), Vec2(8.2, 0.9)};
    const auto inside = [](const std::array<Vec2, 3>& corner, Vec2 p) {
        int positive = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 edge = corner[(i + 1) % 3] - corner[i], to = p - corner[i];
            if (edge.x * to.y - edge.y * to.x > 0) ++positive;
        }
        return positive == 0 || positive == 3;
    };
    const Real cell = 26;
    for (const Real left : {22.0, 372.0}) {
        const bool casting = left < 100;
        const Vec2 corner(left, 48);
        const auto place = [&](Vec2 p) { return corner + cell * p; };
        for (int y = 0; y < 7; ++y) {
            for (int x = 0; x < 12; ++x) {
                const Vec2 center(x + 0.5, y + 0.5);
                const bool in_first = inside(first, center), in_second = inside(second, center);
                // Cast: the rows above are done, to the nearest colour. Converted: the first triangle is.
                const bool done = casting ? (y < 3 || (y == 3 && x < 6)) : in_first;
                const char* fill = "none";
                if (done) fill = in_first ? "#9fcbe8" : (in_second ? "#f6d18a" : light);
                if (!casting && !in_first && in_second && y < 3) fill = "#f6d18a";
                rectangle(svg, place({x, y}), {cell, cell}, {.stroke = "#cccccc", .width = 1, .fill = fill});
            }
        }
        const auto outline = [&](const std::array<Vec2, 3>& triangle, const char* color) {
            std::array<Vec2, 3> points{};
            std::transform(triangle.begin(), triangle.end(), points.begin(), place);
            polygon(svg, points, {.stroke = color, .width = 2.5});
        };
        outline(second, orange);
        outline(first, blue);
        if (casting) {
            rectangle(svg, place({6, 3}), {cell, cell}, {.stroke = red, .width = 3});
            dot_at(svg, place({6.5, 3.5}), red, 4);
        } else {
            for (int x = 6; x < 10; ++x)
                if (inside(second, {x + 0.5, 3.5}) && !inside(first, {x + 0.5, 3.5}))
                    dot_at(svg, place({x + 0.5, 3.5}), red, 4);
        }
    }
    const SvgFont code{.size = 17};
    const std::array<const char*, 4> cast{"for each pixel", "    for each object",
                                          "        does the ray hit it, and where?", "    keep the nearest"};
    const std::array<const char*, 4> convert{"for each object", "    for each pixel that it covers",
                                             "        is it nearer than what is there?",
                                             "        then write colour and depth"};
    for (std::size_t i = 0; i < 4; ++i) {
        const Real y = 262 + 24 * static_cast<Real>(i);
        const auto indented = [&](Real left, const char* words) {
            const std::string_view all(words);
            const std::size_t blanks = all.find_first_not_of(' ');
            text(svg, {left + 5 * static_cast<Real>(blanks), y}, all.substr(blanks), code);
        };
        indented(22, cast[i]);
        indented(372, convert[i]);
    }
    write_svg(directory / "two_loops.svg", svg);
}

// The camera -------------------------------------------------------------------------------------------

void draw_camera(const Path& directory) {
    Svg svg{.width = 700, .height = 330};
    text(svg, {170, 26}, "From the side", heading);
    text(svg, {545, 26}, "The picture, 4 × 2 pixels", heading);

    // The image plane at distance 1, for a field of view of 60 degrees.
    const Vec2 eye(95, 180);
    const Real unit = 185, half = std::tan(radians(30)) * unit;
    const Vec2 center = eye + Vec2(unit, 0);
    const SvgStyle thin{.stroke = grey, .width = 1.2, .dash = "5 4"};
    line(svg, eye, center + Vec2(45, 0), thin);
    line(svg, eye, center + Vec2(0, -half), thin);
    line(svg, eye, center + Vec2(0, half), thin);
    line(svg, center + Vec2(0, -half), center + Vec2(0, half), {.stroke = ink, .width = 3});
    for (int row = 0; row <= 2; ++row)
        line(svg, center + Vec2(-6, (row - 1) * half), center + Vec2(6, (row - 1) * half),
             {.stroke = ink, .width = 2});
    const Vec2 aim = center + Vec2(0, -half / 2);
    arrow(svg, eye, eye + 1.25 * (aim - eye), {.stroke = blue, .width = 2.2});
    dot_at(svg, aim, blue, 4);
    text(svg, eye + 1.25 * (aim - eye) + Vec2(4, -6), "ray", colored(label, blue));
    arrow(svg, eye, eye + Vec2(0, -78), {.stroke = green, .width = 2.4});
    text(svg, eye + Vec2(-16, -76), "v", colored(label, green));
    arrow(svg, eye, eye + Vec2(-78, 0), {.stroke = red, .width = 2.4});
    text(svg, eye + Vec2(-80, 22), "w", colored(label, red));
    dot_at(svg, eye, purple, 6);
    text(svg, eye + Vec2(-88, 60), "u points at you", {.size = 17, .color = purple});
    arc(svg, eye, 58, radians(-30), 0, {.stroke = ink});
    text(svg, eye + Vec2(66, 26), "fovy/2", {.size = 17});
    text(svg, center + Vec2(14, -half / 2 + 22), "b", colored(label, blue));
    line(svg, center + Vec2(8, -2), center + Vec2(8, -half / 2), {.stroke = blue, .width = 1.5});
    text(svg, eye + Vec2(unit / 2, 140), "1", middle(label));
    arrow(svg, eye + Vec2(unit / 2 - 12, 135), eye + Vec2(2, 135), {.width = 1.2}, 7);
    arrow(svg, eye + Vec2(unit / 2 + 12, 135), center + Vec2(-2, 135), {.width = 1.2}, 7);
    text(svg, center + Vec2(12, -half + 5), "half_height", {.size = 17});
    text(svg, center + Vec2(12, half + 5), "−half_height", {.size = 17});

    // Front view; positions of the sample points by the same formula as the code.
    const Vec2 corner(425, 75);
    const Real cell = 60;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) {
            rectangle(svg, corner + cell * Vec2(x, y), Vec2(cell), {.stroke = grey, .width = 1.5});
            dot_at(svg, corner + cell * Vec2(x + 0.5, y + 0.5), x == 0 && y == 0 ? blue : grey, 4);
        }
    arrow(svg, corner, corner + Vec2(264, 0), {.stroke = ink, .width = 2});
    arrow(svg, corner, corner + Vec2(0, 155), {.stroke = ink, .width = 2});
    text(svg, corner + Vec2(256, -9), "x", label);
    text(svg, corner + Vec2(-18, 152), "y", label);
    text(svg, corner + Vec2(-6, -8), "0", middle(remark));
    text(svg, corner + Vec2(240, -8), "4", middle(remark));
    text(svg, corner + Vec2(-14, 125), "2", middle(remark));
    const Vec2 origin = corner + cell * Vec2(2, 1);
    arrow(svg, origin, origin + Vec2(62, 0), {.stroke = purple, .width = 2.4});
    arrow(svg, origin, origin + Vec2(0, -62), {.stroke = green, .width = 2.4});
    text(svg, origin + Vec2(42, 20), "a", colored(label, purple));
    text(svg, origin + Vec2(8, -46), "b", colored(label, green));
    View view;
    view.width = 4;
    view.height = 2;
    const Vec3 d = pixel_ray(view, 0.5, 0.5).direction;
    text(svg, {430, 262}, "The blue point, (½, ½), is", plain);
    text(svg, {430, 286}, "a = " + signed_decimal(d.x / -d.z) + ", b = " + signed_decimal(d.y / -d.z), plain);
    text(svg, {430, 310}, "if half_height is 1.", plain);
    write_svg(directory / "camera.svg", svg);
}

void draw_projections(const Path& directory) {
    Svg svg{.width = 700, .height = 262};
    text(svg, {175, 26}, "Perspective", heading);
    text(svg, {525, 26}, "Orthographic", heading);
    for (const Real left : {0.0, 350.0}) {
        View view;
        view.projection = left < 100 ? Projection::Perspective : Projection::Orthographic;
        view.frame = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};  // seen from the side: the view goes along +x
        view.half_height = left < 100 ? 0.5 : 1.0;
        view.width = 1;
        view.height = 7;
        const Real scale = 70;
        const Vec2 eye(left + 55, 138);
        const auto place = [&](const Vec3& p) { return eye + scale * Vec2(p.x, -p.y); };
        for (int y = 0; y < 7; ++y) {
            const Ray ray = pixel_ray(view, 0.5, y + 0.5);
            const Real t = 3.05 / ray.direction.x;
            arrow(svg, place(ray.origin), place(point_at(ray, t)), {.stroke = blue, .width = 1.3}, 8);
            dot_at(svg, place(ray.origin), ink, 3);
        }
        for (const Real x : {1.15, 2.6})
            line(svg, place({x, -0.42, 0}), place({x, 0.42, 0}),
                 {.stroke = orange, .width = 7, .opacity = 0.85});
        if (left < 100)
            line(svg, place({1, 0.5, 0}), place({1, -0.5, 0}), {.stroke = ink, .width = 3});
        else
            line(svg, place({0, 1, 0}), place({0, -1, 0}), {.stroke = ink, .width = 3});
        text(svg, {left + 175, 252},
             left < 100 ? "the farther post covers fewer rays" : "both posts cover the same rays",
             middle(remark));
    }
    write_svg(directory / "projections.svg", svg);
}

// The plane --------------------------------------------------------------------------------------------

void draw_plane(const Path& directory) {
    Svg svg{.width = 700, .height = 275};
    const Plane plane{{0, 0, 0}, {0, 1, 0}};
    const Ray ray{{-2.2, 1.9, 0}, {1.05, -0.5, 0}};
    const Real t = intersect(plane, ray, {0, infinity})->t;
    const auto place = [](const Vec3& p) { return Vec2(330, 212) + 92.0 * Vec2(p.x, -p.y); };
    const Vec2 o = place(ray.origin), foot = place({ray.origin.x, 0, 0}), p = place(point_at(ray, t));
    rectangle(svg, {40, 212}, {620, 8}, {.stroke = "none", .fill = light});
    line(svg, {40, 212}, {660, 212}, {.stroke = ink, .width = 2});
    line(svg, o, p, {.stroke = sky, .width = 1.6, .dash = "5 4"});
    for (int i = 0; i < 3; ++i) {
        arrow(svg, place(point_at(ray, i)), place(point_at(ray, i + 1)),
              {.stroke = blue, .width = i == 0 ? 2.8 : 1.2});
    }
    text(svg, place(point_at(ray, 0.55)) + Vec2(2, -10), "d", colored(label, blue));
    line(svg, o, foot, {.stroke = green, .width = 1.8, .dash = "5 4"});
    text(svg, (o + foot) / 2.0 + Vec2(-8, -6), "n · (q − o)",
         {.size = 19, .color = green, .anchor = "end", .italic = true});
    text(svg, (o + foot) / 2.0 + Vec2(-8, 18),
         "= " + signed_decimal(glm::dot(plane.normal, plane.point - ray.origin)),
         {.size = 19, .color = green, .anchor = "end", .italic = true});
    const Vec2 q = place(plane.point);
    arrow(svg, q, q + Vec2(0, -92), {.stroke = red, .width = 2.6});
    text(svg, q + Vec2(10, -82), "n", colored(label, red));
    const Vec2 one = place(point_at(ray, 1));
    line(svg, {one.x, o.y}, one, {.stroke = orange, .width = 1.8, .dash = "5 4"});
    line(svg, o, {one.x, o.y}, {.stroke = orange, .width = 1, .dash = "2 3"});
    text(svg, {one.x + 8, o.y + 18},
         "n · d = " + signed_decimal(glm::dot(plane.normal, ray.direction)) + " for each step of t",
         {.size = 19, .color = "#a87400", .italic = true});
    dot_at(svg, o);
    text(svg, o + Vec2(-18, -4), "o", label);
    dot_at(svg, q);
    text(svg, q + Vec2(-16, -8), "q", label);
    dot_at(svg, p, blue, 5);
    text(svg, p + Vec2(12, -12), "p = o + t·d", colored(label, blue));
    text(svg, {40, 262}, "It arrives after t = −1.9 / −0.5 = " + decimal(t) + " steps.", remark);
    write_svg(directory / "plane.svg", svg);
}

// Rounding ---------------------------------------------------------------------------------------------

/// The checkered ground at y = 0, its cubes decided by the point o + t·d as computed (left), and by the
/// point that surface_at gives and its error bound (right).
void draw_flicker(const Path& directory, Numbers& numbers) {
    const int width = 310, height = 220;
    Camera camera;
    camera.eye = {0, 1.5, 0};
    camera.look_at = {0, 1, -4};
    const View view{.frame = camera_frame(camera),
                    .eye = camera.eye,
                    .half_height = std::tan(radians(30)),
                    .width = width,
                    .height = height};
    const Plane ground;
    const Vec3 sky_color(0.20, 0.42, 0.78), even(0.855, 0.828, 0.72), odd(0.036, 0.117, 0.09);
    Image before = make_image(width, height), after = before;
    int wrong = 0, all = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Ray ray = pixel_ray(view, x + 0.5, y + 0.5);
            const auto hit = intersect(ground, ray, {0, infinity});
            Vec3 naive = sky_color, stable = sky_color;
            if (hit) {
                const auto color = [&](const Vec3& p) {
                    const Vec3 cell = glm::floor(p);
                    return std::fmod(cell.x + cell.y + cell.z, 2) == 0 ? even : odd;
                };
                const Surface surface = surface_at(ground, ray, *hit);
                naive = color(point_at(ray, hit->t));
                stable = color(surface.point + surface.error);
                ++all;
                if (naive != stable) ++wrong;
            }
            pixel(before, x, y) = naive;
            pixel(after, x, y) = stable;
        }
    }
    numbers.add("pixels of the ground", all);
    numbers.add("wrong pixels of the ground", wrong);
    write_svg(directory / "flicker.svg",
              side_by_side({{before, "the point as computed"}, {after, "point + error of surface_at"}}, 2));
}

/// How far from perpendicular u and w are, at worst of many cameras, over the angle of up and view.
void draw_up(const Path& directory) {
    Svg svg{.width = 700, .height = 330};
    const Vec2 corner(110, 30);
    const Real right = 540, down = 225;  // of the axes, pixels
    const auto place = [&](Real angle, Real error) {
        return corner + Vec2(right * (std::log10(angle) + 12) / 12, -down * std::log10(error) / 17);
    };
    for (int k = -16; k <= 0; k += 4) {
        line(svg, place(1e-12, std::pow(10.0, k)), place(1, std::pow(10.0, k)),
             {.stroke = light, .width = 1});
        text(svg, place(1e-12, std::pow(10.0, k)) + Vec2(-8, 5), k == 0 ? "1" : "1e" + std::to_string(k),
             {.size = 17, .anchor = "end"});
    }
    for (int k = -12; k <= 0; k += 2)
        text(svg, place(std::pow(10.0, k), 1e-17) + Vec2(0, 22), k == 0 ? "1" : "1e" + std::to_string(k),
             {.size = 17, .anchor = "middle"});
    line(svg, corner, corner + Vec2(0, down));
    line(svg, corner + Vec2(0, down), corner + Vec2(right, down));
    line(svg, place(1e-12, 0x1p-53 * 1e12), place(1, 0x1p-53), {.stroke = grey, .width = 1.2, .dash = "5 4"});
    text(svg, place(1e-7, 2e-8) + Vec2(8, -4), "unit roundoff / angle", remark);
    test::Random random(2);
    for (Real exponent = -12; exponent < 0.01; exponent += 0.5) {
        const Real angle = std::pow(10.0, exponent);
        Real worst = 0;
        for (int i = 0; i < 1000; ++i) {
            Camera camera;
            const Vec3 view = random.direction();
            const Vec3 side = glm::normalize(glm::cross(view, random.direction()));
            camera.eye = {0, 0, 0};
            camera.look_at = view;
            camera.up = std::cos(angle) * view + std::sin(angle) * side;
            const CameraFrame frame = camera_frame(camera);
            worst = std::max(worst, std::abs(glm::dot(frame.u, frame.w)));
        }
        dot_at(svg, place(angle, worst), red, 4);
    }
    text(svg, corner + Vec2(right / 2, down + 52), "angle between up and the view, radians", middle(plain));
    text(svg, {32, corner.y + down / 2}, "greatest |u · w|", {.size = 18, .anchor = "middle", .turn = -90});
    write_svg(directory / "up.svg", svg);
}

// Other cameras ----------------------------------------------------------------------------------------

/// A scene by a fisheye camera that sees half of everything; what is outside of its circle is white.
void draw_fisheye(const Path& directory) {
    const Scene scene = scene_beside(__FILE__, "planes", 240, 240);
    World world = compile(scene);
    Image image = make_image(scene.width, scene.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Real a = x + 0.5 - image.width / 2.0, b = y + 0.5 - image.height / 2.0;
            pixel(image, x, y) = Vec3(1);
            if (std::hypot(a, b) < image.width / 2.0)
                pixel(image, x, y) = cast_ray(world, fisheye_ray(world.view, x + 0.5, y + 0.5, pi));
        }
    write_image(directory / "fisheye.png", image, scene.encoding);
}

void draw_all(const Path& directory) {
    Numbers numbers;
    draw_forward_backward(directory, numbers);
    draw_two_loops(directory);
    draw_camera(directory);
    draw_projections(directory);
    draw_plane(directory);
    draw_flicker(directory, numbers);
    draw_up(directory);
    draw_fisheye(directory);
    numbers.write(directory);
    draw_scenes(directory, __FILE__, {"directions", "horizon", "orthographic", "planes"});
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw_all); }
