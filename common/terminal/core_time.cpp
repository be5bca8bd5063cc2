// What a process gets of the machine, as Linux counts it.
#include "common/terminal/core_time.hpp"

#include <fmt/format.h>

#include <fstream>

namespace rt {

CoreTime core_time(pid_t process) {
    std::ifstream counts(fmt::format("/proc/{}/schedstat", process));
    double running = 0, waiting = 0;  // nanoseconds
    if (!(counts >> running >> waiting)) return {};
    return {running / 1e9, waiting / 1e9};
}

}  // namespace rt
