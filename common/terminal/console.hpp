// What a person sees in the terminal: colour where it is wanted, and how far long work has come.
#pragma once

#include "common/math/counted.hpp"
#include "common/math/stopwatch.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

namespace rt {

enum class Tone { Plain, Bold, Dim, Good, Bad, Accent };

/// Whether the stream is a terminal and NO_COLOR (no-color.org) is not set.
bool has_color(std::FILE* stream);

/// The text in a colour, if the stream has any.
std::string paint(std::string_view text, Tone tone, std::FILE* stream = stdout);

/// One line on standard error, with whatever does not fit into a line of a terminal escaped. Never throws:
/// whether it was written, `ended` tells.
void say(std::string_view text);
template <class... Args>
requires(sizeof...(Args) > 0) void say(fmt::format_string<Args...> format, Args&&... args) {
    say(std::string_view(fmt::format(format, std::forward<Args>(args)...)));
}

/// Another program's words, or some lines, in the same way.
void say_lines(std::string_view text);

/// Standard streams that the program was started without are opened so that what is said there fails as it
/// should, and no picture gets their number. To be called before anything is opened.
void open_missing_streams();

/// Sends what was printed on its way, before somebody else writes. Throws std::system_error where it cannot
/// be written.
void flush_output();

/// The program's exit status at its end: `status`, or 2 if something that was said could not be written; then
/// a line says so, with the reason if it is known already.
int ended(int status, int write_error = 0);

/// Columns and rows of the terminal that the stream is; 80 × 24 if it is none.
struct TerminalSize {
    int columns = 80;
    int rows = 24;
};
TerminalSize terminal_size(std::FILE* stream);

/// A line on standard error that shows how much of some work is done and how long the rest will take. It
/// appears after a second, only on a terminal, and leaves nothing behind. Safe to call from any thread.
struct Progress {
    explicit Progress(std::string what, bool enabled = true);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `fraction` in [0, 1] of the work is done.
    void update(double fraction);
    /// As `update`, with another text in front.
    void update(double fraction, std::string_view what);
    /// Takes the line away; a later update may bring it back.
    void clear();

private:
    std::mutex mutex;
    std::string label;
    bool visible = false;
    bool drawn = false;
    Stopwatch since_start, since_update;
};

/// The line that Progress draws: label, bar, per cent, and the time that is left.
std::string progress_line(std::string_view label, double fraction, double seconds_so_far, int columns);

/// A time as a person says it: "0.4 s", "12 s", "3 min 5 s".
std::string duration(double seconds);

}  // namespace rt
