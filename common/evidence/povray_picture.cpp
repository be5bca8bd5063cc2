// Pictures by POV-Ray: the program run on a scene, and what it draws put together as our filters do.
#include "common/evidence/povray_picture.hpp"

#include "chapters/08_antialiasing/film.hpp"
#include "common/image/file.hpp"
#include "common/povray/export.hpp"
#include "common/render/snapshots.hpp"
#include "common/terminal/process.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr const char* how_to_install = "povray is not installed; install it with: apt-get install povray";

std::vector<std::string> command_line(const Scene& scene, const PovrayRun& run, const fs::path& source,
                                      const fs::path& picture) {
    std::vector<std::string> line = {"povray",
                                     "+I" + source.string(),
                                     "+O" + picture.string(),
                                     fmt::format("+W{}", scene.width * run.scale),
                                     fmt::format("+H{}", scene.height * run.scale),
                                     "+FN16",
                                     "-D",
                                     fmt::format("+WT{}", povray_threads),
                                     "File_Gamma=1.0"};
    // It looks for pictures where it is told to, not beside what it reads.
    if (!scene.pictures.empty()) line.push_back("+L" + fs::absolute(scene.file).parent_path().string());
    if (run.options.empty()) line.emplace_back("-A");
    line.insert(line.end(), run.options.begin(), run.options.end());
    if (run.frames > 1) {
        line.emplace_back("+KFI0");
        line.push_back(fmt::format("+KFF{}", run.frames - 1));
    }
    return line;
}

/// Writes the text, runs POV-Ray on it, and returns the seconds that it took.
double run_povray(const std::string& name, const std::string& text, const Scene& scene,
                  const fs::path& directory) {
    const fs::path source = directory / (name + ".pov"), picture = directory / (name + ".png");
    write_file(source, text);
    const ProcessResult result = run_process(command_line(scene, povray_run(scene), source, picture));
    if (result.exit_code == 127) throw MissingProgram(how_to_install);
    if (!succeeded(result)) {
        const fs::path log = directory / (name + ".log");
        write_file(log, result.output);
        throw InputError(
            fmt::format("POV-Ray failed on {}; its messages are in {}", source.string(), log.string()));
    }
    return result.seconds;
}

/// The frames of an animation are NAME with a number and .png; all numbers have as many digits as the last
/// one.
std::vector<Image> take_frames(const std::string& name, int count, const fs::path& directory) {
    const std::size_t digits = fmt::format("{}", count - 1).size();
    std::vector<Image> frames;
    for (int k = 0; k < count; ++k) {
        const fs::path file = directory / fmt::format("{}{:0{}}.png", name, k, digits);
        frames.push_back(read_image(file));
        fs::remove(file);
    }
    return frames;
}

/// Whether a channel of a pixel is cut off in some of the pictures, so that the mean of all is not known.
bool is_cut_off(std::span<const Image> stills, int x, int y, int channel, bool alone) {
    const auto is_white = [&](const Image& still) { return !(pixel(still, x, y)[channel] < 1); };
    const auto count = std::ranges::count_if(stills, is_white);
    return count > 0 && !(alone && static_cast<std::size_t>(count) == stills.size());
}

/// Where all pictures are white, a pixel that takes no samples of its neighbours is white, too.
void require_not_cut_off(std::span<const Image> stills, const Scene& scene) {
    const Filter& filter = scene.sampling.filter;
    const bool alone = filter.kind == FilterKind::Box && filter.radius == 0.5;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                if (is_cut_off(stills, x, y, channel, alone))
                    throw InputError(fmt::format(
                        "{}: POV-Ray's picture of a sample is cut off at white in pixel ({}, {}), so "
                        "the mean is not known: let the lights be darker",
                        scene.file, x, y));
}

/// The image weighed from what POV-Ray has made, as a file of 16 bits has it.
PovrayPicture kept_as_png16(const fs::path& file, const Image& image, double seconds) {
    write_png16(file, image);
    return {read_image(file), seconds};
}

Image weighed(std::span<const FilmSample> samples, const Scene& scene) {
    Image image = make_image(scene.width, scene.height);
    const std::vector<FilmPixel> film =
        film_of(samples, scene.sampling.filter, {0, 0, scene.width, scene.height});
    std::ranges::transform(film, image.pixels.begin(), color_of);
    return image;
}

}  // namespace

Image filtered(const Image& large, int scale, const Scene& scene) {
    std::vector<FilmSample> samples;
    samples.reserve(large.pixels.size());
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            samples.push_back({Vec2(x + 0.5, y + 0.5) / Real(scale), pixel(large, x, y), 1});
    return weighed(samples, scene);
}

Image filtered(std::span<const Image> stills, std::span<const Snapshot> snapshots, const Scene& scene) {
    std::vector<FilmSample> samples;
    for (std::size_t k = 0; k < stills.size(); ++k)
        for (int y = 0; y < scene.height; ++y)
            for (int x = 0; x < scene.width; ++x)
                samples.push_back(
                    {Vec2(x, y) + snapshots[k].at, pixel(stills[k], x, y), snapshots[k].weight});
    return weighed(samples, scene);
}

Scene scene_of_samples(Scene scene, int scale) {
    scene.width *= scale, scene.height *= scale;
    scene.sampling = {};
    return scene;
}

PovrayPicture samples_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const fs::path& directory) {
    const double seconds = run_povray(name, text, scene, directory);
    return {read_image(directory / (name + ".png")), seconds};
}

PovrayPicture picture_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const fs::path& directory) {
    const PovrayRun run = povray_run(scene);
    const fs::path picture = directory / (name + ".png");
    if (run.frames > 1) {
        const double seconds = run_povray(name, text, scene, directory);
        const std::vector<Image> stills = take_frames(name, run.frames, directory);
        require_not_cut_off(stills, scene);
        return kept_as_png16(picture, filtered(stills, snapshots_of(scene), scene), seconds);
    }
    const PovrayPicture samples = samples_by_povray(name, text, scene, directory);
    if (!run.filter) return samples;
    return kept_as_png16(picture, filtered(samples.image, run.scale, scene), samples.seconds);
}

double povray_startup(const fs::path& directory) {
    double least = infinity;
    for (int i = 0; i < 3; ++i) {
        Scene nothing;
        nothing.width = nothing.height = 16;
        least =
            std::min(least, picture_by_povray("nothing", export_povray(nothing), nothing, directory).seconds);
    }
    return least;
}

void require_povray() {
    if (run_process({"povray", "--version"}).exit_code == 127) throw MissingProgram(how_to_install);
}

}  // namespace rt
