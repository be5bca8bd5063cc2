// What is refused because rounding would draw it wrong: objects out of the range of numbers.
#pragma once

#include "common/scene/scene.hpp"
#include "common/world/shapes.hpp"

#include <span>
#include <string>

namespace rt {

/// Throws InputError: what is wrong, after the place in the scene's file.
[[noreturn]] void refuse(const Scene& scene, SourcePlace place, const std::string& what);

/// Refuses an object, with its place, if a number is out of range (common/scene/range.hpp).
class ObjectLimits {
public:
    ObjectLimits(const Scene& of, const Object& what) : scene(of), object(what) {}

    /// A point that is too far away.
    void check_place(const Vec3& p) const;

    /// A size out of range; `noun` names what has it, as "radii".
    void check_size(const char* noun, Real size) const;

    /// Corners that are all in the same place, or on one line, are no error: there is nothing to see.
    void check_corners(std::span<const Vec3> corners) const;

    /// A ball that is too flat, or too far away in a parallel projection, would be drawn wrong by rounding.
    void check_ball(const Vec3& center, Real shortest, Real longest, Real flattening) const;

    /// An ellipsoid, by the map from the unit ball.
    void check_ellipsoid(const Transform& map) const;

    /// A mesh that instances share must be in range in its own space, too, and so its image.
    void check_instance(const Transform& map, const Sphere& bound) const;

    [[noreturn]] void fail(const std::string& what) const { refuse(scene, object.place, what); }

private:
    const Scene& scene;
    const Object& object;
};

}  // namespace rt
