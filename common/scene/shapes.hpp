// The shapes of the course, as plain data.
#pragma once

#include "common/math/vec.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// All points p with dot(normal, p − point) = 0. `normal` need not be a unit vector; not zero.
struct Plane {
    Vec3 point{0};
    Vec3 normal{0, 1, 0};
};

/// All points at distance `radius` > 0 from `center`.
struct Sphere {
    Vec3 center{0};
    Real radius = 1;
};

/// Corners in counterclockwise order seen from the side that the normal points to.
struct Triangle {
    Vec3 a{0};
    Vec3 b{0};
    Vec3 c{0};
};

/// A planar polygon, convex or not, without holes; at least three vertices, in order.
struct Polygon {
    std::vector<Vec3> vertices;
};

/// Triangles that share vertices, as a `.obj` file gives them.
struct Mesh {
    /// Indices of one corner: position, and −1 where the file gives no normal or texture coordinate.
    struct Corner {
        std::int32_t position = 0;
        std::int32_t normal = -1;
        std::int32_t uv = -1;
    };
    std::string file;
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
    std::vector<Vec2> uvs;
    std::vector<std::array<Corner, 3>> triangles;
};

}  // namespace rt
