// `course report`: error against run time, stability and what scenes leave out, measured and shown on a page.
#pragma once

#include <filesystem>
#include <string>

namespace rt {

struct ReportCommand {
    std::string what;              ///< "error-time", "stability" or "leave-out"; empty: all three
    std::filesystem::path output;  ///< directory of the page; empty: `report` in the build directory
    bool quick = false;            ///< fewer cases and samples: half a minute instead of five
    bool json = false;
};

/// Builds and runs the measuring programs, writes their data as CSV, has gnuplot draw them, and writes the
/// page. Returns 1 if what was measured breaks a demand: a family with a wrong answer, a grid that differs
/// from brute force, a scene that pays for what it does not need. Throws InputError where gnuplot, valgrind
/// or the packages of the tests are missing.
int run_report(const ReportCommand& command);

}  // namespace rt
