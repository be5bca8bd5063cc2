// The chapters as their chapter.json describe them: steps, hints, points, hours and scenes.
#pragma once

#include "common/terminal/project.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

struct Step {
    std::string id;  ///< "02.1"
    std::string title;
    std::string file;  ///< of the exercise, in the chapter's directory
    int points = 0;
    std::vector<std::string> hints;  ///< at least three, from a nudge to nearly the answer
    /// Earlier steps: while one of them is wrong, this one may fail for that.
    std::vector<std::string> uses{};
    /// What shows it best: one of the chapter's scenes or a drawing (common/pictures/drawings.cpp); or empty.
    std::string picture{};
    /// A challenge that is checked: its points are extra credit, and the chapter is complete without it.
    bool optional = false;
};

struct Chapter {
    std::string name;    ///< of its directory, "02_spheres"
    std::string number;  ///< "02"
    std::string title;
    std::string summary;
    std::vector<Step> steps;
    std::vector<std::string> scenes;  ///< in references/NN_name; the first is the chapter's picture
    int hours = 0;                    ///< that a student is expected to need: an estimate (CONTRIBUTING.md)
};

/// Whether a directory's name is a chapter's: two digits, an underscore, and something.
bool is_chapter_name(std::string_view name);

/// All chapters that have exercises, by number. Throws InputError, which names file, line, column and key,
/// for a missing key, one that is not known or of the wrong type, a step's number that is twice there or not
/// of this chapter, a later step that is used, fewer than three hints, points and hours that are not
/// positive, and files that do not exist.
std::vector<Chapter> read_catalogue(const Project& project);

/// The chapter with this number; throws InputError, which lists the numbers, if there is none. `number` may
/// be written without its zero, and as the directory's name.
const Chapter& find_chapter(const std::vector<Chapter>& chapters, std::string_view number);

/// The chapter's step with this number, which must be one of its own.
const Step& step_of(const Chapter& chapter, std::string_view id);

/// A chapter, and one of its steps or none: what `02` and `02.1` on a command line say.
struct Target {
    const Chapter* chapter = nullptr;
    const Step* step = nullptr;
};

/// Reads `02`, `2`, `02_spheres`, `02.1` or `2.1`. Throws InputError, which lists what there is.
Target find_target(const std::vector<Chapter>& chapters, std::string_view text);

/// As `find_target`, for commands that need a step.
Target find_step(const std::vector<Chapter>& chapters, std::string_view text);

}  // namespace rt
