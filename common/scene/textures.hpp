// What makes a material vary from place to place: pictures, patterns in space, bumps.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/solid_pattern.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// How a picture goes on beyond its edges: again and again, back and forth, or with the colour of its edge.
enum class Wrap { Repeat, Mirror, Clamp };

/// How the colour at a place of a picture is found: that of the nearest pixel; between the four around; the
/// mean over a square as large as what one pixel of ours sees of it; or over its true, longer shape.
enum class TextureFilter { Nearest, Bilinear, Trilinear, Anisotropic };

/// A picture that a scene file names. One that is named both as a texture and as a normal map stands there
/// twice, because its 8 bits mean light by the sRGB curve in the one, and numbers as they are in the other.
struct PictureFile {
    std::string file;  ///< as the scene says it
    std::shared_ptr<const Image> image;
    bool eight_bits = false;  ///< else linear
};

/// A picture and smaller ones of it: level 0 is the picture itself, each other level half as wide and high as
/// the one before (Williams 1983).
struct MipMap {
    std::vector<Image> levels;
};

/// A picture on a surface, at its texture coordinates.
struct PictureTexture {
    std::uint32_t picture = 0;  ///< index into Scene::pictures
    Wrap wrap = Wrap::Repeat;
    TextureFilter filter = TextureFilter::Bilinear;
    friend bool operator==(const PictureTexture&, const PictureTexture&) = default;
};

/// Bumps of noise in the material: the shading normal is that of a surface whose points are moved along it by
/// height · noise(p/size).
struct Bumps {
    Real height = 0;  ///< world units; 0 is none
    Real size = 1;    ///< of the bumps, world units
    friend bool operator==(const Bumps&, const Bumps&) = default;
};

/// Which of a material's numbers a picture or a pattern multiplies.
struct ColorsOf {
    bool ambient = true, diffuse = true, emission = true;
    bool specular = false, transmission = false, absorption = false;
    bool shininess = false;  ///< by the first channel
    friend bool operator==(const ColorsOf&, const ColorsOf&) = default;
};

/// All that varies a material. What is not said varies nothing.
struct Texturing {
    std::optional<PictureTexture> picture;
    std::optional<SolidPattern> pattern;
    ColorsOf colors;
    Bumps bumps;
    std::optional<PictureTexture> normal_map;  ///< its picture's numbers are directions, not light
    friend bool operator==(const Texturing&, const Texturing&) = default;
};

}  // namespace rt
