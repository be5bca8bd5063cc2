// Scene files to Scene.
// The language is described in README.md beside this file.
#pragma once

#include "common/image/file.hpp"
#include "common/scene/scene.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

// What is possible at all.
inline constexpr int largest_side = 65536;  ///< pixels of a picture's side; all of them: `most_pixels`
inline constexpr int most_samples = 65536;  ///< a pixel, in one pattern

/// How strictly to read, and what else may be read.
struct ParseOptions {
    /// Skip with a warning what other programs may know: unknown commands, lines with unknown values of a
    /// choice or of a setting (`maxdepth -1`), arguments beyond the last, and in meshes what MeshOptions
    /// says.
    bool lenient = false;
    bool files = true;  ///< commands may read files, such as `mesh`; without this that is an error
    std::vector<std::string>* warnings = nullptr;  ///< one line each is appended; may be null
};

/// The scene of a file. Meshes and pictures are looked for relative to the file's directory.
/// Throws InputError for anything wrong: one line, `file:line:column: what is wrong`, or `file: …` where the
/// file cannot be read. Columns count bytes from 1; a tab is one.
Scene parse_scene(const std::filesystem::path& file, const ParseOptions& options = {});

/// The same from text; `name` stands for the file in messages, other files are looked for in `directory`.
Scene parse_scene_text(std::string_view text, const std::string& name,
                       const std::filesystem::path& directory = {}, const ParseOptions& options = {});

/// The files that were read for `scene`, the scene of `file`: that file, its meshes and its pictures.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& file, const Scene& scene);

/// One command of the language, as the reference documents it.
struct SceneCommand {
    std::string name;
    std::string arguments;  ///< one word an argument; `a|b` is a choice, a last `[x]` may be
                            ///< left out, a last `...` means any number more
    std::string meaning;    ///< a sentence, in Markdown
    std::string chapter;    ///< number of the chapter that brings it, such as "02"
};

/// All commands, in the order of the reference: by chapter.
const std::vector<SceneCommand>& scene_commands();

/// The reference as a Markdown table, made from the commands.
std::string scene_command_table();

}  // namespace rt
