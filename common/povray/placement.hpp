// Where the objects of a scene are, in world space: around the eye, within each other.
#pragma once

#include "common/povray/shapes.hpp"

namespace rt::povray {

/// The matrix of a node of the transform tree: its parents' steps on the left of its own; −1 is the identity.
Mat4 matrix_of(const Scene& scene, int node);

/// The object's transform as ` matrix <...>`; empty where it has none.
std::string transform_of(const Scene& scene, const Object& object);

/// The object's box in world space; infinite for a plane.
Extent extent_of(const Scene& scene, const Object& object);

/// Whether two bodies may have a part in common.
bool may_overlap(const Scene& scene, const Object& a, const Object& b);

/// Whether both are untransformed balls, and the first is all within the second.
bool is_ball_within(const Object& inner, const Object& outer);

/// Whether the place is inside of a shape that POV-Ray knows the inside of.
bool surrounds(const Scene& scene, const Object& object, const Vec3& p);

/// Whether the eye is.
bool surrounds_eye(const Scene& scene, const Object& object);

/// Whether the body may have a point of what is between the corners.
bool may_reach(const Scene& scene, const Object& object, std::span<const Vec3> corners);

/// Whether the eye may be inside the object.
bool may_surround_eye(const Scene& scene, const Object& object);

}  // namespace rt::povray
