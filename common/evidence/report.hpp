// The pieces of `course report`: tables for spreadsheets, plots for gnuplot, and the page around them.
// All read the JSON that the program report_data writes (tests/report/report_data.cpp).
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

using ReportData = nlohmann::ordered_json;

/// A file of the report: its name in the directory, and what is in it.
struct ReportFile {
    std::string name;
    std::string content;
};

/// One CSV a kind of measurement that `data` has.
std::vector<ReportFile> report_tables(const ReportData& data);

/// A plot: a gnuplot script NAME.gp, which reads the CSVs beside it and writes NAME.svg.
struct ReportPlot {
    std::string name;
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    std::string script;
    std::string table;  ///< the CSV that it shows
    std::string alt;    ///< what is to be seen, for who can't see it
};

/// The plots of what `data` has, in the order of the page.
std::vector<ReportPlot> report_plots(const ReportData& data);

/// Writes the plot's script into `directory`, beside its table, and has gnuplot draw it. Throws
/// std::runtime_error, with gnuplot's messages, if it cannot.
void draw(const ReportPlot& plot, const std::filesystem::path& directory);

/// The SVG that gnuplot wrote with colours that follow the reader's preference for light or dark.
std::string svg_for_light_and_dark(const std::string& svg);

/// The page. `command` is the command line that made it.
std::string report_page(const ReportData& data, const std::vector<ReportPlot>& plots,
                        const std::string& command);

/// What breaks a demand, one sentence each.
std::vector<std::string> report_problems(const ReportData& data);

/// A number as people write it: three digits, 1.2e-05 as 1.2 · 10⁻⁵; "–" for what is no number.
std::string number_text(const ReportData& number);

/// All of the data, each number in it written by `number_text`.
ReportData numbers_as_text(ReportData data);

}  // namespace rt
