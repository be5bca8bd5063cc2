// Writes scenes in POV-Ray's language. Each function writes one kind of statement, and says why its
// statement means the same as ours where that is not plain.
#include "common/povray/export.hpp"

#include "common/povray/povray_scene.hpp"
#include "common/scene/range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace rt {
namespace {

/// POV-Ray's own limit of max_trace_level.
constexpr int most_trace_levels = 256;

/// Where lights that shine in parallel stand, in POV-Ray; only their direction matters.
constexpr Real far_away = 1e5;

/// Its rays end at 1e7.
constexpr Real sky_radius = 1e6;

/// Shortest number that reads back as the same double. Adding 0 makes -0 a 0.
std::string number(Real x) { return fmt::format("{}", x + 0); }

std::string triple(const Vec3& v) {
    return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z));
}

std::string rgb(const Vec3& c) {
    if (c.x == c.y && c.y == c.z) return fmt::format("rgb {}", number(c.x));
    return "rgb " + triple(c);
}

bool is_black(const Vec3& c) { return c == Vec3(0); }
bool is_grey(const Vec3& c) { return c.x == c.y && c.y == c.z; }

/// The text so far, and the scene that it is about.
struct Writer {
    const Scene& scene;
    Real factor;  ///< of all its lengths to what was written
    std::string text{};

    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
        text += '\n';
    }
};

// What the picture depends on -----------------------------------------------------------------------------

bool is_transparent(const Material& m) { return !is_black(m.transmission); }
bool is_mirror(const Material& m) { return !is_black(m.specular) || m.fresnel != Fresnel::None; }

/// Scan conversion draws the picture of normals too.
bool shows_normals(const Scene& scene) {
    return scene.integrator == Integrator::Normals || scene.integrator == Integrator::Rasterize;
}

/// In an orthographic view all directions are the same, and a background shows them.
bool shows_directions_on_sphere(const Scene& scene) {
    return scene.integrator == Integrator::Directions && scene.camera.projection == Projection::Perspective;
}

Vec3 backwards(const Camera& camera) { return unit_along(camera.eye - camera.look_at); }

/// Whether any object sends rays on.
bool has_bounces(const Scene& scene) {
    if (scene.integrator != Integrator::Raytrace || scene.max_depth == 0) return false;
    return std::ranges::any_of(scene.objects, [&](const Object& object) {
        const Material& m = scene.materials[object.material];
        return is_mirror(m) || is_transparent(m);
    });
}

// Camera and settings -------------------------------------------------------------------------------------

void write_header(Writer& out) {
    const Scene& scene = out.scene;
    const std::string name = std::filesystem::path(scene.file).stem().string();
    out.line("// {}, written by `course export`.", std::filesystem::path(scene.file).filename().string());
    const PovrayRun run = povray_run(scene);
    out.line("// povray +I{0}.pov +O{0}.png +W{1} +H{2} +FN16 -D {3} File_Gamma=1.0", name,
             scene.width * run.scale, scene.height * run.scale,
             run.options.empty() ? "-A" : fmt::format("{}", fmt::join(run.options, " ")));
    if (run.scale > 1)
        out.line("// then {0} × {0} of its pixels are one of ours, weighed by our filter", run.scale);
    else if (run.filter)
        out.line("// then its pixels are weighed by our filter");
    if (out.factor != 1)
        out.line("// All lengths are {} times those of the scene: POV-Ray's tolerances are lengths.",
                 number(out.factor));
    out.line("#version 3.7;");
    int levels = 1;
    if (has_bounces(scene)) {
        levels = scene.max_depth + 1;
        if (levels > most_trace_levels)
            refuse(scene, fmt::format("maxdepth {} is over its limit of {}", scene.max_depth,
                                      most_trace_levels - 1));
    }
    out.line("global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout {} }}", levels,
             number(scene.min_contribution));
    const bool directions = scene.integrator == Integrator::Directions;
    const Vec3 background = directions ? 0.5 * (Vec3(1) - backwards(scene.camera)) : scene.background;
    out.line("background {{ {} }}", rgb(background));
    out.line("");
}

