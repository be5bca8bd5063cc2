// The terminal that gives each key as it is pressed, and signals one by one.
#pragma once

#include <termios.h>

#include <csignal>
#include <string>
#include <vector>

namespace rt {

/// While it lives, keys come without Enter and are not shown, and signals that would end or stop this process
/// (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP) or tell of a child's end (SIGCHLD) wait to be asked for. What
/// was before is back when it ends. Standard input must be a terminal.
struct RawTerminal {
    RawTerminal();
    ~RawTerminal();
    RawTerminal(const RawTerminal&) = delete;
    RawTerminal& operator=(const RawTerminal&) = delete;

    /// What has happened.
    struct Event {
        enum class Kind { Nothing, Key, Signal, Closed } kind = Kind::Nothing;
        char key = 0;    ///< where it is a key: the first letter of what it sends
        int signal = 0;  ///< where it is a signal
    };

    /// The next event, or Nothing after so many milliseconds.
    Event wait(int milliseconds);

    /// Has the terminal as it was before, and lets a signal that was held do its work. Comes back from
    /// SIGTSTP, once the process goes on.
    void obey(int signal);

private:
    void hold(bool held);

    termios before{};
    sigset_t signals{}, blocked_before{};
    int signal_descriptor = -1;
};

/// Whether somebody sits at it: standard input and output are a terminal.
bool is_interactive();

/// Starts a program in a group of processes of its own, with this program's output and without input; it may
/// be watched by RawTerminal's SIGCHLD. Returns its process, which leads the group. Throws std::runtime_error
/// if it cannot be started.
pid_t start_beside(const std::vector<std::string>& command);

}  // namespace rt
