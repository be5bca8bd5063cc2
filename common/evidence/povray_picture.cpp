// Pictures by POV-Ray: the program run on a scene, and what it draws put together as our filters do.
#include "common/evidence/povray_picture.hpp"

#include "chapters/08_antialiasing/film.hpp"
#include "common/image/file.hpp"
#include "common/povray/export.hpp"
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
    return line;
}

}  // namespace

Image filtered(const Image& large, int scale, const Scene& scene) {
    std::vector<FilmSample> samples;
    samples.reserve(large.pixels.size());
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            samples.push_back({Vec2(x + 0.5, y + 0.5) / Real(scale), pixel(large, x, y), 1});
    Image image = make_image(scene.width, scene.height);
    const std::vector<FilmPixel> film =
        film_of(samples, scene.sampling.filter, {0, 0, scene.width, scene.height});
    std::ranges::transform(film, image.pixels.begin(), color_of);
    return image;
}

Scene scene_of_samples(Scene scene, int scale) {
    scene.width *= scale, scene.height *= scale;
    scene.sampling = {};
    return scene;
}

PovrayPicture samples_by_povray(const std::string& name, const std::string& text, const Scene& scene,
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
    return {read_image(picture), result.seconds};
}

PovrayPicture picture_by_povray(const std::string& name, const std::string& text, const Scene& scene,
                                const fs::path& directory) {
    const PovrayPicture samples = samples_by_povray(name, text, scene, directory);
    const PovrayRun run = povray_run(scene);
    if (!run.filter) return samples;
    const fs::path picture = directory / (name + ".png");
    write_png16(picture, filtered(samples.image, run.scale, scene));
    return {read_image(picture), samples.seconds};
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
