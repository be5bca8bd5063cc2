// The scenes of the leave-out table, and for each the smallest renderer that draws it.
// It calls the chapters on its own constants: no World (but for absorption), no kinds, no materials to find.
#include "tests/leave_out/cases.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/01_ray_casting/plane.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/06_shadows/shadow.hpp"
#include "chapters/07_recursion/optics.hpp"
#include "chapters/07_recursion/radiance.hpp"
#include "chapters/10_surfaces/box.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/torus.hpp"
#include "common/world/search.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace rt::test {
namespace {

constexpr Interval everything{0, infinity};

// ------------------------------------------------------------------------- shapes, as data and as a scene's
// text

// All coordinates are multiples of 1/32, so that the text says them exactly.
constexpr std::uint32_t count = 32, half = count / 2;

/// 8 × 4 balls, none of which touches another.
constexpr std::array<Sphere, count> make_balls() {
    std::array<Sphere, count> balls{};
    for (std::uint32_t i = 0; i < count; ++i)
        balls[i] = {Vec3(i % 8 - 3.5, i / 8 - 1.5, 0.25 * (i % 5)), 0.4375};
    return balls;
}
constexpr std::array<Sphere, count> balls = make_balls();
constexpr std::array<Sphere, 1> ball = {Sphere{Vec3(0), 0.5}};

/// A valley that goes down and away.
constexpr std::array<Plane, 2> planes = {Plane{{0, -1, 6}, {2, 2, -1.5}}, Plane{{0, -1, 6}, {-2, 2, -1.5}}};

/// The corners of 4 × 4 squares in a wavy sheet, five to a row.
constexpr Vec3 sheet_corner(std::uint32_t i) {
    const std::uint32_t x = i % 5, y = i / 5;
    return {x - 2.0, y - 2.0, 0.25 * ((x + y) % 3)};
}
constexpr std::uint32_t corners = 25;

/// The corners of triangle i of the sheet.
constexpr std::array<std::uint32_t, 3> sheet_indices(std::uint32_t i) {
    const std::uint32_t square = i / 2, low = square / 4 * 5 + square % 4;
    if (i % 2 == 0) return {low, low + 1, low + 6};
    return {low, low + 6, low + 5};
}
constexpr std::array<Triangle, count> make_sheet(const Vec3& moved) {
    std::array<Triangle, count> sheet{};
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto [a, b, c] = sheet_indices(i);
        sheet[i] = {sheet_corner(a) + moved, sheet_corner(b) + moved, sheet_corner(c) + moved};
    }
    return sheet;
}
constexpr std::array<Triangle, count> sheet = make_sheet(Vec3(0));
constexpr std::array<Triangle, count> moved_sheet = make_sheet({0.5, 0, -1});

/// 8 × 4 boxes, cones and tori, apart like the balls.
constexpr std::array<Box, count> make_boxes() {
    std::array<Box, count> boxes{};
    for (std::uint32_t i = 0; i < count; ++i)
        boxes[i] = {balls[i].center - Vec3(0.375, 0.25, 0.4375), balls[i].center + Vec3(0.375, 0.4375, 0.25)};
    return boxes;
}
constexpr std::array<Box, count> boxes = make_boxes();
constexpr std::array<Cone, count> make_cones() {
    std::array<Cone, count> cones{};
    for (std::uint32_t i = 0; i < count; ++i)
        cones[i] = {balls[i].center - Vec3(0.25, 0.375, 0), i % 3 * 0.125,
                    balls[i].center + Vec3(0.125, 0.375, 0.25), 0.375};
    return cones;
}
constexpr std::array<Cone, count> cones = make_cones();
constexpr std::array<Torus, count> make_tori() {
    std::array<Torus, count> tori{};
    for (std::uint32_t i = 0; i < count; ++i)
        tori[i] = {balls[i].center, Vec3(i % 4 - 1.5, 1, i % 3), 0.25, 0.09375};
    return tori;
}
constexpr std::array<Torus, count> tori = make_tori();

