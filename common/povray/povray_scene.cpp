// What POV-Ray's tolerances and its way with interiors make of a scene.
#include "common/povray/povray_scene.hpp"

#include "common/math/input_error.hpp"
#include "common/scene/range.hpp"

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace rt {
namespace {

/// Between these lengths its pictures agree with ours: a shadow ray overlooks what is nearer than 0.001, and
/// nothing is seen that is farther than 1e7.
constexpr Real least_length = 0.01;
constexpr Real greatest_length = 1e4;
/// Lights have no size, and may be farther away.
constexpr Real greatest_light_distance = 1e6;

bool is_black(const Vec3& c) { return c == Vec3(0); }
bool is_grey(const Vec3& c) { return c.x == c.y && c.y == c.z; }

bool bounces(const Scene& scene) { return scene.integrator == Integrator::Raytrace && scene.max_depth > 0; }

const Material& material_of(const Scene& scene, const Object& object) {
    return scene.materials[object.material];
}

/// Calls visit(p) for the points that span a finite object, in its own space.
template <class Visit>
void visit_points(const Scene& scene, const Object& object, Visit visit) {
    if (const auto* triangle = std::get_if<TriangleObject>(&object.shape)) {
        for (const std::uint32_t i : triangle->vertex)
            visit(triangle->smooth ? scene.smooth_vertices[i].position : scene.vertices[i]);
    } else if (const auto* polygon = std::get_if<PolygonObject>(&object.shape)) {
        for (const std::uint32_t i : polygon->vertex) visit(scene.vertices[i]);
    } else if (const auto* shown = std::get_if<MeshObject>(&object.shape)) {
        const Mesh& mesh = scene.meshes[shown->mesh];
        for (const auto& face : mesh.triangles)
            for (const Mesh::Corner& corner : face)
                visit(mesh.positions[static_cast<std::size_t>(corner.position)]);
    }
}

/// A plane in world space.
Plane moved(const Plane& plane, const Mat4& m) {
    const Mat3 directions(m);
    return {Vec3(m * Vec4(plane.point, 1)),
            unit_along(glm::transpose(glm::inverse(directions)) * unit_along(plane.normal))};
}

/// The least and greatest of the lengths that POV-Ray must tell from nothing and from infinity.
struct Lengths {
    Real least = infinity;
    Real greatest = 0;
    Real lights = 0;  ///< the greatest distance of a point light
};

/// An ellipsoid's shortest axis at least: a ball of radius r, r times the smallest stretch of a direction.
Real least_axis(const Sphere& sphere, const Mat4& m) {
    const Mat3 back = glm::inverse(Mat3(m));
    Real squares = 0;
    for (int i = 0; i < 3; ++i) squares += glm::dot(back[i], back[i]);
    return sphere.radius / std::sqrt(squares / 3);
}

Lengths lengths_of(const Scene& scene) {
    Lengths lengths;
    const Vec3& eye = scene.camera.eye;
    const auto reach = [&](Real length) { lengths.greatest = std::max(lengths.greatest, length); };
    for (const Object& object : scene.objects) {
        const Mat4 m = matrix_of(scene, object.transform);
        if (const auto* plane = std::get_if<Plane>(&object.shape)) {
            const Plane here = moved(*plane, m);
            reach(std::abs(glm::dot(here.normal, eye - here.point)));
            continue;
        }
        const Box box = box_of(scene, object);
        reach(glm::length(glm::max(glm::abs(box.low - eye), glm::abs(box.high - eye))));
        const auto* sphere = std::get_if<Sphere>(&object.shape);
        const Real size = sphere ? least_axis(*sphere, m) : glm::length(box.high - box.low);
        if (size > 0) lengths.least = std::min(lengths.least, size);
    }
    if (scene.integrator == Integrator::Raytrace)
        for (const Light& light : scene.lights)
            if (const auto* point = std::get_if<PointLight>(&light))
                lengths.lights = std::max(lengths.lights, glm::length(point->position - eye));
    return lengths;
}

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

/// Whether two bodies may have a part in common.
bool may_overlap(const Scene& scene, const Object& a, const Object& b) {
    const auto* plane_a = std::get_if<Plane>(&a.shape);
    const auto* plane_b = std::get_if<Plane>(&b.shape);
    if (plane_a && plane_b) return true;
    if (plane_b) return may_overlap(scene, b, a);
    const Box box = box_of(scene, b);
    if (plane_a) {
        const Plane here = moved(*plane_a, matrix_of(scene, a.transform));
        // The box's lowest corner along the normal.
        Real height = 0;
        for (int i = 0; i < 3; ++i)
            height += here.normal[i] * ((here.normal[i] > 0 ? box.low : box.high)[i] - here.point[i]);
        return height <= 0;
    }
    const auto* ball_a = std::get_if<Sphere>(&a.shape);
    const auto* ball_b = std::get_if<Sphere>(&b.shape);
    if (ball_a && ball_b && a.transform < 0 && b.transform < 0)
        return glm::length(ball_a->center - ball_b->center) <= ball_a->radius + ball_b->radius;
    return overlap(box, box_of(scene, a));
}

/// Whether one untransformed ball is all within another.
bool is_ball_within(const Object& inner, const Object& outer) {
    const auto* a = std::get_if<Sphere>(&inner.shape);
    const auto* b = std::get_if<Sphere>(&outer.shape);
    return a && b && inner.transform < 0 && outer.transform < 0 &&
           glm::length(a->center - b->center) + a->radius < b->radius;
}

/// Whether each edge belongs to an even number of faces.
bool is_closed(const Mesh& mesh) {
    std::map<std::tuple<Real, Real, Real>, std::size_t> places;
    const auto place = [&](const Mesh::Corner& corner) {
        const Vec3& p = mesh.positions[static_cast<std::size_t>(corner.position)];
        return places.try_emplace({p.x + 0, p.y + 0, p.z + 0}, places.size()).first->second;
    };
    std::map<std::pair<std::size_t, std::size_t>, bool> edges;  // whether the number is odd so far
    for (const auto& face : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t a = place(face[i]), b = place(face[(i + 1) % 3]);
            bool& odd = edges[{std::min(a, b), std::max(a, b)}];
            odd = !odd;
        }
    return std::ranges::none_of(edges, [](const auto& edge) { return edge.second; });
}

/// Multiplies all lengths of the scene.
void scale_world(Scene& scene, Real factor) {
    scene.camera.eye *= factor, scene.camera.look_at *= factor, scene.camera.view_height *= factor;
    for (Vec3& p : scene.vertices) p *= factor;
    for (SmoothVertex& v : scene.smooth_vertices) v.position *= factor;
    for (Mesh& mesh : scene.meshes)
        for (Vec3& p : mesh.positions) p *= factor;
    for (Material& m : scene.materials) m.checker.size *= factor, m.absorption /= factor;
    for (TransformNode& node : scene.transforms)
        if (auto* move = std::get_if<Translate>(&node.step)) move->by *= factor;
    for (Object& object : scene.objects) {
        if (auto* sphere = std::get_if<Sphere>(&object.shape))
            sphere->center *= factor, sphere->radius *= factor;
        if (auto* plane = std::get_if<Plane>(&object.shape)) plane->point *= factor;
    }
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) {
            point->position *= factor;
            point->attenuation.y /= factor, point->attenuation.z /= factor * factor;
        }
}

/// The power of two that brings a shape of this size near 1; 1 where it need not be.
Real factor_for(Real size) {
    if (size == 0 || (size >= least_length && size <= greatest_length)) return 1;
    return std::exp2(std::round(-std::log2(size)));
}

/// Undoes for an object what has been done to its shape.
void shrink(Scene& scene, Object& object, Real factor) {
    scene.transforms.push_back({object.transform, Scale{Vec3(1 / factor)}, object.place});
    object.transform = static_cast<int>(scene.transforms.size()) - 1;
}

/// Brings a mesh to a size near 1 in its own space, whatever its objects' transforms make of it.
void size_mesh(Scene& scene, std::size_t index) {
    Mesh& mesh = scene.meshes[index];
    Vec3 low(infinity), high(-infinity);
    for (const Vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const Real factor = mesh.positions.empty() ? 1 : factor_for(glm::length(high - low));
    if (factor == 1) return;
    for (Vec3& p : mesh.positions) p *= factor;
    for (Object& object : scene.objects)
        if (const auto* shown = std::get_if<MeshObject>(&object.shape); shown && shown->mesh == index)
            shrink(scene, object, factor);
}

/// The same for a transformed shape of its own numbers. Vertices may be shared, so it gets new ones.
void size_shape(Scene& scene, Object& object) {
    if (object.transform < 0 || std::holds_alternative<MeshObject>(object.shape) ||
        std::holds_alternative<Plane>(object.shape))
        return;
    auto* sphere = std::get_if<Sphere>(&object.shape);
    Vec3 low(infinity), high(-infinity);
    visit_points(scene, object, [&](const Vec3& p) { low = glm::min(low, p), high = glm::max(high, p); });
    const Real factor = factor_for(sphere ? sphere->radius : glm::length(high - low));
    if (factor == 1) return;
    const auto renew = [&](std::uint32_t& index) {
        scene.vertices.push_back(scene.vertices[index] * factor);
        index = static_cast<std::uint32_t>(scene.vertices.size()) - 1;
    };
    const auto renew_smooth = [&](std::uint32_t& index) {
        const SmoothVertex& v = scene.smooth_vertices[index];
        scene.smooth_vertices.push_back({v.position * factor, v.normal});
        index = static_cast<std::uint32_t>(scene.smooth_vertices.size()) - 1;
    };
    if (sphere) sphere->center *= factor, sphere->radius *= factor;
    if (auto* triangle = std::get_if<TriangleObject>(&object.shape))
        for (std::uint32_t& i : triangle->vertex) triangle->smooth ? renew_smooth(i) : renew(i);
    if (auto* polygon = std::get_if<PolygonObject>(&object.shape))
        for (std::uint32_t& i : polygon->vertex) renew(i);
    shrink(scene, object, factor);
}

bool is_lit(const Scene& scene) {
    const auto reflects = [&](const Object& object) {
        const Material& m = material_of(scene, object);
        return !is_black(m.diffuse) || !is_black(m.specular);
    };
    const auto shines = [](const Light& light) {
        return std::visit([](const auto& one) { return !is_black(one.color); }, light);
    };
    return std::ranges::any_of(scene.lights, shines) && std::ranges::any_of(scene.objects, reflects);
}

/// Our rays are all inside of what the eye is inside of, also those that an orthographic view begins beside
/// it.
void refuse_partly_inside(const Scene& scene) {
    if (scene.camera.projection != Projection::Orthographic) return;
    const Camera& camera = scene.camera;
    const Vec3 w = unit_along(camera.eye - camera.look_at);
    const Vec3 u = unit_along(glm::cross(near_one(camera.up), w)), v = glm::cross(w, u);
    const Real high = camera.view_height / 2, wide = high * scene.width / scene.height;
    for (const Object& object : scene.objects) {
        if (!is_glass(scene, object)) continue;
        const Box box = box_of(scene, object);
        int inside = 0;
        Box picture;
        for (const Vec3& at :
             {wide * u + high * v, wide * u - high * v, -wide * u + high * v, -wide * u - high * v}) {
            const Vec3 p = camera.eye + at;
            picture = {glm::min(picture.low, p), glm::max(picture.high, p)};
            if (const auto* plane = std::get_if<Plane>(&object.shape)) {
                const Plane here = moved(*plane, matrix_of(scene, object.transform));
                inside += glm::dot(here.normal, p - here.point) < 0;
            }
        }
        const bool touches =
            std::holds_alternative<Plane>(object.shape) ? inside % 4 != 0 : overlap(box, picture);
        if (touches)
            refuse(scene, object, "transparent, and an orthographic view begins partly inside of it");
    }
}

void refuse_nested_fresnel(const Scene& scene) {
    for (const Object& mirror : scene.objects) {
        if (!is_glass(scene, mirror) || material_of(scene, mirror).fresnel == Fresnel::None) continue;
        for (const Object& other : scene.objects)
            if (&other != &mirror && is_glass(scene, other) && may_overlap(scene, mirror, other))
                refuse(scene, mirror,
                       fmt::format("fresnel where it may be inside or around the transparent object of line "
                                   "{}: on the way out POV-Ray forgets what is around",
                                   other.place.line));
    }
}

/// POV-Ray's weight of a ray is the product of the strongest channels on its way, and leaves out Fresnel's
/// share.
void refuse_weights(const Scene& scene, const Object& object) {
    const Material& m = material_of(scene, object);
    if (scene.min_contribution == 0) return;
    if (!is_grey(m.specular) || !is_grey(m.transmission))
        refuse(scene, object,
               "a coloured mirror or glass with mincontribution: POV-Ray's weights have no colour");
    if (is_glass(scene, object) && m.fresnel != Fresnel::None)
        refuse(scene, object, "fresnel with mincontribution: POV-Ray's weights leave it out");
}

void refuse_material(const Scene& scene, const Object& object) {
    const Material& m = material_of(scene, object);
    if (!scene.lights.empty() && !is_grey(m.specular)) {
        if (m.fresnel != Fresnel::None)
            refuse(scene, object, "a transparent material with fresnel and a coloured highlight");
        for (int i = 0; i < 3; ++i)
            if (m.specular[i] == 0 && m.transmission[i] > 0)
                refuse(scene, object,
                       "a transparent material whose highlight lacks a channel that it transmits");
    }
    if (m.fresnel == Fresnel::Schlick)
        refuse(scene, object,
               "Schlick's approximation, for which POV-Ray takes the angle of incidence also where light "
               "leaves the denser side");
    if (!is_black(m.absorption) && bounces(scene) && is_lit(scene))
        refuse(scene, object,
               "absorption in a scene with lights, whose light POV-Ray absorbs on its way to a surface, too");
}

}  // namespace

void refuse(const Scene& scene, const Object& object, std::string_view why) {
    throw InputError(fmt::format("{}:{}:{}: POV-Ray cannot express this object: {}", scene.file,
                                 object.place.line, object.place.column, why));
}

void refuse(const Scene& scene, std::string_view why) {
    throw InputError(fmt::format("{}: POV-Ray cannot express this scene: {}", scene.file, why));
}

Vec3 unit_along(const Vec3& v) { return glm::normalize(near_one(v)); }

bool is_glass(const Scene& scene, const Object& object) {
    return scene.integrator == Integrator::Raytrace && !is_black(material_of(scene, object).transmission);
}

Mat4 matrix_of(const Scene& scene, int node) {
    Mat4 m(1);
    for (; node >= 0; node = scene.transforms[static_cast<std::size_t>(node)].parent) {
        Mat4 step(1);
        const TransformStep& what = scene.transforms[static_cast<std::size_t>(node)].step;
        if (const auto* move = std::get_if<Translate>(&what)) {
            step[3] = Vec4(move->by, 1);
        } else if (const auto* stretch = std::get_if<Scale>(&what)) {
            for (int i = 0; i < 3; ++i) step[i][i] = stretch->by[i];
        } else {
            const auto& turn = std::get<Rotate>(what);
            const Vec3 k = unit_along(turn.axis);
            for (int i = 0; i < 3; ++i) {
                Vec3 e(0);
                e[i] = 1;
                const Vec3 turned = e * std::cos(turn.angle) + glm::cross(k, e) * std::sin(turn.angle) +
                                    k * (k[i] * (1 - std::cos(turn.angle)));
                step[i] = Vec4(turned, 0);
            }
        }
        m = step * m;
    }
    return m;
}

Box box_of(const Scene& scene, const Object& object) {
    const Mat4 m = matrix_of(scene, object.transform);
    if (std::holds_alternative<Plane>(object.shape)) return {Vec3(-infinity), Vec3(infinity)};
    Box box;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        const Vec3 center(m * Vec4(sphere->center, 1));
        const Mat3 rows = glm::transpose(Mat3(m));
        const Vec3 half =
            sphere->radius * Vec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
        return {center - half, center + half};
    }
    visit_points(scene, object, [&](const Vec3& p) {
        const Vec3 here(m * Vec4(p, 1));
        box = {glm::min(box.low, here), glm::max(box.high, here)};
    });
    return box;
}

