// Random scenes: each function makes up one kind of statement.
#include "common/evidence/random_scenes.hpp"

#include "common/image/file.hpp"
#include "common/math/random.hpp"
#include "common/scene/integrators.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace rt {
namespace {

/// The text so far, the random numbers, and what later statements must know.
struct Author {
    Random random;
    std::string text{};
    std::string integrator = "raytrace";
    bool lit = false;      ///< there are lights
    bool dim = false;      ///< no light may be over 1: samples are averaged, and POV-Ray clamps each
    bool tame = false;     ///< says little that POV-Ray cannot express
    bool blurred = false;  ///< there are a lens, motion and lights with an extent
    Real unit = 1;         ///< of all lengths
    int depth = 5;         ///< of bounces
    std::size_t vertices = 0;
    std::size_t normals = 0;

    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text += fmt::format(format, std::forward<Args>(args)...) + '\n';
    }
    bool chance(Real share) { return random_real(random) < share; }
    Real uniform(Real low, Real high) { return low + (high - low) * random_real(random); }
    int whole(int low, int high) {
        return low + static_cast<int>(random_index(random, static_cast<std::uint64_t>(high - low + 1)));
    }
    const char* one_of(std::initializer_list<const char*> words) {
        return words.begin()[random_index(random, words.size())];
    }
};

std::string triple(const Vec3& v) { return fmt::format("{:.7g} {:.7g} {:.7g}", v.x, v.y, v.z); }

Vec3 in_box(Author& a, const Vec3& low, const Vec3& high) {
    const Real x = a.uniform(low.x, high.x), y = a.uniform(low.y, high.y);
    return {x, y, a.uniform(low.z, high.z)};
}

/// A colour, sometimes grey and sometimes without a channel.
std::string color(Author& a, Real greatest) {
    if (a.chance(0.2)) return triple(Vec3(a.uniform(0, greatest)));
    Vec3 c = in_box(a, Vec3(0), Vec3(greatest));
    if (a.chance(0.2)) c[static_cast<int>(random_index(a.random, 3))] = 0;
    return triple(c);
}

void write_picture(Author& a) {
    a.line("version 1\nsize 64 48");
    if (a.chance(0.2)) a.line("output random.png");
    if (a.chance(0.5)) a.line("encoding {}", a.one_of({"linear", "srgb"}));
    const Vec3 eye = in_box(a, Vec3(-2, 0.5, 4), Vec3(2, 2.5, 7)), to = in_box(a, Vec3(-0.4), Vec3(0.4));
    a.line("camera {} {} {} {:.4g}", triple(a.unit * eye), triple(a.unit * to),
           triple(in_box(a, Vec3(-0.4, 1, -0.4), Vec3(0.4, 2, 0.4))), a.uniform(25, 60));
    if (a.chance(0.2)) a.line("orthographic {:.5g}", a.unit * a.uniform(2, 5));
    if (a.integrator == rasterize_word && a.random.key % 2 == 0)
        a.line("integrator {}\nvisibility rasterize", a.random.key % 4 == 0 ? "normals" : "flat");
    else if (a.integrator != "raytrace" || a.chance(0.3))
        a.line("integrator {}", a.integrator);
    a.line("background {}", color(a, a.dim ? 0.3 : 0.8));
    if (a.chance(0.15)) a.line("shadows {}", a.one_of({"on", "off", "off"}));
    if (a.chance(0.7)) {
        a.depth = a.chance(0.2) ? 0 : a.whole(1, 8);
        a.line("maxdepth {}", a.depth);
    }
    if (a.chance(0.1)) a.line("mincontribution {:.3g}", a.tame ? 0 : a.uniform(0.001, 0.1));
    if (a.chance(0.2))
        a.line("accelerator {}",
               a.one_of({"auto", "none", "grid", "nested", "bvh", "spheres", "obb", "ellipsoids"}));
}

