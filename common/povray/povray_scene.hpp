// A scene made ready for POV-Ray: of a size that it can tell apart, and without what it cannot express.
#pragma once

#include "common/scene/scene.hpp"

#include <string_view>

namespace rt {

/// Throws InputError with the object's `file:line:column`, or the scene's name, and the reason.
[[noreturn]] void refuse(const Scene& scene, const Object& object, std::string_view why);
[[noreturn]] void refuse(const Scene& scene, std::string_view why);

/// The unit vector along v, which may have any length but 0. Its digits stand in the references' files, so it
/// is not `unit`, which rounds otherwise.
Vec3 unit_along(const Vec3& v);

/// Whether the object sends refracted rays on.
bool is_glass(const Scene& scene, const Object& object);

/// The matrix of a node of the transform tree: its parents' steps on the left of its own; −1 is the identity.
Mat4 matrix_of(const Scene& scene, int node);

/// The object's smallest box along the axes in world space, as `low` and `high`; infinite for a plane.
struct Box {
    Vec3 low{infinity};
    Vec3 high{-infinity};
};
Box box_of(const Scene& scene, const Object& object);

/// Whether the eye is inside of a sphere or plane; POV-Ray's other shapes have no inside of their own.
bool surrounds_eye(const Scene& scene, const Object& object);

/// Whether the eye may be inside the object: in its box, or on the inner side of the plane.
bool may_surround_eye(const Scene& scene, const Object& object);

/// Whether any ray loses light on its way through something.
bool absorbs(const Scene& scene);

/// Whether a ray inside the absorbing object may go on for ever: it is no closed body.
bool is_endless(const Scene& scene, const Object& object);

/// How many steps the index of refraction of a transparent object must differ from what the scene says, so
/// that it differs from that of nothing where the object may stand in nothing, and from that of bodies that
/// it may overlap.
int bending_steps(const Scene& scene, const Object& object);

/// The power of two by which all lengths of the scene are multiplied for POV-Ray, whose tolerances are
/// lengths of its own: 1 where everything is between 0.01 and 1e4, as it must be. Refuses scenes that no
/// factor brings there.
Real povray_factor(const Scene& scene);

/// The same picture, with all lengths multiplied by a factor, a power of two; and where a transform makes
/// much or little of a shape, the shape has a size near 1 before it, because the tolerances hold there, too.
Scene sized_for_povray(Scene scene, Real factor);

/// Refuses scenes whose rays POV-Ray sends on otherwise: bodies with Fresnel's mirror inside others, whose
/// way out it takes for the way into nothing; light that is absorbed on its way to what it lights; glass of
/// single faces; and materials that have no layers of POV-Ray's.
void refuse_other_optics(const Scene& scene);

}  // namespace rt
