// Random scenes by POV-Ray and by us: each must be equal, or the export must refuse it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rt {

/// What became of one random scene.
struct RandomFinding {
    enum { Equal, Refused, Differs } state = Equal;
    std::string why = {};  ///< it was refused, or how it differs
};

/// Makes up the scenes `first`, `first` + 1, … , exports them and compares POV-Ray's pictures with ours by
/// the gate of the tour. Works in `directory`, which exists; the files of those that differ are left there.
/// `progress` is told the fraction that is done, from one thread. Throws MissingProgram without POV-Ray.
std::vector<RandomFinding> check_random_scenes(std::uint64_t first, std::uint64_t count,
                                               const std::filesystem::path& directory,
                                               const std::function<void(double)>& progress);

}  // namespace rt
