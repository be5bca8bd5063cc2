// One section a shape: its statement, its texture coordinates, its box and its scaling; and where it is not
// as most shapes are, lengths, places and inside. To add a shape, add a section.
#include "common/povray/shapes.hpp"

#include "common/povray/formula.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/refuse.hpp"
#include "common/povray/writer.hpp"
#include "common/scene/closed_mesh.hpp"
#include "common/scene/evaluate.hpp"
#include "common/scene/range.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <type_traits>

namespace rt::povray {
namespace {

/// Adds a point of a shape's own space.
void extend(Extent& box, const Mat4& m, const Vec3& p) {
    const Vec3 here(m * Vec4(p, 1));
    box = {glm::min(box.low, here), glm::max(box.high, here)};
}

bool overlap(const Extent& a, const Extent& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

/// The statement of a shape whose texture coordinates are 0 everywhere.
std::string without_uv(const std::string& statement, const std::string& transform) {
    return statement + transform + " texture { NoUv } }";
}

/// The numbers of a matrix, as POV-Ray orders them.
std::string rows(const std::array<Vec3, 4>& columns) {
    std::string text;
    for (const Vec3& column : columns)
        for (int i = 0; i < 3; ++i) text += (text.empty() ? "" : ", ") + number(column[i]);
    return text;
}

// Sphere ----------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Sphere& sphere) {
    return fmt::format("sphere {{ {}, {}", triple(sphere.center), number(sphere.radius));
}

/// Texture coordinates belong to the object, so they move with it.
std::string with_uv(const Scene& scene, const Sphere& sphere, const std::string& transform) {
    return fmt::format("{} texture {{ SphereUv scale {} translate {} }}{} }}", open_statement(scene, sphere),
                       number(sphere.radius), triple(sphere.center), transform);
}

Extent extent_of(const Scene&, const Sphere& sphere, const Mat4& m) {
    const Vec3 center(m * Vec4(sphere.center, 1));
    const Mat3 rows = glm::transpose(Mat3(m));
    const Vec3 half = sphere.radius * Vec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    return {center - half, center + half};
}

/// An ellipsoid's shortest axis at least: a ball of radius r, r times the smallest stretch of a direction.
Real least_length_of(const Scene&, const Sphere& sphere, const Mat4& m) {
    const Mat3 back = glm::inverse(Mat3(m));
    Real squares = 0;
    for (int i = 0; i < 3; ++i) squares += glm::dot(back[i], back[i]);
    return sphere.radius / std::sqrt(squares / 3);
}

Real own_size(const Scene&, const Sphere& sphere) { return sphere.radius; }

void scale(Scene&, Sphere& sphere, Real factor) { sphere.center *= factor, sphere.radius *= factor; }

bool contains(const Scene&, const Sphere& sphere, const Vec3& p) {
    return glm::length(p - sphere.center) < sphere.radius;
}

// Plane -----------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Plane& plane) {
    const Vec3 n = unit_along(plane.normal);
    return fmt::format("plane {{ {}, {}", triple(n), number(glm::dot(n, plane.point)));
}

std::string with_uv(const Scene& scene, const Plane& plane, const std::string& transform) {
    return without_uv(open_statement(scene, plane), transform);
}

Extent extent_of(const Scene&, const Plane&, const Mat4&) { return {Vec3(-infinity), Vec3(infinity)}; }

Real least_length_of(const Scene&, const Plane&, const Mat4&) { return 0; }

void scale(Scene&, Plane& plane, Real factor) { plane.point *= factor; }

bool contains(const Scene&, const Plane& plane, const Vec3& p) {
    return glm::dot(plane.normal, p - plane.point) < 0;
}

/// The plane after `m`, with a unit normal.
Plane moved(const Plane& plane, const Mat4& m) {
    const Mat3 directions(m);
    return {Vec3(m * Vec4(plane.point, 1)),
            unit_along(glm::transpose(glm::inverse(directions)) * unit_along(plane.normal))};
}

/// Straight, because there is no farthest point.
Real reach_of(const Scene& scene, const Plane& plane, const Mat4& m) {
    const Plane here = moved(plane, m);
    return std::abs(glm::dot(here.normal, scene.camera.eye - here.point));
}

/// Whether one of them is on the inner side.
bool may_reach(const Scene&, const Plane& plane, const Mat4& m, std::span<const Vec3> corners) {
    const Plane here = moved(plane, m);
    return std::ranges::any_of(corners, [&](const Vec3& corner) {
        Real height = 0;
        for (int i = 0; i < 3; ++i)
            if (here.normal[i] != 0)  // corners may be infinitely far away
                height += here.normal[i] * (corner[i] - here.point[i]);
        return height <= 0;
    });
}

// Triangle --------------------------------------------------------------------------------------------------

/// Only meshes have texture coordinates in POV-Ray, so for those a triangle becomes a mesh of one.
std::string open_statement(const Scene& scene, const TriangleObject& triangle) {
    const bool uv = row_of(scene.integrator).uvs;
    std::string text = fmt::format("{}{}triangle {{ ", uv ? "mesh { " : "", triangle.smooth ? "smooth_" : "");
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) text += ", ";
        if (triangle.smooth) {
            const SmoothVertex& v = scene.smooth_vertices[triangle.vertex[i]];
            text += triple(v.position) + ", " + triple(in_range(v.normal) ? v.normal : near_one(v.normal));
        } else {
            text += triple(scene.vertices[triangle.vertex[i]]);
        }
    }
    return uv ? text + " uv_vectors <0, 0>, <1, 0>, <0, 1> }" : text;
}

