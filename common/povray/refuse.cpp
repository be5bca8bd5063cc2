// Scenes whose rays POV-Ray sends on otherwise than we do.
#include "common/povray/refuse.hpp"

#include "common/math/input_error.hpp"
#include "common/povray/bumps.hpp"
#include "common/povray/camera.hpp"
#include "common/povray/optics.hpp"
#include "common/povray/placement.hpp"
#include "common/scene/cut_open.hpp"
#include "common/scene/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rt::povray {
namespace {

bool is_lit(const Scene& scene) {
    const auto reflects = [&](const Object& object) {
        const Material& m = material_of(scene, object);
        return !is_black(m.diffuse) || !is_black(m.specular);
    };
    const auto shines = [](const Light& light) {
        return std::visit([](const auto& one) { return !is_black(one.color); }, light);
    };
    const auto glows = [](const AreaLightObject& object) { return !is_black(object.light.radiance); };
    return (std::ranges::any_of(scene.lights, shines) || std::ranges::any_of(scene.area_lights, glows)) &&
           std::ranges::any_of(scene.objects, reflects);
}

/// Whether some, but not all, of the rays of an orthographic view may begin inside the object.
bool is_around_part_of_view(const Scene& scene, const Object& object) {
    const Camera& camera = scene.camera;
    const auto [u, v, w] = basis_of(camera);
    const Real high = camera.view_height / 2, wide = high * scene.width / scene.height;
    const Vec3 up = high * v, right = wide * u;
    const std::array<Vec3, 4> corners{camera.eye + right + up, camera.eye + right - up,
                                      camera.eye - right + up, camera.eye - right - up};
    const bool all =
        std::ranges::all_of(corners, [&](const Vec3& corner) { return surrounds(scene, object, corner); });
    return !all && may_reach(scene, object, corners);
}

/// Our rays are all inside of what the eye is inside of, also those that an orthographic view begins beside
/// it.
void refuse_partly_inside(const Scene& scene) {
    if (scene.camera.projection != Projection::Orthographic) return;
    for (const Object& object : scene.objects)
        if (is_glass(scene, object) && is_around_part_of_view(scene, object))
            refuse(scene, object, "transparent, and an orthographic view begins partly inside of it");
}

void refuse_nested_fresnel(const Scene& scene) {
    for (const Object& mirror : scene.objects) {
        if (!is_glass(scene, mirror) || material_of(scene, mirror).fresnel == Fresnel::None) continue;
        for (const Object& other : scene.objects)
            if (&other != &mirror && is_glass(scene, other) && may_overlap(scene, mirror, other))
                refuse(scene, mirror,
                       fmt::format("fresnel where it may be inside or around the transparent object of line "
                                   "{}: on the way out POV-Ray forgets what is around",
                                   other.place.line));
    }
}

/// Of bodies around the eye, the one that is left first is the innermost; POV-Ray has an order of its own.
void refuse_order_around_eye(const Scene& scene) {
    std::vector<const Object*> around;
    for (const Object& object : scene.objects)
        if (is_glass(scene, object) && surrounds_eye(scene, object)) around.push_back(&object);
    for (const Object* object : around)
        if (material_of(scene, *object).ior != material_of(scene, *around.front()).ior)
            refuse(
                scene, *object,
                fmt::format("transparent and around the eye, as is the one of line {} with another index of "
                            "refraction: POV-Ray does not know which is the inner one",
                            around.front()->place.line));
}

/// Of several bodies in one place, ours is made of the one that a ray entered last, which displaces the
/// others; POV-Ray adds up what all of them absorb. That is the same where the last one alone absorbs.
void refuse_nested_absorption(const Scene& scene) {
    const auto is_clear = [&](const Object& object) {
        return is_black(material_of(scene, object).absorption);
    };
    for (const Object& object : scene.objects) {
        if (!is_glass(scene, object) || is_clear(object)) continue;
        for (const Object& other : scene.objects) {
            if (&other == &object || !is_glass(scene, other) || !may_overlap(scene, object, other)) continue;
            if (is_clear(other) && is_ball_within(object, other)) continue;
            refuse(
                scene, object,
                fmt::format("absorption where it may be in one place with the transparent object of line {}: "
                            "POV-Ray adds up what both absorb",
                            other.place.line));
        }
    }
}

/// POV-Ray's weight of a ray is the product of the strongest channels on its way, and leaves out Fresnel's
/// share.
void refuse_weights(const Scene& scene, const Object& object) {
    const Material& m = material_of(scene, object);
    if (scene.min_contribution == 0) return;
    if (!is_grey(m.specular) || !is_grey(m.transmission))
        refuse(scene, object,
               "a coloured mirror or glass with mincontribution: POV-Ray's weights have no colour");
    if (is_glass(scene, object) && m.fresnel != Fresnel::None)
        refuse(scene, object, "fresnel with mincontribution: POV-Ray's weights leave it out");
}

void refuse_material(const Scene& scene, const Object& object) {
    const Material& m = material_of(scene, object);
    if (has_lights(scene) && !is_grey(m.specular)) {
        if (m.fresnel != Fresnel::None)
            refuse(scene, object, "a transparent material with fresnel and a coloured highlight");
        for (int i = 0; i < 3; ++i)
            if (m.specular[i] == 0 && m.transmission[i] > 0)
                refuse(scene, object,
                       "a transparent material whose highlight lacks a channel that it transmits");
    }
    if (m.fresnel == Fresnel::Schlick)
        refuse(scene, object,
               "Schlick's approximation, for which POV-Ray takes the angle of incidence also where light "
               "leaves the denser side");
    if (!is_black(m.absorption) && may_bounce(scene) && is_lit(scene))
        refuse(scene, object,
               "absorption in a scene with lights, whose light POV-Ray absorbs on its way to a surface, too");
}

void refuse_glass_shape(const Scene& scene, const Object& object) {
    if (cut_open(object.shape)) refuse(scene, object, "a transparent surface that its box cuts open");
    if (!words_of(object.shape).has_inside)
        refuse(scene, object, "a transparent object without an inside; put its faces into one `mesh`");
    const auto* shown = std::get_if<MeshObject>(&object.shape);
    if (may_bounce(scene) && shown && !scene.meshes[shown->mesh].normals.empty())
        refuse(scene, object,
               "a transparent mesh with normals of its own, through whose flat faces POV-Ray takes rays "
               "inside that stay outside");
}

bool has_normal_map(const Scene& scene, const Object& object) {
    const std::int32_t texturing = material_of(scene, object).texturing;
    return texturing >= 0 && scene.texturings[static_cast<std::size_t>(texturing)].normal_map.has_value();
}

void refuse_bumps(const Scene& scene, const Object& object) {
    if (is_transparent(material_of(scene, object)))
        refuse(scene, object, "transparent bumps, which it turns to the other side inside");
    if (!words_of(object.shape).has_inside)
        refuse(scene, object, "bumps that may be seen from behind, where it makes dents of them");
    if (has_bounces(scene))
        refuse(scene, object, "bumps that a mirror or glass may show: they lean as the eye sees them");
}

/// Of the finish, what the integrator looks at.
void refuse_finish(const Scene& scene, const Object& object, const Finish& finish) {
    if (finish.kind != FinishKind::Plain) refuse(scene, object, "a finish, whose lobe it does not have");
    const bool rough =
        finish.brdf == Brdf::Ggx && finish.roughness > 0 &&
        !(is_black(material_of(scene, object).specular) && !is_transparent(material_of(scene, object)));
    if (has_bounces(scene) && (finish.gloss > 0 || finish.translucency > 0 || rough))
        refuse(scene, object, "mirrored or refracted rays that spread in a lobe");
}

void refuse_texturing(const Scene& scene, const Object& object) {
    const Material& m = material_of(scene, object);
    const Texturing& t = scene.texturings[static_cast<std::size_t>(m.texturing)];
    const ColorsOf& colors = t.colors;
    if (t.picture && t.picture->filter >= TextureFilter::Trilinear)
        refuse(scene, object, "a texture that is averaged over what a pixel sees");
    if (t.pattern && t.pattern->kind == PatternKind::Cellular)
        refuse(scene, object, "cells, whose random points its functions cannot compute");
    if (colors.absorption && (t.picture || t.pattern) && !is_black(m.absorption))
        refuse(scene, object, "absorption that varies");
    const bool is_smooth = t.picture || (t.pattern && t.pattern->kind != PatternKind::Stripes &&
                                         t.pattern->kind != PatternKind::Rings);
    if (colors.shininess && is_smooth) refuse(scene, object, "shininess that varies smoothly");
    if (t.picture && colors.transmission && is_transparent(m) && m.fresnel != Fresnel::None)
        refuse(scene, object, "a picture of what goes through glass with fresnel");
    if (t.picture && scene.min_contribution > 0 && (colors.specular || colors.transmission))
        refuse(scene, object, "a picture of what mirrors or transmits with mincontribution");
}

}  // namespace

