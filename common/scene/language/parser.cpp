// Places and messages.
#include "common/scene/language/parser.hpp"

namespace rt::language {

std::string message_at(const Parser& parser, const char* where, const std::string& what) {
    return parser.scene.file + ":" + std::to_string(parser.line_number) + ":" +
           std::to_string(where - parser.line.data() + 1) + ": " + what;
}

void warn(const Parser& parser, const char* where, const std::string& what) {
    if (parser.options.warnings) parser.options.warnings->push_back(message_at(parser, where, what));
}

void fail(const Parser& parser, std::string_view word, const std::string& what) {
    throw InputError(message_at(parser, word.data(), what));
}

void fail_at(const Parser& parser, SourcePlace place, const std::string& what) {
    throw InputError(parser.scene.file + ":" + std::to_string(place.line) + ":" +
                     std::to_string(place.column) + ": " + what);
}

std::string expected(const Parser& parser) {
    const SceneCommand& command = *parser.command;
    return "; expected: " + command.name + (command.arguments.empty() ? "" : " ") + command.arguments;
}

SourcePlace place_of(const Parser& parser, std::string_view word) {
    return {parser.line_number, static_cast<int>(word.data() - parser.line.data()) + 1};
}

}  // namespace rt::language
