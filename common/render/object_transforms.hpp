// The transforms of a scene's objects: their matrices, and what can be said of them without looking at
// numbers.
#pragma once

#include "common/scene/scene.hpp"
#include "common/world/shapes.hpp"

#include <optional>
#include <vector>

namespace rt {

/// The transforms of a scene's objects; inverses are worked out where they are asked for.
class ObjectTransforms {
public:
    explicit ObjectTransforms(const Scene& scene);

    /// The transform of an object; nothing where it has none. Each step on the way to it is looked at, so
    /// that nothing is lost in the middle of a chain that later steps could not bring back. Throws InputError
    /// with the place of a step whose matrix has no inverse, or is out of range.
    std::optional<Transform> of(const Object& object);

    /// The factor by which the object's transform multiplies all lengths alike, if there is one.
    std::optional<Real> similarity(const Object& object) const;

    /// Whether the object's transform turns or mirrors directions.
    bool turns(const Object& object) const;

    /// The last step of the object's transform that turns while the shutter is open, as an index into
    /// Scene::transforms; −1 where none does.
    int last_spin(const Object& object) const;

    /// That step and those before it that turn, where they are at time 0, in the order of the file. Throws
    /// InputError with the place of one that is no turn, because lengths are not scaled all alike before it.
    std::vector<Spin> turns_until(int last_spin) const;

private:
    const Scene& scene;
    std::vector<Mat4> matrix;                  ///< these are a node of the scene's tree each
    std::vector<std::optional<Mat4>> inverse;  ///< of those that were asked for
    std::vector<std::optional<Real>> factor;
    std::vector<bool> turned;
    std::vector<int> spin;  ///< as last_spin
};

/// How much longer the longest half-axis of a ball's image is than the shortest; too much by a factor of 3 at
/// most.
Real flattening_of(const Transform& transform);

}  // namespace rt
