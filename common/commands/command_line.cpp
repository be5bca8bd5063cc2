// What can be asked for on the command line, with help and examples.
#include "common/commands/command_line.hpp"

#include "common/grading/class_script.hpp"
#include "common/grading/formats/formats.hpp"
#include "common/scene/integrators.hpp"
#include "common/scene/parse.hpp"
#include "common/scene/text.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace rt {

namespace {

/// The text as a whole number from `least` to `most`, in decimal: CLI11 takes 010 for eight.
CLI::Validator whole_number(long long least, long long most) {
    return {[=](std::string& text) -> std::string {
                const std::string_view digits = std::string_view(text).substr(text.starts_with('+') ? 1 : 0);
                long long value = 0;
                const char* end = digits.data() + digits.size();
                const auto [stop, error] = std::from_chars(digits.data(), end, value);
                if (error != std::errc() || stop != end || value < least || value > most)
                    return fmt::format("'{}' is not a whole number from {} to {}", text, least, most);
                text = std::to_string(value);
                return "";
            },
            fmt::format("{} to {}", least, most)};
}

/// The text as a number from `least` to `most`, written as in a scene: neither infinite nor NaN.
CLI::Validator number(double least, double most) {
    return {[=](std::string& text) -> std::string {
                const ParsedNumber parsed = parse_number(text);
                if (!parsed.problem.empty()) return fmt::format("'{}' {}", text, parsed.problem);
                if (parsed.value < least || parsed.value > most)
                    return fmt::format("'{}' is not between {:g} and {:g}", text, least, most);
                text = shown(parsed.value);
                return "";
            },
            fmt::format("{:g} to {:g}", least, most)};
}

/// No option means anything by an empty text; it is a variable of a script that was never set.
void refuse_empty_values(CLI::App& app) {
    const CLI::Validator not_empty(
        [](std::string& text) -> std::string { return text.empty() ? "the value is empty" : ""; }, "");
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options())
            if (option->get_items_expected_max() > 0) option->check(not_empty);
}

constexpr const char* for_instructors = "For instructors";
constexpr const char* for_maintainers = "For maintainers";
constexpr const char* lenient_help =
    "skip with a warning what other programs may know of the scene: commands, values, arguments";

CLI::App* add_command(CommandLine& line, const std::string& name, const std::string& what,
                      const std::string& example, const std::function<int()>& run) {
    CLI::App* sub = line.app.add_subcommand(name, what);
    sub->footer("Example:\n  ./course " + example);
    sub->add_flag("--json", line.json, "one JSON object on standard output, nothing else there");
    sub->callback([&line, run] { line.action = run; });
    return sub;
}

void add_check(CommandLine& line) {
    CLI::App* sub = add_command(
        line, "check",
        "build and test your code: chapters (02), steps (02.1), or the chapter in "
        "progress",
        "check 02", [&line] { return line.check.watch ? run_watch(line.check) : run_check(line.check); });
    sub->add_option("what", line.check.targets, "chapters or steps, such as 02 or 02.1");
    CLI::Option* solutions = sub->add_flag("--solutions", line.check.solutions,
                                           "the solutions instead of your code; default: all chapters");
    sub->add_flag(
           "--watch", line.check.watch,
           "one step at a time, checked again whenever you save a file; keys for hint, picture and list")
        ->excludes(solutions)
        ->excludes("--json");
}

void add_list(CommandLine& line) {
    add_command(line, "list", "chapters and steps with titles, points and state", "list",
                [&line] { return run_list(line.json); });
}

void add_hint(CommandLine& line) {
    CLI::App* sub = add_command(line, "hint", "one more hint for a step", "hint 02.1",
                                [&line] { return run_hint(line.step, line.all, line.json); });
    sub->add_option("step", line.step, "such as 02.1")->required();
    sub->add_flag("--all", line.all, "all of them at once");
}

void add_reset(CommandLine& line) {
    CLI::App* sub =
        add_command(line, "reset", "a chapter or a step back to its start; your file is kept as a backup",
                    "reset 02.1", [&line] { return run_reset(line.step, line.json); });
    sub->add_option("what", line.step, "a chapter or a step, such as 02 or 02.1")->required();
}