std::string with_uv(const Scene& scene, const TriangleObject& triangle, const std::string& transform) {
    return open_statement(scene, triangle) + transform + " texture { MeshUv } }";
}

Extent extent_of(const Scene& scene, const TriangleObject& triangle, const Mat4& m) {
    Extent box;
    for (const std::uint32_t i : triangle.vertex)
        extend(box, m, triangle.smooth ? scene.smooth_vertices[i].position : scene.vertices[i]);
    return box;
}

void scale_vertex(Scene& scene, std::uint32_t& index, Real factor) {
    scene.vertices.push_back(scene.vertices[index] * factor);
    index = static_cast<std::uint32_t>(scene.vertices.size()) - 1;
}

void scale_smooth_vertex(Scene& scene, std::uint32_t& index, Real factor) {
    const SmoothVertex v = scene.smooth_vertices[index];
    scene.smooth_vertices.push_back({v.position * factor, v.normal});
    index = static_cast<std::uint32_t>(scene.smooth_vertices.size()) - 1;
}

void scale(Scene& scene, TriangleObject& triangle, Real factor) {
    for (std::uint32_t& i : triangle.vertex)
        triangle.smooth ? scale_smooth_vertex(scene, i, factor) : scale_vertex(scene, i, factor);
}

// Polygon ---------------------------------------------------------------------------------------------------

std::string open_statement(const Scene& scene, const PolygonObject& polygon) {
    std::string text = fmt::format("polygon {{ {}", polygon.vertex.size() + 1);
    for (const std::uint32_t i : polygon.vertex) text += ", " + triple(scene.vertices[i]);
    return text + ", " + triple(scene.vertices[polygon.vertex.front()]);
}

std::string with_uv(const Scene& scene, const PolygonObject& polygon, const std::string& transform) {
    return without_uv(open_statement(scene, polygon), transform);
}

Extent extent_of(const Scene& scene, const PolygonObject& polygon, const Mat4& m) {
    Extent box;
    for (const std::uint32_t i : polygon.vertex) extend(box, m, scene.vertices[i]);
    return box;
}

void scale(Scene& scene, PolygonObject& polygon, Real factor) {
    for (std::uint32_t& i : polygon.vertex) scale_vertex(scene, i, factor);
}

// Mesh ------------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const MeshObject& shown) {
    return fmt::format("object {{ Mesh{}", shown.mesh);
}

