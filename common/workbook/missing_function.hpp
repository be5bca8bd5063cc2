// A function that a chapter's contract declares and the student's files do not have: what a linker says of
// it, in words.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A function as a chapter's header declares it.
struct Declared {
    const Chapter* chapter = nullptr;
    std::string step;  ///< "02.3", as its comment says; empty if it says none
    std::string
        text;  ///< "std::optional<Hit> intersect(const Sphere& sphere, const Ray& ray, Interval range)"
};

/// What the contracts declare as the function that a linker calls so: "rt::intersect(rt::Sphere const&, …)".
/// Nothing if they do not have it.
std::optional<Declared> declared_function(const Project& project, const std::vector<Chapter>& chapters,
                                          std::string_view linker_name);

/// What a linker's line "…: undefined reference to `…'" says to a student: which function of which step is
/// missing, and how it comes back. Empty if the line says no such thing.
std::string missing_in_words(const Project& project, const std::vector<Chapter>& chapters,
                             std::string_view line);

}  // namespace rt
