// read_outside FILE...: names those that can be read, and what of the machine can be, too.
#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <initializer_list>

static void try_file(const char* path) {
    char byte;
    const int file = open(path, O_RDONLY);
    if (file >= 0 && read(file, &byte, 1) == 1) std::puts(path);
}

int main(int count, char** files) {
    for (int i = 1; i < count; ++i) try_file(files[i]);
    for (const char* file : {"/etc/passwd", "/etc/shadow", "/proc/1/environ", "/proc/1/cmdline",
                             "/proc/self/mountinfo", "/proc/cpuinfo", "/sys/kernel/uevent_helper"})
        try_file(file);
    for (const char* directory : {"/root", "/home", "/var", "/etc", "/proc", "/work"})
        if (DIR* list = opendir(directory)) {
            std::puts(directory);
            closedir(list);
        }
}
