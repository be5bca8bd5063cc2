// The snapshots of which a blurred picture is the mean.
#pragma once

#include "common/scene/snapshot.hpp"

#include <vector>

namespace rt {

/// snapshot_count(scene) snapshots. If the pixels share their samples there is one a sample, in their order:
/// it asks for the numbers that the renderer asks for, in its order: the lens, the time, then the points of
/// each light at the first hit. Else they are scrambled Sobol' points, with one point of each light. Throws
/// InputError as `compile` does.
std::vector<Snapshot> snapshots_of(const Scene& scene);

}  // namespace rt
