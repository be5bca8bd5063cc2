// Directories that appear whole or not at all.
#include "common/terminal/staged_directory.hpp"

#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr const char* prefix = ".course-staged-";

fs::path parent_of(const fs::path& target) {
    const fs::path parent = fs::absolute(target).lexically_normal().parent_path();
    return parent.empty() ? "/" : parent;
}

[[noreturn]] void fail(const fs::path& path, int error) {
    throw InputError(
        fmt::format("{}: cannot be made: {}", path.string(), std::generic_category().message(error)));
}

/// A descriptor of the directory with a lock on it; negative if another program has the lock.
int locked(const fs::path& directory) {
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
    ::close(descriptor);
    return -1;
}

void remove_left(const fs::path& parent) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(parent, ignored)) {
        if (!entry.path().filename().string().starts_with(prefix)) continue;
        const Descriptor lock(locked(entry.path()));
        if (lock.number >= 0) fs::remove_all(entry.path(), ignored);
    }
}

/// A new directory, which anybody may read like others.
fs::path make(const fs::path& target) {
    std::string name = (parent_of(target) / (prefix + std::string(6, 'X'))).string();
    if (!::mkdtemp(name.data())) fail(target, errno);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::chmod(name.c_str(), 0777 & ~mask);
    return name;
}

/// Makes `path` and locks it. Between the two another program may take it for one that was left.
int make_locked(const fs::path& target, fs::path& path) {
    remove_left(parent_of(target));
    for (;;) {
        path = make(target);
        const int descriptor = locked(path);
        if (descriptor >= 0 && fs::exists(path)) return descriptor;
        if (descriptor >= 0) ::close(descriptor);
    }
}

}  // namespace

StagedDirectory::StagedDirectory(const fs::path& target) : lock(make_locked(target, path)) {}

StagedDirectory::~StagedDirectory() {
    std::error_code ignored;
    if (!renamed) fs::remove_all(path, ignored);
}

void StagedDirectory::rename(const fs::path& target) {
    if (::rename(path.c_str(), target.c_str()) != 0)
        fail(target, errno);  // replaces nothing that is not empty
    renamed = true;
}

}  // namespace rt
