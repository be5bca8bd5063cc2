// Asks for a refused call by the numbers of another architecture.
#include <cstdio>

int main() {
#ifdef __x86_64__
    long result = 359;  // socketpair of i386
    asm volatile("int $0x80"
                 : "+a"(result)
                 : "b"(1), "c"(1), "d"(0), "S"(0)
                 : "memory", "r8", "r9", "r10", "r11");
    std::printf("survived: %ld\n", result);
#else
    __builtin_trap();
#endif
}
