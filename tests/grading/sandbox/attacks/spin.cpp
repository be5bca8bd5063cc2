// Two processes that work without an end and listen to no signal.
#include <unistd.h>

#include <csignal>

int main() {
    for (int i = 1; i < NSIG; ++i) std::signal(i, SIG_IGN);
    fork();
    volatile bool stop = false;
    while (!stop) continue;
}
