// The report's plots, as scripts for gnuplot that read the CSVs beside them.
#include "common/evidence/report.hpp"

#include "common/image/whole_file.hpp"
#include "common/terminal/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace rt {

namespace fs = std::filesystem;

namespace {

// Colours that can be read on white and on nearly black.
constexpr std::string_view red = "#d1495b", blue = "#1d83d4", green = "#2f9e6b", orange = "#d98514",
                           violet = "#8f6fd6", grey = "#858c95";

/// A text in single quotes, without gnuplot's own markup.
std::string literal(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'')
            quoted += "''";
        else if (std::string_view("_^@&~{}\\").find(c) != std::string_view::npos)
            quoted += ' ';
        else
            quoted += c;
    }
    return quoted + "'";
}

std::string begin(const std::string& name, int width, int height, bool skip_missing = true) {
    return fmt::format(
        "# Draws {0}.svg from the tables beside it: gnuplot {0}.gp\n"
        "set terminal svg size {1},{2} enhanced font 'sans-serif,15' linewidth 1.2 background '#ffffff'\n"
        "set output '{0}.svg'\n"
        "set encoding utf8\n"
        "set datafile separator ','\n"
        "{3}"
        "set border linewidth 0.6\n"
        "set tics scale 0.6\n"
        "set grid linecolor rgb '#d0d3d8' linewidth 0.5 dashtype 1\n"
        "set pointsize 0.6\n",
        name, width, height, skip_missing ? "set datafile missing NaN\n" : "");
}

// ---------------------------------------------------------------------------------------------- kernels

/// A way to compute an intersection that has a colour of its own.
struct KernelWay {
    std::string_view name;
    std::string_view rows;  ///< which rows of kernels.csv it is, for gnuplot
    std::string_view color;
};

constexpr KernelWay kernel_ways[] = {
    {"textbook", "strcol(2) eq 'textbook'", red},
    {"textbook with its constants", "strcol(2) eq 'textbook with its constants'", orange},
    {"stable", "(strcol(2) eq 'stable' || strcol(2) eq 'watertight') && strcol(3) ne 'interval'", blue},
    {"intervals", "strcol(3) eq 'interval'", green},
    {"exact", "strcol(3) eq 'exact'", violet},
};

ReportPlot kernel_plot(const ReportData& kernels, const std::string& shape) {
    constexpr int width = 700, height = 560;
    const std::string name = "kernels_" + shape;
    std::string script = begin(name, width, height) +
                         "set logscale xy\nset xrange [2:20000]\nset yrange [1e-4:1e14]\nset format y "
                         "'10^{%T}'\nset ytics 1e3\n"
                         "set xlabel 'nanoseconds a call'\nset ylabel 'error of t, in units of κu|t|'\n"
                         "set arrow from graph 0,first 8 to graph 1,first 8 nohead linecolor rgb '#7c848e' "
                         "dashtype 2\nset label 'demand: 8 κu' at graph 0.98,first 8 right offset 0,0.6 "
                         "textcolor rgb '#7c848e' font ',13'\n"
                         "set bmargin at screen 0.26\nset key at screen 0.55,0.015 center bottom vertical "
                         "maxrows 3 samplen 1 font ',14'\n";
    // What a method computes with stands beside its point: the textbook's on the left, the course's on the
    // right.
    for (const auto& row : kernels.at("rows")) {
        const std::string method = row.at("method"), number = row.at("number");
        if (row.at("shape") != shape || row.at("error_max").is_null()) continue;
        if (number == "exact" || number == "interval" || method == "textbook with its constants") continue;
        const bool textbook = method == "textbook";
        script += fmt::format("set label {} at {},{} {} textcolor rgb '{}' font ',14'\n", literal(number),
                              row.at("ns").get<double>(), row.at("error_max").get<double>(),
                              textbook ? "right offset -1,0.2" : "left offset 1,0.2", textbook ? red : blue);
    }
    script += "plot ";
    bool first = true;
    for (const KernelWay& way : kernel_ways) {
        const bool there = std::ranges::any_of(kernels.at("rows"), [&](const auto& row) {
            return row.at("shape") == shape &&
                   (way.name != "textbook with its constants" || row.at("method") == way.name);
        });
        if (!there) continue;
        const auto column = [&](std::string_view y) {
            return fmt::format("'kernels.csv' skip 1 using 4:(strcol(1) eq '{}' && {} ? {} : NaN)", shape,
                               way.rows, y);
        };
        script += fmt::format("{}{} with points pointtype 7 linecolor rgb '{}' title '{}', \\\n",
                              first ? "" : ", \\\n", column("$7"), way.color, way.name);
        script += fmt::format("{} with points pointtype 2 linecolor rgb '{}' notitle, \\\n", column("$6"),
                              way.color);
        script += fmt::format("{}:(0):($7-$5) with vectors nohead linewidth 0.8 linecolor rgb '{}' notitle",
                              column("$5"), way.color);
        first = false;
    }
    return {name,
            width,
            height,
            script + "\n",
            "kernels.csv",
            fmt::format(
                "Time a call and error of t for the methods of intersecting a ray with a {}; a dashed line "
                "is the demand of 8 κu.",
                shape)};
}

