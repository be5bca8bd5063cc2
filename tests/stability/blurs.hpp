// The billiard table of chapter 12 with some of its blurs: what its figures and the report measure.
#pragma once

#include "common/scene/scene.hpp"

#include <variant>

namespace rt::test {

struct Blurs {
    bool lens = false, motion = false, lamps = false, gloss = false;
};

/// `scene`, references/12_distribution/billiards.scene, with these of its blurs, and every lamp asked.
/// Without their extent each of its lamps is a point that is as bright.
inline Scene with_blurs(Scene scene, const Blurs& blurs) {
    scene.light_samples.all = true;
    if (!blurs.lens) scene.lens.radius = 0;
    if (!blurs.motion)
        for (Object& object : scene.objects) object.motion = Vec3(0);
    if (!blurs.gloss)
        for (Finish& finish : scene.finishes) finish.gloss = 0;
    if (!blurs.lamps) {
        for (const AreaLightObject& lamp : scene.area_lights) {
            const auto& quad = std::get<QuadLight>(lamp.light.shape);
            const Real area = length(cross(quad.ab, quad.ac));
            scene.lights.push_back(PointLight{quad.corner + 0.5 * (quad.ab + quad.ac),
                                              area / pi * lamp.light.radiance, Vec3(0, 0, 1)});
        }
        scene.area_lights.clear();
    }
    return scene;
}

}  // namespace rt::test
