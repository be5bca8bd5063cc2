// The integrators that a scene may ask for, one row each: their words, and what they look at in a world.
// To add one: its name and its row here, and its functions and its row in common/render/integrators.cpp.
#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// How a scene's rays become colours.
enum class Integrator { Raytrace, Flat, Directions, Normals, Uv, AnalyticDirect, Direct };

/// How a picture finds what each of its pixels sees.
enum class Visibility {
    Rays,       ///< by a ray through each sample of a pixel
    Rasterize,  ///< by scan conversion of triangles with a z-buffer, at the pixels' centres
};

/// A row of the table of integrators.
struct IntegratorRow {
    Integrator value;
    std::string_view name;     ///< the word after `integrator` and `--integrator`
    std::string_view meaning;  ///< what a picture shows
    std::string_view chapter;  ///< the number of one that it needs whatever the scene
    /// Where it has no row in common/povray/integrators.cpp: ends "POV-Ray cannot express this scene: ".
    std::string_view why_not_povray{};

    // What it looks at.
    bool objects = true;       ///< anything at all that is in the scene
    bool hit_alone = false;    ///< nothing but the nearest hit: then scan conversion can find that, too
    bool materials = false;    ///< the colours of materials, and so their patterns
    bool lights = false;       ///< lights, and so highlights and shadows
    bool area_lights = false;  ///< those with an extent, too
    bool tree = false;         ///< the mirrored and refracted rays of chapter 7's tree
    bool normals = false;      ///< shading normals, even where there are no lights
    bool uvs = false;          ///< texture coordinates
};

inline constexpr IntegratorRow integrators[] = {
    {.value = Integrator::Raytrace,
     .name = "raytrace",
     .meaning = "(default) the whole sum of light",
     .chapter = "01",
     .materials = true,
     .lights = true,
     .area_lights = true,
     .tree = true},
    {.value = Integrator::Flat,
     .name = "flat",
     .meaning = "ambient + emission",
     .chapter = "01",
     .hit_alone = true,
     .materials = true},
    {.value = Integrator::Directions,
     .name = "directions",
     .meaning = "(d + 1)/2 for the unit direction d of each ray",
     .chapter = "01",
     .objects = false},
    {.value = Integrator::Normals,
     .name = "normals",
     .meaning = "(n + 1)/2 for the unit shading normal n, turned to the viewer",
     .chapter = "01",
     .hit_alone = true,
     .normals = true},
    {.value = Integrator::Uv,
     .name = "uv",
     .meaning = "the texture coordinates as red and green",
     .chapter = "01",
     .hit_alone = true,
     .uvs = true},
    {.value = Integrator::AnalyticDirect,
     .name = "analyticdirect",
     .meaning = "the light of `quadLight`s on diffuse surfaces by Lambert's formula, without shadows",
     .chapter = "12",
     .why_not_povray = "it has no light of a whole polygon",
     .materials = true,
     .lights = true,
     .area_lights = true},
    {.value = Integrator::Direct,
     .name = "direct",
     .meaning = "the light of area lights by random points of them, in physical units: diffuse/π, and "
                "highlights by `brdf`",
     .chapter = "12",
     .why_not_povray = "its lights are no physical ones",
     .materials = true,
     .lights = true,
     .area_lights = true},
};

constexpr const IntegratorRow& row_of(Integrator integrator) {
    return integrators[static_cast<std::size_t>(integrator)];
}

/// Whether each row is where `row_of` looks for it.
constexpr bool integrators_are_in_order() {
    for (std::size_t i = 0; i < std::size(integrators); ++i)
        if (integrators[i].value != static_cast<Integrator>(i)) return false;
    return true;
}
static_assert(integrators_are_in_order());

/// What a word after `integrator` asks for.
struct IntegratorChoice {
    Integrator integrator = Integrator::Raytrace;
    Visibility visibility = Visibility::Rays;
};

/// An older word for `integrator normals` and `visibility rasterize`.
inline constexpr std::string_view rasterize_word = "rasterize";

/// What the word asks for; nothing if there is no such word.
std::optional<IntegratorChoice> integrator_named(std::string_view word);

/// All words after `integrator`: those of the table, then the older one.
std::vector<std::string_view> integrator_names();

/// The names of the rows of which `property` is true, for a sentence: `a, b and c`.
std::string integrators_with(bool IntegratorRow::*property);

}  // namespace rt