/// Only patterns that POV-Ray can repeat: random samples are not equal to any others.
void write_sampling(Author& a) {
    const bool several = a.dim;
    if (several) {
        switch (a.whole(0, 2)) {
            case 0:
                a.line("sampler regular\nspp {}", a.one_of({"4", "9"}));
                if (a.chance(0.6)) a.line("filter {}", a.one_of({"box", "tent", "gaussian", "mitchell"}));
                break;
            case 1:
                a.line("sampler trapezoid\nspp {}", a.one_of({"4", "9", "25"}));
                break;
            default:
                a.line("sampler centered\nspp {}", a.one_of({"5", "10"}));
        }
    } else if (a.chance(0.2)) {
        a.line("spp 1\nfilter {}", a.one_of({"tent", "gaussian", "mitchell"}));
    }
    if (a.chance(0.1)) a.line("adaptive off\nseed {}", a.whole(0, 1000));
}

void write_lights(Author& a) {
    a.lit = a.chance(0.75);
    if (!a.lit) return;
    const int count = a.whole(1, 3);
    for (int i = 0; i < count; ++i) {
        const Real power = (a.dim ? 0.25 : 0.9) / count;
        if (a.chance(0.35)) {
            a.line("directional {} {}", triple(in_box(a, Vec3(-1, 0.3, -0.5), Vec3(1, 1.5, 1.5))),
                   color(a, power));
            continue;
        }
        // Divided by about 1 at the distance of things, whichever terms there are.
        const Real c = a.uniform(0.2, 1), l = a.uniform(0.05, 0.3) / a.unit,
                   q = a.uniform(0.01, 0.06) / a.unit / a.unit;
        const std::array<Vec3, 6> kinds = {Vec3(1, 0, 0), Vec3(c, l, 0),        Vec3(c, 0, q),
                                           Vec3(0, l, 0), Vec3(0.05 * c, l, q), Vec3(c, l, q)};
        a.line("attenuation {}", triple(kinds[random_index(a.random, a.tame ? 5 : kinds.size())]));
        a.line("point {} {}", triple(a.unit * in_box(a, Vec3(-4, 2, 0), Vec3(4, 6, 6))), color(a, power));
    }
}

/// Sets anew what varies the material. Noise is seldom: POV-Ray has its own, and knows no normal maps. Those,
/// and pictures on what had none at first, have random numbers of their own, so that older scenes remain.
void write_texturing(Author& a, bool had_pictures) {
    Author own{random_for(a.random.key, a.random.dimension, 2)};
    Author& of_picture = had_pictures ? a : own;
    const bool has_picture = of_picture.chance(0.15);
    if (has_picture && of_picture.chance(0.3))
        a.line("texturewrap {}", of_picture.one_of({"repeat", "mirror", "clamp"}));
    if (has_picture && of_picture.chance(0.5))
        a.line("texturefilter {}",
               a.tame ? of_picture.one_of({"nearest", "bilinear", "bilinear", "bilinear", "bilinear"})
                      : of_picture.one_of({"nearest", "bilinear", "bilinear", "trilinear", "anisotropic"}));
    a.line("texture {}", has_picture ? "random.png" : "off");
    a.line("normalmap {}", own.chance(0.03) && !a.tame ? "random.png" : "off");
    if (a.chance(0.15))
        a.line("{} {} {} {:.5g}",
               a.one_of({"stripes", "rings", "gradient", "stripes", "rings", "gradient", "marble", "wood",
                         a.tame ? "wood" : "cells"}),
               color(a, 1), color(a, 1), a.unit * a.uniform(0.2, 1));
    else
        a.line("stripes 1 1 1 1 1 1 1");
    if (a.chance(0.1))
        a.line("textured {}", a.one_of({"diffuse", "specular diffuse", "transmission", "emission ambient"}));
    else
        a.line("textured ambient diffuse emission");
    if (own.chance(0.1) && !a.tame)
        a.line("textured {}", own.one_of({"gloss translucency", "roughness", "diffuse gloss roughness",
                                          "finish coat", "shininess translucency"}));
    const bool is_plain = !a.chance(0.05);
    const auto finish = is_plain ? "plain" : a.one_of({"matte", "velvet .3", "metal .4", "coated 1.4"});
    a.line("finish {}", a.tame ? "plain" : finish);
    a.line("bumps {} {:.5g}", a.chance(0.03) ? fmt::format("{:.5g}", a.unit * 0.01) : "0", a.unit * 0.1);
}

