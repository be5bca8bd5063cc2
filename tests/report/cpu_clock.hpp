// The CPU time of a thread: what a measurement takes, whoever else uses the machine.
#pragma once

#include <ctime>

namespace rt::report {

/// Seconds that the calling thread has run so far.
inline double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace rt::report
