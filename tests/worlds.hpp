// Worlds and pictures from the text of a scene.
#pragma once

#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

namespace rt::test {

/// The world of a scene that is named test.scene and finds its meshes in `directory`.
inline World world_of(const std::string& text, const std::filesystem::path& directory = scratch_directory()) {
    return compile(parse_scene_text(text, "test.scene", directory));
}

inline Image picture_of(const std::string& text) { return render(world_of(text)).image; }

/// How many pixels differ by more than `bound` in some channel; of images of different sizes, all do.
inline std::size_t differing(const Image& a, const Image& b, Real bound = 0) {
    if (a.width != b.width || a.height != b.height) return std::max(a.pixels.size(), b.pixels.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        count += !(max_component(glm::abs(a.pixels[i] - b.pixels[i])) <= bound);
    }
    return count;
}

}  // namespace rt::test
