// Helpers for all tests: how many cases, and where things are.
#include "tests/support.hpp"

#include <algorithm>
#include <filesystem>

namespace rt::test {

// Set by --quick, in tests/main.cpp.
bool quick = false;

int cases(int full) { return quick ? std::max(1, full / 10) : full; }

std::string scratch_directory() {
    const std::filesystem::path directory = std::filesystem::path(COURSE_BUILD_DIR) / "scratch";
    std::filesystem::create_directories(directory);
    return directory.string();
}

std::string repository() { return COURSE_SOURCE_DIR; }

}  // namespace rt::test
