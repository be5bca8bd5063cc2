// What `course report` shows, measured by the programs report_data and leave_out (tests/report,
// tests/leave_out).
#pragma once

#include "common/evidence/report.hpp"
#include "common/terminal/project.hpp"

#include <filesystem>
#include <string>

namespace rt {

/// Which reports are wanted.
struct WantedReports {
    bool error_time = false, stability = false, leave_out = false;
};

/// The report of this name, "error-time", "stability" or "leave-out", or all for an empty one. Throws
/// InputError, with the names that there are.
WantedReports wanted_reports(const std::string& name);

/// Throws InputError, which says how to install it, where a program is missing that measuring needs.
void require_measuring_programs(const WantedReports& wanted);

/// Builds the programs, runs them and adds what they have measured and on what machine to `data`. `directory`
/// exists and is where the programs may write. Throws InputError if they cannot be built.
void add_measurements(ReportData& data, const Project& project, const WantedReports& wanted, bool quick,
                      const std::filesystem::path& directory);

}  // namespace rt
