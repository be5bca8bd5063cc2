// What the renderer reads: only what this scene needs, each kind of shape in one array.
#pragma once

#include "common/scene/area_lights.hpp"
#include "common/scene/lens.hpp"
#include "common/scene/sampling.hpp"
#include "common/scene/sky.hpp"
#include "common/scene/textures.hpp"
#include "common/world/accelerators.hpp"
#include "common/world/hit.hpp"
#include "common/world/shapes.hpp"
#include "common/world/view.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

namespace rt {

/// The normals of a smooth triangle at its corners a, b, c: unit vectors in the space of the file, then
/// mapped to the triangle's. Those of a stretched triangle are no unit vectors, so that they weigh as in the
/// file.
struct TriangleNormals {
    Vec3 a{0};
    Vec3 b{0};
    Vec3 c{0};
};

/// The texture coordinates of a triangle at its corners.
struct TriangleUvs {
    Vec2 a{0};
    Vec2 b{0};
    Vec2 c{0};
};

/// What a group keeps of its shapes beside their numbers. `lists()` are all its lists; each is empty, or has
/// one element a shape.
template <class Shape>
struct Extras {
    auto lists() const { return std::tie(); }
};

/// `normals` and `uvs` are empty where no triangle of the group has them.
template <>
struct Extras<Triangle> {
    std::vector<TriangleNormals> normals;
    std::vector<TriangleUvs> uvs;

