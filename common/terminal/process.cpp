// Another program as a child of this one: its output, its end, and a limit on its time.
#include "common/terminal/process.hpp"

#include "common/math/stopwatch.hpp"
#include "common/terminal/core_time.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace rt {

namespace {

// The sanitizers reserve terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// The program's file, found as a shell would find it.
std::string found_program(const std::string& name) {
    if (name.find('/') != std::string::npos) return name;
    const char* path = std::getenv("PATH");
    std::string_view rest = path ? path : "/usr/local/bin:/usr/bin:/bin";
    for (bool more = true; more;) {
        const std::size_t end = rest.find(':');
        const std::string directory(end == 0 || rest.empty() ? std::string_view(".") : rest.substr(0, end));
        const std::string file = directory + "/" + name;
        std::error_code ignored;
        if (access(file.c_str(), X_OK) == 0 && !std::filesystem::is_directory(file, ignored)) return file;
        more = end != std::string_view::npos;
        if (more) rest.remove_prefix(end + 1);
    }
    return "";  // no program has this name, and starting it fails
}

/// What `execve` takes, made before a fork: between fork and exec nothing may be allocated, because another
/// thread may have held the allocator's lock when the process was copied.
struct Execution {
    std::string program;
    std::vector<std::string> texts;
    std::vector<char*> arguments, environment;

    Execution(const std::vector<std::string>& command,
              const std::vector<std::pair<std::string, std::string>>& added)
        : program(found_program(command.front())), texts(command) {
        const std::size_t count = texts.size();
        for (char** variable = environ; *variable; ++variable) {
            const std::string_view text = *variable;
            const std::string_view name = text.substr(0, text.find('='));
            const bool replaced =
                std::any_of(added.begin(), added.end(), [&](const auto& pair) { return pair.first == name; });
            if (!replaced) texts.emplace_back(text);
        }
        for (const auto& [name, value] : added) texts.push_back(name + "=" + value);
        for (std::size_t i = 0; i < texts.size(); ++i)
            (i < count ? arguments : environment).push_back(texts[i].data());
        arguments.push_back(nullptr);
        environment.push_back(nullptr);
    }
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

    void start() const { execve(program.c_str(), arguments.data(), environment.data()); }
};

void limit(int resource, rlim_t value) {
    // Core dumps and limits are conveniences: without them the child still runs.
    const rlimit limits{value, value};
    setrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &limits);
}

void limit_resources(double seconds) {
    limit(RLIMIT_CORE, 0);
    // Holds also if this program is killed while the child hangs.
    limit(RLIMIT_CPU, static_cast<rlim_t>(seconds) + 2);
    if (!sanitized) limit(RLIMIT_AS, rlim_t{4} << 30);
}

/// Whether a process that began when the watch did has had so many seconds; those that others took do not
/// count.
bool has_had(double seconds, pid_t process, const Stopwatch& watch) {
    const double passed = watch.seconds();
    return seconds > 0 && passed > seconds && passed - core_time(process).waiting > seconds;
}

/// Cuts the output into lines as it comes.
struct Lines {
    const std::function<void(std::string_view)>& on_line;
    std::string rest;

    void add(std::string_view text) {
        if (!on_line) return;
        for (const char c : text) {
            if (c != '\n') {
                rest += c;
            } else {
                on_line(rest);
                rest.clear();
            }
        }
    }
};

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
    const Execution execution(command, options.environment);
    int pipe_ends[2];
    if (pipe2(pipe_ends, O_CLOEXEC) != 0)
        throw std::runtime_error("no pipe to another program could be opened");
    const Stopwatch stopwatch;
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no other program could be started");
    if (child == 0) {
        dup2(pipe_ends[1], STDOUT_FILENO);
        if (options.merge_errors) dup2(pipe_ends[1], STDERR_FILENO);
        const int nothing = open("/dev/null", O_RDONLY);
        dup2(nothing, STDIN_FILENO);
        close(pipe_ends[0]);
        close(pipe_ends[1]);
        if (options.time_limit > 0) limit_resources(options.time_limit);
        execution.start();
        _exit(127);
    }
    close(pipe_ends[1]);
    fcntl(pipe_ends[0], F_SETFL, O_NONBLOCK);

    ProcessResult result;
    Lines lines{options.on_line, {}};
    int status = 0;
    bool open = true, ended = false, killed = false;
    Stopwatch since_last_words;
    while (!ended && !killed) {
        // A child that has closed its output may still run.
        pollfd descriptor{open ? pipe_ends[0] : -1, POLLIN, 0};
        poll(&descriptor, 1, open ? 20 : 1);
        // Its end is asked for before the last output is read, so that nothing said before is lost; a
        // grandchild may hold the pipe open for longer.
        ended = waitpid(child, &status, WNOHANG) == child;
        char buffer[65536];
        for (ssize_t count; open && (count = read(pipe_ends[0], buffer, sizeof buffer)) != -1;) {
            open = count != 0;
            const std::string_view text(buffer, static_cast<std::size_t>(count));
            result.output += text.substr(0, options.output_limit - result.output.size());
            lines.add(text);
            if (has_had(options.time_limit, child, stopwatch)) break;
        }
        if (options.while_waiting) options.while_waiting();
        if (ended) break;
        if (!result.timed_out && has_had(options.time_limit, child, stopwatch)) {
            result.timed_out = true;
            since_last_words = {};
            if (options.last_words != 0) kill(child, options.last_words);
        }
        killed = result.timed_out && (options.last_words == 0 || since_last_words.seconds() > 1);
        if (killed) kill(child, SIGKILL);
    }
    close(pipe_ends[0]);
    while (!ended && waitpid(child, &status, 0) == -1 && errno == EINTR) continue;
    if (!lines.rest.empty()) options.on_line(lines.rest);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.seconds = stopwatch.seconds();
    return result;
}

void replace_process(const std::vector<std::string>& command,
                     const std::vector<std::pair<std::string, std::string>>& environment) {
    const Execution execution(command, environment);
    std::fflush(stdout);
    execution.start();
}

std::string signal_name(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "segmentation fault";
        case SIGFPE:
            return "arithmetic error";
        case SIGABRT:
            return "abort";
        case SIGILL:
            return "illegal instruction";
        case SIGBUS:
            return "bus error";
        case SIGKILL:
            return "killed";
        case SIGXCPU:
            return "too much time";
        default:
            return "signal " + std::to_string(signal);
    }
}

}  // namespace rt
