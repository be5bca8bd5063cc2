// Scene files to Scene: the complete language, one table of commands.
// To add a command: one row of `commands`, then copy the new reference table into README.md (a test
// compares).
#include "common/scene/parse.hpp"

#include "common/math/error.hpp"
#include "common/math/input_error.hpp"
#include "common/scene/elsewhere.hpp"
#include "common/scene/mesh_file.hpp"
#include "common/scene/range.hpp"
#include "common/scene/suggest.hpp"
#include "common/scene/text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace rt {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;

struct Parser;

/// A row of the table of commands.
struct Command {
    SceneCommand text;
    void (*handle)(Parser&);
    std::size_t arguments = 0;  ///< how many there must be, or at least if `any_more`
    bool any_more = false;
};

/// The state in the middle of a file.
struct Parser {
    const ParseOptions& options;
    const std::filesystem::path& directory;
    Scene scene{};

    Material material{};
    Vec3 attenuation{1, 0, 0};
    int transform = -1;
    std::vector<int> transform_stack{};
    bool has_camera = false;
    bool has_command = false;
    std::string adaptive_place{};  ///< of `adaptive on`, for a message
    std::map<std::string, std::uint32_t> mesh_of_file{};

    const Command* command = nullptr;
    int line_number = 0;
    std::string_view line{};
    std::vector<std::string_view> words{};  ///< of the line: the command and its arguments
};

// Messages

std::string message_at(const Parser& parser, const char* where, const std::string& what) {
    return parser.scene.file + ":" + std::to_string(parser.line_number) + ":" +
           std::to_string(where - parser.line.data() + 1) + ": " + what;
}

void warn(const Parser& parser, const char* where, const std::string& what) {
    if (parser.options.warnings) parser.options.warnings->push_back(message_at(parser, where, what));
}

/// A value that later versions may know, such as a new integrator: lenient reading goes on without the line.
struct UnknownValue : InputError {
    using InputError::InputError;
};

/// Wrong, at the word.
[[noreturn]] void fail(const Parser& parser, std::string_view word, const std::string& what) {
    throw InputError(message_at(parser, word.data(), what));
}

/// The line as it should be: `expected: sphere x y z r`.
std::string expected(const Parser& parser) {
    const SceneCommand& text = parser.command->text;
    return "; expected: " + std::string(text.name) + (text.arguments.empty() ? "" : " ") +
           std::string(text.arguments);
}

// Arguments; they count from 1

Real number(const Parser& parser, std::size_t i) {
    const ParsedNumber parsed = parse_number(parser.words[i]);
    if (!parsed.problem.empty())
        fail(parser, parser.words[i],
             quoted(parser.words[i]) + " " + std::string(parsed.problem) + expected(parser));
    return parsed.value;
}

Real positive(const Parser& parser, std::size_t i, const char* noun) {
    const Real value = number(parser, i);
    if (!(value > 0))
        fail(parser, parser.words[i], std::string(noun) + " must be greater than 0, not " + shown(value));
    return value;
}

Real not_negative(const Parser& parser, std::size_t i, const char* noun) {
    const Real value = number(parser, i);
    if (!(value >= 0))
        fail(parser, parser.words[i], std::string(noun) + " must not be negative, but is " + shown(value));
    return value;
}

/// A whole number in [low, high]; existing scenes also write them as `5.0`.
Real whole(const Parser& parser, std::size_t i, const char* noun, Real low, Real high) {
    const Real value = number(parser, i);
    if (value != std::floor(value))
        fail(parser, parser.words[i], quoted(parser.words[i]) + " is not a whole number" + expected(parser));
    if (value < low || value > high)
        fail(parser, parser.words[i],
             std::string(noun) + " must be from " + shown(low) + " to " + shown(high) + ", not " +
                 shown(value));
    return value;
}

Vec3 vec3(const Parser& parser, std::size_t i) {
    const Real x = number(parser, i), y = number(parser, i + 1), z = number(parser, i + 2);
    return {x, y, z};
}

