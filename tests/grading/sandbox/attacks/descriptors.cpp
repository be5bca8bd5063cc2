// Names the descriptors that it was given, and its environment.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

int main() {
    for (int i = 0; i < 1024; ++i)
        if (fcntl(i, F_GETFD) >= 0) std::printf("%d ", i);
    for (char** variable = environ; *variable; ++variable) std::printf("%s ", *variable);
}
