// One finish of POV-Ray has one pigment for every term, where our materials have a colour for each. So a
// material becomes up to four layers of texture.
#include "common/povray/materials.hpp"

#include "common/povray/bumps.hpp"
#include "common/povray/noise_text.hpp"
#include "common/povray/optics.hpp"
#include "common/povray/picture_text.hpp"
#include "common/povray/places.hpp"
#include "common/povray/shapes.hpp"
#include "common/povray/sky.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace rt::povray {
namespace {

std::string highlight(const Material& m, Real strength) {
    if (m.highlight == Highlight::Phong)
        return fmt::format(" phong {} phong_size {}", number(strength), number(m.shininess));
    // POV-Ray's exponent is 1/roughness; the largest roughness stands for exponent 0.
    const Real roughness = m.shininess > 0 ? 1 / m.shininess : 1e30;
    return fmt::format(" specular {} roughness {}", number(strength), number(roughness));
}

bool has_fresnel(const Material& m) { return is_transparent(m) && m.fresnel != Fresnel::None; }

/// What POV-Ray must know to put a material's layers together.
struct Terms {
    bool diffuse, skylight, highlight;
    bool filtered;  ///< the highlight has a colour, which a layer of its own gives it
    bool bottom;    ///< something is left for the lowest layer
    Vec3 glow;
    Real strongest;  ///< channel of the highlight
    /// What each coloured layer lets through. Half is the more readable number. But conserve_energy also dims
    /// the light of layers below the one that reflects, and POV-Ray leaves out layers from which less than
    /// adc_bailout arrives. There the upper layers hide nothing that a 16-bit step could show.
    Real share;
};

Terms terms_of(const Scene& scene, const Material& m) {
    const bool lit = has_lights(scene);
    const bool highlight = lit && !is_black(m.specular), filtered = highlight && !is_grey(m.specular);
    return {.diffuse = lit && !is_black(m.diffuse),
            .skylight = has_skylight(scene) && !is_black(m.diffuse),
            .highlight = highlight,
            .filtered = filtered,
            .bottom = filtered || is_transparent(m),
            .glow = m.ambient + m.emission,
            .strongest = max_component(m.specular),
            .share = has_fresnel(m) || scene.min_contribution > 0 ? 1 - 0x1p-16 : 0.5};
}

const std::string no_bumps;

/// The layers so far, from the top. The strengths of those below make up for what the upper ones keep.
struct Layers {
    const Material& m;
    const Terms& terms;
    const std::string& bumps;  ///< `normal { }` of each that needs it: they take long
    std::string top;           ///< belongs into the finish of the first
    Real over = 1;             ///< what they let through
    std::vector<std::string> texts{};

    void add(const std::string& pigment, const std::string& finish, bool has_normal = true) {
        const std::string& normal = has_normal || !top.empty() ? bumps : no_bumps;
        texts.push_back(fmt::format("texture {{ pigment {{ {} }}{} finish {{ ambient 0 {}{} }} }}", pigment,
                                    normal, finish, std::exchange(top, "")));
    }

    void add_colored(const Vec3& color, bool is_last, std::string_view term) {
        const Real kept = is_last ? 1 : 1 - terms.share;
        add(patterned(color, m.checker, is_last ? "" : " transmit " + number(terms.share)),
            fmt::format("{} {}", term, number(1 / (kept * over))), term == "diffuse");
        if (!is_last) over *= terms.share;
    }

    /// As much of the skylight as is reflected.
    void add_skylight(const Scene& scene, bool is_last) {
        const Real kept = is_last ? 1 : 1 - terms.share;
        add(skylight_pigment(scene, m.diffuse, is_last ? "" : " transmit " + number(terms.share)),
            fmt::format("diffuse 0 emission {}", number(1 / (kept * over))));
        if (!is_last) over *= terms.share;
    }