/// Refuses a number that is beyond what can be drawn, so that nothing computed from it leaves the range of
/// Real.
Real limited(const Parser& parser, std::size_t i, Real value, const char* nouns) {
    if (std::abs(value) > largest_number)
        fail(parser, parser.words[i],
             std::string(nouns) + " beyond " + shown(largest_number) + " are not possible, and this is " +
                 shown(value));
    return value;
}

/// A point of the world.
Vec3 place3(const Parser& parser, std::size_t i) {
    const Vec3 value = vec3(parser, i);
    for (int k = 0; k < 3; ++k) limited(parser, i + static_cast<std::size_t>(k), value[k], "coordinates");
    return value;
}

Vec3 color(const Parser& parser, std::size_t i) {
    const Vec3 value = vec3(parser, i);
    for (int k = 0; k < 3; ++k) limited(parser, i + static_cast<std::size_t>(k), value[k], "colours");
    return value;
}

/// A number that is greater than 0 and neither too small nor too large.
Real sized(const Parser& parser, std::size_t i, const char* noun) {
    const Real value = positive(parser, i, noun);
    if (value < smallest_size || value > largest_number)
        fail(parser, parser.words[i],
             std::string(noun) + " must be from " + shown(smallest_size) + " to " + shown(largest_number) +
                 ", not " + shown(value));
    return value;
}

Vec3 not_negative3(const Parser& parser, std::size_t i, const char* noun) {
    const Real x = not_negative(parser, i, noun), y = not_negative(parser, i + 1, noun),
               z = not_negative(parser, i + 2, noun);
    return {x, y, z};
}

/// A vector that has a direction.
Vec3 direction(const Parser& parser, std::size_t i, const char* noun) {
    const Vec3 value = vec3(parser, i);
    if (value == Vec3(0)) fail(parser, parser.words[i], std::string(noun) + " must not be 0 0 0");
    return value;
}

/// Index into a list of which `count` have been given so far.
std::uint32_t index(const Parser& parser, std::size_t i, std::size_t count) {
    const Real value = number(parser, i);
    const std::string_view word = parser.words[i];
    if (value != std::floor(value))
        fail(parser, word, quoted(word) + " is not a whole number" + expected(parser));
    const std::string noun = parser.command->text.name == "trinormal" ? "vertexnormal" : "vertex";
    if (count == 0) fail(parser, word, "index " + shown(value) + ": no " + noun + " stands before this line");
    if (value < 0 || value >= static_cast<Real>(count))
        fail(parser, word,
             "index " + shown(value) + " is out of range: 0 to " + std::to_string(count - 1) +
                 " stand before this line");
    return static_cast<std::uint32_t>(value);
}

/// The same for the first argument of a setting that programs give other ranges: `maxdepth -1`.
Real whole_setting(const Parser& parser, const char* noun, Real low, Real high) {
    try {
        return whole(parser, 1, noun, low, high);
    } catch (const InputError& error) {
        // What is not a number at all is wrong everywhere.
        if (!parse_number(parser.words[1]).problem.empty()) throw;
        throw UnknownValue(error.what());
    }
}

template <class Enum>
struct Choice {
    std::string_view name;
    Enum value;
};

/// One of some words; the first argument.
template <class Enum, std::size_t N>
Enum choice(const Parser& parser, const Choice<Enum> (&choices)[N]) {
    std::vector<std::string_view> names;
    for (const Choice<Enum>& each : choices) {
        if (each.name == parser.words[1]) return each.value;
        names.push_back(each.name);
    }
    const std::string_view command = parser.words[0], word = parser.words[1];
    std::string meaning = meaning_elsewhere(command, word);
    if (meaning.empty()) meaning = did_you_mean(word, names);
    throw UnknownValue(
        message_at(parser, word.data(),
                   quoted(word) + " is not a known " + std::string(command) + meaning + expected(parser)));
}

