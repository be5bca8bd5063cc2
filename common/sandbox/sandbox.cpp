// A box as the grader sees it: its supervisor is started, told what to do, and asked how it ended.
#include "common/sandbox/sandbox.hpp"

#include "common/image/descriptor.hpp"
#include "common/math/input_error.hpp"
#include "common/sandbox/message.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace rt {

namespace {

[[noreturn]] void fail(const char* what, int error = errno) {
    throw std::system_error(error, std::generic_category(), what);
}

/// What posix_spawn is to do in the child.
struct Actions {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    Actions() {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        // Its own session: an interrupt at the keyboard reaches the grader, which then ends its boxes.
        posix_spawnattr_setflags(&attributes,
                                 POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes, &signals);
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&attributes, &signals);
    }
    Actions(const Actions&) = delete;
    Actions& operator=(const Actions&) = delete;
    ~Actions() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
};

/// Duplicates above all numbers that they are going to have in the child, so that none is overwritten before
/// its turn.
struct Duplicates {
    std::vector<int> numbers;

    Duplicates() = default;
    Duplicates(const Duplicates&) = delete;
    Duplicates& operator=(const Duplicates&) = delete;
    ~Duplicates() {
        for (const int number : numbers) close(number);
    }
    int add(int descriptor, int above) {
        const int number = fcntl(descriptor, F_DUPFD_CLOEXEC, above);
        if (number < 0) fail("a descriptor for a box");
        numbers.push_back(number);
        return number;
    }
};

/// The supervisor finds its control as standard input; nothing of this process but `descriptors` reaches it.
pid_t spawn(const std::string& program, int control, std::span<const int> descriptors) {
    Actions actions;
    Duplicates duplicates;
    const int first_free = STDERR_FILENO + 1 + static_cast<int>(descriptors.size());
    posix_spawn_file_actions_adddup2(&actions.files, duplicates.add(control, first_free), STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    for (int target = STDERR_FILENO + 1; const int descriptor : descriptors)
        posix_spawn_file_actions_adddup2(&actions.files, duplicates.add(descriptor, first_free), target++);
    posix_spawn_file_actions_addclosefrom_np(&actions.files, first_free);
    std::string name = "course-box";
    char* arguments[] = {name.data(), nullptr};
    char* environment[] = {nullptr};
    pid_t child = -1;
    const int error =
        posix_spawn(&child, program.c_str(), &actions.files, &actions.attributes, arguments, environment);
    if (error == ENOENT)
        throw InputError(program + ": there is none; it is built where libseccomp-dev is installed");
    if (error != 0) fail(program.c_str(), error);
    return child;
}

}  // namespace

std::string seen_from(const Sandbox& box, const std::filesystem::path& host) {
    const std::string path = host.lexically_normal().string();
    if (box.isolation != Isolation::Bubblewrap) return path;
    for (const Mount& mount : box.mounts) {
        if (path == mount.host) return mount.inside;
        if (path.starts_with(mount.host + "/")) return mount.inside + path.substr(mount.host.size());
    }
    throw std::logic_error(path + " is below no mount of the box");
}

Boxed start(const Sandbox& box, const std::vector<std::string>& command, std::span<const int> descriptors) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("a socket for a box");
    const Descriptor theirs(ends[1]);
    Descriptor ours(ends[0]);
    const std::string program = rt::program(this_project(), "course-box").string();
    const pid_t supervisor = spawn(program, theirs.number, descriptors);
    Boxed boxed(supervisor, std::exchange(ours.number, -1));
    send_message(boxed.descriptor(), to_message(Request{box, command, descriptors.size()}));
    return boxed;
}

Ending run_in(const Sandbox& box, const std::vector<std::string>& command, std::span<const int> descriptors) {
    return start(box, command, descriptors).wait();
}

Boxed::~Boxed() {
    // The supervisor sees its control close, ends the box and then itself.
    if (control_ >= 0) close(control_);
    while (supervisor_ > 0 && waitpid(supervisor_, nullptr, 0) == -1 && errno == EINTR) continue;
}

bool Boxed::ended() const {
    pollfd control{control_, POLLIN, 0};
    return poll(&control, 1, 0) > 0;
}

void Boxed::stop() { shutdown(control_, SHUT_WR); }

Ending Boxed::wait() {
    std::string message;
    if (!receive_message(control_, message))
        throw std::runtime_error("the supervisor of a box ended without a word");
    const Reply reply = reply_from(message);
    if (!reply.refusal.empty()) throw InputError(reply.refusal);
    return reply.verdict;
}

std::string in_words(const Ending& verdict, const Limits& limits) {
    const auto mebibytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); };
    switch (verdict.end) {
        case End::Exited:
            return fmt::format("ended with status {}", verdict.number);
        case End::Signal:
            if (verdict.number == SIGXFSZ)
                return fmt::format("wrote a file of more than {:.4g} MiB", mebibytes(limits.file_size));
            return fmt::format("crashed ({})", signal_name(verdict.number));
        case End::CpuTime:
            return fmt::format("took more than {:.4g} s of processor time", limits.cpu_seconds);
        case End::WallTime:
            return fmt::format("took longer than {:.4g} s", limits.wall_seconds);
        case End::Memory:
            return fmt::format("took more than {:.4g} MiB of memory", mebibytes(limits.memory));
        case End::Output:
            return fmt::format("wrote more than {:.4g} MiB of output", mebibytes(limits.output));
        case End::Stopped:
            return "was stopped";
    }
    throw std::logic_error("an end of a box without words");
}

}  // namespace rt