/// POV-Ray's camera is given by the same basis as ours, so it needs no look_at, and none of the
/// handedness that comes with it. `direction`, `right` and `up` span the whole picture.
void write_camera(Writer& out) {
    const Camera& camera = out.scene.camera;
    const Vec3 w = backwards(camera);
    const Vec3 u = unit_along(glm::cross(near_one(camera.up), w));
    const Vec3 v = glm::cross(w, u);
    const bool flat = camera.projection == Projection::Orthographic;
    const Real height = flat ? camera.view_height : 2 * std::tan(camera.fovy / 2);
    const Real width = height * out.scene.width / out.scene.height;
    out.line("camera {{");
    out.line("  {}", flat ? "orthographic" : "perspective");
    out.line("  location {}", triple(camera.eye));
    out.line("  direction {}", triple(-w));
    out.line("  right {}", triple(width * u));
    out.line("  up {}", triple(height * v));
    out.line("}}");
    out.line("");
}

// Lights --------------------------------------------------------------------------------------------------

/// Nothing behind such a light is lit. So where the eye is far from the origin, the light goes with it.
void write_parallel_light(Writer& out, const Vec3& direction, const Vec3& color, std::string_view more = "") {
    const Vec3& eye = out.scene.camera.eye;
    const bool is_far = glm::length(eye) > far_away / 10;
    out.line("light_source {{ {} {} parallel point_at {}{} }}",
             triple(far_away * direction + (is_far ? eye : Vec3(0))), rgb(color), is_far ? triple(eye) : "0",
             more);
}

/// A light that POV-Ray divides by (1 + (d / fade_distance)^power) / 2 at distance d.
void write_fading_light(Writer& out, const PointLight& light, Real factor, Real fade_distance, int power) {
    out.line("light_source {{ {} {} fade_distance {} fade_power {} }}", triple(light.position),
             rgb(light.color * factor), number(fade_distance), power);
}

/// 1/(c + l·d + q·d²) in terms of 2/(1 + (d/f)^p): one light where two of the terms suffice. With all
/// three, partial fractions give 1/(q·(r2 − r1)) · (1/(d + r1) − 1/(d + r2)) with −r1, −r2 the roots of
/// the quadratic in d: two lights, the second with negative colour.
void write_light(Writer& out, const PointLight& light, std::size_t index) {
    const Real c = light.attenuation.x, l = light.attenuation.y, q = light.attenuation.z;
    // Stands for distance 0, where a light without a constant term is infinitely bright.
    const Real near = 1e-6;
    if (l == 0 && q == 0) {
        out.line("light_source {{ {} {} }}", triple(light.position), rgb(light.color / c));
    } else if (q == 0) {
        const Real f = c > 0 ? c / l : near;
        write_fading_light(out, light, 1 / (2 * l * f), f, 1);
    } else if (l == 0) {
        const Real f = c > 0 ? std::sqrt(c / q) : near;
        write_fading_light(out, light, 1 / (2 * q * f * f), f, 2);
    } else {
        const Real discriminant = l * l - 4 * c * q;
        // Where the roots are closer than this, the difference of two single-precision colours is
        // less exact than a 16-bit step.
        if (!(discriminant > 1e-4 * l * l))
            refuse(out.scene, fmt::format("light {} has attenuation {} {} {}, and only quadratics with two "
                                          "real roots (l*l > 4*c*q) can be put together from its lights",
                                          index + 1, number(c), number(l), number(q)));
        const Real far_root = (l + std::sqrt(discriminant)) / (2 * q);
        const Real near_root = std::max(c / (q * far_root), near);
        const Real k = 1 / (q * (far_root - near_root));
        write_fading_light(out, light, k / (2 * near_root), near_root, 1);
        write_fading_light(out, light, -k / (2 * far_root), far_root, 1);
    }
}