// Handlers that need more than a line

SourcePlace place(const Parser& parser) {
    return {parser.line_number, static_cast<int>(parser.words[0].data() - parser.line.data()) + 1};
}

void add_transform(Parser& parser, const TransformStep& step) {
    parser.scene.transforms.push_back({parser.transform, step, place(parser)});
    parser.transform = static_cast<int>(parser.scene.transforms.size()) - 1;
}

template <class Shape>
void add_object(Parser& parser, Shape&& shape) {
    std::vector<Material>& materials = parser.scene.materials;
    if (materials.empty() || !(materials.back() == parser.material)) materials.push_back(parser.material);
    parser.scene.objects.push_back({std::forward<Shape>(shape),
                                    static_cast<std::uint32_t>(materials.size() - 1), parser.transform,
                                    place(parser)});
}

void add_triangle(Parser& parser, bool smooth) {
    const std::size_t count = smooth ? parser.scene.smooth_vertices.size() : parser.scene.vertices.size();
    TriangleObject triangle{{}, smooth};
    for (std::size_t i = 0; i < 3; ++i) triangle.vertex[i] = index(parser, i + 1, count);
    add_object(parser, triangle);
}

void add_polygon(Parser& parser) {
    PolygonObject polygon;
    for (std::size_t i = 1; i < parser.words.size(); ++i)
        polygon.vertex.push_back(index(parser, i, parser.scene.vertices.size()));
    add_object(parser, std::move(polygon));
}

void add_mesh(Parser& parser) {
    if (!parser.options.meshes) fail(parser, parser.words[0], "mesh files are not read here");
    const std::string_view word = parser.words[1];
    const std::filesystem::path path = parser.directory / std::filesystem::path(word);
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
    const auto [found, is_new] = parser.mesh_of_file.try_emplace(
        error ? path.string() : canonical.string(), static_cast<std::uint32_t>(parser.scene.meshes.size()));
    if (is_new) {
        std::vector<std::string> warnings;
        try {
            parser.scene.meshes.push_back(
                read_mesh(path, {.lenient = parser.options.lenient, .warnings = &warnings}));
        } catch (const InputError& problem) {
            fail(parser, word, std::string("mesh ") + problem.what());
        }
        for (const std::string& warning : warnings) warn(parser, word.data(), "mesh " + warning);
        parser.scene.meshes.back().file = word;
    }
    add_object(parser, MeshObject{found->second});
}

void set_size(Parser& parser) {
    const Real width = whole(parser, 1, "width", 1, largest_side),
               height = whole(parser, 2, "height", 1, largest_side);
    if (width * height > static_cast<Real>(most_pixels))
        fail(parser, parser.words[1],
             shown(width) + " by " + shown(height) + " is " +
                 std::to_string(static_cast<long>(width * height)) + " pixels; at most " +
                 std::to_string(most_pixels) + " are possible");
    parser.scene.width = static_cast<int>(width);
    parser.scene.height = static_cast<int>(height);
}

void set_camera(Parser& parser) {
    Camera& camera = parser.scene.camera;
    camera.eye = place3(parser, 1);
    camera.look_at = place3(parser, 4);
    camera.up = direction(parser, 7, "the up direction");
    const Real fovy = number(parser, 10);
    if (camera.eye == camera.look_at)
        fail(parser, parser.words[4], "the camera looks at the point where it stands");
    const Vec3 view = camera.look_at - camera.eye;
    // Parallel vectors that are not multiples of each other to the bit cross to a few rounding errors.
    const Vec3 across = glm::cross(glm::normalize(near_one(view)), glm::normalize(near_one(camera.up)));
    if (glm::length(across) <= gamma(8))
        fail(parser, parser.words[7], "the up direction is parallel to the direction of view");
    if (!(fovy > 0 && fovy < 180))
        fail(parser, parser.words[10],
             "the field of view must be between 0 and 180 degrees, both excluded, not " + shown(fovy));
    // The directions through neighbouring pixels must be different numbers.
    if (fovy < 1e-6) fail(parser, parser.words[10], "the field of view must be at least 1e-6 degrees");
    camera.fovy = radians(fovy);
    parser.has_camera = true;
}

