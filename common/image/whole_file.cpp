// Files read and written whole, with what can go wrong on the way: devices, pipes, full disks, signals.
#include "common/image/whole_file.hpp"

#include "common/math/input_error.hpp"

#include <fcntl.h>
#include <poll.h>
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
#include <system_error>
#include <utility>

namespace rt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw InputError(path.string() + ": " + what);
}

std::string reason(int error) { return std::generic_category().message(error); }

/// A file descriptor that is closed on every way out.
struct Descriptor {
    int number;

    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

// ---- Reading ----

/// What opened file it is, if it is one that can be read whole.
struct stat readable(const fs::path& path, int descriptor) {
    struct stat what {};
    if (::fstat(descriptor, &what) != 0) fail(path, "cannot be read: " + reason(errno));
    if (S_ISDIR(what.st_mode)) fail(path, "cannot be read: " + reason(EISDIR));
    if (!S_ISREG(what.st_mode) && !S_ISFIFO(what.st_mode))
        fail(path, "cannot be read: it is a device, not a file");
    return what;
}

void check_length(const fs::path& path, std::size_t bytes) {
    if (bytes > largest_file)
        fail(path, "more than " + std::to_string(largest_file) + " bytes; no larger file is read");
}

// ---- Temporary files: their names are known to the handler of the signals that end the program ----

struct Temporary {
    enum State { Free, Taken, There };
    std::atomic<int> state = Free;
    std::array<char, PATH_MAX> name;
};
std::array<Temporary, 64> temporaries;  // of more at one time the others are left to the next program
std::atomic<pid_t> owner = 0;           // a child between fork and exec has the handler, but not the files

extern "C" void remove_temporaries(int signal) {
    if (::getpid() == owner)
        for (Temporary& temporary : temporaries)
            if (temporary.state == Temporary::There) ::unlink(temporary.name.data());
    ::raise(signal);  // the handler was for once; now the signal ends the program, as it should
}

void watch_signals() {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ}) {
        struct sigaction action {};
        if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
        action.sa_handler = remove_temporaries;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        ::sigaction(signal, &action, nullptr);
    }
}

/// Tells the handler of a temporary file; null where it cannot.
Temporary* announce(const std::string& name) {
    static std::once_flag watched;
    std::call_once(watched, watch_signals);
    owner = ::getpid();
    if (name.size() >= PATH_MAX) return nullptr;
    for (Temporary& temporary : temporaries) {
        int state = Temporary::Free;
        if (!temporary.state.compare_exchange_strong(state, Temporary::Taken)) continue;
        std::copy_n(name.c_str(), name.size() + 1, temporary.name.data());
        temporary.state = Temporary::There;
        return &temporary;
    }
    return nullptr;
}

constexpr std::string_view prefix = ".course-", suffix = ".tmp";

/// Removes temporary files that nobody is writing: a writer holds a lock, which ends with it however it ends.
/// Once a directory, because a directory may be large.
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

/// A new file with a lock on it; removed on every way out unless it was renamed.
struct TemporaryFile {
    fs::path path;
    Descriptor descriptor;
    Temporary* announced = nullptr;
    bool renamed = false;

    /// Made in `directory`; the descriptor is negative, with the reason in errno, where that fails.
    explicit TemporaryFile(const fs::path& directory) : path(new_name(directory)), descriptor(-1) {
        make();
        if (descriptor.number < 0) return;
        while (::flock(descriptor.number, LOCK_EX) != 0 && errno == EINTR) continue;
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor.number >= 0 && !renamed) ::unlink(path.c_str());
        if (announced) announced->state = Temporary::Free;
    }

    /// No signal comes between the file and its announcement.
    void make() {
        sigset_t all, before;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before);
        descriptor.number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        const int error = errno;
        if (descriptor.number >= 0) announced = announce(path.string());
        ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
        errno = error;
    }

    /// Whether another program took it for one that was left, between its making and its lock.
    bool gone() const {
        struct stat what {};
        return ::fstat(descriptor.number, &what) == 0 && what.st_nlink == 0;
    }

    /// Gives it its name; false, with the reason in errno, if it could not be kept whole.
    bool rename(const fs::path& target) {
        // Some file systems say only on closing that the disk is full; the lock must outlive that.
        const int other = ::fcntl(descriptor.number, F_DUPFD_CLOEXEC, 0);
        renamed = other >= 0 && ::close(other) == 0 && ::rename(path.c_str(), target.c_str()) == 0;
        return renamed;
    }

    /// A name in `directory` that no other thread or process uses.
    static fs::path new_name(const fs::path& directory) {
        static std::atomic<unsigned> count = 0;
        return directory / (std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(count++) +
                            std::string(suffix));
    }
};

// ---- Writing ----

/// Writes all of `content`; false, with the reason in errno, if that fails.
bool write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

