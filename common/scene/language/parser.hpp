// The parser in the middle of a scene file: what has been read, what is in force, and where it is.
// Handlers of commands (commands.hpp) change it; arguments.hpp reads the words of the line.
#pragma once

#include "common/math/input_error.hpp"
#include "common/scene/parse.hpp"
#include "common/scene/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::language {

/// A combination whose `end` has not come yet.
struct OpenCombination {
    CombinationObject made;
    std::string word;            ///< that opened it
    SourcePlace place;           ///< of that word
    std::uint32_t material = 0;  ///< in force there; index into Scene::materials
    Vec3 motion{0};              ///< likewise
};

/// What the commands so far have made, and the line that is being read.
struct Parser {
    const ParseOptions& options;
    const std::filesystem::path& directory;  ///< where meshes and pictures are looked for
    Scene scene{};

    // What the objects and lights that follow take.
    Material material{};  ///< but for the indices of the next two
    Texturing texturing{};
    Finish finish{};
    Vec3 motion{0};
    Wrap wrap = Wrap::Repeat;  ///< of the textures that follow
    TextureFilter texture_filter = TextureFilter::Bilinear;
    SkyMap sky_map = SkyMap::LatitudeLongitude;  ///< of the environments that follow
    Vec3 attenuation{1, 0, 0};
    int transform = -1;  ///< index into Scene::transforms; −1 is the identity
    std::vector<int> transform_stack{};
    std::vector<OpenCombination> combinations{};  ///< each inside the one before it

    bool has_camera = false;
    bool has_command = false;
    bool integrator_rasterizes = false;  ///< the last `integrator` said the older word for both
    std::string adaptive_place{};        ///< of `adaptive on`, for a message
    std::map<std::string, std::uint32_t> mesh_of_file{};  ///< by the whole path
    std::map<std::pair<std::string, Encoding>, std::uint32_t> picture_of_file{};

    const SceneCommand* command = nullptr;  ///< of the line
    int line_number = 0;
    std::string_view line{};
    std::vector<std::string_view> words{};  ///< of the line: the command and its arguments
};

/// `file:line:column: what`; `where` points into the parser's line.
std::string message_at(const Parser& parser, const char* where, const std::string& what);

/// Appends that message to the warnings, if anybody wants them.
void warn(const Parser& parser, const char* where, const std::string& what);

/// Throws that message as an InputError, with the place where `word` begins.
[[noreturn]] void fail(const Parser& parser, std::string_view word, const std::string& what);

/// The same with a place that may be on an earlier line.
[[noreturn]] void fail_at(const Parser& parser, SourcePlace place, const std::string& what);

/// A value that later versions may know, such as a new integrator: lenient reading goes on without the line.
struct UnknownValue : InputError {
    using InputError::InputError;
};

/// The line as it should be, for the end of a message: `; expected: sphere x y z r`.
std::string expected(const Parser& parser);

/// The path of the file that a word of the line names; throws where no files are read.
std::filesystem::path file_named(const Parser& parser, std::string_view word);

/// The whole path of a file, so that each is read once, whatever it is called.
std::string whole_path(const std::filesystem::path& file);

/// The index into Scene::pictures of the picture that a word of the line names; read if it is new. 8-bit
/// files are light by the sRGB curve or, as `Encoding::Linear`, numbers.
std::uint32_t picture_named(Parser& parser, std::string_view word, Encoding encoding = Encoding::Srgb);

/// Where a word of the line is.
SourcePlace place_of(const Parser& parser, std::string_view word);

}  // namespace rt::language
