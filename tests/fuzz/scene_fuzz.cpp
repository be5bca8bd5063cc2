// The whole way of a scene under libFuzzer: parse, compile, render, export. Whatever the text, out comes a
// picture, the same with one thread and with two, or an InputError of one line. README.md beside this file
// says how to run it.
#include "common/povray/export.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/render/snapshots.hpp"
#include "common/scene/parse.hpp"
#include "tests/fuzz/must.hpp"

#include <algorithm>
#include <cstring>

namespace {

using rt::fuzz::require;

/// So few pixels, samples and bounces that a scene takes a moment.
void make_quick(rt::Scene& scene) {
    scene.width = std::min(scene.width, 9);
    scene.height = std::min(scene.height, 7);
    scene.max_depth = std::min(scene.max_depth, 3);
    scene.sampling.count = std::min(scene.sampling.count, 4);
    scene.light_samples.count = std::min(scene.light_samples.count, 4);
}

bool same_bits(const rt::Image& a, const rt::Image& b) {
    return a.width == b.width && a.height == b.height && a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(rt::Vec3)) == 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    rt::fuzz::must_read_or_refuse([&] {
        rt::Scene scene = rt::parse_scene_text(text, "fuzz", {}, {.lenient = true, .files = false});
        make_quick(scene);
        rt::fuzz::must_read_or_refuse(
            [&] { require(!rt::export_povray(scene, rt::snapshots_of(scene)).empty()); });
        const rt::World world = rt::compile(scene);
        const rt::Image image = rt::render(world, {.threads = 1}).image;
        require(image.width == scene.width && image.height == scene.height);
        require(same_bits(image, rt::render(world, {.threads = 2}).image));
    });
    return 0;
}
