// Pictures beside another renderer's: what Blender's Cycles draws of the scenes in tests/common/cycles. Its
// pictures are kept there, so that no test needs Blender.
#include "common/image/file.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;

namespace {

/// The mean of several pictures, and the square of the standard error of each of its numbers.
struct Mean {
    Image mean, squares;
};

Mean by_cycles(const std::string& name) {
    const std::string file = test::repository() + "/tests/common/cycles/" + name;
    Mean result{read_image(file + ".pfm"), read_image(file + ".error.pfm")};
    for (Vec3& error : result.squares.pixels) error *= error;
    return result;
}

Scene scene_named(const std::string& name) {
    return parse_scene(test::repository() + "/tests/common/cycles/" + name + ".scene");
}

/// As many samples as Cycles took; fewer where each casts further rays.
Mean by_us(Scene scene) {
    constexpr int pictures = 8;
    Mean result{make_image(scene.width, scene.height), make_image(scene.width, scene.height)};
    std::vector<Image> all;
    scene.sampling.count = scene.integrator == Integrator::Flat ? 256 : 64;
    RenderOptions options;
    options.estimate = false;
    for (int i = 0; i < pictures; ++i) {
        scene.sampling.seed = static_cast<std::uint64_t>(i + 1);
        all.push_back(render(compile(scene), options).image);
    }
    for (std::size_t i = 0; i < result.mean.pixels.size(); ++i) {
        Vec3& mean = result.mean.pixels[i];
        for (const Image& image : all) mean += image.pixels[i] / Real(pictures);
        for (const Image& image : all) {
            const Vec3 off = image.pixels[i] - mean;
            result.squares.pixels[i] += off * off / Real(pictures * (pictures - 1));
        }
    }
    return result;
}

/// By how many of their standard errors the two differ over the pixels from `low` up to `high`. Single
/// precision may have turned each block by 3e-5 of itself.
Vec3 errors_apart(const Mean& a, const Mean& b, const std::array<int, 2>& low,
                  const std::array<int, 2>& high) {
    Vec3 off(0), squares(0), sum(0);
    for (int y = low[1]; y < high[1]; ++y)
        for (int x = low[0]; x < high[0]; ++x) {
            off += pixel(a.mean, x, y) - pixel(b.mean, x, y);
            squares += pixel(a.squares, x, y) + pixel(b.squares, x, y);
            sum += pixel(a.mean, x, y);
        }
    const Vec3 rounding = Real(3e-5) * sum;
    const Vec3 error = glm::sqrt(squares + rounding * rounding);
    // Where both are black nothing is to be compared.
    return {error.x > 0 ? off.x / error.x : 0, error.y > 0 ? off.y / error.y : 0,
            error.z > 0 ? off.z / error.z : 0};
}

struct Apart {
    Real picture = 0;         ///< of the whole picture, the worst channel
    Real rms = 0, worst = 0;  ///< of its blocks of 8 × 8 pixels
};

Apart apart(const Mean& a, const Mean& b) {
    Apart result;
    const int width = a.mean.width, height = a.mean.height;
    const Vec3 all = errors_apart(a, b, {0, 0}, {width, height});
    result.picture = max_component(glm::abs(all));
    Real squares = 0;
    int count = 0;
    for (int y = 0; y < height; y += 8)
        for (int x = 0; x < width; x += 8, ++count) {
            const Vec3 one = errors_apart(a, b, {x, y}, {x + 8, y + 8});
            squares += dot(one, one) / 3;
            result.worst = std::max(result.worst, max_component(glm::abs(one)));
        }
    result.rms = std::sqrt(squares / count);
    return result;
}

bool agree(const Apart& by) { return by.picture <= 4 && by.rms <= 1.3 && by.worst <= 4.5; }

std::string said(const Apart& by) {
    return "standard errors apart: the picture " + std::to_string(by.picture) + ", its blocks " +
           std::to_string(by.rms) + " in the mean and " + std::to_string(by.worst) + " at most";
}

}  // namespace

TEST_CASE("soft shadows, a lens, motion, highlights and rough mirrors are those of Cycles", "[cycles]") {
    // Random numbers are fixed: a picture that agrees does so always. Of right pairs with others, whose z are
    // normal, a picture's three channels are beyond 4 once in 5,000, and of 36 blocks one beyond 4.5 once in
    // 4,000.
    for (const std::string name : {"shadow", "lens", "motion", "highlights", "mirror"}) {
        const Apart by = apart(by_us(scene_named(name)), by_cycles(name));
        INFO(name << ", " << said(by));
        CHECK(agree(by));
    }
}

TEST_CASE("what is not as it should be is not that of Cycles", "[cycles]") {
    const auto differs = [](const std::string& name, const char* changed, auto change) {
        Scene scene = scene_named(name);
        change(scene);
        const Apart by = apart(by_us(scene), by_cycles(name));
        INFO(name << ", " << changed << ", " << said(by));
        CHECK_FALSE(agree(by));
    };
    differs("shadow", "the eye is higher", [](Scene& s) { s.camera.eye.y += 0.02; });
    differs("shadow", "the lamp is brighter", [](Scene& s) { s.area_lights[0].light.radiance *= 1.01; });
    differs("lens", "the lens is larger", [](Scene& s) { s.lens.radius *= 1.1; });
    differs("lens", "its focus is farther", [](Scene& s) { s.lens.distance *= 1.1; });
    differs("motion", "the ball is slower", [](Scene& s) {
        for (Object& object : s.objects) object.motion *= 0.97;
    });
    differs("motion", "the shutter opens slowly", [](Scene& s) { s.shutter.opening = 0.2; });
    differs("highlights", "rougher", [](Scene& s) {
        for (Finish& finish : s.finishes) finish.roughness *= 1.02;
    });
    differs("mirror", "rougher", [](Scene& s) {
        for (Finish& finish : s.finishes) finish.roughness *= 1.04;
    });
}