ReportPlot map_plot(const ReportData& kernels) {
    constexpr int width = 1000, height = 400;
    std::string script =
        begin("kernels_map", width, height, false) +
        "set multiplot layout 1,3 margins 0.10,0.89,0.20,0.89 spacing 0.02,0\n"
        "unset key\nunset grid\nset cbrange [0:16]\nset cbtics 4\n"
        "set palette defined (0 '#7a1f3d', 4 '#d1495b', 8 '#f0b429', 12 '#58b67c', 16 "
        "'#14537d')\n"
        "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '#8e959e' "
        "fillstyle solid 0.35 noborder\n"
        "set xrange [0:8]\nset yrange [-16:0]\nset xtics 1,2,7 format '10^{%.0f}'\nset ytics 4 "
        "format '10^{%.0f}'\nset xlabel 'distance / radius'\nset ylabel 'depth under the rim / radius'\n";
    const auto& maps = kernels.at("maps");
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::size_t cells = maps[i].at("digits").size();
        if (i > 0) script += "set format y ''\nunset ylabel\n";
        script += fmt::format(
            "{}set colorbox{}\nset title {}\n", i + 1 < maps.size() ? "un" : "",
            i + 1 < maps.size() ? ""
                                : " user origin 0.91,0.20 size 0.015,0.69\nset cblabel 'correct digits of t'",
            literal(maps[i].at("method")));
        script += fmt::format("plot 'kernels_map.csv' skip 1 every ::{}::{} using 2:3:4 with image pixels\n",
                              i * cells, (i + 1) * cells - 1);
    }
    script += "unset multiplot\n";
    return {
        "kernels_map",
        width,
        height,
        script,
        "kernels_map.csv",
        "Correct decimal digits of t by distance over radius and by how deep the ray passes under the rim: "
        "the textbook formula loses all of them far away, the stable one keeps what the data allow."};
}

// --------------------------------------------------------------------------------------------- pictures

std::string_view picture_color(const std::string& method) {
    constexpr std::pair<std::string_view, std::string_view> colors[] = {{"random", red},
                                                                        {"regular", orange},
                                                                        {"jittered", blue},
                                                                        {"Poisson disk", green},
                                                                        {"adaptive", violet}};
    for (const auto& [name, color] : colors)
        if (method == name) return color;
    return grey;
}

std::string exponent(const ReportData& law) {
    if (law.at("low").is_null()) return fmt::format("{:.2f}", law.at("slope").get<double>());
    const double half = (law.at("high").get<double>() - law.at("low").get<double>()) / 2;
    return fmt::format("{:.2f} ± {:.2f}", law.at("slope").get<double>(), half);
}