void refuse(const Scene& scene, const Object& object, std::string_view why) {
    throw InputError(at_place(scene.file, object.place.line, object.place.column,
                              fmt::format("POV-Ray cannot express this object: {}", why)));
}

void refuse(const Scene& scene, const AreaLightObject& light, std::string_view why) {
    throw InputError(fmt::format("{}:{}:{}: POV-Ray cannot express this light: {}", scene.file,
                                 light.place.line, light.place.column, why));
}

void refuse(const Scene& scene, std::string_view why) {
    throw InputError(fmt::format("{}: POV-Ray cannot express this scene: {}", scene.file, why));
}

void refuse_other_optics(const Scene& scene) {
    const IntegratorRow& integrator = row_of(scene.integrator);
    for (const Object& object : scene.objects) {
        if (integrator.materials && material_of(scene, object).texturing >= 0)
            refuse_texturing(scene, object);
        if (integrator.lights || integrator.normals) {
            if (has_normal_map(scene, object))
                refuse(scene, object, "a normal map: its bump maps know heights only");
            if (bumps_of(scene, material_of(scene, object))) refuse_bumps(scene, object);
        }
        if (integrator.lights && material_of(scene, object).finish >= 0)
            refuse_finish(scene, object,
                          scene.finishes[static_cast<std::size_t>(material_of(scene, object).finish)]);
        if (may_bounce(scene)) refuse_weights(scene, object);
        if (!is_glass(scene, object)) continue;
        refuse_material(scene, object);
        refuse_glass_shape(scene, object);
    }
    // Where the picture is a mean of many snapshots, all bounces may share a snapshot's points.
    if (integrator.area_lights && !scene.area_lights.empty() && has_bounces(scene) && shares_samples(scene))
        refuse(scene, scene.area_lights.front(),
               "an extent in a scene with bounces, each of which has points of its own: say 'maxdepth 0'");
    if (scene.sky && absorbs(scene)) refuse(scene, "absorption under a sky of more than one colour");
    if (!may_bounce(scene)) return;
    refuse_nested_fresnel(scene);
    refuse_nested_absorption(scene);
    refuse_order_around_eye(scene);
    refuse_partly_inside(scene);
}

void refuse_other_eye(const Scene& scene, const Scene& still) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (is_glass(scene, scene.objects[i]) &&
            surrounds_eye(scene, scene.objects[i]) != surrounds_eye(still, still.objects[i]))
            refuse(scene, scene.objects[i],
                   "transparent, and a part of the lens, or the eye at some time, is on its other side");
}

}  // namespace rt::povray