    auto lists() { return std::tie(normals, uvs); }
    auto lists() const { return std::tie(normals, uvs); }
};

/// The shapes of one kind, for each its place in the order of the file, and an accelerator over them.
template <class Shape>
struct Group : Extras<Shape> {
    std::vector<Shape> shapes;
    std::vector<std::uint32_t> primitive;  ///< index into World::primitives; ascending. A mesh has none
    Accelerator accelerator;               ///< Nothing where asking them all is cheaper
    std::uint32_t mailbox = 0;             ///< which one of a thread is the accelerator's; unique in a World
};

template <class Shape>
bool has_accelerator(const Group<Shape>& group) {
    return group.accelerator.index() != 0;
}

template <class>
struct GroupsOf;
template <class... Shape>
struct GroupsOf<List<Shape...>> {
    using Any = std::variant<Group<Shape>...>;
};

/// A group of any of the shapes.
using AnyGroup = GroupsOf<Shapes>::Any;

/// The triangles of a mesh that instances share, in the mesh's own space, with a sphere around them.
struct SharedMesh {
    Group<Triangle> triangles;
    Sphere bound;
};

/// Where a primitive of the file went.
struct Primitive {
    std::uint32_t group = 0;     ///< index into World::groups
    std::uint32_t index = 0;     ///< index into the group's shapes
    std::uint32_t material = 0;  ///< index into World::materials
    std::uint32_t object = 0;    ///< which object of the file; all triangles of a mesh are one object, and
                                 ///< all faces of a transparent body are the first of them
};

/// A primitive whose own object of the file is not the one that its Primitive names.
struct BodyFace {
    std::uint32_t primitive = 0;  ///< index into World::primitives
    std::uint32_t object = 0;     ///< which object of the file
};

/// A transparent object that a ray can be inside of, and what it is made of.
struct Medium {
    std::uint32_t object = 0;    ///< as in Primitive
    std::uint32_t material = 0;  ///< index into World::materials
};

/// A checkerboard between two materials.
struct Pattern {
    Real size = 0;          ///< edge of a cube, world units; 0 where the material has no pattern
    std::uint32_t odd = 0;  ///< index of the material in the odd cubes
};

/// A picture at the texture coordinates, and how it is looked up.
struct PictureLookup {
    std::shared_ptr<const Image> image;     ///< null is none
    std::shared_ptr<const MipMap> pyramid;  ///< of that picture, where the filter needs it
    Wrap wrap = Wrap::Repeat;
    TextureFilter filter = TextureFilter::Bilinear;
};

/// What multiplies a material's colours at each place.
struct MaterialTexture {
    PictureLookup picture;
    std::optional<SolidPattern> pattern;  ///< at the point
    ColorsOf colors;                      ///< which of them
};

/// What the picture depends on. A feature that is false is not stored, computed or asked for per ray.
struct Needs {
    bool transforms = false;       ///< some primitive keeps a matrix
    bool normals = false;          ///< some normal is interpolated
    bool uvs = false;              ///< texture coordinates are used
    bool patterns = false;         ///< some material has a checker
    bool textures = false;         ///< some material has a picture or a pattern of two colours
    bool footprints = false;       ///< some texture is averaged over what a pixel sees
    bool bumps = false;            ///< some material has bumps or a normal map
    bool normal_maps = false;      ///< some material has one of these
    bool sky = false;              ///< the background depends on the direction
    bool finishes = false;         ///< some material spreads diffuse light in another way than evenly
    bool other_light = false;      ///< finishes or skylight: light is not just the plain sum over the lamps
    bool skylight = false;         ///< the sky lights what is diffuse
    bool lights = false;           ///< some light can contribute
    bool highlights = false;       ///< some material has a specular highlight, and there are lights
    bool shadows = false;          ///< shadow rays are cast
    bool colored_shadows = false;  ///< some shadow may be filtered by a transparent thing
    bool reflection = false;       ///< some material mirrors
    bool refraction = false;       ///< some material transmits
    bool absorption = false;       ///< some material absorbs inside
    bool accelerators = false;     ///< some group or mesh has one
    bool lens = false;             ///< camera rays start at points of a lens
    bool motion = false;           ///< something moves while the shutter is open, or the camera does
    bool blur = false;             ///< lens or motion: camera rays draw random numbers
    bool area_lights = false;      ///< some light has an extent
    bool gloss = false;            ///< some mirrored or refracted rays are spread by Phong's lobe
    bool rough = false;            ///< some are, by facets of GGX
    bool distribution = false;  ///< motion, area lights or either: rays draw random numbers after the camera
    bool samples = false;       ///< pixels have more than one sample, or share samples by a wide filter
};

/// Whether some material's numbers depend on the place.
inline bool varies(const Needs& needs) { return needs.patterns || needs.textures; }

/// What the camera does while it looks.
struct CameraBlur {
    Lens lens;  ///< with a radius if needs.lens
    Shutter shutter;
    Vec3 motion{0};  ///< of the camera, while the shutter is open
};

/// The lights that have an extent, which are primitives, too: the last ones.
struct AreaLights {
    std::vector<AreaLight> lights;
    std::vector<Real> chances;  ///< sums of their chances to be asked; empty where all are asked
    LightSamples samples;
    std::uint32_t first_primitive = 0;  ///< of those that are a light
    std::vector<std::uint32_t> of;      ///< which light each of them is; index into `lights`
};

/// A compiled scene. Equal for equal scenes; the renderer never changes it.
struct World {
    View view;
    Sampling sampling;
    Vec3 background{0};
    Sky sky;  ///< instead of the background, if needs.sky
    SkyLight skylight;
    Integrator integrator = Integrator::Raytrace;
    Visibility visibility = Visibility::Rays;
    int max_depth = 5;
    Real min_contribution = 0;
    Needs needs;
    std::vector<AnyGroup> groups;            ///< only kinds that occur, none empty
    std::vector<Primitive> primitives;       ///< in the order of the file
    std::vector<Material> materials;         ///< patterns are resolved: a checker is two materials
    std::vector<Pattern> patterns;           ///< one a material; empty where no material has a pattern
    std::vector<MaterialTexture> textures;   ///< likewise
    std::vector<Bumps> bumps;                ///< likewise
    std::vector<PictureLookup> normal_maps;  ///< likewise
    std::vector<Finish> finishes;            ///< those that materials name; empty if no light shows them
    CameraBlur blur;                         ///< if needs.blur
    AreaLights area_lights;                  ///< empty if no light has an extent, or nobody asks
    std::vector<PointLight> point_lights;
    std::vector<DirectionalLight> directional_lights;  ///< directions are unit vectors
    std::vector<std::shared_ptr<SharedMesh>> meshes;
    std::vector<Medium> eye_inside;     ///< transparent objects around the eye, outermost first
    std::vector<BodyFace> faces;        ///< of bodies that are made of several objects, but for the first of
                                        ///< each; ascending primitives
    std::vector<std::uint32_t> sheets;  ///< transparent objects without an inside, ascending
};

}  // namespace rt
