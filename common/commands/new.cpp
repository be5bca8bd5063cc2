// `course new`: a new chapter's column.
#include "common/commands/commands.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/new_chapter.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

int run_new(const std::string& name, bool json) {
    const Project project = this_project();
    std::vector<std::string> files;
    for (const std::filesystem::path& file : make_chapter(project, name))
        files.push_back(relative(project, file));
    if (json) {
        fmt::print("{}\n", json_text(nlohmann::ordered_json{{"chapter", name}, {"files", files}}));
        return 0;
    }
    for (const std::string& file : files) fmt::print("wrote {}\n", file);
    fmt::print(
        "\nIts one step is complete: ./course check {} --solutions. CONTRIBUTING.md says how to go on.\n",
        name.substr(0, 2));
    return 0;
}

}  // namespace rt
