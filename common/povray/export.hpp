// A scene in POV-Ray's language: every statement means the same there as here, to rounding.
// The mappings were measured with POV-Ray 3.7.0; the first lines of what this writes say how to render it.
#pragma once

#include "common/povray/run.hpp"
#include "common/scene/snapshot.hpp"

#include <span>
#include <string>

namespace rt {

/// The scene for POV-Ray 3.7, complete, and the same text for the same scene.
///
/// Numbers are written so that reading them gives back the same double. Where things are smaller than 0.01 or
/// farther than 1e4, all lengths are multiplied by a power of two, because POV-Ray's tolerances are lengths.
/// Throws InputError with the object's `file:line:column` and the reason for what POV-Ray cannot express.
///
/// `snapshots`: those of the scene (snapshots_of in common/render/snapshots.hpp); none of one that is not
/// blurred. Several become the frames of an animation, whose light is the scene's times its exposure
/// (common/povray/exposure.hpp).
std::string export_povray(const Scene& scene, std::span<const Snapshot> snapshots = {});

}  // namespace rt
