// What `course check` shows beside its verdict: the student's picture of what has passed, and of a failed
// step the smallest picture in which a mistake can be seen. The chapter has just been checked: the program
// that tests it draws.
#pragma once

#include "common/workbook/results.hpp"

#include <optional>
#include <string>

namespace rt {

/// A picture that was drawn for a verdict.
struct VerdictPicture {
    std::string file;  ///< as a person at the repository's root names it
    std::string text;  ///< all that is said of it, in lines
};

/// Draws the chapter's picture by the student's code. Nothing if the chapter has none, or if that is not
/// quick.
std::optional<VerdictPicture> chapter_picture(const Project& project, const Chapter& chapter);

/// Likewise the picture of a step that has passed. Nothing, too, where it needs steps that are not started.
std::optional<VerdictPicture> picture_of_passed(const Project& project, const Chapter& chapter,
                                                const Step& step);

/// Draws what shows a failed step, smallest pictures first, until one differs from the expected one or a
/// second has passed. Writes both and their difference into a file, shows them if this is a terminal with
/// colours, and says in words what is wrong at the worst pixel. Nothing where no picture shows it: where
/// steps that it needs are not started, or the code crashes or does not come to an end.
std::optional<VerdictPicture> picture_of_failed(const Project& project, const Chapter& chapter,
                                                const ChapterResult& result, const std::string& step);

}  // namespace rt
