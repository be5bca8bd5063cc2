// What the commands that take a scene share: reading it, and where its picture goes.
#include "common/pictures/scene_file.hpp"

#include "common/math/input_error.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/console.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::string about_output(const Scene& scene, const std::string& what) {
    return at_place(scene.file, scene.output_place.line, scene.output_place.column, what);
}

/// Makes the folders of a relative path that does not lead out of the current one.
void make_folders(const Scene& scene, const fs::path& output) {
    const fs::path folder = output.parent_path();
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) return;
    const bool is_below =
        folder.is_relative() && std::find(folder.begin(), folder.end(), "..") == folder.end();
    if (is_below) fs::create_directories(folder, error);
    if (!is_below || error)
        throw InputError(about_output(
            scene,
            fmt::format("there is no folder '{}'; -o FILE writes the picture elsewhere", folder.string())));
}

}  // namespace

Scene read_scene(const fs::path& file, bool lenient, std::vector<std::string>& warnings) {
    return parse_scene(file, {.lenient = lenient, .warnings = &warnings});
}

Scene read_scene(const fs::path& file, bool lenient) {
    std::vector<std::string> warnings;
    Scene scene = read_scene(file, lenient, warnings);
    // The program that is linked with the student's code reads what this one has read.
    if (!std::getenv(mine_variable))
        for (const std::string& warning : warnings) say(warning);
    return scene;
}

void set_size(Scene& scene, const std::string& text) {
    int width = 0, height = 0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, width);
    const bool cross =
        first.ec == std::errc() && first.ptr != end && (*first.ptr == 'x' || *first.ptr == 'X');
    const auto second = cross ? std::from_chars(first.ptr + 1, end, height) : first;
    const bool whole = cross && second.ec == std::errc() && second.ptr == end;
    if (!whole || width < 1 || height < 1 || width > largest_side || height > largest_side)
        throw InputError(
            fmt::format("--size: '{}' is not a size; expected width and height from 1 to {}, such as "
                        "640x480",
                        text, largest_side));
    if (const long long pixels = static_cast<long long>(width) * height; pixels > most_pixels)
        throw InputError(
            fmt::format("--size: '{}' is {} pixels; at most {} are possible", text, pixels, most_pixels));
    scene.width = width;
    scene.height = height;
}

bool is_picture(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".png" || ending == ".pfm" || ending == ".hdr";
}

fs::path picture_of(const Scene& scene, std::vector<std::string>& warnings) {
    if (scene.output.empty()) return fs::path(scene.file).stem().replace_extension(".png");
    fs::path output = scene.output;
    if (!output.has_filename())
        throw InputError(about_output(
            scene, fmt::format("'{}' names no file; -o FILE says where the picture goes", scene.output)));
    if (!is_picture(output)) {
        output.replace_extension(".png");
        warnings.push_back(
            about_output(scene, fmt::format("pictures are written as .png, .pfm or .hdr: '{}' becomes '{}'",
                                            scene.output, output.string())));
    }
    make_folders(scene, output);
    return output;
}

}  // namespace rt
