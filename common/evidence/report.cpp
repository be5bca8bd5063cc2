// `course report`: error against run time, stability and what scenes leave out, measured and shown on a page.
#include "common/evidence/report.hpp"

#include "common/workbook/check.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/evidence/report_parts.hpp"
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace rt {

namespace fs = std::filesystem;

namespace {

bool available(const std::string& program) { return succeeded(run_process({program, "--version"})); }

struct Wanted {
    bool error_time, stability, leave_out;

    explicit Wanted(const std::string& what)
        : error_time(what.empty() || what == "error-time"),
          stability(what.empty() || what == "stability"),
          leave_out(what.empty() || what == "leave-out") {
        if (!error_time && !stability && !leave_out)
            throw InputError(
                fmt::format("there is no report '{}'; there are error-time, stability and leave-out", what));
    }
};

void require(bool there, const std::string& program, const std::string& why, const std::string& package) {
    if (!there)
        throw InputError(fmt::format("{} is needed {}, and is not installed: sudo apt-get install {}",
                                     program, why, package));
}

void build(const Project& project, const Wanted& wanted) {
    std::vector<std::string> targets;
    if (wanted.error_time || wanted.stability) targets.push_back("report_data");
    if (wanted.leave_out) targets.push_back("leave_out");
    const BuildResult result = build_targets(project, targets, "Building");
    if (!result.ok) throw InputError("the measuring programs cannot be built: " + result.message);
}

/// What the program report_data measures; through a file, because there may be more of it than of messages.
ReportData measured(const Project& project, const Wanted& wanted, bool quick, const fs::path& directory) {
    const fs::path file = directory / "measured.json";
    std::vector<std::string> arguments{program(project, "report_data").string(), "-o", file.string()};
    if (quick) arguments.push_back("--quick");
    if (wanted.error_time) arguments.insert(arguments.end(), {"kernels", "pictures", "grids"});
    if (wanted.stability) arguments.push_back("stability");
    ProcessOptions options;
    options.merge_errors = false;  // it shows its progress
    const ProcessResult result = run_process(arguments, options);
    if (!succeeded(result)) throw std::runtime_error("report_data failed" + result.output);
    return ReportData::parse(read_file(file));
}

ReportData left_out(const Project& project) {
    Progress progress("leaving out");
    ProcessOptions options;
    options.merge_errors = false;
    const ProcessResult result = run_process({program(project, "leave_out").string(), "--json"}, options);
    if (!succeeded(result)) throw std::runtime_error("leave_out failed");
    return ReportData::parse(result.output).at("cases");
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
    return "unknown";
}

ReportData machine() {
#ifdef __clang__
    const std::string compiler = "clang " __clang_version__;
#else
    const std::string compiler = "g++ " __VERSION__;
#endif
    double load = 0;
    const bool known = getloadavg(&load, 1) == 1;
    return {{"processor", processor()},
            {"cores", std::thread::hardware_concurrency()},
            {"compiler", compiler},
            {"load", known ? ReportData(load) : ReportData(nullptr)}};
}

std::string quoted_for_gnuplot(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
    return quoted + "'";
}

void draw(const ReportPlot& plot, const fs::path& directory) {
    write_file(directory / (plot.name + ".gp"), plot.script);
    const ProcessResult result = run_process(
        {"gnuplot", "-e", "cd " + quoted_for_gnuplot(fs::absolute(directory).string()), plot.name + ".gp"});
    const fs::path drawn = directory / (plot.name + ".svg");
    if (!succeeded(result) || !fs::exists(drawn))
        throw std::runtime_error(fmt::format("gnuplot could not draw {}.gp:\n{}", plot.name, result.output));
    write_file(drawn, svg_for_light_and_dark(read_file(drawn)));
}

std::string command_line(const ReportCommand& command) {
    std::string line = "./course report";
    if (!command.what.empty()) line += " " + command.what;
    if (command.quick) line += " --quick";
    return line;
}

}  // namespace

int run_report(const ReportCommand& command) {
    const Wanted wanted(command.what);
    const Project project = this_project();
    const fs::path directory = command.output.empty() ? project.build / "report" : command.output;
    make_directories(directory);
    require(available("gnuplot"), "gnuplot", "to draw the plots", "gnuplot-nox");
    require(!wanted.leave_out || available("valgrind"), "valgrind", "to count instructions",
            "valgrind libc6-dbg");

    build(project, wanted);
    ReportData data{{"command", command_line(command)}, {"quick", command.quick}, {"machine", machine()}};
    if (wanted.error_time || wanted.stability)
        data.update(measured(project, wanted, command.quick, directory));
    if (wanted.leave_out) data["leave_out"] = left_out(project);
    const std::vector<std::string> problems = report_problems(data);
    data["problems"] = problems;

    for (const ReportFile& table : report_tables(data)) write_file(directory / table.name, table.content);
    const std::vector<ReportPlot> plots = report_plots(data);
    {
        Progress progress("drawing");
        for (std::size_t i = 0; i < plots.size(); ++i) {
            draw(plots[i], directory);
            progress.update(static_cast<double>(i + 1) / static_cast<double>(plots.size()));
        }
    }
    const fs::path page = directory / "index.html";
    write_file(page, report_page(data, plots, command_line(command)));
    write_file(directory / "measured.json", json_text(data, 1) + "\n");

    if (command.json) {
        data["output"] = page.string();
        if (data.contains("kernels"))
            data["kernels"].erase("maps");  // thousands of numbers; they are in the CSV
        fmt::print("{}\n", json_text(data));
    } else {
        for (const std::string& problem : problems) fmt::print("{} {}\n", paint("✗", Tone::Bad), problem);
        if (problems.empty()) fmt::print("{} every demand is met\n", paint("✓", Tone::Good));
        fmt::print("{}\n", printable(relative(project, page)));
    }
    return problems.empty() ? 0 : 1;
}

}  // namespace rt
