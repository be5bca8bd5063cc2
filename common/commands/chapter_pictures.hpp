// What `course check` shows of a chapter: its picture once it has passed, and before that the smallest
// picture in which a mistake can be seen.
#pragma once

#include "common/workbook/results.hpp"

#include <string>

namespace rt {

/// Draws the chapter's picture by the student's code and says where it is, if that is quick. The chapter has
/// just been checked: the program that tests it draws.
void show_chapter_picture(const Project& project, const Chapter& chapter);

/// Draws what shows a failed step, smallest pictures first, until one differs from the expected one or a
/// second has passed. Shows both and their difference in a terminal with colours, writes them into a file,
/// and says in words what is wrong at the worst pixel. Says nothing where no picture shows it: where steps
/// that it needs are not started, or the code crashes or does not come to an end.
void show_failed_step(const Project& project, const Chapter& chapter, const ChapterResult& result,
                      const std::string& step);

}  // namespace rt
