// The snapshots of which a picture of shared samples is the mean.
#pragma once

#include "common/scene/snapshot.hpp"

#include <vector>

namespace rt {

/// One snapshot a sample, in their order; none for a scene that is not blurred, or whose pixels do not share
/// their samples (common/scene/snapshot.hpp). They ask for the numbers that the renderer asks for, in its
/// order: the lens, the time, then the points of each light at the first hit. Throws InputError as `compile`
/// does.
std::vector<Snapshot> snapshots_of(const Scene& scene);

}  // namespace rt