void add_scale(Parser& parser) {
    const Vec3 by = vec3(parser, 1);
    for (std::size_t i = 0; i < 3; ++i)
        if (by[static_cast<int>(i)] == 0)
            fail(parser, parser.words[i + 1], "a scale factor of 0 makes things flat; it must not be 0");
    add_transform(parser, Scale{by});
}

void pop_transform(Parser& parser) {
    if (parser.transform_stack.empty())
        fail(parser, parser.words[0], "'popTransform' without a 'pushTransform' before it");
    parser.transform = parser.transform_stack.back();
    parser.transform_stack.pop_back();
}

void set_attenuation(Parser& parser) {
    parser.attenuation = not_negative3(parser, 1, "attenuation");
    for (std::size_t i = 1; i <= 3; ++i)
        if (number(parser, i) != 0) sized(parser, i, "an attenuation that is not 0");
    if (parser.attenuation == Vec3(0))
        fail(parser, parser.words[1], "attenuation 0 0 0 would divide light by zero");
}

void set_filter(Parser& parser) {
    parser.scene.sampling.filter = choice<Filter>(parser, {{"box", {FilterKind::Box, 0.5}},
                                                           {"tent", {FilterKind::Tent, 1}},
                                                           {"gaussian", {FilterKind::Gaussian, 1.5}},
                                                           {"mitchell", {FilterKind::Mitchell, 2}}});
}

void set_adaptive(Parser& parser) {
    parser.scene.sampling.adaptive = choice<bool>(parser, {{"on", true}, {"off", false}});
    parser.adaptive_place = message_at(parser, parser.words[0].data(), "");
}

void set_version(Parser& parser) {
    if (parser.has_command) fail(parser, parser.words[0], "'version' must be the first command");
    whole_setting(parser, "the version of the language", 1, 1);
}

// The table