std::string curve_title(const ReportData& curve) {
    std::string title = std::string(curve.at("method")) + "  " + exponent(curve.at("by_samples"));
    if (curve.at("theory") != 0) title += fmt::format(" ({:g})", curve.at("theory").get<double>());
    // A real minus is as wide as a plus.
    for (std::size_t at = 0; (at = title.find('-', at)) != std::string::npos;) title.replace(at, 1, "−");
    return title;
}

ReportPlot picture_plot(const ReportData& scene) {
    constexpr int width = 700, height = 560;
    const std::string scene_name = scene.at("name"), name = "pictures_" + scene_name;
    double low = 1e9, high = 0, fast = 1e9, slow = 0;
    for (const auto& curve : scene.at("curves"))
        for (const auto& point : curve.at("points")) {
            low = std::min(low, point.at("error").get<double>());
            high = std::max(high, point.at("error").get<double>());
            fast = std::min(fast, point.at("seconds").get<double>());
            slow = std::max(slow, point.at("seconds").get<double>());
        }
    const double truth = scene.at("truth_error");
    const bool floor = truth > low / 1e4;  // else it lies far below the plot
    std::string script =
        begin(name, width, height) +
        fmt::format(
            "set logscale xy\nset format y '10^{{%T}}'\nset format x '%.0s %cs'\nset xlabel 'CPU time'\n"
            "set ylabel 'root mean square error'\nset bmargin at screen 0.26\nset key at screen 0.55,0.015 "
            "center bottom vertical maxrows 3 samplen 2 width -3 font ',14'\n"
            "set xrange [{}:{}]\nset yrange [{}:{}]\n",
            fast / 1.7, slow * 1.7, (floor ? std::min(low, truth) : low) / 2, high * 2);
    if (floor)
        script += fmt::format(
            "set arrow from graph 0,first {0} to graph 1,first {0} nohead linecolor rgb '#7c848e' dashtype "
            "2\n"
            "set label 'standard error of the truth' at graph 0.98,first {0} right offset 0,0.6 textcolor "
            "rgb "
            "'#7c848e' font ',13'\n",
            truth);
    script += "plot ";
    bool first = true;
    for (const auto& curve : scene.at("curves")) {
        const std::string method = curve.at("method");
        const bool alone = curve.at("points").size() < 2;
        script += fmt::format(
            "{}'pictures.csv' skip 1 using 5:(strcol(1) eq '{}' && strcol(2) eq '{}' ? $6 : NaN) with {} "
            "pointtype "
            "7 linewidth 1.6 linecolor rgb '{}' title {}",
            first ? "" : ", \\\n", scene_name, method, alone ? "points" : "linespoints",
            picture_color(method), alone ? literal(method) : literal(curve_title(curve)));
        first = false;
    }
    return {name,
            width,
            height,
            script + "\n",
            "pictures.csv",
            fmt::format("Error against CPU time for several ways of sampling, scene: {}.",
                        std::string(scene.at("title")))};
}

