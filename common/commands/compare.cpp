// `course compare`: how far a picture is from a reference, in numbers and as a page.
#include "common/image/compare.hpp"
#include "common/commands/commands.hpp"
#include "common/commands/mine.hpp"
#include "common/commands/student_trees.hpp"
#include "common/image/file.hpp"
#include "common/image/flip.hpp"
#include "common/image/ssim.hpp"
#include "common/math/input_error.hpp"
#include "common/pictures/comparison_page.hpp"
#include "common/pictures/ray_tree.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/pictures/tree_difference.hpp"
#include "common/render/compile.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <set>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// JSON knows no infinity.
ordered_json number_or_null(Real value) { return value < infinity ? ordered_json(value) : ordered_json(); }

template <std::size_t N>
ordered_json fractions(const std::array<Real, N>& within, int asked) {
    auto object = ordered_json::object();
    for (const int n : std::set{1, 2, 10, asked})
        object[std::to_string(n)] = within[static_cast<std::size_t>(n)];
    return object;
}

/// What the eye makes of it.
struct Perceived {
    std::optional<Real> ssim;
    Real flip = 0;
};

ordered_json to_json(const Comparison& comparison, const Perceived& perceived, int within, bool same) {
    return {{"width", comparison.width},
            {"height", comparison.height},
            {"max", comparison.max},
            {"shown_max", comparison.shown_max},
            {"mean", comparison.mean},
            {"rmse", comparison.rmse},
            {"psnr", number_or_null(comparison.psnr)},
            {"within", fractions(comparison.within, within)},
            {"within16", fractions(comparison.within16, 2)},
            {"worst", {{"x", comparison.worst_x}, {"y", comparison.worst_y}}},
            {"ssim", perceived.ssim ? ordered_json(*perceived.ssim) : ordered_json()},
            {"flip", perceived.flip},
            {"same", same}};
}

void print(const Comparison& comparison, int within, bool same, bool eight_bits) {
    if (comparison.max == 0) {
        fmt::print("equal: {} × {} pixels, none differs\n", comparison.width, comparison.height);
        return;
    }
    // What 8 bits cannot hold says nothing of a picture that has only those.
    const std::string finer =
        eight_bits ? "" : fmt::format("; {} within 2/65535 in light", percent(comparison.within16[2]));
    fmt::print("{}: {} of {} × {} pixels within {}/255 as a display shows them, greatest {:.3g}/255{}\n",
               same ? "the same to the eye" : "different",
               percent(comparison.within[static_cast<std::size_t>(within)]), comparison.width,
               comparison.height, within, 255 * comparison.shown_max, finer);
    fmt::print("in light: greatest {:.6f} at pixel ({}, {}), mean {:.3g}, RMSE {:.3g}, PSNR {:.1f} dB\n",
               comparison.max, comparison.worst_x, comparison.worst_y, comparison.mean, comparison.rmse,
               comparison.psnr);
}

/// The one name of a file that need not be there yet.
std::filesystem::path full(const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
}

/// What will be written can be, and is neither what is read nor one file for two things.
void require_places(const CompareCommand& command) {
    const std::vector<std::filesystem::path> inputs{command.image, command.reference, command.scene};
    for (const std::filesystem::path& output : {command.diff, command.page}) {
        if (output.empty()) continue;
        require_no_input(output, inputs);
        require_writable(output);
    }
    if (command.diff.empty()) return;
    require_picture_ending(command.diff);
    if (!command.page.empty() && full(command.diff) == full(command.page))
        throw InputError(command.page.string() + ": --diff and --page cannot be one file");
}

void require_same_size(const CompareCommand& command, const Image& image, const Image& reference) {
    if (image.width == reference.width && image.height == reference.height) return;
    throw InputError(
        fmt::format("{} has {} x {} pixels and {} has {} x {}; only images of one size can be compared",
                    command.image.string(), image.width, image.height, command.reference.string(),
                    reference.width, reference.height));
}

