// Lessons show code of the course; the program writes it there from its one source.
// Light on purpose: the build looks with it whether all that is quoted still exists.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// The pages of a chapter's directory in the order in which they are read: README.md, then the other parts of
/// its lesson by name.
std::vector<std::filesystem::path> pages_of(const std::filesystem::path& chapter);

/// A lesson, or another page of a chapter, with its code as it is now.
struct WovenLesson {
    std::string text;
    std::vector<std::filesystem::path> sources;  ///< the files that are quoted, each once
};

/// Writes the block of code below each of these marks, which readers of the page do not see:
///
///     <!-- code chapters/02_spheres/quadratic.hpp "struct Roots" to "};" -->
///     <!-- code common/math/ray.hpp "Vec3 at(" -->
///     <!-- mistake 02.2_naive_discriminant -->
///     <!-- mistake 02.2_naive_discriminant "return" to "}" -->
///
/// The first text must stand on exactly one line of the file, whose name is seen from `root`; with it the
/// piece begins. It ends with the next line that contains the text after `to`, or is that one line. Of a
/// mistake it is the wrong lines: all of them, if no text is given. What all lines are indented by is left
/// out. Throws InputError, with `name` and the mark's line, if there is no such piece, if the mark is
/// malformed, and if no block of code follows it.
WovenLesson woven_lesson(const std::string& text, const std::string& name, const std::filesystem::path& root);

}  // namespace rt