/// Six lights that shine along the axes paint the unit normal n as sign · n/2, a channel an axis: the
/// positive half from one side, the negative half, with a negative colour, from the other.
void write_normal_lights(Writer& out, Real sign) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real side : {1., -1.}) {
            Vec3 direction(0), color(0);
            direction[axis] = side;
            color[axis] = sign * side / 2;
            write_parallel_light(out, direction, color, " shadowless");
        }
    }
}

void write_lights(Writer& out) {
    const Scene& scene = out.scene;
    if (shows_normals(scene)) {
        write_normal_lights(out, 1);
    } else if (shows_directions_on_sphere(scene)) {
        // The inside of a sphere around the eye has the normal -d, turned to the viewer.
        write_normal_lights(out, -1);
    } else if (scene.integrator == Integrator::Raytrace) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if (const auto* point = std::get_if<PointLight>(&scene.lights[i])) {
                write_light(out, *point, i);
            } else {
                const auto& light = std::get<DirectionalLight>(scene.lights[i]);
                write_parallel_light(out, unit_along(light.direction), light.color);
            }
        }
    }
    out.line("");
}

// Materials -----------------------------------------------------------------------------------------------

/// The colour with the material's pattern, as the inside of `pigment { }`.
std::string patterned(const Vec3& color, const Checker& checker, std::string_view more) {
    if (checker.even == Vec3(1) && checker.odd == Vec3(1)) return rgb(color) + std::string(more);
    return fmt::format("checker {}{} {}{} scale {}", rgb(color * checker.even), more,
                       rgb(color * checker.odd), more, number(checker.size));
}

std::string highlight(const Material& m, Real strength) {
    if (m.highlight == Highlight::Phong)
        return fmt::format(" phong {} phong_size {}", number(strength), number(m.shininess));
    // POV-Ray's exponent is 1/roughness; the largest roughness stands for exponent 0.
    const Real roughness = m.shininess > 0 ? 1 / m.shininess : 1e30;
    return fmt::format(" specular {} roughness {}", number(strength), number(roughness));
}

bool has_fresnel(const Material& m) { return is_transparent(m) && m.fresnel != Fresnel::None; }

/// One finish of POV-Ray has one pigment for every term, where our materials have a colour for each. So a
/// material becomes up to four layers: diffuse, emission, a filter that colours the highlight, and below
/// it the highlight itself and what shines through. The layers above another let most or half of it
/// through, and the strengths of those below make up for that.
std::string texture(const Scene& scene, const Material& m) {
    const bool lit = !scene.lights.empty();
    const Vec3 glow = m.ambient + m.emission;
    const bool has_diffuse = lit && !is_black(m.diffuse);
    const bool has_highlight = lit && !is_black(m.specular);
    const bool filtered = has_highlight && !is_grey(m.specular);
    const bool transparent = is_transparent(m);
    const bool has_bottom = filtered || transparent;
    // Half is the more readable number. But conserve_energy also dims the light of layers below the one that
    // reflects, and POV-Ray leaves out layers from which less than adc_bailout arrives. There the upper
    // layers hide nothing that a 16-bit step could show.
    const Real share = has_fresnel(m) || scene.min_contribution > 0 ? 1 - 0x1p-16 : 0.5;

    std::vector<std::string> layers;  // top first
    Real over = 1;                    // what the layers so far let through
    std::string top =
        has_fresnel(m) || is_black(m.specular) ? "" : fmt::format(" reflection {{ {} }}", rgb(m.specular));
    if (has_highlight && !filtered) top += highlight(m, m.specular.x);
    const auto add = [&](const std::string& pigment, const std::string& finish) {
        layers.push_back(fmt::format("texture {{ pigment {{ {} }} finish {{ ambient 0 {}{} }} }}", pigment,
                                     finish, std::exchange(top, "")));
    };
    const auto add_colored = [&](const Vec3& color, bool is_last, std::string_view term) {
        const std::string transmit = is_last ? "" : " transmit " + number(share);
        add(patterned(color, m.checker, transmit),
            fmt::format("{} {}", term, number(1 / ((is_last ? 1 : 1 - share) * over))));
        if (!is_last) over *= share;
    };
    if (has_diffuse) add_colored(m.diffuse, is_black(glow) && !has_bottom, "diffuse");
    if (!is_black(glow)) add_colored(glow, !has_bottom, "diffuse 0 emission");
    const Real strongest = max_component(m.specular);
    if (filtered) add(rgb(m.specular / strongest) + " filter 1", "diffuse 0");
    if (has_bottom || layers.empty()) {
        std::string pigment = "rgb 0", finish = "diffuse 0";
        if (transparent) {
            Vec3 through(0);
            for (int i = 0; i < 3; ++i)
                if (m.transmission[i] > 0)
                    through[i] = m.transmission[i] / over / (filtered ? m.specular[i] / strongest : 1);
            pigment = rgb(through) + " filter 1";
        }
        if (filtered) finish += highlight(m, strongest / over);
        if (has_fresnel(m))
            finish +=
                fmt::format(" reflection {{ rgb 0, rgb {} fresnel }} conserve_energy", number(1 / over));
        add(pigment, finish);
    }
    std::string text;
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) text += "  " + *layer + "\n";
    return text;
}

