// From a scene as written to a world as rendered.
#include "common/render/compile.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/11_textures/harmonics.hpp"
#include "chapters/11_textures/mip_map.hpp"
#include "common/render/accelerate.hpp"
#include "common/render/area_lights.hpp"
#include "common/render/combinations.hpp"
#include "common/render/eye_inside.hpp"
#include "common/render/object_limits.hpp"
#include "common/render/primitives.hpp"
#include "common/scene/moves.hpp"
#include "common/scene/range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace rt {
namespace {

bool is_zero(const Vec3& v) { return v == Vec3(0); }

View view_of(const Scene& scene) {
    const Camera& camera = scene.camera;
    const bool perspective = camera.projection == Projection::Perspective;
    // Only directions matter to the frame, and those may come from places very near and very far apart.
    Camera directions = camera;
    directions.eye = near_one(camera.eye - camera.look_at);
    directions.look_at = Vec3(0);
    directions.up = near_one(camera.up);
    return {.frame = camera_frame(directions),
            .eye = camera.eye,
            .projection = camera.projection,
            .half_height = perspective ? std::tan(camera.fovy / 2) : camera.view_height / 2,
            .width = scene.width,
            .height = scene.height};
}

void compile_materials(const Scene& scene, World& world) {
    world.materials = scene.materials;
    for (const AreaLightObject& object : scene.area_lights) {
        Material shining;
        shining.ambient = Vec3(0), shining.emission = object.light.radiance;
        world.materials.push_back(shining);
    }
    if (!row_of(scene.integrator).materials) return;
    world.patterns.resize(world.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Checker& checker = scene.materials[i].checker;
        if (checker.even == Vec3(1) && checker.odd == Vec3(1)) continue;
        world.needs.patterns = true;
        const auto tinted = [&](const Vec3& factor) {
            Material m = scene.materials[i];
            m.ambient *= factor, m.diffuse *= factor, m.emission *= factor;
            return m;
        };
        world.materials[i] = tinted(checker.even);
        world.patterns[i] = {checker.size, static_cast<std::uint32_t>(world.materials.size())};
        world.materials.push_back(tinted(checker.odd));
    }
    world.patterns.resize(world.needs.patterns ? world.materials.size() : 0);
}

/// How a picture of the scene is looked up. Each picture has one pyramid.
struct Lookups {
    const Scene& scene;
    World& world;
    std::map<const Image*, std::shared_ptr<const MipMap>> pyramids{};

    PictureLookup of(const PictureTexture& from) {
        world.needs.uvs = true;
        PictureLookup lookup{scene.pictures[from.picture].image, nullptr, from.wrap, from.filter};
        if (lookup.filter < TextureFilter::Trilinear) return lookup;
        world.needs.footprints = true;
        std::shared_ptr<const MipMap>& pyramid = pyramids[lookup.image.get()];
        if (!pyramid) pyramid = std::make_shared<const MipMap>(mip_map(*lookup.image));
        lookup.pyramid = pyramid;
        return lookup;
    }
};

/// The textures and bumps of the materials, of which those of odd cubes are copies of others: they are found
/// by the material of the primitive.
void compile_textures(const Scene& scene, World& world) {
    const IntegratorRow& integrator = row_of(scene.integrator);
    Lookups lookups{scene, world};
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const std::int32_t number = scene.materials[i].texturing;
        if (number < 0) continue;
        const Texturing& from = scene.texturings[static_cast<std::size_t>(number)];
        if (integrator.materials && (from.picture || from.pattern)) {
            world.needs.textures = true;
            world.textures.resize(world.materials.size());
            MaterialTexture& texture = world.textures[i];
            texture.pattern = from.pattern, texture.colors = from.colors;
            if (from.picture) texture.picture = lookups.of(*from.picture);
        }
        if (!integrator.lights && !integrator.normals) continue;
        if (from.bumps.height != 0) {
            world.needs.bumps = true;
            world.bumps.resize(world.materials.size());
            world.bumps[i] = from.bumps;
        }
        if (from.normal_map) {
            world.needs.bumps = world.needs.normal_maps = true;
            world.normal_maps.resize(world.materials.size());
            world.normal_maps[i] = lookups.of(*from.normal_map);
        }
    }
}

