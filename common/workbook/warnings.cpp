// The compiler's warnings of a student's files, which it says only when it compiles them.
#include "common/workbook/warnings.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t most_warnings = 5;

fs::path memory_file(const Project& project) { return project.build / "warnings.json"; }

json read_memory(const Project& project) {
    if (!fs::exists(memory_file(project))) return json::object();
    json memory = read_json(read_file(memory_file(project)));
    return memory.is_object() ? memory : json::object();
}

/// "chapters/02_spheres/sphere.cpp" if the line begins with what ninja says before it compiles that, or after
/// it failed to; else nothing.
std::string exercise_in(const std::string& line) {
    const bool begins = line.starts_with("[") && line.find("] Building CXX object ") != std::string::npos;
    const auto library = line.find("/exercise_");
    const auto source = line.find(".dir/chapters/");
    if ((!begins && !line.starts_with("FAILED: ")) || library == std::string::npos ||
        source == std::string::npos)
        return "";
    const std::size_t from = source + std::string_view(".dir/").size(), end = line.find(".cpp.o", from);
    return end == std::string::npos ? "" : line.substr(from, end + 4 - from);
}

std::string text_of(const fs::path& file) { return fs::exists(file) ? read_file(file) : ""; }

}  // namespace

std::map<std::string, std::vector<std::string>> compiled_exercises(const Project& project,
                                                                   std::string_view output) {
    const std::string root = project.root.string() + "/";
    std::map<std::string, std::vector<std::string>> compiled;
    std::string current;
    for (const std::string& line : split_lines(output)) {
        if (line.starts_with("[") || line.starts_with("FAILED: ")) {
            current = exercise_in(line);
            if (!current.empty()) compiled[current];
        }
        const std::string text = line.starts_with(root) ? line.substr(root.size()) : line;
        if (current.empty() || !text.starts_with(current + ":") ||
            text.find(": warning: ") == std::string::npos)
            continue;
        std::vector<std::string>& warnings = compiled[current];
        const std::string shown = printable(text);
        if (std::find(warnings.begin(), warnings.end(), shown) == warnings.end()) warnings.push_back(shown);
    }
    return compiled;
}

void remember_warnings(const Project& project, std::string_view output) {
    const auto compiled = compiled_exercises(project, output);
    if (compiled.empty()) return;
    json memory = read_memory(project);
    for (const auto& [file, warnings] : compiled)
        memory[file] = {{"of", fingerprint(text_of(project.root / file))}, {"warnings", warnings}};
    write_file(memory_file(project), json_text(memory, 1) + "\n");
}

std::vector<std::string> known_warnings(const Project& project, const Chapter& chapter) {
    std::vector<std::string> known;
    const json memory = read_memory(project);
    for (const fs::path& file : files_in(project.root / "chapters" / chapter.name, {".cpp"})) {
        const auto entry = memory.find(relative(project, file));
        if (entry == memory.end()) continue;
        try {
            if (entry->at("of") != fingerprint(read_file(file))) continue;
            for (const json& warning : entry->at("warnings")) known.push_back(warning.get<std::string>());
        } catch (const json::exception&) {
            continue;  // written by another version of the course: as good as nothing
        }
    }
    return known;
}

std::string warnings_in_words(const std::vector<std::string>& warnings) {
    if (warnings.empty()) return "";
    std::string text = "  The compiler warns:\n";
    for (std::size_t i = 0; i < std::min(warnings.size(), most_warnings); ++i)
        text += "      " + warnings[i] + "\n";
    if (warnings.size() > most_warnings)
        text += fmt::format("      … and {}\n", counted(warnings.size() - most_warnings, "more warning"));
    return text;
}

}  // namespace rt
