// Commands of what varies a material from place to place, and of the sky.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"
#include "common/scene/text.hpp"

#include <variant>

namespace rt::language {

namespace {

constexpr Word<Wrap> wraps[] = {{"repeat", Wrap::Repeat}, {"mirror", Wrap::Mirror}, {"clamp", Wrap::Clamp}};
constexpr Word<TextureFilter> filters[] = {{"nearest", TextureFilter::Nearest},
                                           {"bilinear", TextureFilter::Bilinear},
                                           {"trilinear", TextureFilter::Trilinear},
                                           {"anisotropic", TextureFilter::Anisotropic}};

void set_texture(Parser& parser) {
    if (parser.words[1] == "off")
        parser.texturing.picture.reset();
    else
        parser.texturing.picture = {picture_named(parser, parser.words[1]), parser.wrap,
                                    parser.texture_filter};
}

void set_normal_map(Parser& parser) {
    if (parser.words[1] == "off")
        parser.texturing.normal_map.reset();
    else
        parser.texturing.normal_map = {picture_named(parser, parser.words[1], Encoding::Linear), parser.wrap,
                                       parser.texture_filter};
}

template <PatternKind kind>
void set_pattern(Parser& parser) {
    const Vec3 first = color(parser, 1), second = color(parser, 4);
    const Real size = sized(parser, 7, "the size of the pattern");
    if (first == Vec3(1) && second == Vec3(1))
        parser.texturing.pattern.reset();
    else
        parser.texturing.pattern = {kind, size, first, second};
}

/// A word after `textured`, and the number of materials that it names: a member of one of the two.
struct TexturedWord {
    std::string_view name;
    std::variant<bool ColorsOf::*, bool TexturedFinish::*> value;
};
constexpr TexturedWord textured_words[] = {{"ambient", &ColorsOf::ambient},
                                           {"diffuse", &ColorsOf::diffuse},
                                           {"emission", &ColorsOf::emission},
                                           {"specular", &ColorsOf::specular},
                                           {"transmission", &ColorsOf::transmission},
                                           {"absorption", &ColorsOf::absorption},
                                           {"shininess", &ColorsOf::shininess},
                                           {"finish", &TexturedFinish::finish},
                                           {"coat", &TexturedFinish::coat},
                                           {"gloss", &TexturedFinish::gloss},
                                           {"translucency", &TexturedFinish::translucency},
                                           {"roughness", &TexturedFinish::roughness}};

void set_textured(Parser& parser) {
    ColorsOf colors{false, false, false};
    TexturedFinish finish;
    for (std::size_t i = 1; i < parser.words.size(); ++i) {
        const auto named = choice(parser, textured_words, i);
        if (const auto* color = std::get_if<bool ColorsOf::*>(&named))
            colors.*(*color) = true;
        else
            finish.*std::get<bool TexturedFinish::*>(named) = true;
    }
    parser.texturing.colors = colors;
    parser.finish.textured = finish;
}

void set_finish(Parser& parser) {
    Finish& finish = parser.finish;
    finish.kind = choice(parser, finish_words);
    const FinishWord& word = word_of(finish.kind);
    finish.value = word.usual;
    if (parser.words.size() == 2) return;
    if (finish.kind == FinishKind::Plain)
        fail(parser, parser.words[2], "'plain' has no value" + expected(parser));
    finish.value = number(parser, 2);
    if (!(finish.value >= word.range.min && finish.value <= word.range.max))
        fail(parser, parser.words[2],
             "the value of '" + std::string(word.name) + "' must be from " + shown(word.range.min) + " to " +
                 shown(word.range.max) + ", not " + shown(finish.value));
}

void set_bumps(Parser& parser) {
    const Real height = number(parser, 1);
    if (height != 0) sized(parser, 1, "the height of bumps that is not 0");
    parser.texturing.bumps = {height, sized(parser, 2, "the size of the bumps")};
    if (height == 0) parser.texturing.bumps = {};
}

void set_environment(Parser& parser) {
    const Turn turn = parser.words.size() > 2 ? turn_by(radians(number(parser, 2))) : Turn{};
    const std::uint32_t picture = picture_named(parser, parser.words[1]);
    parser.scene.sky = ImageSky{parser.scene.pictures[picture].image, parser.sky_map, turn};
}

void set_sky_gradient(Parser& parser) {
    parser.scene.sky = GradientSky{color(parser, 1), color(parser, 4), color(parser, 7)};
}

constexpr Word<SkyMap> sky_maps[] = {
    {"latlong", SkyMap::LatitudeLongitude}, {"mirrorball", SkyMap::MirrorBall}, {"angular", SkyMap::Angular}};

const CommandRow rows[] = {
    {{"texture", "file",
      "For the objects that follow: a picture (`.png`, `.hdr`, `.pfm`) that multiplies ambient, diffuse "
      "and emission at the surface's texture coordinates; its path is relative to the scene's, without "
      "blanks. 8-bit "
      "files are read as sRGB, others as linear. `texture off` is none.",
      "11"},
     set_texture},
    {{"texturewrap", alternatives(wraps),
      "For the textures that follow: how a picture goes on beyond its edges: again and again (default), back "
      "and forth, or with the colour of its edge.",
      "11"},
     [](Parser& p) { p.wrap = choice(p, wraps); }},
    {{"texturefilter", alternatives(filters),
      "For the textures that follow: the colour of the nearest pixel; between the four around (default); the "
      "mean over a square as large as what a pixel sees; or over the shape that it sees, however long.",
      "11"},
     [](Parser& p) { p.texture_filter = choice(p, filters); }},
    {{"textured", alternatives(textured_words) + " ...",
      "For the objects that follow: which numbers of the material a texture or a pattern multiplies. By its "
      "red channel, and kept in their ranges: `shininess`, the roughness of a `finish`, the index of the "
      "`coat` of `finish coated`, `gloss` and `translucency` (at 0 a mirror or glass is sharp), and the "
      "`roughness` of `brdf ggx`. At first `textured ambient diffuse emission`.",
      "11"},
     set_textured},
    {{"stripes", "r g b r g b size",
      "For the objects that follow: two colours that multiply what a texture does, in slices across x of the "
      "given thickness in world space. Like the other patterns it takes the place of the one before; two "
      "white colours are none.",
      "11"},
     set_pattern<PatternKind::Stripes>},
    {{"rings", "r g b r g b size", "Likewise in shells of the given thickness around the y axis.", "11"},
     set_pattern<PatternKind::Rings>},
    {{"gradient", "r g b r g b size",
      "Likewise from the first colour to the second along y, again from the first after each `size`.", "11"},
     set_pattern<PatternKind::Gradient>},
    {{"marble", "r g b r g b size", "Likewise in soft slices across x, disturbed by turbulence.", "11"},
     set_pattern<PatternKind::Marble>},
    {{"wood", "r g b r g b size", "Likewise in the rings of a tree around the y axis, disturbed by noise.",
      "11"},
     set_pattern<PatternKind::Wood>},
    {{"cells", "r g b r g b size",
      "Likewise in cells about random points, about one in each cube of the size.", "11"},
     set_pattern<PatternKind::Cellular>},
    {{"finish", alternatives(finish_words) + " [value]",
      "For the objects that follow: how they spread diffuse light under lamps, with the diffuse colour, 1 at "
      "most in each channel: `plain` evenly (default); `matte` as rough clay, its value the roughness from 0 "
      "to 1, else .5; `velvet`, likewise; `metal`, likewise, else .3; `coated` as paint under a clear coat, "
      "its value the coat's index of refraction from 1 to 4, else 1.5; `glass` as rough glass, also for "
      "lamps on the other side, its value the roughness, else .3, its `ior` from 1.01 to 4.",
      "11"},
     set_finish},
    {{"bumps", "height size",
      "For the objects that follow: shading normals as if noise of this height and size moved the surface, "
      "in world units; `bumps 0 1` is none.",
      "11"},
     set_bumps},
    {{"normalmap", "file",
      "For the objects that follow: a picture of shading normals n in a surface's own directions, rgb = (n + "
      "1)/2, as numbers whatever its bits: red along growing u, green along growing v (up; OpenGL's way), "
      "blue "
      "outwards. Wrapped and filtered as textures; before `bumps`. `normalmap off` is none.",
      "11"},
     set_normal_map},
    {{"environment", "file [turn]",
      "A picture of what is seen where nothing is hit, in latitude and longitude; turned by `turn` degrees "
      "about y, counterclockwise from above.",
      "11"},
     set_environment},
    {{"environmentmap", alternatives(sky_maps),
      "Which part of the pictures of `environment` lines that follow shows which direction: latitude and "
      "longitude (default), a mirror ball as seen from +z, or an angular map (a light probe).",
      "11"},
     [](Parser& p) { p.sky_map = choice(p, sky_maps); }},
    {{"skyGradient", "r g b r g b r g b",
      "What is seen where nothing is hit: colours straight up, level and straight down, and mixed between.",
      "11"},
     set_sky_gradient},
    {{"skylight", alternatives(on_or_off),
      "Whether the sky lights what is diffuse, as if nothing stood in the way; default off.", "11"},
     [](Parser& p) { p.scene.skylight = choice(p, on_or_off); }},
};

}  // namespace

std::span<const CommandRow> texture_commands() { return rows; }

}  // namespace rt::language
