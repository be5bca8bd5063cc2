// The reference pictures: made by POV-Ray from our scenes, and watched for change.
#pragma once

#include "common/evidence/reference_scenes.hpp"
#include "common/image/image.hpp"
#include "common/math/vec.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// How a file of the repository stands against what would be written now.
enum class Kept { Same, Changed, Missing };

/// "same", "changed" or "missing".
std::string_view name_of(Kept kept);

/// What a check of one scene found.
struct ReferenceFinding {
    ReferenceScene scene;
    Kept pov = Kept::Same;
    Kept picture = Kept::Same;
    std::size_t changed_pixels = 0;
    Real greatest = 0;         ///< steps of 1/65535
    double seconds = 0;        ///< that POV-Ray took, its start-up of an empty scene subtracted
    double our_seconds = 0;    ///< for the same samples on as many threads, with reading and compiling
    std::string problem = {};  ///< why the scene could not be checked
};

/// Whether neither the scene for POV-Ray nor the picture has changed, and both could be checked.
bool is_same(const ReferenceFinding& finding);

/// Exports the scenes of these chapters, renders them with POV-Ray and compares text and pixels with the
/// files of the repository; with `make` writes what changed. `progress` is told the fraction done and the
/// scene that is next. Throws MissingProgram without POV-Ray; other trouble becomes a scene's problem.
std::vector<ReferenceFinding> check_references(
    const Project& project, const std::vector<Chapter>& chapters, bool make,
    const std::function<void(double fraction, const std::string& scene)>& progress);

/// How the small picture of a chapter that the README shows stands against its first reference picture.
struct ThumbnailFinding {
    std::string chapter;
    Kept state = Kept::Same;
};

/// Nothing for a chapter without reference pictures; with `make` writes what changed.
std::optional<ThumbnailFinding> check_thumbnail(const Project& project, const Chapter& chapter, bool make);

/// The picture, averaged over boxes in linear light to `width` pixels, at most its own.
Image thumbnail(const Image& image, int width);

}  // namespace rt
