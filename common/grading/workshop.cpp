// Where submissions become programs: the course's own parts are built once, a student's files in a box.
#include "common/grading/workshop.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/sandbox/system_files.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace rt {

namespace fs = std::filesystem;

namespace {

const char* const compiler = "/usr/bin/g++";

/// CMakeLists.txt has them, because the headers that all include are compiled with the same.
std::vector<std::string> compiler_flags() {
    std::istringstream words(COURSE_GRADING_FLAGS);
    return {std::istream_iterator<std::string>(words), {}};
}

/// Copies the headers that a chapter may include: the contracts, what they stand on, and what the build has
/// compiled of them.
void copy_headers(const Project& project, const fs::path& to) {
    for (const char* top : {"chapters", "common"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(project.root / top)) {
            if (!entry.is_regular_file() || entry.path().extension() != ".hpp") continue;
            const fs::path target = to / fs::relative(entry.path(), project.root);
            fs::create_directories(target.parent_path());
            fs::copy_file(entry.path(), target);
        }
    for (const char* name : {"common.hpp", "common.hpp.gch"})
        fs::copy_file(project.build / "grading" / name, to / name);
}

/// The first error, with the file's name as from the root.
std::string first_of(const Project& project, std::string output, const std::string& job) {
    for (auto at = output.find(job); at != std::string::npos; at = output.find(job, at))
        output.erase(at, job.size());
    return first_error(project, output);
}

Sandbox compilers_box(Isolation isolation) {
    Sandbox box;
    box.isolation = isolation;
    box.limits = compiler_limits();
    box.mounts = compiler_mounts();
    return box;
}

}  // namespace

void prepare_boxes(const Project& project, Isolation isolation) {
    const BuildResult built = build_targets(project, {"course-box"}, "Building boxes");
    if (!built.ok) throw InputError("boxes do not build: " + built.message);
    require_possible(isolation);
}

Workshop::Workshop(const Project& project, const std::vector<const Chapter*>& chapters, Isolation isolation)
    : project_(project), isolation_(isolation), shared_(fs::temp_directory_path() / "course-grading") {
    std::vector<std::string> targets{"grading_kit", "grading_headers"};
    for (const Chapter& chapter : read_catalogue(project)) {
        numbers_.push_back(chapter.number);
        targets.push_back("grading_solution_" + chapter.number);
    }
    for (const Chapter* chapter : chapters) targets.push_back("judge_" + chapter->number);
    const BuildResult built = build_targets(project, targets, "Building the judges");
    if (!built.ok) throw InputError("the judges do not build: " + built.message);

    fs::permissions(place(), fs::perms(0755));  // boxes have uids of their own
}

void Workshop::furnish() {
    if (is_furnished_) return;
    copy_headers(project_, place() / "include");
    fs::create_directories(place() / "lib");
    for (const fs::path& library : files_in(project_.build / "grading", {".a"}))
        fs::copy_file(library, place() / "lib" / library.filename());
    is_furnished_ = true;
}

const Workshop::Compiled& Workshop::compiled(const Chapter& chapter, const std::string& file,
                                             const std::string& text) {
    furnish();
    const std::string name = exercise_path(chapter, file);
    const std::string key = fingerprint(name + "\n" + text);
    const auto known = compiled_.find(key);
    if (known != compiled_.end()) return known->second;

    const fs::path directory = place() / "objects" / key;
    fs::create_directories((directory / name).parent_path());
    write_file(directory / name, text);
    Sandbox box = compilers_box(isolation_);
    box.mounts.push_back({(place() / "include").string(), "/course"});
    box.mounts.push_back({directory.string(), "/job"});
    Compiled made{directory / "out.o", "", 0};
    box.products.push_back({"out.o", made.object.string()});

    const std::string include = seen_from(box, place() / "include"), job = seen_from(box, directory) + "/";
    std::vector<std::string> command{compiler};
    for (const std::string& option : compiler_flags()) command.push_back(option);
    for (const std::string& option : short_diagnostics()) command.push_back(option);
    command.insert(command.end(),
                   {"-I", include, "-include", include + "/common.hpp", "-c", job + name, "-o", "out.o"});
    const Ending ending = run_in(box, command);
    made.peak_memory = ending.peak_memory;
    if (ending.products.empty()) {
        const bool said = ending.end == End::Exited && !ending.errors.empty();
        made.error = said ? printable(first_of(project_, ending.errors, job))
                          : fmt::format("the compiler {}", in_words(ending, box.limits));
    }
    return compiled_[key] = made;
}

fs::path Workshop::pristine_object(const Chapter& chapter, const std::string& file) {
    const std::optional<std::string> text = pristine_text(project_, chapter, file);
    if (!text) throw InputError(exercise_path(chapter, file) + ": there is no pristine exercise");
    return compiled(chapter, file, *text).object;
}

std::string Workshop::link(const Chapter& chapter, const std::vector<fs::path>& objects,
                           const fs::path& directory, std::uint64_t& peak_memory) {
    Sandbox box = compilers_box(isolation_);
    box.mounts.push_back({place().string(), "/course"});
    box.products.push_back({"out", (directory / "worker").string()});
    std::vector<std::string> command{compiler, "-o", "out"};
    for (const fs::path& object : objects) command.push_back(seen_from(box, object));
    command.push_back("-Wl,--start-group");
    for (const std::string& number : numbers_)
        if (number != chapter.number)
            command.push_back(seen_from(box, place() / "lib" / ("libgrading_solution_" + number + ".a")));
    command.insert(command.end(), {seen_from(box, place() / "lib" / "libgrading_kit.a"), "-Wl,--end-group",
                                   "-ltbb", "-lfmt", "-lspng", "-pthread"});
    // At a level without mounts a worker could read the solution of its own chapter there: only linkers may.
    fs::permissions(place() / "lib", fs::perms(0755));
    const Ending ending = run_in(box, command);
    fs::permissions(place() / "lib", fs::perms(0700));
    peak_memory = std::max(peak_memory, ending.peak_memory);
    if (!ending.products.empty()) return "";
    if (ending.end != End::Exited || ending.errors.empty())
        return fmt::format("the linker {}", in_words(ending, box.limits));
    return printable(first_of(project_, ending.errors, seen_from(box, directory) + "/"));
}

fs::path Workshop::object_of(const Chapter& chapter, const Submission& submission, const std::string& file,
                             BuiltWorker& built) {
    const auto text = submission.files.find(exercise_path(chapter, file));
    if (text == submission.files.end()) return pristine_object(chapter, file);
    const Compiled& mine = compiled(chapter, file, text->second);
    built.peak_memory = std::max(built.peak_memory, mine.peak_memory);
    if (mine.error.empty()) return mine.object;
    built.errors[file] = mine.error;
    return pristine_object(chapter, file);
}

BuiltWorker Workshop::build(const Chapter& chapter, const Submission& submission, const fs::path& directory) {
    BuiltWorker built;
    const std::vector<std::string> files = exercise_files(project_, chapter);
    std::vector<fs::path> objects;
    for (const std::string& file : files) objects.push_back(object_of(chapter, submission, file, built));
    std::string error = link(chapter, objects, directory, built.peak_memory);
    if (!error.empty()) {
        // Whose fault is it? A file that does not even link alone is left out; if none, all of them are.
        const std::vector<fs::path> all = objects;
        std::vector<fs::path> pristine_objects;
        for (const std::string& file : files) pristine_objects.push_back(pristine_object(chapter, file));
        for (std::size_t i = 0; i < files.size(); ++i) {
            std::vector<fs::path> alone = pristine_objects;
            alone[i] = all[i];
            if (alone == pristine_objects) continue;
            const std::string why = link(chapter, alone, directory, built.peak_memory);
            if (why.empty()) continue;
            built.errors[files[i]] = why;
            objects[i] = pristine_objects[i];
        }
        const bool nobodys = objects == all;
        if (nobodys) {
            for (const std::string& file : files_of_steps(chapter)) built.errors.try_emplace(file, error);
            objects = pristine_objects;
        }
        error = link(chapter, objects, directory, built.peak_memory);
    }
    if (!error.empty()) return built;
    // Written by a box with a uid of its own, run by another.
    built.program = directory / "worker";
    fs::permissions(built.program, fs::perms(0755));
    return built;
}

}  // namespace rt