/// The rays of some pixels, by the student's code from a process of its own.
void add_rays(const CompareCommand& command, const Scene& scene, const Image& image, const Image& reference,
              PageExtras& extras) {
    extras.scene = command.scene.string();
    extras.rays = pixels_to_trace(image, reference);
    const World world = compile(scene);
    std::vector<ordered_json> theirs, mine;
    std::vector<std::pair<int, int>> places;
    for (const PixelRays& pixel : extras.rays) {
        places.emplace_back(pixel.x, pixel.y);
        theirs.push_back(ray_tree(scene, world, pixel.x, pixel.y));
        theirs.back()["scene"] = extras.scene;
    }
    // In a handout this program is linked with the student's code: its trees are theirs.
    if (linked_chapters()) mine.swap(theirs);
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const OwnCode own = own_code(project, chapters);
    std::vector<WrongStep> wrong;
    if (!linked_chapters() && is_empty(own))
        extras.without_mine = "No chapter is begun: these are the solutions' rays.";
    else if (!linked_chapters())
        try {
            mine = student_trees(project, own, {command.scene, false, ""}, places);
            wrong = wrong_steps(project, chapters);
        } catch (const InputError& error) {
            extras.without_mine = fmt::format("There are no rays by your code: {}.", error.what());
        }
    for (std::size_t i = 0; i < extras.rays.size(); ++i) {
        PixelRays& pixel = extras.rays[i];
        if (!mine.empty()) {
            mine[i]["scene"] = extras.scene;
            pixel.mine = tree_text(mine[i]);
        }
        if (!theirs.empty()) pixel.theirs = tree_text(theirs[i]);
        if (mine.empty() || theirs.empty()) continue;
        if (const auto difference = first_difference(mine[i], theirs[i]))
            pixel.difference =
                fmt::format("First difference: {}: yours is {}, the solutions' {}. {}", difference->quantity,
                            difference->mine, difference->theirs, advice(*difference, wrong));
    }
}

void write_page(const CompareCommand& command, const std::optional<Scene>& scene, const Image& image,
                const Image& reference, const Comparison& comparison, const Display& display) {
    PageExtras extras;
    extras.display = display;
    if (scene) add_rays(command, *scene, image, reference, extras);
    write_file(command.page, comparison_page(image, reference, comparison, command.image.string(),
                                             command.reference.string(), extras));
}

/// The scene of the pictures, if it was named.
std::optional<Scene> scene_of(const CompareCommand& command, const Image& image) {
    if (command.scene.empty()) return std::nullopt;
    Scene scene = read_scene(command.scene, false);
    if (scene.width != image.width || scene.height != image.height)
        throw InputError(
            fmt::format("{} has {} x {} pixels and {} has {} x {}: it is not the scene of this picture",
                        command.scene.string(), scene.width, scene.height, command.image.string(),
                        image.width, image.height));
    return scene;
}

}  // namespace

int run_compare(const CompareCommand& command) {
    if (!command.scene.empty()) become_mine_in_handout(command.arguments);
    require_places(command);
    const Encoding encoding = command.encoding == "linear" ? Encoding::Linear : Encoding::Srgb;
    const auto [image, image_has_8_bits] = read_picture(command.image, encoding);
    const auto [reference, reference_has_8_bits] = read_picture(command.reference, encoding);
    require_same_size(command, image, reference);
    const std::optional<Scene> scene = scene_of(command, image);
    const bool eight_bits = image_has_8_bits || reference_has_8_bits;
    const Display display = eight_bits ? Display{encoding, true} : Display{};
    const Comparison comparison = compare(image, reference, display);
    const bool same = comparison.within[static_cast<std::size_t>(command.within)] >= same_share;

    if (!command.diff.empty())
        write_image(command.diff, difference(image, reference, visible_gain(comparison)));
    if (!command.page.empty()) write_page(command, scene, image, reference, comparison, display);
    if (command.json)
        fmt::print("{}\n",
                   json_text(to_json(comparison,
                                     {ssim(image, reference, display), mean(flip(image, reference, display))},
                                     command.within, same)));
    else
        print(comparison, command.within, same, eight_bits);
    return same ? 0 : 1;
}

}  // namespace rt
