// The tour: every scene of the course rendered and compared with its reference.
#include "common/evidence/tour.hpp"

#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/povray/export.hpp"
#include "common/render/compile.hpp"
#include "common/render/decisions.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/workbook/catalogue.hpp"

#include <fmt/format.h>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// As `visit`; throws what goes wrong.
void render_and_compare(TourStop& stop, const fs::path& directory,
                        const std::function<void(Real)>& progress) {
    const Scene scene = parse_scene(stop.scene.scene);
    const World world = compile(scene);
    const RenderResult result = render(world, {.threads = 0, .progress = progress});
    const Image& image = result.image;
    stop.width = image.width;
    stop.height = image.height;
    stop.seconds = result.seconds;
    stop.estimate = result.rms_error.value_or(0);
    stop.rays = result.rays.camera + result.rays.shadow + result.rays.reflection + result.rays.refraction;
    write_image(directory / picture_of(stop), image, scene.encoding);
    if (stop.scene.picture.empty() || !stop.scene.why_none.empty()) return;
    if (!fs::exists(stop.scene.picture))
        throw InputError("there is no reference; `course references --make` makes it");
    const Image reference = read_image(stop.scene.picture);
    stop.agreement = povray_run(scene).exact ? judge(image, reference, [&] { return decisions(world); })
                                             : judge_samples(image, reference, stop.estimate);
    write_image(directory / reference_of(stop), reference, scene.encoding);
    write_image(directory / difference_of(stop), difference(image, reference, difference_gain),
                Encoding::Srgb);
}

/// Scenes as users of the base format write them; no stops where there are none.
TourPart base_format(const Project& project) {
    TourPart part{
        "base_format",
        "Scenes in the base format",
        "Written as users of the format write them. They are rendered as they are; there is nothing "
        "to compare them with.",
        {}};
    const fs::path directory = project.root / "tests" / "common" / "base_scenes";
    for (const fs::path& file : files_in(directory, {".test"}))
        part.stops.push_back({.scene = {.chapter = part.name, .name = file.stem().string(), .scene = file}});
    return part;
}

std::string word_of(const TourStop& stop) {
    if (!stop.problem.empty()) return "failed";
    if (!stop.agreement) return "rendered";
    if (!stop.agreement->passed) return "differs";
    return stop.agreement->ratio ? "as estimated" : "equal";
}

std::string rate_text(double rays_a_second) {
    return rays_a_second < 1e5 ? fmt::format("{:.2f} k", rays_a_second * 1e-3)
                               : fmt::format("{:.2f} M", rays_a_second * 1e-6);
}

}  // namespace

bool passed(const TourStop& stop) {
    return stop.problem.empty() && (!stop.agreement || stop.agreement->passed);
}

std::vector<TourPart> tour_of(const Project& project) {
    std::vector<TourPart> tour;
    for (const Chapter& chapter : read_catalogue(project)) {
        TourPart part{chapter.name, chapter.number + "  " + chapter.title, chapter.summary, {}};
        for (ReferenceScene& scene : reference_scenes(project, chapter))
            part.stops.push_back({.scene = std::move(scene)});
        tour.push_back(std::move(part));
    }
    if (TourPart base = base_format(project); !base.stops.empty()) tour.push_back(std::move(base));
    return tour;
}

TourCount count(const std::vector<TourPart>& tour) {
    TourCount count;
    for (const TourPart& part : tour)
        for (const TourStop& stop : part.stops) {
            ++count.stops;
            if (stop.agreement) ++count.compared;
            if (!passed(stop)) ++count.failed;
        }
    return count;
}

std::string picture_of(const TourStop& stop) { return stop.scene.name + ".png"; }
std::string reference_of(const TourStop& stop) { return stop.scene.name + ".reference.png"; }
std::string difference_of(const TourStop& stop) { return stop.scene.name + ".difference.png"; }

void visit(TourStop& stop, const fs::path& directory, const std::function<void(Real)>& progress) {
    try {
        render_and_compare(stop, directory, progress);
    } catch (const std::exception& error) {
        stop.problem = error.what();
    }
}

StopText text_of(const TourStop& stop) {
    StopText text{"–", "–", "–", "–", "–", "–", "–", word_of(stop)};
    if (stop.width > 0) {
        text.size = fmt::format("{}×{}", stop.width, stop.height);
        text.ms = fmt::format("{:.1f}", stop.seconds * 1e3);
    }
    if (stop.rays > 0) text.rate = rate_text(static_cast<double>(stop.rays) / stop.seconds);
    if (!stop.agreement) return text;
    text.greatest = fmt::format("{:.1f}", stop.agreement->greatest);
    if (stop.agreement->ratio) {
        text.error = fmt::format("{:.2g} × {:.2f}", stop.estimate, *stop.agreement->ratio);
    } else {
        text.over = fmt::format("{}", stop.agreement->over);
        text.inside = fmt::format("{}", stop.agreement->unexplained);
    }
    return text;
}

std::string opening_comment(std::string_view text) {
    std::string paragraph;
    while (text.starts_with('#')) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
        line = line.substr(0, line.find_last_not_of(" \r") + 1);
        if (!paragraph.empty() && !line.empty()) paragraph += ' ';
        paragraph += line;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return paragraph;
}

}  // namespace rt
