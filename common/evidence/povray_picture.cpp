// Pictures by POV-Ray: the program run on a scene, and what it draws put together as our filters do.
#include "common/evidence/povray_picture.hpp"

#include "common/image/file.hpp"
#include "common/povray/export.hpp"
#include "common/povray/exposure.hpp"
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

/// The picture's pixels as samples of a pixel that is `scale` × `scale` of them; each of them was taken at
/// the place `at` of its own.
std::vector<FilmSample> samples_of(const Image& large, int scale, const Vec2& at, Real weight) {
    std::vector<FilmSample> samples;
    samples.reserve(large.pixels.size());
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            samples.push_back({(Vec2(x, y) + at) / Real(scale), pixel(large, x, y), weight});
    return samples;
}

Image developed(std::span<const FilmPixel> film, const Scene& scene) {
    Image image = make_image(scene.width, scene.height);
    std::ranges::transform(film, image.pixels.begin(), color_of);
    return image;
}

/// Where some of the pictures are cut off at white, the mean of all is not known.
struct White {
    std::vector<glm::ivec3> counts;  ///< a pixel: in how many pictures each channel is white

    explicit White(const Scene& scene)
        : counts(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height)) {}

    void look_at(const Image& still) {
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] += glm::ivec3(glm::greaterThanEqual(still.pixels[i], Vec3(1)));
    }

    /// Where all pictures are white, a pixel that takes no samples of its neighbours is white, too.
    void require_none(const Scene& scene, int stills) const {
        const bool is_white = takes_its_own(scene.sampling.filter) && exposure_of(scene) == 1;
        const auto width = static_cast<std::size_t>(scene.width);
        for (std::size_t i = 0; i < counts.size(); ++i)
            for (int channel = 0; channel < 3; ++channel) {
                const int count = counts[i][channel];
                if (count == 0 || (is_white && count == stills)) continue;
                throw InputError(
                    fmt::format("{}: POV-Ray's picture of a sample is cut off at white in pixel ({}, {}), so "
                                "the mean is not known: let the lights be darker",
                                scene.file, i % width, i / width));
            }
    }
};

/// The frames of an animation weighed: each has one sample of every pixel. They are NAME with a number and
/// .png, and are removed; all numbers have as many digits as the last one.
Image mean_of_frames(const std::string& name, int count, const Scene& scene, const fs::path& directory) {
    const std::vector<Snapshot> snapshots = snapshots_of(scene);
    const std::size_t digits = fmt::format("{}", count - 1).size();
    std::vector<FilmPixel> film(static_cast<std::size_t>(scene.width) *
                                static_cast<std::size_t>(scene.height));
    White white(scene);
    for (int k = 0; k < count; ++k) {
        const fs::path file = directory / fmt::format("{}{:0{}}.png", name, k, digits);
        const Image still = read_image(file);
        fs::remove(file);
        white.look_at(still);
        expose(film, still, snapshots[static_cast<std::size_t>(k)], scene.sampling.filter);
    }
    white.require_none(scene, count);
    Image image = developed(film, scene);
    const Real exposure = exposure_of(scene);
    for (Vec3& color : image.pixels) color /= exposure;
    return image;
}

/// The image weighed from what POV-Ray has made, as a file has it: a .png of 16 bits, or an .hdr if it is
/// brighter than white.
PovrayPicture kept(fs::path file, const Image& image, double seconds) {
    if (std::ranges::any_of(image.pixels, [](const Vec3& color) { return max_component(color) > 1; })) {
        file.replace_extension(".hdr");
        write_image(file, image, Encoding::Linear);
    } else {
        write_png16(file, image);
    }
    return {file, read_image(file), seconds};
}

}  // namespace

void expose(std::vector<FilmPixel>& film, const Image& still, const Snapshot& snapshot,
            const Filter& filter) {
    if (takes_its_own(filter)) {
        for (std::size_t i = 0; i < film.size(); ++i)
            film[i] = add(film[i], still.pixels[i], snapshot.weight);
        return;
    }
    const std::vector<FilmPixel> exposed = film_of(samples_of(still, 1, snapshot.at, snapshot.weight), filter,
                                                   {0, 0, still.width, still.height});
    for (std::size_t i = 0; i < film.size(); ++i) film[i] = merge(film[i], exposed[i]);
}

Image filtered(const Image& large, int scale, const Scene& scene) {
    return developed(film_of(samples_of(large, scale, Vec2(0.5), 1), scene.sampling.filter,
                             {0, 0, scene.width, scene.height}),
                     scene);
}

Scene scene_of_samples(Scene scene, int scale) {
    scene.width *= scale, scene.height *= scale;
    scene.sampling = {};
    return scene;
}

PovrayPicture samples_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const fs::path& directory) {
    const double seconds = run_povray(name, text, scene, directory);
    const fs::path picture = directory / (name + ".png");
    return {picture, read_image(picture), seconds};
}

PovrayPicture picture_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const fs::path& directory) {
    const PovrayRun run = povray_run(scene);
    const fs::path picture = directory / (name + ".png");
    if (run.frames > 1) {
        const double seconds = run_povray(name, text, scene, directory);
        return kept(picture, mean_of_frames(name, run.frames, scene, directory), seconds);
    }
    const PovrayPicture samples = samples_by_povray(name, text, scene, directory);
    if (!run.filter) return samples;
    return kept(picture, filtered(samples.image, run.scale, scene), samples.seconds);
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
