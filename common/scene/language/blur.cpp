// Commands of all that blurs: lights with an extent, the lens, motion, rays that spread.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"
#include "common/scene/mesh_file.hpp"
#include "common/scene/range.hpp"
#include "common/scene/text.hpp"

#include <cmath>

namespace rt::language {

namespace {

constexpr Word<LightSampling> light_samplings[] = {{"angle", LightSampling::Angle},
                                                   {"area", LightSampling::Area}};
constexpr Word<bool> light_choices[] = {{"all", true}, {"one", false}};
constexpr Word<Brdf> brdfs[] = {{"phong", Brdf::Phong}, {"ggx", Brdf::Ggx}};

constexpr Real most_light_samples = 1e4;
constexpr Real most_sides = 1000;

/// Adds a light; the radiance is argument `i` and the next two.
void add_light(Parser& parser, const LightShape& shape, std::size_t i) {
    const Vec3 radiance = color(parser, i);
    not_negative3(parser, i, "radiance");
    parser.scene.area_lights.push_back({{shape, radiance}, place_of(parser, parser.words[0])});
}

/// Refuses two edges that are parallel, or too short to be told from that.
void require_area(const Parser& parser, const Vec3& one, const Vec3& other) {
    if (size_of(one) < smallest_size || size_of(other) < smallest_size ||
        cross(unit(one), unit(other)) == Vec3(0))
        fail(parser, parser.words[0], "this light has no area: its edges have no length, or one direction");
}

void add_quad(Parser& parser) {
    const QuadLight quad{place3(parser, 1), place3(parser, 4), place3(parser, 7)};
    require_area(parser, quad.ab, quad.ac);
    add_light(parser, quad, 10);
}

void add_triangle(Parser& parser) {
    const TriangleLight triangle{place3(parser, 1), place3(parser, 4), place3(parser, 7)};
    require_area(parser, triangle.b - triangle.a, triangle.c - triangle.a);
    add_light(parser, triangle, 10);
}

void add_disc(Parser& parser) {
    const Vec3 normal = near_one(direction(parser, 4, "the normal"));
    add_light(parser, DiscLight{place3(parser, 1), normal, sized(parser, 7, "the radius")}, 8);
}

void add_sphere(Parser& parser) {
    add_light(parser, SphereLight{place3(parser, 1), sized(parser, 4, "the radius")}, 5);
}

/// Each triangle of the file that has an area is a light.
void add_mesh(Parser& parser) {
    const std::string_view word = parser.words[1];
    Mesh mesh;
    std::vector<std::string> warnings;
    try {
        mesh =
            read_mesh(file_named(parser, word), {.lenient = parser.options.lenient, .warnings = &warnings});
    } catch (const InputError& problem) {
        fail(parser, word, std::string("mesh ") + problem.what());
    }
    for (const std::string& warning : warnings) warn(parser, word.data(), "mesh " + warning);
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](const Mesh::Corner& corner) {
            return mesh.positions[static_cast<std::size_t>(corner.position)];
        };
        const TriangleLight triangle{at(a), at(b), at(c)};
        if (cross(unit(triangle.b - triangle.a), unit(triangle.c - triangle.a)) != Vec3(0))
            add_light(parser, triangle, 2);
    }
}

void set_light_samples(Parser& parser) {
    parser.scene.light_samples.count =
        static_cast<int>(whole_setting(parser, "the number of samples of a light", 1, most_light_samples));
}

void set_lens(Parser& parser) {
    Lens& lens = parser.scene.lens;
    lens.radius = not_negative(parser, 1, "the radius of the lens");
    if (lens.radius != 0) sized(parser, 1, "a radius of the lens that is not 0");
    lens.distance = sized(parser, 2, "the distance of the plane in focus");
}

void set_aperture(Parser& parser) {
    Lens& lens = parser.scene.lens;
    lens.sides = static_cast<int>(whole(parser, 1, "the number of sides", 0, most_sides));
    if (lens.sides == 1 || lens.sides == 2)
        fail(parser, parser.words[1], "an aperture has 3 sides or more, or 0 if it is round");
    lens.turn = parser.words.size() > 2 ? radians(number(parser, 2)) : 0;
}

void set_shutter(Parser& parser) {
    Shutter& shutter = parser.scene.shutter;
    shutter = {not_negative(parser, 1, "the part in which the shutter opens"),
               not_negative(parser, 2, "the part in which it closes")};
    if (shutter.opening + shutter.closing > 1)
        fail(parser, parser.words[2], "opening and closing are parts of the whole time: together 1 at most");
}

