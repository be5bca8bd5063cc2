// What moves or turns while the shutter is open.
#include "common/scene/moves.hpp"

#include <algorithm>
#include <vector>

namespace rt {

bool anything_moves(const Scene& scene) {
    // Parents stand before children.
    std::vector<bool> turns;
    for (const TransformNode& node : scene.transforms)
        turns.push_back(node.spin != 0 || (node.parent >= 0 && turns[static_cast<std::size_t>(node.parent)]));
    const auto moves = [&](const Object& object) {
        return object.motion != Vec3(0) ||
               (object.transform >= 0 && turns[static_cast<std::size_t>(object.transform)]);
    };
    return std::ranges::any_of(scene.objects, moves) || std::ranges::any_of(scene.parts, moves);
}

}  // namespace rt