Command commands[] = {
    {{"version", "1", "Version of this language; if given, the first command. Scenes of the course say it.",
      "01"},
     set_version},
    {{"size", "w h", "Size of the picture in pixels, each from 1 to 65536; default 640 480.", "01"},
     set_size},
    {{"output", "file",
      "Default name of the picture's file; without blanks. Folders are made below the current one. Of kinds "
      "that are not written, such as `.bmp`, it becomes a `.png` of the same name.",
      "01"},
     [](Parser& p) {
         p.scene.output = p.words[1];
         p.scene.output_place = {p.line_number, static_cast<int>(p.words[1].data() - p.line.data()) + 1};
     }},
    {{"camera", "fx fy fz ax ay az ux uy uz fovy",
      "Look from (fx, fy, fz) at (ax, ay, az), with the up direction (ux, uy, uz) and the vertical field of "
      "view `fovy` in degrees. Every scene needs one.",
      "01"},
     set_camera},
    {{"orthographic", "height",
      "Parallel projection: the picture is `height` world units high; the field of view is not used.", "01"},
     [](Parser& p) {
         p.scene.camera.view_height = sized(p, 1, "the height of the view");
         p.scene.camera.projection = Projection::Orthographic;
     }},
    {{"encoding", "linear|srgb",
      "How 8-bit files store light: as it is (default, as the base language does) or by the sRGB curve.",
      "01"},
     [](Parser& p) {
         p.scene.encoding = choice<Encoding>(p, {{"linear", Encoding::Linear}, {"srgb", Encoding::Srgb}});
     }},
    {{"integrator", "raytrace|flat|directions|normals|uv|rasterize",
      "How rays become colours: `raytrace` (default) is the whole sum of light; `flat` is ambient + "
      "emission; `directions` and `normals` show (x + 1)/2 of unit vectors, `uv` the texture coordinates; "
      "`rasterize` is the z-buffer's `normals`.",
      "01"},
     [](Parser& p) {
         p.scene.integrator = choice<Integrator>(p, {{"raytrace", Integrator::Raytrace},
                                                     {"flat", Integrator::Flat},
                                                     {"directions", Integrator::Directions},
                                                     {"normals", Integrator::Normals},
                                                     {"uv", Integrator::Uv},
                                                     {"rasterize", Integrator::Rasterize}});
     }},
    {{"background", "r g b", "Colour where nothing is hit; default 0 0 0.", "01"},
     [](Parser& p) { p.scene.background = color(p, 1); }},
    {{"plane", "px py pz nx ny nz",
      "Plane through (px, py, pz) with the normal (nx, ny, nz), of any length but 0.", "01"},
     [](Parser& p) {
         add_object(p, Plane{vec3(p, 1), direction(p, 4, "the normal")});
     }},
    {{"ambient", "r g b",
      "For the objects that follow: light that they send whatever the lights; default .2 .2 .2.", "01"},
     [](Parser& p) { p.material.ambient = color(p, 1); }},
    {{"emission", "r g b", "For the objects that follow: light that they send besides; default 0 0 0.", "01"},
     [](Parser& p) { p.material.emission = color(p, 1); }},
    {{"checker", "r g b r g b size",
      "For the objects that follow: two colours that multiply ambient, diffuse and emission, in solid cubes "
      "of the given size in world space. The first where the sum of the floors of x/size, y/size and z/size "
      "is even. `checker 1 1 1 1 1 1 1` is none.",
      "01"},
     [](Parser& p) {
         p.material.checker = {color(p, 1), color(p, 4), sized(p, 7, "the size of the checker's cubes")};
     }},
    {{"sphere", "x y z r", "Sphere with centre (x, y, z) and radius r > 0.", "02"},
     [](Parser& p) {
         add_object(p, Sphere{vec3(p, 1), positive(p, 4, "the radius")});
     }},
    {{"maxverts", "n", "Number of `vertex` lines to expect; accepted for old scenes, and not trusted.", "03"},
     [](Parser& p) { whole(p, 1, "the number of vertices", 0, 0x1p53); }},
    {{"maxvertnorms", "n", "The same for `vertexnormal` lines.", "03"},
     [](Parser& p) { whole(p, 1, "the number of vertices", 0, 0x1p53); }},
    {{"vertex", "x y z", "Appended to the list of vertices, which are counted from 0; not transformed here.",
      "03"},
     [](Parser& p) { p.scene.vertices.push_back(vec3(p, 1)); }},
    {{"tri", "a b c",
      "Triangle of three vertices, counterclockwise seen from the side that its normal points to.", "03"},
     [](Parser& p) { add_triangle(p, false); }},
    {{"vertexnormal", "x y z nx ny nz",
      "Appended to a second list, of vertices with normals, of any length but 0; also counted from 0.", "03"},
     [](Parser& p) {
         p.scene.smooth_vertices.push_back({vec3(p, 1), direction(p, 4, "the normal")});
     }},
    {{"trinormal", "a b c", "Triangle of three vertices of the second list, with interpolated normals.",
      "03"},
     [](Parser& p) { add_triangle(p, true); }},
    {{"polygon", "i j k ...", "Planar polygon of three vertices or more of the first list, in order.", "03"},
     add_polygon},
    {{"mesh", "file.obj",
      "The triangles of a Wavefront file, its path relative to the scene's; the name is without blanks. A "
      "file that several objects name is read once.",
      "03"},
     add_mesh},
    {{"translate", "x y z", "Multiply the current transform on the right by a translation.", "04"},
     [](Parser& p) { add_transform(p, Translate{vec3(p, 1)}); }},
    {{"rotate", "x y z degrees",
      "The same by a rotation about the axis (x, y, z), counterclockwise for who looks against the axis.",
      "04"},
     [](Parser& p) {
         const Vec3 axis = direction(p, 1, "the axis of a rotation");
         add_transform(p, Rotate{axis, radians(number(p, 4))});
     }},
    {{"scale", "x y z", "The same by a scaling; no factor may be 0.", "04"}, add_scale},
    {{"pushTransform", "", "Remember the current transform.", "04"},
     [](Parser& p) { p.transform_stack.push_back(p.transform); }},
    {{"popTransform", "", "Return to the transform remembered last.", "04"}, pop_transform},
    {{"directional", "x y z r g b",
      "Light from infinitely far away; (x, y, z) points towards it. In world space, not attenuated.", "05"},
     [](Parser& p) {
         p.scene.lights.push_back(
             DirectionalLight{direction(p, 1, "the direction to the light"), color(p, 4)});
     }},
    {{"point", "x y z r g b", "Light at (x, y, z) in world space, with the attenuation in force.", "05"},
     [](Parser& p) {
         p.scene.lights.push_back(PointLight{place3(p, 1), color(p, 4), p.attenuation});
     }},
    {{"attenuation", "c l q",
      "For the point lights that follow: light at distance d is divided by c + l·d + q·d²; default 1 0 0.",
      "05"},
     set_attenuation},
    {{"diffuse", "r g b",
      "For the objects that follow: weight of light that is scattered evenly; default 0 0 0.", "05"},
     [](Parser& p) { p.material.diffuse = color(p, 1); }},
    {{"specular", "r g b",
      "For the objects that follow: weight of the highlight and of the mirror direction; default 0 0 0.",
      "05"},
     [](Parser& p) { p.material.specular = color(p, 1); }},
    {{"shininess", "s", "For the objects that follow: exponent of the highlight, at least 0; default 0.",
      "05"},
     [](Parser& p) { p.material.shininess = not_negative(p, 1, "the shininess"); }},
    {{"highlight", "blinn|phong",
      "For the objects that follow: highlight from the half vector (default) or from the reflection vector.",
      "05"},
     [](Parser& p) {
         p.material.highlight =
             choice<Highlight>(p, {{"blinn", Highlight::Blinn}, {"phong", Highlight::Phong}});
     }},
    {{"shadows", "on|off", "Whether things stand in each other's light; default on.", "06"},
     [](Parser& p) {
         p.scene.shadows = choice<bool>(p, {{"on", true}, {"off", false}});
     }},
    {{"maxdepth", "n", "Greatest number of bounces; default 5.", "07"},
     [](Parser& p) {
         p.scene.max_depth =
             static_cast<int>(whole_setting(p, "the number of bounces", 0, std::numeric_limits<int>::max()));
     }},
    {{"mincontribution", "c",
      "Rays whose weight is not greater than c in any channel are not followed; default 0.", "07"},
     [](Parser& p) { p.scene.min_contribution = not_negative(p, 1, "the least contribution"); }},
    {{"transmission", "r g b",
      "For the objects that follow: weight of the refracted ray; default 0 0 0, opaque.", "07"},
     [](Parser& p) { p.material.transmission = not_negative3(p, 1, "transmission"), color(p, 1); }},
    {{"ior", "n", "For the objects that follow: index of refraction inside, greater than 0; default 1.",
      "07"},
     [](Parser& p) { p.material.ior = sized(p, 1, "the index of refraction"); }},
    {{"fresnel", "none|exact|schlick",
      "For the objects that follow: how much light a transparent surface mirrors; default none.", "07"},
     [](Parser& p) {
         p.material.fresnel = choice<Fresnel>(
             p, {{"none", Fresnel::None}, {"exact", Fresnel::Exact}, {"schlick", Fresnel::Schlick}});
     }},
    {{"absorption", "r g b",
      "For the objects that follow: light inside is multiplied by exp(−absorption · distance); default none.",
      "07"},
     [](Parser& p) { p.material.absorption = not_negative3(p, 1, "absorption"); }},
    {{"spp", "n", "Samples a pixel, from 1 to 65536; default 1, which lies in the pixel's centre.", "08"},
     [](Parser& p) {
         p.scene.sampling.count =
             static_cast<int>(whole_setting(p, "the number of samples", 1, most_samples));
     }},
    {{"sampler", "jittered|random|regular|poisson|trapezoid|centered",
      "Where several samples lie: one at random in each of equal cells (default), all at random, in the "
      "middles "
      "of equal cells, at random but none near another, on the corners of cells with the trapezoid rule's "
      "weights, or in the middles and one more at the centre.",
      "08"},
     [](Parser& p) {
         p.scene.sampling.sampler = choice<Sampler>(p, {{"jittered", Sampler::Jittered},
                                                        {"random", Sampler::Random},
                                                        {"regular", Sampler::Regular},
                                                        {"poisson", Sampler::Poisson},
                                                        {"trapezoid", Sampler::Trapezoid},
                                                        {"centered", Sampler::Centered}});
     }},
    {{"adaptive", "on|off",
      "Whether pixels whose colours differ more get more of the samples; `spp` is then their mean number. "
      "For the "
      "samplers `jittered` and `random`; default off.",
      "08"},
     set_adaptive},
    {{"filter", "box|tent|gaussian|mitchell",
      "What samples count for a pixel, by their distance from its centre along each axis: all in the pixel "
      "alike "
      "(default); less and less up to 1 pixel, or 1.5; the cubic of Mitchell and Netravali up to 2.",
      "08"},
     set_filter},
    {{"seed", "n", "Which random numbers are used, from 0 to 2^53 − 1; default 0.", "08"},
     [](Parser& p) {
         p.scene.sampling.seed = static_cast<std::uint64_t>(whole_setting(p, "the seed", 0, 0x1p53 - 1));
     }},
    {{"accelerator", "auto|none|grid|nested",
      "What is built so that a ray need not ask every shape: `nested` a grid of grids over each kind of "
      "shape and "
      "each shared mesh, `grid` a single uniform one, `none` nothing; `auto` (default) whichever of them is "
      "found cheapest by samples and counts, around all shapes of a kind but at most 64 that are far out or "
      "huge. The picture is the same to the bit.",
      "09"},
     [](Parser& p) {
         p.scene.accelerator = choice<Accelerator>(p, {{"auto", Accelerator::Auto},
                                                       {"none", Accelerator::None},
                                                       {"grid", Accelerator::Grid},
                                                       {"nested", Accelerator::Nested}});
     }},
};

