// The camera in POV-Ray's language.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// Unit vectors to the right, upwards and backwards.
struct Basis {
    Vec3 u, v, w;
};
Basis basis_of(const Camera& camera);

/// The scene at the snapshot's time, seen from its place on the lens, with a camera that does not lean yet.
Scene still_of(const Scene& scene, const Snapshot& snapshot);

/// The unit vector against the ray through the middle of the picture; all rays' in an orthographic view.
Vec3 to_viewer(const Writer& out);

void write_camera(Writer& out);

}  // namespace rt::povray
