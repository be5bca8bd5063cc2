// POV-Ray repeats pictures in both directions; the functions' coordinates are brought to where that does not
// matter.
#include "common/povray/picture_text.hpp"

#include "common/povray/refuse.hpp"

#include <algorithm>
#include <filesystem>

namespace rt::povray {
namespace {

std::string_view word_of(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return "Repeat";
        case Wrap::Mirror:
            return "Mirror";
        case Wrap::Clamp:
            return "Clamp";
    }
    return "";
}

/// The coordinate, which is called `x`, brought between the centres of the first and the last of n pixels,
/// where nothing beyond the edge is mixed in.
std::string wrapped(std::string_view x, int n, Wrap wrap) {
    if (wrap == Wrap::Repeat) return std::string(x);
    const std::string there =
        wrap == Wrap::Clamp ? std::string(x) : fmt::format("1 - abs(1 - {0} + 2 * floor({0} / 2))", x);
    return fmt::format("min(max({}, {}), {})", there, number(0.5 / n), number(1 - 0.5 / n));
}

std::string extension(const PictureFile& picture) {
    std::string text = std::filesystem::path(picture.file).extension().string();
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return text;
}

/// 8-bit numbers are mixed as light, not as numbers: POV-Ray decodes each pixel first.
void write_png(Writer& out, const Lookup& lookup, const PictureFile& picture) {
    const std::string name = name_of(lookup);
    // The gamma of the file itself does not matter, because this word is said.
    out.line("#declare {} = function {{ pigment {{ image_map {{ png \"{}\" gamma {}{} }} }} }}", name,
             picture.file, picture.eight_bits ? "srgb" : "1.0", lookup.nearest ? "" : " interpolate 2");
    for (int i = 0; i < 3; ++i)
        out.line("#declare {0}{1} = function(x, y) {{ {0}({2}, {3}, 0).{4} }}", name, channel_names[i],
                 wrapped("x", picture.image->width, lookup.wrap_u),
                 wrapped("y", picture.image->height, lookup.wrap_v), channel_words[i]);
}

/// POV-Ray takes a mantissa m of RGBE for m + ½, also 0. Half a step of the last digit is subtracted from
/// each pixel: the greatest channel's mantissa is 128 to 255, so it tells the exponent. Therefore POV-Ray
/// looks up pixels, and the functions mix them.
void write_hdr(Writer& out, const Lookup& lookup, const PictureFile& picture) {
    const std::string name = name_of(lookup);
    const int w = picture.image->width, h = picture.image->height;
    const std::string u = wrapped("x", w, lookup.wrap_u), v = wrapped("y", h, lookup.wrap_v);
    out.line("#declare {} = function {{ pigment {{ image_map {{ hdr \"{}\" gamma 1.0 }} }} }}", name,
             picture.file);
    out.line(
        "#declare {0}Half = function(x, y) {{ pow(2, floor(ln(max({0}(x, y, 0).red, {0}(x, y, 0).green, "
        "{0}(x, y, "
        "0).blue, 1e-30)) / ln(2)) - 8) }}",
        name);
    const Real greatest = brightest(out.scene, lookup);
    for (int i = 0; i < 3; ++i) {
        const std::string channel = fmt::format("{}{}", name, channel_names[i]);
        out.line("#declare {0}Pixel = function(x, y) {{ max({1}(x, y, 0).{2} - {1}Half(x, y), 0) }}", channel,
                 name, channel_words[i]);
        if (lookup.nearest) {
            out.line("#declare {0} = function(x, y) {{ {0}Pixel({1}, {2}) / {3} }}", channel, u, v,
                     number(greatest));
            continue;
        }
        out.line(
            "#declare {0}Row = function(x, y, f) {{ (1 - f) * {0}Pixel(x, y) + f * {0}Pixel(x + {1}, y) }}",
            channel, number(1.0 / w));
        // i, j: column and row of the pixel at the left and below; x, y in pixels.
        out.line(
            "#declare {0}Cell = function(i, j, x, y) {{ (1 - y + j) * {0}Row((i + 0.5) / {1}, (j + 0.5) / "
            "{2}, x - i) "
            "+ (y - j) * {0}Row((i + 0.5) / {1}, (j + 1.5) / {2}, x - i) }}",
            channel, w, h);
        out.line("#declare {0}Place = function(x, y) {{ {0}Cell(floor(x), floor(y), x, y) }}", channel);
        out.line("#declare {0} = function(x, y) {{ {0}Place({1} * {2} - 0.5, {3} * {4} - 0.5) / {5} }}",
                 channel, u, w, v, h, number(greatest));
    }
}

}  // namespace

Lookup lookup_of(const PictureTexture& texture) {
    return {texture.picture, texture.wrap, texture.wrap, texture.filter == TextureFilter::Nearest};
}

Lookup lookup_of(const Scene& scene, const ImageSky& sky) {
    const auto found = std::ranges::find(scene.pictures, sky.image, &PictureFile::image);
    return {static_cast<std::uint32_t>(found - scene.pictures.begin()),
            sky.map == SkyMap::LatitudeLongitude ? Wrap::Repeat : Wrap::Clamp, Wrap::Clamp, false};
}

std::string name_of(const Lookup& lookup) {
    return fmt::format("Picture{}{}{}{}", lookup.picture, word_of(lookup.wrap_u), word_of(lookup.wrap_v),
                       lookup.nearest ? "Nearest" : "");
}

Real brightest(const Scene& scene, const Lookup& lookup) {
    Real greatest = 1;
    for (const Vec3& pixel : scene.pictures[lookup.picture].image->pixels)
        greatest = std::max(greatest, max_component(pixel));
    return greatest;
}

void write_lookup(Writer& out, const Lookup& lookup) {
    const PictureFile& picture = out.scene.pictures[lookup.picture];
    const std::string kind = extension(picture);
    if (kind == ".png")
        write_png(out, lookup, picture);
    else if (kind == ".hdr")
        write_hdr(out, lookup, picture);
    else
        refuse(out.scene, fmt::format("it does not read {}", picture.file));
}

}  // namespace rt::povray
