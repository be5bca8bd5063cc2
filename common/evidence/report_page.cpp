// The report's page: what the templates in pages/ show of the data, ready to be read.
#include "common/evidence/report.hpp"
#include "common/math/vec.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace rt {
namespace {

/// Numbers that are whole, whatever type they have.
ReportData whole(const ReportData& number) { return static_cast<long long>(number.get<double>()); }

std::string measuring_time(const ReportData& data) {
    if (!data.contains("seconds")) return "–";
    double sum = 0;
    for (const auto& part : data.at("seconds")) sum += part.get<double>();
    return duration(sum);
}

PageView plots_view(const std::vector<ReportPlot>& plots) {
    PageView view = PageView::object();
    for (const ReportPlot& plot : plots)
        view[plot.name] = {{"name", plot.name},
                           {"width", plot.width},
                           {"height", plot.height},
                           {"alt", plot.alt},
                           {"table", plot.table}};
    return view;
}

PageView kernels_view(const ReportData& kernels, const PageView& plots) {
    PageView shapes = PageView::array();
    for (const auto& family : kernels.at("families")) {
        PageView rows = PageView::array();
        for (const auto& row : kernels.at("rows"))
            if (row.at("shape") == family.at("shape")) rows.push_back(numbers_as_text(row));
        shapes.push_back({{"shape", family.at("shape")},
                          {"words", family.at("words")},
                          {"cases", number_text(family.at("cases"))},
                          {"plot", plots.value("kernels_" + std::string(family.at("shape")), PageView())},
                          {"rows", rows}});
    }
    return {{"shapes", shapes}};
}

/// What a scene's plot says below it; `kind` is what the plot's name begins with.
PageView scene_view(const ReportData& scene, const std::string& kind, const PageView& plots) {
    PageView flat = PageView::array();
    for (const auto& curve : scene.at("curves"))
        if (const std::string by = curve.at("stopped"); !by.empty() && !by.starts_with("nothing"))
            flat.push_back({{"method", curve.at("method")}, {"by", by}});
    const double best = scene.at("best"), truth = scene.at("truth_error");
    return {{"title", scene.at("title")},
            {"chapter", scene.at("chapter")},
            {"size", fmt::format("{} × {}", scene.at("width").get<int>(), scene.at("height").get<int>())},
            {"analytic", scene.at("analytic")},
            {"truth_samples", number_text(scene.at("truth_samples"))},
            {"truth_error", number_text(scene.at("truth_error"))},
            {"better", fmt::format("{:.0f}", best / truth)},
            {"flat", flat},
            {"plot", plots.value(kind + "_" + std::string(scene.at("name")), PageView())}};
}

PageView exponents_view(const ReportData& pictures) {
    PageView rows = PageView::array();
    for (const auto& scene : pictures)
        for (const auto& curve : scene.at("curves")) {
            if (curve.at("points").size() < 2) continue;
            rows.push_back({{"title", scene.at("title")},
                            {"method", curve.at("method")},
                            {"theory", curve.at("theory") == 0 ? "–" : number_text(curve.at("theory"))},
                            {"by_samples", numbers_as_text(curve.at("by_samples"))},
                            {"by_seconds", numbers_as_text(curve.at("by_seconds"))},
                            {"stopped", curve.at("stopped")}});
        }
    return rows;
}

/// The true errors of a method's pictures over those that they estimate.
struct Honesty {
    std::string method;
    int points = 0, within = 0;
    double least = 1e9, greatest = 0;
};

PageView honesty_view(const ReportData& pictures) {
    std::vector<Honesty> methods;
    for (const auto& scene : pictures)
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points")) {
                const double estimate = point.at("estimate");
                if (!(estimate > 0)) continue;
                const double ratio = point.at("error").get<double>() / estimate;
                auto at = std::ranges::find(methods, std::string(curve.at("method")), &Honesty::method);
                if (at == methods.end()) at = methods.insert(at, Honesty{.method = curve.at("method")});
                ++at->points;
                at->within += ratio >= 1 / 1.5 && ratio <= 1.5;
                at->least = std::min(at->least, ratio);
                at->greatest = std::max(at->greatest, ratio);
            }
    PageView rows = PageView::array();
    for (const Honesty& method : methods)
        rows.push_back({{"method", method.method},
                        {"within", method.within},
                        {"points", method.points},
                        {"least", number_text(method.least)},
                        {"greatest", number_text(method.greatest)}});
    return rows;
}

