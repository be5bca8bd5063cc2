// Boxes for tests: in every way that this machine can do, and what they may not leave behind.
#include "tests/grading/sandbox/boxes.hpp"

#include "common/image/descriptor.hpp"
#include "common/math/input_error.hpp"
#include "common/sandbox/message.hpp"
#include "common/terminal/project.hpp"
#include "tests/support.hpp"

#include <fcntl.h>
#include <grp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace rt::test {

namespace fs = std::filesystem;

namespace {

constexpr uid_t plain_uid = 60'599;  // nobody's on Debian

std::string attack_directory() { return (this_project().build / "bin" / "attacks").string(); }

std::vector<Way> find_ways() {
    const bool root = geteuid() == 0;
    std::vector<Way> all{{"bwrap", Isolation::Bubblewrap, root},
                         {"user", Isolation::User, root},
                         {"user, without mounts", Isolation::User, root, false},
                         {"none", Isolation::None, root}};
    if (root) {
        all.push_back({"bwrap for a user", Isolation::Bubblewrap, false});
        all.push_back({"none for a user", Isolation::None, false});
    }
    std::erase_if(all, [](const Way& way) {
        try {
            return run_attack(way, "worker").end != End::Exited;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "skipped: boxes of level %s: %s\n", way.name.c_str(), error.what());
            return true;
        }
    });
    return all;
}

/// Of a file in /proc; empty if its process has ended.
std::string content(const fs::path& path) {
    std::string text;
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    char buffer[4096];
    for (ssize_t count; file.number >= 0 && (count = read(file.number, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(count));
    return text;
}

/// As common/box/identity.cpp chooses them.
bool is_of_box(uid_t uid) {
    return uid == plain_uid || (uid >= 60'600 && uid < 61'100) ||
           (uid >= 2'000'000'000 && uid < 2'000'001'000);
}

/// What everybody may write to, as far as attacks and boxes would.
void add_shared_files(std::vector<std::string>& state) {
    for (const char* directory : {"/tmp", "/var/tmp", "/dev/shm", "/"})
        for (const auto& entry : fs::directory_iterator(directory)) {
            const std::string name = entry.path().filename().string();
            struct stat status {};
            const bool ours = lstat(entry.path().c_str(), &status) == 0 && is_of_box(status.st_uid);
            if (ours || name.starts_with("box-") || name == "sandbox_attack")
                state.push_back(entry.path().string());
        }
}

}  // namespace

const std::vector<Way>& ways() {
    static const std::vector<Way> all = find_ways();
    return all;
}

Limits small_limits() {
    Limits limits;
    limits.process_memory = std::uint64_t{64} << 20;
    limits.memory = std::uint64_t{80} << 20;
    limits.stack = std::uint64_t{1} << 20;
    limits.processes = 12;
    limits.file_size = std::uint64_t{1} << 20;
    limits.disk = std::uint64_t{8} << 20;
    limits.files = 100;
    limits.output = std::uint64_t{64} << 10;
    return limits;
}

Sandbox attack_box(const Way& way) {
    Sandbox box;
    box.isolation = way.isolation;
    box.limits = small_limits();
    box.may_mount = way.may_mount;
    box.mounts = {{attack_directory(), "/attacks"}};
    return box;
}

std::vector<std::string> attack(const Sandbox& box, const std::string& name,
                                const std::vector<std::string>& arguments) {
    std::vector<std::string> command{seen_from(box, fs::path(attack_directory()) / ("box_" + name))};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return command;
}

bool become(const Way& way) {
    if (way.root || geteuid() != 0) return true;
    return setgroups(0, nullptr) == 0 && setresgid(plain_uid, plain_uid, plain_uid) == 0 &&
           setresuid(plain_uid, plain_uid, plain_uid) == 0;
}

Ending as(const Way& way, const std::function<Ending()>& action) {
    if (way.root || geteuid() != 0) return action();
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::system_error(errno, std::generic_category(), "socketpair");
    const pid_t child = fork();
    if (child == 0) {
        Reply reply;
        try {
            if (!become(way)) throw std::runtime_error("no other user could be had");
            reply.verdict = action();
        } catch (const std::exception& error) {
            reply.refusal = error.what();
        }
        send_message(ends[1], to_message(reply));
        _exit(0);
    }
    close(ends[1]);
    std::string message;
    const bool whole = receive_message(ends[0], message);
    close(ends[0]);
    waitpid(child, nullptr, 0);
    if (!whole) throw std::runtime_error("the user's process ended");
    const Reply reply = reply_from(message);
    if (!reply.refusal.empty()) throw InputError(reply.refusal);
    return reply.verdict;
}

Ending run(const Way& way, const Sandbox& box, const std::vector<std::string>& command) {
    return as(way, [&] { return run_in(box, command); });
}

Ending run_attack(const Way& way, const std::string& name, const std::vector<std::string>& arguments) {
    const Sandbox box = attack_box(way);
    return run(way, box, attack(box, name, arguments));
}

std::vector<std::string> attacks_running() {
    std::vector<std::string> running;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::string name = content(entry.path() / "comm");
        if (!name.starts_with("box_")) continue;
        name.pop_back();  // the line's end
        running.push_back(name + " (" + entry.path().filename().string() + ")");
    }
    return running;
}

std::vector<std::string> surroundings() {
    std::vector<std::string> state;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_directory() + "/boxes")) {
        struct stat status {};
        lstat(entry.path().c_str(), &status);
        state.push_back(entry.path().string() + " " + std::to_string(status.st_mode) + " " +
                        std::to_string(status.st_uid) + " " + std::to_string(status.st_size));
    }
    for (const char* file :
         {"/proc/self/mountinfo", "/proc/sysvipc/shm", "/proc/sysvipc/msg", "/proc/sysvipc/sem",
          "/proc/sys/kernel/core_pattern", "/proc/sys/kernel/hostname"})
        state.push_back(content(file));
    for (char** variable = environ; *variable; ++variable) state.emplace_back(*variable);
    state.push_back(fs::current_path().string());
    for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
        std::error_code ignored;
        state.push_back(entry.path().string() + " " + fs::read_symlink(entry.path(), ignored).string());
    }
    state.push_back(waitpid(-1, nullptr, WNOHANG) == -1 ? "no child" : "children");
    return state;
}

std::vector<std::string> machine() {
    std::vector<std::string> state = surroundings();
    add_shared_files(state);
    const std::vector<std::string> running = attacks_running();
    state.insert(state.end(), running.begin(), running.end());
    return state;
}

fs::path boxes_lock() { return this_project().build / "scratch" / "boxes.lock"; }

std::string fresh_directory(const std::string& name) {
    const fs::path all = fs::path(scratch_directory()) / "boxes", directory = name.empty() ? all : all / name;
    fs::remove_all(directory);
    fs::create_directories(directory);
    fs::permissions(directory, fs::perms(0755));
    return directory.string();
}

}  // namespace rt::test
