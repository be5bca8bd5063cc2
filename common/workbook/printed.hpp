// What a student's code prints while its tests run.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// What was printed during one test.
struct Printed {
    std::string test;                ///< its name; empty for what came before the first
    std::vector<std::string> lines;  ///< at least one, the first; whatever bytes were in them, as text
    std::size_t more = 0;            ///< lines after those
};

/// Cuts what a test program with --watched has printed: a line with the sign 0x1e in front names the test
/// that follows. What comes after the empty name is the program's own.
std::vector<Printed> read_printed(std::string_view output);

/// The first lines of what was printed in the test `first`, or else in the first that printed, and how much
/// more there is; indented to stand below a verdict. Empty if nothing was printed.
std::string printed_in_words(const std::vector<Printed>& printed, std::string_view first);

}  // namespace rt
