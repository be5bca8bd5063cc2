// What `course report` shows, measured by the programs report_data and leave_out.
#include "common/evidence/measurements.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace rt {

namespace fs = std::filesystem;

namespace {

void build(const Project& project, const WantedReports& wanted) {
    std::vector<std::string> targets;
    if (wanted.error_time || wanted.stability) targets.push_back("report_data");
    if (wanted.leave_out) targets.push_back("leave_out");
    const BuildResult result = build_targets(project, targets, "Building");
    if (!result.ok) throw InputError("the measuring programs cannot be built: " + result.message);
}

/// What the program report_data measures; through a file, because there may be more of it than of messages.
ReportData measured(const Project& project, const WantedReports& wanted, bool quick,
                    const fs::path& directory) {
    const fs::path file = directory / "measured.json";
    std::vector<std::string> arguments{program(project, "report_data").string(), "-o", file.string()};
    if (quick) arguments.push_back("--quick");
    if (wanted.error_time)
        arguments.insert(arguments.end(),
                         {"kernels", "pictures", "filters", "blurs", "povray", "grids", "searches"});
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

void require(const std::string& program, const std::string& why, const std::string& package) {
    if (!succeeded(run_process({program, "--version"})))
        throw InputError(fmt::format("{} is needed {}, and is not installed: sudo apt-get install {}",
                                     program, why, package));
}

}  // namespace

WantedReports wanted_reports(const std::string& name) {
    if (name.empty()) return {true, true, true};
    const WantedReports wanted{name == "error-time", name == "stability", name == "leave-out"};
    if (!wanted.error_time && !wanted.stability && !wanted.leave_out)
        throw InputError(
            fmt::format("there is no report '{}'; there are error-time, stability and leave-out", name));
    return wanted;
}

void require_measuring_programs(const WantedReports& wanted) {
    require("gnuplot", "to draw the plots", "gnuplot-nox");
    if (wanted.leave_out) require("valgrind", "to count instructions", "valgrind libc6-dbg");
}

void add_measurements(ReportData& data, const Project& project, const WantedReports& wanted, bool quick,
                      const fs::path& directory) {
    build(project, wanted);
    data["machine"] = machine();
    if (wanted.error_time || wanted.stability) data.update(measured(project, wanted, quick, directory));
    if (wanted.leave_out) data["leave_out"] = left_out(project);
}

}  // namespace rt
