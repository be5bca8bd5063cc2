// A fork bomb of 400: says how many there could be.
#include <unistd.h>

#include <csignal>
#include <cstdio>

int main() {
    int count = 0;
    for (; count < 400; ++count) {
        const pid_t child = fork();
        if (child < 0) break;
        if (child == 0) {
            pause();
            _exit(0);
        }
    }
    std::printf("%d\n", count);
}
