// Makes the system calls that no box needs; names those that were not refused.
#include <sys/ioctl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/ptrace.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

static void expect_refused(const char* name, long result) {
    if (result != -1 || (errno != EPERM && errno != ENOSYS)) std::puts(name);
}

int main() {
    int ends[2];
    expect_refused("memfd_create", memfd_create("x", 0));
    expect_refused("memfd_secret", syscall(447, 0));
    expect_refused("shmget", shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600));
    expect_refused("msgget", syscall(SYS_msgget, IPC_PRIVATE, 0));
    expect_refused("semget", syscall(SYS_semget, IPC_PRIVATE, 1, 0));
    expect_refused("mq_open", syscall(SYS_mq_open, "x", 0, 0, nullptr));
    expect_refused("socket", socket(AF_INET, SOCK_DGRAM, 0));
    expect_refused("socketpair", socketpair(AF_UNIX, SOCK_STREAM, 0, ends));
    expect_refused("io_uring_setup", syscall(SYS_io_uring_setup, 1, nullptr));
    expect_refused("bpf", syscall(SYS_bpf, 0, nullptr, 0));
    expect_refused("perf_event_open", syscall(SYS_perf_event_open, nullptr, 0, 0, 0, 0));
    expect_refused("userfaultfd", syscall(SYS_userfaultfd, 1));
    expect_refused("keyctl", syscall(SYS_keyctl, 0, 0, 0, 0, 0));
    expect_refused("add_key", syscall(SYS_add_key, "user", "x", "x", 1, -3));
    expect_refused("personality", personality(0xffffffff));
    expect_refused("mount", syscall(SYS_mount, "x", "/tmp", "tmpfs", 0, nullptr));
    expect_refused("open_tree", syscall(SYS_open_tree, 0, "/", 0));
    expect_refused("fsopen", syscall(SYS_fsopen, "tmpfs", 0));
    expect_refused("chroot", chroot("."));
    expect_refused("setns", syscall(SYS_setns, 0, 0));
    expect_refused("clone3", syscall(SYS_clone3, nullptr, 0));
    expect_refused("ptrace", ptrace(PTRACE_TRACEME, 0, nullptr, nullptr));
    expect_refused("statmount", syscall(457, nullptr, nullptr, 0, 0));
    expect_refused("TIOCSTI", ioctl(0, TIOCSTI, "x"));
    expect_refused("TIOCSTI with high bits", syscall(SYS_ioctl, 0, 0x100000000 | TIOCSTI, "x"));
}
