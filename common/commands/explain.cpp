// `course explain`: what a scene needs, what was left out and why, and which chapters draw it.
#include "common/render/explain.hpp"
#include "common/commands/commands.hpp"
#include "common/commands/mine.hpp"
#include "common/math/counted.hpp"
#include "common/math/printable.hpp"
#include "common/pictures/reasons_json.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/render/compile.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/catalogue.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

using nlohmann::ordered_json;

namespace {

void print(std::string_view title, const std::vector<Reason>& reasons) {
    if (reasons.empty()) return;
    fmt::print("{}\n", paint(title, Tone::Bold));
    for (const Reason& reason : reasons)
        fmt::print("  {}: {}\n", printable(reason.what), printable(reason.why));
    fmt::print("\n");
}

/// Numbers and titles of chapters, in one line.
void print_chapters(const std::vector<std::string>& numbers) {
    fmt::print("{}", paint("Drawn by", Tone::Bold));
    const std::vector<Chapter> chapters = read_catalogue(this_project());
    for (const std::string& number : numbers) {
        const auto found = std::ranges::find(chapters, number, &Chapter::number);
        fmt::print("{} {}{}", number == numbers.front() ? "" : ",", number,
                   found == chapters.end() ? "" : " " + found->title);
    }
}

}  // namespace

int run_explain(const ExplainCommand& command) {
    std::vector<std::string> warnings;
    const Scene scene = read_scene(command.scene, command.lenient, warnings);
    become_mine_in_handout(command.arguments);
    for (const std::string& warning : warnings) say(warning);  // not before: what it becomes says them, too
    const Explanation explanation = explain(scene, compile(scene));
    if (command.json) {
        const ordered_json object = {{"scene", command.scene.string()},
                                     {"kept", reasons_json(explanation.kept)},
                                     {"left_out", reasons_json(explanation.left_out)},
                                     {"chapters", explanation.chapters},
                                     {"bytes", explanation.bytes}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    print("Kept", explanation.kept);
    print("Left out", explanation.left_out);
    print_chapters(explanation.chapters);
    fmt::print("\nin {} of memory\n", counted(explanation.bytes, "byte"));
    return 0;
}

}  // namespace rt
