// Files read and written whole, with what can go wrong on the way: devices, pipes, full disks.
#include "common/image/whole_file.hpp"

#include "common/image/descriptor.hpp"
#include "common/image/temporary_file.hpp"
#include "common/math/input_error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace rt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw InputError(path.string() + ": " + what);
}

std::string reason(int error) { return std::generic_category().message(error); }

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