[[noreturn]] void fail_write(const fs::path& path, int error) {
    const fs::path directory = path.parent_path();
    std::error_code ignored;
    if (error == ENOENT && !directory.empty() && !fs::exists(directory, ignored))
        fail(path, "cannot be written: there is no directory '" + directory.string() + "'");
    fail(path, "cannot be written: " + reason(error));
}

/// What is at a place that shall be written.
enum class There { Nothing, File, Device };

There what_is_at(const fs::path& path) {
    struct stat what {};
    if (::stat(path.c_str(), &what) != 0) {
        if (errno != ENOENT) fail_write(path, errno);
        return There::Nothing;  // also a link to what is not there
    }
    if (S_ISDIR(what.st_mode)) fail_write(path, EISDIR);
    const bool regular = S_ISREG(what.st_mode);
    if (regular && (what.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
        fail(path, "cannot be written: it is read-only");
    if (::access(path.c_str(), W_OK) != 0) fail_write(path, errno);
    if (!regular) return There::Device;
    return There::File;
}

/// The file itself where `path` is a link to it, or to a link.
fs::path without_links(const fs::path& path) {
    fs::path target = path;
    std::error_code error;
    for (int links = 0; fs::is_symlink(target, error); ++links) {
        if (links == 40) fail_write(path, ELOOP);
        target = target.parent_path() / fs::read_symlink(target, error);
    }
    return target;
}

/// Makes a temporary file for `path`, whose directory is that of `target`, and gives it to `use`.
template <class Use>
void with_temporary(const fs::path& path, const fs::path& target, Use use) {
    remove_stale(target.parent_path());
    for (;;) {
        TemporaryFile file(target.parent_path());
        // A name may be that of one left by a process of the same number that was killed.
        if (file.descriptor.number < 0 && errno == EEXIST) continue;
        if (file.descriptor.number < 0) fail_write(path, errno);
        if (!file.gone()) return use(file);
    }
}

}  // namespace

std::string read_file(const fs::path& path) {
    // Not waiting: to open a pipe for reading would, until somebody writes.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (file.number < 0) fail(path, "cannot be read: " + reason(errno));
    const struct stat what = readable(path, file.number);
    const bool pipe = S_ISFIFO(what.st_mode);
    std::string content;
    if (!pipe) {
        check_length(path, static_cast<std::size_t>(what.st_size));
        content.reserve(static_cast<std::size_t>(what.st_size));
    }
    std::vector<char> buffer(std::size_t{1} << 18);
    int waited = 0;
    for (;;) {
        const ssize_t count = ::read(file.number, buffer.data(), buffer.size());
        if (count > 0) {
            content.append(buffer.data(), static_cast<std::size_t>(count));
            check_length(path, content.size());
        } else if (count == 0) {
            if (!pipe || !content.empty()) return content;
            if (waited >= pipe_patience) fail(path, "cannot be read: nobody writes into this pipe");
            ::poll(nullptr, 0, 10);
            waited += 10;
        } else if (errno == EAGAIN) {
            pollfd ready{file.number, POLLIN, 0};
            if (::poll(&ready, 1, pipe_silence) == 0)
                fail(path, "cannot be read: nothing came through the pipe for " +
                               std::to_string(pipe_silence / 1000) + " s");
        } else if (errno != EINTR) {
            fail(path, "cannot be read: " + reason(errno));
        }
    }
}

void write_file(const fs::path& path, std::string_view content) {
    const There there = what_is_at(path);
    if (there == There::Device) {  // or a pipe: a rename would replace it
        Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.number < 0 || !write_all(file.number, content)) fail_write(path, errno);
        if (::close(std::exchange(file.number, -1)) != 0) fail_write(path, errno);
        return;
    }
    const fs::path target = without_links(path);
    with_temporary(path, target, [&](TemporaryFile& file) {
        if (!write_all(file.descriptor.number, content)) fail_write(path, errno);
        struct stat before {};
        if (there == There::File && ::stat(target.c_str(), &before) == 0)
            ::fchmod(file.descriptor.number, before.st_mode & 07777);
        if (!file.rename(target)) fail_write(path, errno);
    });
}

void require_writable(const fs::path& path) {
    if (what_is_at(path) == There::Device) return;
    with_temporary(path, without_links(path), [](TemporaryFile&) {});
}

void require_no_input(const fs::path& path, const std::vector<fs::path>& inputs) {
    for (const fs::path& input : inputs) {
        std::error_code error;
        if (fs::equivalent(path, input, error) && !error)
            fail(path, "cannot be written: it is '" + input.string() + "', which is read here");
    }
}

void make_directories(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    std::error_code ignored;
    if (!fs::is_directory(path, ignored))
        fail(path, "cannot be made a directory: " + (error ? error.message() : reason(ENOTDIR)));
}

}  // namespace rt
