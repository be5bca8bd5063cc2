// Commands of the picture: the language's version, size, file, camera and background.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"
#include "common/scene/range.hpp"
#include "common/scene/text.hpp"

#include "common/math/error.hpp"

#include <algorithm>

namespace rt::language {

namespace {

constexpr Word<Encoding> encodings[] = {{"linear", Encoding::Linear}, {"srgb", Encoding::Srgb}};

void set_version(Parser& parser) {
    if (parser.has_command) fail(parser, parser.words[0], "'version' must be the first command");
    whole_setting(parser, "the version of the language", 1, 1);
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

void set_output(Parser& parser) {
    parser.scene.output = parser.words[1];
    parser.scene.output_place = place_of(parser, parser.words[1]);
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

void set_orthographic(Parser& parser) {
    parser.scene.camera.view_height = sized(parser, 1, "the height of the view");
    parser.scene.camera.projection = Projection::Orthographic;
}

const CommandRow rows[] = {
    {{"version", "1", "Version of this language; if given, the first command. Scenes of the course say it.",
      "01"},
     set_version},
    {{"size", "w h", "Size of the picture in pixels, each from 1 to 65536; default 640 480.", "01"},
     set_size},
    {{"output", "file",
      "Default name of the picture's file; without blanks. Folders are made below the current one. Of kinds "
      "that are not written, such as `.bmp`, it becomes a `.png` of the same name.",
      "01"},
     set_output},
    {{"camera", "fx fy fz ax ay az ux uy uz fovy",
      "Look from (fx, fy, fz) at (ax, ay, az), with the up direction (ux, uy, uz) and the vertical field of "
      "view `fovy` in degrees. Every scene needs one.",
      "01"},
     set_camera},
    {{"orthographic", "height",
      "Parallel projection: the picture is `height` world units high; the field of view is not used.", "01"},
     set_orthographic},
    {{"encoding", alternatives(encodings),
      "How 8-bit files store light: as it is (default, as the base language does) or by the sRGB curve.",
      "01"},
     [](Parser& p) { p.scene.encoding = choice(p, encodings); }},
    {{"background", "r g b", "Colour where nothing is hit; default 0 0 0.", "01"},
     [](Parser& p) { p.scene.background = color(p, 1); }},
};

}  // namespace

std::span<const CommandRow> picture_commands() { return rows; }

void require_camera(const Parser& parser) {
    if (parser.has_camera) return;
    throw InputError(
        at_place(parser.scene.file, std::max(parser.line_number, 1), 1,
                 "no camera in the whole file; expected somewhere: camera fx fy fz ax ay az ux uy uz fovy"));
}

}  // namespace rt::language
