// Wrong input from a person: one clear line, and the program ends with exit status 2.
#pragma once

#include <stdexcept>

namespace rt {

/// `what()` is the whole line to show, with the place (`file:line:column: …`) where there is one.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace rt