void set_gloss(Parser& parser, Real Finish::*exponent, const char* noun) {
    parser.finish.*exponent = not_negative(parser, 1, noun);
    if (parser.finish.*exponent > gloss_range.max)
        fail(parser, parser.words[1], std::string(noun) + " is 1e8 at most: that is as good as a mirror");
}

void set_roughness(Parser& parser) {
    parser.finish.roughness = number(parser, 1);
    if (!(parser.finish.roughness >= roughness_range.min && parser.finish.roughness <= roughness_range.max))
        fail(parser, parser.words[1],
             "the roughness must be from 0 to 1, not " + shown(parser.finish.roughness));
}

const CommandRow rows[] = {
    {{"quadLight", "ax ay az bx by bz cx cy cz r g b",
      "Parallelogram that shines: its corner a and, from there, its edges b and c, in world space; r, g, b "
      "is "
      "its radiance, on the side of −(b × c) alone. Area lights are things: they are seen, and stand in "
      "each other's way.",
      "12"},
     add_quad},
    {{"triangleLight", "ax ay az bx by bz cx cy cz r g b",
      "Triangle of three corners that shines on the side from which they run counterclockwise.", "12"},
     add_triangle},
    {{"discLight", "x y z nx ny nz radius r g b",
      "Disc around (x, y, z) that shines to the side of its normal (nx, ny, nz).", "12"},
     add_disc},
    {{"sphereLight", "x y z radius r g b", "Sphere around (x, y, z) that shines outwards.", "12"},
     add_sphere},
    {{"meshLight", "file.obj r g b",
      "The triangles of a Wavefront file, each of them a triangle light; best with `lightchoice one`.", "12"},
     add_mesh},
    {{"lightsamples", "n", "Shadow rays to each area light, from 1 to 10000; default 1.", "12"},
     set_light_samples},
    {{"lightstratify", alternatives(on_or_off),
      "Whether the shadow rays to one light go to cells of their own; default off.", "12"},
     [](Parser& p) { p.scene.light_samples.stratified = choice(p, on_or_off); }},
    {{"lightsampling", alternatives(light_samplings),
      "Whether the random points of an area light are even in the angle that it is seen under (default), or "
      "on its area.",
      "12"},
     [](Parser& p) { p.scene.light_samples.how = choice(p, light_samplings); }},
    {{"lightchoice", alternatives(light_choices),
      "Whether each point asks all area lights (default), or one at random, chosen by its power.", "12"},
     [](Parser& p) { p.scene.light_samples.all = choice(p, light_choices); }},
    {{"lens", "radius distance",
      "Lens of the camera: its radius in world units, 0 for a pinhole (default), and how far along the view "
      "the plane in focus is.",
      "12"},
     set_lens},
    {{"aperture", "sides [turn]",
      "Shape of the lens: a regular polygon in its circle, turned by `turn` degrees counterclockwise; 0 is "
      "the circle (default).",
      "12"},
     set_aperture},
    {{"motion", "dx dy dz",
      "For the objects that follow: they move by this, in world space, while the shutter is open; default 0 "
      "0 "
      "0.",
      "12"},
     [](Parser& p) { p.motion = place3(p, 1); }},
    {{"cameramotion", "dx dy dz", "Likewise for the camera, which keeps its direction.", "12"},
     [](Parser& p) { p.scene.camera_motion = place3(p, 1); }},
    {{"shutter", "opening closing",
      "Which parts of the time the shutter takes to open and to close, evenly; default 0 0, at once.", "12"},
     set_shutter},
    {{"gloss", "exponent",
      "For the objects that follow: mirrored rays spread around the mirror direction as cos^exponent; 0 is "
      "not at all (default).",
      "12"},
     [](Parser& p) { set_gloss(p, &Finish::gloss, "the exponent of the gloss"); }},
    {{"translucency", "exponent", "Likewise refracted rays around the refracted direction.", "12"},
     [](Parser& p) { set_gloss(p, &Finish::translucency, "the exponent of the translucency"); }},
    {{"brdf", alternatives(brdfs),
      "For the objects that follow, in the integrator `direct`: highlights by Phong's lobe (default) or by "
      "GGX. In `raytrace`, `ggx` spreads mirrored and refracted rays by facets, instead of `gloss` and "
      "`translucency`.",
      "12"},
     [](Parser& p) { p.finish.brdf = choice(p, brdfs); }},
    {{"roughness", "alpha", "For the objects that follow: α of GGX, from 0 to 1; default 1.", "12"},
     set_roughness},
    {{"gamma", "g", "8-bit files store light to the power 1/g; default 1. Instead of `encoding`.", "12"},
     [](Parser& p) { p.scene.gamma = sized(p, 1, "the gamma"); }},
};

}  // namespace

std::span<const CommandRow> blur_commands() { return rows; }

}  // namespace rt::language
