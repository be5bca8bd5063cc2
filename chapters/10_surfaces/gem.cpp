// Solids with flat faces, as many as one likes.
#include "chapters/10_surfaces/gem.hpp"

#include "common/math/todo.hpp"

namespace rt {

std::optional<Span> inside_gem(std::span<const Plane> planes, const Ray& ray) {
    // 10.16  Return the part of the line that is behind all of the planes, or nothing. The faces
    // are the planes' numbers.
    return todo("10.16");
}

}  // namespace rt