/// Beer–Lambert as a medium: POV-Ray's fade_power 1001 has the same formula, but leaves out the ways
/// between inner reflections.
///
/// POV-Ray does not count a bounce where rays are not bent. So no body has quite the index of refraction of
/// what is around it: the differences are steps of its single precision.
std::string interior(const Scene& scene, const Object& object) {
    const Material& m = scene.materials[object.material];
    const int steps = bending_steps(scene, object);
    // Nine digits are more than single precision has.
    const std::string ior = steps == 0 ? number(m.ior) : fmt::format("{:.9g}", m.ior * (1 + steps * 1e-6));
    std::string text = fmt::format(" interior {{ ior {}", ior);
    if (!is_black(m.absorption)) text += fmt::format(" media {{ absorption {} }}", rgb(m.absorption));
    return text + " }";
}

/// POV-Ray takes any body around the eye for a medium, even if it is opaque. `inverse` turns its inside out
/// and changes nothing that is seen.
bool must_be_inverse(const Scene& scene, const Object& object) {
    return has_bounces(scene) && !is_glass(scene, object) && surrounds_eye(scene, object) &&
           std::ranges::any_of(scene.objects, [&](const Object& other) { return is_glass(scene, other); });
}

/// Media are only where every body around is hollow.
bool must_be_hollow(const Scene& scene, const Object& object) {
    return absorbs(scene) && (is_glass(scene, object) || may_surround_eye(scene, object));
}

void write_materials(Writer& out) {
    const Scene& scene = out.scene;
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) used[object.material] = true;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (!used[i]) continue;
        const Material& m = scene.materials[i];
        if (scene.integrator == Integrator::Raytrace) {
            out.line("#declare Material{} =\n{}", i, texture(scene, m));
        } else {
            const std::string pigment = patterned(m.ambient + m.emission, m.checker, "");
            out.line("#declare Material{} =", i);
            out.line("  texture {{ pigment {{ {} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}\n",
                     pigment);
        }
    }
}

// Shapes --------------------------------------------------------------------------------------------------

std::string transform_of(const Scene& scene, const Object& object) {
    if (object.transform < 0) return "";
    const Mat4 m = matrix_of(scene, object.transform);
    std::string text = " matrix <";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) text += (column + row == 0 ? "" : ", ") + number(m[column][row]);
    return text + ">";
}

std::string shape_text(const Scene&, const Object&, const Sphere& sphere) {
    return fmt::format("sphere {{ {}, {}", triple(sphere.center), number(sphere.radius));
}

