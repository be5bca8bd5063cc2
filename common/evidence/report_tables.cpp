// The report's data as tables for spreadsheets.
#include "common/evidence/report.hpp"
#include "common/terminal/json_text.hpp"

#include <string_view>

namespace rt {
namespace {

/// A cell: text in quotes where it has to be, numbers with all their digits, nothing for null.
std::string cell(const ReportData& value) {
    if (value.is_null()) return "";
    if (!value.is_string()) return json_text(value);
    const std::string text = value;
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

/// A table with a line of names and lines of cells.
struct Table {
    std::string text;

    explicit Table(const std::vector<std::string_view>& names) {
        line(names, [](auto name) { return name; });
    }
    void row(const std::vector<ReportData>& cells) { line(cells, cell); }

    template <class Items, class Text>
    void line(const Items& items, Text to_text) {
        bool first = true;
        for (const auto& item : items) {
            if (!first) text += ',';
            first = false;
            text += to_text(item);
        }
        text += '\n';
    }
};

ReportFile kernel_table(const ReportData& kernels) {
    Table table({"shape", "method", "number", "ns", "error_median", "error_9999", "error_max", "cases",
                 "wrong", "undecided", "color"});
    for (const auto& row : kernels.at("rows"))
        table.row({row.at("shape"), row.at("method"), row.at("number"), row.at("ns"), row.at("error_median"),
                   row.at("error_9999"), row.at("error_max"), row.at("cases"), row.at("wrong"),
                   row.at("undecided"), row.at("color")});
    return {"kernels.csv", table.text};
}

ReportFile map_table(const ReportData& kernels) {
    Table table({"method", "log10_distance_over_radius", "log10_depth_over_radius", "correct_digits"});
    for (const auto& map : kernels.at("maps")) {
        std::size_t i = 0;
        for (const auto& tangency : map.at("tangency"))
            for (const auto& distance : map.at("distance")) {
                const auto& digits = map.at("digits").at(i++);
                table.row({map.at("method"), distance, tangency, digits.is_null() ? "NaN" : digits});
            }
    }
    return {"kernels_map.csv", table.text};
}

ReportFile picture_table(const ReportData& pictures, const std::string& name) {
    Table table({"scene", "method", "samples_asked", "samples_a_pixel", "cpu_seconds", "rmse",
                 "estimated_rmse", "least_ratio", "greatest_ratio"});
    for (const auto& scene : pictures)
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points"))
                table.row({scene.at("name"), curve.at("method"), point.at("asked"), point.at("samples"),
                           point.at("seconds"), point.at("error"), point.at("estimate"),
                           point.at("ratio_low"), point.at("ratio_high")});
    return {name, table.text};
}

/// The same with the rays that a pixel takes.
ReportFile blur_table(const ReportData& scenes, const std::string& name) {
    Table table({"scene", "method", "samples_asked", "samples_a_pixel", "cpu_seconds", "rmse",
                 "estimated_rmse", "least_ratio", "greatest_ratio", "rays_a_pixel"});
    for (const auto& scene : scenes)
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points"))
                table.row({scene.at("name"), curve.at("method"), point.at("asked"), point.at("samples"),
                           point.at("seconds"), point.at("error"), point.at("estimate"),
                           point.at("ratio_low"), point.at("ratio_high"), point.at("rays")});
    return {name, table.text};
}

ReportFile slope_table(const ReportData& pictures, const std::string& name) {
    Table table({"scene", "method", "theory", "slope_by_samples", "low", "high", "slope_by_seconds", "low",
                 "high", "stopped_by"});
    for (const auto& scene : pictures)
        for (const auto& curve : scene.at("curves")) {
            if (curve.at("points").size() < 2) continue;
            const auto &samples = curve.at("by_samples"), &seconds = curve.at("by_seconds");
            table.row({scene.at("name"), curve.at("method"),
                       curve.at("theory") == 0 ? ReportData(nullptr) : curve.at("theory"),
                       samples.at("slope"), samples.at("low"), samples.at("high"), seconds.at("slope"),
                       seconds.at("low"), seconds.at("high"), curve.at("stopped")});
        }
    return {name, table.text};
}

ReportFile grid_table(const ReportData& grids) {
    Table table({"triangles", "build_seconds", "grid_ns_a_ray", "brute_ns_a_ray", "cells_a_ray",
                 "triangles_asked_a_ray", "bytes_a_triangle", "break_even_rays", "rays", "brute_rays",
                 "different"});
    for (const auto& point : grids.at("points")) {
        std::vector<ReportData> cells;
        for (const auto* name : {"triangles", "build_seconds", "grid_ns", "brute_ns", "cells", "asked",
                                 "bytes", "break_even", "rays", "brute_rays", "different"})
            cells.push_back(point.at(name));
        table.row(cells);
    }
    return {"grids.csv", table.text};
}

ReportFile search_table(const ReportData& searches) {
    Table table({"scene", "way", "triangles", "build_seconds", "ns_a_ray", "nodes_a_ray",
                 "triangles_asked_a_ray", "bytes_a_triangle", "break_even_rays", "predicted_cost",
                 "paid_by_lines", "compared", "different"});
    for (const auto& point : searches) {
        std::vector<ReportData> cells;
        for (const auto* name : {"scene", "way", "triangles", "build_seconds", "ns", "nodes", "asked",
                                 "bytes", "break_even", "predicted", "paid", "compared", "different"})
            cells.push_back(point.at(name));
        table.row(cells);
    }
    return {"searches.csv", table.text};
}

ReportFile stability_table(const ReportData& rows) {
    Table table({"chapter", "question", "family", "condition_number", "demand", "cases", "undecided", "wrong",
                 "worst_error_in_demands", "worst_case", "first_wrong_case", "textbook_method",
                 "textbook_cases", "textbook_wrong", "textbook_first_wrong_case"});
    for (const auto& row : rows) {
        const auto &stable = row.at("stable"), &naive = row.at("naive");
        table.row({row.at("chapter"), row.at("question"), row.at("family"), row.at("condition"),
                   row.at("demand"), stable.at("cases"), stable.at("undecided"), stable.at("wrong"),
                   stable.at("worst"), stable.at("worst_case"), stable.at("first_wrong"), row.at("textbook"),
                   naive.at("cases"), naive.at("wrong"), naive.at("first_wrong")});
    }
    return {"stability.csv", table.text};
}

ReportFile leave_out_table(const ReportData& rows) {
    Table table({"a_scene_without", "instructions", "instructions_of_a_minimal_renderer", "ratio", "limit",
                 "instructions_with_it", "camera_rays", "shadow_rays", "reflection_rays", "refraction_rays",
                 "bytes", "bytes_with_it", "judged"});
    for (const auto& row : rows) {
        const auto &counts = row.at("instructions"), &rays = row.at("rays").at("general");
        const double general = counts.at("general"), minimal = counts.at("minimal");
        table.row({row.at("feature"), counts.at("general"), counts.at("minimal"), general / minimal,
                   counts.at("limit"), counts.at("with_feature"), rays.at("camera"), rays.at("shadow"),
                   rays.at("reflection"), rays.at("refraction"), row.at("bytes").at("general"),
                   row.at("bytes").at("with_feature"), row.at("judged")});
    }
    return {"leave_out.csv", table.text};
}

}  // namespace

std::vector<ReportFile> report_tables(const ReportData& data) {
    std::vector<ReportFile> tables;
    if (data.contains("kernels")) {
        tables.push_back(kernel_table(data.at("kernels")));
        tables.push_back(map_table(data.at("kernels")));
    }
    if (data.contains("pictures")) {
        tables.push_back(picture_table(data.at("pictures"), "pictures.csv"));
        tables.push_back(slope_table(data.at("pictures"), "slopes.csv"));
    }
    if (data.contains("filters")) tables.push_back(picture_table(data.at("filters"), "filters.csv"));
    for (const char* kind : {"blurs", "blurs_compared", "povray"})
        if (data.contains(kind)) tables.push_back(blur_table(data.at(kind), std::string(kind) + ".csv"));
    if (data.contains("blurs")) tables.push_back(slope_table(data.at("blurs"), "blurs_slopes.csv"));
    if (data.contains("grids")) tables.push_back(grid_table(data.at("grids")));
    if (data.contains("searches")) tables.push_back(search_table(data.at("searches")));
    if (data.contains("stability")) tables.push_back(stability_table(data.at("stability")));
    if (data.contains("leave_out")) tables.push_back(leave_out_table(data.at("leave_out")));
    return tables;
}

}  // namespace rt
