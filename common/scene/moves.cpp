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
    const auto is_turned = [&](const Object& object) {
        return object.transform >= 0 && turns[static_cast<std::size_t>(object.transform)];
    };
    const auto moves = [](const Object& object) { return object.motion != Vec3(0); };
    return std::ranges::any_of(scene.objects, moves) || std::ranges::any_of(scene.objects, is_turned) ||
           std::ranges::any_of(scene.parts, is_turned);
}

}  // namespace rt
