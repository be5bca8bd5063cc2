// Places, messages, and files that a scene names.
#include "common/scene/language/parser.hpp"

#include "common/image/file.hpp"

#include <memory>
#include <system_error>

namespace rt::language {

std::string message_at(const Parser& parser, const char* where, const std::string& what) {
    return at_place(parser.scene.file, parser.line_number, where - parser.line.data() + 1, what);
}

void warn(const Parser& parser, const char* where, const std::string& what) {
    if (parser.options.warnings) parser.options.warnings->push_back(message_at(parser, where, what));
}

void fail(const Parser& parser, std::string_view word, const std::string& what) {
    throw InputError(message_at(parser, word.data(), what));
}

void fail_at(const Parser& parser, SourcePlace place, const std::string& what) {
    throw InputError(at_place(parser.scene.file, place.line, place.column, what));
}

std::string expected(const Parser& parser) {
    const SceneCommand& command = *parser.command;
    return "; expected: " + command.name + (command.arguments.empty() ? "" : " ") + command.arguments;
}

std::filesystem::path file_named(const Parser& parser, std::string_view word) {
    if (!parser.options.files)
        fail(parser, parser.words[0],
             "'" + std::string(parser.words[0]) + "' reads a file, which is not allowed here");
    return parser.directory / std::filesystem::path(word);
}

std::string whole_path(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
    return error ? file.string() : canonical.string();
}

std::uint32_t picture_named(Parser& parser, std::string_view word, Encoding encoding) {
    const std::filesystem::path path = file_named(parser, word);
    std::vector<PictureFile>& pictures = parser.scene.pictures;
    const auto [found, is_new] = parser.picture_of_file.try_emplace(
        {whole_path(path), encoding}, static_cast<std::uint32_t>(pictures.size()));
    if (is_new) {
        try {
            Picture read = read_picture(path, encoding);
            pictures.push_back(
                {std::string(word), std::make_shared<const Image>(std::move(read.image)), read.eight_bits});
        } catch (const InputError& problem) {
            fail(parser, word, std::string("picture ") + problem.what());
        }
    }
    return found->second;
}

SourcePlace place_of(const Parser& parser, std::string_view word) {
    return {parser.line_number, static_cast<int>(word.data() - parser.line.data()) + 1};
}

}  // namespace rt::language