/// The sky, and what it lights.
void compile_sky(const Scene& scene, World& world) {
    if (!scene.sky) return;
    world.sky = *scene.sky;
    world.needs.sky = true;
    const auto scatters = [](const Material& m) { return !is_zero(m.diffuse); };
    world.needs.skylight = scene.skylight && row_of(scene.integrator).lights &&
                           std::any_of(world.materials.begin(), world.materials.end(), scatters);
    if (world.needs.skylight) world.skylight = sky_light(world.sky);
}

void compile_lights(const Scene& scene, World& world) {
    const auto reflects = [](const Material& m) { return !is_zero(m.diffuse) || !is_zero(m.specular); };
    if (!std::any_of(world.materials.begin(), world.materials.end(), reflects)) return;
    for (const Light& light : scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light); point && !is_zero(point->color))
            world.point_lights.push_back(*point);
        if (const auto* far = std::get_if<DirectionalLight>(&light); far && !is_zero(far->color))
            world.directional_lights.push_back({unit(far->direction), far->color});
    }
}

/// What camera rays need besides a place of the picture.
void compile_camera(const Scene& scene, World& world) {
    world.blur.lens = scene.lens, world.blur.shutter = scene.shutter, world.blur.motion = scene.camera_motion;
    Needs& needs = world.needs;
    needs.lens = scene.lens.radius > 0;
    needs.motion =
        !is_zero(scene.camera_motion) || (row_of(scene.integrator).objects && anything_moves(scene));
    needs.blur = needs.lens || needs.motion;
}

/// What rays draw random numbers for once they have left the camera.
void derive_distribution(const Scene& scene, World& world) {
    Needs& needs = world.needs;
    needs.area_lights = !world.area_lights.lights.empty();
    if (needs.area_lights) {
        world.area_lights.samples = scene.light_samples;
        if (!scene.light_samples.all) world.area_lights.chances = chances_of(world.area_lights.lights);
    }
    const auto any_finish = [&](auto spreads) {
        return std::ranges::any_of(scene.objects, [&](const Object& object) {
            const Material& m = scene.materials[object.material];
            return m.finish >= 0 && spreads(m, scene.finishes[static_cast<std::size_t>(m.finish)]);
        });
    };
    needs.gloss = any_finish([&](const Material&, const Finish& of) {
        return (needs.reflection && of.gloss > 0) || (needs.refraction && of.translucency > 0);
    });
    needs.rough = any_finish([&](const Material& m, const Finish& of) {
        const bool sends_on = (needs.reflection && !is_zero(m.specular)) || !is_zero(m.transmission);
        return (needs.reflection || needs.refraction) && sends_on && of.brdf == Brdf::Ggx && of.roughness > 0;
    });
    if (needs.gloss || needs.rough || scene.integrator == Integrator::Direct) world.finishes = scene.finishes;
    needs.distribution = needs.area_lights || needs.gloss || needs.rough || needs.motion;
}

void derive_needs(const Scene& scene, World& world) {
    Needs& needs = world.needs;
    if (row_of(scene.integrator).area_lights)
        for (const AreaLightObject& object : scene.area_lights)
            world.area_lights.lights.push_back(object.light);
    const auto any = [&](auto has) {
        return std::any_of(world.materials.begin(), world.materials.end(), has);
    };
    const IntegratorRow& integrator = row_of(scene.integrator);
    if (integrator.lights) {
        compile_lights(scene, world);
        needs.lights = !world.point_lights.empty() || !world.directional_lights.empty() ||
                       !world.area_lights.lights.empty();
        needs.highlights = needs.lights && any([](const Material& m) { return !is_zero(m.specular); });
        needs.shadows = needs.lights && scene.shadows;
        needs.finishes =
            needs.lights && any([&](const Material& m) {
                return m.finish >= 0 && !is_zero(m.diffuse) &&
                       scene.finishes[static_cast<std::size_t>(m.finish)].kind != FinishKind::Plain;
            });
        if (needs.finishes) world.finishes = scene.finishes;
        needs.colored_shadows =
            needs.shadows && any([](const Material& m) { return !is_zero(m.transmission); });
    }
    needs.other_light = needs.finishes || needs.skylight;
    if (integrator.tree && scene.max_depth > 0) {
        needs.refraction = any([](const Material& m) { return !is_zero(m.transmission); });
        needs.reflection = any([](const Material& m) {
            // Glass mirrors by Fresnel's law, and where its reflection is total.
            const bool glass = !is_zero(m.transmission) && m.ior != 1;
            return !is_zero(m.specular) || glass;
        });
        needs.absorption = needs.refraction && any([](const Material& m) { return !is_zero(m.absorption); });
    }
    const auto is_smooth = [&](const Object& object) {
        if (const auto* t = std::get_if<TriangleObject>(&object.shape)) return t->smooth;
        if (const auto* m = std::get_if<MeshObject>(&object.shape))
            return !scene.meshes[m->mesh].normals.empty();
        return false;
    };
    needs.normals =
        (integrator.normals || needs.lights || needs.skylight || needs.reflection || needs.refraction) &&
        (std::ranges::any_of(scene.objects, is_smooth) || std::ranges::any_of(scene.parts, is_smooth));
    if (integrator.uvs) needs.uvs = true;
    derive_distribution(scene, world);
}

