// One process that takes all the memory that it gets: says how many MiB.
#include <cstdio>
#include <cstdlib>
#include <cstring>

int main() {
    int count = 0;
    for (; count < 4096; ++count) {
        void* block = std::malloc(1 << 20);
        if (!block) break;
        std::memset(block, 1, 1 << 20);
    }
    std::printf("%d\n", count);
}
