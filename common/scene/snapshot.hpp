// A blurred picture is the mean of still ones: what one sample of each pixel sees, if all pixels share their
// samples.
#pragma once

#include "common/scene/scene.hpp"

#include <string_view>
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

/// What sample number k of every pixel sees.
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

/// Why a blurred picture's pixels do not share their samples; empty if they do. Then it is the weighed mean
/// of as many snapshots as it has samples a pixel.
std::string_view why_no_snapshots(const Scene& scene);

/// The scene as it is at a time: objects and eye where they are then, and nothing that moves. Its lens and
/// its area lights are as they were.
Scene scene_at(Scene scene, Real time);

}  // namespace rt
