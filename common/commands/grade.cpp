// `course grade`: marks submissions, in boxes, by the chapters' own tests; a class may be marked in parts,
// here or on other machines.
#include "common/commands/commands.hpp"
#include "common/grading/class_list.hpp"
#include "common/grading/class_marks.hpp"
#include "common/grading/class_script.hpp"
#include "common/grading/formats/formats.hpp"
#include "common/grading/grade_json.hpp"
#include "common/grading/private_words.hpp"
#include "common/grading/submission_times.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/console.hpp"
#include "common/workbook/chosen_chapters.hpp"

#include <fmt/format.h>

namespace rt {

namespace fs = std::filesystem;

namespace {

void mark(const GradeCommand& command, const Project& project, GraderOptions options,
          FormatRequest& results) {
    const ClassList list = class_list(command.submissions);
    if (!command.part.empty()) results.part = part_named(command.part, list.names);
    std::vector<Submission> submissions =
        read_class(list, results.part, project, options.chapters, options.isolation);
    if (!command.submitted.empty())
        tell_times(submissions, command.submitted);
    else if (!options.rubric.due.empty())
        say("nothing counts as late: --submitted says when submissions were handed in");
    if (!command.seed) options.seed = seed_of_class(project);
    if (const std::vector<std::string> open = open_at(options.isolation); !open.empty())
        say("level {} leaves open: {}", name_of(options.isolation), fmt::join(open, "; "));
    Grader grader(project, options);
    ClassMarks marks = marks_of(submissions, KeptGrades(project, options),
                                [&](const Submission& submission, const auto& progress) {
                                    return grader.grade(submission, progress);
                                });
    results.grades = std::move(marks.grades);
    results.not_marked = std::move(marks.not_marked);
}

/// Whatever is wrong with what is asked is said now, and not on another machine.
std::string script_for(const GradeCommand& command, const Project& project, const Format& format,
                       const GraderOptions& options) {
    require_engine(command.on);
    const ClassList list = class_list(command.submissions);
    read_class(list, {}, project, options.chapters, options.isolation);
    ClassScript script{.engine = command.on,
                       .course = project.root / "course",
                       .directory = fs::current_path(),
                       .submissions = list.paths,
                       .options = command.part_options,
                       .rubric = command.rubric.string(),
                       .parts = command.parts > 0 ? command.parts : usual_parts(list.paths.size()),
                       .format = std::string(format.name)};
    // All machines have the same cases.
    if (!command.seed)
        script.options.insert(script.options.end(), {"--seed", std::to_string(seed_of_class(project))});
    return class_script(script);
}

void merge(const GradeCommand& command, FormatRequest& results) {
    std::vector<GradesFile> files;
    for (const fs::path& file : command.merge)
        files.push_back(read_grades_file(file.string(), read_file(file)));
    results.grades = merged(files);
    results.not_marked = not_marked_in(files);
    // What students may see, and when, is the rubric's.
    if (!results.grades.empty() && results.grades.front().rubric != digest_of(results.rubric))
        throw InputError(fmt::format("{}: was marked with another rubric than {}",
                                     printable(files.front().name),
                                     command.rubric.empty() ? "the chapters' points; --rubric names it"
                                                            : printable(command.rubric.string())));
}

}  // namespace

int run_grade(const GradeCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Format& format = find_format(!command.format.empty() ? command.format
                                       : command.part.empty()  ? "csv"
                                                               : "json");
    FormatRequest results;
    results.rubric = command.rubric.empty()
                         ? default_rubric(chapters)
                         : read_rubric(command.rubric.string(), read_file(command.rubric), chapters);
    if (!command.output.empty()) require_writable(command.output);
    const GraderOptions options{.chapters = named_chapters(chapters, command.chapters),
                                .rubric = results.rubric,
                                .seed = command.seed.value_or(0),
                                .isolation = isolation_named(command.isolation)};
    std::string text;
    if (!command.on.empty()) {
        text = script_for(command, project, format, options);
    } else {
        if (command.merge.empty())
            mark(command, project, options, results);
        else
            merge(command, results);
        results.at = now();
        results.private_words = private_words(project);
        text = format.text(results);
    }
    if (command.output.empty())
        fmt::print("{}", text);
    else
        write_file(command.output, text);
    // A part's file says who has no mark, and it is said when the parts are merged.
    if (!results.not_marked.empty() && !results.part)
        throw InputError(fmt::format("the grader failed at {}; the results are of all others",
                                     printable(fmt::format("{}", fmt::join(results.not_marked, ", ")))));
    return 0;
}

}  // namespace rt
