// Wrong input from a person: one clear line, and the program ends with exit status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace rt {

/// `what()` is the whole line to show, with the place (`file:line:column: …`) where there is one.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws an InputError about a line of a file.
[[noreturn]] inline void fail_at(const std::string& file, int line, const std::string& what) {
    throw InputError(file + ":" + std::to_string(line) + ": " + what);
}

}  // namespace rt
