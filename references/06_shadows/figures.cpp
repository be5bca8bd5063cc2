// Draws the figures of lesson 6 into the directory that it is given.
// Numbers in the figures are computed here, by the course's own functions where there is one.
#include "references/figures.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/06_shadows/eclipse.hpp"
#include "chapters/06_shadows/shadow.hpp"
#include "references/panels.hpp"
#include "tests/stability/shadows.hpp"

#include <fmt/format.h>

using namespace rt;
using namespace rt::figures;

namespace {

const SvgFont label{.size = 17, .italic = true};
const SvgFont caption{.size = 14, .anchor = "middle"};

void cross_at(Svg& svg, Vec2 at, const char* color, Real size = 6) {
    line(svg, at - Vec2(size, size), at + Vec2(size, size), {.stroke = color, .width = 2.5});
    line(svg, at - Vec2(size, -size), at + Vec2(size, -size), {.stroke = color, .width = 2.5});
}

// What a shadow ray asks --------------------------------------------------------------------------------

void draw_shadow_ray(const Path& directory) {
    Svg svg{.width = 740, .height = 300};
    const Real floor = 250;
    rectangle(svg, {20, floor}, {700, 9}, {.stroke = "none", .fill = light});
    line(svg, {20, floor}, {720, floor}, {.stroke = ink, .width = 2});
    const Vec2 lamp(520, 70), eye(70, 110), ball(395, 138), lit(610, floor), dark(230, floor);
    const Real radius = 38;
    circle(svg, ball, radius, {.stroke = ink, .width = 2, .fill = "#eef3f7"});
    circle(svg, {640, 40}, 26, {.stroke = grey, .width = 2, .fill = "#f5f5f5"});
    for (const Vec2& p : {lit, dark}) arrow(svg, eye, p, {.stroke = blue, .width = 1.4}, 9);
    arrow(svg, lit, lamp, {.stroke = green, .width = 2.2, .dash = "6 4"});
    const Vec2 d = glm::normalize(lamp - dark);
    const Real along = glm::dot(ball - dark, d);
    const Real off = std::abs(d.x * (ball - dark).y - d.y * (ball - dark).x);
    const Vec2 stop = dark + (along - std::sqrt(radius * radius - off * off)) * d;
    line(svg, dark, stop, {.stroke = red, .width = 2.2, .dash = "6 4"});
    cross_at(svg, stop, red);
    dot_at(svg, lamp, orange, 9);
    circle(svg, lamp, 9, {.stroke = ink});
    dot_at(svg, eye, ink, 6);
    for (const Vec2& p : {lit, dark}) dot_at(svg, p, ink, 4);
    text(svg, eye + Vec2(-8, -14), "eye");
    text(svg, lamp + Vec2(-18, -18), "lamp");
    text(svg, {575, 152}, "nothing between:", colored(SvgFont{.size = 14}, green));
    text(svg, {575, 170}, "lit", colored(SvgFont{.size = 14}, green));
    text(svg, {182, 186}, "something", colored(SvgFont{.size = 14}, red));
    text(svg, {182, 204}, "between", colored(SvgFont{.size = 14}, red));
    text(svg, {650, 84}, "behind the lamp:", colored(caption, grey));
    text(svg, {650, 101}, "does not matter", colored(caption, grey));
    text(svg, {dark.x, 281}, "in shadow", caption);
    text(svg, {lit.x, 281}, "in light", caption);
    write_svg(directory / "shadow_ray.svg", svg);
}

// The box of the error ----------------------------------------------------------------------------------

void draw_offset(const Path& directory) {
    Svg svg{.width = 700, .height = 400};
    const Vec2 point(290, 205), e(85, 48);
    const Real lean = radians(28);
    const Vec2 n(std::sin(lean), -std::cos(lean)), tangent(std::cos(lean), std::sin(lean));
    const Real d = std::abs(n.x) * e.x + std::abs(n.y) * e.y;
    const Real below = 33;  // how far the exact surface is below the point, along n
    const Vec2 on_surface = point - below * n;
    line(svg, on_surface - Real(170) * tangent, on_surface + Real(270) * tangent,
         {.stroke = ink, .width = 2.5});
    text(svg, on_surface + Real(262) * tangent + Vec2(12, -6), "the exact surface");
    line(svg, point - d * n - Real(115) * tangent, point - d * n + Real(240) * tangent,
         {.stroke = grey, .width = 1.2, .dash = "5 4"});
    line(svg, point + d * n - Real(115) * tangent, point + d * n + Real(240) * tangent,
         {.stroke = grey, .width = 1.2, .dash = "5 4"});
    rectangle(svg, point - e, Real(2) * e, {.stroke = blue, .width = 2, .fill = "#dcebf5", .opacity = 0.75});
    const Vec2 origin = point + d * n;
    const Vec2 corner(point.x + e.x, point.y - e.y);
    dot_at(svg, corner, blue, 4);
    arrow(svg, point, origin, {.stroke = red, .width = 2.4});
    const Vec2 l = glm::normalize(Vec2(0.9, 0.18));
    arrow(svg, origin, origin + Real(300) * l, {.stroke = green, .width = 2.2});
    dot_at(svg, point, ink, 5);
    dot_at(svg, origin, green, 6);
    text(svg, point + Vec2(-66, 6), "point", label);
    text(svg, origin + Vec2(-30, -16), "origin", colored(label, green));
    text(svg, point + Real(0.5) * d * n + Vec2(-34, -2), "d·n", colored(label, red));
    text(svg, {point.x - 62, point.y - e.y - 9}, "e.x", colored(label, blue));
    text(svg, {point.x - e.x - 40, point.y + e.y / 2}, "e.y", colored(label, blue));
    text(svg, origin + Real(225) * l + Vec2(0, -10), "to the light", colored(SvgFont{.size = 15}, green));
    text(svg, {24, 30}, "d = |n.x|·e.x + |n.y|·e.y + |n.z|·e.z", {.size = 16, .italic = true});
    text(svg, {24, 54}, "The box is where the exact point may be.", note);
    text(svg, {24, 74}, "Along n it reaches from −d to d.", note);
    write_svg(directory / "offset.svg", svg);
}

// Pictures with other shadow rays -----------------------------------------------------------------------

using Method = ShadowRay (*)(const Surface&, const LightSample&);

/// The picture of a world, its shadow rays made by `method`.
Image picture(const World& world, Method method) {
    Image image = make_image(world.view.width, world.view.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Ray ray = pixel_ray(world.view, x + 0.5, y + 0.5);
            Vec3& color = pixel(image, x, y) = world.background;
            const std::optional<Hit> hit = closest_hit(world, ray, {0, infinity});
            if (!hit) continue;
            const Surface surface = surface_at(world, ray, *hit);
            const Vec3 n = dot(surface.shading_normal, ray.direction) > 0 ? -surface.shading_normal
                                                                          : surface.shading_normal;
            const Material material = material_at(world, *hit, surface);
            color = emitted_light(material);
            const auto shine = [&](const LightSample& light) {
                if (!(dot(n, light.direction) > 0)) return;
                const Vec3 part = visibility(world, method(surface, light));
                color += reflected_light(material, n, -ray.direction, light, part);
            };
            for (const PointLight& light : world.point_lights) shine(sample_light(light, surface.point));
            for (const DirectionalLight& light : world.directional_lights)
                shine(sample_light(light, surface.point));
        }
    return image;
}

/// Everything that is a length times `factor`; what these scenes do not have is left out.
void scale(Scene& scene, Real factor) {
    scene.camera.eye *= factor;
    scene.camera.look_at *= factor;
    for (Vec3& vertex : scene.vertices) vertex *= factor;
    for (Material& material : scene.materials) material.checker.size *= factor;
    for (Object& object : scene.objects)
        if (auto* sphere = std::get_if<Sphere>(&object.shape))
            sphere->center *= factor, sphere->radius *= factor;
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) {
            point->position *= factor;
            point->attenuation *= Vec3(1, 1 / factor, 1 / (factor * factor));
        }
}

