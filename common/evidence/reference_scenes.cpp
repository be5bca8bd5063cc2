// The scenes that have reference pictures, and the files that belong to each.
#include "common/evidence/reference_scenes.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Names of a chapter's scene files: those that it lists, in its order, then all others.
std::vector<std::string> scene_files(const fs::path& directory, const Chapter& chapter) {
    std::vector<std::string> files = chapter.scenes;
    for (const std::string& file : files)
        if (!fs::exists(directory / file))
            throw InputError(fmt::format("chapters/{}/chapter.json: references/{}/{} does not exist",
                                         chapter.name, chapter.name, file));
    for (const fs::path& path : files_in(directory, {".scene"}))
        if (const std::string file = path.filename().string();
            std::ranges::find(chapter.scenes, file) == chapter.scenes.end())
            files.push_back(file);
    return files;
}

}  // namespace

std::vector<ReferenceScene> reference_scenes(const Project& project, const Chapter& chapter) {
    const fs::path directory = project.root / "references" / chapter.name;
    std::vector<ReferenceScene> scenes;
    for (const std::string& file : scene_files(directory, chapter)) {
        ReferenceScene scene;
        scene.chapter = chapter.name;
        scene.name = fs::path(file).stem().string();
        scene.scene = directory / file;
        scene.pov = directory / (scene.name + ".pov");
        scene.picture = directory / (scene.name + ".hdr");
        if (!fs::exists(scene.picture)) scene.picture.replace_extension(".png");
        if (const fs::path why = directory / (scene.name + ".why"); fs::exists(why)) {
            scene.why_none = read_file(why);
            while (scene.why_none.ends_with('\n')) scene.why_none.pop_back();
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

}  // namespace rt