std::string shape_text(const Scene&, const Object&, const Plane& plane) {
    const Vec3 n = unit_along(plane.normal);
    return fmt::format("plane {{ {}, {}", triple(n), number(glm::dot(n, plane.point)));
}

bool has_triangles(const Object& object) {
    return std::holds_alternative<TriangleObject>(object.shape) ||
           std::holds_alternative<MeshObject>(object.shape);
}

/// Only meshes have texture coordinates in POV-Ray, so for those a triangle becomes a mesh of one.
std::string shape_text(const Scene& scene, const Object&, const TriangleObject& triangle) {
    const bool uv = scene.integrator == Integrator::Uv;
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

std::string shape_text(const Scene& scene, const Object&, const PolygonObject& polygon) {
    std::string text = fmt::format("polygon {{ {}", polygon.vertex.size() + 1);
    for (const std::uint32_t i : polygon.vertex) text += ", " + triple(scene.vertices[i]);
    return text + ", " + triple(scene.vertices[polygon.vertex.front()]);
}

std::string shape_text(const Scene&, const Object&, const MeshObject& mesh) {
    return fmt::format("object {{ Mesh{}", mesh.mesh);
}

/// A list `name { n, <...>, ... }`, one element a line.
template <class Range, class Text>
void write_list(Writer& out, std::string_view name, const Range& range, Text text) {
    out.line("  {} {{ {}", name, range.size());
    for (const auto& element : range) out.line("    , {}", text(element));
    out.line("  }}");
}

Vec3 face_normal(const Mesh& mesh, const std::array<Mesh::Corner, 3>& face) {
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(face[i].position)]; };
    const Vec3 n = glm::cross(at(1) - at(0), at(2) - at(0));
    const Real length = glm::length(n);
    return length > 0 ? n / length : Vec3(0, 0, 1);
}

/// For each face the indices of its corners' values in a list. Where a corner has no value, all corners of
/// the face get those of `otherwise(face)`, appended to the list.
template <class Value, class Otherwise>
std::vector<std::array<std::size_t, 3>> indices_of(const Mesh& mesh, std::int32_t Mesh::Corner::*member,
                                                   std::vector<Value>& values, Otherwise otherwise) {
    std::vector<std::array<std::size_t, 3>> indices;
    for (const auto& face : mesh.triangles) {
        std::array<std::size_t, 3> of_face{};
        if (std::ranges::all_of(face, [&](const Mesh::Corner& c) { return c.*member >= 0; })) {
            for (std::size_t i = 0; i < 3; ++i) of_face[i] = static_cast<std::size_t>(face[i].*member);
        } else {
            for (const Value& value : otherwise(face)) values.push_back(value);
            for (std::size_t i = 0; i < 3; ++i) of_face[i] = values.size() - 3 + i;
        }
        indices.push_back(of_face);
    }
    return indices;
}

/// Whether the eye may be inside a transparent object of this mesh.
bool is_around_eye(const Scene& scene, std::size_t mesh) {
    return std::ranges::any_of(scene.objects, [&](const Object& object) {
        const auto* shown = std::get_if<MeshObject>(&object.shape);
        return shown && shown->mesh == mesh && is_glass(scene, object) && may_surround_eye(scene, object);
    });
}

