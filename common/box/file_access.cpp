// What of this machine's files a process may touch where it cannot have a file system of its own: Landlock
// (https://docs.kernel.org/userspace-api/landlock.html), for which this C library has no functions.
#include "common/box/file_access.hpp"

#include "common/image/descriptor.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace rt {

namespace {

// Rights that are younger than these headers.
constexpr std::uint64_t truncate_right = std::uint64_t{1} << 14, device_right = std::uint64_t{1} << 15;

constexpr std::uint64_t reading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;

/// All rights that a version of the kernel's interface knows.
std::uint64_t all_rights(long version) {
    std::uint64_t rights = LANDLOCK_ACCESS_FS_REFER - 1;
    if (version >= 2) rights |= LANDLOCK_ACCESS_FS_REFER;
    if (version >= 3) rights |= truncate_right;
    if (version >= 5) rights |= device_right;
    return rights;
}

bool allow(int rules, const std::string& path, std::uint64_t rights) {
    const Descriptor place(open(path.c_str(), O_PATH | O_CLOEXEC));
    struct stat status {};
    if (place.number < 0 || fstat(place.number, &status) != 0) return false;
    if (!S_ISDIR(status.st_mode))  // a file has these only
        rights &= LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                  truncate_right | device_right;
    const landlock_path_beneath_attr rule{rights, place.number};
    return syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

}  // namespace

bool restrict_files(const std::vector<Mount>& mounts, const std::string& scratch) {
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) return true;
    const std::uint64_t all = all_rights(version);
    const landlock_ruleset_attr attributes{all};
    const Descriptor rules(
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0)));
    bool good = rules.number >= 0 && allow(rules.number, scratch, all);
    for (const char* device : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"})
        if (access(device, F_OK) == 0)
            good = good &&
                   allow(rules.number, device, LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE);
    for (const Mount& mount : mounts) good = good && allow(rules.number, mount.host, reading);
    return good && syscall(SYS_landlock_restrict_self, rules.number, 0) == 0;
}

}  // namespace rt
