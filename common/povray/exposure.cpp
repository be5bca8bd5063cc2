// Everything that shines, and what it takes to make it darker.
#include "common/povray/exposure.hpp"

#include "common/math/vec.hpp"
#include "common/scene/snapshot.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// Visits all colours that are light, not a share of it. A sky's picture is not among them.
void visit_light(auto& scene, const auto& visit) {
    visit(scene.background);
    if (scene.sky) {
        if (auto* constant = std::get_if<ConstantSky>(&*scene.sky)) visit(constant->color);
        if (auto* gradient = std::get_if<GradientSky>(&*scene.sky))
            visit(gradient->zenith), visit(gradient->horizon), visit(gradient->nadir);
    }
    for (auto& material : scene.materials) visit(material.ambient), visit(material.emission);
    for (auto& light : scene.lights) std::visit([&](auto& one) { visit(one.color); }, light);
    for (auto& object : scene.area_lights) visit(object.light.radiance);
}

}  // namespace

Real exposure_of(const Scene& scene) {
    if (!is_blurred(scene) || shares_samples(scene) || !row_of(scene.integrator).lights) return 1;
    if (scene.sky && std::holds_alternative<ImageSky>(*scene.sky)) return 1;
    Real brightest = 1;
    visit_light(scene, [&](const Vec3& color) { brightest = std::max(brightest, max_component(color)); });
    return std::exp2(-2 - std::ceil(std::log2(brightest)));
}

Scene povray::exposed(Scene scene, Real exposure) {
    if (exposure != 1) visit_light(scene, [&](Vec3& color) { color *= exposure; });
    return scene;
}

}  // namespace rt
