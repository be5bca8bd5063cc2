// What a person sees in the terminal: colour where it is wanted, and how far long work has come.
#include "common/terminal/console.hpp"

#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace rt {

namespace {

constexpr double seconds_before_progress = 1;
constexpr double seconds_between_updates = 0.1;

}  // namespace

bool has_color(std::FILE* stream) {
    const char* no_color = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    return isatty(fileno(stream)) && !(no_color && *no_color) &&
           !(terminal && std::string_view(terminal) == "dumb");
}

std::string paint(std::string_view text, Tone tone, std::FILE* stream) {
    if (tone == Tone::Plain || !has_color(stream)) return std::string(text);
    constexpr std::string_view codes[] = {"0", "1", "2", "32", "31", "36"};
    return fmt::format("\033[{}m{}\033[0m", codes[static_cast<std::size_t>(tone)], text);
}

void say(std::string_view text) {
    const std::string line = printable(text) + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
}

void say_lines(std::string_view text) {
    const std::string lines = printable(text, Keep::Lines) + "\n";
    std::fwrite(lines.data(), 1, lines.size(), stderr);
}

void open_missing_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
            // It takes the lowest free number, which is this one; what fails on it fails with EBADF, as if
            // closed.
            if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
}

void flush_output() {
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category(), "standard output");
}

int ended(int status, int write_error) {
    if (std::fflush(stdout) != 0 && write_error == 0) write_error = errno;
    if (std::ferror(stdout)) {
        const std::string why = write_error == 0 ? "" : ": " + std::generic_category().message(write_error);
        say("standard output: cannot be written{}", why);
        return 2;
    }
    return std::ferror(stderr) ? 2 : status;
}

TerminalSize terminal_size(std::FILE* stream) {
    winsize size{};
    if (ioctl(fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
    return {size.ws_col, size.ws_row};
}

Progress::Progress(std::string what, bool enabled)
    : label(std::move(what)), visible(enabled && isatty(STDERR_FILENO)) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    const std::lock_guard lock(mutex);
    if (drawn) std::fputs("\r\033[K", stderr);
    drawn = false;
}

void Progress::update(double fraction) { update(fraction, {}); }

void Progress::update(double fraction, std::string_view what) {
    if (!visible) return;
    const std::lock_guard lock(mutex);
    if (!what.empty()) label = what;
    const double so_far = since_start.seconds();
    if (so_far < seconds_before_progress || since_update.seconds() < seconds_between_updates) return;
    since_update = {};
    drawn = true;
    const std::string line = fmt::format(
        "\r{}\033[K", progress_line(printable(label), fraction, so_far, terminal_size(stderr).columns));
    std::fwrite(line.data(), 1, line.size(), stderr);
}

std::string progress_line(std::string_view label, double fraction, double seconds_so_far, int columns) {
    fraction = std::clamp(fraction, 0.0, 1.0);
    const std::string left =
        fraction > 0.01 ? duration(seconds_so_far * (1 - fraction) / fraction) + " left" : "";
    const int width = std::clamp(columns - static_cast<int>(label.size()) - 24, 0, 30);
    const int filled = static_cast<int>(std::lround(fraction * width));
    std::string bar;
    for (int i = 0; i < width; ++i) bar += i < filled ? "━" : "─";
    return fmt::format("{} {} {:3.0f} %  {}", label, bar, std::floor(100 * fraction), left);
}

std::string duration(double seconds) {
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace rt