/// The greatest number that the texture of a material multiplies what mirrors or transmits by; at least 1.
Real greatest_factor(const World& world, std::uint32_t material) {
    if (!world.needs.textures) return 1;
    const MaterialTexture& texture = world.textures[material];
    if (!texture.colors.specular && !texture.colors.transmission) return 1;
    Real greatest = 1;
    if (texture.picture.image)
        for (const Vec3& pixel : texture.picture.image->pixels) greatest = std::max(greatest, size_of(pixel));
    if (texture.pattern)
        greatest *= std::max({Real(1), size_of(texture.pattern->first), size_of(texture.pattern->second)});
    return greatest;
}

/// Refuses what could make light so strong that its number ends. A factor above 1 may be met once a bounce,
/// and a filter above 1 at every surface of its material.
void check_growth_of_light(const Scene& scene, const World& world) {
    std::vector<Real> surfaces(world.materials.size(), 0);
    if (world.needs.colored_shadows)
        for (const Primitive& primitive : world.primitives)
            surfaces[primitive.material] +=
                std::visit([&](const auto& group) { return crossings_of(group.shapes[primitive.index]); },
                           world.groups[primitive.group]);
    const Real bounces = world.needs.reflection || world.needs.refraction ? world.max_depth : 0;
    for (const Object& object : scene.objects) {
        const Material& m = world.materials[object.material];
        const Real textured = greatest_factor(world, object.material);
        const Real filter = textured * size_of(m.transmission),
                   factor = std::max(filter, textured * size_of(m.specular));
        const bool grows =
            (factor > 1 && bounces * std::log10(factor) > std::log10(largest_number)) ||
            (filter > 1 && surfaces[object.material] * std::log10(filter) > std::log10(largest_number));
        if (grows)
            refuse(scene, object.place,
                   fmt::format(
                       "the material sends on {} times the light that it gets, which may grow beyond {}: "
                       "let specular and transmission be 1 at most, or maxdepth less",
                       factor, largest_number));
    }
}

/// Refuses what scan conversion cannot draw.
void check_rasterized(const Scene& scene) {
    if (const IntegratorRow& row = row_of(scene.integrator); !row.hit_alone)
        refuse(scene, scene.visibility_place,
               fmt::format("scan conversion finds what each pixel sees and nothing else: enough for "
                           "the integrators {}, but not for {}",
                           integrators_with(&IntegratorRow::hit_alone), row.name));
    for (const Object& object : scene.objects)
        if (!std::holds_alternative<TriangleObject>(object.shape) &&
            !std::holds_alternative<MeshObject>(object.shape))
            refuse(scene, object.place, "scan conversion draws triangles only");
}

}  // namespace

World compile(const Scene& scene) {
    World world;
    world.view = view_of(scene);
    world.background = scene.background;
    world.integrator = scene.integrator;
    world.visibility = scene.visibility;
    world.max_depth = scene.max_depth;
    world.min_contribution = scene.min_contribution;
    world.sampling = scene.sampling;
    // Scan conversion finds what is at the pixels' centres.
    compile_camera(scene, world);
    world.needs.samples =
        scene.visibility != Visibility::Rasterize &&
        (scene.sampling.count > 1 || !takes_its_own(scene.sampling.filter) || world.needs.blur);
    if (scene.visibility == Visibility::Rasterize) check_rasterized(scene);
    if (!row_of(scene.integrator).objects) return world;
    compile_materials(scene, world);
    compile_textures(scene, world);
    compile_sky(scene, world);
    derive_needs(scene, world);
    if (world.needs.distribution && scene.visibility != Visibility::Rasterize) world.needs.samples = true;
    add_primitives(scene, world);
    check_growth_of_light(scene, world);
    add_accelerators(scene, world);
    if (world.needs.refraction) world.eye_inside = objects_around_eye(world);
    return world;
}

}  // namespace rt
