// The chapters as their chapter.json describe them: steps, hints, points and scenes.
#include "common/workbook/catalogue.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A chapter.json being read: its name for messages, and where in it we are.
struct Source {
    std::string file;

    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw InputError(file + ": " + key + ": " + what);
    }
};

const json& member(const Source& source, const json& object, const std::string& path, const char* key) {
    if (!object.is_object()) source.fail(path.empty() ? "the file" : path, "expected an object");
    const auto found = object.find(key);
    if (found == object.end()) source.fail(path.empty() ? key : path + "." + key, "is missing");
    return *found;
}

std::string text(const Source& source, const json& object, const std::string& path, const char* key) {
    const json& value = member(source, object, path, key);
    const std::string full = path.empty() ? key : path + "." + key;
    if (!value.is_string() || value.get<std::string>().empty()) source.fail(full, "expected a text");
    return value.get<std::string>();
}

std::vector<std::string> texts(const Source& source, const json& object, const std::string& path,
                               const char* key) {
    const json& value = member(source, object, path, key);
    const std::string full = path.empty() ? key : path + "." + key;
    const bool good = value.is_array() && std::all_of(value.begin(), value.end(), [](const json& entry) {
                          return entry.is_string() && !entry.get<std::string>().empty();
                      });
    if (!good) source.fail(full, "expected a list of texts");
    return value.get<std::vector<std::string>>();
}

void refuse_unknown(const Source& source, const json& object, const std::string& path,
                    const std::set<std::string>& known) {
    for (const auto& [key, value] : object.items())
        if (!known.contains(key)) source.fail(path.empty() ? key : path + "." + key, "is not known");
}

Step read_step(const Source& source, const json& entry, const std::string& path, const Chapter& chapter,
               const fs::path& directory) {
    Step step;
    step.id = text(source, entry, path, "id");
    if (!is_step_id(step.id) || !step.id.starts_with(chapter.number + "."))
        source.fail(path + ".id", fmt::format("'{}' is not a step of chapter {}; expected '{}.N'", step.id,
                                              chapter.number, chapter.number));
    for (const Step& other : chapter.steps)
        if (other.id == step.id) source.fail(path + ".id", fmt::format("'{}' is there twice", step.id));
    step.title = text(source, entry, path, "title");
    step.file = text(source, entry, path, "file");
    // Before its exercises are generated for the first time, and after a student has deleted it, a chapter
    // has only the file's original.
    const fs::path root = directory.parent_path().parent_path();
    if (!fs::exists(directory / step.file) && !fs::exists(root / "solutions" / chapter.name / step.file) &&
        !fs::exists(root / ".course" / "pristine" / chapter.name / step.file))
        source.fail(path + ".file", fmt::format("there is no '{}' beside this file", step.file));
    const json& points = member(source, entry, path, "points");
    if (!points.is_number_integer() || points.get<long long>() <= 0 || points.get<long long>() > 1000)
        source.fail(path + ".points", "expected a whole number from 1 to 1000");
    step.points = points.get<int>();
    step.hints = texts(source, entry, path, "hints");
    if (step.hints.size() < 3)
        source.fail(path + ".hints", fmt::format("expected at least 3, not {}", step.hints.size()));
    refuse_unknown(source, entry, path, {"id", "title", "file", "points", "hints"});
    return step;
}

Chapter read_chapter(const Project& project, const fs::path& directory) {
    const fs::path file = directory / "chapter.json";
    const Source source{relative(project, file)};
    if (!fs::exists(file)) source.fail("the file", "is missing");
    const json root = json::parse(read_file(file), nullptr, false);
    if (root.is_discarded()) source.fail("the file", "is not JSON");

    Chapter chapter;
    chapter.name = directory.filename().string();
    chapter.number = chapter.name.substr(0, 2);
    chapter.title = text(source, root, "", "title");
    chapter.summary = text(source, root, "", "summary");
    const json& steps = member(source, root, "", "steps");
    if (!steps.is_array() || steps.empty()) source.fail("steps", "expected a list of at least one step");
    for (std::size_t i = 0; i < steps.size(); ++i)
        chapter.steps.push_back(read_step(source, steps[i], fmt::format("steps[{}]", i), chapter, directory));
    chapter.scenes = texts(source, root, "", "scenes");
    for (const std::string& scene : chapter.scenes)
        if (!fs::exists(project.root / "references" / chapter.name / scene))
            source.fail("scenes", fmt::format("there is no references/{}/{}", chapter.name, scene));
    refuse_unknown(source, root, "", {"title", "summary", "steps", "scenes"});
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
