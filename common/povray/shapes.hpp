// The shapes of a file in POV-Ray's language, and what else it must be told of them.
// None of these looks at the object's transform or material.
#pragma once

#include "common/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rt::povray {

/// A box along the axes; without a point inside where `low` is greater.
struct Extent {
    Vec3 low{infinity};
    Vec3 high{-infinity};
};

/// Its statement, still open for what else is said of the object: `sphere { <0, 0, 0>, 1`.
std::string open_statement(const Scene& scene, const Object& object);

/// The same of a combination, of whose parts each has a texture of its own: `texture(part)` is its name, of
/// an index into Scene::parts.
std::string open_statement_by_parts(const Scene& scene, const CombinationObject& whole,
                                    const std::function<std::string(std::uint32_t part)>& texture);

/// The parts of a combination, and of those inside it, that are none themselves; indices into Scene::parts.
std::vector<std::uint32_t> leaves_of(const Scene& scene, const CombinationObject& whole);

/// The whole statement with texture coordinates as colours; `transform` is a text, too.
std::string with_uv(const Scene& scene, const Object& object, const std::string& transform);

/// The box of the shape after `m`; infinite for a shape without an end.
Extent extent_of(const Scene& scene, const Object& object, const Mat4& m);

/// The least length that is to be told from nothing after `m`; 0 where there is none.
Real least_length_of(const Scene& scene, const Object& object, const Mat4& m);

/// How far from the eye the shape reaches after `m`: the farthest corner of its box, but straight to a plane.
Real reach_of(const Scene& scene, const Object& object, const Mat4& m);

/// Whether a body of this shape, after `m`, may have a point of what is between the corners.
bool may_reach(const Scene& scene, const Object& object, const Mat4& m, std::span<const Vec3> corners);

/// The shape's size in its own space; 0 where it has none, or none that `scale` changes.
Real own_size(const Scene& scene, const Object& object);

/// Multiplies the shape's own lengths; vertices may be shared, so it gets new ones. Meshes, and the
/// parts of combinations, are scaled by themselves (scaling.cpp).
void scale(Scene& scene, Object& object, Real factor);

/// Whether `p`, in the shape's own space, is inside of it for POV-Ray, whose meshes have no inside unless
/// they are told of one.
bool contains(const Scene& scene, const Object& object, const Vec3& p);

/// Whether a ray inside may go on for ever: the box is infinite, or a mesh not closed.
bool is_endless(const Scene& scene, const Object& object);

}  // namespace rt::povray
