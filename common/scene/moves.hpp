// What moves or turns while the shutter is open.
#pragma once

#include "common/scene/scene.hpp"

namespace rt {

/// Whether any object moves, or stands under a transform that turns.
bool anything_moves(const Scene& scene);

}  // namespace rt
