// What a handout consists of: the course's files without solutions and all that would give them away.
#include "common/handout/handout_files.hpp"

#include "common/handout/solution_lines.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/course_files.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/template.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

const std::set<std::string> top_level{"CMakeLists.txt", "CMakePresets.json", "LICENSE",   "course",
                                      ".clang-format",  ".gitattributes",    ".gitignore"};

/// Whether a file of the course is handed out as it is. `shown` are the directories' names of chapters that
/// are not hidden.
bool is_handed_out(const fs::path& path, const std::set<std::string>& shown) {
    const std::vector<std::string> parts(path.begin(), path.end());
    if (parts.size() == 1) return top_level.contains(parts[0]);
    const std::string &room = parts[0], &part = parts[1], name = path.filename().string();
    // The instructor's guide and its reference are nobody else's.
    if (room == "common") return part != "grading" || path.extension() != ".md";
    if (room == "chapters")
        return path.extension() == ".hpp" || (shown.contains(part) && path.extension() != ".cpp");
    if (room == "references") return shown.contains(part) && name != "figures.cpp";
    if (room != "tests") return false;
    if (parts.size() == 2) return name != "changed_solutions.cmake";
    if (shown.contains(part)) return parts[2] != "mistakes" && parts[2] != "variants";
    return part == "oracle" || part == "stability";
}

/// The exercises of all chapters; those of hidden ones only where the build needs them.
void add_exercises(std::vector<HandoutFile>& files, const Project& project,
                   const std::set<std::string>& shown) {
    std::vector<HandoutFile> pristine;
    for (const auto& entry : fs::directory_iterator(project.root / "solutions"))
        for (const fs::path& solution : files_in(entry.path(), {".cpp"})) {
            const std::string chapter = entry.path().filename().string(), name = solution.filename().string();
            const std::string text = exercise_text(read_file(solution), relative(project, solution));
            if (shown.contains(chapter)) files.push_back({"chapters/" + chapter + "/" + name, text});
            pristine.push_back({".course/pristine/" + chapter + "/" + name, text});
        }
    files.insert(files.end(), pristine.begin(), pristine.end());
}

/// The chapters as rows of the README's table.
ordered_json rows_of(const std::vector<Chapter>& chapters, const ClassFacts& about) {
    auto rows = ordered_json::array();
    for (const Chapter& chapter : chapters) {
        const auto due = about.due.find(chapter.number);
        rows.push_back({{"name", chapter.name},
                        {"number", std::to_string(std::stoi(chapter.number))},
                        {"title", chapter.title},
                        {"summary", chapter.summary},
                        {"hours", std::to_string(chapter.hours)},
                        {"has_due", !about.due.empty()},
                        {"due", due == about.due.end() ? "" : due->second}});
    }
    return rows;
}

std::string readme_text(const std::vector<Chapter>& chapters, const ClassFacts& about) {
    const Chapter& first = chapters.front();
    const ordered_json view = {
        {"course", about.course.empty() ? "A ray tracing course" : about.course},
        {"instructor", about.instructor},
        {"chapters", rows_of(chapters, about)},
        {"has_dates", !about.due.empty()},
        {"first", first.number},
        {"step", first.steps.front().id},
        {"scene", first.scenes.empty() ? "" : "references/" + first.name + "/" + first.scenes.front()}};
    return filled(this_project().root / "common/handout/README.md.mustache", view, Escape::None);
}

/// What is written must not give away what students are to find.
void require_no_leak(const Project& project, const std::vector<HandoutFile>& files) {
    const SolutionLines lines = solution_lines(project);
    for (const HandoutFile& file : files)
        if (const auto leak = find_leak(lines, file.text))
            throw InputError(fmt::format(
                "{}:{} is line {} of {}; a handout must have no line of a solution, so write it in "
                "another way",
                file.path, leak->line, leak->solution.line, leak->solution.file));
}

bool is_executable(const fs::path& file) {
    return (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

/// Whether a path of a record stays inside of the handout.
bool is_inside(const fs::path& path) {
    return path.is_relative() && !path.empty() && path.string() == path.lexically_normal().string() &&
           *path.begin() != ".." && *path.begin() != "." && *path.begin() != ".git" && path.has_filename();
}

}  // namespace

bool is_exercise(std::string_view path) {
    const fs::path file(path);
    const std::vector<std::string> parts(file.begin(), file.end());
    return parts.size() == 3 && parts[0] == "chapters" && is_chapter_name(parts[1]) &&
           file.extension() == ".cpp";
}

std::string record_text(const HandoutRecord& record) {
    const ordered_json value = {
        {"class", to_json(record.about)}, {"chapters", record.chapters}, {"files", record.files}};
    return json_text(value, 1) + "\n";
}

HandoutRecord read_record(const std::string& text, const std::string& name) {
    const JsonSource source = parse_json(name, text);
    const JsonValue root = root_of(source);
    root.only({"class", "chapters", "files"});
    HandoutRecord record;
    record.about = class_facts(root.at("class"));
    for (const JsonValue& chapter : root.at("chapters").items()) record.chapters.push_back(chapter.text());
    for (const auto& [path, mark] : root.at("files").members()) {
        if (!is_inside(path)) mark.fail("there is no such file in a handout");
        record.files[path] = mark.text();
    }
    return record;
}

std::vector<HandoutFile> handout_files(const Project& project, const std::vector<Chapter>& chapters,
                                       const ClassFacts& about) {
    HandoutRecord record{{}, about, {}};
    std::set<std::string> shown;
    for (const Chapter& chapter : chapters) {
        record.chapters.push_back(chapter.number);
        shown.insert(chapter.name);
    }
    std::vector<HandoutFile> files;
    add_exercises(files, project, shown);
    for (const std::string& path : course_files(project)) {
        const fs::path file = project.root / path;
        if (is_handed_out(path, shown) && fs::is_regular_file(fs::symlink_status(file)))
            files.push_back({path, read_file(file), is_executable(file)});
    }
    files.push_back({"README.md", readme_text(chapters, about)});
    require_no_leak(project, files);
    for (const HandoutFile& file : files) record.files[file.path] = fingerprint(file.text);
    files.push_back({record_file, record_text(record)});
    return files;
}

}  // namespace rt
