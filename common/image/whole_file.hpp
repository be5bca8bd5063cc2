// Files read and written whole. What is read has a limit, known before memory is taken; what is written
// appears whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// No scene, mesh or picture that is read may have more bytes: 1 GiB.
inline constexpr std::size_t largest_file = std::size_t{1} << 30;

/// How long a pipe may have nobody who writes into it, and how long a writer may be silent, in milliseconds.
inline constexpr int pipe_patience = 1000;
inline constexpr int pipe_silence = 10000;

/// The content of a file, or what comes through a pipe. Throws InputError, the path in front, where it cannot
/// be read, is a directory or a device, is larger than `largest_file`, or is a pipe into which nobody writes.
std::string read_file(const std::filesystem::path& path);

/// Writes `content` to `path` whole, through a temporary file beside it and a rename; a link or the
/// permissions of an existing file are kept, a device or pipe is written directly. Throws InputError with
/// the path and what is wrong, also for a file that may not be written (not even by root, whom permissions do
/// not hold back); then nothing is left behind and an existing file is as it was. A signal that ends the
/// program takes the temporary file away, too; one that was left by a program that was killed is removed by
/// the next that writes into the same directory.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Throws what `write_file` would throw because of the place, before any work is done; leaves nothing behind.
void require_writable(const std::filesystem::path& path);

/// Throws InputError if `path` is one of the files in `inputs`, by whatever name or link: writing it would
/// lose what was read.
void require_no_input(const std::filesystem::path& path, const std::vector<std::filesystem::path>& inputs);

/// Makes a directory and those above it. Throws InputError if that cannot be.
void make_directories(const std::filesystem::path& path);

}  // namespace rt
