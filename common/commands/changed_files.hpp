// What the commands say that keep generated files true to their sources.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Tells which files differ from what is generated, or, if `make`, were written; `repair` is the command that
/// writes them. Returns the exit status: 1 if any differ and were not written.
int report_changed(const std::vector<std::string>& files, bool make, bool json, const char* repair);

}  // namespace rt
