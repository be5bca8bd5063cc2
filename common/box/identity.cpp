// As whom the program in a box runs: under a uid that nobody else has, with no privilege.
#include "common/box/identity.hpp"

#include "common/math/input_error.hpp"

#include <grp.h>
#include <linux/capability.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace rt {

namespace {

struct Pool {
    uid_t first, count;
};

// The first is far from the uids of people, of containers and of systemd. A container has often 65536 uids
// only; then it is what Debian and systemd leave unused below these.
constexpr Pool pools[] = {{2'000'000'000, 1000}, {60'600, 500}};

/// Whether this process's user namespace has these uids.
bool is_mapped(const Pool& pool) {
    std::ifstream map("/proc/self/uid_map");
    for (std::uint64_t inside = 0, outside = 0, count = 0; map >> inside >> outside >> count;)
        if (inside <= pool.first && pool.first + pool.count <= inside + count) return true;
    return false;
}

Pool pool_here() {
    for (const Pool& pool : pools)
        if (is_mapped(pool)) return pool;
    throw InputError("this container has no uids to spare for boxes (/proc/self/uid_map)");
}

/// A lock that leaves no file and goes with the process: a socket's name that only one can have. Negative if
/// another has it.
int try_to_lock(uid_t uid) {
    const int lock = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (lock < 0) throw InputError("no socket for the lock of a uid");
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    const std::string text = "course-box-" + std::to_string(uid);
    std::memcpy(name.sun_path + 1, text.data(), text.size());  // abstract: it begins with a zero byte
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + text.size());
    if (bind(lock, reinterpret_cast<const sockaddr*>(&name), size) == 0) return lock;
    close(lock);
    return -1;
}

/// Another place in the pool for every box, so that two do not always ask for the same one first.
std::pair<uid_t, int> lock_one() {
    if (geteuid() != 0) return {geteuid(), -1};
    const Pool pool = pool_here();
    const auto start = static_cast<uid_t>(getpid());
    for (uid_t i = 0; i < pool.count; ++i) {
        const uid_t uid = pool.first + (start + i) % pool.count;
        if (getpwuid(uid)) continue;  // somebody's
        if (const int lock = try_to_lock(uid); lock >= 0) return {uid, lock};
    }
    throw InputError("all uids for boxes are in use: too many boxes run at once");
}

bool drop_capabilities() {
    __user_cap_header_struct head{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3] = {};
    return syscall(SYS_capset, &head, none) == 0;
}

}  // namespace

Identity::Identity() : Identity(lock_one()) {}

Identity::Identity(std::pair<uid_t, int> number_and_lock)
    : number_(number_and_lock.first), own_(number_and_lock.second >= 0), lock_(number_and_lock.second) {
    // What a supervisor left that was killed itself; nobody else has this uid.
    kill_all();
}

bool Identity::assume() const {
    // Not all of them exist in every kernel, and without CAP_SETPCAP none can be taken away. What counts is
    // below: no privilege now, and none by exec.
    for (unsigned long capability = 0; capability < 64; ++capability)
        prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
    if (own_ && (setgroups(0, nullptr) != 0 || setresgid(number_, number_, number_) != 0 ||
                 setresuid(number_, number_, number_) != 0))
        return false;
    return drop_capabilities() && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

void Identity::kill_all() const {
    if (!own_) return;
    const pid_t child = fork();
    if (child == 0) {
        // Never as root: -1 would be everybody.
        if (setresuid(number_, number_, number_) == 0 && getuid() == number_) kill(-1, SIGKILL);
        _exit(0);
    }
    while (child > 0 && waitpid(child, nullptr, 0) == -1 && errno == EINTR) continue;
}

}  // namespace rt
