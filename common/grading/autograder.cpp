// Gradescope's autograder: the archive that an instructor uploads there, and what its scripts ask of the
// program.
#include "common/grading/autograder.hpp"

#include "common/grading/formats/formats.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/course_files.hpp"
#include "common/terminal/json_source.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/template.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// "--chapter 01 --chapter 02".
std::string chapter_options(const std::vector<const Chapter*>& chapters) {
    std::string words;
    for (const Chapter* chapter : chapters)
        words += (words.empty() ? "--chapter " : " --chapter ") + chapter->number;
    return words;
}

/// One of the two scripts, which Gradescope starts.
void write_script(const fs::path& file, const TemplateView& view) {
    const fs::path made = this_project().root / "common/grading/autograder" / file.filename();
    write_file(file, filled(made.string() + ".mustache", view, Escape::None));
    fs::permissions(file, fs::perms(0755));
}

/// Whether a file is built, or needed by what is built; what else lies in the tree, such as what a class has
/// handed in, is nobody's business there.
bool is_needed(const fs::path& file) {
    static const std::set<std::string> top{"CMakeLists.txt", "CMakePresets.json", "LICENSE",
                                           "course",         "chapters",          "common",
                                           "references",     "solutions",         "tests"};
    return top.contains(file.begin()->string());
}

/// What will stand in /autograder/source. Returns how many files it is.
std::size_t fill(const Project& project, const fs::path& source, const GraderOptions& options,
                 const fs::path& rubric) {
    std::size_t count = 2;
    for (const std::string& file : course_files(project)) {
        if (!is_needed(file) || !fs::is_regular_file(fs::symlink_status(project.root / file))) continue;
        const fs::path copy = source / "course" / file;
        fs::create_directories(copy.parent_path());
        fs::copy_file(project.root / file, copy);
        ++count;
    }
    std::string mark = fmt::format("{} --seed {} --isolation {}", chapter_options(options.chapters),
                                   options.seed, name_of(options.isolation));
    if (!rubric.empty()) {
        write_file(source / "grading.json", read_file(rubric));
        mark += " --rubric \"$place/source/grading.json\"";
        ++count;
    }
    write_script(source / "setup.sh", {{"chapters", chapter_options(options.chapters)}});
    write_script(source / "run_autograder", {{"arguments", mark}});
    return count;
}

/// A zip of all that is in `source`, by nobody in particular.
void pack(const fs::path& source, const fs::path& archive) {
    std::vector<std::string> command{"bsdtar", "--format",       "zip", "--uid",        "0", "--gid", "0",
                                     "-cf",    archive.string(), "-C",  source.string()};
    for (const auto& entry : fs::directory_iterator(source))
        command.push_back(entry.path().filename().string());
    const ProcessResult result = run_process(command);
    if (result.exit_code == 127)
        throw InputError("bsdtar, which packs the archive, is not installed (Debian: libarchive-tools)");
    if (!succeeded(result)) throw InputError("bsdtar: " + printable(result.output));
}

std::optional<Moment> moment_of_submission(const fs::path& metadata) {
    if (!fs::exists(metadata)) return {};
    const JsonSource source = parse_json(metadata.string(), read_file(metadata));
    const JsonValue created = root_of(source).at("created_at");
    const std::optional<Moment> moment = moment_of(created.text());
    if (!moment) created.fail("expected a time with its distance from UTC");
    return moment;
}

/// Results for what cannot be marked because of what was handed in.
std::string nothing_to_mark(const std::vector<const Chapter*>& chapters) {
    std::string files;
    for (const Chapter* chapter : chapters)
        for (const std::string& file : files_of_steps(*chapter))
            files += "\n" + exercise_path(*chapter, file);
    const nlohmann::ordered_json results = {
        {"score", 0},
        {"output",
         "What you handed in has no exercises, or has them in several folders. Hand in your whole "
         "tree, or these files:" +
             files},
        {"output_format", "text"},
        {"visibility", "visible"},
        {"stdout_visibility", "hidden"},
        {"tests", nlohmann::ordered_json::array()}};
    return json_text(results, 1) + "\n";
}

}  // namespace

std::size_t make_autograder(const Project& project, const fs::path& archive, const GraderOptions& options,
                            const fs::path& rubric) {
    require_writable(archive);
    StagedDirectory staged(archive);
    const fs::path source = staged.path / "source", packed = staged.path / "packed";
    fs::create_directories(source);
    const std::size_t count = fill(project, source, options, rubric);
    pack(source, packed);
    fs::rename(packed, archive);
    return count;
}

void mark_for_gradescope(const Project& project, const fs::path& place, const GraderOptions& options) {
    const fs::path directory = place / "submission", results = place / "results" / "results.json";
    if (!fs::is_directory(directory)) throw InputError(directory.string() + ": there is no such directory");
    Submission submission;
    try {
        submission = read_submission(directory, options.chapters);
    } catch (const InputError& error) {
        say(error.what());
        write_file(results, nothing_to_mark(options.chapters));
        return;
    }
    submission.submitted = moment_of_submission(place / "submission_metadata.json");
    Grader grader(project, options);
    const Grade grade = grader.grade(submission);
    write_file(results, find_format("gradescope")
                            .text({.grades = {grade},
                                   .rubric = options.rubric,
                                   .at = now(),
                                   .private_words = {},
                                   .classroom50 = {}}));
}

}  // namespace rt