std::string text(const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string text(const Sphere& s) { return fmt::format("sphere {} {}\n", text(s.center), s.radius); }
std::string text(const Plane& p) { return fmt::format("plane {} {}\n", text(p.point), text(p.normal)); }

std::string text(const Box& b) { return fmt::format("box {} {}\n", text(b.low), text(b.high)); }
/// And as many cubes with round corners.
const std::vector<Implicit>& implicits() {
    static const std::vector<Implicit> all = [] {
        std::vector<Implicit> made;
        for (const Sphere& one : balls) {
            const auto& [x, y, z] = std::array{one.center.x, one.center.y, one.center.z};
            const std::string f =
                fmt::format("(x-({}))^4+(y-({}))^4+(z-({}))^4-{}", x, y, z, std::pow(0.375, 4));
            made.push_back({{one.center - Vec3(0.4375), one.center + Vec3(0.4375)},
                            std::make_shared<const Formula>(parse_formula(f))});
        }
        return made;
    }();
    return all;
}

std::string text(const Implicit& s) {
    return fmt::format("implicit {} {} {}\n", text(s.box.low), text(s.box.high), s.f->text);
}

std::string text(const Cone& c) {
    return fmt::format("cone {} {} {} {}\n", text(c.a), c.radius_a, text(c.b), c.radius_b);
}
std::string text(const Torus& t) {
    return fmt::format("torus {} {} {} {}\n", text(t.center), text(t.axis), t.ring, t.tube);
}

const std::string base = "size 64 48\ncamera 0 1 6 0 0 0 0 1 0 40\n";
// The minimal renderers ask every shape, so what they are compared with does too.
const std::string head = base + "accelerator none\n";
const std::string red = "ambient .125 .0625 .0625\ndiffuse .75 .25 .25\n";
const std::string blue = "ambient .0625 .0625 .125\ndiffuse .25 .25 .75\n";

/// The balls, the first half after the lines `first`, the second after `second`.
std::string balls_text(const std::string& first = red, const std::string& second = blue,
                       const std::string& around = "") {
    std::string lines = first;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == half) lines += second;
        lines += around.empty() ? text(balls[i])
                                : fmt::format("pushTransform\ntranslate {}\n{}sphere 0 0 0 1\npopTransform\n",
                                              text(balls[i].center), around);
    }
    return lines;
}

/// The first half of the shapes red, the second blue.
template <class Shapes>
std::string halves_text(const Shapes& shapes) {
    std::string lines = red;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == half) lines += blue;
        lines += text(shapes[i]);
    }
    return lines;
}

std::string sheet_text(bool smooth) {
    std::string lines = red;
    for (std::uint32_t i = 0; i < corners; ++i)
        lines += smooth
                     ? fmt::format("vertexnormal {} {} 0 1\n", text(sheet_corner(i)), 0.25 * (i % 3) - 0.25)
                     : fmt::format("vertex {}\n", text(sheet_corner(i)));
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == half) lines += blue;
        const auto [a, b, c] = sheet_indices(i);
        lines += fmt::format("{} {} {} {}\n", smooth ? "trinormal" : "tri", a, b, c);
    }
    return lines;
}

const std::string lamp_text = "point 4 6 5 1 1 1\n";
const std::string sun_text = "directional 0 0 2 .5 .5 .5\n";
const PointLight lamp{.position = {4, 6, 5}, .color = Vec3(1)};
const DirectionalLight sun{.direction = {0, 0, 1}, .color = Vec3(0.5)};

Material matte(const Vec3& ambient, const Vec3& diffuse) {
    Material material;
    material.ambient = ambient;
    material.diffuse = diffuse;
    return material;
}
const Vec3 glow[2] = {{.125, .0625, .0625}, {.0625, .0625, .125}};
const Material mattes[2] = {matte(glow[0], {.75, .25, .25}), matte(glow[1], {.25, .25, .75})};

