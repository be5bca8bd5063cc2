// Several of this program at once: who has to wait for whom, and what each one has to itself.
#include "common/terminal/lock.hpp"

#include "common/terminal/console.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr const char* inherited_lock = "COURSE_LOCK";

/// Whether the lock was taken or cannot be; false while another process has it.
bool try_to_lock(int descriptor, int how) {
    int result = 0;
    while ((result = flock(descriptor, how)) != 0 && errno == EINTR) continue;
    return result == 0 || errno != EWOULDBLOCK;
}

/// What the one who has the lock wrote into it: "1234: Building chapter 02".
std::string holder(int descriptor) {
    char text[200];
    const ssize_t size = pread(descriptor, text, sizeof text, 0);
    std::string line(text, size > 0 ? static_cast<std::size_t>(size) : 0);
    line = line.substr(0, line.find('\n'));
    const auto colon = line.find(": ");
    if (colon == std::string::npos) return "another ./course";
    return fmt::format("another ./course (process {}, {})", line.substr(0, colon), line.substr(colon + 2));
}

/// The directories of this process, a build directory each.
struct OwnDirectories {
    struct One {
        fs::path path;
        int alive = -1;  ///< descriptor of a file that is locked as long as this process lives
    };
    std::map<fs::path, One> of_build;

    ~OwnDirectories() {
        std::error_code ignored;
        for (const auto& [build, own] : of_build) fs::remove_all(own.path, ignored);
    }
};

OwnDirectories& own_directories() {
    static OwnDirectories directories;
    return directories;
}

fs::path alive_file(const fs::path& directory) { return directory / "alive"; }

/// Removes the directories of processes that have ended without doing it.
void remove_abandoned_runs(const fs::path& runs) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(runs, ignored)) {
        const int file = open(alive_file(entry.path()).c_str(), O_RDWR | O_CLOEXEC);
        if (file < 0 || flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), ignored);
        if (file >= 0) close(file);
    }
}

}  // namespace

Lock::Lock(const fs::path& file, const std::string& doing) {
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    // Children inherit it: a build goes on for a moment when this process is killed.
    descriptor = open(file.c_str(), O_RDWR | O_CREAT, 0666);
    if (descriptor < 0) return;
    if (!try_to_lock(descriptor, LOCK_EX | LOCK_NB)) {
        say("Waiting for {} …", holder(descriptor));
        try_to_lock(descriptor, LOCK_EX);
    }
    const std::string line = fmt::format("{}: {}\n", getpid(), doing);
    // It is only a message to others.
    if (ftruncate(descriptor, 0) != 0 || pwrite(descriptor, line.data(), line.size(), 0) < 0) return;
}

Lock::~Lock() {
    if (descriptor >= 0) close(descriptor);
}

fs::path build_lock(const Project& project) { return project.root / ".course" / "build.lock"; }

fs::path memory_lock(const Project& project) { return project.root / ".course" / "memory.lock"; }

void close_inherited_lock() {
    const char* descriptor = std::getenv(inherited_lock);
    if (!descriptor) return;
    if (const int number = std::atoi(descriptor); number > STDERR_FILENO) close(number);
    unsetenv(inherited_lock);
}

fs::path own_directory(const Project& project) {
    auto& own = own_directories().of_build[project.build];
    if (!own.path.empty()) return own.path;
    const fs::path runs = project.build / "runs";
    fs::create_directories(runs);
    const Lock lock(runs.string() + ".lock", "looking for what killed processes left");
    remove_abandoned_runs(runs);
    std::string name = (runs / std::string(6, 'X')).string();  // mkdtemp puts a name that is free there
    if (!mkdtemp(name.data())) throw std::runtime_error(runs.string() + ": no directory can be made there");
    own.alive = open(alive_file(name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    try_to_lock(own.alive, LOCK_EX | LOCK_NB);
    return own.path = name;
}

void keep_program(const Project& project, const std::string& name) {
    const fs::path built = project.build / "bin" / name;
    if (!fs::is_regular_file(built)) return;  // a target that is no program
    const fs::path kept = own_directory(project) / name;
    std::error_code ignored;
    fs::remove(kept, ignored);
    // Linkers write a new file and leave the old one to whoever has it. Where files cannot have two names,
    // the program of the build is used.
    fs::create_hard_link(built, kept, ignored);
}

fs::path program(const Project& project, std::string_view name) {
    const auto& of_build = own_directories().of_build;
    std::error_code ignored;  // whoever has given up rights since cannot look there
    if (const auto own = of_build.find(project.build); own != of_build.end())
        if (fs::path kept = own->second.path / name; fs::exists(kept, ignored)) return kept;
    return project.build / "bin" / name;
}

}  // namespace rt
