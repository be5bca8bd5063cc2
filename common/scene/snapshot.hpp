// A blurred picture is the mean of still ones. If all pixels share their samples it is exactly that: each
// still is what one sample of every pixel sees.
#pragma once

#include "common/scene/scene.hpp"

#include <vector>

namespace rt {

/// One point of an area light: it sends color · cos θ / d² to what is d away in the direction θ from its
/// normal, and nothing behind it. An area light of radiance L and area A is the mean of points of the colour
/// L·A/π.
struct FacingLight {
    Vec3 point{0};
    Vec3 normal{0, 1, 0};  ///< unit
    Vec3 color{0};
};

/// What one sample of every pixel sees.
struct Snapshot {
    Vec2 at{0.5};     ///< place in the pixel, as a PixelSample has it
    Real weight = 1;  ///< as a PixelSample's
    Vec2 lens{0};     ///< where the ray leaves the lens: to the right and up, world units
    Real time = 0;
    std::vector<FacingLight> lights{};
};

/// Whether the picture is no single still one: there is a lens, motion or lights with an extent that it looks
/// at.
bool is_blurred(const Scene& scene);

/// Whether all pixels of a blurred scene share their samples, and all places the points of its lights. Then
/// its picture is the weighed mean of as many snapshots as it has samples a pixel; else it is the mean of
/// many random snapshots, but for the errors of both.
bool shares_samples(const Scene& scene);

/// How many snapshots show a blurred scene: its samples if pixels share them, else 128, or fewer where that
/// asks more than 4096 points of lights, but at least 64. None of one that is not blurred.
int snapshot_count(const Scene& scene);

/// The scene as it is at a time: objects and eye where they are then, and nothing that moves. Its lens and
/// its area lights are as they were.
Scene scene_at(Scene scene, Real time);

}  // namespace rt
