// The tour: every scene of the course rendered, compared with its reference and shown on a page.
#include "common/evidence/tour.hpp"

#include "common/workbook/catalogue.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/pictures/page.hpp"
#include "common/evidence/references.hpp"
#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/render/compile.hpp"
#include "common/render/decisions.hpp"
#include "common/povray/export.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <thread>

namespace rt {
namespace {

namespace fs = std::filesystem;

/// By which differences are multiplied for the eye: two steps of 1/65535 become an eighth of full light.
constexpr Real difference_gain = 4096;

/// One scene of the tour.
struct Stop {
    ReferenceScene scene;
    int width = 0;
    int height = 0;
    double seconds = 0;
    std::uint64_t rays = 0;            ///< of all kinds; 0 for scan conversion
    Real estimate = 0;                 ///< of the root mean square error; 0 for one sample a pixel
    std::optional<Verdict> verdict{};  ///< nothing where there is no reference
    std::string problem{};  ///< why there is no picture, or no verdict although there should be one

    bool passed() const { return problem.empty() && (!verdict || verdict->passed); }
    std::string word() const {
        if (!problem.empty()) return "failed";
        if (!verdict) return "rendered";
        if (!verdict->passed) return "differs";
        return verdict->ratio ? "as estimated" : "equal";
    }
};

/// A chapter's part of the tour, or that of the scenes in the base format.
struct Part {
    std::string name;  ///< of the directory of its pictures, "02_spheres"
    std::string title;
    std::string summary;
    std::vector<Stop> stops;
};

std::string picture_of(const Stop& stop) { return stop.scene.name + ".png"; }
std::string reference_of(const Stop& stop) { return stop.scene.name + ".reference.png"; }
std::string difference_of(const Stop& stop) { return stop.scene.name + ".difference.png"; }

bool is_silhouette(std::span<const std::uint64_t> decisions, int width, int height, int x, int y) {
    const auto at = [&](int i, int j) {
        return decisions[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(i)];
    };
    for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i)
            if (at(i, j) != at(x, y)) return true;
    return false;
}

/// Greatest difference of a channel, in steps of 1/65535; a NaN differs from everything by the whole range.
Real steps_between(const Vec3& a, const Vec3& b) {
    Real greatest = 0;
    for (int c = 0; c < 3; ++c) {
        const bool broken = std::isnan(a[c]) || std::isnan(b[c]);
        greatest = std::max(greatest, broken ? 1 : std::abs(displayable(a[c]) - displayable(b[c])));
    }
    return greatest * 65535;
}

void require_same_size(const Image& image, const Image& reference) {
    if (image.width != reference.width || image.height != reference.height)
        throw InputError(fmt::format("the picture has {} x {} pixels and its reference {} x {}", image.width,
                                     image.height, reference.width, reference.height));
}

/// Renders one scene, writes its pictures into `directory` and judges it.
void visit(Stop& stop, const fs::path& directory, const std::function<void(Real)>& progress) {
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
    stop.verdict = povray_run(scene).exact ? judge(image, reference, [&] { return decisions(world); })
                                           : judge_samples(image, reference, result.rms_error.value_or(0));
    write_image(directory / reference_of(stop), reference, scene.encoding);
    write_image(directory / difference_of(stop), difference(image, reference, difference_gain),
                Encoding::Srgb);
}

/// The tour's files can be written, and none of its pictures is one that it is to be compared with.
void require_places(const std::vector<Part>& parts, const fs::path& output) {
    make_directories(output);
    for (const Part& part : parts) {
        const fs::path directory = output / part.name;
        make_directories(directory);
        for (const Stop& stop : part.stops)
            for (const std::string& name : {picture_of(stop), reference_of(stop), difference_of(stop)}) {
                require_no_input(directory / name, {stop.scene.scene, stop.scene.picture});
                require_writable(directory / name);
            }
    }
    require_writable(output / "index.html");
}

std::vector<Part> parts_of(const Project& project) {
    std::vector<Part> parts;
    for (const Chapter& chapter : read_catalogue(project)) {
        Part part{chapter.name, chapter.number + "  " + chapter.title, chapter.summary, {}};
        for (ReferenceScene& scene : reference_scenes(project, chapter))
            part.stops.push_back({.scene = std::move(scene)});
        parts.push_back(std::move(part));
    }
    Part base{"base_format",
              "Scenes in the base format",
              "Written as users of the format write them. They are rendered as they are; there is nothing to "
              "compare them with.",
              {}};
    const fs::path directory = project.root / "tests" / "common" / "base_scenes";
    if (fs::exists(directory)) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(directory))
            if (entry.path().extension() == ".test") files.push_back(entry.path());
        std::ranges::sort(files);
        for (const fs::path& file : files) {
            Stop stop;
            stop.scene.chapter = base.name;
            stop.scene.name = file.stem().string();
            stop.scene.scene = file;
            base.stops.push_back(std::move(stop));
        }
    }
    if (!base.stops.empty()) parts.push_back(std::move(base));
    return parts;
}