std::string with_uv(const Scene& scene, const MeshObject& shown, const std::string& transform) {
    return open_statement(scene, shown) + transform + " texture { MeshUv } }";
}

Extent extent_of(const Scene& scene, const MeshObject& shown, const Mat4& m) {
    const Mesh& mesh = scene.meshes[shown.mesh];
    Extent box;
    for (const auto& face : mesh.triangles)
        for (const Mesh::Corner& corner : face)
            extend(box, m, mesh.positions[static_cast<std::size_t>(corner.position)]);
    return box;
}

Real own_size(const Scene&, const MeshObject&) { return 0; }

void scale(Scene&, MeshObject&, Real) {}

bool is_endless(const Scene& scene, const MeshObject& shown) { return !is_closed(scene.meshes[shown.mesh]); }

// Box -------------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Box& box) {
    return fmt::format("box {{ {}, {}", triple(box.low), triple(box.high));
}

std::string with_uv(const Scene& scene, const Box& box, const std::string& transform) {
    return without_uv(open_statement(scene, box), transform);
}

Extent extent_of(const Scene&, const Box& box, const Mat4& m) {
    Extent extent;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p = box.low;
        for (int axis = 0; axis < 3; ++axis)
            if (corner >> axis & 1) p[axis] = box.high[axis];
        extend(extent, m, p);
    }
    return extent;
}

/// Its shortest edge, unless `m` turns it.
Real least_length_of(const Scene&, const Box& box, const Mat4& m) {
    Real least = infinity;
    for (int axis = 0; axis < 3; ++axis)
        least = std::min(least, (box.high[axis] - box.low[axis]) * glm::length(Vec3(m[axis])));
    return least;
}

void scale(Scene&, Box& box, Real factor) { box.low *= factor, box.high *= factor; }

bool contains(const Scene&, const Box& box, const Vec3& p) {
    return glm::all(glm::lessThan(box.low, p)) && glm::all(glm::lessThan(p, box.high));
}

// Disc ------------------------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Disc& disc) {
    return fmt::format("disc {{ {}, {}, {}", triple(disc.center), triple(unit_along(disc.normal)),
                       number(disc.radius));
}

std::string with_uv(const Scene& scene, const Disc& disc, const std::string& transform) {
    return without_uv(open_statement(scene, disc), transform);
}

/// A box around the ball that the disc cuts in halves.
Extent extent_of(const Scene& scene, const Disc& disc, const Mat4& m) {
    return extent_of(scene, Sphere{disc.center, disc.radius}, m);
}

void scale(Scene&, Disc& disc, Real factor) { disc.center *= factor, disc.radius *= factor; }

// Cone and cylinder -----------------------------------------------------------------------------------------

std::string open_statement(const Scene&, const Cone& cone) {
    if (cone.radius_a == cone.radius_b)
        return fmt::format("cylinder {{ {}, {}, {}", triple(cone.a), triple(cone.b), number(cone.radius_a));
    return fmt::format("cone {{ {}, {}, {}, {}", triple(cone.a), number(cone.radius_a), triple(cone.b),
                       number(cone.radius_b));
}

std::string with_uv(const Scene& scene, const Cone& cone, const std::string& transform) {
    return without_uv(open_statement(scene, cone), transform);
}

