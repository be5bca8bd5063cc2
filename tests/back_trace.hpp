// Where a test program was when it crashed or was told to stop.
#pragma once

#include <string>

namespace rt::test {

/// From now on a crash, or SIGQUIT, adds a line to the report before the program ends:
///   {"stopped_at":["1a2b","3c4d"]}
/// the innermost function first, each as its place in the program's file, as addr2line(1) takes it. Elsewhere
/// than on Linux nothing is added.
void report_where_it_stops(const std::string& report);

}  // namespace rt::test
