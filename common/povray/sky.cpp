// Irradiance is a quadratic polynomial of the normal: a sum of squares and of products with fixed directions.
// POV-Ray's `slope` is 1/2 + asin(n·d)/π; a sine wave of it is n·d, or its square.
#include "common/povray/sky.hpp"

#include "chapters/11_textures/harmonics.hpp"
#include "common/povray/picture_text.hpp"
#include "common/povray/refuse.hpp"

#include <array>
#include <cmath>

namespace rt::povray {
namespace {

void write_pigment(Writer& out, const GradientSky& sky) {
    out.line(
        "sky_sphere {{ pigment {{ function {{ 0.5 + 0.5 * y }} color_map {{ [0 {}] [0.5 {}] [1 {}] }} }} }}",
        rgb(sky.nadir), rgb(sky.horizon), rgb(sky.zenith));
}

void write_pigment(Writer& out, const ConstantSky& sky) {
    out.line("sky_sphere {{ pigment {{ {} }} }}", rgb(sky.color));
}

/// chapters/11_textures/sky.hpp has the formulas.
void write_pigment(Writer& out, const ImageSky& sky) {
    const Lookup lookup = lookup_of(out.scene, sky);
    write_lookup(out, lookup);
    const auto [c, s] = sky.turn;
    out.line("#declare SkyX = function {{ {} * x - {} * z }}", number(c), number(s));
    out.line("#declare SkyZ = function {{ {} * x + {} * z }}", number(s), number(c));
    if (sky.map == SkyMap::LatitudeLongitude) {
        out.line("#declare SkyU = function {{ atan2(SkyZ(x, y, z), SkyX(x, y, z)) / (2 * pi) }}");
        out.line("#declare SkyV = function {{ 0.5 + atan2(y, sqrt(x * x + z * z)) / pi }}");
    } else {
        // Half the distance from the middle, over that of (x, y).
        out.line("#declare SkyFar = function(x, y, z) {{ {} / max(sqrt(x * x + y * y), 1e-300) }}",
                 sky.map == SkyMap::MirrorBall ? "0.5 * sin(atan2(sqrt(x * x + y * y), z) / 2)"
                                               : "0.5 * atan2(sqrt(x * x + y * y), -z) / pi");
        out.line("#declare SkyOut = function {{ SkyFar(SkyX(x, y, z), y, SkyZ(x, y, z)) }}");
        out.line("#declare SkyU = function {{ 0.5 + SkyOut(x, y, z) * SkyX(x, y, z) }}");
        out.line("#declare SkyV = function {{ 0.5 + SkyOut(x, y, z) * y }}");
    }
    out.line("sky_sphere {{ pigment {{ average pigment_map {{");
    const Real greatest = brightest(out.scene, lookup);
    for (int i = 0; i < 3; ++i) {
        Vec3 color(0);
        color[i] = 3 * greatest;
        out.line("  [function {{ {}{}(SkyU(x, y, z), SkyV(x, y, z)) }} color_map {{ [0 rgb 0] [1 {}] }}]",
                 name_of(lookup), channel_names[i], rgb(color));
    }
    out.line("}} }} }}");
}

/// E(n)/π = constant + Σ linear_i · n_i + Σ square_k · (n · d_k)²
struct Irradiance {
    Vec3 constant{0};
    std::array<Vec3, 3> linear{};
    std::array<Vec3, 6> square{};
};

constexpr std::array<std::array<int, 3>, 6> directions{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};

Irradiance irradiance_of(const SkyLight& light) {
    // Coefficients of Y₀₀; Y₁₋₁, Y₁₀, Y₁₁; Y₂₋₂, Y₂₋₁, Y₂₀, Y₂₁, Y₂₂, each times its factor; over π.
    const auto& k = light.coefficients;
    const Real c0 = std::sqrt(1 / pi) / 2, c1 = std::sqrt(3 / pi) / 3, c2 = std::sqrt(15 / pi) / 8,
               c20 = std::sqrt(5 / pi) / 16;
    const Vec3 xy = c2 * k[4], yz = c2 * k[5], xz = c2 * k[7], zz = 3 * c20 * k[6], xx = c2 / 2 * k[8];
    Irradiance e;
    e.constant = c0 * k[0] - c20 * k[6];
    e.linear = {c1 * k[3], c1 * k[1], c1 * k[2]};
    // xy = (n·d)² − (x² + y²)/2 with d halfway between the axes.
    e.square = {xx - (xy + xz) / Real(2), -xx - (xy + yz) / Real(2), zz - (yz + xz) / Real(2), xy, yz, xz};
    return e;
}

/// Chapter 11 takes negative light for none; that is no polynomial.
void refuse_negative(const Scene& scene, const SkyLight& light) {
    constexpr int steps = 64;
    for (int j = 0; j <= steps; ++j)
        for (int i = 0; i < 2 * steps; ++i) {
            const Real polar = pi * j / steps, azimuth = pi * i / steps;
            const Vec3 e = irradiance(light, {std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                              std::sin(polar) * std::sin(azimuth)});
            for (int c = 0; c < 3; ++c)
                if (e[c] == 0 && !(light.coefficients[0][c] == 0))
                    refuse(scene, "skylight so uneven that its harmonics are negative somewhere");
        }
}

}  // namespace

void write_sky_sphere(Writer& out) {
    if (!out.scene.sky || !row_of(out.scene.integrator).objects) return;
    std::visit([&](const auto& sky) { write_pigment(out, sky); }, *out.scene.sky);
    out.line("");
}

bool has_skylight(const Scene& scene) {
    return scene.sky && scene.skylight && row_of(scene.integrator).lights;
}

std::string skylight_pigment(const Scene& scene, const Vec3& diffuse, std::string_view more) {
    const SkyLight light = sky_light(*scene.sky);
    refuse_negative(scene, light);
    const Irradiance e = irradiance_of(light);
    // The mean of 16, a power of two, so that what shines through stays what it is.
    const Vec3 scale = Real(16) * diffuse;
    const auto colored = [&](const Vec3& color) { return rgb(scale * color) + std::string(more); };
    std::string text =
        fmt::format("average pigment_map {{\n  [1 {}]\n  [6 {}]", colored(e.constant), colored(Vec3(0)));
    for (std::size_t i = 0; i < 3; ++i)
        text += fmt::format(
            "\n  [1 slope {{ {} }} color_map {{ [0 {}] [1 {}] }} sine_wave frequency 0.5 phase 0.25]",
            "xyz"[i], colored(e.linear[i]), colored(-e.linear[i]));
    for (std::size_t k = 0; k < 6; ++k)
        text += fmt::format(
            "\n  [1 slope {{ <{}, {}, {}> }} color_map {{ [0 {}] [1 {}] }} sine_wave frequency -1 phase "
            "0.25]",
            directions[k][0], directions[k][1], directions[k][2], colored(Vec3(0)), colored(e.square[k]));
    return text + " }";
}

}  // namespace rt::povray
