// Scenes made up from a number: something of everything that the language can say.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rt {

/// The scene of this number, always the same: one picture of 64 × 48 pixels. Its meshes and its picture
/// are those that `write_random_files` writes. No two surfaces coincide and no number stands on the edge of a
/// decision, save by chance; much of it cannot be expressed in other languages.
std::string random_scene(std::uint64_t number);

/// Writes the meshes that random scenes name, closed and open ones, with and without normals and texture
/// coordinates, and the picture.
void write_random_files(const std::filesystem::path& directory);

}  // namespace rt
