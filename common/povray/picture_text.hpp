// Pictures as functions of POV-Ray's.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// How a picture is looked up: the same for the same functions.
struct Lookup {
    std::uint32_t picture = 0;  ///< index into Scene::pictures
    Wrap wrap_u = Wrap::Repeat, wrap_v = Wrap::Repeat;
    bool nearest = false;
    friend bool operator==(const Lookup&, const Lookup&) = default;
};

/// That of a texture, or of a sky.
Lookup lookup_of(const PictureTexture& texture);
Lookup lookup_of(const Scene& scene, const ImageSky& sky);

/// The functions' names without the channel: `Picture0RepeatRepeat`.
std::string name_of(const Lookup& lookup);

/// What the functions are divided by, so that they stay in [0, 1]: a pattern's value begins again at 1.
Real brightest(const Scene& scene, const Lookup& lookup);

/// Declares `NameRed(u, v)`, `NameGreen`, `NameBlue`. Throws InputError for a picture that POV-Ray reads
/// otherwise.
void write_lookup(Writer& out, const Lookup& lookup);

inline constexpr std::string_view channel_names[3] = {"Red", "Green", "Blue"};
inline constexpr std::string_view channel_words[3] = {"red", "green", "blue"};

}  // namespace rt::povray
