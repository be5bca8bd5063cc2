// What the commands that take a scene share: reading it, and where its picture goes.
#pragma once

#include "common/scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// The scene of a file; `lenient` as in ParseOptions. Throws InputError as `parse_scene`.
Scene read_scene(const std::filesystem::path& file, bool lenient, std::vector<std::string>& warnings);

/// The same; warnings go to standard error, one line each.
Scene read_scene(const std::filesystem::path& file, bool lenient);

/// Where a scene's picture goes: as its `output` says, else its file's name with `.png`. A kind that is not
/// written becomes `.png`, with a warning; folders that are missing are made, below the
/// current one only. Throws InputError with the scene's line where there cannot be such a file.
std::filesystem::path picture_of(const Scene& scene, std::vector<std::string>& warnings);

/// The size that `--size` asks for, such as "640x480", instead of the scene's. Throws InputError for another
/// text.
void set_size(Scene& scene, const std::string& text);

/// Whether pictures of this name can be written: it ends in .png, .pfm or .hdr, in any case.
bool is_picture(const std::filesystem::path& file);

}  // namespace rt