void add_solution(CommandLine& line) {
    CLI::App* sub = add_command(line, "solution", "your code for a step, and the solution's", "solution 02.1",
                                [&line] { return run_solution(line.step, line.spoil, line.json); });
    sub->add_option("step", line.step, "such as 02.1")->required();
    sub->add_flag("--spoil", line.spoil, "also before the step has passed");
}

void add_render(CommandLine& line) {
    CLI::App* sub = add_command(line, "render", "a scene to a picture: .png, .pfm or .hdr",
                                "render references/02_spheres/normals.scene -o normals.png --preview",
                                [&line] { return run_render(line.render); });
    sub->add_option("scene", line.render.scene, "the scene's file")->required();
    sub->add_option("-o,--output", line.render.output,
                    "the picture's file; default: as the scene says, else its name");
    sub->add_option("--size", line.render.size, "width and height in pixels, such as 640x480");
    sub->add_option("--threads", line.render.threads, "number of threads; default: one a core")
        ->transform(whole_number(1, 1024));
    sub->add_option(
        "--integrator", line.render.integrator,
        fmt::format("{}: one of these instead of the scene's", fmt::join(integrator_names(), ", ")));
    CLI::Option* samples =
        sub->add_option("--spp", line.render.samples, "samples a pixel, instead of the scene's")
            ->transform(whole_number(1, most_samples));
    sub->add_option("--seconds", line.render.seconds, "go on with more samples for so long")
        ->transform(number(1e-3, 1e6))
        ->excludes(samples);
    sub->add_option("--error", line.render.error,
                    "go on with more samples until the RMS error is about so small, such as 0.002")
        ->transform(number(1e-6, 1))
        ->excludes(samples);
    sub->add_option("--seed", line.render.seed, "which random numbers are used")
        ->transform(whole_number(0, (1LL << 53) - 1));
    CLI::Option* solutions =
        sub->add_flag("--solutions", line.render.solutions, "with the solutions of all chapters");
    sub->add_flag("--mine", line.render.mine, "by all that you have begun, whether it passes or not")
        ->excludes(solutions);
    sub->add_flag("--preview", line.render.preview, "show the picture in the terminal, too");
    sub->add_flag("--lenient", line.render.lenient, lenient_help);
    sub->add_flag("--quiet", line.render.quiet, "no progress and no summary");
}

void add_compare(CommandLine& line) {
    CLI::App* sub = add_command(line, "compare", "how far a picture is from a reference",
                                "compare mine.png references/02_spheres/normals.png --page compare.html "
                                "--scene references/02_spheres/normals.scene",
                                [&line] { return run_compare(line.compare); });
    sub->add_option("image", line.compare.image, "a .png, .pfm or .hdr")->required();
    sub->add_option("reference", line.compare.reference, "another of the same size")->required();
    sub->add_option(
           "--within", line.compare.within,
           "the same if 99.9 % of the pixels differ by N/255 of the display's range at most; default 1")
        ->transform(whole_number(0, 255));
    sub->add_option("--diff", line.compare.diff, "write a picture of the differences");
    CLI::Option* page = sub->add_option(
        "--page", line.compare.page, "write a page: both pictures under a slider, where and how they differ");
    sub->add_option(
           "--scene", line.compare.scene,
           "the scene of the pictures: on a click the page shows the rays of a pixel, by your code and "
           "by the solutions")
        ->needs(page);
    sub->add_option("--encoding", line.compare.encoding, "of 8-bit files: srgb or linear; default srgb")
        ->check(CLI::IsMember({"srgb", "linear"}));
}

void add_explain(CommandLine& line) {
    CLI::App* sub = add_command(
        line, "explain", "what a scene needs, what was left out and why, and which chapters draw it",
        "explain references/02_spheres/normals.scene", [&line] { return run_explain(line.explain); });
    sub->add_option("scene", line.explain.scene, "the scene's file")->required();
    sub->add_flag("--lenient", line.explain.lenient, lenient_help);
}

