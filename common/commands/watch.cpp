// `course check --watch`: one step at a time, checked again whenever a file is saved.
#include "common/commands/commands.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/raw_terminal.hpp"
#include "common/workbook/next_step.hpp"
#include "common/workbook/result_text.hpp"

#include <fmt/format.h>

#include <sys/stat.h>
#include <sys/wait.h>

#include <cstdlib>
#include <map>
#include <utility>

namespace rt {

namespace fs = std::filesystem;

namespace {

// Asking for the times of some hundred files costs nothing, and unlike the kernel's messages works on every
// file system.
constexpr int milliseconds_between_looks = 250;

/// What changes when a file is saved, of each file of the exercises and of what they include.
using Stamps = std::map<fs::path, std::tuple<ino_t, off_t, time_t, long>>;

Stamps stamps(const Project& project, const std::vector<Chapter>& chapters) {
    Stamps stamps;
    for (const Chapter& chapter : chapters)
        for (const fs::path& file : files_in(project.root / "chapters" / chapter.name, {".cpp", ".hpp"})) {
            struct stat status {};
            if (stat(file.c_str(), &status) == 0)
                stamps[file] = {status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
        }
    return stamps;
}

/// One person at work.
struct Watch {
    Project project;
    std::vector<Chapter> chapters;
    std::optional<Target> now;  ///< chapter and step; none when all has passed
    RawTerminal terminal{};
    Stamps seen{};  ///< as they were when what is shown was checked
    char key = 0;   ///< pressed while something ran; 0 if there is none
    bool done = false;
    int signal = 0;  ///< that is to end it; 0 for a key
};

void clear_screen() {
    if (const char* kind = std::getenv("TERM"); kind && std::string_view(kind) != "dumb")
        fmt::print("\033[2J\033[3J\033[H");
    else
        fmt::print("\n----------------------------------------\n");
}

/// What a signal, or the end of the terminal, means. A child's group gets those that were meant for both.
void attend(Watch& watch, const RawTerminal::Event& event, pid_t child) {
    using Kind = RawTerminal::Event::Kind;
    const bool quits =
        event.kind == Kind::Closed || (event.kind == Kind::Key && (event.key == 'q' || event.key == '\4'));
    const bool ends = event.kind == Kind::Signal && event.signal != SIGTSTP && event.signal != SIGCHLD;
    if (quits || ends) {
        watch.done = true;
        watch.signal = ends ? event.signal : 0;
        if (child > 0) kill(-child, SIGTERM);
    }
    if (event.kind == Kind::Key) watch.key = event.key;
    if (event.kind != Kind::Signal || event.signal != SIGTSTP) return;
    if (child > 0) kill(-child, SIGSTOP);
    watch.terminal.obey(SIGTSTP);
    if (child > 0) kill(-child, SIGCONT);
    watch.seen.clear();  // what is on the screen by now is others'
}

/// Runs a command of the course, shown as it is, to its end or until the person quits.
void run(Watch& watch, const std::vector<std::string>& arguments) {
    flush_output();
    std::vector<std::string> command{program(watch.project, "course").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const pid_t child = start_beside(command);
    for (int status = 0; waitpid(child, &status, WNOHANG) == 0;)
        attend(watch, watch.terminal.wait(milliseconds_between_looks), child);
}

void show_keys() {
    const auto key = [](const char* letter, const char* what) {
        return fmt::format("{} {}", paint(letter, Tone::Bold), paint(what, Tone::Dim));
    };
    fmt::print("\n{}   {}   {}   {}   {}\n", key("h", "hint"), key("p", "picture"), key("l", "list"),
               key("Enter", "check again"), key("q", "quit"));
    fmt::print("{}\n", paint("Save a file to check it.", Tone::Dim));
    flush_output();
}

/// The chapter's steps that have passed and had not before, a line each.
std::string good_news(const Chapter& chapter, const ChapterResult& before, const ChapterResult& after) {
    std::string lines;
    for (std::size_t i = 0; i < chapter.steps.size(); ++i)
        if (before.steps[i].state != State::Passed && after.steps[i].state == State::Passed)
            lines += step_line(chapter.steps[i], after.steps[i]) + "\n";
    return lines;
}

/// Checks the step, and goes on to the next one as long as what is checked has passed.
void check(Watch& watch) {
    std::string news;
    while (!watch.done && watch.now) {
        watch.seen = stamps(watch.project, watch.chapters);
        const Chapter& chapter = *watch.now->chapter;
        const Step& step = *watch.now->step;
        const ChapterResult before = known_result(watch.project, chapter).result;
        clear_screen();
        fmt::print("{}{}  {}\n\n", news, paint(fmt::format("Watching step {}", step.id), Tone::Bold),
                   paint(fmt::format("chapters/{}/{}", chapter.name, step.file), Tone::Dim));
        run(watch, {"check", step.id});
        if (watch.done) return;
        const std::vector<KnownResult> known = known_results(watch.project, watch.chapters);
        const std::optional<Target> next = next_step(watch.chapters, known, *watch.now);
        if (next && next->step == watch.now->step) break;
        news += good_news(chapter, before, known_result(watch.project, chapter).result);
        watch.now = next;
    }
    if (watch.done) return;
    if (watch.now) return show_keys();
    clear_screen();
    fmt::print("{}\n", news);
    run(watch, {});
    watch.done = true;
}

/// The steps of the chapter at hand, and the bars of all chapters.
void show_list(Watch& watch) {
    const Chapter& chapter = *watch.now->chapter;
    fmt::print("\n{}\n", paint(fmt::format("Chapter {}: {}", chapter.number, chapter.title), Tone::Bold));
    for (const StepResult& result : known_result(watch.project, chapter).result.steps)
        fmt::print("{}\n", step_line(step_of(chapter, result.id), result));
    fmt::print("\n");
    run(watch, {});
}

/// The chapter's picture, by the student's code as it is.
void show_picture(Watch& watch) {
    const Chapter& chapter = *watch.now->chapter;
    if (chapter.scenes.empty()) return fmt::print("\nChapter {} has no picture.\n", chapter.number);
    const fs::path scene = fs::path("references") / chapter.name / chapter.scenes.front();
    const fs::path picture =
        watch.project.build / "pictures" / chapter.name / scene.filename().replace_extension(".png");
    fs::create_directories(picture.parent_path());
    fmt::print("\nDrawing {} …\n", chapter.scenes.front());
    run(watch,
        {"render", (watch.project.root / scene).string(), "--mine", "--preview", "-o", picture.string()});
}

void obey_key(Watch& watch, char key) {
    switch (key) {
        case 'h':
            fmt::print("\n");
            run(watch, {"hint", watch.now->step->id});
            break;
        case 'p':
            show_picture(watch);
            break;
        case 'l':
            show_list(watch);
            break;
        case '\n':
        case '\r':
            return check(watch);
        default:
            return;
    }
    if (!watch.done) show_keys();
}

/// Where to begin: what was asked for, else where the student is.
Target first_target(const Project& project, const std::vector<Chapter>& chapters,
                    const std::vector<std::string>& asked) {
    if (asked.size() > 1) throw InputError("--watch looks at one chapter or step at a time");
    Target target = asked.empty() ? Target{&chapters.front(), nullptr} : find_target(chapters, asked.front());
    if (target.step) return target;
    // Of a chapter that was named and has passed, the first step: it may be about to change.
    const auto next = next_step(chapters, known_results(project, chapters), target);
    if (next && (asked.empty() || next->chapter == target.chapter)) return *next;
    return {target.chapter, &target.chapter->steps.front()};
}

}  // namespace

int run_watch(const CheckCommand& command) {
    if (!is_interactive()) throw InputError("--watch needs a terminal to show things and to take keys");
    const Project project = this_project();
    std::vector<Chapter> chapters = read_catalogue(project);
    if (chapters.empty()) throw InputError("there are no chapters to check");
    int signal = 0;
    {
        Watch watch{.project = project, .chapters = std::move(chapters), .now = std::nullopt};
        watch.now = first_target(project, watch.chapters, command.targets);
        check(watch);
        while (!watch.done) {
            if (watch.key == 0) attend(watch, watch.terminal.wait(milliseconds_between_looks), 0);
            const char key = std::exchange(watch.key, 0);
            if (watch.done) break;
            if (key != 0)
                obey_key(watch, key);
            else if (stamps(watch.project, watch.chapters) != watch.seen)
                check(watch);
        }
        signal = watch.signal;
    }
    fmt::print("\n");
    flush_output();
    if (signal != 0) raise(signal);
    return 0;
}

}  // namespace rt
