// `course tour`: every scene rendered, compared with its reference and shown on a page.
#include "common/evidence/tour.hpp"
#include "common/commands/commands.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

/// The tour's files can be written, and none of its pictures is one that it is to be compared with.
void require_places(const std::vector<TourPart>& tour, const fs::path& output) {
    make_directories(output);
    for (const TourPart& part : tour) {
        const fs::path directory = output / part.name;
        make_directories(directory);
        for (const TourStop& stop : part.stops)
            for (const std::string& name : {picture_of(stop), reference_of(stop), difference_of(stop)}) {
                require_no_input(directory / name, {stop.scene.scene, stop.scene.picture});
                require_writable(directory / name);
            }
    }
    require_writable(output / "index.html");
}

void visit_all(std::vector<TourPart>& tour, const fs::path& output, bool shows_progress) {
    Progress progress("tour", shows_progress);
    const auto total = static_cast<double>(count(tour).stops);
    double done = 0;
    for (TourPart& part : tour)
        for (TourStop& stop : part.stops) {
            const std::string label = part.name + "/" + stop.scene.name;
            visit(stop, output / part.name,
                  [&](Real fraction) { progress.update((done + fraction) / total, label); });
            ++done;
        }
}

/// `text` to the right of a field; counts letters, not bytes.
std::string right(const std::string& text, std::size_t width) {
    const auto letters = static_cast<std::size_t>(std::ranges::count(text, false, continues_utf8));
    return std::string(letters < width ? width - letters : 0, ' ') + text;
}

std::string row(std::string_view chapter, std::string_view scene, const std::vector<std::string>& cells) {
    std::string text = fmt::format("{:<16} {:<24}", chapter, scene);
    for (const std::string& cell : cells) text += " " + right(cell, 9);
    return text;
}

void print_table(const std::vector<TourPart>& tour) {
    fmt::print("{}\n", paint(row("chapter", "scene",
                                 {"size", "ms", "rays/s", "greatest", "over 2", "inside", "error"}),
                             Tone::Dim));
    for (const TourPart& part : tour)
        for (const TourStop& stop : part.stops) {
            const StopText text = text_of(stop);
            fmt::print(
                "{}  {}\n",
                row(part.name, stop.scene.name,
                    {text.size, text.ms, text.rate, text.greatest, text.over, text.inside, text.error}),
                paint(text.word, passed(stop) ? Tone::Good : Tone::Bad));
            if (!stop.problem.empty()) fmt::print("    {}\n", printable(stop.problem));
        }
    fmt::print("{}\n",
               paint("greatest: difference in steps of 1/65535; over 2: pixels that differ by more than 2; "
                     "inside: of them, not at silhouettes; error: of random samples, as estimated × what it "
                     "really is of that",
                     Tone::Dim));
}

ordered_json to_json(const TourStop& stop) {
    ordered_json json = {{"chapter", stop.scene.chapter}, {"scene", stop.scene.name}, {"width", stop.width},
                         {"height", stop.height},         {"seconds", stop.seconds},  {"rays", stop.rays}};
    if (stop.agreement) {
        json["greatest16"] = std::lround(stop.agreement->greatest);
        json["over"] = stop.agreement->over;
        json["unexplained"] = stop.agreement->unexplained;
        if (stop.agreement->ratio) {
            json["rms_error"] = stop.estimate;
            json["error_over_estimate"] = *stop.agreement->ratio;
        }
    }
    if (!stop.scene.why_none.empty()) json["why_none"] = stop.scene.why_none;
    if (!stop.problem.empty()) json["problem"] = stop.problem;
    json["passed"] = passed(stop);
    return json;
}

void print_json(const std::vector<TourPart>& tour, const TourCount& counts, const fs::path& page) {
    ordered_json json = {{"scenes", ordered_json::array()}};
    for (const TourPart& part : tour)
        for (const TourStop& stop : part.stops) json["scenes"].push_back(to_json(stop));
    json["compared"] = counts.compared;
    json["failed"] = counts.failed;
    json["page"] = page.string();
    fmt::print("{}\n", json_text(json, 2));
}

}  // namespace

int run_tour(const TourCommand& command, const Project& project) {
    const fs::path output = command.output.empty() ? project.build / "tour" : command.output;
    std::vector<TourPart> tour = tour_of(project);
    if (count(tour).stops == 0) throw InputError("there are no scenes in references/");
    require_places(tour, output);
    visit_all(tour, output, !command.json && !command.quiet);
    const fs::path page = output / "index.html";
    write_file(page, tour_page(tour));

    const TourCount counts = count(tour);
    if (command.json) {
        print_json(tour, counts, page);
    } else if (!command.quiet) {
        print_table(tour);
        fmt::print("{} compared, {}; the page is {}\n", counted(counts.compared, "picture"),
                   counts.failed == 0 ? paint("all equal", Tone::Good)
                                      : paint(fmt::format("{} failed", counts.failed), Tone::Bad),
                   printable(relative(project, page)));
    }
    return counts.failed == 0 ? 0 : 1;
}

}  // namespace rt
