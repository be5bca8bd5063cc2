// What varies a material at a hit: pictures, patterns, bumps.
#include "common/render/textures.hpp"

#include "chapters/11_textures/bump.hpp"
#include "chapters/11_textures/image_texture.hpp"
#include "chapters/11_textures/mip_map.hpp"
#include "chapters/11_textures/noise.hpp"
#include "chapters/11_textures/pattern.hpp"
#include "common/render/texture_places.hpp"

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

Vec3 picture_color(const PictureLookup& picture, const Vec2& uv, const Footprint* seen) {
    if (picture.filter == TextureFilter::Nearest) return nearest(*picture.image, uv, picture.wrap);
    if (!picture.pyramid || !seen) return bilinear(*picture.image, uv, picture.wrap);
    if (picture.filter == TextureFilter::Anisotropic)
        return anisotropic(*picture.pyramid, uv, *seen, picture.wrap, most_probes);
    return trilinear(*picture.pyramid, uv, std::max(length(seen->dx), length(seen->dy)), picture.wrap);
}

/// The factor on the colours of a material with this texture.
Vec3 factor_at(const MaterialTexture& texture, const Surface& surface, const Footprint* seen) {
    Vec3 factor(1);
    if (texture.picture.image) factor = picture_color(texture.picture, surface.uv, seen);
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
    if (colors.shininess) m.shininess *= std::max(factor.x, Real(0));
    m.finish_factor = static_cast<float>(factor.x);
}

}  // namespace

void apply_texture(const World& world, const Hit& hit, const Surface& surface, const Footprint* seen,
                   Material& material) {
    const MaterialTexture& texture = world.textures[material_of(world, hit)];
    if (texture.picture.image || texture.pattern)
        multiply(material, texture.colors, factor_at(texture, surface, seen));
}

void apply_bumps(const World& world, const Ray& ray, const Hit& hit, const Footprint* seen,
                 Surface& surface) {
    const std::uint32_t material = material_of(world, hit);
    const Bumps bumps = world.bumps.empty() ? Bumps() : world.bumps[material];
    const PictureLookup* const map = world.normal_maps.empty() ? nullptr : &world.normal_maps[material];
    const bool is_mapped = map && map->image;
    if (bumps.height == 0 && !is_mapped) return;
    Vec3 normal = surface.shading_normal;
    if (is_mapped) {
        const TexturePoint place = texture_point_at(world, ray, hit, surface);
        normal = from_normal_map(picture_color(*map, surface.uv, seen), place.du, place.dv, normal);
    }
    // The gradient of height · noise(p/size).
    if (bumps.height != 0)
        normal = bumped(normal, bumps.height / bumps.size * noise_gradient(surface.point / bumps.size));
    surface.shading_normal = kept_visible(normal, surface.normal, normalize(-ray.direction));
}

}  // namespace rt
