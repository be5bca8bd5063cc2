// How well the tests of chapters notice mutants of their solutions.
#include "common/evidence/mutation.hpp"

#include "common/evidence/equivalent_mutants.hpp"
#include "common/evidence/side_by_side.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/lock.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/shell.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>

namespace rt {

namespace fs = std::filesystem;

namespace {

// A chapter's quick tests take less than a second; what takes this long hangs.
constexpr double mutant_seconds = 5;

std::string test_program_of(const Chapter& chapter) { return "check_" + chapter.number + "_solution"; }

/// The build's own commands, as a shell reads them in the build directory.
class Commands {
public:
    Commands(const Project& project, const Chapter& chapter)
        : build_(project.build), program_("bin/" + test_program_of(chapter)), link_(command_for(program_)) {
        for (const auto& [file, text] : solution_files(project, chapter)) {
            const std::string object = fmt::format("CMakeFiles/solution_{}.dir/solutions/{}/{}.o",
                                                   chapter.number, chapter.name, file);
            const std::string compile = command_for(object);
            // Flags stand first, then what is written where, in the names of ninja's own files.
            compile_[file] = {object,
                              compile.substr(0, std::min(compile.find(" -MD "), compile.find(" -o ")))};
        }
    }

    /// Makes `program`, the chapter's tests with `source` in place of the solution's file; false if it does
    /// not compile.
    bool build(const std::string& file, const fs::path& source, const fs::path& program) const {
        const auto& [was, flags] = compile_.at(file);
        const std::string object = shell_word(fs::path(source).replace_extension(".o").string());
        const std::string link =
            exchanged(exchanged(link_, was, object), program_, shell_word(program.string()));
        return run(fmt::format("{} -w -Wno-error -o {} -c {}", flags, object, shell_word(source.string()))) &&
               run(link);
    }

private:
    /// What ninja would run to make this file.
    std::string command_for(const std::string& file) const {
        const ProcessResult result =
            run_process({"ninja", "-C", build_.string(), "-t", "commands", "-s", file});
        const std::vector<std::string> lines = split_lines(result.output);
        if (!succeeded(result) || lines.empty()) throw std::runtime_error("ninja: " + result.output);
        return lines.back();
    }

    /// The command with another file in place of this one, which is a word of it.
    static std::string exchanged(const std::string& command, const std::string& file,
                                 const std::string& other) {
        const auto at = command.find(" " + file + " ");
        if (at == std::string::npos) throw std::runtime_error("the build's command has no " + file);
        return std::string(command).replace(at + 1, file.size(), other);
    }

    bool run(const std::string& command) const {
        return succeeded(run_process({"sh", "-c", "cd " + shell_word(build_.string()) + " && " + command}));
    }