// Words ---------------------------------------------------------------------------------------------------

std::string size_text(const Stop& stop) {
    return stop.width == 0 ? "–" : fmt::format("{}×{}", stop.width, stop.height);
}
std::string time_text(const Stop& stop) {
    return stop.width == 0 ? "–" : fmt::format("{:.1f}", stop.seconds * 1e3);
}
std::string rate_text(const Stop& stop) {
    if (stop.rays == 0) return "–";
    const double rate = static_cast<double>(stop.rays) / stop.seconds;
    return rate < 1e5 ? fmt::format("{:.2f} k", rate * 1e-3) : fmt::format("{:.2f} M", rate * 1e-6);
}
std::string greatest_text(const Stop& stop) {
    return stop.verdict ? fmt::format("{:.1f}", stop.verdict->greatest) : "–";
}
std::string over_text(const Stop& stop) {
    return stop.verdict && !stop.verdict->ratio ? fmt::format("{}", stop.verdict->over) : "–";
}
std::string unexplained_text(const Stop& stop) {
    return stop.verdict && !stop.verdict->ratio ? fmt::format("{}", stop.verdict->unexplained) : "–";
}
/// The picture's own estimate of its error, and what it really is in units of that.
std::string error_text(const Stop& stop) {
    return stop.verdict && stop.verdict->ratio
               ? fmt::format("{:.2g} × {:.2f}", stop.estimate, *stop.verdict->ratio)
               : "–";
}

/// `text` to the right of a field; counts letters, not bytes.
std::string right(const std::string& text, std::size_t width) {
    const auto letters = static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    return std::string(letters < width ? width - letters : 0, ' ') + text;
}

void print_table(const std::vector<Part>& parts) {
    const auto row = [](std::string_view chapter, std::string_view scene,
                        const std::vector<std::string>& cells) {
        std::string text = fmt::format("{:<16} {:<24}", chapter, scene);
        for (const std::string& cell : cells) text += " " + right(cell, 9);
        return text;
    };
    fmt::print("{}\n", paint(row("chapter", "scene",
                                 {"size", "ms", "rays/s", "greatest", "over 2", "inside", "error"}),
                             Tone::Dim));
    for (const Part& part : parts)
        for (const Stop& stop : part.stops) {
            fmt::print("{}  {}\n",
                       row(part.name, stop.scene.name,
                           {size_text(stop), time_text(stop), rate_text(stop), greatest_text(stop),
                            over_text(stop), unexplained_text(stop), error_text(stop)}),
                       paint(stop.word(), stop.passed() ? Tone::Good : Tone::Bad));
            if (!stop.problem.empty()) fmt::print("    {}\n", printable(stop.problem));
        }
    fmt::print("{}\n",
               paint("greatest: difference in steps of 1/65535; over 2: pixels that differ by more than 2; "
                     "inside: of them, not at silhouettes; error: of random samples, as estimated × what it "
                     "really is of that",
                     Tone::Dim));
}

nlohmann::ordered_json json_of(const Stop& stop) {
    nlohmann::ordered_json json = {{"chapter", stop.scene.chapter}, {"scene", stop.scene.name},
                                   {"width", stop.width},           {"height", stop.height},
                                   {"seconds", stop.seconds},       {"rays", stop.rays}};
    if (stop.verdict) {
        json["greatest16"] = std::lround(stop.verdict->greatest);
        json["over"] = stop.verdict->over;
        json["unexplained"] = stop.verdict->unexplained;
        if (stop.verdict->ratio) {
            json["rms_error"] = stop.estimate;
            json["error_over_estimate"] = *stop.verdict->ratio;
        }
    }
    if (!stop.scene.why_none.empty()) json["why_none"] = stop.scene.why_none;
    if (!stop.problem.empty()) json["problem"] = stop.problem;
    json["passed"] = stop.passed();
    return json;
}

// The page ------------------------------------------------------------------------------------------------

