// What POV-Ray must be told of a scene depends on where its rays go on.
#pragma once

#include "common/scene/scene.hpp"

namespace rt::povray {

inline bool is_black(const Vec3& c) { return c == Vec3(0); }
inline bool is_grey(const Vec3& c) { return c.x == c.y && c.y == c.z; }

inline bool is_transparent(const Material& m) { return !is_black(m.transmission); }

inline const Material& material_of(const Scene& scene, const Object& object) {
    return scene.materials[object.material];
}

/// Whether there are lights, of whatever extent.
inline bool has_lights(const Scene& scene) { return !scene.lights.empty() || !scene.area_lights.empty(); }

/// Whether rays go on wherever a material sends them.
bool may_bounce(const Scene& scene);

/// Whether any object sends rays on.
bool has_bounces(const Scene& scene);

/// Whether the object sends refracted rays on.
bool is_glass(const Scene& scene, const Object& object);

/// Whether any ray loses light on its way through something.
bool absorbs(const Scene& scene);

}  // namespace rt::povray