bool surrounds_eye(const Scene& scene, const Object& object) {
    const Vec3 eye(glm::inverse(matrix_of(scene, object.transform)) * Vec4(scene.camera.eye, 1));
    if (const auto* sphere = std::get_if<Sphere>(&object.shape))
        return glm::length(eye - sphere->center) < sphere->radius;
    const auto* plane = std::get_if<Plane>(&object.shape);
    return plane && glm::dot(plane->normal, eye - plane->point) < 0;
}

bool may_surround_eye(const Scene& scene, const Object& object) {
    const Vec3& eye = scene.camera.eye;
    if (const auto* plane = std::get_if<Plane>(&object.shape)) {
        const Plane here = moved(*plane, matrix_of(scene, object.transform));
        return glm::dot(here.normal, eye - here.point) <= 0;
    }
    const Box box = box_of(scene, object);
    return glm::all(glm::lessThanEqual(box.low, eye)) && glm::all(glm::lessThanEqual(eye, box.high));
}

bool absorbs(const Scene& scene) {
    return bounces(scene) && std::ranges::any_of(scene.objects, [&](const Object& object) {
               return is_glass(scene, object) && !is_black(material_of(scene, object).absorption);
           });
}

bool is_endless(const Scene& scene, const Object& object) {
    if (!is_glass(scene, object) || is_black(material_of(scene, object).absorption)) return false;
    if (const auto* shown = std::get_if<MeshObject>(&object.shape))
        return !is_closed(scene.meshes[shown->mesh]);
    return std::holds_alternative<Plane>(object.shape);
}

