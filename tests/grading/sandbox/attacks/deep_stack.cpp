// Recursion without an end.
#include <cstdio>

static int deeper(volatile char* above) {
    volatile char here[4096];
    here[0] = above[0];
    return above[0] == 2 ? 0 : deeper(here) + here[0];
}

int main() {
    volatile char first = 1;
    std::printf("%d\n", deeper(&first));
}
