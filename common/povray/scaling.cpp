// All lengths of a scene, and what it takes to multiply them.
#include "common/povray/scaling.hpp"

#include "common/povray/area_lights.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/refuse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::povray {
namespace {

/// Between these lengths its pictures agree with ours: a shadow ray overlooks what is nearer than 0.001, and
/// nothing is seen that is farther than 1e7.
constexpr Real least_length = 0.01;
constexpr Real greatest_length = 1e4;
/// Lights have no size, and may be farther away.
constexpr Real greatest_light_distance = 1e6;

/// The least and greatest of the lengths that POV-Ray must tell from nothing and from infinity.
struct Lengths {
    Real least = infinity;
    Real greatest = 0;
    Real lights = 0;  ///< the greatest distance of a point light
};

Lengths lengths_of(const Scene& scene) {
    Lengths lengths;
    for (const Object& object : scene.objects) {
        const Mat4 m = matrix_of(scene, object.transform);
        lengths.greatest = std::max(lengths.greatest, reach_of(scene, object, m));
        const Real least = least_length_of(scene, object, m);
        if (least > 0) lengths.least = std::min(lengths.least, least);
    }
    for (const AreaLightObject& object : scene.area_lights) {
        lengths.greatest = std::max(lengths.greatest, reach_of(object.light, scene.camera.eye));
        lengths.least = std::min(lengths.least, least_length_of(object.light));
    }
    if (row_of(scene.integrator).lights)
        for (const Light& light : scene.lights)
            if (const auto* point = std::get_if<PointLight>(&light))
                lengths.lights = std::max(lengths.lights, glm::length(point->position - scene.camera.eye));
    return lengths;
}

/// The power of two that brings a shape of this size near 1; 1 where it need not be.
Real factor_for(Real size) {
    if (size == 0 || (size >= least_length && size <= greatest_length)) return 1;
    return std::exp2(std::round(-std::log2(size)));
}

/// Multiplies all lengths of the scene.
void scale_world(Scene& scene, Real factor) {
    scene.camera.eye *= factor, scene.camera.look_at *= factor, scene.camera.view_height *= factor;
    scene.camera_motion *= factor, scene.lens.radius *= factor, scene.lens.distance *= factor;
    for (Mesh& mesh : scene.meshes)
        for (Vec3& p : mesh.positions) p *= factor;
    for (Material& m : scene.materials) m.checker.size *= factor, m.absorption /= factor;
    for (Texturing& texturing : scene.texturings) {
        if (texturing.pattern) texturing.pattern->size *= factor;
        texturing.bumps.height *= factor, texturing.bumps.size *= factor;
    }
    for (TransformNode& node : scene.transforms)
        if (auto* move = std::get_if<Translate>(&node.step)) move->by *= factor;
    for (Object& object : scene.objects) scale(scene, object, factor), object.motion *= factor;
    for (Object& part : scene.parts) scale(scene, part, factor);
    for (AreaLightObject& object : scene.area_lights) scale(object.light, factor);
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) {
            point->position *= factor;
            point->attenuation.y /= factor, point->attenuation.z /= factor * factor;
        }
}

/// Undoes for an object what has been done to its shape.
void shrink(Scene& scene, Object& object, Real factor) {
    scene.transforms.push_back({object.transform, Scale{Vec3(1 / factor)}, object.place});
    object.transform = static_cast<int>(scene.transforms.size()) - 1;
}

/// Brings a mesh to a size near 1 in its own space, whatever its objects' transforms make of it.
void size_mesh(Scene& scene, std::size_t index) {
    Mesh& mesh = scene.meshes[index];
    Vec3 low(infinity), high(-infinity);
    for (const Vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const Real factor = mesh.positions.empty() ? 1 : factor_for(glm::length(high - low));
    if (factor == 1) return;
    for (Vec3& p : mesh.positions) p *= factor;
    for (std::vector<Object>* objects : {&scene.objects, &scene.parts})
        for (Object& object : *objects)
            if (const auto* shown = std::get_if<MeshObject>(&object.shape); shown && shown->mesh == index)
                shrink(scene, object, factor);
}

/// The same for a transformed shape of its own numbers.
void size_shape(Scene& scene, Object& object) {
    if (object.transform < 0) return;
    const Real factor = factor_for(own_size(scene, object));
    if (factor == 1) return;
    scale(scene, object, factor);
    shrink(scene, object, factor);
}

}  // namespace

Real factor_for(const Scene& scene) {
    // Then only the eye has a place.
    if (!row_of(scene.integrator).objects) {
        const Real far = glm::length(scene.camera.eye);
        return far > greatest_length ? factor_for(far) : 1;
    }
    const Lengths lengths = lengths_of(scene);
    if (lengths.greatest == 0) return 1;  // nothing but planes through the eye
    const Real least = std::min(lengths.least, lengths.greatest);
    const auto fits = [&](Real factor) {
        return lengths.least * factor >= least_length && lengths.greatest * factor <= greatest_length &&
               lengths.lights * factor <= greatest_light_distance;
    };
    if (fits(1)) return 1;
    // The middle of what is there goes to the middle of what may be.
    const Real middle = std::sqrt(least_length * greatest_length);
    const Real factor =
        std::exp2(std::round(std::log2(middle / std::sqrt(least) / std::sqrt(lengths.greatest))));
    if (!fits(factor))
        refuse(scene, fmt::format(
                          "its lengths are from {:.3g} to {:.3g}, and only a factor of {:.0e} between the "
                          "smallest object and the farthest point is safe from its tolerances",
                          least, std::max(lengths.greatest, lengths.lights), greatest_length / least_length));
    return factor;
}

Scene scaled(Scene scene, Real factor) {
    if (factor != 1) scale_world(scene, factor);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) size_mesh(scene, i);
    for (Object& object : scene.objects) size_shape(scene, object);
    for (Object& part : scene.parts) size_shape(scene, part);
    return scene;
}

}  // namespace rt::povray
