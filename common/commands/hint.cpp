// `course hint`: one more hint for a step.
#include "common/commands/commands.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/catalogue.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

fs::path hints_file(const Project& project) { return memory(project, "hints.json"); }

/// How many hints of each step were shown; empty if that was never written, or is damaged.
nlohmann::json read_hints(const Project& project) {
    if (!fs::exists(hints_file(project))) return nlohmann::json::object();
    nlohmann::json shown = read_json(read_file(hints_file(project)));
    return shown.is_object() ? shown : nlohmann::json::object();
}

/// The number stored for a step, between 0 and `most`.
std::size_t hints_shown(const nlohmann::json& shown, const std::string& step, std::size_t most) {
    const auto found = shown.find(step);
    if (found == shown.end() || !found->is_number_unsigned()) return 0;
    return std::min(found->get<std::size_t>(), most);
}

}  // namespace

int run_hint(const std::string& name, bool all, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Step& step = *find_step(chapters, name).step;

    const Lock lock(memory_lock(project), "counting hints");
    nlohmann::json shown = read_hints(project);
    const std::size_t before = hints_shown(shown, step.id, step.hints.size());
    const std::size_t after = all ? step.hints.size() : std::min(before + 1, step.hints.size());
    const std::size_t first = all ? 0 : before;
    shown[step.id] = std::max(before, after);
    write_file(hints_file(project), json_text(shown) + "\n");

    if (json) {
        const std::vector<std::string> hints(step.hints.begin() + static_cast<std::ptrdiff_t>(first),
                                             step.hints.begin() + static_cast<std::ptrdiff_t>(after));
        const nlohmann::ordered_json object = {
            {"step", step.id}, {"hints", hints}, {"shown", after}, {"of", step.hints.size()}};
        fmt::print("{}\n", json_text(object));
        return 0;
    }
    for (std::size_t i = first; i < after; ++i)
        fmt::print("{} {}\n", paint(fmt::format("Hint {} of {}:", i + 1, step.hints.size()), Tone::Bold),
                   step.hints[i]);
    if (first == after)
        fmt::print(
            "No hints are left for step {}: you have seen all {}. ./course hint {} --all shows them again.\n",
            step.id, step.hints.size(), step.id);
    return 0;
}

}  // namespace rt
