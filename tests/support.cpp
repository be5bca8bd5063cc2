// Helpers for all tests: how many cases, and where things are.
#include "tests/support.hpp"

#include "tests/own_options.hpp"
#include "tests/pictures.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <utility>

namespace rt::test {

// Set in tests/main.cpp.
bool quick = false;
std::string stopped;

double (*running_seconds)() = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
};

void (*pictures_differ)(const Image&, const Image&) = [](const Image&, const Image&) {};

std::vector<OwnOption*>& own_options() {
    static std::vector<OwnOption*> options;
    return options;
}

OwnOption::OwnOption(std::string option, std::string value, std::string about)
    : name(std::move(option)), value_name(std::move(value)), help(std::move(about)) {
    own_options().push_back(this);
}

std::vector<OtherUse*>& other_uses() {
    static std::vector<OtherUse*> uses;
    return uses;
}

OtherUse::OtherUse(std::string option, int (*what)(const std::vector<std::string>&))
    : name(std::move(option)), use(what) {
    other_uses().push_back(this);
}

int cases(int full) { return quick ? std::max(1, full / 10) : full; }

std::string scratch_directory() {
    const std::filesystem::path directory =
        std::filesystem::path(COURSE_BUILD_DIR) / "scratch" / program_invocation_short_name;
    std::filesystem::create_directories(directory);
    return directory.string();
}

std::string repository() { return COURSE_SOURCE_DIR; }

}  // namespace rt::test
