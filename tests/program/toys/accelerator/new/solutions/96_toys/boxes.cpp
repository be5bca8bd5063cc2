// A toy accelerator: only shapes whose boxes are met are asked.
#include "chapters/96_toys/boxes.hpp"

#include "chapters/09_grids/bounds.hpp"

#include <algorithm>
#include <cstdint>

namespace rt {

bool serves(const Boxes&, const Ray& ray) {
    // [exercise 96.1] Rays along no axis, to keep this short.
    return ray.direction.x != 0 && ray.direction.y != 0 && ray.direction.z != 0;
    // [/exercise]
}

void search(const Boxes& boxes, const Ray& ray, Interval range, const Ask& ask) {
    for (std::uint32_t i = 0; i < boxes.boxes.size(); ++i) {
        // Moved out, so that rounding loses no shape.
        const Bounds& box = boxes.boxes[i];
        const Vec3 margin = 1e-9 * (Vec3(1) + glm::abs(box.low) + glm::abs(box.high));
        const Vec3 a = (box.low - margin - ray.origin) / ray.direction,
                   b = (box.high + margin - ray.origin) / ray.direction;
        const Vec3 in = glm::min(a, b), out = glm::max(a, b);
        const Real first = std::max({in.x, in.y, in.z, range.min}),
                   last = std::min({out.x, out.y, out.z, range.max});
        if (first <= last) range.max = ask({&i, 1}, range);
    }
}

std::size_t bytes_of(const Boxes& boxes) { return boxes.boxes.size() * sizeof(Bounds); }
std::string in_words(const Boxes& boxes) { return std::to_string(boxes.boxes.size()) + " boxes"; }

}  // namespace rt
