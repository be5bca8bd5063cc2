// Wrong input from a person: one clear line, and the program ends with exit status 2.
#pragma once

#include <concepts>
#include <stdexcept>
#include <string>

namespace rt {

/// `what()` is the whole line to show, with the place (`file:line:column: …`) where there is one.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// `file:line:column: what`; both count from 1.
inline std::string at_place(const std::string& file, std::integral auto line, std::integral auto column,
                            const std::string& what) {
    return file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + what;
}

/// Throws an InputError about a line of a file.
[[noreturn]] inline void fail_at(const std::string& file, int line, const std::string& what) {
    throw InputError(file + ":" + std::to_string(line) + ": " + what);
}

}  // namespace rt
