// The processes of a box as /proc tells of them, and what they use together.
#include "common/box/members.hpp"

#include "common/image/descriptor.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace rt {

namespace {

struct Process {
    pid_t parent = 0;
    std::uint64_t memory = 0;
    double cpu_seconds = 0;
};

/// Fields of /proc/PID/stat (proc(5)); nothing if it has ended meanwhile.
std::optional<Process> read_process(pid_t pid) {
    const Descriptor file(open(("/proc/" + std::to_string(pid) + "/stat").c_str(), O_RDONLY | O_CLOEXEC));
    char text[1024];
    const ssize_t size = file.number < 0 ? -1 : read(file.number, text, sizeof text - 1);
    if (size <= 0) return std::nullopt;
    text[size] = 0;
    // The second field is the program's name in brackets, with whatever is in it.
    const char* rest = std::strrchr(text, ')');
    Process process;
    unsigned long user = 0, system = 0;
    long waited_user = 0, waited_system = 0, pages = 0;
    if (!rest || std::sscanf(rest + 1,
                             " %*c %d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu %ld %ld %*d %*d %*d %*d "
                             "%*u %*u %ld",
                             &process.parent, &user, &system, &waited_user, &waited_system, &pages) != 6)
        return std::nullopt;
    static const double ticks = static_cast<double>(sysconf(_SC_CLK_TCK));
    static const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    process.memory = static_cast<std::uint64_t>(pages) * page;
    process.cpu_seconds =
        (static_cast<double>(user + system) + static_cast<double>(waited_user + waited_system)) / ticks;
    return process;
}

}  // namespace

Members::Use Members::look() {
    const auto now = std::chrono::steady_clock::now();
    if (now > forget_others_) {  // their numbers may be given to ours by now
        others_.clear();
        forget_others_ = now + std::chrono::seconds(1);
    }
    std::map<pid_t, Process> candidates;
    const std::unique_ptr<DIR, int (*)(DIR*)> directory(opendir("/proc"), closedir);
    for (const dirent* entry = nullptr; directory && (entry = readdir(directory.get()));) {
        const pid_t pid = std::atoi(entry->d_name);
        if (pid <= 0 || others_.contains(pid)) continue;
        if (const auto process = read_process(pid)) candidates[pid] = *process;
    }
    Use use;
    std::set<pid_t> family{getpid()};
    candidates.erase(getpid());
    for (bool grown = true; grown;) {
        grown = false;
        for (auto candidate = candidates.begin(); candidate != candidates.end();) {
            const auto& [pid, process] = *candidate;
            if (!family.contains(process.parent)) {
                ++candidate;
                continue;
            }
            family.insert(pid);
            use.alive.push_back(pid);
            use.memory += process.memory;
            use.cpu_seconds += process.cpu_seconds;
            candidate = candidates.erase(candidate);
            grown = true;
        }
    }
    for (const auto& [pid, process] : candidates) others_.insert(pid);
    return use;
}

}  // namespace rt
