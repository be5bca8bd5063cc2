// The report's plots: gnuplot scripts of common/evidence/plots, below what their variables are for some data.
#include "common/evidence/report.hpp"

#include "common/image/whole_file.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// A text in single quotes.
std::string in_quotes(std::string_view text) {
    std::string literal = "'";
    for (const char c : text) literal += c == '\'' ? std::string("''") : std::string(1, c);
    return literal + "'";
}

/// A text in single quotes, without gnuplot's own markup.
std::string without_markup(std::string text) {
    for (char& c : text)
        if (std::string_view("_^@&~{}\\").find(c) != std::string_view::npos) c = ' ';
    return in_quotes(text);
}

/// Lines of gnuplot that give variables their values.
struct Variables {
    std::string text;

    void number(std::string_view name, double value) { text += fmt::format("{} = {}\n", name, value); }
    void literal(std::string_view name, const std::string& value) {
        text += fmt::format("{} = {}\n", name, value);
    }
    /// An array of literals, counted from 1.
    void list(std::string_view name, const std::vector<std::string>& values) {
        text += fmt::format("array {}[{}] = [{}]\n", name, values.size(), fmt::join(values, ", "));
    }
};

/// The plot NAME: what it is of, its variables, then the scripts of common/evidence/plots that draw it.
ReportPlot plot(const std::string& name, int width, int height, const Variables& variables,
                const std::string& script, const std::string& table, const std::string& alt) {
    const fs::path plots = this_project().root / "common/evidence/plots";
    const std::string head = fmt::format(
        "# Draws {0}.svg from {1} beside it: gnuplot {0}.gp\nname = '{0}'\nwidth = {2}\nheight = "
        "{3}\n",
        name, table, width, height);
    return {name,
            width,
            height,
            head + variables.text + "\n" + read_file(plots / "style.gp") + "\n" +
                read_file(plots / (script + ".gp")),
            table,
            alt};
}

/// A minus is as wide as a plus.
std::string with_real_minus(std::string text) {
    for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos;) text.replace(at, 1, "−");
    return text;
}

/// The exponent of a law with half its confidence interval.
std::string exponent(const ReportData& law) {
    const double slope = law.at("slope");
    if (law.at("low").is_null()) return with_real_minus(fmt::format("{:.2f}", slope));
    const double half = (law.at("high").get<double>() - law.at("low").get<double>()) / 2;
    return with_real_minus(fmt::format("{:.2f} ± {:.2f}", slope, half));
}

std::string power_of(const ReportData& law) { return in_quotes("N^{" + exponent(law) + "}"); }

// ---------------------------------------------------------------------------------------------- kernels

/// A colour of a plot: what it stands for, and by how many methods.
struct KernelColor {
    std::string look;
    int methods = 0;
};

ReportPlot kernel_plot(const ReportData& kernels, const std::string& shape) {
    std::map<int, KernelColor> colors;
    double slowest = 20'000;
    for (const auto& row : kernels.at("rows")) {
        if (row.at("shape") != shape) continue;
        KernelColor& color = colors[row.at("color")];
        color.look = row.at("look");
        ++color.methods;
        slowest = std::max(slowest, 2 * row.at("ns").get<double>());
    }
    Variables variables;
    variables.literal("shape", in_quotes(shape));
    variables.number("slowest", slowest);
    std::string shown, names, several;
    for (const auto& [color, one] : colors) {
        shown += fmt::format("{} ", color);
        names += in_quotes(one.look) + " ";
        if (one.methods > 1) several += fmt::format("{} ", color);
    }
    variables.literal("colors", in_quotes(shown));
    variables.literal("names", '"' + names + '"');
    variables.literal("several", in_quotes(several));
    return plot("kernels_" + shape, 700, 560, variables, "kernels", "kernels.csv",
                fmt::format("Time a call and error of t for the methods of intersecting a ray with a {}; a "
                            "dashed line is the demand of 8 κu.",
                            shape));
}

