// `course report`: error against run time, stability and what scenes leave out, measured and shown on a page.
#include "common/evidence/report.hpp"
#include "common/commands/commands.hpp"
#include "common/evidence/measurements.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::string command_line(const ReportCommand& command) {
    std::string line = "./course report";
    if (!command.what.empty()) line += " " + command.what;
    if (command.quick) line += " --quick";
    return line;
}

void draw_all(const std::vector<ReportPlot>& plots, const fs::path& directory) {
    Progress progress("drawing");
    for (std::size_t i = 0; i < plots.size(); ++i) {
        draw(plots[i], directory);
        progress.update(static_cast<double>(i + 1) / static_cast<double>(plots.size()));
    }
}

void print(const std::vector<std::string>& problems, const std::string& page) {
    for (const std::string& problem : problems) fmt::print("{} {}\n", paint("✗", Tone::Bad), problem);
    if (problems.empty()) fmt::print("{} every demand is met\n", paint("✓", Tone::Good));
    fmt::print("{}\n", printable(page));
}

void print_json(ReportData data, const fs::path& page) {
    data["output"] = page.string();
    if (data.contains("kernels")) data["kernels"].erase("maps");  // thousands of numbers; they are in the CSV
    fmt::print("{}\n", json_text(data));
}

}  // namespace

int run_report(const ReportCommand& command) {
    const WantedReports wanted = wanted_reports(command.what);
    const Project project = this_project();
    const fs::path directory = command.output.empty() ? project.build / "report" : command.output;
    make_directories(directory);
    require_measuring_programs(wanted);

    ReportData data{{"command", command_line(command)}, {"quick", command.quick}};
    add_measurements(data, project, wanted, command.quick, directory);
    const std::vector<std::string> problems = report_problems(data);
    data["problems"] = problems;

    for (const ReportFile& table : report_tables(data)) write_file(directory / table.name, table.content);
    const std::vector<ReportPlot> plots = report_plots(data);
    draw_all(plots, directory);
    const fs::path page = directory / "index.html";
    write_file(page, report_page(data, plots, command_line(command)));
    write_file(directory / "measured.json", json_text(data, 1) + "\n");

    if (command.json)
        print_json(data, page);
    else
        print(problems, relative(project, page));
    return problems.empty() ? 0 : 1;
}

}  // namespace rt