ReportPlot honesty_plot(const ReportData& pictures) {
    constexpr int width = 700, height = 480;
    std::string script =
        begin("honesty", width, height) +
        "set logscale xy\nset xlabel 'samples a pixel'\nset ylabel 'true error / estimated error'\n"
        "set yrange [0.05:4]\nset xrange [3:400]\nset ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 4)\n"
        "set bmargin at screen 0.25\nset key at screen 0.55,0.015 center bottom vertical maxrows 2 samplen 1 "
        "font ',14'\n"
        "set object 1 rectangle from graph 0,first 1/1.5 to graph 1,first 1.5 behind fillcolor rgb "
        "'#8e959e' fillstyle solid 0.25 noborder\nplot ";
    bool first = true;
    double shift = 0.9;
    for (const auto& curve : pictures.front().at("curves")) {
        if (curve.at("points").size() < 2) continue;
        const std::string method = curve.at("method");
        // Side by side, so that the methods' points do not cover each other.
        script += fmt::format(
            "{}'pictures.csv' skip 1 using ($3*{}):(strcol(2) eq '{}' && $7 > 0 ? "
            "($6/$7 > 0.05 ? $6/$7 : 0.052) : NaN) "
            "with points pointtype 7 linecolor rgb '{}' title {}",
            first ? "" : ", \\\n", shift, method, picture_color(method), literal(method));
        first = false;
        shift += 0.05;
    }
    return {
        "honesty",
        width,
        height,
        script + "\n",
        "pictures.csv",
        "True error over the error that renders estimate of themselves, for all scenes and methods; the grey "
        "band is a factor 1.5 either way."};
}

// ------------------------------------------------------------------------------------------------ grids

std::string power_of(const ReportData& law) {
    std::string text = exponent(law);
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return "N^{" + text + "}";
}

std::string size_range(const ReportData& grids) {
    const auto& points = grids.at("points");
    return fmt::format("set xrange [{}:{}]\n", points.front().at("triangles").get<double>() / 1.5,
                       points.back().at("triangles").get<double>() * 1.5);
}

ReportPlot ray_plot(const ReportData& grids) {
    constexpr int width = 700, height = 480;
    const std::string script =
        begin("grids_rays", width, height) +
        "set logscale xy\nset format '10^{%T}'\nset xlabel 'triangles N'\nset ylabel 'rays a second'\n"
        "set key bottom left\n" +
        size_range(grids) +
        fmt::format(
            "plot 'grids.csv' skip 1 using 1:(1e9/$3) with linespoints pointtype 7 linewidth 1.6 linecolor "
            "rgb '{}' title 'grid: time a ray as {}', \\\n'grids.csv' skip 1 using 1:(1e9/$4) with "
            "linespoints pointtype 7 linewidth 1.6 linecolor rgb '{}' title 'every triangle: {}'\n",
            blue, power_of(grids.at("grid_ray")), red, power_of(grids.at("brute_ray")));
    return {
        "grids_rays",
        width,
        height,
        script,
        "grids.csv",
        "Rays a second against the number of triangles: a grid slows down a little, asking every triangle in "
        "proportion."};
}

ReportPlot build_plot(const ReportData& grids) {
    constexpr int width = 700, height = 480;
    const std::string script =
        begin("grids_build", width, height) +
        "set logscale xy\nset format x '10^{%T}'\nset format y '%.0s %cs'\nset xlabel 'triangles N'\n"
        "set ylabel 'time to build the grid'\nset y2tics\nset logscale y2\nset format y2 '%g'\nset ytics "
        "nomirror\n"
        "set y2range [10:10000]\nset y2label 'rays until building has paid'\nset key top left\n" +
        size_range(grids) +
        fmt::format(
            "plot 'grids.csv' skip 1 using 1:2 with linespoints pointtype 7 linewidth 1.6 linecolor rgb '{}' "
            "title 'time to build: {}', \\\n'grids.csv' skip 1 using 1:8 axes x1y2 with linespoints "
            "pointtype 7 linewidth 1.6 linecolor rgb '{}' title 'rays until it has paid (right)'\n",
            blue, power_of(grids.at("build")), orange);
    return {"grids_build",
            width,
            height,
            script,
            "grids.csv",
            "Time to build a grid, and the number of rays from which on building it has paid, against the "
            "number of "
            "triangles."};
}

// -------------------------------------------------------------------------------------------- leave out

