// One section an integrator, and the table of them at the end.
#include "common/povray/integrators.hpp"

#include "common/povray/bumps.hpp"
#include "common/povray/camera.hpp"
#include "common/povray/interiors.hpp"
#include "common/povray/lights.hpp"
#include "common/povray/materials.hpp"
#include "common/povray/noise_text.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/places.hpp"
#include "common/povray/refuse.hpp"
#include "common/povray/shapes.hpp"

#include <algorithm>
#include <string_view>

namespace rt::povray {
namespace {

Vec3 scene_background(const Writer& out) { return out.scene.background; }

void write_nothing(Writer&) {}

/// Shape, transform and texture, in this order, because checkers are solid in world space.
std::string textured(const Scene& scene, const Object& object, const std::string& texture) {
    return open_statement(scene, object) + transform_of(scene, object) + " texture { " + texture + " }";
}

// raytrace and flat -----------------------------------------------------------------------------------------

/// With the texture of its material.
std::string of_material(const Scene& scene, const Object& object) {
    if (is_by_parts(scene, object))
        return open_statement_by_parts(scene, std::get<CombinationObject>(object.shape), part_texture_name);
    return textured(scene, object, texture_name(scene, object));
}

std::string lit_object(const Scene& scene, const Object& object) {
    return of_material(scene, object) + inside(scene, object) + (scene.shadows ? "" : " no_shadow") + " }";
}

std::string flat_object(const Scene& scene, const Object& object) {
    return of_material(scene, object) + " }";
}

constexpr std::string_view glow =
    " texture {{ pigment {{ {} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}";

std::string lit_area_light(const Scene& scene, const AreaLight& light) {
    return fmt::format(glow, rgb(light.radiance)) +
           " interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }" +
           (scene.shadows ? "" : " no_shadow");
}

std::string flat_area_light(const Scene&, const AreaLight& light) {
    return fmt::format(glow, rgb(light.radiance));
}

// normals; scan conversion draws the same picture -----------------------------------------------------------

constexpr std::string_view normal_texture =
    "texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }";

void write_outward_lights(Writer& out) { write_normal_lights(out, 1); }

bool has_bumps(const Scene& scene, const Object& object) {
    return bumps_of(scene, scene.materials[object.material]) != nullptr;
}

std::string normal_name(const Scene& scene, const Object& object) {
    return has_bumps(scene, object) ? fmt::format("Normal{}", &object - scene.objects.data()) : "Normal";
}

void write_normal_textures(Writer& out) {
    const Scene& scene = out.scene;
    out.line("#declare Normal = {}\n", normal_texture);
    const auto has = [&](const Object& object) { return has_bumps(scene, object); };
    if (!std::ranges::any_of(scene.objects, has)) return;
    write_noise(out);
    write_bump_functions(out);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (const Object& object = scene.objects[i]; has(object)) {
            const std::string bumps = write_bumps(out, object, i);
            out.line("#declare {} = texture {{ Normal{} }}\n", normal_name(scene, object), bumps);
        }
}

std::string normal_object(const Scene& scene, const Object& object) {
    return textured(scene, object, normal_name(scene, object)) + " }";
}

std::string normal_area_light(const Scene&, const AreaLight&) { return " texture { Normal }"; }

// directions: the inside of a sphere around the eye has the normal −d, turned to the viewer -----------------

/// In an orthographic view all directions are the same, and a background shows them.
bool has_one_direction(const Scene& scene) { return scene.camera.projection == Projection::Orthographic; }

Vec3 direction_background(const Writer& out) { return 0.5 * (Vec3(1) - to_viewer(out)); }

void write_inward_lights(Writer& out) {
    if (!has_one_direction(out.scene)) write_normal_lights(out, -1);
}

void write_direction_sphere(Writer& out) {
    if (!has_one_direction(out.scene))
        out.line("sphere {{ {}, 1 {} }}", triple(out.scene.camera.eye), normal_texture);
}

// uv --------------------------------------------------------------------------------------------------------

/// Paints (u, v, 0): the mean of u in red and v in green, twice as bright.
std::string uv_texture(std::string_view mapping, std::string_view u, std::string_view v) {
    return fmt::format(
        "texture {{ pigment {{ {}average pigment_map {{ [function {{ {} }} color_map {{ [0 rgb 0] [1 rgb <1, "
        "0, 0>] }}] [function {{ {} }} color_map {{ [0 rgb 0] [1 rgb <0, 1, 0>] }}] }} }} "
        "finish {{ ambient 0 diffuse 0 emission 2 }} }}",
        mapping, u, v);
}

template <class... Shape>
bool is_one_of(const FileShape& shape) {
    return (std::holds_alternative<Shape>(shape) || ...);
}

/// Whether functions of the place tell the coordinates; spheres, triangles and meshes that are no parts of
/// others have the textures above.
bool has_own_uv(const Object& object) {
    return is_one_of<Plane, Disc, Box, Cone, OpenCone, Torus, PolygonObject, Implicit, Quadric>(object.shape);
}

/// Declares `Uv` and the number, a texture of an object or part that is none of several.
void write_uv_texture(Writer& out, const Object& object, std::size_t number) {
    if (out.scene.sampling.count > 1 && is_one_of<Plane, PolygonObject>(object.shape))
        refuse(out.scene, object,
               "coordinates beyond 0 and 1 as colours of several samples, each of which it limits");
    const auto [mapped, u, v] = write_coordinates(out, object, number);
    const auto shown = [](const std::string& x) { return fmt::format("min(max({}, 0), 1)", x); };
    out.line("#declare Uv{} = {}\n", number,
             mapped ? uv_texture("uv_mapping ", u, v) : uv_texture("", shown(u), shown(v)));
}

void write_uv_textures(Writer& out) {
    const Scene& scene = out.scene;
    out.line("#declare SphereUv = {}\n",
             uv_texture("", "atan2(z, x) / (2 * pi) + (z < 0)", "0.5 + asin(min(max(y, -1), 1)) / pi"));
    out.line("#declare MeshUv = {}\n", uv_texture("uv_mapping ", "x", "y"));
    out.line("#declare NoUv = texture {{ pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 }} }}\n");
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (has_own_uv(object)) write_uv_texture(out, object, i);
        if (const auto* whole = std::get_if<CombinationObject>(&object.shape))
            for (const std::uint32_t part : leaves_of(scene, *whole))
                write_uv_texture(out, scene.parts[part], scene.objects.size() + part);
    }
}

std::string uv_object(const Scene& scene, const Object& object) {
    const auto name = [](std::size_t number) { return fmt::format("Uv{}", number); };
    if (has_own_uv(object))
        return textured(scene, object, name(static_cast<std::size_t>(&object - scene.objects.data()))) + " }";
    if (const auto* whole = std::get_if<CombinationObject>(&object.shape))
        return open_statement_by_parts(
                   scene, *whole, [&](std::uint32_t part) { return name(scene.objects.size() + part); }) +
               " }";
    return with_uv(scene, object, transform_of(scene, object));
}

constexpr Expression expressions[] = {
    {Integrator::Raytrace, scene_background, write_lights, write_materials, lit_object, lit_area_light},
    {Integrator::Flat, scene_background, write_nothing, write_flat_materials, flat_object, flat_area_light},
    {Integrator::Directions, direction_background, write_inward_lights, write_direction_sphere, nullptr,
     nullptr},
    {Integrator::Normals, scene_background, write_outward_lights, write_normal_textures, normal_object,
     normal_area_light},
    {Integrator::Uv, scene_background, write_nothing, write_uv_textures, uv_object, nullptr},
};

}  // namespace

const Expression& expression_of(const Scene& scene) {
    const auto found = std::ranges::find(expressions, scene.integrator, &Expression::integrator);
    if (found == std::end(expressions)) refuse(scene, row_of(scene.integrator).why_not_povray);
    return *found;
}

}  // namespace rt::povray