PageView pictures_view(const ReportData& pictures, const PageView& plots) {
    PageView scenes = PageView::array();
    for (const auto& scene : pictures) scenes.push_back(scene_view(scene, "pictures", plots));
    return {{"scenes", scenes}, {"exponents", exponents_view(pictures)}, {"honesty", honesty_view(pictures)}};
}

/// All points of a scene's curves, one below the other.
PageView filters_view(const ReportData& filters, const PageView& plots) {
    PageView scenes = PageView::array(), points = PageView::array();
    for (const auto& scene : filters) {
        scenes.push_back(scene_view(scene, "filters", plots));
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points"))
                points.push_back({{"method", curve.at("method")},
                                  {"samples", number_text(point.at("asked"))},
                                  {"error", number_text(point.at("error"))},
                                  {"ms", number_text(point.at("seconds").get<double>() * 1e3)}});
    }
    return {{"scenes", scenes}, {"points", points}};
}

/// CPU seconds until a curve is no more wrong than `error`, on a straight line of logarithms between its
/// points; those of its first point if that is not. Nothing if it never is.
std::optional<double> seconds_to(const ReportData& curve, double error) {
    const auto logarithm = [](const ReportData& point, const char* what) {
        return std::log(point.at(what).get<double>());
    };
    const ReportData* before = nullptr;
    for (const auto& point : curve.at("points")) {
        if (point.at("error").get<double>() <= error) {
            if (!before) return point.at("seconds").get<double>();
            const double from = logarithm(*before, "error"), to = logarithm(point, "error");
            const double start = logarithm(*before, "seconds"), end = logarithm(point, "seconds");
            return std::exp(start + (end - start) * (std::log(error) - from) / (to - from));
        }
        before = &point;
    }
    return std::nullopt;
}

/// How long each way takes until it is as wrong as the scene's first one is at its second point.
PageView equal_errors_view(const ReportData& scenes) {
    PageView rows = PageView::array();
    for (const auto& scene : scenes) {
        if (scene.at("name") == "together") continue;  // a truth each
        const ReportData& first = scene.at("curves").at(0);
        const double error = first.at("points").at(1).at("error");
        const double its_own = seconds_to(first, error).value_or(infinity);
        for (const auto& curve : scene.at("curves")) {
            double best = infinity;
            for (const auto& point : curve.at("points"))
                best = std::min(best, point.at("error").get<double>());
            const std::optional<double> seconds = seconds_to(curve, error);
            rows.push_back({{"title", scene.at("title")},
                            {"method", curve.at("method")},
                            {"error", number_text(error)},
                            {"ms", seconds ? number_text(*seconds * 1e3) : "not reached"},
                            {"times", seconds ? number_text(*seconds / its_own) : "–"},
                            {"best", number_text(best)}});
        }
    }
    return rows;
}

PageView blurs_view(const ReportData& data, const PageView& plots) {
    const ReportData &blurs = data.at("blurs"), &compared = data.at("blurs_compared");
    PageView scenes = PageView::array(), ways = PageView::array(), beside = PageView::array(),
             points = PageView::array();
    for (const auto& scene : blurs) scenes.push_back(scene_view(scene, "blurs", plots));
    for (const auto& scene : compared) {
        ways.push_back(scene_view(scene, "blurs_compared", plots));
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points"))
                points.push_back({{"title", scene.at("title")},
                                  {"method", curve.at("method")},
                                  {"samples", number_text(point.at("asked"))},
                                  {"rays", number_text(point.at("rays"))},
                                  {"error", number_text(point.at("error"))},
                                  {"ms", number_text(point.at("seconds").get<double>() * 1e3)}});
    }
    PageView view = {
        {"scenes", scenes}, {"exponents", exponents_view(blurs)},   {"honesty", honesty_view(blurs)},
        {"ways", ways},     {"equal", equal_errors_view(compared)}, {"points", points}};
    if (data.contains("povray")) {
        for (const auto& scene : data.at("povray")) beside.push_back(scene_view(scene, "povray", plots));
        view["povray"] = {{"scenes", beside}, {"equal", equal_errors_view(data.at("povray"))}};
    }
    return view;
}

PageView grids_view(const ReportData& grids) {
    PageView points = PageView::array();
    for (ReportData point : grids.at("points")) {
        point["triangles"] = whole(point.at("triangles"));
        point["break_even"] = whole(point.at("break_even"));
        point["build_ms"] = point.at("build_seconds").get<double>() * 1e3;
        point["faster"] = point.at("brute_ns").get<double>() / point.at("grid_ns").get<double>();
        points.push_back(numbers_as_text(point));
    }
    return {{"points", points}};
}