/// A box around balls around the ends.
Extent extent_of(const Scene& scene, const Cone& cone, const Mat4& m) {
    const Extent a = extent_of(scene, Sphere{cone.a, cone.radius_a}, m),
                 b = extent_of(scene, Sphere{cone.b, cone.radius_b}, m);
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

/// The shorter of axis and greatest width.
Real least_length_of(const Scene& scene, const Cone& cone, const Mat4& m) {
    return std::min(glm::length(Mat3(m) * (cone.b - cone.a)),
                    2 * least_length_of(scene, Sphere{cone.a, std::max(cone.radius_a, cone.radius_b)}, m));
}

void scale(Scene&, Cone& cone, Real factor) {
    cone.a *= factor, cone.radius_a *= factor, cone.b *= factor, cone.radius_b *= factor;
}

bool contains(const Scene&, const Cone& cone, const Vec3& p) {
    const Vec3 u = cone.b - cone.a, f = p - cone.a;
    const Real s = glm::dot(f, u) / glm::dot(u, u);
    return 0 < s && s < 1 && glm::length(f - s * u) < cone.radius_a + s * (cone.radius_b - cone.radius_a);
}

// Open cone and cylinder ------------------------------------------------------------------------------------

std::string open_statement(const Scene& scene, const OpenCone& open) {
    return open_statement(scene, open.cone) + " open";
}

std::string with_uv(const Scene& scene, const OpenCone& open, const std::string& transform) {
    return without_uv(open_statement(scene, open), transform);
}

Extent extent_of(const Scene& scene, const OpenCone& open, const Mat4& m) {
    return extent_of(scene, open.cone, m);
}

Real least_length_of(const Scene& scene, const OpenCone& open, const Mat4& m) {
    return least_length_of(scene, open.cone, m);
}

void scale(Scene& scene, OpenCone& open, Real factor) { scale(scene, open.cone, factor); }

// Torus -----------------------------------------------------------------------------------------------------

/// POV-Ray's lies around the y axis; without `sturm` its roots are those of a closed formula. The lemon
/// inside a spindle is a surface for it; what is merged with a ball around the lemon has none.
std::string open_statement(const Scene&, const Torus& torus) {
    const Real R = torus.ring, r = torus.tube;
    std::string text = fmt::format("torus {{ {}, {} sturm", number(R), number(r));
    if (r > R)
        text = fmt::format("merge {{ {} }} sphere {{ 0, {} }}", text, number(std::sqrt((r - R) * (r + R))));
    if (torus.axis.x != 0 || torus.axis.z != 0) {
        const Vec3 y = unit_along(torus.axis);
        const Vec3 x =
            unit_along(glm::cross(y, std::abs(y.x) < std::abs(y.z) ? Vec3(1, 0, 0) : Vec3(0, 0, 1)));
        text += fmt::format(" matrix <{}>", rows({x, y, glm::cross(x, y), Vec3(0)}));
    }
    return text + " translate " + triple(torus.center);
}

std::string with_uv(const Scene& scene, const Torus& torus, const std::string& transform) {
    return without_uv(open_statement(scene, torus), transform);
}

/// A box around the ball around it.
Extent extent_of(const Scene& scene, const Torus& torus, const Mat4& m) {
    return extent_of(scene, Sphere{torus.center, torus.ring + torus.tube}, m);
}

/// The width of the tube.
Real least_length_of(const Scene& scene, const Torus& torus, const Mat4& m) {
    return 2 * least_length_of(scene, Sphere{torus.center, torus.tube}, m);
}

void scale(Scene&, Torus& torus, Real factor) {
    torus.center *= factor, torus.ring *= factor, torus.tube *= factor;
}

bool contains(const Scene&, const Torus& torus, const Vec3& p) {
    const Vec3 n = unit_along(torus.axis), f = p - torus.center;
    return std::hypot(glm::length(glm::cross(f, n)) - torus.ring, glm::dot(f, n)) < torus.tube;
}

// Implicit surface ------------------------------------------------------------------------------------------

/// POV-Ray looks for roots only where the function, changing by no more than max_gradient, may have one, and
/// takes longer the greater that is. So it gets as little of the box as has an inside.
struct Searched {
    Box box;
    Real gradient = 0;  ///< no greater one is there
};

Searched searched(const Scene& scene, const Implicit& implicit) {
    const auto& [box, f] = implicit;
    const PartOfBox inner = not_positive(*f, box.low, box.high);
    const Box part = inner.low.x < inner.high.x ? Box{inner.low, inner.high} : box;
    const Real gradient = lipschitz_bound(*f, part.low, part.high);
    if (!(gradient > 0 && gradient < infinity))
        refuse(scene,
               "its isosurfaces need a bound of the function's gradient, and one of an implicit surface has "
               "none");
    return {part, gradient};
}

std::string isosurface(const Implicit& implicit, const Searched& part) {
    return fmt::format(
        "isosurface {{ function {{ {} }} contained_by {{ box {{ {}, {} }} }} accuracy {:.3g} "
        "max_gradient {:.6g}",
        function_of(*implicit.f), triple(part.box.low), triple(part.box.high),
        1e-7 * size_of(part.box.high - part.box.low), part.gradient);
}

std::string polynomial(const PolynomialTerms& terms) {
    std::vector<std::string> texts;
    for (const auto& [e, coefficient] : terms)
        texts.push_back(fmt::format("xyz({}, {}, {}): {}", e[0], e[1], e[2], number(coefficient)));
    return fmt::format("polynomial {{ {}, {} sturm", degree_of(terms), fmt::join(texts, ", "));
}

/// POV-Ray's isosurface takes minutes where f is flat near 0 and steep elsewhere: from a tenth of the points
/// in the box, a step of |f| over the greatest gradient is then less than this part of it. A polynomial is
/// solved instead, which is fast, but not as good.
constexpr Real shortest_step = 1 / 2e4;

std::string open_statement(const Scene& scene, const Implicit& implicit) {
    const Searched part = searched(scene, implicit);
    if (small_value(*implicit.f, part.box.low, part.box.high) <
        shortest_step * part.gradient * size_of(part.box.high - part.box.low))
        if (const auto terms = terms_of(*implicit.f))
            return fmt::format("{} clipped_by {{ box {{ {}, {} }} }}", polynomial(*terms),
                               triple(implicit.box.low), triple(implicit.box.high));
    return isosurface(implicit, part) + " open";
}

std::string with_uv(const Scene& scene, const Implicit& implicit, const std::string& transform) {
    return without_uv(open_statement(scene, implicit), transform);
}

Extent extent_of(const Scene& scene, const Implicit& implicit, const Mat4& m) {
    return extent_of(scene, implicit.box, m);
}

void scale(Scene& scene, Implicit& implicit, Real factor) {
    scale(scene, implicit.box, factor);
    implicit.f = std::make_shared<const Formula>(in_other_unit(*implicit.f, factor));
}

bool contains(const Scene& scene, const Implicit& implicit, const Vec3& p) {
    return contains(scene, implicit.box, p) && value_at(*implicit.f, p) < 0;
}

// Quadric ---------------------------------------------------------------------------------------------------

std::string unclipped(const Quadric& q) {
    return fmt::format("quadric {{ {}, {}, {}, {}", triple(q.squares), triple(q.mixed), triple(q.linear),
                       number(q.constant));
}

std::string open_statement(const Scene&, const Quadric& q) {
    return fmt::format("{} clipped_by {{ box {{ {}, {} }} }}", unclipped(q), triple(q.box.low),
                       triple(q.box.high));
}

std::string with_uv(const Scene& scene, const Quadric& quadric, const std::string& transform) {
    return without_uv(open_statement(scene, quadric), transform);
}

Extent extent_of(const Scene& scene, const Quadric& quadric, const Mat4& m) {
    return extent_of(scene, quadric.box, m);
}

void scale(Scene& scene, Quadric& quadric, Real factor) {
    scale(scene, quadric.box, factor);
    quadric.squares /= factor * factor, quadric.mixed /= factor * factor, quadric.linear /= factor;
}

/// Its inside ends at the box, too.
bool contains(const Scene& scene, const Quadric& q, const Vec3& p) {
    return contains(scene, q.box, p) && glm::dot(q.squares, p * p) +
                                                glm::dot(q.mixed, Vec3(p.x * p.y, p.x * p.z, p.y * p.z)) +
                                                glm::dot(q.linear, p) + q.constant <
                                            0;
}

// Combination -----------------------------------------------------------------------------------------------

/// A `union` of POV-Ray keeps the walls inside, which glass would show.
std::string_view word_of(SetOperation operation) {
    switch (operation) {
        case SetOperation::Union:
            return "merge";
        case SetOperation::Intersection:
            return "intersection";
        case SetOperation::Difference:
            return "difference";
    }
    return "";
}

const Object& part_of(const Scene& scene, std::uint32_t part) { return scene.parts[part]; }

/// Where a solid is part of another, a surface that ends at a box is closed by it.
std::string closed_statement(const Scene& scene, const Object& part) {
    if (const auto* implicit = std::get_if<Implicit>(&part.shape))
        return isosurface(*implicit, searched(scene, *implicit));
    if (const auto* q = std::get_if<Quadric>(&part.shape))
        return fmt::format("intersection {{ {} }} box {{ {}, {} }}", unclipped(*q), triple(q->box.low),
                           triple(q->box.high));
    return povray::open_statement(scene, part);
}

std::string open_statement(const Scene& scene, const CombinationObject& whole) {
    return open_statement_by_parts(scene, whole, {});
}

std::string with_uv(const Scene& scene, const CombinationObject& whole, const std::string& transform) {
    return without_uv(open_statement(scene, whole), transform);
}

Extent extent_of(const Scene& scene, const CombinationObject& whole, const Mat4& m) {
    const auto of = [&](std::uint32_t part) {
        const Object& object = part_of(scene, part);
        return povray::extent_of(scene, object, m * matrix_of(scene, object.transform));
    };
    Extent box = of(whole.parts.front());
    if (whole.operation == SetOperation::Difference) return box;
    for (const std::uint32_t part : whole.parts) {
        const Extent other = of(part);
        if (whole.operation == SetOperation::Union)
            box = {glm::min(box.low, other.low), glm::max(box.high, other.high)};
        else
            box = {glm::max(box.low, other.low), glm::min(box.high, other.high)};
    }
    return box;
}

/// That of its smallest part.
Real least_length_of(const Scene& scene, const CombinationObject& whole, const Mat4& m) {
    Real least = infinity;
    for (const std::uint32_t part : whole.parts) {
        const Object& object = part_of(scene, part);
        const Real own = povray::least_length_of(scene, object, m * matrix_of(scene, object.transform));
        if (own > 0) least = std::min(least, own);
    }
    return least == infinity ? 0 : least;
}

Real own_size(const Scene&, const CombinationObject&) { return 0; }

void scale(Scene&, CombinationObject&, Real) {}

bool contains(const Scene& scene, const CombinationObject& whole, const Vec3& p) {
    const auto in = [&](std::uint32_t part) { return surrounds(scene, part_of(scene, part), p); };
    switch (whole.operation) {
        case SetOperation::Union:
            return std::ranges::any_of(whole.parts, in);
        case SetOperation::Intersection:
            return std::ranges::all_of(whole.parts, in);
        case SetOperation::Difference:
            return in(whole.parts.front()) && std::none_of(whole.parts.begin() + 1, whole.parts.end(), in);
    }
    return false;
}

// What holds of most shapes ---------------------------------------------------------------------------------

template <class Shape>
Real least_length_of(const Scene& scene, const Shape& shape, const Mat4& m) {
    const Extent box = extent_of(scene, shape, m);
    return glm::length(box.high - box.low);
}

template <class Shape>
Real reach_of(const Scene& scene, const Shape& shape, const Mat4& m) {
    const Vec3& eye = scene.camera.eye;
    const Extent box = extent_of(scene, shape, m);
    return glm::length(glm::max(glm::abs(box.low - eye), glm::abs(box.high - eye)));
}

template <class Shape>
bool may_reach(const Scene& scene, const Shape& shape, const Mat4& m, std::span<const Vec3> corners) {
    Extent around;
    for (const Vec3& corner : corners) around = {glm::min(around.low, corner), glm::max(around.high, corner)};
    return overlap(extent_of(scene, shape, m), around);
}

template <class Shape>
Real own_size(const Scene& scene, const Shape& shape) {
    return least_length_of(scene, shape, Mat4(1));
}

template <class Shape>
bool contains(const Scene&, const Shape&, const Vec3&) {
    return false;
}

template <class Shape>
bool is_endless(const Scene& scene, const Shape& shape) {
    const Extent box = extent_of(scene, shape, Mat4(1));
    return max_component(box.high - box.low) == infinity;
}

/// Whether the shape has a section.
template <class Shape>
constexpr bool has_section() {
    constexpr bool is_whole = requires(Scene & scene, Shape & shape, const Mat4& m) {
        open_statement(scene, shape);
        with_uv(scene, shape, std::string());
        extent_of(scene, shape, m);
        scale(scene, shape, Real(2));
    };
    static_assert(is_whole,
                  "this shape's section in common/povray/shapes.cpp is missing, or lacks one of "
                  "open_statement, with_uv, extent_of and scale");
    return is_whole;
}

/// What `ask` says of the object's shape.
template <class Answer, class SomeObject, class Ask>
Answer of_shape(SomeObject& object, const Ask& ask) {
    return std::visit(
        [&]<class Shape>(Shape& shape) {
            if constexpr (has_section<std::remove_const_t<Shape>>())
                return ask(shape);
            else
                return Answer();
        },
        object.shape);
}

}  // namespace

