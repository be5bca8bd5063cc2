// POV-Ray's functions have neither lists nor names for what is in between: a list is a colour map that is
// read in the middles of its steps, and what is used twice is a function's parameter.
#include "common/povray/noise_text.hpp"

#include "chapters/11_textures/noise.hpp"

namespace rt::povray {
namespace {

/// A colour map of 256 entries, of which number i is at (i + ½)/256. It is asked between 0 and 1 only:
/// beyond, POV-Ray goes on after 1.00001.
template <class Color>
std::string table(Color color) {
    std::string text = "function { pigment { gradient x color_map {";
    for (int i = 0; i < 256; ++i)
        text += fmt::format("{}[{} {}]", i % 8 == 0 ? "\n  " : " ", number((i + 0.5) / 256), rgb(color(i)));
    return text + " } } }";
}

/// The gradient that belongs to a number of the last permutation, as a colour: 0, ½ and 1 are −1, 0 and 1.
/// Perlin's permutation of the number is already in it.
Vec3 gradient_color(int i) {
    const int hash = noise_permutation[static_cast<std::size_t>(i)] & 15;
    // Of the 16 directions four are there twice.
    constexpr int directions[16][3] = {
        {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
        {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1}};
    const auto& d = directions[hash];
    return (Vec3(d[0], d[1], d[2]) + Real(1)) / Real(2);
}

constexpr std::string_view functions = R"(
#declare Entry = function(x) { (x + 0.5) / 256 - floor((x + 0.5) / 256) }
#declare Permuted = function(x) { floor(PermutedTable(Entry(x), 0, 0).red * 255 + 0.5) }
#declare GradientX = function(x) { floor(GradientTable(Entry(x), 0, 0).red * 2 + 0.5) - 1 }
#declare GradientY = function(x) { floor(GradientTable(Entry(x), 0, 0).green * 2 + 0.5) - 1 }
#declare GradientZ = function(x) { floor(GradientTable(Entry(x), 0, 0).blue * 2 + 0.5) - 1 }
#declare Corner = function(h, x, y, z) { GradientX(h) * x + GradientY(h) * y + GradientZ(h) * z }
#declare Fade = function(x) { x * x * x * (x * (x * 6 - 15) + 10) }
#declare Mix = function(f, a, b) { a + f * (b - a) }
#declare MixAll = function(aa, ba, ab, bb, ca, da, cb, db, fu, fv, fw) {
  Mix(fw, Mix(fv, Mix(fu, aa, ba), Mix(fu, ab, bb)), Mix(fv, Mix(fu, ca, da), Mix(fu, cb, db))) }
#declare NoiseH = function(aa, ab, ba, bb, fu, fv, fw, x, y, z) {
  MixAll(Corner(aa, x, y, z), Corner(ba, x - 1, y, z), Corner(ab, x, y - 1, z), Corner(bb, x - 1, y - 1, z),
    Corner(aa + 1, x, y, z - 1), Corner(ba + 1, x - 1, y, z - 1), Corner(ab + 1, x, y - 1, z - 1),
    Corner(bb + 1, x - 1, y - 1, z - 1), fu, fv, fw) }
#declare NoiseA = function(a, b, i, x, y, z) {
  NoiseH(Permuted(a) + i, Permuted(a + 1) + i, Permuted(b) + i, Permuted(b + 1) + i, Fade(x), Fade(y),
    Fade(z), x, y, z) }
#declare NoiseI = function(i, j, k, x, y, z) {
  NoiseA(Permuted(i) + j, Permuted(i + 1) + j, k, x - i, y - j, z - k) }
#declare Noise = function(x, y, z) { NoiseI(floor(x), floor(y), floor(z), x, y, z) }
)";

constexpr std::string_view slope_functions = R"(#declare Rise = function(x) { 30 * x * x * (x - 1) * (x - 1) }
#declare SlopeW = function(aa, ba, ab, bb, ca, da, cb, db, fu, fv, fw, x, y, z, ax, ay, az) {
  ax * Rise(x) * Mix(fw, Mix(fv, ba - aa, bb - ab), Mix(fv, da - ca, db - cb)) +
  ay * Rise(y) * Mix(fw, Mix(fu, ab - aa, bb - ba), Mix(fu, cb - ca, db - da)) +
  az * Rise(z) * Mix(fv, Mix(fu, ca - aa, da - ba), Mix(fu, cb - ab, db - bb)) }
#declare SlopeH = function(aa, ab, ba, bb, fu, fv, fw, x, y, z, ax, ay, az) {
  MixAll(Corner(aa, ax, ay, az), Corner(ba, ax, ay, az), Corner(ab, ax, ay, az), Corner(bb, ax, ay, az),
    Corner(aa + 1, ax, ay, az), Corner(ba + 1, ax, ay, az), Corner(ab + 1, ax, ay, az),
    Corner(bb + 1, ax, ay, az), fu, fv, fw) +
  SlopeW(Corner(aa, x, y, z), Corner(ba, x - 1, y, z), Corner(ab, x, y - 1, z), Corner(bb, x - 1, y - 1, z),
    Corner(aa + 1, x, y, z - 1), Corner(ba + 1, x - 1, y, z - 1), Corner(ab + 1, x, y - 1, z - 1),
    Corner(bb + 1, x - 1, y - 1, z - 1), fu, fv, fw, x, y, z, ax, ay, az) }
#declare SlopeA = function(a, b, i, x, y, z, ax, ay, az) {
  SlopeH(Permuted(a) + i, Permuted(a + 1) + i, Permuted(b) + i, Permuted(b + 1) + i, Fade(x), Fade(y),
    Fade(z), x, y, z, ax, ay, az) }
#declare SlopeI = function(i, j, k, x, y, z, ax, ay, az) {
  SlopeA(Permuted(i) + j, Permuted(i + 1) + j, k, x - i, y - j, z - k, ax, ay, az) }
#declare NoiseSlope = function(x, y, z, ax, ay, az) {
  SlopeI(floor(x), floor(y), floor(z), x, y, z, ax, ay, az) }
)";

}  // namespace

void write_noise(Writer& out) {
    out.line("#declare PermutedTable = {}",
             table([](int i) { return Vec3(noise_permutation[static_cast<std::size_t>(i)]) / Real(255); }));
    out.text += fmt::format("#declare GradientTable = {}", table(gradient_color));
    out.line("{}", functions);
}

void write_noise_slope(Writer& out) { out.line("{}", slope_functions); }

}  // namespace rt::povray
