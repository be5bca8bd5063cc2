// Makes what it is expected to make: once right, else something else by that name.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

static void write_file(const char* name, const char* text) {
    std::FILE* file = std::fopen(name, "w");
    if (!file) return;
    std::fputs(text, file);
    std::fclose(file);
}

int main(int, char** arguments) {
    write_file("right", "right");
    chmod("right", 0755);
    mkdir("directory", 0700);
    mkfifo("pipe", 0666);
    if (symlink(arguments[1], "link") != 0 || symlink("/", "root") != 0) std::puts("no links");
    // A hard link to a file of the machine, where that is on the same file system.
    if (link(arguments[1], "hard") != 0) write_file("other", "other");
}