    /// The highlight, if it was filtered, and what shines through.
    void add_bottom() {
        std::string pigment = "rgb 0", finish = "diffuse 0";
        if (is_transparent(m)) {
            Vec3 through(0);
            for (int i = 0; i < 3; ++i)
                if (m.transmission[i] > 0)
                    through[i] =
                        m.transmission[i] / over / (terms.filtered ? m.specular[i] / terms.strongest : 1);
            pigment = rgb(through) + " filter 1";
        }
        if (terms.filtered) finish += highlight(m, terms.strongest / over);
        if (has_fresnel(m))
            finish +=
                fmt::format(" reflection {{ rgb 0, rgb {} fresnel }} conserve_energy", number(1 / over));
        add(pigment, finish);
    }
};

/// From the top: diffuse, emission, a filter that colours the highlight, and below it the highlight itself
/// and what shines through.
std::string layers(const Scene& scene, const Material& m, const std::string& bumps) {
    const Terms terms = terms_of(scene, m);
    std::string top =
        has_fresnel(m) || is_black(m.specular) ? "" : fmt::format(" reflection {{ {} }}", rgb(m.specular));
    if (terms.highlight && !terms.filtered) top += highlight(m, m.specular.x);
    Layers layers{m, terms, bumps, std::move(top)};
    const bool glows = !is_black(terms.glow);
    if (terms.diffuse) layers.add_colored(m.diffuse, !terms.skylight && !glows && !terms.bottom, "diffuse");
    if (terms.skylight) layers.add_skylight(scene, !glows && !terms.bottom);
    if (glows) layers.add_colored(terms.glow, !terms.bottom, "diffuse 0 emission");
    if (terms.filtered) layers.add(rgb(m.specular / terms.strongest) + " filter 1", "diffuse 0", false);
    if (terms.bottom || layers.texts.empty()) layers.add_bottom();
    std::string text;
    for (auto layer = layers.texts.rbegin(); layer != layers.texts.rend(); ++layer)
        text += "  " + *layer + "\n";
    return text;
}

// What varies from place to place: textures that are mixed from others
// ---------------------------------------

/// A material without texturing, as the layers of a texture.
using Plain = std::function<std::string(const Material&)>;

/// What a picture's channel weighs beside what it does not touch. That is untouched but for 3e-6 of it: less
/// than a step of 16 bits. (Not an equal share, because Fresnel's mirror has no strength that could be made
/// up for.)
constexpr Real channel_weight = 0x1p-20;

Vec3 channel_of(int i) {
    Vec3 unit(0);
    unit[i] = 1;
    return unit;
}

/// What the texturing touches, times `factor`; and what it does not, times `rest`.
Material multiplied(Material m, const ColorsOf& colors, const Vec3& factor, Real rest = 1) {
    const auto of = [&](bool is_touched) { return is_touched ? factor : Vec3(rest); };
    m.ambient *= of(colors.ambient);
    m.diffuse *= of(colors.diffuse);
    m.emission *= of(colors.emission);
    m.specular *= of(colors.specular);
    m.transmission *= of(colors.transmission);
    if (colors.shininess) m.shininess *= std::max(factor.x, Real(0));
    return m;
}

bool has_checker(const Material& m) { return m.checker.even != Vec3(1) || m.checker.odd != Vec3(1); }

/// The checker's factor for good.
Material in_cube(Material m, const Vec3& factor) {
    m.checker = {};
    m.ambient *= factor, m.diffuse *= factor, m.emission *= factor;
    return m;
}

/// Writes textures under names that begin with `name`, the last of which is `name`.
struct TextureWriter {
    Writer& out;
    const Plain& plain;
    const Coordinates& coordinates;  ///< of the object, if it has a picture

    void write(const std::string& name, const Material& m, const Texturing& texturing) {
        if (texturing.pattern) {
            Texturing rest = texturing;
            rest.pattern.reset();
            write(name + "First", multiplied(m, texturing.colors, texturing.pattern->first), rest);
            write(name + "Second", multiplied(m, texturing.colors, texturing.pattern->second), rest);
            write_mix(name, pattern_function(*texturing.pattern));
        } else if (has_checker(m) && (texturing.picture || has_skylight(out.scene))) {
            write(name + "First", in_cube(m, m.checker.even), texturing);
            write(name + "Second", in_cube(m, m.checker.odd), texturing);
            write_mix(name, checker_function(m.checker.size));
        } else if (texturing.picture) {
            write_picture(name, m, texturing);
        } else {
            out.line("#declare {} =\n{}", name, plain(m));
        }
    }

private:
    void write_mix(const std::string& name, const std::string& value) {
        out.line(
            "#declare {0} = texture {{ function {{ {1} }} texture_map {{ [0 {0}First] [1 {0}Second] }} }}\n",
            name, value);
    }

