// The tour's page: what the templates pages/tour*.mustache show of its stops.
#include "common/evidence/tour.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {
namespace {

std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

PageView figures_of(const TourPart& part, const TourStop& stop, const StopText& text) {
    const std::string name = spoken(stop.scene.name);
    PageView figures = PageView::array();
    const auto add = [&](const std::string& file, const std::string& alt, const std::string& caption) {
        figures.push_back({{"source", part.name + "/" + file},
                           {"alt", alt},
                           {"caption", caption},
                           {"width", stop.width},
                           {"height", stop.height}});
    };
    add(picture_of(stop), fmt::format("Our picture of the scene “{}”.", name), stop.agreement ? "ours" : "");
    if (!stop.agreement) return figures;
    add(reference_of(stop), fmt::format("POV-Ray's picture of the scene “{}”.", name), "POV-Ray");
    add(difference_of(stop),
        fmt::format("Their difference, amplified; at most {} steps of 1/65535.", text.greatest),
        fmt::format("difference × {}", difference_gain));
    return figures;
}

PageView view_of(const TourPart& part, const TourStop& stop) {
    const StopText text = text_of(stop);
    PageView view = {{"id", stop.scene.name},
                     {"scene", spoken(stop.scene.name)},
                     {"passed", passed(stop)},
                     {"word", text.word},
                     {"problem", stop.problem},
                     {"size", text.size},
                     {"ms", text.ms},
                     {"rate", text.rate},
                     {"greatest", text.greatest},
                     {"over", text.over},
                     {"inside", text.inside},
                     {"error", text.error}};
    if (!stop.problem.empty()) return view;
    view["width"] = stop.width;
    view["height"] = stop.height;
    view["figures"] = figures_of(part, stop, text);
    view["why_none"] = stop.scene.why_none;
    view["has_rays"] = stop.rays > 0;
    view["has_reference"] = stop.agreement.has_value();
    if (!stop.agreement) return view;
    view["random"] = stop.agreement->ratio.has_value();
    // Our own scenes begin with a sentence about themselves; those of others with whatever they like.
    view["about"] = opening_comment(read_file(stop.scene.scene));
    return view;
}

/// The first picture of a chapter, or nothing.
PageView cover_of(const TourPart& part) {
    const auto stop = std::ranges::find_if(part.stops, [](const TourStop& s) { return s.problem.empty(); });
    if (stop == part.stops.end()) return nullptr;
    return {
        {"source", part.name + "/" + picture_of(*stop)}, {"width", stop->width}, {"height", stop->height}};
}

}  // namespace

std::string tour_page(const std::vector<TourPart>& tour) {
    PageView parts = PageView::array();
    for (const TourPart& part : tour) {
        PageView stops = PageView::array();
        for (const TourStop& stop : part.stops) stops.push_back(view_of(part, stop));
        const bool gallery =
            std::ranges::none_of(part.stops, [](const TourStop& stop) { return stop.agreement.has_value(); });
        parts.push_back({{"chapter", part.name},
                         {"title", part.title},
                         {"summary", part.summary},
                         {"cover", cover_of(part)},
                         {"gallery", gallery},
                         {"stops", stops}});
    }
    const TourCount counts = count(tour);
    return page_from("common/evidence/pages/tour.mustache",
                     {{"title", "A tour of the ray tracing course"},
                      {"compared", counted(counts.compared, "picture")},
                      {"outcome", counts.failed == 0 ? "all equal" : fmt::format("{} failed", counts.failed)},
                      {"parts", parts}});
}

}  // namespace rt
