// Temporary files: taken away on every way out of the program, also by a signal, unless they were renamed.
#pragma once

#include "common/image/descriptor.hpp"

#include <filesystem>

namespace rt {

/// A file that the handler of the signals that end the program knows.
struct AnnouncedFile;

/// A new file with a lock on it; removed unless it was renamed.
struct TemporaryFile {
    std::filesystem::path path;
    Descriptor descriptor;
    AnnouncedFile* announced = nullptr;
    bool renamed = false;

    /// Made in `directory`; the descriptor is negative, with the reason in errno, where that fails.
    explicit TemporaryFile(const std::filesystem::path& directory);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    /// Whether another program took it for one that was left, between its making and its lock.
    bool gone() const;

    /// Gives it its name; false, with the reason in errno, if it could not be kept whole.
    bool rename(const std::filesystem::path& target);
};

/// Removes temporary files that nobody is writing: a writer holds a lock, which ends with it however it ends.
/// Once a directory, because a directory may be large.
void remove_stale(const std::filesystem::path& directory);

}  // namespace rt