std::string open_statement_by_parts(const Scene& scene, const CombinationObject& whole,
                                    const std::function<std::string(std::uint32_t part)>& texture) {
    std::string text = fmt::format("{} {{", word_of(whole.operation));
    for (const std::uint32_t i : whole.parts) {
        const Object& part = part_of(scene, i);
        const auto* inner = std::get_if<CombinationObject>(&part.shape);
        text += " " + (inner ? open_statement_by_parts(scene, *inner, texture)
                             : closed_statement(scene, part) + transform_of(scene, part));
        if (!inner && texture) text += " texture { " + texture(i) + " }";
        text += " }";
    }
    return text;
}

std::vector<std::uint32_t> leaves_of(const Scene& scene, const CombinationObject& whole) {
    std::vector<std::uint32_t> leaves;
    for (const std::uint32_t i : whole.parts) {
        const auto* inner = std::get_if<CombinationObject>(&part_of(scene, i).shape);
        const std::vector<std::uint32_t> some = inner ? leaves_of(scene, *inner) : std::vector{i};
        leaves.insert(leaves.end(), some.begin(), some.end());
    }
    return leaves;
}

// Any of them -----------------------------------------------------------------------------------------------

std::string open_statement(const Scene& scene, const Object& object) {
    return of_shape<std::string>(object, [&](const auto& s) { return open_statement(scene, s); });
}