/// The commands by name, the number of their arguments counted.
const std::unordered_map<std::string_view, const Command*>& commands_by_name() {
    static const auto by_name = [] {
        std::unordered_map<std::string_view, const Command*> map;
        std::vector<std::string_view> words;
        for (Command& command : commands) {
            split_words(command.text.arguments, words);
            command.any_more = !words.empty() && words.back() == "...";
            command.arguments = words.size() - (command.any_more ? 1 : 0);
            map.emplace(command.text.name, &command);
        }
        return map;
    }();
    return by_name;
}

// Lines

constexpr const char* line_skipped = " (line skipped)";

void unknown_command(const Parser& parser) {
    std::vector<std::string_view> names;
    for (const Command& command : commands) names.push_back(command.text.name);
    const std::string_view word = parser.words[0];
    std::string meaning = meaning_elsewhere(word);
    if (meaning.empty()) meaning = did_you_mean(word, names);
    const std::string what = "unknown command " + quoted(word) + meaning;
    if (!parser.options.lenient) fail(parser, word, what);
    warn(parser, word.data(), what + line_skipped);
}

void check_argument_count(Parser& parser) {
    const std::size_t count = parser.words.size() - 1, needed = parser.command->arguments;
    const auto complaint = [&](const char* adverb) {
        return quoted(parser.words[0]) + " needs " + adverb + std::to_string(needed) +
               (needed == 1 ? " argument" : " arguments") + ", here " + (count == 1 ? "is " : "are ") +
               std::to_string(count) + expected(parser);
    };
    // What is missing is missing behind the last word.
    if (count < needed)
        throw InputError(message_at(parser, parser.words.back().data() + parser.words.back().size(),
                                    complaint(parser.command->any_more ? "at least " : "")));
    if (count == needed || parser.command->any_more) return;
    const std::string_view surplus = parser.words[needed + 1];
    if (!parser.options.lenient) fail(parser, surplus, complaint(""));
    warn(parser, surplus.data(), complaint("") + " (the rest of the line is skipped)");
    parser.words.resize(needed + 1);
}

