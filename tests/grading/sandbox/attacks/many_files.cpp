// Makes empty files until it may not, or 200: says how many.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>

int main() {
    int count = 0;
    for (; count < 200; ++count) {
        const int file = open(std::to_string(count).c_str(), O_CREAT | O_WRONLY, 0600);
        if (file < 0) break;
        close(file);
    }
    std::printf("%d\n", count);
}
