// Eight processes that take 24 MiB each, none of them too much, and hide in /proc.
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

int main() {
    for (int i = 1; i < 8; ++i)
        if (fork() == 0) break;
    prctl(PR_SET_DUMPABLE, 0);
    constexpr std::size_t size = std::size_t{24} << 20;
    volatile char* block = static_cast<char*>(std::malloc(size));
    for (std::size_t i = 0; i < size; i += 4096) block[i] = 1;
    sleep(60);
}