void parse_line(Parser& parser) {
    if (parser.line.size() > longest_line)
        fail(parser, parser.line, "the line is longer than a megabyte: this does not look like a scene file");
    if (const char* const comment = split_words(parser.line, parser.words))
        warn(parser, comment, std::string(comment_inside_word));
    if (parser.words.empty()) return;
    const auto found = commands_by_name().find(parser.words[0]);
    if (found == commands_by_name().end()) return unknown_command(parser);
    parser.command = found->second;
    check_argument_count(parser);
    try {
        parser.command->handle(parser);
    } catch (const UnknownValue& problem) {
        if (!parser.options.lenient) throw;
        if (parser.options.warnings)
            parser.options.warnings->push_back(problem.what() + std::string(line_skipped));
    }
    parser.has_command = true;
}

}  // namespace

Scene parse_scene_text(std::string_view text, const std::string& name, const std::filesystem::path& directory,
                       const ParseOptions& options) {
    text = without_bom(text);
    check_is_text(text, name);

    Parser parser{options, directory};
    parser.scene.file = name;
    while (!text.empty()) {
        parser.line = take_line(text);
        ++parser.line_number;
        parse_line(parser);
    }
    if (!parser.has_camera)
        throw InputError(
            name + ":" + std::to_string(std::max(parser.line_number, 1)) +
            ":1: no camera in the whole file; expected somewhere: camera fx fy fz ax ay az ux uy uz fovy");
    const Sampling& sampling = parser.scene.sampling;
    if (sampling.adaptive && sampling.sampler != Sampler::Jittered && sampling.sampler != Sampler::Random)
        throw InputError(
            parser.adaptive_place +
            "'adaptive on' needs 'sampler jittered' or 'sampler random': the other patterns have a "
            "given number of samples");
    return std::move(parser.scene);
}