    struct Compile {
        std::string object, flags;
    };
    fs::path build_;
    std::string program_, link_;
    std::map<std::string, Compile> compile_;  ///< by the solution's file
};

/// Whether the tests with these tags, as Catch2 selects them, all pass.
bool passes(const fs::path& program, const std::string& tags) {
    ProcessOptions options;
    options.time_limit = mutant_seconds;
    const ProcessResult result =
        run_process({program.string(), "--quick", "--abort", "--order", "decl", tags}, options);
    return succeeded(result) && !result.timed_out;
}

/// What becomes of `text` in place of the solution's file. The directory is made for this, and nobody else's.
Fate fate_of(const Commands& commands, const std::string& file, const std::string& text,
             const std::string& step, const fs::path& directory) {
    make_directories(directory);
    const fs::path source = directory / "mutant.cpp", tests = directory / "tests";
    write_file(source, text);
    const Fate fate = !commands.build(file, source, tests) ? Fate::NotCompiled
                      : !passes(tests, "[" + step + "]")   ? Fate::Caught
                      : !passes(tests, "~[" + step + "]")  ? Fate::CaughtLater
                                                           : Fate::Survived;
    fs::remove_all(directory);
    return fate;
}

/// So many of them, evenly spread.
void keep_sample(std::vector<TriedMutant>& mutants, int sample) {
    const auto wanted = static_cast<std::size_t>(std::max(sample, 0));
    if (wanted == 0 || wanted >= mutants.size()) return;
    std::vector<TriedMutant> kept;
    for (std::size_t k = 0; k < wanted; ++k) kept.push_back(mutants[k * mutants.size() / wanted]);
    mutants = std::move(kept);
}

/// The mutants to try, with the reasons of those that are listed as equivalent.
Mutation mutants_to_try(const Project& project, const Chapter& chapter,
                        const std::vector<std::string>& steps) {
    const auto wanted = [&](const auto& of_step) {
        return steps.empty() || std::find(steps.begin(), steps.end(), of_step.step) != steps.end();
    };
    std::vector<EquivalentMutant> listed = equivalent_mutants(project, chapter);
    std::erase_if(listed, [&](const EquivalentMutant& entry) { return !wanted(entry); });
    Mutation mutation{&chapter, {}, {}};
    std::vector<Mutant> all;
    for (const auto& [file, text] : solution_files(project, chapter))
        for (const Mutant& mutant : mutants_of(text, "solutions/" + chapter.name + "/" + file)) {
            if (!wanted(mutant)) continue;
            const auto entry =
                std::find_if(listed.begin(), listed.end(),
                             [&mutant](const EquivalentMutant& known) { return is_about(known, mutant); });
            mutation.tried.push_back({mutant, file, entry == listed.end() ? "" : entry->why});
            all.push_back(mutant);
        }
    mutation.stale = stale_entries(listed, all, equivalent_list(chapter));
    return mutation;
}

}  // namespace

int Mutation::count(Fate fate) const {
    return static_cast<int>(std::count_if(tried.begin(), tried.end(), [&](const TriedMutant& one) {
        return one.equivalent.empty() && one.fate == fate;
    }));
}

int Mutation::equivalent() const {
    return static_cast<int>(std::count_if(tried.begin(), tried.end(),
                                          [](const TriedMutant& one) { return !one.equivalent.empty(); }));
}

double Mutation::score() const {
    const int caught = count(Fate::Caught) + count(Fate::CaughtLater), all = caught + count(Fate::Survived);
    return all == 0 ? 1 : static_cast<double>(caught) / all;
}

std::vector<const TriedMutant*> Mutation::survivors() const {
    std::vector<const TriedMutant*> found;
    for (const TriedMutant& one : tried)
        if (one.equivalent.empty() && one.fate == Fate::Survived) found.push_back(&one);
    return found;
}

Mutation try_mutants(const Project& project, const Chapter& chapter, const std::vector<std::string>& steps,
                     int sample, const std::function<void(const TriedMutant&)>& survived) {
    Mutation mutation = mutants_to_try(project, chapter, steps);
    keep_sample(mutation.tried, sample);

    const std::string target = test_program_of(chapter), label = "Mutants of chapter " + chapter.number;
    const BuildResult build = build_targets(project, {target}, "Building chapter " + chapter.number);
    if (!build.ok) throw std::runtime_error(build.message);
    const Lock lock(build_lock(project), label);
    const Commands commands(project, chapter);
    const std::map<std::string, std::string> texts = solution_files(project, chapter);
    const auto fate = [&](const TriedMutant& one, const std::string& text, std::size_t number) {
        return fate_of(commands, one.file, text, one.mutant.step,
                       own_directory(project) / fmt::format("mutant_{}", number));
    };
    // If the solution did not come through as mutants do, all would seem to be caught.
    if (!mutation.tried.empty()) {
        const TriedMutant& first = mutation.tried.front();
        if (fate(first, texts.at(first.file), 0) != Fate::Survived)
            throw std::runtime_error("the solution does not pass its tests: ./course check " +
                                     chapter.number + " --solutions");
    }
    Progress progress(label);
    std::atomic<int> done = 0;
    std::mutex telling;
    side_by_side(mutation.tried.size(), [&](std::size_t i) {
        TriedMutant& one = mutation.tried[i];
        one.fate = fate(one, mutated(texts.at(one.file), one.mutant), i);
        progress.update(++done / static_cast<double>(mutation.tried.size()));
        if (one.fate != Fate::Survived || !one.equivalent.empty()) return;
        const std::lock_guard guard(telling);
        progress.clear();
        survived(one);
    });
    for (const TriedMutant& one : mutation.tried)
        if (!one.equivalent.empty() && (one.fate == Fate::Caught || one.fate == Fate::CaughtLater))
            mutation.stale.push_back(fmt::format("{}: a test of step {} notices '{}' of '{}'",
                                                 equivalent_list(chapter), one.mutant.step, one.mutant.to,
                                                 one.mutant.from));
    return mutation;
}

}  // namespace rt
