// What `course check` shows beside its verdict: a picture of the student's, or one in which a mistake is
// seen.
#include "common/commands/chapter_pictures.hpp"

#include "common/commands/student_trees.hpp"
#include "common/evidence/agreement.hpp"
#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/image/in_terminal.hpp"
#include "common/math/input_error.hpp"
#include "common/math/stopwatch.hpp"
#include "common/pictures/drawings.hpp"
#include "common/pictures/step_picture.hpp"
#include "common/pictures/tree_difference.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/lock.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

// A picture that takes longer than this is not part of a verdict.
constexpr double picture_seconds = 3;
// So long mistakes are looked for in pictures, and so long one picture may take.
constexpr double all_seconds = 1, one_second = 1;
// What shows a mistake is so many times smaller than the chapter's pictures, if that will do.
constexpr int times_smaller = 4;

/// Runs the program that has tested the chapter with these arguments; whether it did what it was asked for.
bool ask_code(const Project& project, const Chapter& chapter, std::vector<std::string> arguments,
              double seconds) {
    arguments.insert(arguments.begin(), program(project, "check_" + chapter.number).string());
    ProcessOptions options;
    options.time_limit = seconds;
    return succeeded(run_process(arguments, options));
}

std::vector<std::string> words_of(const Shown& shown) {
    return {shown.what, std::to_string(shown.width), std::to_string(shown.height)};
}

/// What the student's code draws; nothing if it does not come to its end.
std::optional<Image> drawn(const Project& project, const Chapter& chapter, const Shown& shown,
                           double seconds) {
    const fs::path file = own_directory(project) / "shown.pfm";
    std::vector<std::string> arguments = words_of(shown);
    arguments.insert(arguments.begin(), "--picture");
    arguments.push_back(file.string());
    fs::remove(file);  // of the time before
    if (!ask_code(project, chapter, arguments, seconds) || !fs::exists(file)) return std::nullopt;
    return read_image(file);
}

/// What is behind a pixel of that picture, by the student's code.
std::optional<ordered_json> behind(const Project& project, const Chapter& chapter, const Shown& shown, int x,
                                   int y) {
    const fs::path file = own_directory(project) / "pixel.json";
    std::vector<std::string> arguments = words_of(shown);
    arguments.insert(arguments.begin(), "--pixel");
    arguments.insert(arguments.end(), {std::to_string(x), std::to_string(y), file.string()});
    fs::remove(file);
    if (!ask_code(project, chapter, arguments, one_second) || !fs::exists(file)) return std::nullopt;
    const ordered_json json = read_ordered_json(read_file(file));
    return json.is_discarded() ? std::nullopt : std::optional(json);
}

fs::path scene_path(const Project& project, const Chapter& chapter, const std::string& name) {
    return project.root / "references" / chapter.name / name;
}

/// The scene's picture in this part of its size.
Shown small(const fs::path& scene, int part) {
    const Scene read = parse_scene(scene);
    return {scene.string(), std::max(1, read.width / part), std::max(1, read.height / part)};
}

/// Something to show: a drawing, or a scene in a part of its size, which is not read before it is its turn.
struct Candidate {
    std::string what;
    int part = 0;  ///< 0 of a drawing
};

/// What may show a mistake in a step, the best first: its own picture, small and large, then all of the
/// chapter's. In a handout there is only POV-Ray's picture to compare with.
std::vector<Candidate> pictures_of(const Project& project, const Chapter& chapter, const Step& step) {
    std::vector<Candidate> pictures;
    const bool is_scene = step.picture.ends_with(".scene");
    const int part = has_solutions(project) ? times_smaller : 1;
    if (is_scene) pictures.push_back({step.picture, part});
    if (!step.picture.empty() && !is_scene && has_solutions(project)) pictures.push_back({step.picture});
    for (const std::string& name : chapter.scenes)
        if (name != step.picture) pictures.push_back({name, part});
    if (is_scene && part > 1) pictures.push_back({step.picture, 1});
    return pictures;
}