// ------------------------------------------------------------------------------------------------ renderers

Vec3 towards_viewer(const Vec3& n, const Ray& ray) { return dot(n, ray.direction) > 0 ? -n : n; }

Vec3 glowing_ball(const World&, const Ray& ray, Stream&) {
    return closest_hit(ball, ray, everything) ? glow[0] : Vec3(0);
}

Vec3 glowing_planes(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(planes, ray, everything);
    return hit ? glow[hit->primitive] : Vec3(0);
}

Vec3 glowing_sheet(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(sheet, ray, everything);
    return hit ? glow[hit->primitive >= half] : Vec3(0);
}

Vec3 glowing_balls(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(balls, ray, everything);
    return hit ? glow[hit->primitive >= half] : Vec3(0);
}

Vec3 glowing_boxes(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(std::span<const Box>(boxes), ray, everything);
    return hit ? glow[hit->primitive >= half] : Vec3(0);
}

Vec3 glowing_cones(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(std::span<const Cone>(cones), ray, everything);
    return hit ? glow[hit->primitive >= half] : Vec3(0);
}

Vec3 glowing_tori(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(std::span<const Torus>(tori), ray, everything);
    return hit ? glow[hit->primitive >= half] : Vec3(0);
}

Vec3 glowing_implicits(const World&, const Ray& ray, Stream&) {
    const std::optional<Hit> hit = closest_hit(std::span<const Implicit>(implicits()), ray, everything);
    return hit ? glow[hit->primitive >= half] : Vec3(0);
}

template <class Shapes>
Vec3 normals(const Shapes& shapes, const Ray& ray) {
    const std::optional<Hit> hit = closest_hit(shapes, ray, everything);
    if (!hit) return Vec3(0);
    const Surface surface = surface_at(shapes[hit->primitive], ray, *hit);
    return 0.5 * (towards_viewer(surface.shading_normal, ray) + Vec3(1));
}

Vec3 normals_of_balls(const World&, const Ray& ray, Stream&) { return normals(balls, ray); }
Vec3 normals_of_sheet(const World&, const Ray& ray, Stream&) { return normals(sheet, ray); }

/// Matte shapes, `red_ones` of them red and the rest blue, under lights that throw shadows.
template <std::uint32_t red_ones, class Shapes, class... Lights>
Vec3 lit(const Shapes& shapes, const Ray& ray, const Lights&... lights) {
    const std::optional<Hit> hit = closest_hit(shapes, ray, everything);
    if (!hit) return Vec3(0);
    const Surface surface = surface_at(shapes[hit->primitive], ray, *hit);
    const Vec3 n = towards_viewer(surface.shading_normal, ray);
    const Material& material = mattes[hit->primitive >= red_ones];
    Vec3 sum = emitted_light(material);
    const auto add = [&](const LightSample& light) {
        if (!(dot(n, light.direction) > 0)) return;
        ++ray_counts().shadow;
        const ShadowRay shadow = shadow_ray(surface, light);
        if (any_hit(shapes, shadow.ray, shadow.range)) return;
        sum += reflected_light(material, n, -ray.direction, light, Vec3(1));
    };
    (add(sample_light(lights, surface.point)), ...);
    return sum;
}

Vec3 balls_by_lamp(const World&, const Ray& ray, Stream&) { return lit<half>(balls, ray, lamp); }
Vec3 balls_by_sun(const World&, const Ray& ray, Stream&) { return lit<half>(balls, ray, sun); }
Vec3 balls_by_both(const World&, const Ray& ray, Stream&) { return lit<half>(balls, ray, lamp, sun); }
Vec3 moved_sheet_by_lamp(const World&, const Ray& ray, Stream&) { return lit<count>(moved_sheet, ray, lamp); }

// The first half of the balls is of clear glass, the second glows.