int bending_steps(const Scene& scene, const Object& object) {
    const Real ior = material_of(scene, object).ior;
    bool is_within = false;  // a ball of other glass
    int steps = 0;
    bool is_earlier = true;
    for (const Object& other : scene.objects) {
        if (&other == &object) is_earlier = false;
        if (&other == &object || !is_glass(scene, other)) continue;
        if (material_of(scene, other).ior != ior)
            is_within = is_within || is_ball_within(object, other);
        else if (is_earlier && may_overlap(scene, object, other))
            ++steps;
    }
    return steps + (ior == 1 && !is_within ? 1 : 0);
}

Real povray_factor(const Scene& scene) {
    // A picture of directions looks at nothing.
    if (scene.integrator == Integrator::Directions) {
        const Real far = glm::length(scene.camera.eye);
        return far > greatest_length ? factor_for(far) : 1;
    }
    const Lengths lengths = lengths_of(scene);
    if (lengths.greatest == 0) return 1;  // nothing but planes through the eye
    const Real least = std::min(lengths.least, lengths.greatest);
    const auto fits = [&](Real factor) {
        return lengths.least * factor >= least_length && lengths.greatest * factor <= greatest_length &&
               lengths.lights * factor <= greatest_light_distance;
    };
    if (fits(1)) return 1;
    // The middle of what is there goes to the middle of what may be.
    const Real middle = std::sqrt(least_length * greatest_length);
    const Real factor =
        std::exp2(std::round(std::log2(middle / std::sqrt(least) / std::sqrt(lengths.greatest))));
    if (!fits(factor))
        refuse(scene, fmt::format(
                          "its lengths are from {:.3g} to {:.3g}, and only a factor of {:.0e} between the "
                          "smallest object and the farthest point is safe from its tolerances",
                          least, std::max(lengths.greatest, lengths.lights), greatest_length / least_length));
    return factor;
}

Scene sized_for_povray(Scene scene, Real factor) {
    scale_world(scene, factor);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) size_mesh(scene, i);
    for (Object& object : scene.objects) size_shape(scene, object);
    return scene;
}

void refuse_other_optics(const Scene& scene) {
    for (const Object& object : scene.objects) {
        if (bounces(scene)) refuse_weights(scene, object);
        if (!is_glass(scene, object)) continue;
        refuse_material(scene, object);
        if (std::holds_alternative<TriangleObject>(object.shape) ||
            std::holds_alternative<PolygonObject>(object.shape))
            refuse(scene, object, "a transparent object without an inside; put its faces into one `mesh`");
        const auto* shown = std::get_if<MeshObject>(&object.shape);
        if (bounces(scene) && shown && !scene.meshes[shown->mesh].normals.empty())
            refuse(scene, object,
                   "a transparent mesh with normals of its own, through whose flat faces POV-Ray takes rays "
                   "inside "
                   "that stay outside");
    }
    if (!bounces(scene)) return;
    refuse_nested_fresnel(scene);
    refuse_partly_inside(scene);
}

}  // namespace rt