ReportPlot map_plot(const ReportData& kernels) {
    std::vector<std::string> titles, first, last;
    std::size_t rows = 0;
    for (const auto& map : kernels.at("maps")) {
        titles.push_back(without_markup(map.at("method")));
        first.push_back(std::to_string(rows));
        rows += map.at("digits").size();
        last.push_back(std::to_string(rows - 1));
    }
    Variables variables;
    variables.number("maps", static_cast<double>(titles.size()));
    variables.list("title", titles);
    variables.list("first", first);
    variables.list("last", last);
    return plot(
        "kernels_map", 1000, 400, variables, "kernels_map", "kernels_map.csv",
        "Correct decimal digits of t by distance over radius and by how deep the ray passes under the rim: "
        "the textbook formula loses all of them far away, the stable one keeps what the data allow.");
}

// --------------------------------------------------------------------------------------------- pictures

bool is_lone(const ReportData& curve) { return curve.at("points").size() < 2; }

/// What the key says of a method: its name, the exponent of its error, and in brackets that of the theory.
std::string curve_title(const ReportData& curve) {
    std::string title = curve.at("method");
    if (is_lone(curve) || curve.at("by_samples").at("points") < 2) return title;
    title += "  " + exponent(curve.at("by_samples"));
    if (curve.at("theory") != 0)
        title += with_real_minus(fmt::format(" ({:g})", curve.at("theory").get<double>()));
    return title;
}

struct Range {
    double least = 1e9, greatest = 0;
    void add(double x) { least = std::min(least, x), greatest = std::max(greatest, x); }
};

/// `of` says what the curves are ways of; their points are in the table `kind`.csv.
ReportPlot picture_plot(const ReportData& scene, const std::string& kind, const std::string& of) {
    std::vector<ReportData> curves = scene.at("curves");
    std::stable_partition(curves.begin(), curves.end(), is_lone);
    std::vector<std::string> methods, titles;
    Range errors, seconds;
    for (const auto& curve : curves) {
        methods.push_back(in_quotes(std::string(curve.at("method"))));
        titles.push_back(without_markup(curve_title(curve)));
        for (const auto& point : curve.at("points")) {
            errors.add(point.at("error"));
            seconds.add(point.at("seconds"));
        }
    }
    const double truth = scene.at("truth_error");
    const bool shows_truth = truth > errors.least / 1e4;  // else it lies far below the plot

    Variables variables;
    variables.literal("table", in_quotes(kind + ".csv"));
    variables.literal("scene", in_quotes(std::string(scene.at("name"))));
    variables.number("curves", static_cast<double>(curves.size()));
    variables.number("lone", static_cast<double>(std::ranges::count_if(curves, is_lone)));
    variables.list("method", methods);
    variables.list("title", titles);
    variables.number("truth", shows_truth ? truth : 0);
    variables.number("least", shows_truth ? std::min(errors.least, truth) : errors.least);
    variables.number("greatest", errors.greatest);
    variables.number("fastest", seconds.least);
    variables.number("slowest", seconds.greatest);
    return plot(kind + "_" + std::string(scene.at("name")), 700, 560, variables, "pictures", kind + ".csv",
                fmt::format("Error against CPU time for several ways of {}, scene: {}.", of,
                            std::string(scene.at("title"))));
}

ReportPlot honesty_plot(const ReportData& pictures) {
    std::vector<std::string> methods;
    for (const auto& curve : pictures.front().at("curves"))
        if (!is_lone(curve)) methods.push_back(in_quotes(std::string(curve.at("method"))));
    Variables variables;
    variables.number("curves", static_cast<double>(methods.size()));
    variables.list("method", methods);
    return plot(
        "honesty", 700, 480, variables, "honesty", "pictures.csv",
        "True error over the error that renders estimate of themselves, for all scenes and methods; the grey "
        "band is a factor 1.5 either way.");
}

// ------------------------------------------------------------------------------------------------ grids

Variables sizes(const ReportData& grids) {
    Variables variables;
    variables.number("fewest", grids.at("points").front().at("triangles"));
    variables.number("most", grids.at("points").back().at("triangles"));
    return variables;
}