std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string card(const Part& part, const Stop& stop) {
    std::string text = fmt::format(
        "<article class=\"card\" id=\"{0}-{1}\">\n<header><h3>{2}</h3>{3}</header>\n", html(part.name),
        html(stop.scene.name), html(spoken(stop.scene.name)), html_verdict(stop.passed(), stop.word()));
    if (!stop.problem.empty()) return text + "<p>" + html(stop.problem) + "</p>\n</article>\n";
    const std::string here = part.name + "/", name = spoken(stop.scene.name);
    // Our own scenes begin with a sentence about themselves; those of others with whatever they like.
    if (stop.verdict)
        text +=
            fmt::format("<p class=\"quiet\">{}</p>\n", html(opening_comment(read_file(stop.scene.scene))));
    std::vector<PageFigure> figures;
    const auto add = [&](const std::string& file, std::string alt, std::string caption) {
        figures.push_back({here + file, std::move(alt), std::move(caption), stop.width, stop.height});
    };
    add(picture_of(stop), fmt::format("Our picture of the scene “{}”.", name), stop.verdict ? "ours" : "");
    if (stop.verdict) {
        add(reference_of(stop), fmt::format("POV-Ray's picture of the scene “{}”.", name), "POV-Ray");
        add(difference_of(stop),
            fmt::format("Their difference, amplified; at most {} steps of 1/65535.", greatest_text(stop)),
            fmt::format("difference × {}", difference_gain));
    }
    text += html_figures(figures);
    if (!stop.scene.why_none.empty())
        text += fmt::format("<p class=\"quiet\">No reference: {}</p>\n", html(stop.scene.why_none));
    std::vector<std::pair<std::string, std::string>> facts = {
        {"size", fmt::format("{} × {}", stop.width, stop.height)}, {"time", time_text(stop) + " ms"}};
    if (stop.verdict) {
        if (stop.rays > 0) facts.emplace_back("rays a second", rate_text(stop));
        facts.emplace_back("greatest difference", greatest_text(stop) + " / 65535");
        if (stop.verdict->ratio) {
            facts.emplace_back("estimated RMS error × true over estimated", error_text(stop));
        } else {
            facts.emplace_back("pixels over 2 steps", over_text(stop));
            facts.emplace_back("of them not at silhouettes", unexplained_text(stop));
        }
    }
    return text + html_facts(facts) + "</article>\n";
}

std::string overview(const std::vector<Part>& parts) {
    std::string text =
        "<section class=\"card scroll\" tabindex=\"0\" aria-label=\"All scenes in one table\">\n<table>\n"
        "<caption>Times are of one run of the whole tour. Differences are in steps of 1/65535 of linear "
        "light. Error: of random samples, as estimated × what it really is of that.</caption>\n<thead><tr>";
    for (const auto* head : {"chapter", "scene", "size", "ms", "rays/s", "greatest difference",
                             "pixels over 2", "not at silhouettes", "error", "verdict"})
        text += fmt::format("<th scope=\"col\">{}</th>", head);
    text += "</tr></thead>\n<tbody>\n";
    for (const Part& part : parts)
        for (const Stop& stop : part.stops) {
            text += fmt::format("<tr><td>{0}</td><th scope=\"row\"><a href=\"#{0}-{1}\">{2}</a></th>",
                                html(part.name), html(stop.scene.name), html(spoken(stop.scene.name)));
            for (const auto& cell : {size_text(stop), time_text(stop), rate_text(stop), greatest_text(stop),
                                     over_text(stop), unexplained_text(stop), error_text(stop)})
                text += "<td>" + cell + "</td>";
            text += "<td>" + html_verdict(stop.passed(), stop.word()) + "</td></tr>\n";
        }
    return text + "</tbody>\n</table>\n</section>\n";
}