/// Nothing where the scene cannot be read.
std::optional<Shown> shown_of(const Project& project, const Chapter& chapter, const Candidate& candidate) {
    if (candidate.part == 0) return Shown{candidate.what};
    try {
        return small(scene_path(project, chapter, candidate.what), candidate.part);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// The picture as it should be.
std::optional<Image> expected(const Project& project, const Shown& shown) {
    if (has_solutions(project)) return step_picture(shown);
    const fs::path reference = fs::path(shown.what).replace_extension(".png");
    return fs::exists(reference) ? std::optional(read_image(reference)) : std::nullopt;
}

/// Both pictures, and how they differ.
struct Seen {
    Shown shown;
    Image mine, theirs;
    Comparison comparison;
};

/// Whether somebody who looks at them sees a difference. POV-Ray's picture differs at silhouettes, too.
bool is_seen(const Project& project, const Comparison& comparison) {
    return comparison.within[1] < (has_solutions(project) ? 1 : same_share);
}

std::optional<Seen> first_seen(const Project& project, const Chapter& chapter, const Step& step) {
    const Stopwatch watch;
    for (const Candidate& candidate : pictures_of(project, chapter, step)) {
        if (watch.seconds() > all_seconds) break;
        const std::optional<Shown> shown = shown_of(project, chapter, candidate);
        std::optional<Image> mine = shown ? drawn(project, chapter, *shown, one_second) : std::nullopt;
        std::optional<Image> theirs = mine ? expected(project, *shown) : std::nullopt;
        if (!theirs) continue;
        const Comparison comparison = compare(*mine, *theirs);
        if (is_seen(project, comparison))
            return Seen{*shown, std::move(*mine), std::move(*theirs), comparison};
    }
    return std::nullopt;
}

/// Pictures of one size side by side, each pixel as a square of `size` pixels, with a gap between.
Image in_a_row(const std::vector<Image>& images, int size) {
    const int gap = 2 * size, width = images.front().width * size, height = images.front().height * size;
    const int count = static_cast<int>(images.size());
    Image row = make_image(count * width + (count - 1) * gap, height);
    for (int i = 0; i < count; ++i)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                pixel(row, i * (width + gap) + x, y) =
                    pixel(images[static_cast<std::size_t>(i)], x / size, y / size);
    return row;
}

bool shows_true_colors() {
    const char* colors = std::getenv("COLORTERM");
    const std::string_view known = colors ? colors : "";
    return has_color(stdout) && (known == "truecolor" || known == "24bit");
}

std::string color_in_words(const Image& image, int x, int y) {
    const Vec3& color = pixel(image, x, y);
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", color.x, color.y, color.z);
}

/// What is wrong at the worst pixel: "your normal is (0, -0.8, 0.6), expected (0, 0.8, 0.6) – step 02.4".
std::string worst_in_words(const Project& project, const Chapter& chapter, const ChapterResult& result,
                           const Seen& seen) {
    const int x = seen.comparison.worst_x, y = seen.comparison.worst_y;
    const std::string colors = fmt::format("your colour {}, expected {}", color_in_words(seen.mine, x, y),
                                           color_in_words(seen.theirs, x, y));
    const std::optional<ordered_json> mine =
        has_solutions(project) ? behind(project, chapter, seen.shown, x, y) : std::nullopt;
    if (!mine) return colors;
    const ordered_json theirs = step_pixel(seen.shown, x, y);
    if (drawing_named(seen.shown.what))
        return fmt::format("{}: yours says {}, expected {}", theirs["place"].get<std::string>(),
                           (*mine)["answer"].get<std::string>(), theirs["answer"].get<std::string>());
    const std::optional<TraceDifference> difference = first_difference(*mine, theirs);
    if (!difference) return colors;
    const auto step = step_to_look_at(*difference, wrong_steps(chapter, result));
    return in_words(*difference) + (step ? " \u2013 step " + *step : "");
}

/// How to look into the pixel.
std::string way_on(const Project& project, const Seen& seen) {
    if (drawing_named(seen.shown.what)) return "";
    const std::string scene = relative(project, seen.shown.what);
    const int x = seen.comparison.worst_x, y = seen.comparison.worst_y;
    if (!has_solutions(project))
        return fmt::format("      ./course trace {} {} {} shows its rays\n", scene, x, y);
    const Scene read = parse_scene(seen.shown.what);
    const bool is_small = read.width != seen.shown.width;
    return fmt::format("      ./course trace {} {} {}{} --against solutions follows it\n", scene, x, y,
                       is_small ? fmt::format(" --size {}x{}", seen.shown.width, seen.shown.height) : "");
}

/// Where a picture of the chapter is written.
fs::path picture_file(const Project& project, const Chapter& chapter, const std::string& name) {
    const fs::path file = project.build / "pictures" / chapter.name / (name + ".png");
    make_directories(file.parent_path());
    return file;
}

/// What the student's code draws of a scene or a drawing, written to a file of that name.
std::optional<VerdictPicture> own_picture(const Project& project, const Chapter& chapter,
                                          const std::string& what, const std::string& name) {
    const bool is_scene = what.ends_with(".scene");
    const fs::path scene = scene_path(project, chapter, what);
    const std::optional<Image> image =
        drawn(project, chapter, {is_scene ? scene.string() : what}, picture_seconds);
    if (!image) return std::nullopt;
    const fs::path file = picture_file(project, chapter, name);
    write_image(file, *image, is_scene ? parse_scene(scene).encoding : Encoding::Srgb);
    VerdictPicture picture{relative(project, file), ""};
    picture.text = fmt::format("\nYour picture: {}\n", picture.file);

    const fs::path reference = fs::path(scene).replace_extension(".png");
    if (!is_scene || !fs::exists(reference)) return picture;
    const Comparison comparison = compare(*image, read_image(reference));
    picture.text += fmt::format("{} of its pixels equal POV-Ray's ({})\n",
                                percent(comparison.within16[static_cast<std::size_t>(gate_steps)]),
                                relative(project, reference));
    return picture;
}

}  // namespace

std::optional<VerdictPicture> chapter_picture(const Project& project, const Chapter& chapter) {
    if (chapter.scenes.empty()) return std::nullopt;
    const std::string& scene = chapter.scenes.front();
    return own_picture(project, chapter, scene, fs::path(scene).stem().string());
}

std::optional<VerdictPicture> picture_of_passed(const Project& project, const Chapter& chapter,
                                                const Step& step) {
    if (step.picture.empty()) return std::nullopt;
    return own_picture(project, chapter, step.picture, step.id);
}

std::optional<VerdictPicture> picture_of_failed(const Project& project, const Chapter& chapter,
                                                const ChapterResult& result, const std::string& step) {
    const std::optional<Seen> seen = first_seen(project, chapter, step_of(chapter, step));
    if (!seen) return std::nullopt;
    const std::vector<Image> images{seen->mine, seen->theirs,
                                    difference(seen->mine, seen->theirs, visible_gain(seen->comparison))};
    const fs::path file = picture_file(project, chapter, step);
    write_image(file, in_a_row(images, std::max(1, 320 / seen->mine.width)));

    VerdictPicture picture{relative(project, file), ""};
    picture.text = fmt::format("\n      {}: yours, the expected one, and the difference\n", picture.file);
    if (shows_true_colors()) {
        const TerminalSize terminal = terminal_size(stdout);
        picture.text += preview(in_a_row(images, 1), Encoding::Srgb, terminal.columns, terminal.rows - 3);
    }
    picture.text +=
        fmt::format("      at pixel ({}, {}): {}\n{}", seen->comparison.worst_x, seen->comparison.worst_y,
                    worst_in_words(project, chapter, result, *seen), way_on(project, *seen));
    return picture;
}

}  // namespace rt
