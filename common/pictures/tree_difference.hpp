// Where two ray trees of one pixel first differ.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace rt {

/// The first quantity in which two trees differ, in the order in which a ray tracer computes them.
struct TraceDifference {
    std::size_t ray = 0;   ///< index into the rays of both trees
    std::string quantity;  ///< such as "t", "normal" or "light 2: visible"
    std::string mine;
    std::string theirs;
    std::string step;  ///< the step that computes the quantity, such as "02.3"
};

/// The quantity in which two trees differ whose rays are all the same, and are summed up differently.
inline constexpr const char* colour_of_pixel = "colour of the pixel";

/// Compares two trees as `course trace --json` prints them. Numbers that differ by less than 1e-9 of their
/// size are the same: another order of the same operations may change as much.
std::optional<TraceDifference> first_difference(const nlohmann::ordered_json& mine,
                                                const nlohmann::ordered_json& theirs);

}  // namespace rt