/// A scene as it is looked at.
Panel shown(const char* name, const char* words) {
    return {render(compile(scene_beside(__FILE__, name))).image, words};
}

void draw_goals(const Path& directory) {
    write_svg(directory / "goals.svg",
              side_by_side({shown("shadows", "two lamps"), shown("sun", "a low sun"),
                            shown("colored", "coloured shadows"), shown("large_floor", "a floor 4000 wide")},
                           2));
}

void draw_acne(const Path& directory) {
    const World world = compile(scene_beside(__FILE__, "shadows", 320, 240));
    write_svg(directory / "acne.svg",
              side_by_side({{picture(world, naive::shadow_ray_without_offset), "no offset"},
                            {picture(world, shadow_ray), "offset"}},
                           2));
}

/// A fixed epsilon of 1e-4 above, the derived offset below, in scenes of three sizes.
void draw_scales(const Path& directory) {
    std::vector<Panel> panels;
    for (const Method method : {Method{naive::shadow_ray_with_epsilon}, Method{shadow_ray}})
        for (const auto& [factor, size] : {std::pair{2e-5, "2·10⁻⁵"}, {1.0, "1"}, {1e12, "10¹²"}}) {
            Scene scene = scene_beside(__FILE__, "shadows", 224, 168);
            scale(scene, factor);
            panels.push_back(
                {picture(compile(scene), method),
                 (method == shadow_ray ? "offset, size " : "ε = 10⁻⁴, size ") + std::string(size)});
        }
    write_svg(directory / "scales.svg", side_by_side(panels, 3));
}

