// What varies a material at a hit: pictures, patterns, bumps.
#include "common/render/textures.hpp"

#include "chapters/11_textures/bump.hpp"
#include "chapters/11_textures/image_texture.hpp"
#include "chapters/11_textures/mip_map.hpp"
#include "chapters/11_textures/noise.hpp"
#include "chapters/11_textures/pattern.hpp"

#include <algorithm>

namespace rt {
namespace {

/// Lookups along the longer axis of a footprint, at most.
constexpr int most_probes = 16;

/// Which of the materials of World::materials a hit is on, whatever its checker: both of its colours have one
/// texture.
std::uint32_t material_of(const World& world, const Hit& hit) {
    return world.primitives[hit.primitive].material;
}

Vec3 picture_color(const MaterialTexture& texture, const Vec2& uv, const Footprint* seen) {
    if (texture.filter == TextureFilter::Nearest) return nearest(*texture.picture, uv, texture.wrap);
    if (!texture.pyramid || !seen) return bilinear(*texture.picture, uv, texture.wrap);
    if (texture.filter == TextureFilter::Anisotropic)
        return anisotropic(*texture.pyramid, uv, *seen, texture.wrap, most_probes);
    return trilinear(*texture.pyramid, uv, std::max(length(seen->dx), length(seen->dy)), texture.wrap);
}

/// The factor on the colours of a material with this texture.
Vec3 factor_at(const MaterialTexture& texture, const Surface& surface, const Footprint* seen) {
    Vec3 factor(1);
    if (texture.picture) factor = picture_color(texture, surface.uv, seen);
    // As with a checker, what lies exactly between two colours has the upper one, whatever its rounding.
    if (texture.pattern) factor *= pattern_color(*texture.pattern, surface.point + surface.error);
    return factor;
}

void multiply(Material& m, const ColorsOf& colors, const Vec3& factor) {
    if (colors.ambient) m.ambient *= factor;
    if (colors.diffuse) m.diffuse *= factor;
    if (colors.emission) m.emission *= factor;
    if (colors.specular) m.specular *= factor;
    if (colors.transmission) m.transmission *= factor;
    if (colors.absorption) m.absorption *= factor;
    if (colors.shininess) m.shininess *= factor.x;
}

}  // namespace

void apply_texture(const World& world, const Hit& hit, const Surface& surface, const Footprint* seen,
                   Material& material) {
    const MaterialTexture& texture = world.textures[material_of(world, hit)];
    if (texture.picture || texture.pattern)
        multiply(material, texture.colors, factor_at(texture, surface, seen));
}

void apply_bumps(const World& world, const Ray& ray, const Hit& hit, Surface& surface) {
    const Bumps& bumps = world.bumps[material_of(world, hit)];
    if (bumps.height == 0) return;
    // The gradient of height · noise(p/size).
    const Vec3 slope = bumps.height / bumps.size * noise_gradient(surface.point / bumps.size);
    const Vec3 to_viewer = normalize(-ray.direction);
    surface.shading_normal = kept_visible(bumped(surface.shading_normal, slope), surface.normal, to_viewer);
}

}  // namespace rt