std::string with_uv(const Scene& scene, const Object& object, const std::string& transform) {
    return of_shape<std::string>(object, [&](const auto& s) { return with_uv(scene, s, transform); });
}

Extent extent_of(const Scene& scene, const Object& object, const Mat4& m) {
    return of_shape<Extent>(object, [&](const auto& s) { return extent_of(scene, s, m); });
}

Real least_length_of(const Scene& scene, const Object& object, const Mat4& m) {
    return of_shape<Real>(object, [&](const auto& s) { return least_length_of(scene, s, m); });
}

Real reach_of(const Scene& scene, const Object& object, const Mat4& m) {
    return of_shape<Real>(object, [&](const auto& s) { return reach_of(scene, s, m); });
}

bool may_reach(const Scene& scene, const Object& object, const Mat4& m, std::span<const Vec3> corners) {
    return of_shape<bool>(object, [&](const auto& s) { return may_reach(scene, s, m, corners); });
}

Real own_size(const Scene& scene, const Object& object) {
    return of_shape<Real>(object, [&](const auto& s) { return own_size(scene, s); });
}

void scale(Scene& scene, Object& object, Real factor) {
    of_shape<void>(object, [&](auto& s) { scale(scene, s, factor); });
}

bool contains(const Scene& scene, const Object& object, const Vec3& p) {
    return of_shape<bool>(object, [&](const auto& s) { return contains(scene, s, p); });
}

bool is_endless(const Scene& scene, const Object& object) {
    return of_shape<bool>(object, [&](const auto& s) { return is_endless(scene, s); });
}

}  // namespace rt::povray
