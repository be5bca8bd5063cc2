// Reads scene files line by line: finds the command, counts its arguments, lets its handler read them.
#include "common/scene/parse.hpp"

#include "common/math/input_error.hpp"
#include "common/scene/elsewhere.hpp"
#include "common/scene/language/commands.hpp"
#include "common/scene/language/parser.hpp"
#include "common/scene/suggest.hpp"
#include "common/scene/text.hpp"

#include <unordered_map>
#include <utility>

namespace rt {

namespace {

using namespace language;

constexpr std::size_t longest_line = std::size_t{1} << 20;
constexpr const char* line_skipped = " (line skipped)";

/// A row of the table, and how many arguments it takes.
struct Command {
    const CommandRow* row;
    std::size_t least, most;
};

const std::unordered_map<std::string_view, Command>& commands_by_name() {
    static const auto by_name = [] {
        std::unordered_map<std::string_view, Command> map;
        std::vector<std::string_view> words;
        for (const CommandRow& row : all_commands()) {
            split_words(row.reference.arguments, words);
            const std::string_view last = words.empty() ? "" : words.back();
            const bool any_more = last == "...", one_more = last.starts_with('[');
            const std::size_t least = words.size() - (any_more || one_more ? 1 : 0);
            map.emplace(row.reference.name, Command{&row, least, any_more ? longest_line : words.size()});
        }
        return map;
    }();
    return by_name;
}

void unknown_command(const Parser& parser) {
    std::vector<std::string_view> names;
    for (const CommandRow& row : all_commands()) names.push_back(row.reference.name);
    const std::string_view word = parser.words[0];
    std::string meaning = meaning_elsewhere(word);
    if (meaning.empty()) meaning = did_you_mean(word, names);
    const std::string what = "unknown command " + quoted(word) + meaning;
    if (!parser.options.lenient) fail(parser, word, what);
    warn(parser, word.data(), what + line_skipped);
}

void check_argument_count(Parser& parser, const Command& command) {
    const std::size_t count = parser.words.size() - 1, least = command.least, most = command.most;
    const auto complaint = [&](const char* adverb, std::size_t needed) {
        return quoted(parser.words[0]) + " needs " + adverb + std::to_string(needed) +
               (needed == 1 ? " argument" : " arguments") + ", here " + (count == 1 ? "is " : "are ") +
               std::to_string(count) + expected(parser);
    };
    // What is missing is missing behind the last word.
    if (count < least)
        throw InputError(message_at(parser, parser.words.back().data() + parser.words.back().size(),
                                    complaint(least < most ? "at least " : "", least)));
    if (count <= most) return;
    const std::string_view surplus = parser.words[most + 1];
    const std::string what = complaint(least < most ? "at most " : "", most);
    if (!parser.options.lenient) fail(parser, surplus, what);
    warn(parser, surplus.data(), what + " (the rest of the line is skipped)");
    parser.words.resize(most + 1);
}

void parse_line(Parser& parser) {
    if (parser.line.size() > longest_line)
        fail(parser, parser.line, "the line is longer than a megabyte: this does not look like a scene file");
    if (const char* const comment = split_words(parser.line, parser.words))
        warn(parser, comment, std::string(comment_inside_word));
    if (parser.words.empty()) return;
    const auto found = commands_by_name().find(parser.words[0]);
    if (found == commands_by_name().end()) return unknown_command(parser);
    const Command& command = found->second;
    parser.command = &command.row->reference;
    check_argument_count(parser, command);
    try {
        command.row->handle(parser);
    } catch (const UnknownValue& problem) {
        if (!parser.options.lenient) throw;
        if (parser.options.warnings)
            parser.options.warnings->push_back(problem.what() + std::string(line_skipped));
    }
    parser.has_command = true;
}

}  // namespace

Scene parse_scene_text(std::string_view text, const std::string& name, const std::filesystem::path& directory,
                       const ParseOptions& options) {
    text = without_bom(text);
    check_is_text(text, name);

    Parser parser{options, directory};
    parser.scene.file = name;
    while (!text.empty()) {
        parser.line = take_line(text);
        ++parser.line_number;
        parse_line(parser);
    }
    require_camera(parser);
    require_closed_combinations(parser);
    require_adaptable_sampler(parser);
    if (parser.integrator_rasterizes) parser.scene.visibility = Visibility::Rasterize;
    return std::move(parser.scene);
}

Scene parse_scene(const std::filesystem::path& file, const ParseOptions& options) {
    return parse_scene_text(read_text(file, file.string()), file.string(), file.parent_path(), options);
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& file, const Scene& scene) {
    std::vector<std::filesystem::path> files{file};
    for (const Mesh& mesh : scene.meshes) files.push_back(file.parent_path() / mesh.file);
    for (const PictureFile& picture : scene.pictures) files.push_back(file.parent_path() / picture.file);
    return files;
}

const std::vector<SceneCommand>& scene_commands() {
    static const std::vector<SceneCommand> list = [] {
        std::vector<SceneCommand> all;
        for (const CommandRow& row : all_commands()) all.push_back(row.reference);
        return all;
    }();
    return list;
}

std::string scene_command_table() {
    std::string table = "| command | meaning | chapter |\n|---|---|---|\n";
    for (const SceneCommand& command : scene_commands()) {
        std::string line = command.name;
        if (!command.arguments.empty()) line.append(" ").append(command.arguments);
        // A bar would end the cell, even inside `…`.
        for (std::size_t bar = 0; (bar = line.find('|', bar)) != std::string::npos; bar += 2)
            line.insert(bar, "\\");
        table += "| `" + line + "` | " + command.meaning + " | " + command.chapter + " |\n";
    }
    return table;
}

}  // namespace rt
