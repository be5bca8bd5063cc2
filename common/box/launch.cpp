// Starting a program in its box: everything that a child gives up before it becomes the program.
#include "common/box/launch.hpp"

#include "common/box/file_access.hpp"
#include "common/box/system_calls.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace rt {

namespace {

/// Tells the supervisor, and ends.
[[noreturn]] void fail(const Launch& launch, const std::string& what) {
    const std::string text = what + ": " + std::strerror(errno);
    if (write(launch.failure.writer(), text.data(), text.size()) < 0) _exit(126);
    _exit(127);
}

bool set_limit(int resource, std::uint64_t soft, std::uint64_t hard) {
    const rlimit both{soft, hard};
    return setrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &both) == 0;
}

/// Limits that the kernel holds by itself, of each process.
bool set_limits(const Sandbox& box, bool own_uid) {
    const Limits& limits = box.limits;
    // Behind the supervisor's limit, which looks at all processes and at parts of a second.
    const auto seconds = static_cast<std::uint64_t>(std::ceil(limits.cpu_seconds)) + 1;
    const std::uint64_t of_bubblewrap = box.isolation == Isolation::Bubblewrap ? 2 : 0;
    bool good = set_limit(RLIMIT_CPU, seconds, seconds + 1);
    const auto set = [&](int resource, std::uint64_t value) {
        good = good && set_limit(resource, value, value);
    };
    set(RLIMIT_AS, limits.process_memory);
    set(RLIMIT_STACK, limits.stack);
    // Processes are counted by uid, and from zero in a user namespace.
    if (own_uid || of_bubblewrap > 0) set(RLIMIT_NPROC, limits.processes + of_bubblewrap);
    set(RLIMIT_FSIZE, limits.file_size);
    set(RLIMIT_NOFILE, limits.open_files);
    for (const auto resource : {RLIMIT_CORE, RLIMIT_MEMLOCK, RLIMIT_MSGQUEUE, RLIMIT_RTPRIO, RLIMIT_NICE})
        set(resource, 0);
    return good;
}

std::vector<std::string> environment_of(const Sandbox& box, const std::string& scratch) {
    std::vector<std::string> texts{"PATH=/usr/bin", "HOME=" + scratch, "TMPDIR=" + scratch};
    for (const auto& [name, value] : box.environment) texts.push_back(name + "=" + value);
    return texts;
}

/// As exec takes them; the texts must live as long.
std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (std::string& text : texts) list.push_back(text.data());
    list.push_back(nullptr);
    return list;
}

/// What bubblewrap is to build. The texts do not stand in its command line, which the program could read.
std::vector<std::string> bubblewrap_options(const Launch& launch, int filter) {
    std::vector<std::string> options{"--unshare-all",
                                     "--unshare-user",
                                     "--disable-userns",
                                     "--die-with-parent",
                                     "--new-session",
                                     "--hostname",
                                     "box"};
    const auto add = [&](auto... words) { (options.emplace_back(words), ...); };
    for (const Mount& mount : launch.stage.mounts()) add("--ro-bind", mount.host, mount.inside);
    for (const char* link : {"/bin", "/lib", "/lib64", "/sbin"})
        if (std::filesystem::is_symlink(link))
            add("--symlink", std::filesystem::read_symlink(link).string(), link);
    // Nothing but the scratch directory is writable; without the word, / and /dev would be, up to half of the
    // memory. There is no /proc, because it tells where on this machine the mounts come from.
    add("--dev", "/dev", "--remount-ro", "/dev", "--bind", launch.stage.scratch(), "/tmp", "--remount-ro",
        "/");
    add("--chdir", "/tmp", "--seccomp", std::to_string(filter));
    add("--json-status-fd", std::to_string(launch.status.writer()));
    return options;
}

/// A file without a name that holds the texts, each closed by a zero byte; negative if it could not be made.
int file_of(const std::vector<std::string>& texts) {
    const int file = memfd_create("options", MFD_CLOEXEC);
    bool good = file >= 0;
    for (const std::string& text : texts)
        good = good && write(file, text.c_str(), text.size() + 1) == static_cast<ssize_t>(text.size() + 1);
    return good && lseek(file, 0, SEEK_SET) == 0 ? file : -1;
}

void keep(int descriptor) { fcntl(descriptor, F_SETFD, 0); }

[[noreturn]] void become_bubblewrap(const Launch& launch) {
    const int filter = system_call_filter();
    if (filter < 0) fail(launch, "no filter of system calls");
    const int options = file_of(bubblewrap_options(launch, filter));
    if (options < 0) fail(launch, "no options for bubblewrap");
    for (const int descriptor : {filter, options, launch.status.writer()}) keep(descriptor);
    std::vector<std::string> arguments{"bwrap", "--args", std::to_string(options), "--"};
    arguments.insert(arguments.end(), launch.request.command.begin(), launch.request.command.end());
    std::vector<std::string> variables = environment_of(launch.request.box, "/tmp");
    execve("/usr/bin/bwrap", pointers(arguments).data(), pointers(variables).data());
    fail(launch, "bubblewrap (/usr/bin/bwrap)");
}

[[noreturn]] void become_program(const Launch& launch) {
    const Sandbox& box = launch.request.box;
    if (chdir(launch.stage.scratch().c_str()) != 0) fail(launch, launch.stage.scratch());
    if (box.isolation == Isolation::User) {
        if (!restrict_files(launch.stage.mounts(), launch.stage.scratch()))
            fail(launch, "no limits by Landlock");
        if (!refuse_system_calls()) fail(launch, "no filter of system calls");
    }
    std::vector<std::string> arguments = launch.request.command;
    std::vector<std::string> variables = environment_of(box, launch.stage.scratch());
    execvpe(arguments.front().c_str(), pointers(arguments).data(), pointers(variables).data());
    fail(launch, arguments.front());
}

/// The child's side.
[[noreturn]] void become(const Launch& launch, pid_t supervisor) {
    const Sandbox& box = launch.request.box;
    setsid();
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (dup2(nothing, STDIN_FILENO) < 0 || dup2(launch.output.writer(), STDOUT_FILENO) < 0 ||
        dup2(launch.errors.writer(), STDERR_FILENO) < 0)
        fail(launch, "standard streams");
    // Whatever else this process has open, the program shall not find it.
    const auto kept = static_cast<unsigned>(STDERR_FILENO + 1 + launch.request.descriptors);
    if (close_range(kept, ~0U, CLOSE_RANGE_CLOEXEC) != 0) fail(launch, "descriptors");
    // If this machine runs out of memory all the same, the box goes first.
    if (const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
        score < 0 || write(score, "1000", 4) < 0)
        errno = 0;
    if (!set_limits(box, launch.identity.own())) fail(launch, "limits");
    if (!launch.identity.assume()) fail(launch, "a uid without privileges");
    // After the change of uid, which forgets it. The supervisor has one thread, so it is its end that counts.
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    if (getppid() != supervisor) _exit(127);
    for (std::size_t i = 0; i < box.mounts.size(); ++i)
        if (access(launch.stage.mounts()[i].host.c_str(), R_OK) != 0)
            fail(launch, box.mounts[i].host + " cannot be read by the box");
    if (box.isolation == Isolation::Bubblewrap) become_bubblewrap(launch);
    become_program(launch);
}

}  // namespace

pid_t launch(const Launch& launch) {
    const pid_t supervisor = getpid();
    const pid_t child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "no process for a box");
    if (child == 0) become(launch, supervisor);
    return child;
}

}  // namespace rt
