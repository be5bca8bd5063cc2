// All generated files against what they are generated from: exercises, code in lessons, the reference of
// scenes.
#include "common/evidence/drifted_files.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/scene/parse.hpp"
#include "common/workbook/lesson.hpp"

namespace rt {

namespace {

void add_drifted_lessons(const Project& project, const Chapter& chapter, std::vector<Drift>& drifted) {
    for (const std::filesystem::path& page : pages_of(project.root / "chapters" / chapter.name)) {
        const std::string text = read_file(page);
        const std::string expected = woven_lesson(text, relative(project, page), project.root).text;
        if (text != expected) drifted.push_back({page, expected});
    }
}

}  // namespace

std::vector<Drift> drifted_files(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<Drift> drifted = drifted_exercises(project, chapters);
    for (const Chapter& chapter : chapters) add_drifted_lessons(project, chapter, drifted);
    const std::filesystem::path reference = project.root / "common/scene/README.md";
    const std::string text = read_file(reference), begin = "<!-- commands -->\n";
    const std::size_t from = text.find(begin), to = text.find("<!-- /commands -->");
    if (from == std::string::npos || to == std::string::npos)
        throw InputError(relative(project, reference) + ": the marks around the table of commands are gone");
    const std::string expected =
        text.substr(0, from + begin.size()) + scene_command_table() + text.substr(to);
    if (text != expected) drifted.push_back({reference, expected});
    return drifted;
}

}  // namespace rt