/// A sky of several colours, or in a picture.
void write_sky(Author& a) {
    if (a.chance(0.5)) {
        const Real bright = a.dim ? 0.3 : 0.8;
        a.line("skyGradient {} {} {}", color(a, bright), color(a, bright), color(a, bright));
    } else {
        a.line("environmentmap {}", a.one_of({"latlong", "latlong", "latlong", "mirrorball", "angular"}));
        a.line("environment random.png {:.5g}", a.uniform(-180, 180));
    }
    if (a.chance(0.2)) a.line("skylight on");
}

/// Sets the material anew for the next object. `glassy` is the share of transparent ones, which are seldom
/// anything else.
void write_material(Author& a, Real glassy) {
    const Real bright = a.dim ? 0.3 : 1;
    const bool glass = a.chance(glassy);
    a.line("ambient {}", glass ? "0 0 0" : color(a, 0.4 * bright));
    a.line("emission {}", a.chance(0.2) ? color(a, 0.3 * bright) : "0 0 0");
    a.line("diffuse {}", glass && a.chance(0.8) ? "0 0 0" : color(a, 0.9));
    const bool mirrors = a.chance(glass ? 0.25 : 0.4) && !(glass && a.tame);
    a.line("specular {}", mirrors ? color(a, 0.4) : "0 0 0");
    a.line("shininess {:.4g}", a.chance(0.1) ? 0 : std::exp(a.uniform(0, 5)));
    a.line("highlight {}", a.one_of({"blinn", "blinn", "phong"}));
    if (a.chance(0.25))
        a.line("checker {} {} {:.5g}", color(a, 1), color(a, 1), a.unit * a.uniform(0.2, 1));
    else
        a.line("checker 1 1 1 1 1 1 1");
    const bool absorbs = a.chance(a.lit ? 0.1 : 0.5);
    a.line("transmission {}", !glass ? "0 0 0" : a.chance(0.5) ? color(a, 1) : "1 1 1");
    a.line("ior {:.4g}", a.chance(0.2) ? 1 : a.uniform(0.7, 2.2));
    const auto fresnel = a.one_of({"none", "none", "none", "exact", "exact", "exact", "exact", "schlick"});
    a.line("fresnel {}", a.tame && fresnel == std::string_view("schlick") ? "exact" : fresnel);
    a.line("absorption {}", glass && absorbs ? triple(in_box(a, Vec3(0), Vec3(1)) / a.unit) : "0 0 0");
}

/// Takes the mirror from what has smooth normals: POV-Ray's rays go on into the body where ours do not.
void write_no_mirror(Author& a) {
    if (a.depth > 0) a.line("specular 0 0 0");
}

/// Moves, turns and stretches what follows.
void write_transform(Author& a) {
    a.line("pushTransform\ntranslate {}", triple(a.unit * in_box(a, Vec3(-1), Vec3(1))));
    if (a.chance(0.6)) a.line("rotate {} {:.5g}", triple(in_box(a, Vec3(-1), Vec3(1))), a.uniform(-180, 180));
    if (a.chance(0.6)) a.line("scale {}", triple(in_box(a, Vec3(0.5), Vec3(1.5))));
    if (a.chance(0.1)) a.line("scale -1 1 1");
}

void write_sphere(Author& a) {
    if (a.chance(0.05)) {  // a room
        a.line("sphere 0 0 0 {:.5g}", a.unit * a.uniform(12, 20));
        return;
    }
    a.line("sphere {} {:.5g}", triple(a.unit * in_box(a, Vec3(-1.6, -0.6, -1.6), Vec3(1.6, 1.2, 1.6))),
           a.unit * a.uniform(0.15, 0.9));
}

