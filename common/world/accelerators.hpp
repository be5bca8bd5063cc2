// Accelerators: what is built so that a ray need not ask every shape. They see boxes and hand out numbers of
// shapes; none of them knows what a shape is.
#pragma once

#include "common/math/ray.hpp"
#include "common/world/bounding_volumes.hpp"
#include "common/world/grid.hpp"
#include "common/world/hierarchy.hpp"

#include <span>
#include <type_traits>
#include <variant>

namespace rt {

/// No accelerator: every shape is asked.
struct Nothing {};

/// All accelerators. One brings, beside its data here, in its chapter's contract
///   bool serves(const A&, const Ray&)                    whether it can tell what this ray may meet;
///   void search(const A&, const Ray&, Interval, Ask)     tells it, in the order along the ray;
///   std::size_t bytes_of(const A&)                       the memory that it takes;
///   std::string in_words(const A&)                       what messages call it, such as "grid of 2 × 3 × 4
///   cells".
/// What builds it where it pays is common/render/accelerate.cpp.
using Accelerator = std::variant<Nothing, Grid, Hierarchy, VolumeTree<BoundingSphere>,
                                 VolumeTree<OrientedBox>, VolumeTree<BoundingEllipsoid>>;

/// What a search calls on its way: it hands over the numbers of shapes that may be met in a part of the ray,
/// and gets back how far along the ray it still has to look. That is the nearest hit so far, where another
/// may be as near, or −∞ where nothing more is wanted. A reference to a function: cheap to pass on, and no
/// longer valid than what it was made from.
class Ask {
public:
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, Ask>) Ask(const Function& function)
        : object(&function), call([](const void* f, std::span<const std::uint32_t> shapes, Interval part) {
              return (*static_cast<const Function*>(f))(shapes, part);
          }) {}
    Real operator()(std::span<const std::uint32_t> shapes, Interval part) const {
        return call(object, shapes, part);
    }

private:
    const void* object;
    Real (*call)(const void*, std::span<const std::uint32_t>, Interval);
};

}  // namespace rt
