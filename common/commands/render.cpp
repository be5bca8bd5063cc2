// `course render`: a scene as a picture, and what it took.
#include "common/render/render.hpp"
#include "common/commands/commands.hpp"
#include "common/commands/mine.hpp"
#include "common/image/file.hpp"
#include "common/image/in_terminal.hpp"
#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/pictures/reasons_json.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/render/compile.hpp"
#include "common/render/explain.hpp"
#include "common/scene/parse.hpp"
#include "common/scene/suggest.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

/// A picture by another integrator than the scene's: by rays, unless the word says otherwise.
void set_integrator(Scene& scene, const std::string& name) {
    const std::optional<IntegratorChoice> chosen = integrator_named(name);
    if (!chosen)
        throw InputError(
            fmt::format("--integrator: there is no '{}'{}", name, did_you_mean(name, integrator_names())));
    scene.integrator = chosen->integrator;
    scene.visibility = chosen->visibility;
}

/// Where the picture goes; throws before any work if it is of no kind that can be written.
fs::path output_of(const RenderCommand& command, const Scene& scene, std::vector<std::string>& warnings) {
    if (command.output.empty()) return picture_of(scene, warnings);
    if (!is_picture(command.output))
        throw InputError(fmt::format("{}: pictures end in .png, .pfm or .hdr, not in '{}'",
                                     command.output.string(), command.output.extension().string()));
    return command.output;
}

/// Goes on with the student's code if there is any to use, else returns: chapters that pass, or all that is
/// begun. In a handout, where nothing takes the place of the others, these are all chapters.
void use_mine(const RenderCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const bool all = command.mine || !has_solutions(project);
    const OwnCode own =
        all ? own_code(project, chapters) : OwnCode{passing_chapters(project, chapters), {}, {}};
    if (command.mine && is_empty(own)) say("nothing of yours is begun: the solutions draw all of it");
    become_mine(project, own, command.arguments);
}

std::uint64_t all_rays(const RayCounts& rays) {
    return rays.camera + rays.shadow + rays.reflection + rays.refraction;
}

/// How many samples, and how wrong; nothing for one sample.
std::string sampling_of(const RenderResult& result) {
    if (result.samples_per_pixel == 1) return "";
    const std::string error =
        result.rms_error ? fmt::format(", RMS error about {:.2g}", *result.rms_error) : "";
    return fmt::format("{:.6g} samples a pixel{}, ", result.samples_per_pixel, error);
}

/// What the command line says instead of the scene.
void change(Scene& scene, const RenderCommand& command) {
    if (!command.size.empty()) set_size(scene, command.size);
    if (!command.integrator.empty()) set_integrator(scene, command.integrator);
    if (command.samples) scene.sampling.count = *command.samples;
    if (command.seed) scene.sampling.seed = *command.seed;
    if (scene.visibility == Visibility::Rasterize && (command.seconds || command.error))
        throw InputError("--seconds and --error: scan conversion takes one sample a pixel, and is done then");
}

RenderResult rendered(const World& world, const RenderCommand& command, const fs::path& output) {
    Progress progress(output.filename().string(), !command.quiet);
    RenderOptions options;
    options.threads = command.threads;
    options.seconds = command.seconds;
    options.error = command.error;
    options.progress = [&](Real fraction) { progress.update(fraction); };
    return render(world, options);
}

void print_json(const Scene& scene, const World& world, const RenderResult& result, const fs::path& output) {
    const RayCounts& rays = result.rays;
    const ordered_json object = {
        {"output", output.string()},
        {"width", scene.width},
        {"height", scene.height},
        {"seconds", result.seconds},
        {"cpu_seconds", result.cpu_seconds},
        {"samples_per_pixel", result.samples_per_pixel},
        {"rms_error", result.rms_error ? ordered_json(*result.rms_error) : ordered_json(nullptr)},
        {"rays",
         {{"camera", rays.camera},
          {"shadow", rays.shadow},
          {"reflection", rays.reflection},
          {"refraction", rays.refraction}}},
        {"random_numbers", rays.random_numbers},
        {"left_out", reasons_json(explain(scene, world).left_out)}};
    fmt::print("{}\n", json_text(object));
}

/// The picture as a file of this kind shows it: 8-bit ones by the scene's gamma.
Image for_file(const Scene& scene, const fs::path& output, Image image) {
    if (scene.gamma == 1 || output.extension() == ".pfm" || output.extension() == ".hdr") return image;
    for (Vec3& pixel : image.pixels) pixel = glm::pow(glm::max(pixel, Vec3(0)), Vec3(1 / scene.gamma));
    return image;
}

void show(const Image& image, Encoding encoding) {
    const TerminalSize terminal = terminal_size(stdout);
    fmt::print("{}", preview(image, encoding, terminal.columns, terminal.rows - 3));
    flush_output();
}

}  // namespace

int run_render(const RenderCommand& command) {
    std::vector<std::string> warnings;
    Scene scene = read_scene(command.scene, command.lenient, warnings);
    const fs::path output = output_of(command, scene, warnings);
    require_no_input(output, files_of(command.scene, scene));
    require_writable(output);
    change(scene, command);

    if (command.solutions) require_solutions(this_project(), "./course render --solutions");
    if (!linked_chapters() && !command.solutions) use_mine(command);
    for (const std::string& warning : warnings) say(warning);  // not before: what it becomes says them, too

    const World world = compile(scene);
    const RenderResult result = rendered(world, command, output);
    const Image shown = for_file(scene, output, result.image);
    write_image(output, shown, scene.encoding);
    // A whole pass may take longer than the time that was given, and the person should know why.
    if (command.seconds && result.seconds > 1.1 * *command.seconds)
        say("one sample a pixel takes longer than {}", duration(*command.seconds));

    if (command.json) {
        print_json(scene, world, result, output);
        return 0;
    }
    if (command.preview) show(shown, scene.encoding);
    if (!command.quiet)
        say("{}  {} × {}, {}{}, {}; {}", output.string(), scene.width, scene.height, sampling_of(result),
            counted(all_rays(result.rays), "ray"), duration(result.seconds), whose_code());
    return 0;
}

}  // namespace rt
