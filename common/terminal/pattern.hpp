// Texts that have a form. Only pattern.cpp compiles the library's regular expressions, which take seconds.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// The text, if all of it has this form (a regular expression of ECMAScript), and then its parts in brackets,
/// empty where they are missing; else nothing.
std::optional<std::vector<std::string>> parts_of(const std::string& text, const char* form);

}  // namespace rt