void write_mesh(Writer& out, const Mesh& mesh, std::size_t index) {
    const auto index_text = [](const auto& face) {
        return fmt::format("<{}, {}, {}>", face[0], face[1], face[2]);
    };
    const bool uv = out.scene.integrator == Integrator::Uv;
    std::vector<Vec3> normals = mesh.normals;
    std::vector<Vec2> uvs = mesh.uvs;
    std::vector<std::array<std::size_t, 3>> normal_indices, uv_indices;
    if (!normals.empty())
        normal_indices = indices_of(mesh, &Mesh::Corner::normal, normals, [&](const auto& face) {
            const Vec3 n = face_normal(mesh, face);
            return std::array{n, n, n};
        });
    if (uv)
        uv_indices = indices_of(mesh, &Mesh::Corner::uv, uvs, [](const auto&) {
            return std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
        });

    out.line("#declare Mesh{} = mesh2 {{  // {}", index,
             std::filesystem::path(mesh.file).filename().string());
    write_list(out, "vertex_vectors", mesh.positions, triple);
    if (!normals.empty()) write_list(out, "normal_vectors", normals, triple);
    if (uv)
        write_list(out, "uv_vectors", uvs,
                   [](const Vec2& v) { return fmt::format("<{}, {}>", number(v.x), number(v.y)); });
    write_list(out, "face_indices", mesh.triangles, [](const auto& face) {
        return fmt::format("<{}, {}, {}>", face[0].position, face[1].position, face[2].position);
    });
    if (!normals.empty()) write_list(out, "normal_indices", normal_indices, index_text);
    if (uv) write_list(out, "uv_indices", uv_indices, index_text);
    // Any direction in general position, to tell whether the eye is inside.
    if (is_around_eye(out.scene, index)) out.line("  inside_vector <0.41, 0.83, 0.37>");
    out.line("}}\n");
}

constexpr std::string_view normal_texture =
    "texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }";

/// Paints (u, v, 0): the mean of u in red and v in green, twice as bright.
std::string uv_texture(std::string_view mapping, std::string_view u, std::string_view v) {
    return fmt::format(
        "texture {{ pigment {{ {}average pigment_map {{ [function {{ {} }} color_map {{ [0 rgb 0] [1 rgb <1, "
        "0, 0>] }}] "
        "[function {{ {} }} color_map {{ [0 rgb 0] [1 rgb <0, 1, 0>] }}] }} }} "
        "finish {{ ambient 0 diffuse 0 emission 2 }} }}",
        mapping, u, v);
}

void write_textures(Writer& out) {
    switch (out.scene.integrator) {
        case Integrator::Directions:
            return;
        case Integrator::Normals:
        case Integrator::Rasterize:
            out.line("#declare Normal = {}\n", normal_texture);
            return;
        case Integrator::Uv:
            out.line("#declare SphereUv = {}\n", uv_texture("", "atan2(z, x) / (2 * pi) + (z < 0)",
                                                            "0.5 + asin(min(max(y, -1), 1)) / pi"));
            out.line("#declare MeshUv = {}\n", uv_texture("uv_mapping ", "x", "y"));
            out.line("#declare NoUv = texture {{ pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 }} }}\n");
            return;
        case Integrator::Flat:
        case Integrator::Raytrace:
            write_materials(out);
    }
}

/// Shape, transform and texture, in this order, because checkers are solid in world space.
void write_object(Writer& out, const Object& object) {
    const Scene& scene = out.scene;
    const std::string shape =
        std::visit([&](const auto& s) { return shape_text(scene, object, s); }, object.shape);
    const std::string transform = transform_of(scene, object);
    if (shows_normals(scene)) {
        out.line("{}{} texture {{ Normal }} }}", shape, transform);
    } else if (scene.integrator == Integrator::Uv) {
        // Texture coordinates belong to the object, so they move with it.
        if (const auto* sphere = std::get_if<Sphere>(&object.shape))
            out.line("{} texture {{ SphereUv scale {} translate {} }}{} }}", shape, number(sphere->radius),
                     triple(sphere->center), transform);
        else
            out.line("{}{} texture {{ {} }} }}", shape, transform, has_triangles(object) ? "MeshUv" : "NoUv");
    } else if (scene.integrator == Integrator::Raytrace) {
        const Material& m = scene.materials[object.material];
        out.line("{}{} texture {{ Material{} }}{}{}{}{} }}", shape, transform, object.material,
                 is_transparent(m) ? interior(scene, object) : "",
                 must_be_hollow(scene, object) ? " hollow" : "",
                 must_be_inverse(scene, object) ? " inverse" : "", scene.shadows ? "" : " no_shadow");
    } else {
        out.line("{}{} texture {{ Material{} }} }}", shape, transform, object.material);
    }
}

