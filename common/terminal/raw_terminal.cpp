// The terminal that gives each key as it is pressed, and signals one by one.
#include "common/terminal/raw_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <system_error>

namespace rt {
namespace {

constexpr std::array held_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGCHLD};

}  // namespace

RawTerminal::RawTerminal() {
    sigemptyset(&signals);
    for (const int signal : held_signals) sigaddset(&signals, signal);
    signal_descriptor = signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
    if (signal_descriptor < 0 || tcgetattr(STDIN_FILENO, &before) != 0)
        throw std::system_error(errno, std::generic_category(), "the terminal");
    hold(true);
}

RawTerminal::~RawTerminal() {
    hold(false);
    close(signal_descriptor);
}

void RawTerminal::hold(bool held) {
    if (held) {
        pthread_sigmask(SIG_BLOCK, &signals, &blocked_before);
        termios raw = before;
        raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        raw.c_cc[VMIN] = 1;
        raw.c_cc[VTIME] = 0;
        tcsetattr(STDIN_FILENO, TCSADRAIN, &raw);
    } else {
        tcsetattr(STDIN_FILENO, TCSADRAIN, &before);
        pthread_sigmask(SIG_SETMASK, &blocked_before, nullptr);
    }
}

RawTerminal::Event RawTerminal::wait(int milliseconds) {
    std::array<pollfd, 2> sources{pollfd{STDIN_FILENO, POLLIN, 0}, pollfd{signal_descriptor, POLLIN, 0}};
    // A signal that nobody holds, such as that of another size, ends the wait, too.
    if (poll(sources.data(), sources.size(), milliseconds) <= 0) return {};
    if (sources[1].revents != 0) {
        signalfd_siginfo information{};
        if (read(signal_descriptor, &information, sizeof information) == sizeof information)
            return {Event::Kind::Signal, 0, static_cast<int>(information.ssi_signo)};
    }
    if (sources[0].revents == 0) return {};
    // Arrows and the like send several characters, of which the first is no letter; they come in one piece.
    std::array<char, 64> keys{};
    const ssize_t count = read(STDIN_FILENO, keys.data(), keys.size());
    if (count <= 0) return {Event::Kind::Closed, 0, 0};
    return {Event::Kind::Key, keys[0], 0};
}

void RawTerminal::obey(int signal) {
    hold(false);
    raise(signal);
    hold(true);
}

bool is_interactive() { return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO); }

pid_t start_beside(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    // The terminal is another group's; where it would stop those that write to it all the same, it does not.
    const auto stops_before = std::signal(SIGTTOU, SIG_IGN);
    pid_t child = -1;
    const int error =
        posix_spawn(&child, arguments.front(), &actions, &attributes, arguments.data(), environ);
    std::signal(SIGTTOU, stops_before);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error(words.front() + " cannot be started");
    return child;
}

}  // namespace rt
