// Where two ray trees of one pixel first differ, and the step to look at.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// The first quantity in which two trees differ, in the order in which a ray tracer computes them.
struct TraceDifference {
    std::size_t ray = 0;  ///< index into the rays of both trees
    std::string
        quantity;  ///< such as "distance t", "normal" or "visible part of the point light at (0, 4, 0)"
    std::string mine;
    std::string theirs;
    /// What takes part in computing it, parts before what is made of them: steps ("02.3"), files
    /// ("09/walk.cpp") or whole chapters ("04").
    std::vector<std::string> makers;
};

/// The quantity in which two trees differ whose rays are all the same, and are summed up differently.
inline constexpr const char* colour_of_pixel = "colour of the pixel";

/// Compares two trees as `course trace --json` prints them. Numbers that differ by less than 1e-9 of their
/// size are the same: another order of the same operations may change as much.
std::optional<TraceDifference> first_difference(const nlohmann::ordered_json& mine,
                                                const nlohmann::ordered_json& theirs);

/// A step whose tests fail, and the file of the exercise that it stands in, such as "sphere.cpp".
struct WrongStep {
    std::string id;
    std::string file;
};

/// The step that explains the difference: the first of its makers that is among the wrong ones; nothing if
/// none is. `wrong` is in the order of the course.
std::optional<std::string> step_to_look_at(const TraceDifference& difference,
                                           std::span<const WrongStep> wrong);

/// "your normal is (0, -0.8, 0.6), expected (0, 0.8, 0.6)".
std::string in_words(const TraceDifference& difference);

}  // namespace rt