void write_triangle(Author& a) {
    const Vec3 middle = in_box(a, Vec3(-1, -0.5, -1), Vec3(1));
    const bool smooth = a.chance(0.5);
    const Vec3 normal = in_box(a, Vec3(-0.3), Vec3(0.3)) + Vec3(0, 0, 1);
    for (int i = 0; i < 3; ++i) {
        // Around the middle, so that it is no needle.
        const Real angle = a.uniform(0.2, 1.9) + i * 2 * pi / 3, r = a.uniform(0.5, 1.1);
        const Vec3 p =
            a.unit * (middle + Vec3(r * std::cos(angle), r * std::sin(angle), a.uniform(-0.3, 0.3)));
        if (smooth)
            a.line("vertexnormal {} {}", triple(p),
                   triple(a.uniform(0.5, 2) * (normal + in_box(a, Vec3(-0.2), Vec3(0.2)))));
        else
            a.line("vertex {}", triple(p));
    }
    std::size_t& first = smooth ? a.normals : a.vertices;
    if (smooth) write_no_mirror(a);
    a.line("{} {} {} {}", smooth ? "trinormal" : "tri", first, first + 1, first + 2);
    first += 3;
}

/// A star around the origin of its own space, where it is flat whatever the numbers; concave as a rule.
void write_polygon(Author& a) {
    const int corners = a.whole(4, 9);
    std::string indices;
    for (int i = 0; i < corners; ++i) {
        const Real angle = 2 * pi * i / corners, r = a.uniform(0.4, 1.1);
        a.line("vertex {}", triple(a.unit * Vec3(r * std::cos(angle), r * std::sin(angle), 0)));
        indices += fmt::format(" {}", a.vertices++);
    }
    write_transform(a);
    a.line("polygon{}\npopTransform", indices);
}

/// The end of a rod, or of a box, beside a middle.
std::string near_middle(Author& a, const Vec3& middle, const Vec3& low, const Vec3& high) {
    return triple(a.unit * (middle + in_box(a, low, high)));
}

/// A ring, seldom one that is closed to a spindle.
void write_torus(Author& a) {
    const Real ring = a.unit * a.uniform(0.25, 0.7),
               part = a.chance(0.85) ? a.uniform(0.1, 0.9) : a.uniform(1, 2);
    a.line("torus {} {} {:.5g} {:.5g}",
           triple(a.unit * in_box(a, Vec3(-1.4, -0.5, -1.4), Vec3(1.4, 0.9, 1.4))),
           triple(in_box(a, Vec3(-1), Vec3(1))), ring, part * ring);
}

/// A closed surface f = 0, in a space of its own whose unit it knows.
void write_implicit(Author& a) {
    a.line("pushTransform\ntranslate {}",
           triple(a.unit * in_box(a, Vec3(-1.2, -0.4, -1.2), Vec3(1.2, 0.8, 1.2))));
    a.line("scale {0:.5g} {0:.5g} {0:.5g}", a.unit * a.uniform(0.2, 0.7));
    if (a.chance(0.5)) {
        const Real b = a.uniform(0.5, 2), c = a.uniform(0.5, 2), g = a.uniform(-0.3, 0.3);
        a.line("quadric 1 {:.5g} {:.5g} {:.5g} 0 0 {:.5g} 0 0 -1 -2 -2 -2 2 2 2", b, c, g, g);
    } else {
        a.line("implicit -2 -2 -2 2 2 2 {}",
               a.one_of({"x^4+y^4+z^4-1", "(x^2+y^2+z^2+3/4)^2-4*(x^2+y^2)", "x^2+y^2+z^2-sin(3*x)/4-1",
                         "max(abs(x),abs(y))+z^2-1",
                         "1/2-exp(-2*x^2-2*y^2-2*(z-1/2)^2)-exp(-2*x^2-2*y^2-2*(z+1/2)^2)"}));
    }
    a.line("popTransform");
}

