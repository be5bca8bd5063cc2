// A new chapter's column: its rooms with one step that is complete, to be written over.
#include "common/workbook/new_chapter.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/template.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr const char* rooms[] = {"chapters", "solutions", "tests", "references"};

/// A file of the column: its room, its name there ("*" stands for the chapter's words, "#" for its number),
/// and its template.
struct ColumnFile {
    const char* room;
    const char* name;
    const char* made_from;
};
constexpr ColumnFile column[] = {
    {"chapters", "README.md", "lesson.md"},
    {"chapters", "chapter.json", "chapter.json"},
    {"chapters", "*.hpp", "contract.hpp"},
    {"solutions", "*.cpp", "solution.cpp"},
    {"tests", "*_test.cpp", "test.cpp"},
    {"tests", "mistakes/#.1_only_one_halved.mistake", "only_one_halved.mistake"},
    {"tests", "mistakes/#.1_half_the_distance.mistake", "half_the_distance.mistake"},
    {"tests", "variants/#.1_from_the_first.variant", "from_the_first.variant"},
    {"tests", "variants/#.1_halves.variant", "halves.variant"},
    {"references", "first.scene", "first.scene"},
    {"references", "first.why", "first.why"},
};

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Two digits, an underscore, and words of small letters and digits between underscores, the first of which
/// begins with a letter.
bool is_new_name(std::string_view name) {
    if (!is_chapter_name(name) || name.starts_with("00")) return false;
    const std::string_view words = name.substr(3);
    return is_small(words.front()) && words.back() != '_' && words.find("__") == std::string_view::npos &&
           std::ranges::all_of(words, [](char c) { return is_small(c) || is_digit(c) || c == '_'; });
}

/// Throws InputError if a room has a chapter of this number or of these words.
void require_free(const Project& project, const std::string& name) {
    for (const char* room : rooms) {
        if (!fs::is_directory(project.root / room)) continue;
        for (const auto& entry : fs::directory_iterator(project.root / room)) {
            const std::string other = entry.path().filename().string();
            if (!is_chapter_name(other)) continue;
            if (other.starts_with(name.substr(0, 3)))
                throw InputError(
                    fmt::format("the number {} is taken: there is {}/{}", name.substr(0, 2), room, other));
            if (other.substr(2) == name.substr(2))
                throw InputError(
                    fmt::format("the name '{}' is taken: there is {}/{}", name.substr(3), room, other));
        }
    }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    if (const auto at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

/// "area_lights" as a title: "Area lights".
std::string title_of(std::string words) {
    std::ranges::replace(words, '_', ' ');
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    return words;
}

}  // namespace

std::vector<fs::path> make_chapter(const Project& project, const std::string& name) {
    if (!is_new_name(name))
        throw InputError(fmt::format(
            "'{}' is no name for a chapter; expected two digits and words, such as 11_area_lights", name));
    require_solutions(project, "./course new");
    require_free(project, name);

    const std::string number = name.substr(0, 2), words = name.substr(3);
    const TemplateView view = {{"chapter", name},
                               {"number", number},
                               {"short_number", std::to_string(std::stoi(number))},
                               {"words", words},
                               {"title", title_of(words)}};
    const fs::path templates = this_project().root / "common/workbook/new_chapter";
    std::vector<fs::path> files;
    const auto write = [&](const fs::path& file, const std::string& text) {
        make_directories(file.parent_path());
        write_file(file, text);
        files.push_back(file);
    };
    for (const ColumnFile& part : column) {
        const std::string file = replaced(replaced(part.name, "*", words), "#", number);
        const std::string text =
            filled(templates / (std::string(part.made_from) + ".mustache"), view, Escape::None);
        write(project.root / part.room / name / file, text);
        if (std::string_view(part.room) == "solutions")
            write(project.root / "chapters" / name / file, exercise_text(text, file));
    }
    return files;
}

}  // namespace rt