Scene parse_scene(const std::filesystem::path& file, const ParseOptions& options) {
    return parse_scene_text(read_text(file, file.string()), file.string(), file.parent_path(), options);
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& file, const Scene& scene) {
    std::vector<std::filesystem::path> files{file};
    for (const Mesh& mesh : scene.meshes) files.push_back(file.parent_path() / mesh.file);
    return files;
}

const std::vector<SceneCommand>& scene_commands() {
    static const std::vector<SceneCommand> list = [] {
        std::vector<SceneCommand> all;
        for (const Command& command : commands) all.push_back(command.text);
        return all;
    }();
    return list;
}

std::string scene_command_table() {
    std::string table = "| command | meaning | chapter |\n|---|---|---|\n";
    for (const SceneCommand& command : scene_commands()) {
        std::string line(command.name);
        if (!command.arguments.empty()) line.append(" ").append(command.arguments);
        // A bar would end the cell, even inside `…`.
        for (std::size_t bar = 0; (bar = line.find('|', bar)) != std::string::npos; bar += 2)
            line.insert(bar, "\\");
        table.append("| `")
            .append(line)
            .append("` | ")
            .append(command.meaning)
            .append(" | ")
            .append(command.chapter);
        table += " |\n";
    }
    return table;
}

}  // namespace rt