ReportPlot leave_out_plot(const ReportData& rows) {
    const int width = 760, height = 90 + 30 * static_cast<int>(rows.size());
    double most = 1.02;
    std::string tics, limits;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& counts = rows[i].at("instructions");
        const double minimal = counts.at("minimal"), limit = counts.at("limit");
        // What is shown and not demanded may lie outside.
        if (rows[i].at("judged"))
            most = std::max({most, counts.at("general").get<double>() / minimal, limit / minimal});
        tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", literal(rows[i].at("feature")), i);
        limits += fmt::format(
            "set arrow from {0},{1}-0.35 to {0},{1}+0.35 nohead linewidth 2 linecolor rgb '{2}'\n",
            limit / minimal, i, red);
    }
    const std::string script =
        begin("leave_out", width, height) +
        fmt::format(
            "set lmargin 30\nset yrange [{}:-0.7]\nset ytics ({})\nset xrange [{}:{}]\nset xlabel "
            "'instructions, over those of a renderer for just the scene'\nunset key\n{}"
            "set arrow from 1,graph 0 to 1,graph 1 nohead linecolor rgb 'black' linewidth 0.6\n"
            "plot 'leave_out.csv' skip 1 using 4:0 with points pointtype 7 linecolor rgb '{}'\n",
            static_cast<double>(rows.size()) - 0.3, tics, 0.995, most * 1.005, limits, blue);
    return {
        "leave_out",
        width,
        height,
        script,
        "leave_out.csv",
        "For each feature, the instructions of the general renderer over those of one written for just the "
        "scene; a bar marks what is allowed."};
}

}  // namespace

std::vector<ReportPlot> report_plots(const ReportData& data) {
    std::vector<ReportPlot> plots;
    if (data.contains("kernels")) {
        plots.push_back(kernel_plot(data.at("kernels"), "sphere"));
        plots.push_back(kernel_plot(data.at("kernels"), "triangle"));
        plots.push_back(map_plot(data.at("kernels")));
    }
    if (data.contains("pictures")) {
        for (const auto& scene : data.at("pictures")) plots.push_back(picture_plot(scene));
        plots.push_back(honesty_plot(data.at("pictures")));
    }
    if (data.contains("grids")) {
        plots.push_back(ray_plot(data.at("grids")));
        plots.push_back(build_plot(data.at("grids")));
    }
    if (data.contains("leave_out")) plots.push_back(leave_out_plot(data.at("leave_out")));
    return plots;
}

void draw(const ReportPlot& plot, const fs::path& directory) {
    write_file(directory / (plot.name + ".gp"), plot.script);
    std::string place = fs::absolute(directory).string();
    for (auto at = place.find('\''); at != std::string::npos; at = place.find('\'', at + 2))
        place.insert(at, 1, '\'');
    const ProcessResult result = run_process({"gnuplot", "-e", "cd '" + place + "'", plot.name + ".gp"});
    const fs::path drawn = directory / (plot.name + ".svg");
    if (!succeeded(result) || !fs::exists(drawn))
        throw std::runtime_error(fmt::format("gnuplot could not draw {}.gp:\n{}", plot.name, result.output));
    write_file(drawn, svg_for_light_and_dark(read_file(drawn)));
}

std::string svg_for_light_and_dark(const std::string& svg) {
    // A rule of a style sheet goes before the attributes that gnuplot writes.
    constexpr std::string_view style = R"css(<style>
image { image-rendering: pixelated }
@media (prefers-color-scheme: dark) {
  #gnuplot_canvas > [fill="#ffffff"] { fill: #1d2024 }
  [color="black"] { color: #d6d9dd } [stroke="black"] { stroke: #d6d9dd } [fill="black"] { fill: #d6d9dd }
  [stroke="rgb(  0,   0,   0)"] { stroke: #d6d9dd } [fill="rgb(0,0,0)"] { fill: #d6d9dd }
  [stroke="rgb(208, 211, 216)"] { stroke: #3a4047 }
}
</style>
)css";
    const std::size_t at = svg.find("<title>");
    if (at == std::string::npos) return svg;
    std::string result = svg;
    result.insert(at, style);
    return result;
}

}  // namespace rt
