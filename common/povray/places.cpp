// One section a shape: a frame, in which it is simple, and formulas in the frame's x, y and z.
#include "common/povray/places.hpp"

#include "common/povray/placement.hpp"
#include "common/povray/refuse.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace rt::povray {
namespace {

/// Frame to the object's own space; texts of functions in the frame.
struct Formulas {
    Mat4 frame{1};
    std::string u, v;
    std::array<std::string, 3> out{};  ///< along the normal outwards, any length but 0; empty if not told
};

/// Beyond this much, in heights of the cone, from an end it is the side.
constexpr std::string_view end = "1e-7";

constexpr std::string_view turn = "atan2(z, x) / (2 * pi) + (z < 0)";

Mat4 frame_of(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    return {Vec4(x, 0), Vec4(y, 0), Vec4(z, 0), Vec4(origin, 1)};
}

/// The axes of a picture on a plane: chapters/11_textures/texture_coordinates.hpp.
struct Axes {
    Vec3 u, n, v;
};

Axes axes_of(const Vec3& normal) {
    const Vec3 n = unit_along(normal);
    const Vec3 u = unit_along(Vec3(n.z + n.y * n.y, -n.x * n.y, -n.x));
    return {u, n, glm::cross(n, u)};
}

std::optional<Formulas> formulas_of(const Scene&, const Sphere& sphere, Real) {
    const Real r = sphere.radius;
    return Formulas{frame_of(Vec3(r, 0, 0), Vec3(0, r, 0), Vec3(0, 0, r), sphere.center),
                    std::string(turn),
                    "0.5 + asin(min(max(y, -1), 1)) / pi",
                    {"x", "y", "z"}};
}

std::optional<Formulas> formulas_of(const Scene&, const Plane& plane, Real unit) {
    const auto [u, n, v] = axes_of(plane.normal);
    return Formulas{frame_of(unit * u, unit * n, unit * v, plane.point), "x", "z", {"0", "1", "0"}};
}

std::optional<Formulas> formulas_of(const Scene&, const Disc& disc, Real) {
    const auto [u, n, v] = axes_of(disc.normal);
    const Real r = disc.radius;
    return Formulas{
        frame_of(r * u, r * n, r * v, disc.center), "0.5 + 0.5 * x", "0.5 + 0.5 * z", {"0", "1", "0"}};
}

std::optional<Formulas> formulas_of(const Scene& scene, const TriangleObject& triangle, Real) {
    const auto at = [&](std::size_t i) {
        const std::uint32_t k = triangle.vertex[i];
        return triangle.smooth ? scene.smooth_vertices[k].position : scene.vertices[k];
    };
    const Vec3 b = at(1) - at(0), c = at(2) - at(0), n = glm::cross(b, c);
    Formulas formulas{frame_of(b, n, c, at(0)), "x", "z", {"0", "1", "0"}};
    if (triangle.smooth) formulas.out = {};
    return formulas;
}

/// The first corner is the origin; a picture has no place where it is straight, and is refused there.
std::optional<Formulas> formulas_of(const Scene& scene, const PolygonObject& polygon, Real) {
    const Vec3 first = scene.vertices[polygon.vertex.front()];
    const Vec3 b = scene.vertices[polygon.vertex[1]] - first,
               c = scene.vertices[polygon.vertex.back()] - first, n = glm::cross(b, c);
    if (!(glm::length(n) > 0)) return Formulas{Mat4(1), "0", "0"};
    return Formulas{frame_of(b, n, c, first), "x", "z"};
}

/// Longitude and latitude as seen from the origin.
Formulas from_origin(Real unit) {
    return {frame_of(Vec3(unit, 0, 0), Vec3(0, unit, 0), Vec3(0, 0, unit), Vec3(0)), std::string(turn),
            "0.5 + atan2(y, sqrt(x * x + z * z)) / pi"};
}
std::optional<Formulas> formulas_of(const Scene&, const Implicit&, Real unit) { return from_origin(unit); }
std::optional<Formulas> formulas_of(const Scene&, const Quadric&, Real unit) { return from_origin(unit); }

/// Each face has the whole picture.
std::optional<Formulas> formulas_of(const Scene&, const Box& box, Real) {
    const Vec3 half = (box.high - box.low) / Real(2);
    const auto of_face = [](std::string_view x, std::string_view y, std::string_view z) {
        return fmt::format("select(abs(x) - max(abs(y), abs(z)), select(abs(y) - abs(z), {2}, {1}), {0})", x,
                           y, z);
    };
    return Formulas{
        frame_of(Vec3(half.x, 0, 0), Vec3(0, half.y, 0), Vec3(0, 0, half.z), (box.low + box.high) / Real(2)),
        "0.5 + 0.5 * " + of_face("z * (1 - 2 * (x > 0))", "x", "x * (2 * (z > 0) - 1)"),
        "0.5 + 0.5 * " + of_face("y", "z * (1 - 2 * (y > 0))", "y"),
        {of_face("x", "0", "0"), of_face("0", "y", "0"), of_face("0", "0", "z")}};
}

/// `side` where the point is on the side, else what is at the ends a and b.
std::string on_cone(std::string_view at_a, std::string_view side, std::string_view at_b) {
    return fmt::format("select(y - {0}, {1}, select(y - 1 + {0}, {2}, {3}))", end, at_a, side, at_b);
}

Formulas side_of(const Cone& cone) {
    const auto [u, n, v] = axes_of(cone.b - cone.a);
    const Real rise = cone.radius_b - cone.radius_a;
    return {
        frame_of(u, cone.b - cone.a, -v, cone.a),
        std::string(turn),
        "min(max(y, 0), 1)",
        {"x", fmt::format("-({}) * ({} + {} * y)", number(rise), number(cone.radius_a), number(rise)), "z"}};
}

std::optional<Formulas> formulas_of(const Scene&, const OpenCone& open, Real) { return side_of(open.cone); }

std::optional<Formulas> formulas_of(const Scene&, const Cone& cone, Real) {
    Formulas formulas = side_of(cone);
    const Vec3 x(formulas.frame[0]), z(formulas.frame[2]);
    // A coordinate of the disc at an end, along `axis`.
    const auto across = [&](const Vec3& axis, Real radius) {
        if (radius == 0) return std::string("0.5");
        return fmt::format("0.5 + ({} * x + {} * z) / {}", number(glm::dot(axis, x)),
                           number(glm::dot(axis, z)), number(2 * radius));
    };
    const Axes a = axes_of(cone.a - cone.b), b = axes_of(cone.b - cone.a);
    formulas.u = on_cone(across(a.u, cone.radius_a), formulas.u, across(b.u, cone.radius_b));
    formulas.v = on_cone(across(a.v, cone.radius_a), formulas.v, across(b.v, cone.radius_b));
    formulas.out = {on_cone("0", "x", "0"), on_cone("-1", formulas.out[1], "1"), on_cone("0", "z", "0")};
    return formulas;
}

std::optional<Formulas> formulas_of(const Scene&, const Torus& torus, Real) {
    const auto [u, n, v] = axes_of(torus.axis);
    const std::string ring = number(torus.ring),
                      from_ring = fmt::format("(1 - {} / sqrt(x * x + z * z))", ring);
    return Formulas{frame_of(u, n, -v, torus.center),
                    "0.5 - atan2(z, x) / (2 * pi)",
                    fmt::format("0.5 + atan2(y, sqrt(x * x + z * z) - {}) / (2 * pi)", ring),
                    {"x * " + from_ring, "y", "z * " + from_ring}};
}

template <class Shape>
std::optional<Formulas> formulas_of(const Scene&, const Shape&, Real) {
    return std::nullopt;
}

std::optional<Formulas> formulas_of(const Writer& out, const Object& object) {
    return std::visit([&](const auto& shape) { return formulas_of(out.scene, shape, out.factor); },
                      object.shape);
}

/// The world's directions to the frame's coordinates.
Mat4 to_frame(const Scene& scene, const Object& object, const Formulas& formulas) {
    return glm::inverse(matrix_of(scene, object.transform) * formulas.frame);
}

/// Declares the frame's coordinates, once for an object, which may have a picture and bumps.
void write_own(Writer& out, const Mat4& m, std::size_t id) {
    if (std::ranges::find(out.frames, id) != out.frames.end()) return;
    out.frames.push_back(id);
    for (int row = 0; row < 3; ++row)
        out.line("#declare Own{}{} = function {{ {} * x + {} * y + {} * z + {} }}", "XYZ"[row], id,
                 number(m[0][row]), number(m[1][row]), number(m[2][row]), number(m[3][row]));
}

/// Declares a function of the frame's coordinates, and the same of the world's.
void write_in_frame(Writer& out, const std::string& name, const std::string& formula, std::size_t id) {
    out.line("#declare {}Own{} = function(x, y, z) {{ {} }}", name, id, formula);
    out.line(
        "#declare {0}{1} = function(x, y, z) {{ {0}Own{1}(OwnX{1}(x, y, z), OwnY{1}(x, y, z), OwnZ{1}(x, y, "
        "z)) }}",
        name, id);
}

}  // namespace