void add_trace(CommandLine& line) {
    CLI::App* sub = add_command(line, "trace", "the ray tree of one pixel",
                                "trace references/02_spheres/normals.scene 160 120",
                                [&line] { return run_trace(line.trace); });
    sub->add_option("scene", line.trace.scene, "the scene's file")->required();
    sub->add_option("x", line.trace.x, "the pixel's column, from 0 at the left")
        ->transform(whole_number(0, largest_side - 1))
        ->required();
    sub->add_option("y", line.trace.y, "the pixel's row, from 0 at the top")
        ->transform(whole_number(0, largest_side - 1))
        ->required();
    sub->add_option("--size", line.trace.size, "WxH of the picture instead of the scene's");
    sub->add_flag("--lenient", line.trace.lenient, lenient_help);
    // For the program itself, which asks the student's code for many pixels at once.
    sub->add_option("--also", line.trace.also, "")->group("");
    CLI::Option* mine =
        sub->add_flag("--mine", line.trace.mine, "by all that you have begun, whether it passes or not");
    sub->add_option("--against", line.trace.against,
                    "solutions: your tree beside theirs, to the first difference")
        ->excludes(mine);
}

void add_export(CommandLine& line) {
    CLI::App* sub = add_command(line, "export", "a scene for POV-Ray",
                                "export references/02_spheres/normals.scene -o normals.pov",
                                [&line] { return run_export(line.export_scene); });
    sub->add_option("scene", line.export_scene.scene, "the scene's file")->required();
    sub->add_option("-o,--output", line.export_scene.output, "the file for POV-Ray")->required();
    sub->add_flag("--lenient", line.export_scene.lenient, lenient_help);
}

void add_tour(CommandLine& line) {
    CLI::App* sub =
        add_command(line, "tour", "render every chapter's scenes, compare them with POV-Ray's, write a page",
                    "tour", [&line] { return run_tour(line.tour); });
    sub->add_option("-o,--output", line.tour.output, "directory of the page; default: build/tour");
}

void add_report(CommandLine& line) {
    CLI::App* sub =
        add_command(line, "report", "how wrong, how fast, and where it breaks: measured, with a page",
                    "report error-time --quick", [&line] { return run_report(line.report); });
    sub->add_option("what", line.report.what, "error-time, stability or leave-out; default: all three");
    sub->add_option("-o,--output", line.report.output, "directory of the page; default: build/report");
    sub->add_flag("--quick", line.report.quick,
                  "a minute or two instead of ten: fewer cases, samples and triangles");
}

void add_test(CommandLine& line) {
    CLI::App* sub = add_command(line, "test", "every test of the project", "test --quick",
                                [&line] { return run_test(line.quick, line.json); });
    sub->add_flag("--quick", line.quick, "fewer random cases, one known mistake a step, no scripts");
}

void add_handout(CommandLine& line) {
    CLI::App* sub = add_command(line, "handout", "a tree for students, without solutions",
                                "handout ../handout --chapters 1-5 --class class.json",
                                [&line] { return run_handout(line.handout); });
    sub->add_option("directory", line.handout.directory, "what is made, or brought up to date")->required();
    sub->add_option("--chapters", line.handout.chapters,
                    "from the first to another, such as 1-5; default: all, or those that the handout has");
    sub->add_option("--class", line.handout.about,
                    "a JSON file with the names and dates for the README; default: none, or as before");
    sub->add_flag("--update", line.handout.update,
                  "bring what is given there up to date, and leave what a student has written");
    sub->group(for_instructors);
}

/// What was asked of `course grade` and is to be asked for each part of the class, as words.
std::vector<std::string> part_options(const CLI::App& grade) {
    std::vector<std::string> words;
    for (const CLI::Option* option : grade.get_options()) {
        const std::string name = option->get_name();
        if (option->get_positional() || name == "--on" || name == "--parts" || name == "--format" ||
            name == "--output" || name == "--json")
            continue;
        for (const std::string& value : option->results()) {
            words.push_back(name);
            words.push_back(value);
        }
    }
    return words;
}

