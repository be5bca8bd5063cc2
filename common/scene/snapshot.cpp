// Which scenes are the mean of still ones, and what these look like.
#include "common/scene/snapshot.hpp"

#include "common/scene/moves.hpp"

#include <algorithm>

namespace rt {
namespace {

/// The node whose matrix is that of `node` after a move in world space.
int moved_node(Scene& scene, int node, const Vec3& by, const SourcePlace& place) {
    TransformNode moved{-1, Translate{by}, place};
    if (node >= 0) {
        moved = scene.transforms[static_cast<std::size_t>(node)];
        moved.parent = moved_node(scene, moved.parent, by, place);
    }
    scene.transforms.push_back(moved);
    return static_cast<int>(scene.transforms.size()) - 1;
}

/// Moves an object, or all that a combination is made of. A part stands in one combination only.
void move(Scene& scene, Object& object, const Vec3& by) {
    if (const auto* combined = std::get_if<CombinationObject>(&object.shape)) {
        for (const std::uint32_t part : combined->parts) move(scene, scene.parts[part], by);
        return;
    }
    object.transform = moved_node(scene, object.transform, by, object.place);
}

}  // namespace

bool is_blurred(const Scene& scene) {
    if (scene.visibility == Visibility::Rasterize) return false;
    const IntegratorRow& integrator = row_of(scene.integrator);
    return scene.lens.radius > 0 || scene.camera_motion != Vec3(0) ||
           (integrator.objects && anything_moves(scene)) ||
           (integrator.area_lights && !scene.area_lights.empty());
}

bool shares_samples(const Scene& scene) {
    if (is_random(scene.sampling.sampler)) return false;
    if (scene.area_lights.empty() || !row_of(scene.integrator).area_lights) return true;
    return scene.light_samples.how == LightSampling::Area && scene.light_samples.all;
}

int snapshot_count(const Scene& scene) {
    if (!is_blurred(scene)) return 0;
    if (shares_samples(scene)) return scene.sampling.count;
    const auto lights = static_cast<int>(std::max<std::size_t>(scene.area_lights.size(), 1));
    return std::clamp(4096 / lights, 64, 128);
}

Scene scene_at(Scene scene, Real time) {
    scene.camera.eye += time * scene.camera_motion, scene.camera.look_at += time * scene.camera_motion;
    scene.camera_motion = Vec3(0);
    for (TransformNode& node : scene.transforms)
        if (auto* turn = std::get_if<Rotate>(&node.step)) turn->angle += time * node.spin, node.spin = 0;
    for (Object& object : scene.objects) {
        if (object.motion == Vec3(0)) continue;
        const Vec3 by = time * object.motion;
        object.motion = Vec3(0);
        move(scene, object, by);
    }
    return scene;
}

}  // namespace rt
