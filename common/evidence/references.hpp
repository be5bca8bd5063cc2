// The reference pictures: made by POV-Ray from our scenes, and watched for change.
#pragma once

#include "common/workbook/catalogue.hpp"
#include "common/image/image.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A scene of a chapter and the files that belong to it.
struct ReferenceScene {
    std::string chapter{};            ///< "02_spheres"
    std::string name{};               ///< of the file, without its ending
    std::filesystem::path scene{};    ///< NAME.scene
    std::filesystem::path pov{};      ///< NAME.pov
    std::filesystem::path picture{};  ///< NAME.png, 16-bit, linear
    /// What NAME.why says: why there is no reference. Empty: there should be one.
    std::string why_none{};
};

/// The scenes in references/CHAPTER: first those that the chapter lists, in its order, then all others.
/// Throws InputError for a listed scene that does not exist.
std::vector<ReferenceScene> reference_scenes(const Project& project, const Chapter& chapter);

/// The picture, averaged over boxes in linear light to `width` pixels, at most its own.
Image thumbnail(const Image& image, int width);

struct ReferencesOptions {
    bool make = false;    ///< write what changed
    std::string chapter;  ///< number; empty: all
    bool json = false;    ///< one JSON object on standard output instead of the table
    bool quiet = false;   ///< nothing on standard output, no progress
};

/// Exports the scenes, renders them with POV-Ray and compares text and pixels with the files of the
/// repository; also the thumbnails that the README shows. Returns the exit status: 1 if any differ and
/// were not written. Throws InputError if POV-Ray is not installed.
int run_references(const ReferencesOptions& options, const Project& project = this_project());

struct RandomReferencesOptions {
    std::uint64_t count = 0;  ///< scenes
    std::uint64_t first = 0;  ///< number of the first
    bool json = false;        ///< one JSON object on standard output instead of the table
};

/// Makes up scenes, exports them and compares POV-Ray's pictures with ours by the gate of the tour: each is
/// equal, or the export refuses it. Those that differ are left in build/references/random. Returns the exit
/// status: 1 if any differs, or if more are refused than equal. Throws InputError if POV-Ray is not
/// installed.
int run_random_references(const RandomReferencesOptions& options, const Project& project = this_project());

/// Writes the scene for POV-Ray. Returns the exit status. Throws InputError for what POV-Ray cannot express.
int run_export(const std::filesystem::path& scene, const std::filesystem::path& output, bool lenient);

}  // namespace rt
