// Writes files of 1 MiB until it may not, or 16: says how many.
#include <cstdio>
#include <string>

int main() {
    static char block[1 << 20];
    int count = 0;
    for (; count < 16; ++count) {
        std::FILE* file = std::fopen(std::to_string(count).c_str(), "w");
        if (!file || std::fwrite(block, sizeof block, 1, file) != 1 || std::fclose(file) != 0) break;
    }
    std::printf("%d\n", count);
}