/// One of those of chapter 10 that are solid, or that are not.
void write_round_or_box(Author& a, bool solid) {
    if (solid && a.chance(0.4)) return a.chance(0.5) ? write_torus(a) : write_implicit(a);
    const Vec3 middle = in_box(a, Vec3(-1.4, -0.5, -1.4), Vec3(1.4, 0.9, 1.4));
    const Real r = a.unit * a.uniform(0.1, 0.6);
    const auto ends = [&](const std::string& first, const std::string& second) {
        const std::string one = near_middle(a, middle, Vec3(-0.6), Vec3(-0.05));
        return one + first + " " + near_middle(a, middle, Vec3(0.05), Vec3(0.6)) + second;
    };
    const std::string radius = fmt::format(" {:.5g}", r);
    const std::string other = a.chance(0.4) ? " 0" : fmt::format(" {:.5g}", r * a.uniform(0.2, 2));
    const bool first = a.chance(0.5);
    if (a.chance(0.33))
        solid ? a.line("box {}", ends("", ""))
              : a.line("disc {} {}{}", triple(a.unit * middle), triple(in_box(a, Vec3(-1), Vec3(1))), radius);
    else if (a.chance(0.5))
        a.line("{} {}", solid ? "cylinder" : "openCylinder", ends("", radius));
    else
        a.line("{} {}", solid ? "cone" : "openCone", ends(first ? radius : other, first ? other : radius));
}

/// Solids around one place, so that they overlap as a rule; the first of a difference is the largest.
void write_combination(Author& a) {
    const char* const word = a.one_of({"union", "intersection", "difference", "difference"});
    const Vec3 middle = in_box(a, Vec3(-1.2, -0.4, -1.2), Vec3(1.2, 0.8, 1.2));
    a.line("{}", word);
    const int parts = a.whole(2, 4);
    for (int i = 0; i < parts; ++i) {
        const Real size = a.uniform(0.25, 0.5) * (i == 0 ? 1.5 : 1);
        const std::string at = triple(a.unit * (middle + in_box(a, Vec3(-0.3), Vec3(0.3))));
        const bool apart = std::string_view(word) != "intersection";  // or it would be nothing
        const bool turned = apart && a.chance(0.4), nested = apart && i > 0 && a.chance(0.2);
        if (nested) a.line("intersection");
        if (turned) write_transform(a);
        if (!apart || a.chance(0.4))
            a.line("sphere {} {:.5g}", at, a.unit * size);
        else
            a.line("box {} {}", at, triple(a.unit * (middle + in_box(a, Vec3(0.32), Vec3(0.7)))));
        if (nested)
            a.line("cylinder {} {} {:.5g}\nend", triple(a.unit * (middle - size)), at, a.unit * size * 0.8);
        if (turned) a.line("popTransform");
    }
    a.line("end");
}

void write_mesh(Author& a) {
    a.line("pushTransform\nscale {0:.7g} {0:.7g} {0:.7g}", a.unit * a.uniform(0.5, 1));
    a.line("translate {}", triple(in_box(a, Vec3(-1.2, -0.4, -1.2), Vec3(1.2, 0.8, 1.2))));
    a.line("rotate {} {:.5g}", triple(in_box(a, Vec3(-1), Vec3(1))), a.uniform(-180, 180));
    const std::string_view mesh =
        a.one_of({"box.obj", "gem.obj", "gem.obj", "round.obj", "painted.obj", "open.obj"});
    if (mesh == "round.obj") write_no_mirror(a);
    a.line("mesh {}\npopTransform", mesh);
}

