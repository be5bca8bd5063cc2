// Writes one file without an end.
#include <cstdio>

int main() {
    std::FILE* file = std::fopen("large", "w");
    static char block[1 << 16];
    while (file && std::fwrite(block, sizeof block, 1, file) == 1) continue;
    std::puts("ended");
}
