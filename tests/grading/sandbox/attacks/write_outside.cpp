// write_outside DIRECTORY...: tries to write there and elsewhere; names the files that it made.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>

static void try_file(const std::string& path, int flags) {
    const int file = open(path.c_str(), O_WRONLY | flags, 0666);
    if (file < 0 || write(file, "\n", 1) != 1) return;
    std::puts(path.c_str());
    close(file);
    if (flags & O_CREAT) unlink(path.c_str());
}

int main(int count, char** directories) {
    for (int i = 1; i < count; ++i) try_file(std::string(directories[i]) + "/sandbox_attack", O_CREAT);
    for (const char* directory : {"", "/etc", "/usr", "/usr/bin", "/usr/lib", "/dev", "/dev/shm", "/var/tmp",
                                  "/var", "/run", "/root", "/home", "..", "/tmp/.."})
        try_file(std::string(directory) + "/sandbox_attack", O_CREAT);
    for (const char* file : {"/proc/sys/kernel/core_pattern", "/proc/sys/kernel/hostname",
                             "/proc/self/oom_score_adj", "/dev/kmsg", "/etc/passwd"})
        try_file(file, 0);
}
