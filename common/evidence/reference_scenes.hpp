// The scenes that have reference pictures, and the files that belong to each.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// A scene of a chapter and the files that belong to it.
struct ReferenceScene {
    std::string chapter{};            ///< "02_spheres"
    std::string name{};               ///< of the file, without its ending
    std::filesystem::path scene{};    ///< NAME.scene
    std::filesystem::path pov{};      ///< NAME.pov
    std::filesystem::path picture{};  ///< NAME.png, 16-bit, linear; or NAME.hdr
    /// What NAME.why says: why there is no reference. Empty: there should be one.
    std::string why_none{};
};

/// The scenes in references/CHAPTER: first those that the chapter lists, in its order, then all others.
/// Throws InputError for a listed scene that does not exist.
std::vector<ReferenceScene> reference_scenes(const Project& project, const Chapter& chapter);

}  // namespace rt
