// The scene parser under libFuzzer: whatever the bytes, out comes a scene or an InputError of one
// line. README.md beside this file says how to build and run it.
#include "common/scene/parse.hpp"
#include "tests/fuzz/must.hpp"

namespace {

using rt::fuzz::require;

/// What every scene promises to those who read it.
void check_scene(const rt::Scene& scene) {
    require(scene.width >= 1 && scene.width <= 65536 && scene.height >= 1 && scene.height <= 65536);
    require(scene.camera.eye != scene.camera.look_at);
    for (const rt::Object& object : scene.objects) {
        require(object.material < scene.materials.size());
        require(object.transform < static_cast<int>(scene.transforms.size()));
        if (const auto* triangle = std::get_if<rt::TriangleObject>(&object.shape))
            for (const std::uint32_t vertex : triangle->vertex)
                require(vertex < (triangle->smooth ? scene.smooth_vertices.size() : scene.vertices.size()));
        if (const auto* polygon = std::get_if<rt::PolygonObject>(&object.shape)) {
            require(polygon->vertex.size() >= 3);
            for (const std::uint32_t vertex : polygon->vertex) require(vertex < scene.vertices.size());
        }
    }
    for (std::size_t i = 0; i < scene.transforms.size(); ++i)
        require(scene.transforms[i].parent < static_cast<int>(i));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const bool lenient : {false, true})
        rt::fuzz::must_read_or_refuse([&] {
            std::vector<std::string> warnings;
            check_scene(rt::parse_scene_text(text, "fuzz", {},
                                             {.lenient = lenient, .files = false, .warnings = &warnings}));
        });
    return 0;
}
