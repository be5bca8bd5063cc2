// What all fuzz targets ask for: a condition that holds, and an InputError of one line or none.
#pragma once

#include "common/math/input_error.hpp"

#include <cstdlib>
#include <string_view>

namespace rt::fuzz {

inline void require(bool holds) {
    if (!holds) std::abort();
}

/// Runs `read`; an InputError must be one line that begins with the file's name.
template <class Read>
void must_read_or_refuse(Read read, std::string_view name = "fuzz:") {
    try {
        read();
    } catch (const InputError& error) {
        const std::string_view line = error.what();
        require(line.starts_with(name) && line.find('\n') == std::string_view::npos);
    }
}

}  // namespace rt::fuzz
