// The program: the command line understood, a command run, and one line for what is wrong.
#include "common/commands/command_line.hpp"
#include "common/math/input_error.hpp"
#include "common/math/todo.hpp"
#include "common/scene/suggest.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/given_files.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <system_error>

namespace rt {

namespace {

/// The chosen command, or the program itself.
const CLI::App& chosen(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
}

/// One line for a word of the command line that means nothing.
std::string unknown_word(const CLI::App& app, const std::string& word) {
    const CLI::App& sub = chosen(app);
    std::vector<std::string> names;
    if (&sub == &app && !word.starts_with("-")) {
        for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    } else {
        for (const CLI::Option* option : sub.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::string hint = did_you_mean(word, candidates);
    const std::string help = &sub == &app ? "./course --help" : "./course " + sub.get_name() + " --help";
    const std::string kind = word.starts_with("-") ? "option" : &sub == &app ? "command" : "argument";
    return fmt::format("there is no {} '{}'{} ({} shows what there is)", kind, word, hint, help);
}

/// A message of CLI11 as one line that says what to do.
int usage_error(const CLI::App& app, const CLI::ParseError& error) {
    std::string message = error.what();
    if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
        const std::vector<std::string> words = app.remaining(true);
        if (!words.empty()) {
            say(unknown_word(app, words.front()));
            return 2;
        }
    }
    const CLI::App& sub = chosen(app);
    const std::string help = &sub == &app ? "" : sub.get_name() + " ";
    message = message.substr(0, message.find('\n'));
    say("{} (./course {}--help shows how)", message, help);
    return 2;
}

/// One line that names the step and its chapter.
std::string not_started(const NotImplemented& error) {
    try {
        const std::vector<Chapter> chapters = read_catalogue(this_project());
        const Target target = find_step(chapters, error.step);
        return fmt::format("this needs step {} (chapter {}, {}: {}), which is not started; ./course check {}",
                           error.step, target.chapter->number, target.chapter->title, target.step->title,
                           target.chapter->number);
    } catch (const InputError&) {
        if (has_solutions(this_project())) return error.what();
        return fmt::format("this needs step {}, of a chapter that this handout does not have", error.step);
    }
}

/// --json is one option for all commands.
void hand_on_json(CommandLine& line) {
    line.check.json = line.render.json = line.compare.json = line.explain.json = line.trace.json =
        line.export_scene.json = line.tour.json = line.references.json = line.random.json = line.report.json =
            line.handout.json = line.similarity.json = line.autograder.json = line.mutate.json = line.json;
    if (line.json) line.grade.format = "json";
}

/// Names given files that a student has changed.
void tell_changed_given() {
    const std::string changed = given_in_words(given_changes(this_project()));
    if (!changed.empty()) say(changed);
}

/// Whether the script `course` has started this program, for a person. What this program starts is not told
/// so.
bool started_by_script() {
    const bool started = std::getenv("COURSE_SCRIPT") != nullptr;
    unsetenv("COURSE_SCRIPT");
    return started;
}

/// `write_error` becomes the reason why something could not be written to standard output, if that ended it.
int run_line(int argc, char** argv, bool by_script, int& write_error) {
    try {
        CommandLine line;
        describe_commands(line);
        line.render.arguments.assign(argv + 1, argv + argc);
        line.explain.arguments = line.trace.arguments = line.compare.arguments = line.render.arguments;
        try {
            line.app.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            fmt::print("{}", line.app.help());
            return 0;
        } catch (const CLI::ParseError& error) {
            return usage_error(line.app, error);
        }
        hand_on_json(line);
        if (by_script) tell_changed_given();
        return line.action();
    } catch (const NotImplemented& error) {
        say(not_started(error));
        return 1;
    } catch (const InputError& error) {
        say(error.what());
        return 2;
    } catch (const std::filesystem::filesystem_error& error) {
        say("{}: {}", error.path1().string(), error.code().message());
        return 2;
    } catch (const std::bad_alloc&) {
        say("there is not enough memory for this");
        return 2;
    } catch (const std::exception& error) {
        const auto* system = dynamic_cast<const std::system_error*>(&error);
        if (system && std::ferror(stdout))
            write_error = system->code().value();
        else
            say_lines(std::string("something went wrong that should not: ") + error.what());
        return 1;
    }
}

}  // namespace

int run_course(int argc, char** argv) {
    close_inherited_lock();
    const bool by_script = started_by_script();
    open_missing_streams();
    int write_error = 0;
    const int status = run_line(argc, argv, by_script, write_error);
    return ended(status, write_error);
}

}  // namespace rt