/// Chapter 7's loop, with nothing said about absorption.
Vec3 glass_balls(const World& world, const Ray& ray, Stream&) {
    Vec3 sum(0);
    Branch camera;
    camera.ray = ray;
    std::vector<Branch> stack{camera};
    while (!stack.empty()) {
        const Branch branch = std::move(stack.back());
        stack.pop_back();
        const std::optional<Hit> hit = closest_hit(world, branch.ray, everything);
        if (!hit) {
            sum += branch.weight * background(world, branch.ray.direction);
            continue;
        }
        const Surface surface = surface_at(world, branch.ray, *hit);
        const Material material = material_at(world, *hit, surface);
        const Vec3 n = towards_viewer(surface.shading_normal, branch.ray);
        sum += branch.weight * local_light(world, surface, material, n, -branch.ray.direction);
        Branches next = scatter(world, branch, *hit, surface, material);
        for (int i = next.count - 1; i >= 0; --i) {
            Branch& one = next.branch[static_cast<std::size_t>(i)];
            ++(one.kind == RayKind::Reflection ? ray_counts().reflection : ray_counts().refraction);
            stack.push_back(std::move(one));
        }
    }
    return sum;
}

/// As somebody does it who knows that no ball is inside another: recursion, and for the medium one bit.
void add_glass(const Ray& ray, const Vec3& weight, int depth, bool inside, Vec3& sum) {
    const std::optional<Hit> hit = closest_hit(balls, ray, everything);
    if (!hit) return;
    if (hit->primitive >= half) {
        sum += weight * glow[1];
        return;
    }
    if (depth == 5) return;
    const Surface surface = surface_at(balls[hit->primitive], ray, *hit);
    const Vec3& d = ray.direction;
    const Vec3 n = towards_viewer(surface.normal, ray);
    const Real eta = inside ? 1.5 : 1 / 1.5;
    const Real r = fresnel(std::min(-dot(d, n), Real(1)), eta);
    const std::optional<Vec3> through = refract(d, n, eta);
    const Vec3 mirrored = reflect(d, n);
    ++ray_counts().reflection;
    add_glass({offset_origin(surface, mirrored), mirrored}, weight * (through ? r : 1), depth + 1, inside,
              sum);
    if (!through) return;
    ++ray_counts().refraction;
    add_glass({offset_origin(surface, *through), *through}, weight * (Vec3(0.875) * (1 - r)), depth + 1,
              !inside, sum);
}

Vec3 separate_glass_balls(const World&, const Ray& ray, Stream&) {
    Vec3 sum(0);
    add_glass(ray, Vec3(1), 0, false, sum);
    return sum;
}

// --------------------------------------------------------------------------------------------------- memory

/// What any renderer keeps of `shapes`, some materials and some lights: the numbers, and for each shape 20
/// bytes that say where it stood in the file, to which object it belongs and what it is made of.
template <class Shapes>
std::size_t memory(const Shapes& shapes, std::size_t materials, std::size_t lamps = 0, std::size_t suns = 0) {
    return std::size(shapes) * (sizeof(shapes[0]) + 20) + materials * sizeof(Material) +
           lamps * sizeof(PointLight) + suns * sizeof(DirectionalLight);
}

}  // namespace

View view() {
    const Camera camera{.eye = {0, 1, 6}, .look_at = Vec3(0), .fovy = radians(40)};
    return {camera_frame(camera), camera.eye, Projection::Perspective, std::tan(camera.fovy / 2), 64, 48};
}

