// What of this machine's system a box needs to run programs, and to compile them.
#pragma once

#include "common/sandbox/sandbox.hpp"

#include <string>
#include <vector>

namespace rt {

/// What a dynamically linked program needs: shared libraries and their loader. A static one needs nothing.
std::vector<Mount> library_mounts();

/// What g++ needs to compile and link: programs, libraries, headers. Call it g++ (not c++, a link through
/// /etc).
std::vector<Mount> compiler_mounts();

/// What a compiler may use up.
Limits compiler_limits();

/// Options that hold back diagnostics: a mistake in a template can be five megabytes of them.
std::vector<std::string> short_diagnostics();

}  // namespace rt
