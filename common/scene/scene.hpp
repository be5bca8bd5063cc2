// What a scene file says: plain data, as the author wrote it.
// Angles are in radians here; positions are as written, before the transform of their object.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/accelerators.hpp"
#include "common/scene/area_lights.hpp"
#include "common/scene/finishes.hpp"
#include "common/scene/integrators.hpp"
#include "common/scene/lens.hpp"
#include "common/scene/sampling.hpp"
#include "common/scene/shapes.hpp"
#include "common/scene/sky.hpp"
#include "common/scene/textures.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rt {

/// Place in a scene file; line and column count from 1.
struct SourcePlace {
    int line = 0;
    int column = 0;
};

enum class Projection { Perspective, Orthographic };

/// `camera` and `orthographic`: where the picture is seen from.
struct Camera {
    Vec3 eye{0};
    Vec3 look_at{0, 0, -1};
    Vec3 up{0, 1, 0};
    Real fovy = pi / 2;    ///< vertical field of view, radians, in (0, π); perspective only
    Real view_height = 2;  ///< height of the picture in world units; orthographic only
    Projection projection = Projection::Perspective;
};

/// A solid checkerboard of cubes in world space: factor on ambient, diffuse and emission.
struct Checker {
    Vec3 even{1};   ///< where the sum of the three floors of point / size is even
    Vec3 odd{1};    ///< elsewhere
    Real size = 1;  ///< edge of a cube, world units
    friend bool operator==(const Checker&, const Checker&) = default;
};

/// Which fraction of light a transparent surface mirrors.
enum class Fresnel : std::uint8_t { None, Exact, Schlick };

/// Which formula shapes a highlight.
enum class Highlight : std::uint8_t { Blinn, Phong };

/// Everything the material commands set. Colours are linear RGB.
struct Material {
    Vec3 ambient{0.2};
    Vec3 diffuse{0};
    Vec3 specular{0};  ///< highlight, and the weight of the mirror direction
    Vec3 emission{0};
    Real shininess = 0;
    Highlight highlight = Highlight::Blinn;
    Fresnel fresnel = Fresnel::None;
    std::int32_t texturing = -1;  ///< index into Scene::texturings; −1 is the same everywhere
    Checker checker;              ///< all ones where no `checker` was said
    Vec3 transmission{0};         ///< weight of the refracted ray; zero is opaque
    Real ior = 1;                 ///< index of refraction inside
    std::int32_t finish = -1;     ///< index into Scene::finishes; −1 is plain
    float finish_factor = 1;  ///< at a place: on the finish's textured numbers; a Real would make lists of
                              ///< materials slower for all
    Vec3 absorption{0};       ///< Beer–Lambert coefficient inside, per world unit
    friend bool operator==(const Material&, const Material&) = default;
};

/// One step of the current transform.
struct Translate {
    Vec3 by{0};
};
struct Rotate {
    Vec3 axis{0, 0, 1};
    Real angle = 0;  ///< radians, counterclockwise as seen from the axis's tip
};
struct Scale {
    Vec3 by{1};
};
using TransformStep = std::variant<Translate, Rotate, Scale>;

/// The transforms of a file form a tree: each node multiplies one step on the right of its parent's.
struct TransformNode {
    int parent = -1;     ///< index into Scene::transforms; −1 is the identity
    TransformStep step;  ///< at time 0
    SourcePlace place;
    Real spin = 0;  ///< of a Rotate: by how much its angle grows, evenly, while the shutter is open; radians
};

/// One object of the file, with the material and transform in force where it stands. A combination has no
/// transform of its own: its parts have theirs.
struct Object {
    FileShape shape;
    std::uint32_t material = 0;  ///< index into Scene::materials
    int transform = -1;          ///< index into Scene::transforms; −1 is the identity
    SourcePlace place;
    Vec3 motion{0};  ///< where it is when the shutter closes, from where it stands; world space
};

/// Light from a point, divided by c + l·d + q·d² at distance d; `attenuation` is (c, l, q).
struct PointLight {
    Vec3 position{0};
    Vec3 color{0};
    Vec3 attenuation{1, 0, 0};
};

/// Light from infinitely far away; `direction` points towards the light, any length but 0.
struct DirectionalLight {
    Vec3 direction{0, 1, 0};
    Vec3 color{0};
};

using Light = std::variant<PointLight, DirectionalLight>;

/// A light with an extent, and where the file has it.
struct AreaLightObject {
    AreaLight light;
    SourcePlace place;
};

/// Vertex of `trinormal` triangles; the normal need not be of unit length.
struct SmoothVertex {
    Vec3 position{0};
    Vec3 normal{0};
};

/// A whole scene file.
struct Scene {
    std::string file;  ///< name for messages
    int version = 1;   ///< `version`: of the language
    int width = 640;
    int height = 480;
    int max_depth = 5;          ///< greatest number of bounces
    Real min_contribution = 0;  ///< rays whose weight is not greater in any channel are not followed
    bool shadows = true;
    AcceleratorChoice accelerator = AcceleratorChoice::Auto;
    Sampling sampling;
    std::string output;  ///< `output`; empty if not said
    SourcePlace output_place;
    Encoding encoding = Encoding::Linear;
    Integrator integrator = Integrator::Raytrace;
    Visibility visibility = Visibility::Rays;
    SourcePlace visibility_place;
    Vec3 background{0};
    std::optional<Sky> sky;  ///< instead of the background; its picture is one of `pictures`
    bool skylight = false;   ///< `skylight`: diffuse light from the sky
    Camera camera;
    Lens lens;
    Shutter shutter;
    Vec3 camera_motion{0};  ///< as an object's
    LightSamples light_samples;
    Real gamma = 1;  ///< exponent of 8-bit files: light to the power 1/gamma

    std::vector<Vec3> vertices;
    std::vector<SmoothVertex> smooth_vertices;
    std::vector<Mesh> meshes;           ///< each file once
    std::vector<PictureFile> pictures;  ///< likewise
    std::vector<Material> materials;
    std::vector<Texturing> texturings;
    std::vector<Finish> finishes;
    std::vector<TransformNode> transforms;
    std::vector<Object> objects;
    std::vector<Object> parts;  ///< what combinations are made of; theirs stand before them
    std::vector<Light> lights;
    std::vector<AreaLightObject> area_lights;
};

}  // namespace rt
