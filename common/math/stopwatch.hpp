// How long something takes.
#pragma once

#include <chrono>

namespace rt {

/// Runs from when it is made; wall-clock time, of a clock that nobody sets.
struct Stopwatch {
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
};

}  // namespace rt