ReportPlot ray_plot(const ReportData& grids) {
    Variables variables = sizes(grids);
    variables.literal("grid_law", power_of(grids.at("grid_ray")));
    variables.literal("brute_law", power_of(grids.at("brute_ray")));
    return plot(
        "grids_rays", 700, 480, variables, "grids_rays", "grids.csv",
        "Rays a second against the number of triangles: a grid slows down a little, asking every triangle in "
        "proportion.");
}

ReportPlot build_plot(const ReportData& grids) {
    Variables variables = sizes(grids);
    variables.literal("build_law", power_of(grids.at("build")));
    return plot("grids_build", 700, 480, variables, "grids_build", "grids.csv",
                "Time to build a grid, and the number of rays from which on building it has paid, against "
                "the number of triangles.");
}

// -------------------------------------------------------------------------------------------- leave out

ReportPlot leave_out_plot(const ReportData& rows) {
    double most = 1.02;
    for (const auto& row : rows) {
        const auto& counts = row.at("instructions");
        const double minimal = counts.at("minimal"), general = counts.at("general"),
                     limit = counts.at("limit");
        // What is shown and not demanded may lie outside.
        if (row.at("judged")) most = std::max({most, general / minimal, limit / minimal});
    }
    Variables variables;
    variables.number("rows", static_cast<double>(rows.size()));
    variables.number("most", most);
    return plot(
        "leave_out", 760, 90 + 30 * static_cast<int>(rows.size()), variables, "leave_out", "leave_out.csv",
        "For each feature, the instructions of the general renderer over those of one written for just the "
        "scene; a bar marks what is allowed.");
}

}  // namespace

std::vector<ReportPlot> report_plots(const ReportData& data) {
    std::vector<ReportPlot> plots;
    if (data.contains("kernels")) {
        for (const auto& family : data.at("kernels").at("families"))
            plots.push_back(kernel_plot(data.at("kernels"), family.at("shape")));
        plots.push_back(map_plot(data.at("kernels")));
    }
    if (data.contains("pictures")) {
        for (const auto& scene : data.at("pictures"))
            plots.push_back(picture_plot(scene, "pictures", "sampling"));
        plots.push_back(honesty_plot(data.at("pictures")));
    }
    if (data.contains("filters"))
        for (const auto& scene : data.at("filters"))
            plots.push_back(picture_plot(scene, "filters", "looking up a texture"));
    for (const auto& [kind, of] : {std::pair{"blurs", "sampling"},
                                   {"blurs_compared", "blurring"},
                                   {"povray", "blurring, and of POV-Ray's"}})
        if (data.contains(kind))
            for (const auto& scene : data.at(kind)) plots.push_back(picture_plot(scene, kind, of));
    if (data.contains("grids")) {
        plots.push_back(ray_plot(data.at("grids")));
        plots.push_back(build_plot(data.at("grids")));
    }
    if (data.contains("leave_out")) plots.push_back(leave_out_plot(data.at("leave_out")));
    return plots;
}

void draw(const ReportPlot& plot, const fs::path& directory) {
    write_file(directory / (plot.name + ".gp"), plot.script);
    const ProcessResult result = run_process(
        {"gnuplot", "-e", "cd " + in_quotes(fs::absolute(directory).string()), plot.name + ".gp"});
    const fs::path drawn = directory / (plot.name + ".svg");
    if (!succeeded(result) || !fs::exists(drawn))
        throw std::runtime_error(fmt::format("gnuplot could not draw {}.gp:\n{}", plot.name, result.output));
    write_file(drawn, svg_for_light_and_dark(read_file(drawn)));
}

std::string svg_for_light_and_dark(const std::string& svg) {
    const std::size_t at = svg.find("<title>");
    if (at == std::string::npos) return svg;
    // A rule of a style sheet goes before the attributes that gnuplot writes.
    const std::string style = read_file(this_project().root / "common/evidence/plots/plot.css");
    return svg.substr(0, at) + "<style>\n" + style + "</style>\n" + svg.substr(at);
}

}  // namespace rt