std::vector<Case> cases() {
    const std::string glass = "ambient 0 0 0\ntransmission .875 .875 .875\nior 1.5\nfresnel exact\n";
    const std::string opaque = "ambient .0625 .0625 .125\ntransmission 0 0 0\n";
    const std::string planes_text = red + text(planes[0]) + blue + text(planes[1]);
    const std::string hidden_triangle = "vertex 0 0 9\nvertex 1 0 9\nvertex 0 1 9\ntri 0 1 2\n";
    const std::string hidden_plane = "plane 0 0 9 0 0 1\n";
    std::size_t programs = 0;
    for (const Implicit& one : implicits()) programs += owned_bytes(one);
    const std::string mesh = "mesh sheet.obj\n", out_of_sight = "translate 0 0 50\n";
    return {
        {.feature = "other kinds than one sphere",
         .scene = head + red + text(ball[0]),
         .with_feature = head + red + text(ball[0]) + hidden_plane + hidden_triangle,
         .minimal = glowing_ball,
         .bytes = memory(ball, 1)},
        {.feature = "other kinds than planes",
         .scene = head + planes_text,
         .with_feature = head + planes_text + hidden_triangle,
         .minimal = glowing_planes,
         .bytes = memory(planes, 2)},
        {.feature = "other kinds than triangles",
         .scene = head + sheet_text(false),
         .with_feature = head + sheet_text(false) + hidden_plane,
         .minimal = glowing_sheet,
         .bytes = memory(sheet, 2)},
        {.feature = "other kinds than boxes",
         .scene = head + halves_text(boxes),
         .with_feature = head + halves_text(boxes) + hidden_triangle,
         .minimal = glowing_boxes,
         .bytes = memory(boxes, 2)},
        {.feature = "other kinds than cones",
         .scene = head + halves_text(cones),
         .with_feature = head + halves_text(cones) + hidden_triangle,
         .minimal = glowing_cones,
         .bytes = memory(cones, 2)},
        {.feature = "other kinds than tori",
         .scene = head + halves_text(tori),
         .with_feature = head + halves_text(tori) + hidden_triangle,
         .minimal = glowing_tori,
         .bytes = memory(tori, 2)},
        {.feature = "other kinds than implicit surfaces",
         .scene = head + halves_text(implicits()),
         .with_feature = head + halves_text(implicits()) + hidden_triangle,
         .minimal = glowing_implicits,
         .bytes = memory(implicits(), 2) + programs},
        {.feature = "shadow rays: no lights",
         .scene = head + balls_text(),
         .with_feature = head + lamp_text + balls_text(),
         .minimal = glowing_balls,
         .bytes = memory(balls, 2)},
        {.feature = "black lights",
         .scene = head + lamp_text + "point 1 2 3 0 0 0\ndirectional 1 1 1 0 0 0\n" + balls_text(),
         .with_feature =
             head + lamp_text + "point 1 2 3 .1 .1 .1\ndirectional 1 1 1 .1 .1 .1\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "highlights",
         .scene = head + "maxdepth 0\n" + sun_text + balls_text(),
         .with_feature =
             head + "maxdepth 0\n" + sun_text + "specular .5 .5 .5\nshininess 20\n" + balls_text(),
         .minimal = balls_by_sun,
         .bytes = memory(balls, 2, 0, 1)},
        {.feature = "patterns",
         .scene = head + lamp_text + sun_text + balls_text(),
         .with_feature = head + lamp_text + sun_text + "checker 1 1 1 .5 .5 .5 .25\n" + balls_text(),
         .minimal = balls_by_both,
         .bytes = memory(balls, 2, 1, 1)},
        {.feature = "textures",
         .scene = head + lamp_text + sun_text + balls_text(),
         .with_feature = head + lamp_text + sun_text + "stripes 1 1 1 .5 .5 .5 .25\n" + balls_text(),
         .minimal = balls_by_both,
         .bytes = memory(balls, 2, 1, 1)},
        {.feature = "bumps",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "bumps .01 .1\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "normal maps",
         .scene = head + lamp_text + balls_text(),
         .with_feature =
             head + lamp_text + "normalmap ../../references/11_textures/figures/bricks.png\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "finishes",
         .scene = head + lamp_text + sun_text + balls_text(),
         .with_feature = head + lamp_text + sun_text + "finish matte 1\n" + balls_text(),
         .minimal = balls_by_both,
         .bytes = memory(balls, 2, 1, 1)},
        {.feature = "a sky, and its light",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + "skyGradient 0 0 1 0 1 0 1 0 0\nskylight on\n" + lamp_text + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "a lens",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + "lens .1 4\n" + lamp_text + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "motion",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "motion .1 0 0\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "turns",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "spin 0 1 0 30\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "area lights",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "quadLight 1 3 1  0 0 1  1 0 0  1 1 1\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "gloss",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "specular .5 .5 .5\ngloss 20\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "facets",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "specular .5 .5 .5\nbrdf ggx\nroughness .3\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "coloured shadows",
         .scene = head + "maxdepth 0\n" + lamp_text + sun_text + balls_text(),
         .with_feature =
             head + "maxdepth 0\n" + lamp_text + sun_text + balls_text(red, blue + "transmission .5 .5 .9\n"),
         .minimal = balls_by_both,
         .bytes = memory(balls, 2, 1, 1)},
        {.feature = "reflected and refracted rays",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + lamp_text + "specular .5 .5 .5\n" + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "absorption",
         .scene = head + balls_text(glass, opaque),
         .with_feature = head + balls_text(glass + "absorption .5 .25 .125\n", opaque),
         .minimal = glass_balls,
         .bytes = memory(balls, 2),
         .given_world = true},
        {.feature = "media inside media",
         .scene = head + balls_text(glass, opaque),
         .with_feature = head + glass + "sphere 0 0 0 3\n" + balls_text(glass, opaque),
         .minimal = separate_glass_balls,
         .bytes = memory(balls, 2),
         .judged = false},
        {.feature = "matrices",
         .scene = head + lamp_text + balls_text(red, blue, "scale .4375 .4375 .4375\nrotate 1 2 3 40\n"),
         .with_feature =
             head + lamp_text + balls_text(red, blue, "scale .4375 .4375 .375\nrotate 1 2 3 40\n"),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "instances",
         .scene = head + lamp_text + red + "translate .5 0 -1\n" + mesh,
         .with_feature = head + lamp_text + red + "translate .5 0 -1\n" + mesh + out_of_sight + mesh +
                         out_of_sight + mesh + out_of_sight + mesh + out_of_sight + mesh,
         .minimal = moved_sheet_by_lamp,
         .bytes = memory(sheet, 1, 1)},
        {.feature = "interpolated normals",
         .scene = head + "integrator normals\n" + sheet_text(false),
         .with_feature = head + "integrator normals\n" + sheet_text(true),
         .minimal = normals_of_sheet,
         .bytes = memory(sheet, 2)},
        {.feature = "several samples a pixel, random numbers",
         .scene = head + balls_text(),
         .with_feature = head + "spp 4\n" + balls_text(),
         .minimal = glowing_balls,
         .bytes = memory(balls, 2)},
        {.feature = "wide filters",
         .scene = head + lamp_text + balls_text(),
         .with_feature = head + "filter tent\n" + lamp_text + balls_text(),
         .minimal = balls_by_lamp,
         .bytes = memory(balls, 2, 1)},
        {.feature = "grids: too few shapes",
         .scene = base + red + text(ball[0]),
         .with_feature = base + "accelerator grid\n" + red + text(ball[0]),
         .minimal = glowing_ball,
         .bytes = memory(ball, 1)},
        {.feature = "hierarchies: too few shapes",
         .scene = base + red + text(ball[0]),
         .with_feature = base + "accelerator bvh\n" + red + text(ball[0]),
         .minimal = glowing_ball,
         .bytes = memory(ball, 1)},
        {.feature = "texture coordinates",
         .scene = head + "integrator normals\n" + balls_text(),
         .with_feature = head + "integrator uv\n" + balls_text(),
         .minimal = normals_of_balls,
         .bytes = memory(balls, 2)},
    };
}

}  // namespace rt::test