/// Counts of self hits and lost occluders by family and method.
void write_methods(const Path& directory) {
    struct {
        const char* name;
        const char* start;  // as the lesson's table says it
        Method method;
    } const methods[] = {
        {"no offset", "at the point", naive::shadow_ray_without_offset},
        {"fixed epsilon 1e-4", "at the point; hits from 10⁻⁴ on", naive::shadow_ray_with_epsilon},
        {"integer offset with fixed constants", "moved by 256 ulps; near 0 by 1/65536",
         naive::shadow_ray_by_integers},
        {"offset from the error bound", "moved by the error bound", shadow_ray}};
    constexpr std::size_t count = 100'000, part = 10'000;
    std::string csv = "family,extremes,method,shadow rays,self hits,lost occluders\n";
    std::vector<stability::ShadowVerdict> totals(std::size(methods));
    for (const stability::ShadowFamily& family : stability::shadow_families()) {
        std::vector<stability::ShadowVerdict> verdicts(std::size(methods));
        for (std::size_t first = 0; first < count; first += part) {
            const auto cases = stability::make_cases(family, part, 600 + first);
            for (std::size_t i = 0; i < std::size(methods); ++i) {
                std::vector<ShadowRay> rays;
                for (const auto& one : cases) rays.push_back(methods[i].method(one.surface, one.light));
                add(verdicts[i], judge(cases, rays));
            }
        }
        for (std::size_t i = 0; i < std::size(methods); ++i)
            csv += fmt::format("{},\"{}\",{},{},{},{}\n", family.name, family.extremes, methods[i].name,
                               count, verdicts[i].self_hits, verdicts[i].lost);
        for (std::size_t i = 0; i < std::size(methods); ++i) add(totals[i], verdicts[i]);
    }
    write_file(directory / "methods.csv", csv);
    std::string sums = "start,self hits,lost\n";
    for (std::size_t i = 0; i < std::size(methods); ++i)
        sums += fmt::format("{},{},{}\n", methods[i].start, totals[i].self_hits, totals[i].lost);
    write_file(directory / "totals.csv", sums);
    Numbers numbers;
    numbers.add("shadow rays", totals[0].cases);
    numbers.add("shadow rays with a part of the bound", stability::shadow_families().size() * count / 4);
    numbers.write(directory);
}

/// As shadow_ray, its start moved by a part of the error bound only.
template <int Divisor>
ShadowRay less_moved(const Surface& surface, const LightSample& light) {
    Surface better = surface;
    better.error /= Real(Divisor);
    return shadow_ray(better, light);
}