/// POV-Ray lets light from the background through any medium. So where a ray in an absorbing body may go on
/// for ever, the background is a sphere so large that nothing is left of light from there.
void write_sky(Writer& out) {
    const Scene& scene = out.scene;
    const auto endless =
        std::ranges::find_if(scene.objects, [&](const Object& object) { return is_endless(scene, object); });
    if (!absorbs(scene) || endless == scene.objects.end()) return;
    const Vec3 a = scene.materials[endless->material].absorption;
    for (int i = 0; i < 3; ++i)
        if (a[i] > 0 && a[i] * sky_radius < 12)  // e^-12 is less than half a 16-bit step
            refuse(scene, *endless, "absorption so weak, in a body without an end");
    out.line(
        "sphere {{ {}, {} texture {{ pigment {{ {} }} finish {{ ambient 0 diffuse 0 emission 1 }} }} "
        "no_shadow hollow }}",
        triple(scene.camera.eye), number(sky_radius), rgb(scene.background));
}

void write_objects(Writer& out) {
    write_textures(out);
    if (shows_directions_on_sphere(out.scene))
        out.line("sphere {{ {}, 1 {} }}", triple(out.scene.camera.eye), normal_texture);
    if (out.scene.integrator == Integrator::Directions) return;
    std::vector<bool> written(out.scene.meshes.size(), false);
    for (const Object& object : out.scene.objects) {
        const auto* shown = std::get_if<MeshObject>(&object.shape);
        if (!shown || written[shown->mesh]) continue;
        written[shown->mesh] = true;
        write_mesh(out, out.scene.meshes[shown->mesh], shown->mesh);
    }
    write_sky(out);
    for (const Object& object : out.scene.objects) write_object(out, object);
}

}  // namespace

PovrayRun povray_run(const Scene& scene) {
    const Sampling& sampling = scene.sampling;
    const bool box = sampling.filter.kind == FilterKind::Box && sampling.filter.radius == 0.5;
    const auto root = static_cast<int>(std::sqrt(static_cast<Real>(sampling.count)) + 0.5);
    const auto option = [](const char* name, int n) { return fmt::format("{}{}", name, n); };
    if (scene.integrator == Integrator::Rasterize) return {};
    if (sampling.count == 1) return {1, {}, !box, true};
    switch (sampling.sampler) {
        case Sampler::Regular:
            if (root * root == sampling.count) return {root, {}, true, true};
            break;
        case Sampler::Trapezoid:
            // Its recursion halves the pixel `depth` − 1 times.
            for (int depth = 1; box && depth <= 4; ++depth)
                if (const int side = (1 << (depth - 1)) + 1; side * side == sampling.count)
                    return {1, {"+AM2", "+A0.0", option("+R", depth), "-J"}, false, true};
            break;
        case Sampler::Centered: {
            const auto side = static_cast<int>(std::sqrt(static_cast<Real>(sampling.count - 1)) + 0.5);
            if (box && side * side == sampling.count - 1)
                return {1, {"+AM1", "+A0.0", option("+R", side), "-J"}, false, true};
            break;
        }
        case Sampler::Random:
        case Sampler::Jittered:
        case Sampler::Poisson:
            break;
    }
    return {8, {"+AM1", "+A0.0", "+R2", "-J"}, true, false};
}

std::string export_povray(const Scene& scene) {
    refuse_other_optics(scene);
    const Real factor = povray_factor(scene);
    const Scene here = sized_for_povray(scene, factor);
    Writer out{.scene = here, .factor = factor};
    write_header(out);
    write_camera(out);
    write_lights(out);
    write_objects(out);
    return std::move(out.text);
}

}  // namespace rt