void write_object(Author& a) {
    const bool triangles_only = a.integrator == rasterize_word;
    const int kind = triangles_only ? a.whole(6, 9) : a.whole(0, 9);
    // Half of the balls and of the triangles are something else that has an inside, or that has none.
    const bool round_or_box = !triangles_only && kind != 5 && kind < 8 && a.chance(0.5);
    // Single faces have no inside, so no glass.
    write_material(a, kind >= 5 && kind < 8 ? 0 : 0.35);
    write_texturing(a, kind != 5 && !round_or_box);
    if (kind == 5) return write_polygon(a);
    const bool moved = kind <= 7 && a.chance(0.4);
    if (moved) write_transform(a);
    if (round_or_box && kind < 5 && a.chance(0.3))
        write_combination(a);
    else if (round_or_box)
        write_round_or_box(a, kind < 5);
    else if (kind < 5)
        write_sphere(a);
    else if (kind < 8)
        write_triangle(a);
    else
        write_mesh(a);
    if (moved) a.line("popTransform");
}

/// A floor, seldom a wall; `glassy` as above. It never runs along an axis, where rounding would choose a
/// checker.
void write_plane(Author& a, Real glassy) {
    write_material(a, glassy);
    write_texturing(a, true);
    const Vec3 normal = a.chance(0.8) ? Vec3(a.uniform(-0.1, 0.1), 1, a.uniform(-0.1, 0.1))
                                      : Vec3(a.uniform(-0.3, 0.3), a.uniform(-0.3, 0.3), 1);
    const Vec3 point = normal.z == 1 ? Vec3(0, 0, -3) : Vec3(0, a.uniform(-1.6, -1), 0);
    const Real side = a.chance(0.1) ? -1 : 1;  // which side is inside
    a.line("plane {} {}", triple(a.unit * point), triple(normal * side * a.uniform(0.5, 2)));
}

/// Seldom two half-spaces more, mostly of glass, by random numbers of their own. They overlap, sometimes
/// around the eye.
void write_wedge(Author& a, std::uint64_t number) {
    Author b = a;
    b.random = random_for(number, 3, 0);
    if (b.integrator == rasterize_word || !b.chance(0.08)) return;
    b.text.clear();
    for (int i = 0; i < 2; ++i) write_plane(b, 0.8);
    a.text += b.text;
}

/// What chapter 12 brings, by random numbers of its own. Mostly it says that nothing blurs.
void write_blur(Author& a) {
    Author b{random_for(a.random.key, 1, 0)};
    if (!a.blurred && !b.chance(0.12)) return;
    const Real blurred = a.blurred ? a.unit : 0;
    a.line("lens {:.5g} {:.5g}", 0.1 * blurred, 5 * a.unit);
    a.line("aperture {}", b.one_of({"0", "5", "6 30"}));
    a.line("shutter {}", b.one_of({"0 0", ".2 .3"}));
    a.line("cameramotion {}", triple(Vec3(0.1 * blurred, 0, 0)));
    a.line("motion 0 0 0");
    a.line("lightsamples {}", b.whole(1, 4));
    a.line("lightstratify {}", b.one_of({"on", "off"}));
    a.line("lightsampling {}", b.one_of({"angle", "area"}));
    a.line("lightchoice {}", b.one_of({"all", "one"}));
    const bool spread = a.blurred && !a.tame;
    for (const char* word : {"gloss", "translucency"})
        a.line("{} {}", word, spread ? b.one_of({"0", "20"}) : "0");
    a.line("brdf {}", b.one_of({"phong", "ggx"}));
    a.line("roughness {:.5g}", spread ? b.uniform(0, 1) : 0);
    a.line("gamma {}", b.one_of({"1", "2.2"}));
    if (!a.blurred) return;
    a.line("spp 16\nsampler {}",
           b.one_of({"regular", "trapezoid", "random", "jittered", "poisson", "sobol", "sobol"}));
    const Real u = a.unit;
    a.line("quadLight {} {} {} .1 .1 .1", triple(u * Vec3(-1, 4, 0)), triple(u * Vec3(0, 0, 1)),
           triple(u * Vec3(1, 0, 0)));
    a.line("triangleLight {} {} {} .1 .1 .1", triple(u * Vec3(1, 4, 0)), triple(u * Vec3(2, 4, 0)),
           triple(u * Vec3(1, 4, 1)));
    a.line("discLight {} 0 -1 0 {:.5g} .1 .1 .1", triple(u * Vec3(3, 4, 0)), 0.5 * u);
    a.line("sphereLight {} {:.5g} .1 .1 .1", triple(u * Vec3(-3, 4, 0)), 0.3 * u);
    a.line("meshLight gem.obj .01 .01 .01");
}