std::string tour_page(const std::vector<Part>& parts, std::size_t compared, std::size_t failed) {
    std::string text = fmt::format(
        "<header>\n<h1>A tour of the ray tracing course</h1>\n"
        "<p class=\"quiet\">Every scene, rendered a moment ago with the solutions, beside the same scene "
        "rendered by "
        "POV-Ray. {} compared, {}. Equal means: at most 2 steps of 1/65535 everywhere, save at most 0.1 % of "
        "the "
        "pixels, all at silhouettes, where the two programs may decide differently what a ray hits. Pictures "
        "of "
        "random samples are not equal to any other; their difference must be what they say of their own "
        "error, "
        "within a factor 1.5.</p>\n"
        "<nav aria-label=\"Chapters\"><ul>\n",
        counted(static_cast<long long>(compared), "picture"),
        failed == 0 ? "all equal" : fmt::format("{} failed", failed));
    for (const Part& part : parts)
        text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", html(part.name), html(part.title));
    text += "</ul></nav>\n</header>\n<main>\n" + overview(parts);
    for (const Part& part : parts) {
        text += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p class=\"quiet\">{}</p>\n", html(part.name),
                            html(part.title), html(part.summary));
        const bool gallery =
            std::ranges::none_of(part.stops, [](const Stop& stop) { return stop.verdict.has_value(); });
        if (gallery) text += "<div class=\"gallery\">\n";
        for (const Stop& stop : part.stops) text += card(part, stop);
        text += gallery ? "</div>\n</section>\n" : "</section>\n";
    }
    return html_page("A tour of the ray tracing course", text + "</main>\n");
}

}  // namespace

Verdict judge_samples(const Image& image, const Image& reference, Real rms_error) {
    require_same_size(image, reference);
    Verdict verdict;
    Real squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        verdict.greatest = std::max(verdict.greatest, steps_between(image.pixels[i], reference.pixels[i]));
        const Vec3 difference = image.pixels[i] - reference.pixels[i];
        squares += glm::dot(difference, difference);
    }
    verdict.ratio = std::sqrt(squares / static_cast<Real>(3 * image.pixels.size())) / rms_error;
    verdict.passed = *verdict.ratio <= gate_ratio && *verdict.ratio >= 1 / gate_ratio;
    return verdict;
}

Verdict judge(const Image& image, const Image& reference,
              const std::function<std::vector<std::uint64_t>()>& decisions) {
    require_same_size(image, reference);
    Verdict verdict;
    std::vector<std::size_t> over;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Real steps = steps_between(image.pixels[i], reference.pixels[i]);
        verdict.greatest = std::max(verdict.greatest, steps);
        if (steps > gate_steps) over.push_back(i);
    }
    verdict.over = over.size();
    if (!over.empty()) {
        const std::vector<std::uint64_t> decided = decisions();
        const auto width = static_cast<std::size_t>(image.width);
        for (const std::size_t i : over)
            if (!is_silhouette(decided, image.width, image.height, static_cast<int>(i % width),
                               static_cast<int>(i / width)))
                ++verdict.unexplained;
    }
    verdict.passed = verdict.unexplained == 0 &&
                     static_cast<Real>(verdict.over) <= gate_share * static_cast<Real>(image.pixels.size());
    return verdict;
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

int run_tour(const TourOptions& options, const Project& project) {
    const fs::path output = options.output.empty() ? project.build / "tour" : options.output;
    std::vector<Part> parts = parts_of(project);
    std::size_t count = 0, done = 0, compared = 0, failed = 0;
    for (const Part& part : parts) count += part.stops.size();
    if (count == 0) throw InputError("there are no scenes in references/");
    require_places(parts, output);
    {
        Progress progress("tour", !options.json && !options.quiet);
        for (Part& part : parts) {
            for (Stop& stop : part.stops) {
                const std::string label = part.name + "/" + stop.scene.name;
                const auto tell = [&](Real fraction) {
                    progress.update((static_cast<double>(done) + fraction) / static_cast<double>(count),
                                    label);
                };
                try {
                    visit(stop, output / part.name, tell);
                } catch (const std::exception& error) {
                    stop.problem = error.what();
                }
                ++done;
                if (stop.verdict) ++compared;
                if (!stop.passed()) ++failed;
            }
        }
    }
    const fs::path page = output / "index.html";
    write_file(page, tour_page(parts, compared, failed));

    if (options.json) {
        nlohmann::ordered_json json = {{"scenes", nlohmann::ordered_json::array()}};
        for (const Part& part : parts)
            for (const Stop& stop : part.stops) json["scenes"].push_back(json_of(stop));
        json["compared"] = compared;
        json["failed"] = failed;
        json["page"] = page.string();
        fmt::print("{}\n", json_text(json, 2));
    } else if (!options.quiet) {
        print_table(parts);
        fmt::print(
            "{} compared, {}; the page is {}\n", counted(static_cast<long long>(compared), "picture"),
            failed == 0 ? paint("all equal", Tone::Good) : paint(fmt::format("{} failed", failed), Tone::Bad),
            printable(relative(project, page)));
    }
    return failed == 0 ? 0 : 1;
}

}  // namespace rt
