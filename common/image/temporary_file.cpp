// Their names are known to the handler of the signals that end the program.
#include "common/image/temporary_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace rt {

namespace fs = std::filesystem;

struct AnnouncedFile {
    enum State { Free, Taken, There };
    std::atomic<int> state = Free;
    std::array<char, PATH_MAX> name;
};

namespace {

std::array<AnnouncedFile, 64> announced_files;  // of more at one time the others are left to the next program
std::atomic<pid_t> owner = 0;  // a child between fork and exec has the handler, but not the files

extern "C" void remove_temporaries(int signal) {
    if (::getpid() == owner)
        for (AnnouncedFile& file : announced_files)
            if (file.state == AnnouncedFile::There) ::unlink(file.name.data());
    ::raise(signal);  // the handler was for once; now the signal ends the program, as it should
}

extern "C" void go_on(int) {}

/// Sets the handler of a signal that would end the program.
void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) return;
    action.sa_handler = handler;
    action.sa_flags = flags;
    ::sigaction(signal, &action, nullptr);
}

void watch_signals() {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU})
        handle(signal, remove_temporaries, static_cast<int>(SA_RESETHAND));
    // Where a file would be larger than `ulimit -f` allows, writing fails as on a full disk.
    handle(SIGXFSZ, go_on, SA_RESTART);
}

/// Tells the handler of a temporary file; null where it cannot.
AnnouncedFile* announce(const std::string& name) {
    static std::once_flag watched;
    std::call_once(watched, watch_signals);
    owner = ::getpid();
    if (name.size() >= PATH_MAX) return nullptr;
    for (AnnouncedFile& file : announced_files) {
        int state = AnnouncedFile::Free;
        if (!file.state.compare_exchange_strong(state, AnnouncedFile::Taken)) continue;
        std::copy_n(name.c_str(), name.size() + 1, file.name.data());
        file.state = AnnouncedFile::There;
        return &file;
    }
    return nullptr;
}

constexpr std::string_view prefix = ".course-", suffix = ".tmp";

/// A name in `directory` that no other thread or process uses.
fs::path new_name(const fs::path& directory) {
    static std::atomic<unsigned> count = 0;
    return directory / (std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(count++) +
                        std::string(suffix));
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& directory) : path(new_name(directory)), descriptor(-1) {
    // No signal comes between the file and its announcement.
    sigset_t all, before;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    descriptor.number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    const int error = errno;
    if (descriptor.number >= 0) announced = announce(path.string());
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = error;
    if (descriptor.number < 0) return;
    while (::flock(descriptor.number, LOCK_EX) != 0 && errno == EINTR) continue;
}

TemporaryFile::~TemporaryFile() {
    if (descriptor.number >= 0 && !renamed) ::unlink(path.c_str());
    if (announced) announced->state = AnnouncedFile::Free;
}

bool TemporaryFile::gone() const {
    struct stat what {};
    return ::fstat(descriptor.number, &what) == 0 && what.st_nlink == 0;
}

bool TemporaryFile::rename(const fs::path& target) {
    // Some file systems say only on closing that the disk is full; the lock must outlive that.
    const int other = ::fcntl(descriptor.number, F_DUPFD_CLOEXEC, 0);
    renamed = other >= 0 && ::close(other) == 0 && ::rename(path.c_str(), target.c_str()) == 0;
    return renamed;
}

void remove_stale(const fs::path& directory) {
    static std::mutex mutex;
    static std::set<fs::path> seen;
    {
        const std::lock_guard lock(mutex);
        if (!seen.insert(directory).second) return;
    }
    std::error_code error;
    fs::directory_iterator entry(directory.empty() ? fs::path(".") : directory, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
        const Descriptor file(::open(entry->path().c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        if (file.number >= 0 && ::flock(file.number, LOCK_EX | LOCK_NB) == 0) ::unlink(entry->path().c_str());
    }
}

}  // namespace rt
