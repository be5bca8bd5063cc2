// Pictures by POV-Ray: the program run on a scene, and its samples weighed by our filters.
#pragma once

#include "chapters/08_antialiasing/film.hpp"
#include "common/image/image.hpp"
#include "common/math/input_error.hpp"
#include "common/scene/snapshot.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace rt {

/// Threads that POV-Ray is given, and we where times are compared.
inline constexpr int povray_threads = 2;

/// POV-Ray is not installed. Not a matter of one scene, so it ends whatever needs it.
struct MissingProgram : InputError {
    using InputError::InputError;
};

/// Throws MissingProgram if there is no POV-Ray.
void require_povray();

struct PovrayPicture {
    std::filesystem::path file;
    Image image;         ///< as the file has it
    double seconds = 0;  ///< that POV-Ray took
};

/// Runs POV-Ray in `directory` on NAME.pov, into which `text`, the export of `scene`, is written; its picture
/// is 16-bit, linear, and is left there as NAME.png. Its pixels may be samples, which are not weighed yet.
/// Not for scenes of which it makes several pictures. Throws MissingProgram, and InputError if POV-Ray fails.
PovrayPicture samples_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const std::filesystem::path& directory);

/// The same with the samples weighed: the picture. Of a blurred scene these are many pictures, which are not
/// left there; where it is brighter than white it is NAME.hdr. Throws InputError if one of several is white
/// somewhere, because the mean of what is cut off there is not what is cut off of the mean.
PovrayPicture picture_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const std::filesystem::path& directory);

/// Seconds that POV-Ray takes for a picture of nothing, the least of three runs.
double povray_startup(const std::filesystem::path& directory);

/// A picture that is `scale` times as large, as samples of the scene's pixels, weighed by its filter.
Image filtered(const Image& large, int scale, const Scene& scene);

/// Adds a still picture to the film of as many pixels: one sample of each, where the snapshot says, weighed
/// as the renderer weighs samples. A box filter of one pixel takes a pixel's own, also those on its edge.
void expose(std::vector<FilmPixel>& film, const Image& still, const Snapshot& snapshot, const Filter& filter);

/// The scene whose pixels are the samples of this one, `scale` × `scale` a pixel.
Scene scene_of_samples(Scene scene, int scale);

}  // namespace rt
