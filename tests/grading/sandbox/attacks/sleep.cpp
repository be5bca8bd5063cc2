// Waits without an end and listens to no signal.
#include <unistd.h>

#include <csignal>

int main() {
    for (int i = 1; i < NSIG; ++i) std::signal(i, SIG_IGN);
    for (;;) pause();
}
