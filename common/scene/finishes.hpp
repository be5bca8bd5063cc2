// How light is spread, where it is neither evenly nor as in a mirror.
#pragma once

#include "common/scene/range.hpp"

#include <cstddef>
#include <string_view>

namespace rt {

/// How diffuse light is spread: evenly, or as a lobe of chapter 11 does.
enum class FinishKind { Plain, Matte, Velvet, Metal, Coated, Glass };
/// The formula by which the integrator `direct` reflects light.
enum class Brdf { Phong, Ggx };
/// Which numbers of a finish a texture multiplies, by its first channel.
struct TexturedFinish {
    bool finish = false;  ///< the value, where it is a roughness
    bool coat = false;    ///< the value of Coated
    bool gloss = false, translucency = false, roughness = false;
    friend bool operator==(const TexturedFinish&, const TexturedFinish&) = default;
};
/// What few materials ask for: how light is spread, where it is neither evenly nor as in a mirror.
struct Finish {
    FinishKind kind = FinishKind::Plain;
    Real value = 0;         ///< the lobe's roughness, of Coated its index of refraction
    Real gloss = 0;         ///< exponent of the lobe around the mirror direction; 0 is the direction alone
    Real translucency = 0;  ///< likewise around the refracted direction
    Brdf brdf = Brdf::Phong;
    Real roughness = 1;  ///< of Ggx: α itself
    TexturedFinish textured;
    friend bool operator==(const Finish&, const Finish&) = default;
};

/// A word after `finish`, its value if none is said, and the range of that.
struct FinishWord {
    std::string_view name;
    FinishKind value;
    Real usual;
    Interval range;
};
/// In the order of FinishKind.
inline constexpr FinishWord finish_words[] = {{"plain", FinishKind::Plain, 0, {}},
                                              {"matte", FinishKind::Matte, 0.5, roughness_range},
                                              {"velvet", FinishKind::Velvet, 0.5, roughness_range},
                                              {"metal", FinishKind::Metal, 0.3, roughness_range},
                                              {"coated", FinishKind::Coated, 1.5, coat_range},
                                              {"glass", FinishKind::Glass, 0.3, roughness_range}};

constexpr const FinishWord& word_of(FinishKind kind) { return finish_words[static_cast<std::size_t>(kind)]; }

}  // namespace rt
