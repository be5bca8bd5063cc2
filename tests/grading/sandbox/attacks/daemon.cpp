// Leaves a process behind, in a session of its own, with no parent and no open file.
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

int main() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) {
            for (int i = 0; i < 64; ++i) close(i);
            for (int i = 1; i < NSIG; ++i) std::signal(i, SIG_IGN);
            prctl(PR_SET_NAME, "box_daemon");
            for (;;) pause();
        }
    }
}
