// `course handout`: a tree for students, made or brought up to date.
#include "common/handout/handout.hpp"
#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

using nlohmann::ordered_json;

namespace {

std::string words_for(const std::vector<std::string>& chapters) {
    if (chapters.size() == 1) return "chapter " + chapters.front();
    return fmt::format("chapters {} to {}", chapters.front(), chapters.back());
}

int make(const HandoutCommand& command, const HandoutOptions& options) {
    const MadeHandout made = make_handout(this_project(), command.directory, options);
    if (command.json) {
        const ordered_json object = {
            {"output", command.directory.string()}, {"chapters", made.chapters}, {"files", made.files}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    fmt::print("made {}: {}, {}, in git\n", printable(command.directory.string()), words_for(made.chapters),
               counted(made.files, "file"));
    return 0;
}

int update(const HandoutCommand& command, const HandoutOptions& options) {
    const UpdatedHandout updated = update_handout(this_project(), command.directory, options);
    if (command.json) {
        auto kept = ordered_json::array();
        for (const KeptFile& file : updated.kept) kept.push_back({{"file", file.path}, {"why", file.why}});
        const ordered_json object = {{"output", command.directory.string()},
                                     {"chapters", updated.chapters},
                                     {"written", updated.written},
                                     {"removed", updated.removed},
                                     {"kept", kept}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    for (const KeptFile& file : updated.kept)
        fmt::print("{}: {}\n", printable(file.path), printable(file.why));
    fmt::print("{} has {}: {} written, {} removed\n", printable(command.directory.string()),
               words_for(updated.chapters), counted(updated.written.size(), "file"), updated.removed.size());
    return 0;
}

}  // namespace

int run_handout(const HandoutCommand& command) {
    const HandoutOptions options{command.chapters, command.about};
    return command.update ? update(command, options) : make(command, options);
}

}  // namespace rt
