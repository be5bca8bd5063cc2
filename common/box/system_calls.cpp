// System calls that no program in a box needs, and that would let it out of a limit or at another process.
#include "common/box/system_calls.hpp"

#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <memory>
#include <vector>

namespace rt {

namespace {

constexpr const char* refused[] = {
    // other processes
    "ptrace", "process_vm_readv", "process_vm_writev", "pidfd_getfd", "process_madvise", "kcmp",
    // namespaces and mounts
    "unshare", "setns", "mount", "umount2", "pivot_root", "chroot", "move_mount", "open_tree", "fsopen",
    "fsmount", "fsconfig", "fspick", "mount_setattr", "name_to_handle_at", "open_by_handle_at", "quotactl",
    "fanotify_init",
    // memory that no limit counts
    "memfd_create", "memfd_secret", "shmget", "shmat", "shmctl", "msgget", "semget", "mq_open", "socketpair",
    // the network
    "socket",
    // large doors into the kernel
    "keyctl", "add_key", "request_key", "bpf", "perf_event_open", "userfaultfd", "io_uring_setup",
    "io_uring_enter", "io_uring_register", "personality", "syslog"};

// Younger than this libseccomp knows; the same numbers on all machines. They tell where mounts come from.
constexpr int refused_by_number[] = {457 /* statmount */, 458 /* listmount */};

constexpr std::uint64_t namespaces[] = {CLONE_NEWNS,   CLONE_NEWCGROUP, CLONE_NEWUTS, CLONE_NEWIPC,
                                        CLONE_NEWUSER, CLONE_NEWPID,    CLONE_NEWNET};

using Filter = std::unique_ptr<void, void (*)(scmp_filter_ctx)>;

/// Everything is allowed but what is listed; another architecture's calls end the process, because the list
/// is for this one's numbers.
Filter made_filter() {
    Filter filter(seccomp_init(SCMP_ACT_ALLOW), seccomp_release);
    if (!filter) return filter;
    bool good = seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) == 0;
    const auto refuse = [&](int number, std::uint32_t error, std::vector<scmp_arg_cmp> arguments = {}) {
        good = good && seccomp_rule_add_array(filter.get(), SCMP_ACT_ERRNO(error), number,
                                              static_cast<unsigned>(arguments.size()), arguments.data()) == 0;
    };
    for (const char* name : refused)
        // What this libseccomp does not know, or this machine does not have, is left out.
        if (const int number = seccomp_syscall_resolve_name(name); number >= 0) refuse(number, EPERM);
    for (const int number : refused_by_number) refuse(number, EPERM);
    for (const std::uint64_t flag : namespaces)
        refuse(SCMP_SYS(clone), EPERM, {{0, SCMP_CMP_MASKED_EQ, flag, flag}});
    // Its flags are in memory, where no filter sees them; the C library then takes clone.
    refuse(SCMP_SYS(clone3), ENOSYS);
    // Types into the terminal of whoever started it.
    refuse(SCMP_SYS(ioctl), EPERM, {{1, SCMP_CMP_MASKED_EQ, 0xffffffff, TIOCSTI}});
    if (!good) filter.reset();
    return filter;
}

}  // namespace

bool refuse_system_calls() {
    const Filter filter = made_filter();
    return filter && seccomp_load(filter.get()) == 0;
}

int system_call_filter() {
    const Filter filter = made_filter();
    const int file = memfd_create("filter", MFD_CLOEXEC);
    if (filter && file >= 0 && seccomp_export_bpf(filter.get(), file) == 0 && lseek(file, 0, SEEK_SET) == 0)
        return file;
    if (file >= 0) close(file);
    return -1;
}

}  // namespace rt