/// Of a blurred scene about half of the objects move, and half turn.
void write_motion(Author& a) {
    Author own{random_for(a.random.key, a.random.dimension, 3)};
    if (own.chance(0.5)) a.line("motion {}", triple(a.unit * in_box(own, Vec3(-0.3), Vec3(0.3))));
    const Vec3 axis = in_box(own, Vec3(-1), Vec3(1));
    const Real angle = own.chance(0.2) ? 400 : own.uniform(-60, 60);
    a.line("pushTransform\nspin {} {:.5g}", triple(axis), own.chance(0.5) ? angle : 0);
}

}  // namespace

std::string random_scene(std::uint64_t number) {
    Author a{random_for(number, 0, 0)};
    a.line("# random scene {}", number);
    if (a.chance(0.3)) {
        const std::vector<std::string_view> names = integrator_names();  // the first is the default
        a.integrator = names[1 + random_index(a.random, names.size() - 1)];
    }
    Author of_kind{random_for(number, 2, 0)};
    a.tame = of_kind.chance(0.55);
    a.blurred = of_kind.chance(0.06);
    if (a.tame && (a.integrator == "direct" || a.integrator == "analyticdirect")) a.integrator = "raytrace";
    a.dim = a.chance(0.25) || a.blurred;
    if (a.chance(0.15)) a.unit = std::pow(10, a.whole(-9, 9));
    write_picture(a);
    if (a.chance(0.15)) write_sky(a);
    write_sampling(a);
    write_lights(a);
    write_blur(a);
    if (a.chance(0.1)) a.line("maxverts 100\nmaxvertnorms 100");
    if (a.integrator != rasterize_word && a.chance(0.7)) write_plane(a, 0.15);
    write_wedge(a, number);
    const int count = a.whole(1, 6);
    for (int i = 0; i < count; ++i) {
        if (a.blurred) write_motion(a);
        write_object(a);
        if (a.blurred) a.line("popTransform\nmotion 0 0 0");
    }
    return a.text;
}

void write_random_files(const std::filesystem::path& directory) {
    const std::string box =
        "v -.5 -.5 -.5\nv .5 -.5 -.5\nv .5 .5 -.5\nv -.5 .5 -.5\nv -.5 -.5 .5\nv .5 -.5 .5\nv .5 .5 .5\n"
        "v -.5 .5 .5\n";
    const std::string gem = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n";
    const std::string faces[] = {"1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"};
    std::string flat, round = gem, painted = gem + "vt 0 0\nvt 1 0\nvt .5 1\nvt .2 .7\nvt .9 .9\nvt .4 .1\n";
    round += "vn 1 0 0\nvn -1 0 0\nvn 0 1 0\nvn 0 -1 0\nvn 0 0 1\nvn 0 0 -1\n";
    for (const std::string& face : faces) {
        flat += "f " + face + "\n";
        round += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", face[0], face[2], face[4]);
        painted += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", face[0], face[2], face[4]);
    }
    write_file(directory / "box.obj",
               box + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n");
    write_file(directory / "open.obj", box + "f 4 3 2 1\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\n");
    write_file(directory / "gem.obj", gem + flat);
    write_file(directory / "round.obj", round);
    write_file(directory / "painted.obj", painted);
    Image picture = make_image(5, 4);
    Random random = random_for(0, 0, 0);
    for (Vec3& color : picture.pixels)
        for (int channel = 0; channel < 3; ++channel) color[channel] = 0.9 * random_real(random);
    write_png16(directory / "random.png", picture);
}

}  // namespace rt