/// The ways of each scene together; scenes in the order of the data.
PageView searches_view(const ReportData& searches) {
    PageView scenes = PageView::array();
    for (const auto& point : searches) {
        if (scenes.empty() || scenes.back().at("scene") != point.at("scene"))
            scenes.push_back({{"scene", point.at("scene")},
                              {"triangles", whole(point.at("triangles"))},
                              {"ways", PageView::array()}});
        const bool built = point.at("bytes") > 0, predicted = point.at("predicted") > 0;
        scenes.back()["ways"].push_back(
            {{"way", point.at("way")},
             {"build_ms", built ? number_text(point.at("build_seconds").get<double>() * 1e3) : "–"},
             {"bytes", built ? number_text(point.at("bytes")) : "–"},
             {"nodes", built ? number_text(point.at("nodes")) : "–"},
             {"asked", number_text(point.at("asked"))},
             {"ns", number_text(point.at("ns"))},
             {"break_even", built ? whole(point.at("break_even")) : "–"},
             {"predicted", predicted ? number_text(point.at("predicted")) : "–"},
             {"paid", predicted ? number_text(point.at("paid")) : "–"},
             {"different", number_text(point.at("different"))},
             {"compared", number_text(point.at("compared"))}});
    }
    return {{"scenes", scenes}};
}

/// The rows of each chapter together; chapters in the order of the data.
PageView stability_view(const ReportData& rows) {
    PageView chapters = PageView::array();
    for (const auto& row : rows) {
        if (chapters.empty() || chapters.back().at("chapter") != row.at("chapter"))
            chapters.push_back({{"chapter", row.at("chapter")}, {"rows", PageView::array()}});
        PageView& chapter = chapters.back();
        PageView shown = numbers_as_text(row);
        shown["passed"] = row.at("stable").at("wrong") == 0;
        shown["word"] = number_text(row.at("stable").at("wrong"));
        chapter["rows"].push_back(shown);
        if (row.at("stable").at("worst_case") != "") chapter["has_worst_cases"] = true;
    }
    return {{"chapters", chapters}};
}

PageView leave_out_view(const ReportData& cases) {
    PageView rows = PageView::array();
    for (const auto& row : cases) {
        const auto &counts = row.at("instructions"), &bytes = row.at("bytes");
        double rays = 0;
        for (const auto& kind : row.at("rays").at("minimal")) rays += kind.get<double>();
        const double general = counts.at("general"), minimal = counts.at("minimal"),
                     limit = counts.at("limit"), with_it = counts.at("with_feature");
        rows.push_back({{"feature", row.at("feature")},
                        {"general", number_text(general / rays)},
                        {"minimal", number_text(minimal / rays)},
                        {"judged", row.at("judged")},
                        {"passed", general <= limit},
                        {"word", fmt::format("{:.4f}", general / minimal)},
                        {"allowed", fmt::format("{:.4f}", limit / minimal)},
                        {"with_it", fmt::format("{:.2f}", with_it / general)},
                        {"bytes", number_text(bytes.at("general"))},
                        {"bytes_with_it", number_text(bytes.at("with_feature"))}});
    }
    return {{"rows", rows}};
}

}  // namespace

std::string report_page(const ReportData& data, const std::vector<ReportPlot>& plots,
                        const std::string& command) {
    const bool passed = data.at("problems").empty();
    PageView view = {{"title", "Measured: a ray tracing course"},
                     {"command", command},
                     {"quick", data.at("quick")},
                     {"passed", passed},
                     {"word", passed ? "every demand is met" : "some demands are not met"},
                     {"has_problems", !passed},
                     {"problems", data.at("problems")},
                     {"machine", numbers_as_text(data.at("machine"))},
                     {"measuring", measuring_time(data)},
                     {"plots", plots_view(plots)}};
    if (data.contains("kernels")) view["kernels"] = kernels_view(data.at("kernels"), view.at("plots"));
    if (data.contains("pictures")) view["pictures"] = pictures_view(data.at("pictures"), view.at("plots"));
    if (data.contains("filters")) view["filters"] = filters_view(data.at("filters"), view.at("plots"));
    if (data.contains("blurs")) view["blurs"] = blurs_view(data, view.at("plots"));
    if (data.contains("grids")) view["grids"] = grids_view(data.at("grids"));
    if (data.contains("searches")) view["searches"] = searches_view(data.at("searches"));
    if (data.contains("stability")) view["stability"] = stability_view(data.at("stability"));
    if (data.contains("leave_out")) view["leave_out"] = leave_out_view(data.at("leave_out"));
    return page_from("common/evidence/pages/report.mustache", view);
}

}  // namespace rt
