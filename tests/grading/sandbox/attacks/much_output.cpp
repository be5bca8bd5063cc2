// Writes without an end.
#include <cstdio>

int main() {
    while (std::puts("All tests passed")) continue;
}