    /// The mean of what the picture does not touch and of each channel's part of what it does.
    void write_picture(const std::string& name, const Material& m, const Texturing& texturing) {
        const Lookup lookup = lookup_of(*texturing.picture);
        out.line("#declare {}Rest =\n{}", name, plain(multiplied(m, texturing.colors, Vec3(0))));
        const Real strength = (1 + 3 * channel_weight) / channel_weight * brightest(out.scene, lookup);
        std::string entries = fmt::format("[1 {}Rest]", name);
        for (int i = 0; i < 3; ++i) {
            const std::string_view channel = channel_names[i];
            out.line("#declare {}{} =\n{}", name, channel,
                     plain(multiplied(m, texturing.colors, strength * channel_of(i), 0)));
            entries +=
                fmt::format("\n  [{} {}function {{ {}{}({}, {}) }} texture_map {{ [0 Nothing] [1 {}{}] }}]",
                            number(channel_weight), coordinates.mapped ? "uv_mapping " : "", name_of(lookup),
                            channel, coordinates.u, coordinates.v, name, channel);
        }
        out.line("#declare {} = texture {{ average texture_map {{ {} }} }}\n", name, entries);
    }
};

const Texturing* texturing_of(const Scene& scene, const Material& m) {
    return m.texturing < 0 ? nullptr : &scene.texturings[static_cast<std::size_t>(m.texturing)];
}

bool has_picture(const Scene& scene, const Material& m) {
    const Texturing* texturing = texturing_of(scene, m);
    return texturing && texturing->picture;
}

/// Calls visit(texturing) for those of materials that objects have.
template <class Visit>
void visit_texturings(const Scene& scene, Visit visit) {
    for (const Object& object : scene.objects)
        if (const Texturing* texturing = texturing_of(scene, scene.materials[object.material]))
            visit(*texturing);
}

void write_functions(Writer& out, bool with_bumps) {
    bool needs_noise = false, has_bumps = false, needs_nothing = false;
    std::vector<Lookup> lookups;
    visit_texturings(out.scene, [&](const Texturing& t) {
        has_bumps |= with_bumps && t.bumps.height != 0;
        needs_noise |=
            t.pattern && (t.pattern->kind == PatternKind::Marble || t.pattern->kind == PatternKind::Wood);
        if (!t.picture) return;
        needs_nothing = true;
        if (std::ranges::find(lookups, lookup_of(*t.picture)) == lookups.end())
            lookups.push_back(lookup_of(*t.picture));
    });
    if (needs_noise || has_bumps) write_noise(out);
    if (has_bumps) write_bump_functions(out);
    for (const Lookup& lookup : lookups) write_lookup(out, lookup);
    if (needs_nothing)
        out.line("#declare Nothing = texture {{ pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 }} }}\n");
}

/// `plain(m, bumps)`. What depends on the object, its place on a picture or its normals, is the object's own.
void write_all(Writer& out, bool with_bumps,
               const std::function<std::string(const Material&, const std::string&)>& plain) {
    const Scene& scene = out.scene;
    write_functions(out, with_bumps);
    std::vector<bool> written(scene.materials.size(), false);
    const auto write = [&](const std::string& name, const Material& m, const Coordinates& coordinates,
                           const std::string& bumps) {
        const Texturing* texturing = texturing_of(scene, m);
        TextureWriter{out, [&](const Material& part) { return plain(part, bumps); }, coordinates}.write(
            name, m, texturing ? *texturing : Texturing{});
    };
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Material& m = scene.materials[object.material];
        if (is_by_parts(scene, object)) {
            for (const std::uint32_t part : leaves_of(scene, std::get<CombinationObject>(object.shape)))
                write(part_texture_name(part), m,
                      write_coordinates(out, scene.parts[part], scene.objects.size() + part),
                      with_bumps ? write_bumps(out, object, i) : "");
        } else if (is_own(scene, m)) {
            const Coordinates coordinates =
                has_picture(scene, m) ? write_coordinates(out, object, i) : Coordinates{};
            write(texture_name(scene, object), m, coordinates, with_bumps ? write_bumps(out, object, i) : "");
        } else if (!written[object.material]) {
            written[object.material] = true;
            write(texture_name(scene, object), m, {}, "");
        }
    }
}

}  // namespace