/// How much of the bound is needed: self hits by which part of it the start is moved.
void write_needed(const Path& directory) {
    struct {
        const char* part;
        Method method;
    } const methods[] = {
        {"1/2", less_moved<2>}, {"1/4", less_moved<4>}, {"1/8", less_moved<8>}, {"1/16", less_moved<16>}};
    std::string csv = "part of the bound,self hits\n";
    for (const auto& [part, method] : methods) {
        std::size_t self_hits = 0;
        for (const stability::ShadowFamily& family : stability::shadow_families()) {
            const auto cases = stability::make_cases(family, 25'000, 600);
            std::vector<ShadowRay> rays;
            for (const auto& one : cases) rays.push_back(method(one.surface, one.light));
            self_hits += judge(cases, rays).self_hits;
        }
        csv += fmt::format("{},{}\n", part, self_hits);
    }
    write_file(directory / "needed.csv", csv);
}

// A lamp in the ceiling ---------------------------------------------------------------------------------

/// A room whose lamp is a point of its ceiling.
constexpr const char* room = R"(version 1
size 320 240
encoding srgb
camera 0 1.2 5   0 1.3 0   0 1 0   50
accelerator none
attenuation .3 0 .25
point .3 2.7 -.2   1.3 1.2 1
ambient .03 .03 .035
diffuse .7 .68 .62
plane -3 .1 -5   0 1 0
plane .7 2.7 40   0 -1 0
plane 3 5 -2.1   0 0 1
diffuse .65 .3 .2
plane -2.2 7 1   1 0 0
diffuse .25 .45 .3
plane 2.2 -3 9   -1 0 0
diffuse .6 .5 .3
sphere -.7 .7 -.6 .6
sphere .8 .5 .4 .4
)";

/// As shadow_ray, but up to the lamp itself.
ShadowRay onto_the_lamp(const Surface& surface, const LightSample& light) {
    ShadowRay shadow = shadow_ray(surface, light);
    shadow.range.max = length(light.distance * light.direction - (shadow.ray.origin - surface.point));
    return shadow;
}

void draw_ceiling(const Path& directory) {
    const World world = compile(parse_scene_text(room, "room.scene"));
    write_svg(directory / "ceiling.svg", side_by_side({{picture(world, onto_the_lamp), "onto the lamp"},
                                                       {picture(world, shadow_ray), "just before it"}},
                                                      2));
}

// The shadow of a ball in the sun -----------------------------------------------------------------------

/// A floor under a ball, seen from above: each point sees how much of the sun the ball hides.
Image floor_in_the_sun(Real sun) {
    Image image = make_image(320, 240);
    const Vec3 ball(-0.35, 0.2, 0.9), to_sun = normalize(Vec3(-0.4, 0.25, 1));
    constexpr Real radius = 0.35;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Vec3 floor((x + 0.5 - 160) / 160, (120 - y - 0.5) / 160, 0);
            const Vec3 to_ball = ball - floor;
            const Real moon = std::asin(radius / length(to_ball));
            const Real apart = std::acos(std::min(dot(normalize(to_ball), to_sun), 1.0));
            pixel(image, x, y) = Vec3(0.04) + (1 - eclipsed(sun, moon, apart)) * Vec3(0.8, 0.76, 0.66);
        }
    return image;
}

void draw_eclipse(const Path& directory) {
    write_svg(directory / "eclipse.svg",
              side_by_side({{floor_in_the_sun(1e-6), "a point"}, {floor_in_the_sun(0.2), "a disc"}}, 2));
}

void draw_all(const Path& directory) {
    draw_shadow_ray(directory);
    draw_offset(directory);
    draw_acne(directory);
    draw_goals(directory);
    draw_scales(directory);
    draw_ceiling(directory);
    draw_eclipse(directory);
    write_methods(directory);
    write_needed(directory);
    draw_scenes(directory, __FILE__, {"shadows", "colored", "transformed", "large_floor"}, 240, 180);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw_all); }
