// Directories that appear whole or not at all.
#pragma once

#include "common/image/descriptor.hpp"

#include <filesystem>

namespace rt {

/// A directory that is being filled beside the place where it shall be, under a name of its own; removed with
/// all that is in it unless it was renamed. What a killed program left is removed by the next that fills one
/// at the same place.
struct StagedDirectory {
    std::filesystem::path path;
    Descriptor lock;  ///< held as long as somebody fills it
    bool renamed = false;

    /// For `target`, whose parent exists. Throws InputError if nothing can be made there.
    explicit StagedDirectory(const std::filesystem::path& target);
    StagedDirectory(const StagedDirectory&) = delete;
    StagedDirectory& operator=(const StagedDirectory&) = delete;
    ~StagedDirectory();

    /// Gives it its name. Throws InputError if there is something by now.
    void rename(const std::filesystem::path& target);
};

}  // namespace rt