Coordinates write_coordinates(Writer& out, const Object& object, std::size_t id) {
    if (std::holds_alternative<MeshObject>(object.shape)) return {true, "x", "y"};
    const std::optional<Formulas> formulas = formulas_of(out, object);
    if (!formulas) refuse(out.scene, object, "a picture on a shape whose coordinates no function tells");
    write_own(out, to_frame(out.scene, object, *formulas), id);
    write_in_frame(out, "U", formulas->u, id);
    write_in_frame(out, "V", formulas->v, id);
    return {false, fmt::format("U{}(x, y, z)", id), fmt::format("V{}(x, y, z)", id)};
}

bool write_outward(Writer& out, const Object& object, std::size_t id) {
    const std::optional<Formulas> formulas = formulas_of(out, object);
    if (!formulas || formulas->out[0].empty()) return false;
    const Mat4 m = to_frame(out.scene, object, *formulas);
    write_own(out, m, id);
    for (std::size_t i = 0; i < 3; ++i)
        write_in_frame(out, fmt::format("Along{}", "XYZ"[i]), formulas->out[i], id);
    // Normals go by the transposed inverse.
    for (int i = 0; i < 3; ++i)
        out.line(
            "#declare Across{0}{1} = function(x, y, z) {{ {2} * AlongX{1}(x, y, z) + {3} * AlongY{1}(x, y, "
            "z) + {4} * AlongZ{1}(x, y, z) }}",
            "XYZ"[i], id, number(m[i][0]), number(m[i][1]), number(m[i][2]));
    out.line(
        "#declare OutLength{0} = function(x, y, z) {{ sqrt(pow(AcrossX{0}(x, y, z), 2) + pow(AcrossY{0}(x, "
        "y, z), 2) + pow(AcrossZ{0}(x, y, z), 2)) }}",
        id);
    for (int i = 0; i < 3; ++i)
        out.line("#declare Out{0}{1} = function(x, y, z) {{ Across{0}{1}(x, y, z) / OutLength{1}(x, y, z) }}",
                 "XYZ"[i], id);
    return true;
}

}  // namespace rt::povray