void add_grade(CommandLine& line) {
    CLI::App* sub = add_command(line, "grade", "mark submissions, safely, by the chapters' own tests",
                                "grade submissions/* --chapter 02 --format html -o class.html", [&line] {
                                    const CLI::App& grade = *line.app.get_subcommand("grade");
                                    line.grade.part_options = part_options(grade);
                                    return run_grade(line.grade);
                                });
    CLI::Option* submissions =
        sub->add_option("submissions", line.grade.submissions,
                        "a directory or an archive each: a student's tree or its exercises");
    sub->add_option("--submitted", line.grade.submitted,
                    "a file of lines such as ada,2027-03-01T23:59:00+01:00: when each was handed in")
        ->needs(submissions);
    sub->add_option("--chapter", line.grade.chapters, "such as 02, and again for more; default: all");
    sub->add_option("--rubric", line.grade.rubric, "a grading.json; default: the chapters' points");
    sub->add_option("--seed", line.grade.seed, "of the random cases; default: one that the class keeps")
        ->transform(whole_number(0, 1LL << 53));
    sub->add_option("--isolation", line.grade.isolation, "bwrap, user or none; default: bwrap");
    CLI::Option* part = sub->add_option("--part", line.grade.part,
                                        "such as 2/7: mark the second of seven parts of these submissions");
    sub->add_option("--merge", line.grade.merge, "files of all the parts, which become those of one class")
        ->excludes(submissions)
        ->excludes(part);
    CLI::Option* on =
        sub->add_option("--on", line.grade.on,
                        fmt::format("{}: write the script that marks the class on several machines by it",
                                    fmt::join(engines(), " or ")))
            ->excludes(part)
            ->excludes("--merge");
    sub->add_option("--parts", line.grade.parts,
                    "how many the script makes; default: one for ten submissions")
        ->transform(whole_number(1, 100'000))
        ->needs(on);
    std::string names;
    for (const Format& format : formats()) names += (names.empty() ? "" : ", ") + std::string(format.name);
    sub->add_option("--format", line.grade.format, names + "; default: csv, of a part json");
    sub->add_option("-o,--output", line.grade.output, "the file; default: standard output");
    sub->group(for_instructors);
}

void add_similarity(CommandLine& line) {
    CLI::App* sub =
        add_command(line, "similarity", "what submissions share with each other and with what is published",
                    "similarity submissions/* --chapter 02 -o similarity.html",
                    [&line] { return run_similarity(line.similarity); });
    sub->add_option("submissions", line.similarity.submissions, "as of grade")->required();
    sub->add_option("--chapter", line.similarity.chapters, "such as 02, and again for more; default: all");
    sub->add_option("--isolation", line.similarity.isolation,
                    "of the boxes in which archives are opened; default: bwrap");
    sub->add_option("--least", line.similarity.least, "per cent from which on a pair is listed; default: 70")
        ->transform(whole_number(0, 100));
    sub->add_option("-o,--output", line.similarity.output,
                    ".html, .csv or .json; default: the most similar on standard output");
    sub->group(for_instructors);
}

void add_autograder(CommandLine& line) {
    CLI::App* sub = add_command(line, "autograder", "an autograder for Gradescope: a zip to upload there",
                                "autograder autograder.zip --chapter 02",
                                [&line] { return run_autograder(line.autograder); });
    CLI::Option* archive = sub->add_option("archive", line.autograder.archive, "the zip that is made");
    CLI::Option* prepare = sub->add_flag("--prepare", line.autograder.prepare,
                                         "in Gradescope's image: build all that marking needs")
                               ->excludes(archive);
    sub->add_option("--mark", line.autograder.place,
                    "in Gradescope's image: mark what is in this directory, which is /autograder")
        ->excludes(archive)
        ->excludes(prepare);
    sub->add_option("--chapter", line.autograder.chapters, "such as 02, and again for more; default: all");
    sub->add_option("--rubric", line.autograder.rubric, "a grading.json; default: the chapters' points");
    sub->add_option("--seed", line.autograder.seed,
                    "of the random cases; default: the one that the class keeps")
        ->transform(whole_number(0, 1LL << 53));
    sub->add_option("--isolation", line.autograder.isolation, "bwrap, user or none; default: user");
    sub->group(for_instructors);
}

void add_references(CommandLine& line) {
    CLI::App* sub = add_command(line, "references",
                                "render the references with POV-Ray again and report any that changed",
                                "references 02", [&line] {
                                    if (line.random.count > 0) return run_random_references(line.random);
                                    return run_references(line.references);
                                });
    sub->add_option("chapter", line.references.chapter, "such as 02; default: all");
    CLI::Option* make = sub->add_flag("--make", line.references.make, "write them");
    CLI::Option* random =
        sub->add_option(
               "--random", line.random.count,
               "make up so many scenes instead: each must be equal by POV-Ray, or refused by the export")
            ->transform(whole_number(1, 1'000'000))
            ->excludes(make);
    sub->add_option("--first", line.random.first, "number of the first random scene; default 0")
        ->transform(whole_number(0, 1LL << 53))
        ->needs(random);
    sub->group(for_maintainers);
}

void add_exercises(CommandLine& line) {
    CLI::App* sub = add_command(
        line, "exercises",
        "report generated files that differ: exercises, code in lessons, the table of scene commands",
        "exercises", [&line] { return run_exercises(line.make, line.json); });
    sub->add_flag("--make", line.make, "write them");
    sub->group(for_maintainers);
}

void add_figures(CommandLine& line) {
    CLI::App* sub =
        add_command(line, "figures", "draw the lessons' figures again and report any that changed",
                    "figures 02", [&line] { return run_figures(line.chapter, line.make, line.json); });
    sub->add_option("chapter", line.chapter, "such as 02; default: all");
    sub->add_flag("--make", line.make, "write them");
    sub->group(for_maintainers);
}

void add_mutate(CommandLine& line) {
    CLI::App* sub =
        add_command(line, "mutate",
                    "change the solutions at one place at a time, and report what the tests do not notice",
                    "mutate 02.1", [&line] { return run_mutate(line.mutate); });
    sub->add_option("targets", line.mutate.targets, "such as 02 or 02.1; default: all chapters, for hours");
    sub->add_option("--sample", line.mutate.sample, "only so many changes of each chapter")
        ->transform(whole_number(1, 1'000'000));
    sub->group(for_maintainers);
}

void add_new(CommandLine& line) {
    CLI::App* sub = add_command(line, "new", "a new chapter's rooms, with one step that is complete",
                                "new 11_area_lights", [&line] { return run_new(line.chapter, line.json); });
    sub->add_option("name", line.chapter, "number and words, such as 11_area_lights")->required();
    sub->group(for_maintainers);
}

/// In a handout, what needs solutions is not offered, and says why.
void leave_out_in_handout(CommandLine& line) {
    if (has_solutions(this_project())) return;
    for (const char* name : {"solution", "tour", "report", "test", "grade", "similarity", "autograder",
                             "handout", "references", "exercises", "figures", "mutate", "new"}) {
        CLI::App* command = line.app.get_subcommand(name);
        command->group("");
        command->callback([&line, name] {
            line.action = [name] {
                require_solutions(this_project(), std::string("./course ") + name);
                return 0;
            };
        });
    }
}

}  // namespace

void describe_commands(CommandLine& line) {
    line.app.require_subcommand(0, 1);
    line.app.add_flag("--json", line.json, "one JSON object on standard output, nothing else there");
    line.app.footer(
        "Without a command: where you are, and what to do next.\n"
        "Example:\n  ./course check 02\n"
        "Each command has --help.");
    // In the order of --help.
    for (void (*add)(CommandLine&) :
         {add_check,     add_list,    add_hint,       add_reset,      add_solution, add_render,
          add_compare,   add_explain, add_trace,      add_export,     add_tour,     add_report,
          add_test,      add_grade,   add_similarity, add_autograder, add_handout,  add_references,
          add_exercises, add_figures, add_mutate,     add_new})
        add(line);
    leave_out_in_handout(line);
    refuse_empty_values(line.app);
}

}  // namespace rt
