// POV-Ray adds to the normal what a pattern has at four points around: the sum of (value · corner) over the
// corners of a tetrahedron, `accuracy` away. Here they are so far away that the function can tell which of
// the four it is asked for, and takes it back: so what is added is any vector that is a function of the
// point.
#include "common/povray/bumps.hpp"

#include "common/povray/camera.hpp"
#include "common/povray/noise_text.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/places.hpp"
#include "common/povray/refuse.hpp"

namespace rt::povray {
namespace {

/// A power of two in single precision, much farther than anything in the scene, so that signs tell the
/// corners; near enough to keep 1e-11 of the point.
constexpr Real far_corner = 0x1p17;

/// A pattern's values are in [0, 1]: ½ + part · (the vector's product with the corner). The halves cancel.
constexpr Real part = 0.1875;

/// chapters/11_textures/bump.hpp says what they do. m: the bumped normal, g: POV-Ray's, v: to the viewer, a:
/// a corner. Of the way from m to g the first good point solves a quadratic equation.
constexpr std::string_view functions =
    R"(#declare Dot = function(ax, ay, az, bx, by, bz) { ax * bx + ay * by + az * bz }
#declare Long = function(x, y, z) { sqrt(x * x + y * y + z * z) }
#declare BumpX = function(x, y, z, gx, gy, gz, ax, ay, az) {
  Dot(x, y, z, ax, ay, az) / Long(x, y, z) - Dot(gx, gy, gz, ax, ay, az) }
#declare BumpW = function(mx, my, mz, gx, gy, gz, ax, ay, az, f) {
  BumpX(mx + f * (gx - mx), my + f * (gy - my), mz + f * (gz - mz), gx, gy, gz, ax, ay, az) }
#declare BumpRoot = function(a, b, c) { select(c, -2 * c / (b + sqrt(max(b * b - 4 * a * c, 0))), 0) }
#declare BumpV = function(mx, my, mz, gx, gy, gz, ax, ay, az, mv, mg, gv) {
  BumpW(mx, my, mz, gx, gy, gz, ax, ay, az,
    BumpRoot(2 * (1 - mg) * (gv - mv - 1.015625 * gv),
      2 * (mv * (1 - mg) + (gv - mv) * mg + 1.015625 * gv * (1 - mg)), 2 * mv * mg - 1.015625 * gv)) }
#declare BumpU = function(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az) {
  BumpV(mx, my, mz, gx, gy, gz, ax, ay, az, Dot(mx, my, mz, vx, vy, vz), Dot(mx, my, mz, gx, gy, gz),
    Dot(gx, gy, gz, vx, vy, vz)) }
#declare BumpT = function(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az, l) {
  BumpU(mx / l, my / l, mz / l, gx, gy, gz, vx, vy, vz, ax, ay, az) }
#declare BumpR = function(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az) {
  BumpT(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az, Long(mx, my, mz)) }
#declare BumpS = function(sx, sy, sz, gx, gy, gz, vx, vy, vz, ax, ay, az, k) {
  BumpR(gx - sx + k * gx, gy - sy + k * gy, gz - sz + k * gz, gx, gy, gz, vx, vy, vz, ax, ay, az) }
#declare Bump = function(sx, sy, sz, gx, gy, gz, vx, vy, vz, ax, ay, az) {
  BumpS(sx, sy, sz, gx, gy, gz, vx, vy, vz, ax, ay, az, Dot(sx, sy, sz, gx, gy, gz)) }
)";

/// Three texts, one an axis, with commas between.
template <class Text>
std::string three(Text text) {
    return text(0) + ", " + text(1) + ", " + text(2);
}

std::string to_viewer_text(const Writer& out) {
    const Camera& camera = out.scene.camera;
    if (camera.projection == Projection::Orthographic) {
        const Vec3 back = to_viewer(out);
        return three([&](int i) { return number(back[i]); });
    }
    const auto away = [&](int i) { return fmt::format("({} - {})", number(camera.eye[i]), "xyz"[i]); };
    return three([&](int i) { return fmt::format("{} / Long({})", away(i), three(away)); });
}

/// Bumps whose normal is turned inwards would be dents here.
bool sees_back(const Scene& scene, const Object& object) {
    const auto* plane = std::get_if<Plane>(&object.shape);
    return plane && surrounds_eye(scene, object);
}

}  // namespace

const Bumps* bumps_of(const Scene& scene, const Material& m) {
    if (m.texturing < 0) return nullptr;
    const Bumps& bumps = scene.texturings[static_cast<std::size_t>(m.texturing)].bumps;
    return bumps.height == 0 ? nullptr : &bumps;
}

void write_bump_functions(Writer& out) {
    write_noise_slope(out);
    out.line("{}", functions);
    // Which corner it is, to the digits of POV-Ray's source.
    const std::string half = number(far_corner / 2);
    out.line(
        "#declare CornerX = function(x, y, z) {{ select(y - {0}, select(x - {0}, -0.471404521, 0.942809041), "
        "0) }}",
        half);
    out.line("#declare CornerY = function(x, y, z) {{ select(y - {}, -0.333333333, 1) }}", half);
    out.line(
        "#declare CornerZ = function(x, y, z) {{ select(y - {0}, select(x - {0}, select(z, -0.816496581, "
        "0.816496581), 0), 0) }}\n",
        half);
}

std::string write_bumps(Writer& out, const Object& object, std::size_t id) {
    const Scene& scene = out.scene;
    const Bumps* bumps = bumps_of(scene, scene.materials[object.material]);
    if (!bumps) return "";
    if (!write_outward(out, object, id))
        refuse(scene, object, "bumps on a shape whose normals a point does not tell");
    const Real steep = bumps->height / bumps->size;
    const Real turn = sees_back(scene, object) ? -1 : 1;
    const std::string place =
        three([&](int i) { return fmt::format("{} / {}", "xyz"[i], number(bumps->size)); });
    const auto slope = [&](int i) {
        return fmt::format("{} * NoiseSlope({}, {}, {}, {})", number(turn * steep), place, int(i == 0),
                           int(i == 1), int(i == 2));
    };
    const auto outward = [&](int i) {
        return fmt::format("{}Out{}{}(x, y, z)", turn < 0 ? "-" : "", "XYZ"[i], id);
    };
    out.line("#declare Bump{} = function(x, y, z, ax, ay, az) {{ Bump({}, {}, {}, ax, ay, az) }}", id,
             three(slope), three(outward), to_viewer_text(out));
    out.line(
        "#declare BumpFrom{0} = function(x, y, z, ax, ay, az) {{ Bump{0}(x - {1} * ax, y - {1} * ay, z - {1} "
        "* az, "
        "ax, ay, az) }}",
        id, number(far_corner));
    return fmt::format(
        " normal {{ function {{ 0.5 + {} * BumpFrom{}(x, y, z, CornerX(x, y, z), CornerY(x, y, z), "
        "CornerZ(x, y, z)) }} {} accuracy {} }}",
        number(part), id,
        // POV-Ray makes -0.1/accuracy of 1; the sum of corner · cornerᵀ is 4/3.
        number(-10 * far_corner * 0.75 / part), number(far_corner));
}

}  // namespace rt::povray
