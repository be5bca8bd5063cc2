// The camera as the renderer reads it.
#pragma once

#include "common/scene/scene.hpp"

namespace rt {

/// Orthonormal right-handed basis of a camera: u to the right of the picture, v up, w backwards.
struct CameraFrame {
    Vec3 u{1, 0, 0};
    Vec3 v{0, 1, 0};
    Vec3 w{0, 0, 1};
};

/// All that a ray through a pixel depends on.
struct View {
    CameraFrame frame;
    Vec3 eye{0};
    Projection projection = Projection::Perspective;
    /// Half the height of the picture: at distance 1, tan(fovy/2), in perspective; in world units in
    /// an orthographic view.
    Real half_height = 1;
    int width = 1;   ///< pixels
    int height = 1;  ///< pixels
};

/// Pixels x0 ≤ x < x1, y0 ≤ y < y1 of a picture.
struct Tile {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
};

}  // namespace rt
