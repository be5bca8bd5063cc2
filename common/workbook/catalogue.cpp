// The chapters as their chapter.json describe them: steps, hints, points, hours and scenes.
#include "common/workbook/catalogue.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/json_source.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// A text that is not empty.
std::string some_text(const JsonValue& value) {
    const std::string text = value.text();
    if (text.empty()) value.fail("expected a text");
    return text;
}

/// The texts of a list; none is empty.
std::vector<std::string> texts(const JsonValue& list) {
    std::vector<std::string> all;
    for (const JsonValue& text : list.items()) all.push_back(some_text(text));
    return all;
}

/// Whether the chapter has a file to be written with this name. Before its exercises are generated for the
/// first time, and after a student has deleted it, a chapter has only the file's original.
bool has_exercise(const fs::path& root, const Chapter& chapter, const std::string& file) {
    for (const char* room : {"chapters", "solutions", ".course/pristine"})
        if (fs::exists(root / room / chapter.name / file)) return true;
    return false;
}

/// Whether the step comes before those that are still to be read. Which steps an earlier chapter has is not
/// asked: it may not have been handed out.
bool is_earlier(const std::string& step, const Chapter& chapter) {
    if (is_step_id(step) && step.substr(0, 2) < chapter.number) return true;
    return std::any_of(chapter.steps.begin(), chapter.steps.end(),
                       [&](const Step& before) { return before.id == step; });
}

Step read_step(const JsonValue& entry, const Chapter& chapter, const fs::path& root) {
    entry.only({"id", "title", "file", "points", "optional", "picture", "hints", "uses"});
    Step step;
    const JsonValue id = entry.at("id");
    step.id = id.text();
    if (!is_step_id(step.id) || !step.id.starts_with(chapter.number + "."))
        id.fail(fmt::format("'{}' is not a step of chapter {}; expected '{}.N'", step.id, chapter.number,
                            chapter.number));
    for (const Step& other : chapter.steps)
        if (other.id == step.id) id.fail(fmt::format("'{}' is there twice", step.id));
    step.title = some_text(entry.at("title"));
    step.file = some_text(entry.at("file"));
    if (!has_exercise(root, chapter, step.file))
        entry.at("file").fail(fmt::format("there is no '{}' beside this file", step.file));
    step.points = static_cast<int>(entry.at("points").whole(1, 1000));
    if (entry.has("optional")) step.optional = entry.at("optional").boolean();
    if (entry.has("picture")) step.picture = some_text(entry.at("picture"));
    if (step.picture.ends_with(".scene") && !fs::exists(root / "references" / chapter.name / step.picture))
        entry.at("picture").fail(fmt::format("there is no references/{}/{}", chapter.name, step.picture));
    step.hints = texts(entry.at("hints"));
    if (step.hints.size() < 3)
        entry.at("hints").fail(fmt::format("expected at least 3, not {}", step.hints.size()));
    if (entry.has("uses"))
        for (const JsonValue& used : entry.at("uses").items()) {
            step.uses.push_back(used.text());
            if (!is_earlier(step.uses.back(), chapter))
                used.fail(fmt::format("'{}' is not an earlier step", step.uses.back()));
        }
    return step;
}

Chapter read_chapter(const Project& project, const fs::path& directory) {
    const fs::path file = directory / "chapter.json";
    if (!fs::exists(file)) throw InputError(relative(project, file) + " is missing");
    const JsonSource source = parse_json(relative(project, file), read_file(file));
    const JsonValue root = root_of(source);
    root.only({"title", "summary", "hours", "steps", "scenes"});

    Chapter chapter;
    chapter.name = directory.filename().string();
    chapter.number = chapter.name.substr(0, 2);
    chapter.title = some_text(root.at("title"));
    chapter.summary = some_text(root.at("summary"));
    chapter.hours = static_cast<int>(root.at("hours").whole(1, 100));
    for (const JsonValue& step : root.at("steps").items())
        chapter.steps.push_back(read_step(step, chapter, project.root));
    if (chapter.steps.empty()) root.at("steps").fail("expected at least one step");
    chapter.scenes = texts(root.at("scenes"));
    for (const JsonValue& scene : root.at("scenes").items())
        if (!fs::exists(project.root / "references" / chapter.name / scene.text()))
            scene.fail(fmt::format("there is no references/{}/{}", chapter.name, scene.text()));
    return chapter;
}

/// A chapter that has only its contract so far is not in the catalogue.
bool has_exercises(const fs::path& directory) {
    return std::any_of(fs::directory_iterator(directory), fs::directory_iterator(), [](const auto& entry) {
        return entry.path().filename() == "chapter.json" || entry.path().extension() == ".cpp";
    });
}

/// `2` and `02` and `2.1` with the zero in front.
std::string with_zero(std::string_view text) {
    const auto point = std::min(text.find('.'), text.size());
    return point == 1 ? "0" + std::string(text) : std::string(text);
}

}  // namespace

bool is_chapter_name(std::string_view name) {
    return name.size() > 3 && std::isdigit(static_cast<unsigned char>(name[0])) &&
           std::isdigit(static_cast<unsigned char>(name[1])) && name[2] == '_';
}

std::vector<Chapter> read_catalogue(const Project& project) {
    std::vector<fs::path> directories;
    const fs::path all = project.root / "chapters";
    if (fs::is_directory(all))
        for (const auto& entry : fs::directory_iterator(all))
            if (is_chapter_name(entry.path().filename().string()) && has_exercises(entry.path()))
                directories.push_back(entry.path());
    std::sort(directories.begin(), directories.end());

    std::vector<Chapter> chapters;
    for (const fs::path& directory : directories) chapters.push_back(read_chapter(project, directory));
    return chapters;
}

const Chapter& find_chapter(const std::vector<Chapter>& chapters, std::string_view number) {
    const std::string wanted = with_zero(number);
    std::string known;
    for (const Chapter& chapter : chapters) {
        if (chapter.number == wanted || chapter.name == number) return chapter;
        known += (known.empty() ? "" : ", ") + chapter.number;
    }
    throw InputError(fmt::format("there is no chapter '{}'; there are {}", number, known));
}

const Step& step_of(const Chapter& chapter, std::string_view id) {
    return *std::find_if(chapter.steps.begin(), chapter.steps.end(),
                         [&](const Step& step) { return step.id == id; });
}

Target find_target(const std::vector<Chapter>& chapters, std::string_view text) {
    const auto point = text.find('.');
    const Chapter& chapter = find_chapter(chapters, text.substr(0, point));
    if (point == std::string_view::npos) return {&chapter, nullptr};
    const std::string wanted = with_zero(text);
    std::string known;
    for (const Step& step : chapter.steps) {
        if (step.id == wanted) return {&chapter, &step};
        known += (known.empty() ? "" : ", ") + step.id;
    }
    throw InputError(fmt::format("there is no step '{}'; chapter {} has {}", text, chapter.number, known));
}

Target find_step(const std::vector<Chapter>& chapters, std::string_view text) {
    const Target target = find_target(chapters, text);
    if (!target.step)
        throw InputError(fmt::format("'{}' is a chapter; expected one of its steps, such as {}", text,
                                     target.chapter->steps.front().id));
    return target;
}

}  // namespace rt
