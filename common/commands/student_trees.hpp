// The ray trees of a scene's pixels, as the student's code makes them, and what follows from differences.
#pragma once

#include "common/pictures/tree_difference.hpp"
#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/own_code.hpp"
#include "common/workbook/results.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rt {

/// A scene whose rays are followed.
struct TracedScene {
    std::filesystem::path scene;
    bool lenient = false;
    std::string size;  ///< of the picture, such as "320x240"; the scene's if empty
};

/// The trees that the student's code, and the solutions for the rest, make of pixels (x, y), at least one,
/// from a process of their own. Throws InputError, which says why, where there are none.
std::vector<nlohmann::ordered_json> student_trees(const Project& project, const OwnCode& own,
                                                  const TracedScene& traced,
                                                  const std::vector<std::pair<int, int>>& pixels);

/// The steps of a chapter that failed.
std::vector<WrongStep> wrong_steps(const Chapter& chapter, const ChapterResult& result);

/// The student's steps that fail their tests, those that changed checked again.
std::vector<WrongStep> wrong_steps(const Project& project, const std::vector<Chapter>& chapters);

/// What to do about a difference.
std::string advice(const TraceDifference& difference, const std::vector<WrongStep>& wrong);

}  // namespace rt