bool is_own(const Scene& scene, const Material& m) { return has_picture(scene, m) || bumps_of(scene, m); }

bool is_by_parts(const Scene& scene, const Object& object) {
    return std::holds_alternative<CombinationObject>(object.shape) &&
           has_picture(scene, scene.materials[object.material]);
}

std::string part_texture_name(std::uint32_t part) { return fmt::format("Part{}", part); }

std::string texture_name(const Scene& scene, const Object& object) {
    if (is_own(scene, scene.materials[object.material]))
        return fmt::format("Object{}", &object - scene.objects.data());
    return fmt::format("Material{}", object.material);
}

std::string pattern_function(const SolidPattern& pattern) {
    // What is exactly on a boundary has the upper value, whatever its rounding.
    const auto scaled = [&](std::string_view axis) {
        return fmt::format("({} / {} + 1e-9)", axis, number(pattern.size));
    };
    const std::string x = scaled("x"), y = scaled("y");
    const std::string radius = scaled("sqrt(x * x + z * z)");
    const auto parity = [](const std::string& v) {
        return fmt::format("floor({0}) - 2 * floor(floor({0}) / 2)", v);
    };
    const auto noise = [&](Real scale) {
        const std::string s = number(pattern.size / scale);
        return fmt::format("Noise(x / {0}, y / {0}, z / {0})", s);
    };
    switch (pattern.kind) {
        case PatternKind::Stripes:
            return parity(x);
        case PatternKind::Rings:
            return parity(radius);
        case PatternKind::Gradient:
            return fmt::format("{0} - floor({0})", y);
        case PatternKind::Marble: {
            std::string turbulence;
            for (int i = 0; i < 6; ++i)
                turbulence +=
                    fmt::format("{}abs({}) / {}", i > 0 ? " + " : "", noise(std::exp2(i - 2)), 1 << i);
            return fmt::format("0.5 + 0.5 * sin(pi * (x / {} + 4 * ({})))", number(pattern.size), turbulence);
        }
        case PatternKind::Wood: {
            const std::string ring = fmt::format("({} + 2 * {})", radius, noise(0.125));
            return fmt::format("{0} - floor({0})", ring);
        }
        case PatternKind::Cellular:
            break;  // refused
    }
    return "0";
}

std::string checker_function(Real size) {
    const std::string s = number(size);
    const std::string sum =
        fmt::format("floor(x / {0} + 1e-9) + floor(y / {0} + 1e-9) + floor(z / {0} + 1e-9)", s);
    return fmt::format("{0} - 2 * floor(({0}) / 2)", sum);
}

std::string patterned(const Vec3& color, const Checker& checker, std::string_view more) {
    if (checker.even == Vec3(1) && checker.odd == Vec3(1)) return rgb(color) + std::string(more);
    return fmt::format("checker {}{} {}{} scale {}", rgb(color * checker.even), more,
                       rgb(color * checker.odd), more, number(checker.size));
}

void write_materials(Writer& out) {
    write_all(out, true,
              [&](const Material& m, const std::string& bumps) { return layers(out.scene, m, bumps); });
}

void write_flat_materials(Writer& out) {
    write_all(out, false, [](const Material& m, const std::string&) {
        return fmt::format("  texture {{ pigment {{ {} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}\n",
                           patterned(m.ambient + m.emission, m.checker));
    });
}

}  // namespace rt::povray
