// `course autograder`: the archive for Gradescope, and what its scripts ask for.
#include "common/grading/autograder.hpp"
#include "common/commands/commands.hpp"
#include "common/grading/kept_grades.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/chosen_chapters.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

namespace {

int make(const AutograderCommand& command, GraderOptions options) {
    const Project project = this_project();
    require_solutions(project, "./course autograder");
    if (!command.seed) options.seed = seed_of_class(project);
    const std::size_t files = make_autograder(project, command.archive, options, command.rubric);
    const nlohmann::ordered_json object = {{"output", command.archive.string()}, {"files", files}};
    if (command.json)
        fmt::print("{}\n", json_text(object));
    else
        fmt::print("made {}: {}\n", printable(command.archive.string()), counted(files, "file"));
    return 0;
}

}  // namespace

int run_autograder(const AutograderCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const GraderOptions options{
        .chapters = named_chapters(chapters, command.chapters),
        .rubric = command.rubric.empty()
                      ? default_rubric(chapters)
                      : read_rubric(command.rubric.string(), read_file(command.rubric), chapters),
        .seed = command.seed.value_or(0),
        .isolation = isolation_named(command.isolation)};
    if (!command.archive.empty()) return make(command, options);
    if (command.prepare) {
        prepare_boxes(project, options.isolation);
        const Workshop built(project, options.chapters, options.isolation);
    } else if (!command.place.empty()) {
        mark_for_gradescope(project, command.place, options);
    } else {
        throw InputError("say where the archive is to be made, such as ./course autograder autograder.zip");
    }
    return 0;
}

}  // namespace rt
